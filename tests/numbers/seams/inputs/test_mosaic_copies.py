"""Sources that were made from the mosaic are found, and true ones never taken for such."""
from __future__ import annotations

import gc
import os
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from scipy import ndimage
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.seams.measure import messages
from seam_inspector.plugin.seams.measure.inputs.mosaic_copies import leave_out_copies
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict
from seam_inspector.plugin.seams.measure.source_images import Source, gather_sources
from seam_inspector.plugin.seams.measure.window.inspection import (
    inspect_window,
    make_block,
    window_request,
    without_copies,
)
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings

from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import orthoimage
from tests.work import calls_of

SIDE = 1024


def told(mosaic: str, paths: Sequence[str]) -> tuple[list[str], dict[str, str]]:
    """Names of the sources that stay, and the notices' templates by the names in them."""
    raster = describe_mosaic(RasterRef(mosaic))
    sources, _ = gather_sources(map(RasterRef, paths), (), raster.wkt, raster.ref)
    kept, notices = leave_out_copies(raster, sources)
    return [source.ref.name for source in kept], {str(notice.values["name"]): notice.template for notice in notices}


@pytest.fixture
def images() -> list[np.ndarray]:
    """Two images and the mosaic of them, whose second one has 4 % of it."""
    first, second = (orthoimage((SIDE, SIDE), seed=seed) for seed in (1, 2))
    mosaic = first.copy()
    mosaic[:, 800:1000, 700:900] = second[:, 800:1000, 700:900]
    return [first, second, mosaic]


@pytest.fixture
def paths(make_raster: MakeRaster, images: list[np.ndarray]) -> list[str]:
    return [make_raster(f"{name}.tif", image) for name, image in zip(("a", "b", "mosaic"), images)]


def test_true_sources_on_the_very_pixels_of_the_mosaic_stay(paths: list[str]) -> None:
    assert told(paths[2], paths) == (["a.tif", "b.tif"], {})


def test_no_raster_is_open_once_all_are_compared(paths: list[str]) -> None:
    gc.disable()  # which would close what a cycle of references holds, and QGIS may be gone by then
    try:
        told(paths[2], paths)
        handles = [os.path.realpath(entry.path) for entry in os.scandir("/proc/self/fd")]
    finally:
        gc.enable()
    assert not set(map(os.path.realpath, paths)) & set(handles)


@pytest.mark.slow
def test_copies_overviews_and_vrts_are_left_out_with_their_reason(paths: list[str], tmp_path: Path) -> None:
    mosaic = gdal.Open(paths[2])
    names = "copy.tif", "grown.tif", "half.tif", "deep.tif", "lossy.tif", "of.vrt"
    made = {name: str(tmp_path / name) for name in names}
    gdal.Translate(made["copy.tif"], mosaic, creationOptions=["COMPRESS=LZW", "TILED=NO"])
    gdal.Warp(made["grown.tif"], mosaic, outputBounds=(499999.0, 4999897.0, 500103.0, 5000001.0), dstNodata=0)
    gdal.Translate(made["half.tif"], mosaic, widthPct=50, heightPct=50, resampleAlg="average")
    gdal.Translate(made["deep.tif"], mosaic, outputType=gdal.GDT_UInt16, scaleParams=[[0, 255, 0, 65535]])
    options = ["COMPRESS=JPEG", "JPEG_QUALITY=85", "PHOTOMETRIC=YCBCR"]
    gdal.Translate(made["lossy.tif"], mosaic, creationOptions=options)
    gdal.BuildVRT(made["of.vrt"], [paths[2]]).FlushCache()
    del mosaic
    kept, notices = told(paths[2], [*made.values(), *paths[:2]])
    assert kept == ["a.tif", "b.tif"]
    assert notices == dict.fromkeys(made, messages.COPY_AMONG_SOURCES.template)


