"""``seaminspector:mendseams``: failed seams cut anew, on small mosaics of two orthoimages with a feathered seam."""
from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from scipy import ndimage

from tests.numbers.synthetic import texture, write_raster
from tests.qgis.clusters import needs_dask, two_workers
from tests.qgis.runs import Log, Run, assert_refused, assert_sentence, run
from tests.qgis.scenes import windows
from tests.qgis.seams.scan_scenes import COLUMNS, ROWS, Files, cut, drawn_seam, seam_columns, write_scene

pytestmark = pytest.mark.usefixtures("provider")

FEATHER_PX = 40.0
FIELDS = {"kept_before", "kept_after", "step_before", "step_after", "length"}


def fitting_images(shift_px: int = 0, bands: int = 3) -> list[np.ndarray]:
    """Two images of one scene that share all but their finest detail and their tones, (bands, rows, columns) float;
    the second one lies ``shift_px`` to the right."""
    scene = 24 * texture((ROWS, COLUMNS), 3.0, 40)
    other = np.roll(scene, shift_px, axis=1)
    noise = [[9 * texture((ROWS, COLUMNS), 0.8, seed + band) for band in range(bands)] for seed in (50, 60)]
    tones = 118 + 5 * np.arange(bands)[:, np.newaxis, np.newaxis]
    return [tones + scene + np.array(noise[0]), tones + 8 + 0.95 * other + np.array(noise[1])]


def in_type(made: np.ndarray, dtype: type = np.uint8, scale: float = 1.0) -> np.ndarray:
    return np.asarray(np.clip(np.rint(scale * made), 1, np.iinfo(dtype).max).astype(dtype))


def scene(folder: Path, shift_px: int = 0) -> Files:
    return write_scene(folder, [in_type(image) for image in fitting_images(shift_px)], FEATHER_PX)


@pytest.fixture(scope="module")
def feathered(tmp_path_factory: pytest.TempPathFactory) -> Files:
    return scene(tmp_path_factory.mktemp("feathered"))


def scan(files: Files) -> Run:
    outcome = run("scanmosaic", **files.given())
    assert outcome.complaint is None
    return outcome


def mend(files: Files, scanned: Run | None, folder: Path, log: Log | None = None, **more: Any) -> Run:
    """The failed seams of a scan, or of one that is made first."""
    if scanned is None:
        scanned = scan(files)
    seams = scanned.layer("SEAMS")
    given = {"PATCHES": str(folder / "patches"), "MENDED": str(folder / "mended.vrt"), "WIDTH": 10.0,
             "SEAMS": seams, **more}  # fmt: skip
    return run("mendseams", log, MOSAIC=files.mosaic, SOURCES=files.sources, **given)


@pytest.fixture(scope="module")
def scanned(provider: None, feathered: Files) -> Iterator[Run]:
    made = scan(feathered)
    yield made
    made.close()


@pytest.fixture(scope="module")
def mended(provider: None, feathered: Files, scanned: Run, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Run]:
    made = mend(feathered, scanned, tmp_path_factory.mktemp("mended"))
    yield made
    made.close()


def pixels(path: Any) -> np.ndarray:
    return np.asarray(gdal.Open(str(path)).ReadAsArray()).astype(float)


def patched(ended: Run) -> np.ndarray:
    """(rows, columns) bool: where a patch lies by its alpha."""
    whole = gdal.Open(str(ended.results["MENDED"]))
    left, size, _, top, _, _ = whole.GetGeoTransform()
    result = np.zeros((whole.RasterYSize, whole.RasterXSize), bool)
    place = Path(str(ended.results["PATCHES"]))
    for path in [place] if place.is_file() else sorted(place.glob("*.tif")):
        patch = gdal.Open(str(path))
        x, _, _, y, _, _ = patch.GetGeoTransform()
        alpha = patch.GetRasterBand(patch.RasterCount)
        assert alpha.GetColorInterpretation() == gdal.GCI_AlphaBand
        column, row = round((x - left) / size), round((top - y) / size)
        result[row : row + patch.RasterYSize, column : column + patch.RasterXSize] |= alpha.ReadAsArray() > 0
    return result


