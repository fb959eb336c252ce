"""Pixels as picture files. No QGIS."""
from __future__ import annotations

import numpy as np
from osgeo import gdal

from ...imagery.gdal_calls import gdal_silenced, taken_from_memory


def encoded(pixels: np.ndarray, driver: str, quality: int = 88) -> bytes:
    """The bytes of a picture file, PNG or JPEG, of (rows, columns) or (rows, columns, 3) uint8."""
    bands = np.moveaxis(np.atleast_3d(pixels), 2, 0)
    path = f"/vsimem/report-{id(pixels)}"
    with gdal_silenced():
        memory = gdal.GetDriverByName("MEM").Create("", bands.shape[2], bands.shape[1], len(bands), gdal.GDT_Byte)
        for i, band in enumerate(bands, 1):
            memory.GetRasterBand(i).WriteArray(np.ascontiguousarray(band))
        options = [f"QUALITY={quality}"] if driver == "JPEG" else []
        copy = gdal.GetDriverByName(driver).CreateCopy(path, memory, options=options)
        copy = None  # noqa: F841 - closing the dataset writes the file
        return taken_from_memory(path)