@pytest.mark.parametrize("name", ["of.vrt", "of.tif"])
def test_a_vrt_of_the_mosaic_is_left_out_whatever_it_is_called(paths: list[str], tmp_path: Path, name: str) -> None:
    """The pixels alone would not tell where only one orthoimage is."""
    path = str(tmp_path / name)
    gdal.Translate(path, paths[2], format="VRT", srcWin=[0, 0, 600, 600])
    kept, notices = told(paths[2], [path, *paths[:2]])
    assert kept == ["a.tif", "b.tif"]
    assert notices == {name: messages.COPY_AMONG_SOURCES.template}


@pytest.mark.slow
def test_a_blurred_mosaic_and_a_mean_of_orthoimages_are_told_and_an_image_given_twice_is_not(
    make_raster: MakeRaster
) -> None:
    """All that they show others show, and finer; images of one ground differ in the finest of what they show."""
    ground, *images = (orthoimage((SIDE, SIDE), seed=seed).astype(float) for seed in (4, 1, 2))
    smooth = (0, 2, 2)
    coarse = ndimage.gaussian_filter(ground, smooth)
    first, second = (coarse + image - ndimage.gaussian_filter(image, smooth) for image in images)
    mosaic = np.where(np.arange(SIDE) < 600, first, second)
    made = {"blurred": ndimage.gaussian_filter(mosaic, (0, 1.5, 1.5)), "mean": (first + second) / 2, "twice": second}
    a, b, whole, *given = (
        make_raster(f"{name}.tif", np.clip(np.rint(pixels), 1, 255).astype(np.uint8))
        for name, pixels in {"a": first, "b": second, "mosaic": mosaic, **made}.items()
    )
    for name, path in zip(made, given):
        kept, notices = told(whole, [a, b, path])
        assert kept == ["a.tif", "b.tif", f"{name}.tif"]
        assert notices == ({} if name == "twice" else {f"{name}.tif": messages.MADE_OF_OTHERS.template})


