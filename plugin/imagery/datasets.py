"""The one place that opens rasters: references, GDAL calls that fail with a sentence, and what is valid in them.

A raster is named by a plain ``RasterRef``; every read opens its own dataset, so references can cross
threads and processes, and a file that changes on disk is read as it is now.
"""
from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import Any, Callable

import numpy as np
from osgeo import gdal

from . import messages
from .band_roles import BandRoles, band_roles
from .errors import RasterError
from .gdal_messages import gdal_silenced
from .message import Message

GeoTransform = tuple[float, float, float, float, float, float]


@dataclass(frozen=True)
class RasterRef:
    """Where a raster is, in plain data."""

    path: str
    """What GDAL opens."""
    wkt: str = ""
    """Reference system to assume where the file itself names none."""

    @property
    def name(self) -> str:
        """File name without its folder."""
        return os.path.basename(self.path) or self.path


def open_dataset(ref: RasterRef) -> gdal.Dataset:
    """The dataset itself. Raises RasterError when it can't be opened."""
    there = ref.path.startswith("/vsi") or ":" in ref.path or os.path.exists(ref.path)
    failure = messages.NOT_A_RASTER(name=ref.name) if there else messages.NOT_FOUND(path=ref.path)
    return gdal_call(lambda: gdal.OpenEx(ref.path, gdal.OF_RASTER | gdal.OF_READONLY), ref, failure)


def gdal_call(call: Callable[[], Any], ref: RasterRef, failure: Message | None = None) -> Any:
    """What a GDAL call returns; RasterError when it fails, whether or not GDAL's exceptions are on."""
    with gdal_silenced():
        try:
            result = call()
        except RuntimeError:
            result = None
    if result is None:
        raise RasterError(failure or messages.NOT_READABLE(name=ref.name))
    return result


def drop_from_memory(path: str) -> None:
    """Remove a file of /vsimem and what GDAL wrote beside it; removing what is not there raises in GDAL 3.10."""
    for name in (path, path + ".aux.xml"):
        if gdal.VSIStatL(name) is not None:
            gdal.Unlink(name)


def check_bands(dataset: gdal.Dataset, ref: RasterRef) -> None:
    """Raise RasterError for a dataset without bands or of complex values."""
    if dataset.RasterCount == 0:
        raise RasterError(messages.NO_BANDS(name=ref.name))
    if any(gdal.DataTypeIsComplex(dataset.GetRasterBand(i + 1).DataType) for i in range(dataset.RasterCount)):
        raise RasterError(messages.COMPLEX_VALUES(name=ref.name))


def split_bands(
    dataset: gdal.Dataset, data: np.ndarray, inside: tuple[int, int, int, int], ref: RasterRef
) -> tuple[np.ndarray, np.ndarray | None]:
    """All bands of a dataset into those that are measured and a mask of invalid pixels (None: all are valid)."""
    roles = band_roles(dataset)
    in_order = roles.indices == tuple(range(len(data)))
    bands = data if in_order else data[list(roles.indices)]
    invalid = _nodata_mask(dataset, bands, roles)
    masks = []
    if roles.alpha is not None:
        masks.append(data[roles.alpha] == 0)
    first = dataset.GetRasterBand(1)
    mask_flags = gdal_call(first.GetMaskFlags, ref)
    if mask_flags & (gdal.GMF_PER_DATASET | gdal.GMF_ALPHA) == gdal.GMF_PER_DATASET:
        rows, columns = data.shape[1:]
        mask_band = first.GetMaskBand()
        masks.append(gdal_call(lambda: mask_band.ReadAsArray(*inside, buf_xsize=columns, buf_ysize=rows), ref) == 0)
    if bands.dtype.kind == "f":
        masks.append(~np.isfinite(bands).all(axis=0))
    if roles.palette is not None:
        indices = np.minimum(bands[0], len(roles.palette) - 1)
        masks.append(roles.palette[indices, 3] == 0)
        bands = np.moveaxis(roles.palette[indices, :3], -1, 0)
    for mask in masks:
        if mask.any():
            invalid = mask if invalid is None else invalid | mask
    return bands, invalid


def _nodata_mask(dataset: gdal.Dataset, bands: np.ndarray, roles: BandRoles) -> np.ndarray | None:
    """Pixels all of whose bands hold their nodata value, or None where there are none."""
    invalid: np.ndarray | None = None
    for band, index in zip(bands, roles.indices):
        nodata = dataset.GetRasterBand(index + 1).GetNoDataValue()
        if nodata is None:
            return None
        with np.errstate(all="ignore"):
            value = np.array(nodata).astype(bands.dtype)
        if bands.dtype.kind != "f" and value != nodata:
            return None  # a value that the data type can't hold
        held = np.isnan(band) if math.isnan(nodata) else band == value
        invalid = held if invalid is None else invalid & held
        if not invalid.any():
            return None
    return invalid
