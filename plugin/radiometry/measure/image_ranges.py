"""The range of values that an image could have used, where somebody or something says it; it is never guessed."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from ...imagery.errors import Message
from ...imagery.rasters import BIT_DEPTHS, Raster, ValueRange
from . import messages
from .image_statistics import Histogram

PILE_PIXELS = 8  # at the largest value: fewer may be there by chance
PILE_BELOW = 16  # values below the largest, none of which has as many pixels where the values end at it


@dataclass(frozen=True)
class ImageRange:
    """The range of an image's values, or why it is not known."""

    available: ValueRange | None
    why: Message | None = None
    """Why it is not known."""


@dataclass(frozen=True)
class LargestValue:
    """The largest value of an image in 16 bit that says nothing of its range."""

    value: int
    is_piled_up: bool
    """Whether so many pixels have it that values end there."""


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
    """The largest value of an image's bands."""
    found = list(histograms)
    largest = int(max(histogram.largest for histogram in found))
    piled = False
    for histogram in found:
        if histogram.largest < largest:
            continue  # this band may end below, and its histogram with it
        place = int(np.searchsorted(histogram.values, largest))
        here = int(histogram.counts[place])
        below = histogram.counts[max(place - PILE_BELOW, 0) : place]
        piled |= here >= PILE_PIXELS and here > int(below.max(initial=0))
    return LargestValue(largest, piled)


def range_of_set(images: Sequence[LargestValue]) -> ImageRange:
    """The range of unsigned 16 bit images of one delivery that say nothing of it themselves.

    Their values have b bits where they end at 2^b - 1: where the largest value of all images is that one and pixels
    pile up at it. More than 14 bits are 16. Anything else may have any depth that holds it, so that it is not known.
    """
    largest = max(image.value for image in images)
    if largest >= 2 ** BIT_DEPTHS[-2]:
        return ImageRange((0.0, float(2 ** BIT_DEPTHS[-1] - 1)))
    ends = [2**bits - 1 for bits in BIT_DEPTHS]
    if largest in ends and any(image.is_piled_up for image in images if image.value == largest):
        return ImageRange((0.0, float(largest)))
    possible = ", ".join(str(bits) for bits in BIT_DEPTHS if 2**bits > largest)
    return ImageRange(None, messages.RANGE_UNKNOWN(count=len(images), largest=largest, possible=possible))


def known_range(image: Raster, largest: LargestValue | None, given: ValueRange | None) -> ImageRange | None:
    """The range of an image that needs no other images for it; None where the whole set may tell it."""
    available = own_range(image, given)
    if available is not None:
        if given is None and largest is not None and largest.value > available[1]:
            said = messages.RANGE_CONTRADICTED(bits=image.bits, largest=largest.value)
            return ImageRange(None, said)
        return ImageRange(available)
    if image.data_type != "uint16" or largest is None:
        return ImageRange(None, messages.NO_VALUE_RANGE(data_type=image.data_type))
    return None
