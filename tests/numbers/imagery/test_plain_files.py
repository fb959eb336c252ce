"""What must not be opened: devices, pipes, memory, and VRTs that lead there; what declares more than memory holds."""
from __future__ import annotations

import builtins
import os
import threading
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery import limits
from seam_inspector.plugin.imagery.documents import document_bytes, json_document
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.gdal_calls import check_raster_path, vrt_parts
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import OpenRaster
from seam_inspector.plugin.imagery.rasters import RasterRef

from tests.numbers.synthetic import write_raster

VRT = (
    '<VRTDataset rasterXSize="64" rasterYSize="64"><VRTRasterBand dataType="Byte" band="1">{}'
    "</VRTRasterBand></VRTDataset>"
)
SOURCE = "<SimpleSource><SourceFilename>{}</SourceFilename><SourceBand>1</SourceBand></SimpleSource>"


def refusal(path: Path | str) -> str:
    """What is said of a raster that is opened and read in another thread: it must not wait for anything."""
    said: list[str] = []

    def look() -> None:
        try:
            OpenRaster(RasterRef(str(path))).read(PixelWindow(0, 0, 8, 8))
        except RasterError as error:
            said.append(str(error))

    thread = threading.Thread(target=look, daemon=True)
    thread.start()
    thread.join(20)
    assert not thread.is_alive(), "it waits"
    return said[0]


