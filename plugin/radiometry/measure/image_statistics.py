"""Histograms and sampled areas of a raster, streamed in blocks: memory is flat, the time close to the bare read's."""
from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Callable, Union

import numpy as np

from ...imagery import limits as imagery_limits
from ...imagery.errors import Message
from ...imagery.grids import PixelWindow
from ...imagery.open_raster import OpenRaster, PixelBlock
from ...imagery.raster_pool import reading_threads
from ...imagery.rasters import BIT_DEPTHS, Raster, ValueRange
from . import limits, messages
from .areas import Areas, joined, sample_areas
from .rules import LUMINOSITY


def luminosity(bands: np.ndarray) -> np.ndarray:
    """0.299 R + 0.587 G + 0.114 B of (bands, ...), whose first three are red, green and blue; a single band as it is.

    Whole numbers are rounded to whole numbers of the same type: their histogram has the same bins.
    """
    if len(bands) == 1:
        return np.asarray(bands[0])
    is_whole, size = bands.dtype.kind in "iu", bands.dtype.itemsize
    kind = np.float32 if size == 1 or bands.dtype == np.float32 else np.float64  # 24 bits tell 8 of them to 1e-5
    red, green, blue = (kind(weight) for weight in imagery_limits.LUMINANCE_WEIGHTS)
    mixed = bands[0] * red
    mixed += bands[1] * green
    mixed += bands[2] * blue
    if not is_whole:
        return np.asarray(mixed, bands.dtype)
    if bands.dtype.kind == "i":
        return np.rint(mixed).astype(bands.dtype)
    mixed += kind(0.5)
    return mixed.astype(bands.dtype)  # cuts off, so this rounds, in less time


def figure_bands(image: Raster, bands: np.ndarray, names: tuple[str, ...]) -> np.ndarray:
    """(names, ...): the bands of an image, or its luminosity, by their names."""
    known = image.band_names
    if names == known:
        return bands
    return np.stack([luminosity(bands) if name == LUMINOSITY else bands[known.index(name)] for name in names])


MAX_AREAS = 8192  # looked at, spread over the raster: memory is flat and the time a small part of the read's

_BINS = 65536  # of 16 bit values one each; of values without steps of their own, over the range that was given
_SHOWN_BINS = 256


@dataclass(frozen=True, eq=False)
class Histogram:
    """The number of pixels with each value of a band."""

    values: np.ndarray  # (bins,) float64: the value of each bin, rising; the middle of the bin for values without steps
    counts: np.ndarray  # (bins,) int64, valid pixels only

    @property
    def pixels(self) -> int:
        return int(self.counts.sum())

    @property
    def mean(self) -> float:
        """Mean of all valid pixels; NaN where there are none."""
        return float(self.counts @ self.values / self.pixels) if self.pixels else math.nan

    @property
    def deviation(self) -> float:
        return math.sqrt(self.counts @ (self.values - self.mean) ** 2 / self.pixels) if self.pixels else math.nan

    @property
    def largest(self) -> float:
        """The largest value that occurs; NaN where there is none."""
        return float(self.values[np.flatnonzero(self.counts)[-1]]) if self.pixels else math.nan

    def share(self, least: float = -math.inf, most: float = math.inf) -> float:
        """Share of the pixels with values from ``least`` to ``most``, both inclusive."""
        inside = (self.values >= least) & (self.values <= most)
        return float(self.counts[inside].sum()) / self.pixels

    @property
    def has_steps(self) -> bool:
        """Whether each bin is one whole number."""
        return bool(self.values[1] - self.values[0] == 1)

    def trimmed(self) -> Histogram:
        """Without the empty bins above the largest value: to be kept while other images are looked at."""
        end = max(int(np.flatnonzero(self.counts)[-1]) + 1, 2) if self.pixels else 2
        return Histogram(self.values[:end].copy(), self.counts[:end].copy())

    def binned(self, available: ValueRange) -> tuple[np.ndarray, np.ndarray]:
        """Counts in up to 256 equal bins over a range, and their middles; values beyond it are in the outer bins."""
        low, high = available
        extent = high - low + self.has_steps
        bins = min(_SHOWN_BINS, int(extent)) if self.has_steps else _SHOWN_BINS
        places = np.clip(np.floor((self.values - low) * (bins / extent)), 0, bins - 1).astype(np.int64)
        middles = low + (np.arange(bins) + 0.5) * (extent / bins) - self.has_steps / 2
        return np.bincount(places, self.counts, bins).astype(np.int64), middles


def can_count(image: Raster, given: ValueRange | None) -> bool:
    """Whether the values can be counted: those of 8 and 16 bit always, others over a given range."""
    dtype = np.dtype(image.data_type)
    return given is not None or (dtype.itemsize <= 2 and dtype.kind in "iu")


