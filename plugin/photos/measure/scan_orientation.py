"""The eight ways a photo can lie in the scanner, and what tells them apart."""
from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np
from scipy import ndimage, signal

from . import limits
from .arrangements import Arrangement
from .camera_calibration import CameraCalibration
from .photo import MarkFrame, Place, SearchArea
from .transformations import PlaneModel, fit_transformation, redundancy

MIN_FRAME_SHARE = 0.7  # of the scan's shorter extent that the marks span at least
SAME_PLACE = 0.02  # of the frame: marks of a square differ from it by far less
MIN_TELLING_MISFIT_MM = 0.03  # rms: twice what film and scanner leave on UNBC's photo
MAX_RESIDUAL_RATIO = 0.5  # of the next best way to lie
MIN_STRIP_RATIO = 1.5  # the strip's margin against the next widest one
MIN_DOTS_RATIO = 2.5  # the side with the dots against the next: UNBC 4 to 6
DOTS_BESIDE_RING = (0.9, 1.25, 2.2, 0.35)  # ring radii, UNBC: half the row's length, its nearest, farthest, a dot
DOT_PROMINENCE = 0.25  # of the profile's range: UNBC's four dots 0.4


class OrientationEvidence(Enum):
    """What decided how a photo lies."""

    POSITIONS = "positions"
    DOTS = "dots"
    DATA_STRIP = "data strip"
    RESIDUALS = "residuals"
    MARKS = "marks"
    """The marks' own arrangement allows one way only."""
    ASSUMED = "assumed"
    """Nothing told; it is taken to lie upright and not mirrored."""


@dataclass(frozen=True)
class ScanOrientation:
    """How a photo lies in the scan: one of eight ways."""

    turned: int
    """Degrees clockwise on the screen: 0, 90, 180 or 270."""
    mirrored: bool
    """Left and right changed before it was turned: scanned through its back."""

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
        if not any(_same_places(places, frame.places) for frame in made):
            made.append(_frame_in_scan(tuple(calibration.marks), places, columns, rows))
    return made


def centred_marks(calibration: CameraCalibration) -> np.ndarray:
    """(n, 2) mm about the middle of the marks' bounding box."""
    points = calibration.points
    return np.asarray(points - (points.min(axis=0) + points.max(axis=0)) / 2)


def _same_places(a: np.ndarray, b: np.ndarray) -> bool:
    far = np.hypot(*(a[:, np.newaxis] - b[np.newaxis]).transpose(2, 0, 1)).min(axis=1).max()
    return bool(far < SAME_PLACE * np.ptp(a, axis=0).max())


def _frame_in_scan(marks: tuple[str, ...], places: np.ndarray, columns: int, rows: int) -> MarkFrame:
    """Marks lie inside the photo, and their extent fills a large part of it, wherever it is."""
    low, extent = places.min(axis=0), np.maximum(np.ptp(places, axis=0), 1e-9)
    largest = min(columns / extent[0], rows / extent[1])
    smallest = MIN_FRAME_SHARE * largest
    areas = []
    for x, y in places - low:
        right, bottom = columns - (extent[0] - x) * smallest, rows - (extent[1] - y) * smallest
        areas.append(SearchArea(x * smallest, y * smallest, right, bottom))
    return MarkFrame(marks, places, tuple(areas), (smallest, largest), math.radians(limits.MAX_ROTATION_DEG))


@dataclass(frozen=True)
class Labelling:
    """Names for the places of an arrangement."""

    orientation: ScanOrientation
    places: Mapping[str, Place]
    """Where each mark of the calibration should be, px: by the arrangement."""
    sites: Mapping[str, str]
    """The place where each mark was looked for (as the frame calls it), by the mark's own name."""


def labellings(calibration: CameraCalibration, found: Arrangement) -> list[Labelling]:
    """All ways to name the places of an arrangement that the calibration allows."""
    made = []
    names, frame = tuple(calibration.marks), found.frame
    for orientation in SCAN_ORIENTATIONS:
        places = centred_marks(calibration) @ orientation.matrix.T
        if not _same_places(places, frame.places):
            continue
        distances = np.hypot(*(places[:, np.newaxis] - frame.places[np.newaxis]).transpose(2, 0, 1))
        sites = {name: frame.marks[int(row.argmin())] for name, row in zip(names, distances)}
        made.append(Labelling(orientation, dict(zip(names, found.predicted(places))), sites))
    return made


def matching_positions(
    candidates: Sequence[Labelling], positions: Mapping[str, Place], reach: float
) -> list[Labelling]:
    """Those that put every mark within reach (px) of its approximate position."""
    return [
        one for one in candidates
        if all(math.dist(one.places[mark], place) <= reach for mark, place in positions.items() if mark in one.places)
    ]


