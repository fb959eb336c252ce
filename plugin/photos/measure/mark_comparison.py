"""Two measurements of the same marks against each other (Mikrut and Chwastek 2007, tables 1 to 4)."""
from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...imagery.errors import PhotoError
from . import messages
from .transformations import PlaneModel, fit_transformation

PICTURE_ENDINGS = ("tif", "tiff", "jpg", "jpeg", "png", "bmp", "jp2", "img", "vrt", "ecw", "sid", "pix", "gif")

MarkKey = tuple[str, str]
"""Photo and mark."""


@dataclass(frozen=True)
class ComparedMark:
    """A mark as one operator or program measured it."""

    photo: str
    """Empty where the layer does not say."""
    mark: str
    place: tuple[float, float]
    """Column and row, px."""
    calibrated: tuple[float, float] | None = None
    """mm, where the layer has it."""


    @property
    def photo_key(self) -> str:
        """What the photo is known by: its name without a folder and a picture's ending."""
        stem, _, ending = re.split(r"[\\/]", self.photo)[-1].rpartition(".")
        return stem if stem and ending.lower() in PICTURE_ENDINGS else re.split(r"[\\/]", self.photo)[-1]


@dataclass(frozen=True)
class MarkDifference:
    """One mark, the second measurement less the first, px."""

    photo: str
    mark: str
    column: float
    row: float

    @property
    def distance(self) -> float:
        """px."""
        return math.hypot(self.column, self.row)


@dataclass(frozen=True)
class DifferenceStatistics:
    """Of distances, in one unit."""

    count: int
    mean: float
    standard_deviation: float
    """Of the sample (n - 1); NaN for a single mark."""
    maximum: float
    minimum: float

    def scaled(self, factor: float) -> DifferenceStatistics:
        """The same in a unit of another size."""
        lengths = (self.mean, self.standard_deviation, self.maximum, self.minimum)
        return DifferenceStatistics(self.count, *(length * factor for length in lengths))


Marks = dict[MarkKey, ComparedMark]


def mark_differences(first: Sequence[ComparedMark], second: Sequence[ComparedMark]) -> list[MarkDifference]:
    """The marks that both have, in the first one's order.

    Marks are joined by photo and mark where both say the photo, else by mark. Raises PhotoError for a mark that a
    measurement has twice and where nothing is in both.
    """
    one_side, other_side = _both_by_key(first, second)
    both = [(one, other_side[key].place) for key, one in one_side.items() if key in other_side]
    if not both:
        raise PhotoError(messages.NOTHING_IN_COMMON(first=_named(one_side), second=_named(other_side)))
    return [MarkDifference(one.photo, one.mark, x - one.place[0], y - one.place[1]) for one, (x, y) in both]


def marks_alone(first: Sequence[ComparedMark], second: Sequence[ComparedMark]) -> list[str]:
    """The marks that one of the measurements has only, with their photos."""
    return [" ".join(filter(None, key)) for one, other in _either_way(*_both_by_key(first, second))
            for key in one if key not in other]


def _either_way(one: Marks, other: Marks) -> tuple[tuple[Marks, Marks], ...]:
    return (one, other), (other, one)


def _both_by_key(first: Sequence[ComparedMark], second: Sequence[ComparedMark]) -> tuple[Marks, Marks]:
    by_photo = any(one.photo for one in first) and any(one.photo for one in second)
    return _by_key(first, by_photo), _by_key(second, by_photo)


def _named(marks: Marks) -> str:
    """A few of them."""
    names = [" ".join(filter(None, key)) for key in marks]
    return ", ".join(names[:3]) + (", ..." if len(names) > 3 else "") if names else "-"


def _by_key(marks: Sequence[ComparedMark], by_photo: bool) -> Marks:
    made: Marks = {}
    for one in marks:
        key = one.photo_key if by_photo else "", one.mark
        if key in made:
            where = f" ({one.photo_key})" if by_photo else ""
            raise PhotoError(messages.COMPARED_TWICE(mark=one.mark, where=where))
        made[key] = one
    return made


def distance_statistics(found: Sequence[MarkDifference]) -> DifferenceStatistics:
    """Of the distances, px."""
    distances = np.array([one.distance for one in found])
    spread = float(distances.std(ddof=1)) if len(distances) > 1 else math.nan
    mean, largest, smallest = (float(value) for value in (distances.mean(), distances.max(), distances.min()))
    return DifferenceStatistics(len(distances), mean, spread, largest, smallest)


def by_photo(found: Sequence[MarkDifference]) -> dict[str, list[MarkDifference]]:
    """The differences of each photo, in their order."""
    made: dict[str, list[MarkDifference]] = {}
    for one in found:
        made.setdefault(one.photo, []).append(one)
    return made


def pixel_size(marks: Sequence[ComparedMark]) -> float | None:
    """um per pixel from the calibrated coordinates beside the measured ones; None where they do not tell."""
    photos: dict[str, list[ComparedMark]] = {}
    for one in marks:
        if one.calibrated is not None:
            photos.setdefault(one.photo, []).append(one)
    sizes = []
    for group in photos.values():
        if len(group) < 2:
            continue
        source, target = np.array([one.place for one in group]), np.array([one.calibrated for one in group])
        try:
            matrix = fit_transformation(PlaneModel.SIMILARITY, source, target).matrix
        except PhotoError:
            continue
        sizes.append(1000 * math.sqrt(abs(float(np.linalg.det(matrix[:2, :2])))))
    return float(np.mean(sizes)) if sizes else None
