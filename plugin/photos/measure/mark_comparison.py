"""Two measurements of the same marks against each other (Mikrut and Chwastek 2007, tables 1 to 4)."""
from __future__ import annotations

import math
import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np

from ...imagery.errors import PhotoError
from . import limits, messages
from .transformations import fit_transformation

PICTURE_ENDINGS = ("tif", "tiff", "jpg", "jpeg", "png", "bmp", "jp2", "img", "vrt", "ecw", "sid", "pix", "gif")

MarkKey = tuple[str, str]  # photo and mark


@dataclass(frozen=True)
class ComparedMark:
    """A mark as one operator or program measured it."""

    photo: str  # empty where the layer does not say
    mark: str
    place: tuple[float, float]  # column and row, px
    calibrated: tuple[float, float] | None = None  # mm, where the layer has it

    @property
    def photo_key(self) -> str:
        """The photo's name without a folder and a picture's ending."""
        name = re.split(r"[\\/]", self.photo)[-1]
        stem, _, ending = name.rpartition(".")
        return stem if stem and ending.lower() in PICTURE_ENDINGS else name


@dataclass(frozen=True)
class MarkDifference:
    """One mark, the second measurement less the first, px."""

    photo: str
    mark: str
    column: float
    row: float

    @property
    def distance(self) -> float:
        return math.hypot(self.column, self.row)


@dataclass(frozen=True)
class DifferenceStatistics:
    """Statistics of distances, in one unit."""

    count: int
    mean: float
    standard_deviation: float  # standard deviation of the sample (n - 1); NaN for a single mark
    maximum: float
    minimum: float

    @property
    def lengths(self) -> tuple[float, float, float, float]:
        return self.mean, self.standard_deviation, self.maximum, self.minimum


def mark_differences(
    first: Sequence[ComparedMark], second: Sequence[ComparedMark]
) -> tuple[list[MarkDifference], list[MarkKey]]:
    """The marks that both have, in the first one's order, and those that one of them has only. Marks
    are joined by photo and mark where both say the photo, else by mark. Raises PhotoError for a mark that a measurement
    has twice and where nothing is in both."""
    by_photo = any(mark.photo for mark in first) and any(mark.photo for mark in second)
    ours, theirs = _by_key(first, by_photo), _by_key(second, by_photo)
    differences = []
    for key, mark in ours.items():
        if key in theirs:
            x, y = theirs[key].place
            differences.append(MarkDifference(mark.photo, mark.mark, x - mark.place[0], y - mark.place[1]))
    if not differences:
        raise PhotoError(messages.NOTHING_IN_COMMON(first=some_names(ours), second=some_names(theirs)))
    return differences, [*(key for key in ours if key not in theirs), *(key for key in theirs if key not in ours)]


def some_names(marks: Collection[MarkKey]) -> str:
    """The first marks with their photos."""
    names = [" ".join(filter(None, key)) for key in islice(marks, 5)]
    return ", ".join([*names, "..."] if len(marks) > len(names) else names) or "-"


def _by_key(marks: Sequence[ComparedMark], by_photo: bool) -> dict[MarkKey, ComparedMark]:
    made: dict[MarkKey, ComparedMark] = {}
    for mark in marks:
        key = mark.photo_key if by_photo else "", mark.mark
        if key in made:
            where = f" ({mark.photo_key})" if by_photo else ""
            raise PhotoError(messages.COMPARED_TWICE(mark=mark.mark, where=where))
        if not all(abs(part) < limits.MOST_SCANNED_PX for part in mark.place):
            raise PhotoError(messages.COMPARED_NOWHERE(mark=mark.mark, column=mark.place[0], row=mark.place[1]))
        made[key] = mark
    return made


def distance_statistics(differences: Sequence[MarkDifference], unit: float = 1.0) -> DifferenceStatistics:
    """Statistics of distances in a unit of which a pixel has so many."""
    distances = unit * np.array([difference.distance for difference in differences])
    spread = float(distances.std(ddof=1)) if len(distances) > 1 else math.nan
    mean, largest, smallest = (float(value) for value in (distances.mean(), distances.max(), distances.min()))
    return DifferenceStatistics(len(distances), mean, spread, largest, smallest)


def pixel_size(marks: Sequence[ComparedMark]) -> float | None:
    """um per pixel from the calibrated coordinates beside the measured ones; None where they do not tell."""
    photos: dict[str, list[ComparedMark]] = {}
    for mark in marks:
        if mark.calibrated is not None:
            photos.setdefault(mark.photo, []).append(mark)
    sizes = []
    for group in photos.values():
        if len(group) < 2:
            continue
        source, target = np.array([mark.place for mark in group]), np.array([mark.calibrated for mark in group])
        try:
            matrix = fit_transformation(limits.SIMILARITY, source, target).matrix
        except PhotoError:
            continue
        sizes.append(1000 * math.sqrt(abs(float(np.linalg.det(matrix[:2, :2])))))
    return float(np.mean(sizes)) if sizes else None
