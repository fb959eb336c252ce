"""The colours of surfaces that somebody knows to be grey, by which a cast is told.

What is grey in nature no image tells: bare soil under a clean light and grey asphalt under a warm one have the same
pixels. So areas come from the user; what may be grey is found only to be looked at (``uniform_areas.maybe_grey``).
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from osgeo import gdal, ogr

from ...imagery.gdal_calls import gdal_silenced
from ...imagery.grids import Grid, PixelWindow
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import ValueRange
from . import limits
from .uniform_areas import Areas, maybe_grey

_MOST_PIXELS = 1024 * 1024  # read at a time


@dataclass(frozen=True)
class GreyArea:
    """An area of which the user says that it is grey."""

    number: int
    """Of its feature in the layer."""
    wkb: bytes
    """A polygon in the image's reference system."""


@dataclass(frozen=True)
class GreyTone:
    """What an image shows of such an area."""

    number: int
    """As in ``GreyArea``."""
    pixels: int
    """Valid ones."""
    means: tuple[float, float, float]
    """Of red, green and blue, DN."""
    place: tuple[float, float]
    """The middle of its pixels, in the image's reference system."""


@dataclass(frozen=True)
class ColourBalance:
    """How far the colours of grey areas are from grey."""

    value: float
    """Largest difference between the means of red, green and blue over all areas, each counted once, as a share of
    the range."""
    means: tuple[float, float, float]
    """Those means, DN."""
    tones: tuple[GreyTone, ...]
    """Of the areas that counted."""
    worst: GreyTone
    """The area whose bands differ most."""
    worst_value: float
    """By how much, as a share of the range."""


@dataclass(frozen=True, eq=False)
class MaybeGrey:
    """What may be grey, for somebody to look at."""

    corners: np.ndarray
    """(n, 2): columns and rows of the upper left pixels of areas of 16 x 16."""
    means: np.ndarray
    """(n, 3) of red, green and blue, DN."""
    spreads: np.ndarray
    """(n,): largest difference between the bands, as a share of the range."""
    share: float
    """Of all areas that were looked at."""

    @property
    def difference(self) -> float:
        """The largest difference between the bands over all of them, as a share of the range: their median."""
        return float(np.median(self.spreads))

    @property
    def middle(self) -> tuple[float, float]:
        """Column and row of the middle of the area that is nearest to the middle of all."""
        centres = self.corners + limits.AREA_PX / 2
        nearest = np.argmin(np.hypot(*(centres - np.median(centres, axis=0)).T))
        column, row = centres[nearest]
        return float(column), float(row)


def grey_tones(source: OpenRaster, window: PixelWindow, areas: Sequence[GreyArea]) -> tuple[GreyTone, ...]:
    """The colours of the areas that have valid pixels in a window of a north-up raster with red, green and blue.

    Raises RasterError when the raster can't be read.
    """
    found = (_tone(source, window, area) for area in areas)
    return tuple(tone for tone in found if tone is not None)


def _tone(source: OpenRaster, window: PixelWindow, area: GreyArea) -> GreyTone | None:
    grid = source.raster.grid
    geometry = ogr.CreateGeometryFromWkb(area.wkb)
    xmin, xmax, ymin, ymax = geometry.GetEnvelope()
    edges = grid.column_at(xmin), grid.column_at(xmax), grid.row_at(ymax), grid.row_at(ymin)
    if not all(map(math.isfinite, edges)):
        return None
    first, last = (window.column, window.row), (window.column + window.width, window.row + window.height)
    left, right = (min(max(math.floor(edge), first[0]), last[0]) for edge in (edges[0], edges[1] + 1))
    top, bottom = (min(max(math.floor(edge), first[1]), last[1]) for edge in (edges[2], edges[3] + 1))
    if left >= right or top >= bottom:
        return None
    count, sums, places = 0, np.zeros(3), np.zeros(2)
    for block in source.blocks(PixelWindow(left, top, right - left, bottom - top), _MOST_PIXELS):
        inside = _inside(geometry, grid, block)
        if not inside.any():
            continue
        bands, invalid = source.read(block)
        if invalid is not None:
            inside &= ~invalid
        rows, columns = np.nonzero(inside)
        count += len(rows)
        sums += bands[:3, rows, columns].sum(axis=1, dtype=np.float64)
        places += (block.column + columns + 0.5).sum(), (block.row + rows + 0.5).sum()
    if not count:
        return None
    red, green, blue = (sums / count).tolist()
    column, row = places / count
    return GreyTone(area.number, count, (red, green, blue), grid.to_map(column, row))


def _inside(geometry: ogr.Geometry, grid: Grid, block: PixelWindow) -> np.ndarray:
    """(rows, columns) bool: the pixels whose middles lie in a polygon."""
    xmin, _, _, ymax = grid.window_extent(block)
    with gdal_silenced():
        target = gdal.GetDriverByName("MEM").Create("", block.width, block.height, 1, gdal.GDT_Byte)
        target.SetGeoTransform((xmin, grid.pixel_width, 0, ymax, 0, -grid.pixel_height))
        vector = ogr.GetDriverByName("Memory").CreateDataSource("")
        layer = vector.CreateLayer("area")
        feature = ogr.Feature(layer.GetLayerDefn())
        feature.SetGeometry(geometry)
        layer.CreateFeature(feature)
        gdal.RasterizeLayer(target, [1], layer, burn_values=[1])
        return np.asarray(target.ReadAsArray() == 1)


def colour_balance(tones: Sequence[GreyTone], available: ValueRange) -> ColourBalance | None:
    """The colour balance by grey areas; None where too few pixels of them are neither too dark nor too bright."""
    low, high = available
    least, most = (low + share * (high - low) for share in limits.GREY_TONES)
    usable = tuple(tone for tone in tones if least <= min(tone.means) and max(tone.means) <= most)
    if sum(tone.pixels for tone in usable) < limits.MIN_GREY_PIXELS:
        return None
    spreads = [(max(tone.means) - min(tone.means)) / (high - low) for tone in usable]
    red, green, blue = np.mean([tone.means for tone in usable], axis=0).tolist()
    value = (max(red, green, blue) - min(red, green, blue)) / (high - low)
    worst = int(np.argmax(spreads))
    return ColourBalance(value, (red, green, blue), usable, usable[worst], spreads[worst])


def find_maybe_grey(areas: Areas, bands: Sequence[int], available: ValueRange) -> MaybeGrey | None:
    """The areas that may be grey; None where there is none."""
    chosen = maybe_grey(areas, bands, available)
    if not chosen.any():
        return None
    means = areas.means[chosen][:, list(bands)]
    spreads = np.ptp(means, axis=1) / (available[1] - available[0])
    return MaybeGrey(areas.corners[chosen], means, spreads, float(chosen.mean()))
