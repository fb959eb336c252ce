"""GDAL in both of its ways, and rasters served over the network."""
from __future__ import annotations

import zipfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, osr
from seam_inspector.plugin.imagery import gdal_paths
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.raster_pool import open_raster, rasters_kept
from seam_inspector.plugin.imagery.rasters import RasterRef

from tests.numbers.synthetic import orthoimage, read_pixels, write_mask
from tests.range_server import RangeServer, serving

SIDE, TILE = 1024, 256
WINDOW = PixelWindow(300, 300, 300, 300)  # on four tiles
WHOLE = PixelWindow(0, 0, SIDE, SIDE)


@pytest.fixture(params=[False, True], ids=["quiet GDAL", "GDAL with exceptions"])
def either_gdal(request: pytest.FixtureRequest) -> Iterator[None]:
    """GDAL and OSR as any other plugin in the same process may have left them."""
    before = bool(gdal.GetUseExceptions()), bool(osr.GetUseExceptions())
    use_exceptions(request.param, request.param)
    yield
    use_exceptions(*before)


def use_exceptions(of_gdal: bool, of_osr: bool) -> None:
    """They are a stack: GDAL's go on first, and off last."""
    if osr.GetUseExceptions():
        osr.DontUseExceptions()
    if bool(gdal.GetUseExceptions()) is not of_gdal:
        (gdal.UseExceptions if of_gdal else gdal.DontUseExceptions)()
    if of_osr:
        osr.UseExceptions()


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A COG, the same with a broken end, a TIFF with its mask beside it, an archive and a page that is no raster."""
    place = tmp_path_factory.mktemp("served")
    image = orthoimage((SIDE, SIDE))
    memory = gdal.GetDriverByName("MEM").Create("", SIDE, SIDE, 3)
    memory.WriteArray(image)
    memory.SetGeoTransform((0.0, 1.0, 0.0, 0.0, 0.0, -1.0))
    options = [f"BLOCKSIZE={TILE}", "COMPRESS=DEFLATE", "OVERVIEWS=NONE"]
    gdal.GetDriverByName("COG").CreateCopy(str(place / "cog.tif"), memory, options=options)
    whole = (place / "cog.tif").read_bytes()
    (place / "short.tif").write_bytes(whole[: len(whole) * 3 // 4])
    plain = gdal.GetDriverByName("GTiff").CreateCopy(str(place / "plain.tif"), memory, options=["TILED=YES"])
    write_mask(plain, np.tile(np.repeat(np.uint8([255, 0]), SIDE // 2), (SIDE, 1)))
    del plain
    assert (place / "plain.tif.msk").exists()
    with zipfile.ZipFile(place / "archive.zip", "w") as archive:
        archive.write(place / "cog.tif", "inner/cog.tif")
    (place / "page.tif").write_text("<html>Please log in</html>")
    return place


@pytest.fixture
def server(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[RangeServer]:
    monkeypatch.setitem(gdal_paths.SETTINGS, "GDAL_HTTP_RETRY_DELAY", "0.01")
    gdal.VSICurlClearCache()
    with serving(folder) as started, rasters_kept():
        yield started
    gdal.VSICurlClearCache()


def read(path: str, window: PixelWindow = WINDOW) -> np.ndarray:
    return open_raster(RasterRef(path)).read(window).bands


def expected(folder: Path, name: str = "cog.tif", window: PixelWindow = WINDOW) -> np.ndarray:
    return read_pixels(str(folder / name), window.column, window.row, window.width, window.height)
