"""The one way to open a raster, and the one reader of its pixels with what is valid among them."""
from __future__ import annotations

import math
import os
import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property, partial, reduce
from typing import Any, Callable, NamedTuple, TypeVar

import numpy as np
from osgeo import gdal, gdal_array

from . import limits, messages
from .errors import Message, RasterError
from .gdal_calls import gdal_call, gdal_pixels, gdal_settings, gdal_silenced
from .gdal_paths import check_raster_path, is_there, open_dataset, remote_parts, with_parts, with_retries
from .grids import PixelWindow
from .limits import COLOURS
from .rasters import Raster, RasterRef


@dataclass(frozen=True)
class BandRoles:
    """How the bands of a dataset are to be used. Indices start at 0."""

    names: tuple[str, ...]
    indices: tuple[int, ...]
    alpha: int | None = None


def band_roles(dataset: gdal.Dataset) -> BandRoles:
    """Band roles from what bands are called, else from the colour interpretation.

    The first three of a raster of three bands or more are red, green and blue unless one of them says otherwise; beside
    red and green the first band without a name is near infrared.
    """
    # Photometric red, green and blue are often infrared, red and green, so the name of a band goes before.
    bands = [dataset.GetRasterBand(i + 1) for i in range(dataset.RasterCount)]
    colours = [gdal.GetColorInterpretationName(band.GetColorInterpretation()).lower() for band in bands]
    called = [{role for role in _ROLE.findall(band.GetDescription().lower()) if role} for band in bands]
    colours = [_ROLES[roles.pop()] if len(roles) == 1 else colour for roles, colour in zip(called, colours)]
    alpha = colours.index("alpha") if "alpha" in colours else None
    measured = [i for i in range(len(colours)) if i != alpha]
    named = {colour: i for i, colour in reversed(list(enumerate(colours))) if colour in (*COLOURS, "nir")}
    said = {i: role for role, i in named.items()}
    by_order = dict(zip(COLOURS, measured))
    if len(by_order) == len(COLOURS) and all(said.get(i, role) == role for role, i in by_order.items()):
        named = {**by_order, **named}
    if named.keys() >= {"red", "green"} and "nir" not in named:
        unnamed = [i for i in measured if i not in named.values()]
        if unnamed:
            named["nir"] = unnamed[0]
    order = [named[role] for role in (*COLOURS, "nir") if role in named]
    order += [i for i in measured if i not in order]
    roles = {i: role for role, i in named.items()}
    return BandRoles(tuple(roles.get(i, f"band_{i + 1}") for i in order), tuple(order), alpha)


_ROLES = {**dict(zip(COLOURS, COLOURS)), "nir": "nir", "infrared": "nir"}
_ROLE = re.compile(rf"(?<![a-z])(?:red[ _-]?edge|({'|'.join(_ROLES)}))(?![a-z])")
"""The word for a role in what a band is called, as in Red (band 4) and NIR_842; the red edge is none."""
LOSSY = ("JPEG", "JP2", "JPEG2000", "WEBP", "JXL", "ECW", "MRSID", "LERC")
"""Compressions that are lossy unless the file says otherwise."""
_TURNED = "TURNED", "YES", "SEAM_INSPECTOR"  # what is noted of a raster whose rows were turned over
CORNER_PX = 16
"""Side of the squares at an image's corners, one of which is wholly of the pads around it."""
_MOST_OF_A_TILE = 1 << 24  # pixels that are worked on at once: what is made of them takes several times their room


Fetched = TypeVar("Fetched")


class PixelBlock(NamedTuple):
    """Pixels and which of them are no measurements."""

    bands: np.ndarray
    """(bands, rows, columns) of the measured bands as they are."""
    invalid: np.ndarray | None
    """(rows, columns) bool; None where all are valid."""

    @property
    def valid(self) -> np.ndarray:
        """(rows, columns) bool."""
        return np.ones(self.bands.shape[1:], bool) if self.invalid is None else ~self.invalid

    @property
    def invalid_share(self) -> float:
        """Share of the pixels that are no measurements, 0 to 1."""
        return 0.0 if self.invalid is None else float(self.invalid.mean())


