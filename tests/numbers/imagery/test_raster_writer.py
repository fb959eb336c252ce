"""Rasters that are written are there whole or not at all, with what belongs to them and nothing else."""
from __future__ import annotations

import os
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.errors import CancelledError, Message, RasterError
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe
from seam_inspector.plugin.imagery.raster_writer import WrittenBands, raster_writer
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef

from tests.numbers.disks import full_disk
from tests.numbers.synthetic import orthoimage, write_mask, write_raster

BANDS = WrittenBands(3, np.dtype(np.uint8))
PIXELS = orthoimage((300, 400))
RPC_NAMES = [f"{axis}_{kind}" for axis in ("LINE", "SAMP", "LAT", "LONG", "HEIGHT") for kind in ("OFF", "SCALE")]
RPC_NAMES += [f"{axis}_{part}_COEFF_{number}" for axis in ("LINE", "SAMP") for part in ("NUM", "DEN")
              for number in range(1, 21)]

pytestmark = pytest.mark.usefixtures("either_gdal")


@pytest.fixture
def like(tmp_path: Path) -> Raster:
    folder = tmp_path / "input"
    folder.mkdir()
    return describe(RasterRef(write_raster(folder / "like.tif", PIXELS)))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """An output folder with an older raster in it, its mask and overviews beside it, and files that are not its own."""
    made = tmp_path / "output"
    made.mkdir()
    path = write_raster(made / "out.tif", PIXELS[:1])
    dataset = gdal.Open(path)
    write_mask(dataset, np.zeros((300, 400), np.uint8))
    dataset.BuildOverviews("NEAREST", [2])
    dataset.GetRasterBand(1).ComputeStatistics(False)
    del dataset
    (made / "out_RPC.TXT").write_text("".join(f"{name}: 1\n" for name in RPC_NAMES))
    (made / "out_2.tif").write_text("another")
    (made / "out.txt").write_text("notes")
    return made


def contents(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def write(path: Path, like: Raster, invalid: np.ndarray | None = None) -> None:
    with raster_writer(str(path), like, replace(BANDS, colours=True)) as writer:
        for row in range(0, 300, 100):
            writer.write(row, PIXELS[:, row : row + 100], invalid)


def test_what_is_written_has_the_place_of_the_raster_it_was_made_from(tmp_path: Path, like: Raster) -> None:
    write(tmp_path / "out.tif", like)
    source = OpenRaster(RasterRef(str(tmp_path / "out.tif")))
    assert (source.raster.geotransform, source.raster.wkt) == (like.geotransform, like.wkt)
    assert source.raster.band_names == ("red", "green", "blue")
    assert np.array_equal(source.read(source.raster.whole).bands, PIXELS)
    assert sorted(os.listdir(tmp_path)) == ["input", "out.tif"]


def test_a_mask_comes_along_and_is_read_again(tmp_path: Path, like: Raster) -> None:
    invalid = np.zeros((100, 400), bool)
    invalid[:, :50] = True
    write(tmp_path / "out.tif", like, invalid)
    assert sorted(os.listdir(tmp_path)) == ["input", "out.tif", "out.tif.msk"]
    block = OpenRaster(RasterRef(str(tmp_path / "out.tif"))).read(like.whole)
    assert np.array_equal(block.invalid, np.tile(invalid, (3, 1)))


def test_an_older_raster_takes_its_own_files_with_it_and_no_others(folder: Path, like: Raster) -> None:
    assert {"out.tif.msk", "out.tif.ovr", "out.tif.aux.xml", "out_RPC.TXT"} <= contents(folder).keys()
    write(folder / "out.tif", like)
    assert sorted(os.listdir(folder)) == ["out.tif", "out.txt", "out_2.tif"]
    assert OpenRaster(RasterRef(str(folder / "out.tif"))).read(like.whole).invalid is None


def test_the_sources_of_an_older_virtual_raster_stay(folder: Path, like: Raster) -> None:
    gdal.Translate(str(folder / "out.vrt"), str(folder / "out.tif"), format="VRT")
    before = contents(folder)
    write(folder / "out.vrt", like)
    after = contents(folder)
    assert before.keys() == after.keys()
    assert {name for name in before if before[name] != after[name]} == {"out.vrt"}


@pytest.mark.parametrize("reached", [0, 1, 2])
def test_cancelled_midway_it_leaves_no_half_file_and_an_older_one_as_it_was(
    folder: Path, like: Raster, reached: int
) -> None:
    before = contents(folder)
    for name in ("out.tif", "new.tif"):
        with suppress(CancelledError), raster_writer(str(folder / name), like, BANDS) as writer:
            for strip in range(reached):
                writer.write(strip * 100, PIXELS[:, :100], np.ones((100, 400), bool))
            raise CancelledError(Message("enough"))
    assert contents(folder) == before


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # GDAL's, of a dataset let go
@pytest.mark.parametrize("most_bytes", [0, 1000, 100_000], ids=["at once", "while writing", "while closing"])
def test_a_full_disk_is_a_sentence_and_leaves_an_older_file_as_it_was(
    folder: Path, like: Raster, most_bytes: int
) -> None:
    before = contents(folder)
    for name in ("out.tif", "new.tif"):
        said = pytest.raises(RasterError, match=rf"{name} can't be written; choose another folder, or make room")
        with said, full_disk(most_bytes):
            write(folder / name, like)
        assert contents(folder) == before