def matching_dots(candidates: Sequence[Labelling], dot_counts: Mapping[str, int]) -> list[Labelling]:
    """Those whose marks' numbers are the dots beside them; none where the dots decide nothing.

    ``dot_counts`` are by the names of the places. A mark's number is what its name ends with. All but one of the counts
    must agree, three at least (two where the calibration has no more); the one that does not may miss a dot or be no
    mark's number at all, for a number of another mark speaks for another way to lie.
    """
    def agreeing(one: Labelling) -> int:
        return sum(mark_number(mark) == dot_counts[site] for mark, site in one.sites.items() if site in dot_counts)

    if len(dot_counts) < 2 or not candidates:
        return []
    best = max(agreeing(one) for one in candidates)
    chosen = [one for one in candidates if agreeing(one) == best]
    counted = min(sum(site in dot_counts for site in one.sites.values()) for one in chosen)
    least = max(counted - 1, min(3, min(len(one.sites) for one in chosen)))
    numbers = {mark_number(mark) for mark in candidates[0].sites}
    return [] if best < least else [
        one for one in chosen
        if all(
            dot_counts[site] not in numbers or abs(dot_counts[site] - (mark_number(mark) or 0)) <= 1
            for mark, site in one.sites.items() if site in dot_counts
        )
    ]


def matching_count(candidates: Sequence[Labelling], measured: Mapping[str, Place]) -> list[Labelling]:
    """Those with the most marks at places where one was measured (``measured``, by the names of the places)."""
    counts = [sum(site in measured for site in one.sites.values()) for one in candidates]
    return [one for one, count in zip(candidates, counts) if count == max(counts)]


def matching_residuals(
    candidates: Sequence[Labelling], calibration: CameraCalibration, measured: Mapping[str, Place], model: PlaneModel
) -> list[Labelling]:
    """The one whose residuals are much smaller than all others'; none where they tell nothing.

    ``measured`` are places by their names.
    """
    misfits = []
    for one in candidates:
        pairs = [(measured[site], calibration.marks[mark]) for mark, site in one.sites.items() if site in measured]
        if len(pairs) < 3 or redundancy(model, len(pairs)) < 1:
            return []
        source, target = np.array([a for a, _ in pairs]), np.array([b for _, b in pairs])
        misfits.append(float(np.sqrt(np.mean((fit_transformation(model, source, target)(source) - target) ** 2))))
    order = np.argsort(misfits)
    if len(order) < 2 or misfits[order[1]] < MIN_TELLING_MISFIT_MM:
        return []
    if misfits[order[0]] >= MAX_RESIDUAL_RATIO * misfits[order[1]]:
        return []
    return [candidates[order[0]]]


def matching_data_strip(
    candidates: Sequence[Labelling], calibration: CameraCalibration, found: Arrangement, columns: int, rows: int
) -> list[Labelling]:
    """Those whose data strip lies where the scan goes furthest beyond the marks; none if that is unclear."""
    if calibration.data_strip is None:
        return []
    x, y = np.array(list(found.places.values())).T
    beyond = [columns - x.max(), rows - y.max(), x.min(), y.min()]  # right, below, left, above
    order = np.argsort(beyond)
    if beyond[order[-1]] < MIN_STRIP_RATIO * max(beyond[order[-2]], 1.0):
        return []
    side = np.array([(1, 0), (0, 1), (-1, 0), (0, -1)])[order[-1]]
    middle = calibration.points.mean(axis=0)
    strip = np.array(calibration.data_strip) - middle
    return [one for one in candidates if _nearest_side(one.orientation.matrix @ strip) == tuple(side)]


def _nearest_side(direction: np.ndarray) -> tuple[int, int]:
    if abs(direction[0]) >= abs(direction[1]):
        return (1 if direction[0] > 0 else -1), 0
    return 0, (1 if direction[1] > 0 else -1)


def mark_number(mark: str) -> int | None:
    """The number at the end of a mark's name."""
    ending = re.search(r"(\d+)\s*$", mark)
    return int(ending[1]) if ending else None


def count_numbering_dots(pixels: np.ndarray, radius: float, angle: float) -> int | None:
    """How many dots stand in a column (or row) beside a mark; None where there are none to be seen.

    ``pixels`` are around the mark's centre, as light on dark, (2 n + 1, 2 n + 1) with n of 2.4 radii at least;
    ``angle`` turns the frame back upright, degrees. The dots stand on one of the four sides, outside the ring.
    """
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
