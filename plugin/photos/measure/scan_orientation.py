"""The eight ways a photo can lie in the scanner, and what tells them apart."""
from __future__ import annotations

import math
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from scipy import ndimage, signal
from scipy.spatial.distance import cdist

from . import limits
from .arrangements import Arrangement
from .camera_calibration import CameraCalibration
from .photo import MarkFrame, Place, SearchArea
from .transformations import fit_transformation, redundancy

MIN_FRAME_SHARE = 0.7  # of the scan's shorter extent that the marks span at least
SAME_PLACE = 0.02  # of the frame: marks of a square differ from it by far less
MIN_TELLING_MISFIT_MM = 0.03  # rms: twice what film and scanner leave on UNBC's photo
MAX_RESIDUAL_RATIO = 0.5  # of the next best way to lie
MIN_STRIP_RATIO = 1.5  # the strip's margin against the next widest one
MIN_DOTS_RATIO = 2.5  # the side with the dots against the next: UNBC 4 to 6
DOTS_BESIDE_RING = (0.9, 1.25, 2.2, 0.35)  # ring radii, UNBC: half the row's length, its nearest, farthest, a dot
DOT_PROMINENCE = 0.25  # of the profile's range: UNBC's four dots 0.4

Value = TypeVar("Value")


@dataclass(frozen=True)
class ScanOrientation:
    """The way in which a photo lies in the scan, one of eight."""

    turned: int  # degrees clockwise on the screen: 0, 90, 180 or 270
    mirrored: bool  # left and right changed before it was turned: scanned through its back

    @property
    def matrix(self) -> np.ndarray:
        """(2, 2): photo coordinates (y upwards) to the scan's axes (y downwards)."""
        angle = math.radians(self.turned)
        turn = np.round([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
        return np.asarray(turn @ np.diag([-1.0 if self.mirrored else 1.0, -1.0]))


SCAN_ORIENTATIONS = tuple(
    ScanOrientation(turned, mirrored) for mirrored in (False, True) for turned in (0, 90, 180, 270)
)


def possible_frames(calibration: CameraCalibration, columns: int, rows: int) -> list[MarkFrame]:
    """The frames that a photo of a size may hold: ways to lie that put marks at the same places are one frame."""
    made: list[MarkFrame] = []
    for orientation in SCAN_ORIENTATIONS:
        places = centred_marks(calibration) @ orientation.matrix.T
        if any(_same_places(places, frame.places) for frame in made):
            continue
        # The marks lie inside the photo, and their extent fills a large part of it, wherever it is.
        low, extent = places.min(axis=0), np.maximum(np.ptp(places, axis=0), 1e-9)
        largest = min(columns / extent[0], rows / extent[1])
        smallest, areas = MIN_FRAME_SHARE * largest, []
        for x, y in places - low:
            right, bottom = columns - (extent[0] - x) * smallest, rows - (extent[1] - y) * smallest
            areas.append(SearchArea(x * smallest, y * smallest, right, bottom))
        rotation = math.radians(limits.MAX_ROTATION_DEG)
        made.append(MarkFrame(tuple(calibration.marks), places, tuple(areas), (smallest, largest), rotation))
    return made


def centred_marks(calibration: CameraCalibration) -> np.ndarray:
    """(n, 2) mm about the middle of the marks' bounding box."""
    points = calibration.points
    return np.asarray(points - (points.min(axis=0) + points.max(axis=0)) / 2)


def _same_places(a: np.ndarray, b: np.ndarray) -> bool:
    return bool(cdist(a, b).min(axis=1).max() < SAME_PLACE * np.ptp(a, axis=0).max())


@dataclass(frozen=True)
class Labelling:
    """Names for the places of an arrangement."""

    orientation: ScanOrientation
    places: Mapping[str, Place]  # where each mark of the calibration should be, px: by the arrangement
    sites: Mapping[str, str]  # the place where each mark was looked for (as the frame calls it), by the mark's name

    def marks_at(self, sites: Mapping[str, Value]) -> list[tuple[str, Value]]:
        """The marks at some of the sites, each with the site's value."""
        return [(mark, sites[site]) for mark, site in self.sites.items() if site in sites]


def labellings(calibration: CameraCalibration, arrangement: Arrangement) -> list[Labelling]:
    """All ways to name the places of an arrangement that the calibration allows."""
    made = []
    names, frame = tuple(calibration.marks), arrangement.frame
    for orientation in SCAN_ORIENTATIONS:
        places = centred_marks(calibration) @ orientation.matrix.T
        if _same_places(places, frame.places):
            sites = [frame.marks[index] for index in cdist(places, frame.places).argmin(axis=1)]
            predicted = dict(zip(names, arrangement.predicted(places)))
            made.append(Labelling(orientation, predicted, dict(zip(names, sites))))
    return made


def matching_positions(
    candidates: Sequence[Labelling], positions: Mapping[str, Place], reach: float
) -> list[Labelling]:
    """The labellings that put every mark within reach (px) of its approximate position."""
    return [labelling for labelling in candidates if all(
        math.dist(place, positions[mark]) <= reach for mark, place in labelling.places.items() if mark in positions
    )]  # fmt: skip


def matching_dots(candidates: Sequence[Labelling], dot_counts: Mapping[str, int]) -> list[Labelling]:
    """The labellings whose marks' numbers are the dots beside them; none where the dots decide nothing. ``dot_counts``
    are by the names of the places. The number of a mark is at the end of its name. All but one of the counts must
    agree, three at least (two where the calibration has no more); the one that does not may miss a dot or be no mark's
    number at all, for a number of another mark speaks for another way to lie."""
    def agreeing(labelling: Labelling) -> int:
        return sum(mark_number(mark) == count for mark, count in labelling.marks_at(dot_counts))

    if len(dot_counts) < 2 or not candidates:
        return []
    best = max(map(agreeing, candidates))
    chosen = [labelling for labelling in candidates if agreeing(labelling) == best]
    counted = min(len(labelling.marks_at(dot_counts)) for labelling in chosen)
    least = max(counted - 1, min(3, min(len(labelling.sites) for labelling in chosen)))
    numbers = {mark_number(mark) for mark in candidates[0].sites}
    return [] if best < least else [labelling for labelling in chosen if all(
        count not in numbers or abs(count - (mark_number(mark) or 0)) <= 1
        for mark, count in labelling.marks_at(dot_counts)
    )]  # fmt: skip


def matching_count(candidates: Sequence[Labelling], measured: Mapping[str, Place]) -> list[Labelling]:
    """The labellings with the most marks at places where a mark was ``measured`` (by the names of the places)."""
    counts = [len(labelling.marks_at(measured)) for labelling in candidates]
    return [labelling for labelling, count in zip(candidates, counts) if count == max(counts)]


def matching_residuals(
    candidates: Sequence[Labelling], calibration: CameraCalibration, measured: Mapping[str, Place], model: str
) -> list[Labelling]:
    """The labelling whose residuals are much smaller than all others'; none where they tell nothing. ``measured`` are
    places by their names."""
    misfits = []
    for labelling in candidates:
        marks = labelling.marks_at(measured)
        if len(marks) < 3 or redundancy(model, len(marks)) < 1:
            return []
        source = np.array([place for _, place in marks])
        target = np.array([calibration.marks[mark] for mark, _ in marks])
        misfits.append(float(np.sqrt(np.mean((fit_transformation(model, source, target)(source) - target) ** 2))))
    best, second, *_ = (*sorted(misfits), 0.0, 0.0)
    tells = second >= MIN_TELLING_MISFIT_MM and best < MAX_RESIDUAL_RATIO * second
    return [candidates[int(np.argmin(misfits))]] if tells else []


def matching_data_strip(
    candidates: Sequence[Labelling], calibration: CameraCalibration, places: Collection[Place], size: tuple[int, int]
) -> list[Labelling]:
    """The labellings whose data strip lies where a scan of ``size`` (columns, rows) goes furthest beyond the marks'
    ``places``; none if that is unclear."""
    if calibration.data_strip is None:
        return []
    (x, y), (columns, rows) = np.array([*places]).T, size
    beyond = [columns - x.max(), rows - y.max(), x.min(), y.min()]
    *_, second, widest = np.argsort(beyond)
    if beyond[widest] < MIN_STRIP_RATIO * max(beyond[second], 1.0):
        return []
    sides = np.array([(1, 0), (0, 1), (-1, 0), (0, -1)])  # right, below, left, above
    strip = np.array(calibration.data_strip) - calibration.points.mean(axis=0)
    return [labelling for labelling in candidates if np.argmax(sides @ labelling.orientation.matrix @ strip) == widest]


def mark_number(mark: str) -> int | None:
    ending = re.search(r"(\d+)\s*$", mark)
    return int(ending[1]) if ending else None


def count_numbering_dots(pixels: np.ndarray, radius: float, angle: float) -> int | None:
    """The number of dots in a column (or row) beside a mark; None where there are none to be seen. ``pixels`` are
    around the mark's centre, as light on dark, (2 n + 1, 2 n + 1) with n of 2.4 radii at least; ``angle`` turns the
    frame back upright, degrees. The dots stand on one of the four sides, outside the ring."""
    if abs(angle) > 0.5:
        pixels = ndimage.rotate(pixels, angle, reshape=False, order=1, mode="nearest")
    middle = pixels.shape[0] // 2
    across, near, far, width = (round(share * radius) for share in DOTS_BESIDE_RING)
    width = max(2, width)
    profiles = []
    for turn in range(4):
        turned = np.rot90(pixels, turn)
        strip = turned[middle - across : middle + across + 1, middle + near : middle + far]
        columns = np.stack([strip[:, i : i + width].mean(axis=1) for i in range(max(1, strip.shape[1] - width))])
        profiles.append(columns[columns.std(axis=1).argmax()])
    signals = [float(profile.std()) for profile in profiles]
    order = np.argsort(signals)
    if signals[order[-1]] < MIN_DOTS_RATIO * max(signals[order[-2]], 1e-9):
        return None
    profile = ndimage.zoom(profiles[order[-1]], 4, order=3)
    prominence = DOT_PROMINENCE * np.ptp(profile)
    tops, _ = signal.find_peaks(np.pad(profile, 1, mode="minimum"), prominence=prominence)
    return len(tops)