def test_failed_seams_keep_their_detail_again(scanned: Run, mended: Run) -> None:
    assert mended.complaint is None
    rows = mended.rows("CUTS")
    assert rows[0].keys() >= FIELDS
    assert mended.results["MENDED_METRES"] == pytest.approx(scanned.results["FAILED_METRES"])
    for row in rows:
        assert (row["outcome"], row["reason"]) == ("mended", None)
        assert row["kept_before"] < 0.7
        assert row["kept_after"] >= 0.9
        assert row["step_after"] <= 1.2 * row["step_before"]


def test_a_new_scan_finds_nothing_that_failed(feathered: Files, mended: Run) -> None:
    outcome = run("scanmosaic", MOSAIC=mended.results["MENDED"], SOURCES=feathered.sources, PIECE=20.0)
    assert outcome.results["FAILED_METRES"] == 0
    assert outcome.results["WORST_KEPT"] > 0.85


def test_nothing_outside_the_patches_differs_and_inside_are_the_orthoimages(feathered: Files, mended: Run) -> None:
    made, before, inside = pixels(mended.results["MENDED"]), pixels(feathered.mosaic), patched(mended)
    assert 0.02 < inside.mean() < 0.9
    assert (made == before)[:, ~inside].all()
    # Fine detail is that of one orthoimage or the other; only tones are changed.
    fine = [image - ndimage.gaussian_filter(image, (0, 2, 2)) for image in (made, *map(pixels, feathered.sources))]
    left = np.min([np.abs(fine[0] - image / gain).mean(axis=0) for image, gain in zip(fine[1:], (1, 1))], axis=0)
    assert np.mean(left[inside] < 1.5) > 0.95
    # Where the mosaic was of one of them already, it stays as it was but for tones.
    old = fine[1:][0], fine[1:][1]
    pure = pixels(feathered.mosaic)
    detail = pure - ndimage.gaussian_filter(pure, (0, 2, 2))
    unmixed = inside & (np.min([np.abs(detail - image).mean(axis=0) for image in old], axis=0) < 0.4)
    assert np.median(np.abs(fine[0] - detail).mean(axis=0)[unmixed]) < 1.0


def test_images_three_pixels_apart_are_left_alone(tmp_path: Path) -> None:
    files = scene(tmp_path, shift_px=3)
    ended = mend(files, None, tmp_path)
    rows = ended.rows("CUTS")
    assert rows
    for row in rows:
        assert row["outcome"] == "left"
        assert_sentence(row["reason"], "lie [23].. pixels apart along the best cut")
    assert ended.results["MENDED_METRES"] == 0
    assert (pixels(ended.results["MENDED"]) == pixels(files.mosaic)).all()


