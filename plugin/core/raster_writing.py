"""Rasters written from pixels, in the place of the raster they were made from."""
from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import numpy as np
from osgeo import gdal, gdal_array

from . import messages
from .errors import RasterError
from .quiet import quiet
from .rasters import Mosaic

_COLOURS = (gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand)
_GEOTIFF = "GTiff"


def write_colours(
    path: str, like: Mosaic, kind: np.dtype, strips: Iterable[tuple[int, np.ndarray]], nodata: float | None = None
) -> None:
    """A raster of red, green and blue on another one's grid, from strips of it: first row, (3, rows, columns).

    The path's ending says the format. Raises RasterError when it can't be written.
    """
    grid = like.grid
    failure = RasterError(messages.RASTER_NOT_WRITTEN(path=path))
    with quiet():
        try:
            driver = gdal.GetDriverByName(_driver_name(path))
            options = ["TILED=YES", "COMPRESS=DEFLATE", "PHOTOMETRIC=RGB"] if driver.ShortName == _GEOTIFF else []
            number = gdal_array.NumericTypeCodeToGDALTypeCode(kind.type)
            dataset = driver.Create(path, grid.columns, grid.rows, 3, number, options=options)
        except RuntimeError:
            dataset = None
        if dataset is None:
            raise failure
        if like.has_place:
            dataset.SetGeoTransform((grid.left, grid.pixel_width, 0, grid.top, 0, -grid.pixel_height))
            dataset.SetProjection(like.wkt)
        for index, colour in enumerate(_COLOURS, 1):
            dataset.GetRasterBand(index).SetColorInterpretation(colour)
            if nodata is not None:
                dataset.GetRasterBand(index).SetNoDataValue(nodata)
        for row, pixels in strips:
            try:
                failed = dataset.WriteArray(np.ascontiguousarray(pixels), 0, row) != gdal.CE_None
            except RuntimeError:
                failed = True
            if failed:
                raise failure
        dataset.FlushCache()


def _driver_name(path: str) -> str:
    """The format that can be written pixel by pixel and whose files end so; GeoTIFF where there is none."""
    ending = Path(path).suffix.lower().lstrip(".")
    for index in range(gdal.GetDriverCount() if ending not in ("", "tif", "tiff") else 0):
        driver = gdal.GetDriver(index)
        endings = (driver.GetMetadataItem(gdal.DMD_EXTENSIONS) or "").split()
        if ending in endings and driver.GetMetadataItem(gdal.DCAP_RASTER) and driver.GetMetadataItem(gdal.DCAP_CREATE):
            return str(driver.ShortName)
    return _GEOTIFF
