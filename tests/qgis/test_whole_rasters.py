"""Rasters that algorithms write: whole, or not there; an older one stays until then."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from osgeo import gdal
from seam_inspector.plugin.photos.measure import photo
from seam_inspector.plugin.resolution.measure import bayer

from tests.numbers.disks import full_disk
from tests.numbers.synthetic import orthoimage, write_raster
from tests.qgis.runs import Log, assert_sentence, run

pytestmark = pytest.mark.usefixtures("provider")
OLDER = ("out.tif", "out.tif.aux.xml", "out.tif.ovr")
Job = tuple[str, dict[str, Any]]


class Impatient(Log):
    """Cancels at the first sign of progress."""

    def setProgress(self, progress: float) -> None:
        if progress > 0:
            self.cancel()


def image_with_rpc(path: Path) -> str:
    """An image that sees a hundredth of a degree: columns along longitudes, rows against latitudes."""
    write_raster(path, orthoimage((300, 300)), geotransform=(0.0, 1.0, 0.0, 0.0, 0.0, 1.0), system=None)
    terms = {name: ["0"] * 20 for name in ("LINE_NUM", "LINE_DEN", "SAMP_NUM", "SAMP_DEN")}
    terms["LINE_DEN"][0] = terms["SAMP_DEN"][0] = "1"
    terms["SAMP_NUM"][1], terms["LINE_NUM"][2] = "1", "-1"
    lines = [f"{name}_COEFF_{number}: {value}" for name, row in terms.items() for number, value in enumerate(row, 1)]
    scales = {"LINE": (150, 150), "SAMP": (150, 150), "LAT": (50, 0.01), "LONG": (16, 0.01), "HEIGHT": (100, 100)}
    for name, (offset, scale) in scales.items():
        lines += [f"{name}_OFF: {offset}", f"{name}_SCALE: {scale}"]
    path.with_name(f"{path.stem}_RPC.TXT").write_text("\n".join(lines) + "\n")
    return str(path)


@pytest.fixture(params=["enhancephoto", "simulatebayer", "orthorectify"])
def job(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Job:
    """An algorithm that writes a raster and what it needs, in small steps."""
    monkeypatch.setattr(photo, "STRIP_PIXELS", 30_000)
    monkeypatch.setattr(bayer, "_STRIP_PIXELS", 30_000)
    folder = tmp_path / "input"
    folder.mkdir()
    image = image_with_rpc(folder / "image.tif")
    return request.param, {
        "enhancephoto": {"PHOTO": image, "OPERATION": "negative"},
        "simulatebayer": {"RASTER": write_raster(folder / "scene.tif", orthoimage((300, 300)))},
        "orthorectify": {"IMAGE": image, "HEIGHT": 100},
    }[request.param]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """An output folder with an older raster in it, with its statistics and overviews beside it."""
    made = tmp_path / "output"
    made.mkdir()
    dataset = gdal.Open(write_raster(made / "out.tif", orthoimage((200, 200))))
    dataset.BuildOverviews("NEAREST", [2])
    dataset.GetRasterBand(1).ComputeStatistics(False)
    return made


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_a_new_raster_replaces_an_older_one_and_what_lay_beside_it(job: Job, folder: Path) -> None:
    name, given = job
    assert sorted(contents(folder)) == list(OLDER)
    before = contents(folder)["out.tif"]
    made = run(name, OUTPUT=str(folder / "out.tif"), **given)
    assert made.complaint is None
    assert contents(folder).keys() == {"out.tif"}
    assert contents(folder)["out.tif"] != before
    assert gdal.Open(made.results["OUTPUT"]).ReadAsArray().any()


@pytest.mark.parametrize("ending", ["", ".TIF", ".tiff"])
def test_a_raster_is_a_geotiff_under_the_names_that_one_has(job: Job, tmp_path: Path, ending: str) -> None:
    name, given = job
    path = str(tmp_path / f"out{ending}")
    assert run(name, OUTPUT=path, **given).results["OUTPUT"] == path
    assert gdal.Open(path).GetDriver().ShortName == "GTiff"


def test_cancelled_midway_nothing_is_left_of_it_and_an_older_raster_stays(job: Job, folder: Path) -> None:
    name, given = job
    before = contents(folder)
    for output in ("out.tif", "new.tif"):
        log = Impatient()
        stopped = run(name, log, OUTPUT=str(folder / output), **given)
        assert log.isCanceled()
        assert stopped.results == {}
        assert_sentence(log.warnings[-1], "was cancelled; nothing was written")
        assert contents(folder) == before


@pytest.mark.parametrize("most_bytes", [0, 20_000])
def test_a_full_disk_is_a_sentence_and_an_older_raster_stays(job: Job, folder: Path, most_bytes: int) -> None:
    name, given = job
    before = contents(folder)
    for output in ("out.tif", "new.tif"):
        with full_disk(most_bytes):
            failed = run(name, OUTPUT=str(folder / output), **given)
        assert_sentence(failed.complaint, "can't be written|could not be written")
        assert contents(folder) == before
