"""The one writer of rasters: in the place of the raster they were made from, whole or not at all."""
from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from osgeo import gdal, gdal_array

from . import messages
from .atomic_files import replacing
from .errors import Message, RasterError
from .file_identity import files_beside, refuse_overwriting
from .gdal_calls import drop_from_memory, gdal_call, gdal_settings, gdal_silenced, gdal_writing
from .rasters import Raster

GEOTIFF = "GTiff"


@contextmanager
def whole_raster(path: str) -> Iterator[str]:
    """The place where GDAL is to write what becomes the raster ``path`` when the block ends.

    What it writes beside it comes along, and what an older raster had beside it (overviews, a mask) goes. An exception
    in the block leaves nothing, and an older raster as it was. Raises RasterError where no file can be.
    """
    if path.startswith("/vsi"):  # GDAL's own file systems know no renaming
        try:
            yield path
        except BaseException:
            drop_from_memory(path)
            raise
        return
    try:
        with replacing(Path(path), files_beside(os.path.realpath(path))) as unfinished:
            yield str(unfinished)
    except OSError:
        raise RasterError(messages.RASTER_NOT_WRITTEN(path=path)) from None


@dataclass(frozen=True)
class WrittenBands:
    """The bands of a raster that is to be written."""

    count: int
    data_type: np.dtype
    colours: bool = False
    """Whether they are red, green and blue."""
    nodata: float | None = None


@contextmanager
def raster_writer(path: str, like: Raster, bands: WrittenBands) -> Iterator[RasterWriter]:
    """Writes a GeoTIFF with the size and the place of another one, which is there when the block ends.

    An exception in the block leaves nothing, and an older file as it was. Raises RasterError where the raster can't be
    written, SettingsError where it would take the other one's place.
    """
    failure = messages.RASTER_NOT_WRITTEN(path=path)
    refuse_overwriting({os.path.basename(path): path}, like.ref.paths)
    with whole_raster(path) as unfinished:
        kind = gdal_array.NumericTypeCodeToGDALTypeCode(bands.data_type.type)
        options = ["TILED=YES", "COMPRESS=DEFLATE", "BIGTIFF=IF_SAFER", *["PHOTOMETRIC=RGB"] * bands.colours]
        dataset = gdal_call(lambda: gdal.GetDriverByName(GEOTIFF).Create(
            unfinished, like.columns, like.rows, bands.count, kind, options
        ), failure)  # fmt: skip
        if like.geotransform is not None:
            dataset.SetGeoTransform(like.geotransform)
        if like.wkt:
            dataset.SetProjection(like.wkt)
        if bands.nodata is not None:
            dataset.GetRasterBand(1).SetNoDataValue(bands.nodata)  # that of all bands
        writer = RasterWriter(dataset, failure)
        del dataset
        try:
            yield writer
            with gdal_writing(failure):  # what is still in memory
                writer.close()
        finally:
            with gdal_silenced(), suppress(RuntimeError):
                writer.close()


class RasterWriter:
    """Writes the pixels of ``raster_writer``, strip by strip."""

    def __init__(self, dataset: gdal.Dataset, failure: Message) -> None:
        self._dataset, self._failure = dataset, failure
        self._mask: gdal.Band | None = None

    def write(self, row: int, pixels: np.ndarray, invalid: np.ndarray | None = None) -> None:
        """(bands, rows, columns) from a row on; invalid pixels are masked. Raises RasterError when the disk is full."""
        with gdal_writing(self._failure):
            self._dataset.WriteArray(np.ascontiguousarray(pixels), 0, row)
            if invalid is None:
                return
            if self._mask is None:
                # Beside it: inside, as GDAL 3.13 would, it could not be added to what is already written.
                with gdal_settings(GDAL_TIFF_INTERNAL_MASK="NO"):
                    self._dataset.CreateMaskBand(gdal.GMF_PER_DATASET)
                self._mask = self._dataset.GetRasterBand(1).GetMaskBand()
                self._mask.Fill(255)
            self._mask.WriteArray(np.where(invalid, 0, 255).astype(np.uint8), 0, row)

    def close(self) -> None:
        """Write what is still in memory, once."""
        dataset, self._mask, self._dataset = self._dataset, None, None
        if dataset is not None:
            dataset.FlushCache()