def test_a_misfit_in_a_part_leaves_that_part_only(tmp_path: Path) -> None:
    west, east = fitting_images()
    part = slice(ROWS // 2 - 60, ROWS // 2 + 60)
    east[:, part] = fitting_images(8)[1][:, part]
    files = write_scene(tmp_path, [in_type(west), in_type(east)], FEATHER_PX)
    scanned = scan(files)
    ended = mend(files, scanned, tmp_path)
    rows = ended.rows("CUTS")
    assert [row["outcome"] for row in rows].count("left") == 1
    for row in rows:
        if row["outcome"] == "left":
            assert_sentence(row["reason"], "lie [78].. pixels apart along the best cut")
        else:
            assert (row["outcome"], row["kept_after"] > 0.9) == ("mended", True)
    assert 120 * 0.1 < ended.results["LEFT_METRES"] < 300 * 0.1
    assert sum(row["length"] for row in rows) == pytest.approx(scanned.results["FAILED_METRES"])
    made, before = pixels(ended.results["MENDED"]), pixels(files.mosaic)
    assert (made == before)[:, part].all()


def feathered_cut(west: np.ndarray, east: np.ndarray) -> np.ndarray:
    """In fractions, too."""
    most = 1 if west.dtype.kind != "f" else 40_000
    made = cut(west * np.float64(most), east * np.float64(most), FEATHER_PX) / most
    return np.asarray(made.astype(west.dtype))


@pytest.mark.parametrize(("dtype", "scale"), [(np.uint8, 1.0), (np.uint16, 40.0), (np.float32, 1 / 255)])
def test_what_another_date_shows_is_not_brought_into_the_mosaic(dtype: type, scale: float, tmp_path: Path) -> None:
    """Cars in the eastern orthoimage that were not there when the mosaic was made: beside the seam, not on it."""
    west, east = (
        in_type(raster, dtype, scale) if scale >= 1 else (scale * raster).astype(dtype) for raster in fitting_images()
    )
    files = Files(*(
        write_raster(tmp_path / name, image)
        for name, image in (("mosaic.tif", feathered_cut(west, east)), ("west.tif", west), ("east.tif", east))
    ))
    scanned = scan(files)
    later = gdal.Open(files.sources[1], gdal.GA_Update)
    shown = later.ReadAsArray()
    for row in range(40, ROWS - 40, 100):
        column = int(seam_columns(ROWS, COLUMNS)[row]) + 60
        shown[:, row : row + 24, column : column + 40] = 240 * scale
    later.WriteArray(shown)
    later = None
    ended = mend(files, scanned, tmp_path)
    assert [row["outcome"] for row in ended.rows("CUTS")] == ["left"] * len(ended.rows("CUTS"))
    assert_sentence(ended.rows("CUTS")[0]["reason"], "The orthoimages differ from the mosaic on")
    assert (pixels(ended.results["MENDED"]) == pixels(files.mosaic)).all()


def sharpened(made: np.ndarray) -> np.ndarray:
    return made + 0.6 * (made - ndimage.gaussian_filter(made, (0, 1, 1)))


def balanced(made: np.ndarray) -> np.ndarray:
    """Dodged from left to right."""
    return np.asarray(made * np.linspace(0.85, 1.1, made.shape[2]) + 6)


@pytest.mark.parametrize("change", [sharpened, balanced])
def test_patches_wear_what_came_over_the_mosaic(change: Any, tmp_path: Path) -> None:
    west, east = fitting_images()
    files = write_scene(tmp_path, [in_type(west), in_type(east)])
    write_raster(Path(files.mosaic), in_type(change(cut(west, east, FEATHER_PX))))
    ended = mend(files, None, tmp_path)
    truth, inside = change(cut(west, east)), patched(ended)
    assert all(row["kept_after"] >= 0.9 for row in ended.rows("CUTS"))
    fine = [item - ndimage.gaussian_filter(item, (0, 2, 2)) for item in (pixels(ended.results["MENDED"]), truth)]
    same = np.abs(fine[0] - fine[1]).mean(axis=0)
    assert np.percentile(same[inside], 40) < 1.5  # what did not change sides


def test_windows_instead_of_seams(feathered: Files, scanned: Run, tmp_path: Path) -> None:
    ended = mend(feathered, scanned, tmp_path, SEAMS=windows((0, 0, COLUMNS, 200)))
    assert ended.complaint is None
    assert 10 < ended.results["MENDED_METRES"] < 45


def test_what_is_no_layer_of_a_scan_is_refused(feathered: Files, scanned: Run, tmp_path: Path) -> None:
    given = {"MOSAIC": feathered.mosaic, "SOURCES": feathered.sources, "MENDED": str(tmp_path / "mended.vrt"),
             "PATCHES": str(tmp_path)}  # fmt: skip
    assert_refused("mendseams", "lacks fields of a scan", SEAMS=drawn_seam(), **given)
    seams = scanned.layer("SEAMS")
    assert_refused("mendseams", "No sources are given", **{**given, "SOURCES": []}, SEAMS=seams)
    assert_refused("mendseams", "ending", **{**given, "MENDED": str(tmp_path / "mended.tif")}, SEAMS=seams)
    assert not list(tmp_path.glob("mended*"))


class StopAt(Log):
    """Somebody who cancels when so many per cent are done."""

    def __init__(self, percent: float) -> None:
        super().__init__()
        self.progressChanged.connect(lambda done: self.cancel() if done >= percent else None)


def test_what_was_stopped_goes_on(feathered: Files, scanned: Run, mended: Run, tmp_path: Path) -> None:
    log = Log()
    stopped = mend(feathered, scanned, tmp_path, StopAt(60.0))
    assert any("The work was stopped" in said for said in stopped.log.infos), (stopped.log.infos, stopped.results)
    ended = mend(feathered, scanned, tmp_path, log)
    assert any("continues where it stopped" in said for said in log.infos)
    assert not [said for said in (*log.warnings, *log.errors) if "please report" in said]
    assert not [path for path in tmp_path.iterdir() if ".mend" in path.name]
    assert (pixels(ended.results["MENDED"]) == pixels(mended.results["MENDED"])).all()


@pytest.mark.release
@needs_dask
def test_a_cluster_mends_the_same(feathered: Files, scanned: Run, mended: Run, tmp_path: Path) -> None:
    with two_workers(tmp_path) as address:
        ended = mend(feathered, scanned, tmp_path, SCHEDULER=address)
    assert ended.complaint is None
    assert (pixels(ended.results["MENDED"]) == pixels(mended.results["MENDED"])).all()


def test_what_was_not_measured_is_not_written(feathered: Files, scanned: Run, tmp_path: Path) -> None:
    stopped = mend(feathered, scanned, tmp_path, StopAt(70.0))
    assert any("The work was stopped" in said for said in stopped.log.infos)
    assert not list(tmp_path.rglob("*.tif"))
    assert not list(tmp_path.glob("*.vrt"))


def test_the_report_shows_each_seam_before_and_after(mended: Run) -> None:
    page = Path(str(mended.results["REPORT"])).read_text(encoding="utf-8")
    assert "All mended" in page
    assert page.count("data:image/jpeg") == 4 * len(mended.rows("CUTS"))
    assert "where it is now: after" in page


def test_seams_of_another_mosaic_are_left(scanned: Run, tmp_path: Path) -> None:
    files = scene(tmp_path)
    for path in (files.mosaic, *files.sources):
        moved = gdal.Open(path, gdal.GA_Update)
        left, *others = moved.GetGeoTransform()
        moved.SetGeoTransform((left + 5000, *others))
        moved = None
    ended = mend(files, scanned, tmp_path)
    assert ended.results["MENDED_METRES"] == 0
    assert_sentence(ended.rows("CUTS")[0]["reason"], "does not lie on this mosaic")


def test_holes_stay_and_what_cannot_be_measured_is_told(tmp_path: Path) -> None:
    west, east = (in_type(raster) for raster in fitting_images())
    made, hole = cut(west, east, FEATHER_PX), np.zeros((ROWS, COLUMNS), bool)
    for row in range(30, ROWS, 90):
        column = int(seam_columns(ROWS, COLUMNS)[row])
        hole[row : row + 25, column - 30 : column + 5] = True
    hole |= np.random.default_rng(3).random(hole.shape) < 0.002
    made[:, hole], east[:, 200:260, 180:260] = 0, 0
    files = Files(*(
        write_raster(tmp_path / name, image, nodata=0)
        for name, image in (("mosaic.tif", made), ("west.tif", west), ("east.tif", east))
    ))
    ended = mend(files, None, tmp_path)
    after, before = pixels(ended.results["MENDED"]), pixels(files.mosaic)
    assert ((after == 0).all(axis=0) == hole).all()
    assert (after == before)[:, ~patched(ended)].all()
    for row in ended.rows("CUTS"):
        if row["outcome"] == "left" and row["kept_after"] is None:
            assert_sentence(row["reason"], "can't be measured")


@pytest.mark.parametrize("is_part", [False, True])
def test_a_patch_is_never_written_over_an_input(is_part: bool, feathered: Files, tmp_path: Path) -> None:
    """Nor over a part of one, as the patches are of a mosaic that was mended."""
    folder = tmp_path / "patches"
    folder.mkdir()
    mosaic = folder / "patch_0001.tif"
    mosaic.write_bytes(Path(feathered.mosaic).read_bytes())
    whole = str(tmp_path / "whole.vrt") if is_part else str(mosaic)
    if is_part:
        gdal.Translate(whole, str(mosaic), format="VRT")
    ended = mend(Files(whole, feathered.west, feathered.east), None, tmp_path)
    assert ended.complaint is not None
    assert_sentence(ended.complaint, "written over")
    assert mosaic.read_bytes() == Path(feathered.mosaic).read_bytes()
