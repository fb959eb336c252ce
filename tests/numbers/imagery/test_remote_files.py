"""Rasters over the network: only what is needed is fetched."""
from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np
from osgeo import gdal
from seam_inspector.plugin.imagery.gdal_paths import is_remote, readable_path, remote_parts
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe
from seam_inspector.plugin.imagery.raster_pool import open_raster
from seam_inspector.plugin.imagery.rasters import RasterRef

from tests.numbers.conftest import MakeRaster
from tests.numbers.imagery.conftest import SIDE, WHOLE, expected, read
from tests.numbers.synthetic import orthoimage
from tests.range_server import RangeServer


def tile_bytes(folder: Path, x: int, y: int) -> int:
    dataset = gdal.Open(str(folder / "cog.tif"))
    return int(dataset.GetRasterBand(1).GetMetadataItem(f"BLOCK_SIZE_{x}_{y}", "TIFF"))


def test_only_the_tiles_of_the_window_are_fetched_and_once(server: RangeServer, folder: Path) -> None:
    np.testing.assert_array_equal(read(server.vsi("cog.tif")), expected(folder))
    tiles = sum(tile_bytes(folder, x, y) for x in (1, 2) for y in (1, 2))
    assert tiles <= server.sent <= tiles + 16384 + 4 * 64  # the file's head; what COG writes around each tile
    assert not [answer for answer in server.answers if answer.path.endswith("/")]  # no folder is listed
    server.forget()
    read(server.vsi("cog.tif"))
    assert server.answers == []
    read(server.vsi("cog.tif"), PixelWindow(300, 300, 500, 100))  # one tile to the right of them
    assert server.sent <= tile_bytes(folder, 3, 1) + 2 * 16384  # in whole chunks


def test_a_plain_address_is_read_in_parts_too(server: RangeServer, folder: Path) -> None:
    np.testing.assert_array_equal(read(server.address("cog.tif")), expected(folder))
    assert server.sent < (folder / "cog.tif").stat().st_size / 2
    assert describe(RasterRef(server.address("cog.tif"))).grid == describe(RasterRef(server.vsi("cog.tif"))).grid


def test_a_mask_beside_a_plain_file_counts(server: RangeServer) -> None:
    block = open_raster(RasterRef(server.vsi("plain.tif"))).read(WHOLE)
    assert block.invalid[:, SIDE // 2:].all()
    assert not block.invalid[:, : SIDE // 2].any()
    assert not [answer for answer in server.answers if answer.path.endswith("/")]  # no folder is listed


def test_a_file_inside_an_archive_is_read_in_parts(server: RangeServer, folder: Path) -> None:
    path = f"/vsizip/{server.vsi('archive.zip')}/inner/cog.tif"
    np.testing.assert_array_equal(read(path), expected(folder))
    assert server.sent < (folder / "cog.tif").stat().st_size / 2


def test_a_vrt_here_of_files_there_fetches_what_is_needed(server: RangeServer, folder: Path, tmp_path: Path) -> None:
    path = str(tmp_path / "of files.vrt")
    gdal.BuildVRT(path, [server.vsi("cog.tif")]).FlushCache()
    assert remote_parts(path) == (server.vsi("cog.tif"),)
    outer = str(tmp_path / "of VRTs.vrt")
    gdal.BuildVRT(outer, [path]).FlushCache()
    assert remote_parts(outer) == (server.vsi("cog.tif"),)
    gdal.VSICurlClearCache()
    server.forget()
    np.testing.assert_array_equal(read(path), expected(folder))
    assert server.sent < (folder / "cog.tif").stat().st_size / 2
    assert not [answer for answer in server.answers if answer.path.endswith("/")]


def test_what_is_here_knows_nothing_of_it(make_raster: MakeRaster, tmp_path: Path) -> None:
    path = make_raster("a.tif", orthoimage((64, 64)))
    with zipfile.ZipFile(tmp_path / "a.zip", "w") as archive:
        archive.write(path, "a.tif")
    for local in (path, f"/vsizip/{tmp_path}/a.zip/a.tif", str(tmp_path / "none.vrt"), "/vsimem/a.tif", "C:\\a.tif"):
        assert not is_remote(local)
        assert remote_parts(local) == ()
        assert readable_path(local) == local
    assert read(f"/vsizip/{tmp_path}/a.zip/a.tif", PixelWindow(0, 0, 64, 64)).shape == (3, 64, 64)
    for remote in ("/vsis3/bucket/a.tif", "/vsicurl?url=http://a", "https://a/b.tif", "/vsizip//vsicurl/http://a.zip/b"):
        assert is_remote(remote)
