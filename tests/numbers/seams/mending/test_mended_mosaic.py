"""Patches as files, and the mosaic below them, of any type that mosaics have."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.mending.mend_run import patch_file
from seam_inspector.plugin.seams.measure.mending.mending import write_mended

from tests.numbers.synthetic import write_raster

WINDOW = PixelWindow(16, 8, 40, 24)
PLACE = np.s_[:, 8:32, 16:56]


@pytest.mark.parametrize("bands", [1, 2, 3, 4])
@pytest.mark.parametrize("dtype", [np.uint8, np.int16, np.uint16, np.uint32, np.float32])
def test_patches_lie_above_the_mosaic_where_they_are_opaque(dtype: type, bands: int, tmp_path: Path) -> None:
    below = (np.arange(bands * 64 * 96).reshape(bands, 64, 96) % 200 + 20).astype(dtype)
    mosaic = describe_mosaic(RasterRef(write_raster(tmp_path / "mosaic.tif", below)))
    positions = np.arange(bands) if len(mosaic.band_names) == bands else np.arange(len(mosaic.band_names))
    made, inside = (below[PLACE] + 30).astype(dtype)[positions], np.zeros((24, 40), bool)
    inside[5:20, 8:30] = True
    path = str(tmp_path / "patch.tif")
    patch_file(mosaic, WINDOW, made, inside).tofile(path)
    expected = below.copy()
    expected[PLACE][positions] = np.where(inside, made, below[PLACE][positions])
    mended = str(tmp_path / "mended.vrt")
    write_mended(mended, mosaic, {path: WINDOW})
    np.testing.assert_array_equal(gdal.Open(mended).ReadAsArray().reshape(below.shape), expected)