def test_a_softer_orthoimage_that_its_neighbours_show_as_well_is_none_of_their_making(make_raster: MakeRaster) -> None:
    """The inner image of a block, a pixel off its neighbours, which shows in the mosaic what is its alone: noise."""
    rng, ground = np.random.default_rng(3), orthoimage((SIDE, SIDE), seed=4).astype(float)
    moved = [np.roll(ground, pixels, 1) for pixels in range(3)]
    moved[1] = ndimage.gaussian_filter(moved[1], (0, 0.7, 0.7))
    images = [np.clip(np.rint(image + rng.normal(0, 1.5, image.shape)), 1, 255) for image in moved]
    mosaic = np.choose(np.arange(SIDE) // 342, images)
    paths = [make_raster(f"{name}.tif", data.astype(np.uint8)) for name, data in zip("abcm", [*images, mosaic])]
    assert told(paths[-1], paths[:-1]) == (["a.tif", "b.tif", "c.tif"], {})


@pytest.fixture
def triplet(make_raster: MakeRaster) -> dict[str, str]:
    """Three images of one satellite's pass, alike everywhere, and the mosaic of the first two."""
    rng = np.random.default_rng(3)
    scene = orthoimage((SIDE, SIDE), seed=4).astype(float)
    images = [np.clip(scene + rng.normal(0, 9, scene.shape), 1, 255).astype(np.uint8) for _ in range(3)]
    mosaic = np.where(np.arange(SIDE) < 600, images[0], images[1])
    return {name: make_raster(f"{name}.tif", data) for name, data in zip(("a", "b", "c", "mosaic"), [*images, mosaic])}


@pytest.mark.slow
def test_images_that_are_alike_everywhere_are_no_copies_where_the_mosaic_turns_from_one_to_the_other(
    triplet: dict[str, str], tmp_path: Path
) -> None:
    copy = str(tmp_path / "lossy.tif")
    gdal.Translate(copy, triplet["mosaic"], creationOptions=["COMPRESS=JPEG", "JPEG_QUALITY=90"])
    kept, notices = told(triplet["mosaic"], [triplet["a"], copy, triplet["b"]])
    assert kept == ["a.tif", "lossy.tif", "b.tif"]  # no place tells the orthoimages from what was made of the mosaic
    assert notices == {"lossy.tif": messages.MAY_BE_ALTERED_COPY.template}


@pytest.mark.slow
@pytest.mark.parametrize("noise_dn", [5.0, 12.0])
def test_an_image_that_was_resampled_into_the_mosaic_is_no_copy_of_it(make_raster: MakeRaster, noise_dn: float) -> None:
    """Both cover the mosaic and are alike everywhere, with noise as soft as resampling leaves it; the grid of one lies
    half a pixel beside the mosaic's."""
    rng = np.random.default_rng(3)
    scene = orthoimage((SIDE, SIDE), seed=4).astype(float)
    first, second = (
        ndimage.gaussian_filter(np.clip(scene + rng.normal(0, noise_dn, scene.shape), 1, 255), (0, 1.2, 1.2))
        for _ in range(2)
    )
    given = ndimage.shift(second, (0, 0.5, -0.5), order=3, mode="mirror")
    mosaic = np.where(np.arange(SIDE) < 600, first, second)
    paths = [
        make_raster(f"{name}.tif", np.clip(np.rint(plane), 1, 255).astype(np.uint8))
        for name, plane in (("mosaic", mosaic), ("a", first), ("b", given))
    ]
    assert told(paths[0], paths[1:])[0] == ["a.tif", "b.tif"]


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["jpeg", "png", "equal"])
def test_windows_are_inspected_without_a_copy_of_the_mosaic(
    paths: list[str], images: list[np.ndarray], make_raster: MakeRaster, tmp_path: Path, kind: str
) -> None:
    """It would say that nothing was lost: it lost the same."""
    weight = np.clip((np.arange(SIDE) - 512) / 60 + 0.5, 0, 1)
    feathered = make_raster("feathered.tif", np.rint((1 - weight) * images[0] + weight * images[1]).astype(np.uint8))
    copy = str(tmp_path / f"other_name.{kind}.tif")
    options = {"jpeg": ["COMPRESS=JPEG", "JPEG_QUALITY=85"], "png": [], "equal": ["COMPRESS=LZW"]}[kind]
    gdal.Translate(copy, feathered, format="PNG" if kind == "png" else "GTiff", creationOptions=options)
    mosaic = describe_mosaic(RasterRef(feathered))
    block, _ = make_block(mosaic, [RasterRef(path) for path in (paths[0], copy, paths[1])])
    block, notices = without_copies(block)
    assert [source.ref.name for source in block.sources] == ["a.tif", "b.tif"]
    assert [notice.template for notice in notices] == [messages.COPY_AMONG_SOURCES.template]
    extent = mosaic.grid.window_extent(PixelWindow(384, 384, 256, 256))
    result = inspect_window(window_request(block, 1, extent, InspectionSettings()))
    assert result.judgement.verdict is Verdict.SIGNIFICANT


def test_a_copy_that_is_the_only_source_stays_and_is_told(paths: list[str], tmp_path: Path) -> None:
    """It may be the one orthoimage."""
    copy = str(tmp_path / "copy.tif")
    gdal.Translate(copy, paths[2])
    block, _ = make_block(describe_mosaic(RasterRef(paths[2])), [RasterRef(copy)])
    block, notices = without_copies(block)
    assert [source.ref.name for source in block.sources] == ["copy.tif"]
    assert [notice.template for notice in notices] == [messages.MAY_BE_COPY.template]


def test_the_mosaic_that_a_sheet_was_cut_from_is_left_out(
    make_raster: MakeRaster, images: list[np.ndarray], paths: list[str]
) -> None:
    sheet = make_raster("sheet.tif", images[2][:, 256:1024, 256:1024], origin=(500025.6, 4999974.4))
    kept, notices = told(sheet, [paths[2], *paths[:2]])
    assert kept == ["a.tif", "b.tif"]
    assert notices == {"mosaic.tif": messages.COPY_AMONG_SOURCES.template}