class OpenRaster:
    """A raster that stays open as long as this lives, or until a ``with`` block of it ends; reading opens it again.
    Meant for one thread: what crosses threads is a ``RasterRef``.

    All reads stay inside the raster, and raise RasterError when they fail. What comes over the network is asked for
    again, in a raster that is opened anew, before that.
    """

    def __init__(
        self, ref: RasterRef | str | os.PathLike[str], dataset: gdal.Dataset | None = None,
        complex_values: bool = False,
    ) -> None:
        """``ref``: where it is, or its path; ``dataset``: what was made of the raster in memory, instead of its file;
        ``complex_values`` may be welcome.

        Raises RasterError when it can't be opened or used.
        """
        ref = ref if isinstance(ref, RasterRef) else RasterRef(os.fspath(ref))
        self.ref, self.is_broken = ref, False
        self._is_remote = bool(remote_parts(ref.path))  # looked at once: a VRT may name thousands of files
        self.dataset: Any = dataset
        """For what only GDAL does, such as warping."""
        opened = self.fetched(lambda dataset: dataset)
        if opened.RasterCount == 0:
            raise RasterError(messages.NO_BANDS(name=ref.name))
        check_amounts(opened, ref.name)
        kinds = [opened.GetRasterBand(number).DataType for number in range(1, opened.RasterCount + 1)]
        if not complex_values and any(map(gdal.DataTypeIsComplex, kinds)):
            raise RasterError(messages.COMPLEX_VALUES(name=ref.name))
        self.columns, self.rows = opened.RasterXSize, opened.RasterYSize
        self.roles = band_roles(opened)

    def __enter__(self) -> OpenRaster:
        return self

    def __exit__(self, *error: object) -> None:
        self.dataset = None

    def _open(self) -> None:
        ref = self.ref
        failure = messages.NOT_A_RASTER(name=ref.name) if is_there(ref.path) else messages.NOT_FOUND(path=ref.path)
        if os.path.exists(ref.path) and not os.access(ref.path, os.R_OK):
            failure = messages.NOT_PERMITTED(name=ref.name)
        for path in ref.paths:
            check_raster_path(path, ref.name)
        self.dataset = gdal_call(lambda: _opened(ref), failure)

    def fetched(self, call: Callable[[gdal.Dataset], Fetched]) -> Fetched:
        """What a call finds in the dataset; what comes over the network has an end, and is asked for again."""

        def attempt(again: bool) -> Fetched:
            if again or self.dataset is None:
                self._open()
            return call(self.dataset)

        try:
            return with_retries(self.ref.path, self.ref.name, attempt) if self._is_remote else attempt(again=False)
        except RasterError:
            self.is_broken = True
            raise

    @cached_property
    def raster(self) -> Raster:
        """What the raster is."""
        band, transform = self.dataset.GetRasterBand(1), self.dataset.GetGeoTransform(can_return_null=True)
        stored = self.dataset.GetMetadata("IMAGE_STRUCTURE")
        is_lossless = stored.get("COMPRESSION_REVERSIBILITY", "").startswith("LOSSLESS")
        is_lossy = not is_lossless and any(word in stored.get("COMPRESSION", "").upper() for word in LOSSY)
        back = transform and gdal.InvGeoTransform(transform)
        if back is None or not all(map(math.isfinite, (*transform, *back))):
            transform = None  # its pixels would lie on one line, or nowhere
        kind = np.dtype(gdal_array.GDALTypeCodeToNumericTypeCode(band.DataType))
        bits = band.GetMetadataItem("NBITS", "IMAGE_STRUCTURE")
        return Raster(
            self.ref, self.columns, self.rows,
            transform and tuple(transform), self.dataset.GetProjection() or "",
            self.roles.names, str(kind), int(bits) if bits else None, is_lossy, self.roles.indices,
            self.dataset.GetMetadataItem(_TURNED[0], _TURNED[2]) is not None,
        )

    @property
    def nodata(self) -> float | None:
        """The first band's nodata value; None without one."""
        return self.dataset.GetRasterBand(1).GetNoDataValue()

    @property
    def is_all_valid(self) -> bool:
        """Whether the file says nothing of pixels that are no measurements."""
        return self._mask_flags == gdal.GMF_ALL_VALID and self.ref.nodata is None

    @cached_property
    def corners(self) -> list[np.ndarray]:
        """Squares of ``CORNER_PX`` at the corners, (bands, rows, columns) each. Raises RasterError for damaged ones."""
        side = min(CORNER_PX, self.columns, self.rows)
        return [self.read(PixelWindow(column, row, side, side)).bands
                for column in {0, self.columns - side} for row in {0, self.rows - side}]

    @cached_property
    def _mask_flags(self) -> int:
        """GDAL's. Raises RasterError where the mask is damaged."""
        failure = messages.MASK_NOT_READABLE(name=self.ref.name)
        return self.fetched(
            lambda dataset: int(gdal_pixels(dataset.GetRasterBand(1).GetMaskFlags, failure, lambda why: failure))
        )

    def band_index(self, number: int) -> int:
        """Place of a band of the file, from 1 on, among those that are measured.

        Raises RasterError for a band that is not there or holds no values to measure.
        """
        measured = self.roles.indices
        if number - 1 not in measured:
            raise RasterError(messages.BAND_NOT_THERE(name=self.ref.name, band=number, count=len(measured)))
        return measured.index(number - 1)

    def read(self, window: PixelWindow, size: tuple[int, int] | None = None, averaged: bool = False) -> PixelBlock:
        """The pixels of a window, or ``size`` (columns, rows) of them, the nearest or means, from overviews if any."""
        limits.check_type("window", window, PixelWindow)
        if 0 in (window.width, window.height) or window.cut_to(self.columns, self.rows) != window:
            raise RasterError(messages.NOT_COVERED(name=self.ref.name))
        inside = (window.column, window.row, window.width, window.height)
        columns, rows = size or inside[2:]
        part = {"buf_xsize": columns, "buf_ysize": rows}
        how = gdal.GRIORA_Average if averaged else gdal.GRIORA_NearestNeighbour
        stored = gdal.GetDataTypeSize(self.dataset.GetRasterBand(1).DataType) // 8 * self.dataset.RasterCount
        if columns * rows * stored > limits.MOST_READ_BYTES:
            raise RasterError(messages.TOO_MUCH_AT_ONCE(name=self.ref.name, width=columns, height=rows))
        data = self._pixels(lambda dataset: dataset.ReadAsArray(*inside, **part, resample_alg=how), window, size)
        mask = None
        if self._mask_flags & (gdal.GMF_PER_DATASET | gdal.GMF_ALPHA) == gdal.GMF_PER_DATASET:
            mask = self._pixels(
                lambda dataset: dataset.GetRasterBand(1).GetMaskBand().ReadAsArray(*inside, **part), window, size
            )
        return self._block(data.reshape(-1, rows, columns), mask)

    def _pixels(
        self, call: Callable[[gdal.Dataset], Any], window: PixelWindow, size: tuple[int, int] | None
    ) -> np.ndarray:
        """What a call reads of a window."""
        failure = messages.NOT_READABLE(name=self.ref.name)

        def attempt(dataset: gdal.Dataset) -> np.ndarray:
            return np.asarray(gdal_pixels(lambda: call(dataset), failure, partial(damaged, self.ref.name, window)))

        try:
            return self.fetched(attempt)
        except RasterError:
            self.dataset.FlushCache()  # else the next one would get the made up pixels without a warning
            for part in with_parts(self.ref.path):
                if part != self.ref.path and not is_there(part):
                    raise RasterError(messages.PART_NOT_FOUND(name=self.ref.name, part=part)) from None
            if size is None:
                raise
        # Of a JPEG in TIFF libjpeg decodes a half to an eighth of a tile alone for reduced pixels, where it takes sound
        # tiles for cut off now and then.
        with gdal_settings(GTIFF_IMPLICIT_JPEG_OVR="NO"):
            return self.fetched(lambda _: attempt(gdal_call(lambda: _opened(self.ref), failure)))

    def thinned(self, window: PixelWindow, step: int) -> PixelBlock:
        """Every so many-th pixel of a window along both sides."""
        return self.read(window, (max(1, window.width // step), max(1, window.height // step)))

    def is_valid(self, window: PixelWindow) -> bool:
        """Whether enough pixels of a window are valid: by every fourth pixel where that tells for sure, else by all."""
        share = self.thinned(window, 4).invalid_share
        is_near = 0 < share <= 2 * limits.MAX_INVALID_SHARE
        return (self.read(window).invalid_share if is_near else share) <= limits.MAX_INVALID_SHARE

    def stored_share(self, window: PixelWindow) -> float:
        """Share of a window that the file has blocks for, 0 to 1, by its list of them; 1 where it has none. What it has
        no blocks for is read as nodata or 0."""
        shares = [1.0]
        for index in self.roles.indices:
            band = self.dataset.GetRasterBand(index + 1)
            with gdal_silenced(), suppress(RuntimeError):
                flags, share = band.GetDataCoverageStatus(window.column, window.row, window.width, window.height)
                if flags & gdal.GDAL_DATA_COVERAGE_STATUS_EMPTY:
                    shares.append(share / 100)
        return min(shares)

    def blocks(self, window: PixelWindow, most_pixels: int) -> Iterator[PixelWindow]:
        """Pieces that together are the window, row by row, each on whole tiles or strips of the file.

        They have about ``most_pixels`` pixels, or one tile or strip where that is larger, so that every one of the
        file is decoded once; rows of it where it is huge, which GDAL holds meanwhile.
        """
        tile_width, tile_height = self.dataset.GetRasterBand(1).GetBlockSize()
        tile_width = min(tile_width, self.columns)
        wide = min(max(most_pixels // (tile_width * tile_height), 1), -(-window.width // tile_width)) * tile_width
        high = max(most_pixels // (wide * tile_height), 1) * tile_height
        rows = max(max(_MOST_OF_A_TILE, most_pixels) // wide, 1)
        for top in range(-(window.row % high), window.height, high):
            for left in range(-(window.column % wide), window.width, wide):
                part = PixelWindow(left, top, wide, high).cut_to(window.width, window.height)
                part = part.moved_by(window.column, window.row)
                for start in range(0, part.height, rows):
                    yield replace(part, row=part.row + start, height=min(rows, part.height - start))

    def _block(self, data: np.ndarray, mask: np.ndarray | None) -> PixelBlock:
        """All bands into those that are measured and what is invalid in them; ``mask`` is 0 there."""
        roles = self.roles
        in_order = roles.indices == tuple(range(len(data)))
        bands = data if in_order else data[list(roles.indices)]
        masks = [self._nodata_mask(bands), None if mask is None else mask == 0]
        if self.ref.nodata is not None:
            masks.append(self._nodata_mask(bands, self.ref.nodata))
        if roles.alpha is not None:
            masks.append(data[roles.alpha] == 0)
        if bands.dtype.kind == "f" or bands.dtype.itemsize == 8:
            with np.errstate(invalid="ignore"):
                masks.append(~(np.abs(bands) <= limits.LARGEST_VALUE).all(axis=0))
        invalid = [mask for mask in masks if mask is not None and mask.any()]
        return PixelBlock(bands, reduce(np.logical_or, invalid) if invalid else None)

    def _nodata_mask(self, bands: np.ndarray, additional: float | None = None) -> np.ndarray | None:
        """Pixels all of whose bands hold their nodata value, or another one, or None where there are none."""
        invalid: np.ndarray | None = None
        for band, index in zip(bands, self.roles.indices):
            nodata = self.dataset.GetRasterBand(index + 1).GetNoDataValue() if additional is None else additional
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


def damaged(name: str, window: PixelWindow, why: str) -> Message:
    """What is said of a raster of which GDAL can't decode some pixels of a window, in GDAL's words."""
    right, bottom = window.column + window.width - 1, window.row + window.height - 1
    return messages.DAMAGED(name=name, left=window.column, right=right, top=window.row, bottom=bottom, why=why)


def _opened(ref: RasterRef) -> gdal.Dataset | None:
    """The dataset of all parts, a palette as its colours, rows that run north turned over; None where GDAL opens no
    first part."""
    if (first := open_dataset(ref.path)) is None:
        return None
    whole: gdal.Dataset = first
    with suppress(RuntimeError):  # Read now what lies beside it, without what is broken; else the next question fails.
        first.GetGeoTransform()
    left, width, skew_x, top, skew_y, height = first.GetGeoTransform()
    if ref.parts:
        pixel = {"xRes": width, "yRes": -height}
        whole = gdal.BuildVRT("", [*ref.paths[::-1]], resolution="user", outputBounds=ref.bounds, **pixel)
    if whole.RasterCount == 1 and whole.GetRasterBand(1).GetColorTable() is not None:
        whole = gdal.Translate("", whole, format="VRT", rgbExpand="rgba")
    if height > 0 == skew_x == skew_y and first.GetProjection():
        size = {"width": first.RasterXSize, "height": first.RasterYSize}
        bounds = left, top, left + width * first.RasterXSize, top + height * first.RasterYSize
        is_masked = whole.GetRasterBand(1).GetMaskFlags() == gdal.GMF_PER_DATASET
        whole = gdal.Warp("", whole, format="VRT", outputBounds=bounds, dstAlpha=is_masked, errorThreshold=0, **size)
        whole.SetMetadataItem(*_TURNED)
    if whole is not first:
        whole.SetMetadata(first.GetMetadata("IMAGE_STRUCTURE"), "IMAGE_STRUCTURE")
    return whole


def check_amounts(dataset: gdal.Dataset | None, name: str) -> None:
    """Raise RasterError for what a file of some kilobytes can declare and no memory can hold."""
    if dataset is None or not dataset.RasterCount:
        return
    columns, rows, band = dataset.RasterXSize, dataset.RasterYSize, dataset.GetRasterBand(1)
    width, height = band.GetBlockSize()
    block_bytes = width * height * dataset.RasterCount * gdal.GetDataTypeSize(band.DataType) // 8
    if columns * rows > limits.MOST_PIXELS or block_bytes > limits.MOST_BLOCK_BYTES:
        raise RasterError(messages.TOO_LARGE(name=name, columns=columns, rows=rows, width=width, height=height))


def describe(ref: RasterRef) -> Raster:
    """Open a raster that may lie anywhere and say what it is. Raises RasterError when it can't be opened or used."""
    return OpenRaster(ref).raster


def describe_north_up(ref: RasterRef) -> Raster:
    """Like ``describe``, for a raster that has to have a grid, on the map or on its own pixels."""
    raster = describe(ref)
    if not raster.is_north_up:
        raise RasterError(messages.NOT_NORTH_UP(name=ref.name))
    return raster


def describe_mosaic(ref: RasterRef) -> Raster:
    """Like ``describe``, for the raster whose grid the windows lie on: north-up and on the map."""
    return placed(describe_north_up(ref))


def check_readable(opened: OpenRaster) -> None:
    """Raise RasterError for a raster that opens though its pixels are gone, as those of a truncated file or of a VRT
    whose files were moved: not one of nine all over it can be read."""
    thirds = (1, 3, 5)
    places = [(opened.columns * x // 6, opened.rows * y // 6) for y in thirds for x in thirds]
    for column, row in places[:-1]:
        with suppress(RasterError):
            opened.read(PixelWindow(column, row, 1, 1))
            return
    opened.read(PixelWindow(*places[-1], 1, 1))


def placed(raster: Raster) -> Raster:
    """The raster itself. Raises RasterError when it has no place on the map."""
    if raster.geotransform is None:
        raise RasterError(messages.NOT_GEOREFERENCED(name=raster.ref.name))
    if not raster.wkt:
        raise RasterError(messages.NO_REFERENCE_SYSTEM(name=raster.ref.name))
    return raster
