"""Rasters written from pixels, in the place of the raster they were made from."""
from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from pathlib import Path

import numpy as np
from osgeo import gdal, gdal_array

from . import messages
from .datasets import RasterRef, gdal_call
from .errors import RasterError
from .gdal_messages import gdal_silenced
from .photos import Photo
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
    with gdal_silenced():
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


class RasterWriter:
    """A GeoTIFF on another raster's grid, written strip by strip. Used with ``with``, which closes it."""

    def __init__(self, path: str, like: Photo, dtype: np.dtype, bands: int) -> None:
        """Raises RasterError where no file can be."""
        self._ref = RasterRef(path)
        kind = gdal_array.NumericTypeCodeToGDALTypeCode(dtype.type)
        options = ["TILED=YES", "COMPRESS=DEFLATE", "BIGTIFF=IF_SAFER"]
        self._dataset = gdal_call(
            lambda: gdal.GetDriverByName("GTiff").Create(path, like.columns, like.rows, bands, kind, options),
            self._ref, messages.RASTER_NOT_WRITTEN(path=path),
        )
        if like.is_referenced:
            self._dataset.SetGeoTransform(like.geotransform)
        if like.wkt:
            self._dataset.SetProjection(like.wkt)
        self._mask: gdal.Band | None = None

    def __enter__(self) -> RasterWriter:
        return self

    def __exit__(self, *exception: object) -> None:
        with gdal_silenced():
            self._dataset.FlushCache()
        self._mask = self._dataset = None

    def write(self, row: int, pixels: np.ndarray, invalid: np.ndarray | None) -> None:
        """(bands, rows, columns) from a row on; invalid pixels are masked. Raises RasterError when the disk is full."""
        failure = messages.RASTER_NOT_WRITTEN(path=self._ref.path)
        for number, band in enumerate(pixels, 1):
            write = self._dataset.GetRasterBand(number).WriteArray
            if gdal_call(partial(write, band, 0, row), self._ref, failure) != 0:
                raise RasterError(failure)
        if invalid is None and self._mask is None:
            return
        if self._mask is None:
            self._dataset.CreateMaskBand(gdal.GMF_PER_DATASET)  # a file beside the TIFF
            self._mask = self._dataset.GetRasterBand(1).GetMaskBand()
            self._mask.Fill(255)
        if invalid is not None:
            self._mask.WriteArray(np.where(invalid, 0, 255).astype(np.uint8), 0, row)
