"""The interior orientation of one photo: from pixels and a calibration to marks and a transformation."""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Callable

import numpy as np

from ...imagery.errors import PhotoError
from . import limits, messages, scan_orientation
from .camera_calibration import CameraCalibration, check_calibration
from .finding.finding_marks import find_marks
from .finding.found_marks import FoundMarks
from .fitting_marks import fail_misplaced_marks, fit_marks
from .mark_templates import CutOut, MarkKind, MarkShape
from .measuring_marks import MarkWindow, UnmeasuredMark, window_around
from .orientation import (
    FittedTransformation,
    GivenPosition,
    MarkResult,
    MarkStatus,
    OrientationSettings,
    PhotoOrientation,
)
from .photo import Photo
from .photo_views import Place
from .scan_orientation import OrientationEvidence, ScanOrientation

PLAIN_FIGURES = (MarkKind.DOT, MarkKind.WEDGE)  # three roofs or crossroads of a picture may lie as three marks do
SURE_OF_PLAIN = 0.75  # mean correlation of those: three chance ones had 0.69, true ones in little grain 0.9 and more
MIN_PICTURE_PX = 20  # half a side of the picture of a mark


def orient_photo(
    photo: Photo,
    calibration: CameraCalibration,
    positions: Mapping[str, GivenPosition],
    settings: OrientationSettings,
    cancelled: Callable[[], bool] = lambda: False,
) -> PhotoOrientation:
    """Measure the marks of a photo and fit the transformation.

    Raises PhotoError where nothing can be measured at all.
    """
    check_calibration(calibration, settings.model)
    _check_positions(photo, calibration, positions)
    given = {name: one.place for name, one in positions.items() if not one.measure}
    found = FoundMarks(template=settings.template)
    if set(given) != set(calibration.marks):
        found = find_marks(photo, calibration, positions, settings, cancelled)
    marks = _without_doubles([_mark(name, place, given, found) for name, place in calibration.marks.items()])
    marks = fail_misplaced_marks(marks)
    marks = _supported(marks, positions, found.template)
    fitted, marks, left_out = fit_marks(marks, settings.model)
    if fitted is None and not any(mark.place for mark in marks):
        _raise_nothing(photo, marks, bool(given))
    way, evidence = found.scan_orientation, found.evidence
    if fitted is not None and way is None:
        way, evidence = _nearest_scan_orientation(fitted), OrientationEvidence.POSITIONS
    notices = (*found.notices, *left_out)
    expected = {} if fitted is None else {
        mark.name: _place(fitted, mark.calibrated) for mark in marks if mark.place is None
    }
    views = _surroundings(photo, marks, expected, found.template)
    return PhotoOrientation(tuple(marks), fitted, way, evidence, found.template, notices, views, expected)


def _check_positions(
    photo: Photo, calibration: CameraCalibration, positions: Mapping[str, GivenPosition]
) -> None:
    unknown = [name for name in positions if name not in calibration.marks]
    if unknown:
        raise PhotoError(messages.POSITION_UNKNOWN(mark=unknown[0], marks=", ".join(calibration.marks)))
    seen: dict[Place, str] = {}
    for name, position in positions.items():
        if not position.measure and not photo.contains(position.place):
            raise PhotoError(messages.POSITION_OUTSIDE(mark=name))
        for place, other in seen.items():
            if math.dist(place, position.place) < 1:
                raise PhotoError(messages.POSITIONS_AT_ONE_PLACE(one=other, other=name))
        seen[position.place] = name


def _mark(name: str, calibrated: Place, given: Mapping[str, Place], found: FoundMarks) -> MarkResult:
    if name in given:
        return MarkResult(name, calibrated, MarkStatus.GIVEN, given[name])
    one = found.results.get(name, UnmeasuredMark(messages.MARK_NOT_ARRANGED()))
    if isinstance(one, UnmeasuredMark):
        return MarkResult(name, calibrated, MarkStatus.FAILED, None, one.correlation, one.reason)
    return MarkResult(name, calibrated, MarkStatus.MEASURED, (one.column, one.row), one.correlation)


def _without_doubles(marks: Sequence[MarkResult]) -> list[MarkResult]:
    """Two marks at one place are none."""
    made = []
    for mark in marks:
        twin = next(
            (
                other for other in marks
                if other is not mark and mark.place and other.place
                and math.dist(mark.place, other.place) < limits.ONE_PLACE_PX
            ),
            None,
        )
        if twin is not None and mark.status is MarkStatus.MEASURED:
            mark = replace(mark, status=MarkStatus.FAILED, place=None, reason=messages.MARK_TWICE(other=twin.name))
        made.append(mark)
    return made


def _supported(
    marks: Sequence[MarkResult], positions: Mapping[str, GivenPosition], template: MarkShape | CutOut | None
) -> list[MarkResult]:
    """Marks that nobody pointed at have to confirm each other, one more where pictures hold such figures too."""
    placed = [mark for mark in marks if mark.place is not None]
    count, least = len(placed), limits.MIN_SUPPORT
    if isinstance(template, MarkShape) and template.kind in PLAIN_FIGURES and count:
        alike = float(np.mean([1.0 if mark.correlation is None else mark.correlation for mark in placed]))
        least += alike < SURE_OF_PLAIN
    if count >= least:
        return list(marks)
    reason = messages.MARK_UNSUPPORTED(count=count, least=least)
    return [
        replace(mark, status=MarkStatus.FAILED, place=None, reason=reason)
        if mark.status is MarkStatus.MEASURED and mark.name not in positions else mark
        for mark in marks
    ]


def _raise_nothing(photo: Photo, marks: Sequence[MarkResult], given: bool) -> None:
    why = next(mark.reason for mark in marks if mark.reason is not None)
    if given:
        raise PhotoError(messages.NO_MARK_TRUSTED(name=photo.ref.name, why=why))
    raise PhotoError(messages.NO_MARK_FOUND(name=photo.ref.name, why=why))


def _place(fitted: FittedTransformation, calibrated: Place) -> Place:
    ((column, row),) = fitted.to_pixels(np.array([calibrated]))
    return float(column), float(row)


def _surroundings(
    photo: Photo, marks: Sequence[MarkResult], expected: Mapping[str, Place], template: MarkShape | CutOut | None
) -> dict[str, MarkWindow]:
    """The photo around every mark, where it is or should be, for the report."""
    size = template.size if isinstance(template, MarkShape) else max(template.pixels.shape) if template else 0.0
    half = math.ceil(max(size, 2 * MIN_PICTURE_PX) * 0.75)
    places = {mark.name: mark.place or expected.get(mark.name) for mark in marks}
    return {
        name: window_around(photo, place, half) for name, place in places.items()
        if place is not None and photo.contains(place)
    }


def _nearest_scan_orientation(fitted: FittedTransformation) -> ScanOrientation:
    """The way to lie that a transformation comes nearest."""
    back = fitted.to_pixels.linear(np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]))[:, :2]
    return max(scan_orientation.SCAN_ORIENTATIONS, key=lambda one: float(np.sum(one.matrix * back)))
