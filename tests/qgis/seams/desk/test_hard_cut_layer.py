"""The composite as a layer: the mosaic's own bands and pixels, but for those of the composite."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsRasterLayer
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.desk.map.hard_cut import looks_alike, write_composite
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings, WindowRequest

from tests.numbers.synthetic import orthoimage, write_raster

WINDOW = PixelWindow(64, 32, 128, 96)


@pytest.mark.parametrize("dtype", ["u1", "u2"])
def test_bands_lie_where_the_mosaic_has_them(tmp_path: Path, dtype: str, qgis_app: object) -> None:
    """A mosaic of blue, green, red and infrared, of which the sources have no infrared."""
    pixels = orthoimage((256, 512), 4).astype(dtype)
    path = tmp_path / "mosaic.tif"
    write_raster(path, pixels)
    dataset = gdal.Open(str(path), gdal.GA_Update)
    for number, colour in enumerate((gdal.GCI_BlueBand, gdal.GCI_GreenBand, gdal.GCI_RedBand, gdal.GCI_Undefined), 1):
        dataset.GetRasterBand(number).SetColorInterpretation(colour)
    dataset = None
    mosaic = describe_mosaic(RasterRef(str(path)))
    red, green, blue = (np.full((96, 128), value, dtype) for value in (210, 120, 30))
    composite = ("red", "green", "blue"), np.stack([red, green, blue])
    target = tmp_path / "composite.tif"
    write_composite(composite, WindowRequest(1, mosaic, (), WINDOW, InspectionSettings()), str(target))
    written = gdal.Open(str(target))
    result = written.ReadAsArray()
    assert result.dtype == np.dtype(dtype)
    assert [int(band.min()) for band in result[:3]] == [int(band.max()) for band in result[:3]] == [30, 120, 210]
    assert np.array_equal(result[3], pixels[3, 32:128, 64:192])
    left, _, _, top = mosaic.grid.window_extent(WINDOW)
    assert written.GetGeoTransform()[::3] == pytest.approx((left, top))
    assert looks_alike(QgsRasterLayer(str(target), "composite"), QgsRasterLayer(str(path), "mosaic"))
