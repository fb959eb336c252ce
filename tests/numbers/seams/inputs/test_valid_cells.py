"""Where rasters have pixels, held against all of their pixels as GDAL reads them."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.imagery.reference_systems import extent_on
from seam_inspector.plugin.seams.measure.inputs.valid_cells import CellGrid, ValidCells, valid_cells
from seam_inspector.plugin.seams.measure.window.inspection import inspect_window, make_block, window_request
from seam_inspector.plugin.seams.measure.window.window_request import InspectionSettings

from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import ORIGIN, orthoimage

WINDOWS = [PixelWindow(64 * column, 64 * row, 128, 128) for column in range(7) for row in range(7)]


@pytest.fixture
def mosaic(make_raster: MakeRaster) -> Raster:
    return describe_mosaic(RasterRef(make_raster("mosaic.tif", orthoimage((512, 512)))))


@pytest.fixture
def hole() -> np.ndarray:
    """(rows, columns) bool of 400 x 400: a slanting edge and a hole."""
    row, column = np.indices((400, 400))
    valid = row + 0.5 * column > 120
    valid[200:260, 150:300] = False
    return valid


def cells_of(path: str, mosaic: Raster) -> ValidCells:
    source = OpenRaster(RasterRef(path))
    raster = source.raster
    return valid_cells(source, extent_on(raster.extent, raster.wkt, mosaic.wkt), mosaic)


def shares(cells: ValidCells, mosaic: Raster) -> np.ndarray:
    grid = CellGrid.of(mosaic.grid)
    return np.array([cells.share(grid.cells(window)) for window in WINDOWS])


def true_shares(valid: np.ndarray, column: int, row: int) -> np.ndarray:
    whole = np.zeros((512, 512), bool)
    whole[row : row + len(valid), column : column + valid.shape[1]] = valid
    return np.array([
        whole[one.row : one.row + one.height, one.column : one.column + one.width].mean() for one in WINDOWS
    ])


@pytest.mark.parametrize("kind", ["nodata", "mask", "alpha", "degrees", "float"])
def test_all_ways_to_say_that_a_pixel_is_none(
    make_raster: MakeRaster, mosaic: Raster, hole: np.ndarray, tmp_path: Path, kind: str
) -> None:
    pixels, origin = orthoimage((400, 400)), (ORIGIN[0] + 4.0, ORIGIN[1] - 2.4)
    pixels = np.where(hole, np.maximum(pixels, 1), 0).astype(np.uint8)
    if kind == "mask":
        path = make_raster("source.tif", pixels, origin=origin, valid=hole)
    elif kind == "float":
        path = make_raster("source.tif", np.where(hole, pixels, np.nan).astype(np.float32), origin=origin)
    else:
        path = make_raster("source.tif", pixels, origin=origin, nodata=0)
    if kind == "alpha":
        path = gdal.Warp(str(tmp_path / "alpha.tif"), path, dstAlpha=True).GetDescription()
    elif kind == "degrees":
        path = gdal.Warp(str(tmp_path / "degrees.tif"), path, dstSRS="EPSG:4326", dstNodata=0).GetDescription()
    assert shares(cells_of(path, mosaic), mosaic) == pytest.approx(true_shares(hole, 40, 24), abs=0.035)


def test_a_raster_that_says_of_no_pixel_that_it_is_none_is_not_read(
    make_raster: MakeRaster, mosaic: Raster, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = make_raster("source.tif", orthoimage((200, 200)), origin=(ORIGIN[0] - 5.0, ORIGIN[1]))
    monkeypatch.setattr(OpenRaster, "read", lambda *_: pytest.fail("read"))
    expected = true_shares(np.ones((200, 150), bool), 0, 0)
    assert shares(cells_of(path, mosaic), mosaic) == pytest.approx(expected, abs=0.02)


@pytest.mark.release
def test_what_is_promised_on_brighton_takes_part(data_folder: Path) -> None:
    folder = data_folder / "seams" / "brighton"
    if not folder.is_dir():
        pytest.skip(f"no real data at {folder}")
    raster = describe_mosaic(RasterRef(str(folder / "mosaic_feather0p4m.tif")))
    block, _ = make_block(raster, [RasterRef(str(path)) for path in sorted(folder.glob("DJI*.tif"))])
    grid = CellGrid.of(raster.grid)
    of_mosaic = valid_cells(OpenRaster(raster.ref), raster.extent, raster)
    known = [valid_cells(OpenRaster(source.ref), source.extent, raster) for source in block.sources]
    rng, promised, measured = np.random.default_rng(3), [], []
    for column, row in rng.integers(0, (raster.columns - 256, raster.rows - 256), (12, 2)).tolist():
        window = PixelWindow(column, row, 256, 256)
        result = inspect_window(window_request(block, 1, raster.grid.window_extent(window), InspectionSettings()))
        asked = grid.cells(window)
        exact = OpenRaster(raster.ref).read(window).valid.mean()
        if 0.995 < exact < 0.9995:  # what samples can't tell
            continue
        is_whole = of_mosaic.share(asked) >= 0.999
        promised.append(sum(one.share(asked) >= 0.005 for one in known) if is_whole else 0)
        measured.append(result.source_count)
    assert max(measured) > 1
    assert min(measured) == 0
    assert promised == pytest.approx(measured, abs=1)