def test_pipes_and_devices_are_not_opened(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.tif")
    assert "pipe.tif is a device, a pipe or memory" in refusal(tmp_path / "pipe.tif")
    for path in ("/dev/zero", "/proc/self/mem", "/vsistdin/", "MEM:::DATAPOINTER=1,PIXELS=64,LINES=64"):
        assert "is a device, a pipe or memory" in refusal(path)


@pytest.mark.parametrize("inside", [
    SOURCE.format("MEM:::DATAPOINTER=1,PIXELS=64,LINES=64"),
    SOURCE.format("&#77;em:::datapointer=1,PIXELS=64,LINES=64"),
    SOURCE.format("<![CDATA[/dev/zero]]>"), SOURCE.format("/vsistdin/"), SOURCE.format("{pipe}"),
    SOURCE.format("{inner}"), "<SourceFilename relativeToVRT='1'>pipe.tif</SourceFilename>",
])  # fmt: skip
def test_no_vrt_leads_there(tmp_path: Path, inside: str) -> None:
    os.mkfifo(tmp_path / "pipe.tif")
    inner = tmp_path / "inner.xml"  # a VRT by what it says, not by its name
    inner.write_text(VRT.format(SOURCE.format("/dev/urandom")))
    path = tmp_path / "made.vrt"
    path.write_text(VRT.format(inside.format(pipe=tmp_path / "pipe.tif", inner=inner)))
    assert "made.vrt is a VRT that leads to" in refusal(path)


def test_vrts_in_a_ring_are_read_no_further_than_once(tmp_path: Path) -> None:
    for number in range(5):
        (tmp_path / f"{number}.vrt").write_text(VRT.format(SOURCE.format(tmp_path / f"{(number + 1) % 5}.vrt")))
    assert vrt_parts(str(tmp_path / "4.vrt")) == (str(tmp_path / "0.vrt"),)
    assert refusal(tmp_path / "0.vrt").endswith(".")


@pytest.mark.parametrize(("depth", "times"), [(20, 2), (6, 10)])
def test_vrts_that_name_each_other_a_million_times_are_refused(tmp_path: Path, depth: int, times: int) -> None:
    (tmp_path / "0.tif").write_bytes(b"II*")
    inner = tmp_path / "0.tif"
    for number in range(depth):
        outer = tmp_path / f"{number}.vrt"
        outer.write_text(VRT.format(SOURCE.format(inner) * times))
        inner = outer
    with pytest.raises(RasterError, match=r"is a VRT of more than 300000 files"):
        check_raster_path(str(inner), inner.name)


def test_vrts_of_vrts_with_many_bands_name_each_file_once(tmp_path: Path) -> None:
    """Six levels of 16 bands: each band is read from one file, however often that is named."""
    (tmp_path / "0.tif").write_bytes(b"II*")
    inner = tmp_path / "0.tif"
    for number in range(6):
        outer = tmp_path / f"{number}.vrt"
        band = VRT.format(SOURCE.format(inner)).replace("<VRTDataset", "<a").replace("</VRTDataset>", "</a>")
        outer.write_text(f"<VRTDataset>{band * 16}</VRTDataset>")
        inner = outer
    check_raster_path(str(inner), inner.name)


def test_what_stays_as_it_is_is_looked_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A mosaic of ten thousand files is opened for every window."""
    parts = [tmp_path / f"{number}.tif" for number in range(20)]
    for part in parts:
        part.write_bytes(b"II*")
    mosaic = tmp_path / "mosaic.vrt"
    mosaic.write_text(VRT.format("".join(SOURCE.format(part) for part in parts)))
    check_raster_path(str(mosaic), "mosaic.vrt")
    with monkeypatch.context() as patch:
        for module, name in ((os.path, "realpath"), (builtins, "open")):
            patch.setattr(module, name, lambda *path: pytest.fail("it is looked at again"))
        check_raster_path(str(mosaic), "mosaic.vrt")
    parts[7].unlink()
    parts[7].symlink_to("/dev/zero")
    with pytest.raises(RasterError, match=r"mosaic\.vrt is a VRT that leads to .*7\.tif"):
        check_raster_path(str(mosaic), "mosaic.vrt")


def test_a_part_that_changed_is_looked_at_though_its_size_and_time_are_as_before(tmp_path: Path) -> None:
    mosaic, inner = tmp_path / "mosaic.vrt", tmp_path / "inner.vrt"
    mosaic.write_text(VRT.format(SOURCE.format(inner)))
    inner.write_text(VRT.format(SOURCE.format("/old/null")))
    before = inner.stat()
    check_raster_path(str(mosaic), "mosaic.vrt")
    inner.write_text(VRT.format(SOURCE.format("/dev/null")))
    os.utime(inner, ns=(before.st_atime_ns, before.st_mtime_ns))
    with pytest.raises(RasterError, match="leads to /dev/null"):
        check_raster_path(str(mosaic), "mosaic.vrt")


def test_bands_and_blocks_beyond_all_memory_are_refused(tmp_path: Path) -> None:
    create, options = gdal.GetDriverByName("GTiff").Create, ["SPARSE_OK=TRUE", "TILED=YES", "COMPRESS=DEFLATE"]
    huge = [*options, "BLOCKXSIZE=32768", "BLOCKYSIZE=32768"]
    create(str(tmp_path / "block.tif"), 40_000, 40_000, 1, gdal.GDT_Byte, huge).FlushCache()
    assert "blocks of 32768 x 32768 px, which are too large" in refusal(tmp_path / "block.tif")
    create(str(tmp_path / "bands.tif"), 64, 64, 2000, gdal.GDT_Byte, options).FlushCache()
    assert "has 2000 bands and 1024 are the most" in refusal(tmp_path / "bands.tif")


def test_no_more_is_read_at_once_than_memory_holds(tmp_path: Path) -> None:
    create, options = gdal.GetDriverByName("GTiff").Create, ["SPARSE_OK=TRUE", "TILED=YES", "COMPRESS=DEFLATE"]
    create(str(tmp_path / "large.tif"), 40_000, 40_000, 1, gdal.GDT_Byte, options).FlushCache()
    large = OpenRaster(RasterRef(str(tmp_path / "large.tif")))
    with pytest.raises(RasterError, match=r"40000 x 40000 px of large\.tif are too many to be read at once"):
        large.read(PixelWindow(0, 0, 40_000, 40_000))
    assert large.read(PixelWindow(0, 0, 40_000, 40_000), (10, 10)).bands.shape == (1, 10, 10)
    path = tmp_path / "endless.vrt"
    path.write_text(VRT.format("").replace('"64"', '"2147483647"'))
    assert "says it has 2147483647 x 2147483647 px" in refusal(path)


@pytest.mark.parametrize("value", [1e38, -3.4e38, np.inf, np.nan])
def test_values_that_no_measurement_has_are_invalid(tmp_path: Path, value: float) -> None:
    pixels = np.full((1, 64, 64), 7, np.float32)
    pixels[0, 3, 5] = value
    block = OpenRaster(RasterRef(write_raster(tmp_path / "a.tif", pixels))).read(PixelWindow(0, 0, 64, 64))
    assert np.argwhere(~block.valid).tolist() == [[3, 5]]
    assert np.finfo(np.float32).max > limits.LARGEST_VALUE**2 * 1e6


def test_documents_have_an_end(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.json")
    for path in (tmp_path / "pipe.json", Path("/dev/zero"), Path("/proc/self/mem"), tmp_path):
        with pytest.raises(OSError, match=r"a device or a pipe|directory"):
            document_bytes(path)
    for text in ("[" * 200_000 + "]" * 200_000, "{", "[1,"):
        with pytest.raises(ValueError, match=r"nested too deeply|Expecting"):
            json_document(text)