def stream_statistics(
    source: OpenRaster, window: PixelWindow, counted: tuple[str, ...], looked_at: tuple[str, ...],
    given: ValueRange | None = None, progress: Callable[[float], bool] = lambda share: True,
) -> tuple[dict[str, Histogram], Areas] | None:
    """Histograms and areas of a window of a raster, read block by block, every block once and one ahead.

    ``counted``: names of the bands, and ``luminosity``, that have histograms, at least one. ``looked_at``: the bands of
    areas of 16 x 16 px, spread over the window, those with an invalid pixel left out. ``given``: the range (DN) over
    which values other than 8 and 16 bit are counted. ``progress`` gets the share that is done after each block, and
    ends the work by returning False: then there is no result.

    Raises RasterError when the pixels can't be read.
    """
    image, done, pixels = source.raster, 0, window.width * window.height
    step = max(limits.AREA_PX, math.ceil(math.sqrt(pixels / MAX_AREAS)))  # px; areas lie side by side in small windows
    counts: dict[str, np.ndarray] = {}
    areas: list[Areas] = []
    for block, (bands, invalid) in _read_ahead(source, source.blocks(window, limits.MAX_BLOCK_PIXELS)):
        for name in counted:
            band = luminosity(bands) if name == LUMINOSITY else bands[image.band_names.index(name)]
            occurring = _counts(band, given) - (0 if invalid is None else _counts(band[invalid], given))
            counts[name] = counts.get(name, 0) + occurring
        areas.append(sample_areas(figure_bands(image, bands, looked_at), invalid, step, (block.column, block.row)))
        done += block.width * block.height
        if not progress(done / pixels):
            break
    if done < pixels:
        return None
    values = _values(np.dtype(image.data_type), given)
    return {name: Histogram(values, total) for name, total in counts.items()}, joined(areas)


def _read_ahead(source: OpenRaster, blocks: Iterator[PixelWindow]) -> Iterator[tuple[PixelWindow, PixelBlock]]:
    """Blocks with their pixels; a thread reads the next one meanwhile."""
    with reading_threads(1) as reader:
        coming: tuple[PixelWindow, Future[PixelBlock]] | None = None
        for block in blocks:
            ready, coming = coming, (block, reader.submit(source.read, block))
            if ready is not None:
                yield ready[0], ready[1].result()
        if coming is not None:
            yield coming[0], coming[1].result()


def _counts(band: np.ndarray, given: ValueRange | None) -> np.ndarray:
    """The number of pixels by value."""
    if band.dtype.kind in "iu" and band.dtype.itemsize <= 2:
        counts = np.bincount(band.view(f"u{band.dtype.itemsize}").ravel(), minlength=256**band.dtype.itemsize)
        return np.roll(counts, len(counts) // 2) if band.dtype.kind == "i" else counts
    assert given is not None
    low, high = given
    with np.errstate(invalid="ignore"):  # invalid pixels may be NaN; they are taken off again
        places = np.nan_to_num((band.ravel().astype(np.float64) - low) * (_BINS / (high - low)))
    return np.bincount(np.clip(places, 0, _BINS - 1).astype(np.int64), minlength=_BINS)


def _values(dtype: np.dtype, given: ValueRange | None) -> np.ndarray:
    if dtype.kind in "iu" and dtype.itemsize <= 2:
        information = np.iinfo(dtype)
        return np.arange(information.min, information.max + 1, dtype=np.float64)
    assert given is not None
    low, high = given
    return low + (np.arange(_BINS) + 0.5) * ((high - low) / _BINS)


PILE_PIXELS = 8  # at the largest value: fewer may be there by chance
PILE_BELOW = 16  # values below the largest, none of which has as many pixels where the values end at it

ImageRange = Union[ValueRange, "Message"]  # the range of an image's values, or the reason why it is not known


@dataclass(frozen=True)
class LargestValue:
    """The largest value of an image in 16 bit that says nothing of its range."""

    value: int
    is_piled_up: bool  # whether so many pixels have it that values end there


def own_range(image: Raster, given: ValueRange | None) -> ValueRange | None:
    """The range that was given, or that the file says; None where only its pixels could tell, or nothing.

    8 bit values have all of theirs, 16 bit ones as many bits as the file says (NBITS).
    """
    if given is not None:
        return given
    if image.data_type not in ("uint8", "int8", "uint16"):
        return None
    if image.data_type == "uint16":
        return None if image.bits is None else (0.0, float(2**image.bits - 1))
    information = np.iinfo(image.data_type)
    return float(information.min), float(information.max)


def largest_value(histograms: Iterable[Histogram]) -> LargestValue:
    bands = list(histograms)
    largest = int(max(histogram.largest for histogram in bands))
    is_piled_up = False
    for histogram in bands:
        if histogram.largest == largest:  # the histogram of another band may end below
            place = int(np.searchsorted(histogram.values, largest))
            here, below = histogram.counts[place], histogram.counts[max(place - PILE_BELOW, 0) : place]
            is_piled_up |= bool(here >= PILE_PIXELS and here > below.max(initial=0))
    return LargestValue(largest, is_piled_up)


def range_of_set(images: Sequence[LargestValue]) -> ImageRange:
    """The range of unsigned 16 bit images of one delivery that say nothing of it themselves.

    Their values have b bits where they end at 2^b - 1: where the largest value of all images is that one and pixels
    pile up at it. More than 14 bits are 16. Anything else may have any depth that holds it, so that it is not known.
    """
    largest = max(image.value for image in images)
    if largest >= 2 ** BIT_DEPTHS[-2]:
        return 0.0, float(2 ** BIT_DEPTHS[-1] - 1)
    ends = [2**bits - 1 for bits in BIT_DEPTHS]
    if largest in ends and any(image.is_piled_up for image in images if image.value == largest):
        return 0.0, float(largest)
    possible = ", ".join(str(bits) for bits in BIT_DEPTHS if 2**bits > largest)
    return messages.RANGE_UNKNOWN(count=len(images), largest=largest, possible=possible)


def known_range(image: Raster, largest: LargestValue | None, given: ValueRange | None) -> ImageRange | None:
    """The range of an image that needs no other images for it; None where the whole set may tell it."""
    available = own_range(image, given)
    if available is not None:
        if given is None and largest is not None and largest.value > available[1]:
            return messages.RANGE_CONTRADICTED(bits=image.bits, largest=largest.value)
        return available
    if image.data_type != "uint16" or largest is None:
        return messages.NO_VALUE_RANGE(data_type=image.data_type)
    return None