def test_an_orthoimage_that_the_mosaic_was_cut_from_stays_and_is_told(
    make_raster: MakeRaster, images: list[np.ndarray], paths: list[str]
) -> None:
    """The mosaic is as small as a window in the middle of it."""
    cut = make_raster("cut.tif", images[0][:, 256:512, 256:512], origin=(500025.6, 4999974.4))
    assert told(cut, paths[:2]) == (["a.tif", "b.tif"], {"a.tif": messages.MAY_BE_COPY.template})


@pytest.fixture
def canvas(make_raster: MakeRaster) -> list[str]:
    """Three orthoimages on one canvas, each with pixels on a part of it; in the mosaic the last lies on top."""
    images = [orthoimage((512, 768), seed=seed) for seed in (1, 2, 3)]
    mosaic = np.zeros_like(images[0])
    for image, (first, last) in zip(images, ((0, 600), (150, 768), (60, 760))):
        image[..., :first], image[..., last:] = 0, 0
        mosaic = np.where(image > 0, image, mosaic)
    return [make_raster(f"{name}.tif", pixels, nodata=0) for name, pixels in zip(("mosaic", *"pqr"), (mosaic, *images))]


def test_the_orthoimage_on_top_of_a_canvas_is_no_copy(canvas: list[str], tmp_path: Path) -> None:
    """It is the mosaic wherever it has pixels."""
    assert told(canvas[0], canvas[1:]) == (["p.tif", "q.tif", "r.tif"], {})
    copy = str(tmp_path / "copy.tif")
    gdal.Translate(copy, canvas[0])
    kept, notices = told(canvas[0], [*canvas[1:], copy])
    assert kept[:3] == ["p.tif", "q.tif", "r.tif"]
    assert "r.tif" not in notices
    assert notices.keys() == {"copy.tif"}


@pytest.mark.slow
def test_no_true_source_is_dropped_of_sheets_that_are_scanned_one_by_one(make_raster: MakeRaster) -> None:
    """Some lie in one image, some on a seam, some have a corner of another image that covers a hundredth of them."""
    images = [orthoimage((SIDE, SIDE), seed=seed) for seed in (1, 2, 3)]
    down, across = np.indices((SIDE, SIDE))
    owner = np.where(across < 500, 0, np.where(down < 450, 1, 2))
    mosaic = np.choose(owner, images)
    sources = [make_raster(f"{name}.tif", image) for name, image in zip("abc", images)]
    whole = make_raster("whole.tif", mosaic)
    for row, column in ((0, 0), (0, 300), (600, 300), (300, 640), (200, 476), (422, 128)):
        pixels = mosaic[:, row : row + 384, column : column + 384]
        sheet = make_raster("sheet.tif", pixels, origin=(500000 + 0.1 * column, 5000000 - 0.1 * row))
        kept, notices = told(sheet, sources)
        assert kept == ["a.tif", "b.tif", "c.tif"]
        kept, notices = told(sheet, [*sources, whole])
        assert kept[:3] == ["a.tif", "b.tif", "c.tif"]
        assert "whole.tif" in notices  # the mosaic that it was cut from is left out, or told


def test_a_part_of_the_mosaic_stays_and_is_told(
    make_raster: MakeRaster, images: list[np.ndarray], paths: list[str]
) -> None:
    """A true orthoimage, too, may be the mosaic wherever it lies."""
    part = make_raster("part.tif", images[2][:, 600:, 500:], origin=(500050.0, 4999940.0))
    kept, notices = told(paths[2], [*paths[:2], part])
    assert kept == ["a.tif", "b.tif", "part.tif"]
    assert notices == {"part.tif": messages.MAY_BE_COPY.template}


def test_ground_without_content_proves_nothing(make_raster: MakeRaster) -> None:
    flat = np.full((3, 256, 256), 7, np.uint8)
    mosaic, other = make_raster("mosaic.tif", flat), make_raster("other.tif", flat)
    assert told(mosaic, [other]) == (["other.tif"], {})


@pytest.mark.parametrize("side", [1, 2])
@pytest.mark.filterwarnings("error")
def test_a_mosaic_of_a_few_pixels_proves_nothing(paths: list[str], tmp_path: Path, side: int) -> None:
    few = str(tmp_path / "few.tif")
    gdal.Translate(few, paths[2], srcWin=[16, 16, side, side])
    assert told(few, paths[:2]) == (["a.tif", "b.tif"], {})


def test_one_that_can_not_be_read_is_left_to_the_scan(paths: list[str]) -> None:
    raster = describe_mosaic(RasterRef(paths[2]))
    os.truncate(paths[0], 3000)
    sources = [Source(RasterRef(path), raster.extent) for path in (paths[0], "gone.tif")]
    assert leave_out_copies(raster, sources) == (sources, [])


def test_brighton_and_copies_of_it(data_folder: Path, tmp_path: Path) -> None:
    folder = data_folder / "seams" / "brighton"
    mosaic = str(folder / "mosaic_hardseam.tif")
    sources = sorted(map(str, folder.glob("*_ortho.tif")))
    made = {kind: str(tmp_path / f"{kind}.tif") for kind in ("jpeg", "average", "copy")}
    gdal.Translate(made["jpeg"], mosaic, creationOptions=["COMPRESS=JPEG", "JPEG_QUALITY=75", "TILED=YES"])
    gdal.Translate(made["average"], mosaic, widthPct=50, heightPct=50, resampleAlg="average")
    gdal.Translate(made["copy"], mosaic)
    kept, notices = told(mosaic, [*made.values(), *sources])
    assert kept == [Path(path).name for path in sources]
    assert notices == {f"{kind}.tif": messages.COPY_AMONG_SOURCES.template for kind in made}


@pytest.mark.release
def test_the_one_image_of_a_real_mosaic_stays_among_its_neighbours(data_folder: Path, tmp_path: Path) -> None:
    """Now the one, now the other of these is nearer to it."""
    sources = sorted(map(str, (data_folder / "seams" / "brighton").glob("*_ortho.tif")))
    mosaic = str(tmp_path / "mosaic.tif")
    gdal.Translate(mosaic, sources[1])
    kept, notices = told(mosaic, sources)
    assert kept == [Path(path).name for path in sources]
    assert notices == {Path(sources[1]).name: messages.MAY_BE_COPY.template}


def test_sources_are_not_compared_with_each_other(mosaic: Raster) -> None:
    """An index names a hundred thousand, of which few are where the mosaic is."""
    far = [Source(RasterRef(f"/nowhere/{number}.tif"), (0.0, 0.0, 1.0, 1.0)) for number in range(2000)]
    assert leave_out_copies(mosaic, far) == (far, [])
    assert calls_of(lambda: leave_out_copies(mosaic, far)) < 100 * len(far)


@pytest.mark.parametrize("sigma", [0.0, 0.4])
def test_orthoimages_that_are_all_cut_from_the_mosaic_are_refused(
    make_raster: MakeRaster, images: list[np.ndarray], sigma: float
) -> None:
    """Nothing is said where a true one is among them, which shows what they don't."""
    mosaic = make_raster("mosaic.tif", images[2])
    softened = ndimage.gaussian_filter(images[2], (0, sigma, sigma))
    cut = [make_raster(f"part{left}.tif", softened, valid=inside(left)) for left in (0, 200)]
    with pytest.raises(SettingsError, match=r"All 2 orthoimages show the mosaic's pixels .* as they were rectified"):
        told(mosaic, cut)
    assert len(told(mosaic, [*cut, make_raster("a.tif", images[0])])[0]) == 3


def inside(left: int) -> np.ndarray:
    """All but 200 px of the columns."""
    columns = np.arange(SIDE)
    return np.tile((columns >= left) & (columns < left + SIDE - 200), (SIDE, 1))
