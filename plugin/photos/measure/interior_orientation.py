"""The interior orientation of one photo: from pixels and a calibration to marks and a transformation."""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Callable

import numpy as np

from ...imagery.errors import CancelledError, Message, PhotoError
from ...imagery.messages import CANCELLED
from . import limits, messages
from .camera_calibration import CameraCalibration, check_calibration
from .finding_marks import MarkFinder, within
from .mark_templates import CutOut, MarkShape
from .measuring_marks import MeasuredMark, window_around
from .orientation import (
    FittedTransformation,
    GivenPosition,
    MarkResult,
    MarkSearch,
    OrientationSettings,
    PhotoOrientation,
)
from .photo import Photo, PhotoView, Place
from .scan_orientation import SCAN_ORIENTATIONS
from .transformations import LEAST_MARKS, fit_transformation, redundancy

CHANCE = 0.001  # that a photo without an outlier has a mark that stands out
TELLING_SHARE = 0.25  # of the limit: 0.05 mm on 23 cm, which film and scanner leave on good photos
PLAIN_FIGURES = (limits.DOT, limits.WEDGE)  # three roofs or crossroads of a picture may lie as three marks do
SURE_OF_PLAIN = 0.75  # mean correlation of those: three chance ones had 0.69, true ones in little grain 0.9 and more
MIN_PICTURE_PX = 20  # half a side of the picture of a mark


def fail_misplaced_marks(marks: Sequence[MarkResult]) -> list[MarkResult]:
    """Marks that can't be where they are, since the others agree without them. A photo is its calibration shifted,
    turned and scaled, but for a thousandth of deformation: a similarity leaves two marks' worth of redundancy to four
    marks, enough to tell which one is off. With three it tells only that one is, and marks of which no more than half
    agree are all in doubt. A place that was given is judged like a measured one."""
    placed = [mark for mark in marks if mark.place is not None]
    agreeing, out = placed, dict[str, Message]()
    while len(agreeing) >= 3:
        limit, worst = largest_shift(agreeing), _misfit(agreeing)
        if worst <= limit:
            break
        if len(agreeing) == 3 or 2 * (len(agreeing) - 1) <= len(placed):
            reason = messages.MARKS_DISAGREE(worst=_misfit(placed), limit=limit)
            out = {mark.name: reason for mark in placed}
            break
        suspect = min(agreeing, key=lambda mark: _misfit([other for other in agreeing if other is not mark]))
        agreeing = [mark for mark in agreeing if mark is not suspect]
        out[suspect.name] = _off(suspect, worst, limit)
    return [_failed(mark, out[mark.name]) if mark.name in out else mark for mark in marks]


def largest_shift(marks: Sequence[MarkResult]) -> float:
    """The distance, mm, that a mark may lie from where the others want it: it follows the frame."""
    return limits.FILM_DEFORMATION * float(np.ptp(_pairs(marks)[1], axis=0).max())


def _off(mark: MarkResult, worst: float, limit: float) -> Message:
    if mark.status == limits.GIVEN:
        return messages.GIVEN_OFF(worst=worst, limit=limit)
    return messages.MARK_OFF(worst=worst, limit=limit)


def _failed(mark: MarkResult, reason: Message) -> MarkResult:
    return replace(mark, status=limits.FAILED, place=None, reason=reason)


def _misfit(marks: Sequence[MarkResult]) -> float:
    """The largest residual of a similarity, mm."""
    source, target = _pairs(marks)
    try:
        made = fit_transformation(limits.SIMILARITY, source, target)
    except PhotoError:
        return 0.0
    return float(np.hypot(*(made(source) - target).T).max())


def _pairs(marks: Sequence[MarkResult]) -> tuple[np.ndarray, np.ndarray]:
    return np.array([mark.place for mark in marks], float), np.array([mark.calibrated for mark in marks], float)


def fit_marks(
    marks: Sequence[MarkResult], model: str
) -> tuple[FittedTransformation | None, list[MarkResult], list[Message]]:
    """The transformation by all marks that have a place, and the marks with their residuals.

    A mark is left out as an outlier where the others, without it, agree on a place for it that is farther off than
    film deforms; where they agree on one that is nearer, it is named and stays. Only with enough marks to leave a
    redundancy of two: an affine transformation of four marks has two, and without one of them none, so there the
    residuals say how well the four agree, never which is wrong.
    """
    marks = list(marks)
    notices: list[Message] = []
    while True:
        placed = [mark for mark in marks if mark.place is not None]
        if len(placed) < LEAST_MARKS[model]:
            least, count = LEAST_MARKS[model], len(placed)
            too_few = messages.TOO_FEW_MARKS(model=messages.WORDS[model], least=least, count=count)
            return None, marks, [*notices, too_few.as_warning()]
        source, target = _pairs(placed)
        try:
            made = fit_transformation(model, source, target)
        except PhotoError as error:
            return None, marks, [*notices, error.message.as_warning()]
        limit = largest_shift(placed)
        suspect = _outlier(placed, model, TELLING_SHARE * limit) if redundancy(model, len(placed) - 1) >= 2 else None
        if suspect is None:
            break
        mark, shift = suspect
        if shift <= limit:
            notices.append(messages.MARK_STANDS_OUT(mark=mark.name, worst=shift))
            break
        marks = [_failed(other, _off(other, shift, limit)) if other is mark else other for other in marks]
    residuals = 1000 * (made(source) - target)
    rms = np.sqrt(np.mean(residuals**2, axis=0))
    left_over = redundancy(model, len(placed))
    fitted = FittedTransformation(made, made.inverse, len(placed), left_over, float(rms[0]), float(rms[1]))
    by_name = {mark.name: (float(x), float(y)) for mark, (x, y) in zip(placed, residuals)}
    if fitted.redundancy < 1:
        notices.append(messages.NO_REDUNDANCY(model=messages.WORDS[model], count=len(placed)))
    return fitted, [replace(mark, residual=by_name.get(mark.name)) for mark in marks], notices


def _outlier(marks: Sequence[MarkResult], model: str, least: float) -> tuple[MarkResult, float] | None:
    """The mark that stands out most, and how far off (mm, more than ``least``) the others want it; None without one. A
    mark's residual and its distance from where the others alone put it, multiplied, are its share of the sum of
    squares: against the others' own variance it follows F(2, their redundancy), which has this closed form."""
    source, target = _pairs(marks)
    residuals = np.hypot(*(fit_transformation(model, source, target)(source) - target).T)
    left_over = redundancy(model, len(marks) - 1)
    critical = left_over / 2 * ((CHANCE / len(marks)) ** (-2 / left_over) - 1)
    outlier: tuple[float, MarkResult, float] | None = None
    for index, mark in enumerate(marks):
        others = np.arange(len(marks)) != index
        try:
            made = fit_transformation(model, source[others], target[others])
        except PhotoError:
            continue
        off = np.hypot(*(made(source) - target).T)
        variance = float(np.sum(off[others] ** 2)) / left_over
        ratio = residuals[index] * off[index] / 2 / max(variance, 1e-12)
        if off[index] > least and ratio > critical and (outlier is None or ratio > outlier[0]):
            outlier = ratio, mark, float(off[index])
    return None if outlier is None else outlier[1:]


def orient_photo(
    photo: Photo, calibration: CameraCalibration, positions: Mapping[str, GivenPosition], settings: OrientationSettings,
    cancelled: Callable[[], bool] = lambda: False,
) -> PhotoOrientation:
    """Measure the marks of a photo and fit the transformation. Raises PhotoError where nothing can be measured at all,
    CancelledError where marks were still looked for."""
    check_calibration(calibration, settings.model)
    _check_positions(photo, calibration, positions)
    given = {name: position.place for name, position in positions.items() if not position.measure}
    search = MarkSearch(template=settings.template)
    if set(given) != set(calibration.marks):
        search = MarkFinder(photo, calibration, positions, settings, cancelled).search()
        if cancelled():
            raise CancelledError(CANCELLED())
    marks = _without_doubles([_mark(name, place, given, search) for name, place in calibration.marks.items()])
    marks = _supported(fail_misplaced_marks(marks), positions, search.template)
    fitted, marks, left_out = fit_marks(marks, settings.model)
    if fitted is None and not any(mark.place for mark in marks):
        why = next(mark.reason for mark in marks if mark.reason is not None)
        if given:
            raise PhotoError(messages.NO_MARK_TRUSTED(name=photo.ref.name, why=why))
        raise PhotoError(messages.NO_MARK_FOUND(name=photo.ref.name, why=why))
    way, evidence = search.scan_orientation, search.evidence
    if fitted is not None and way is None:
        back = fitted.to_pixels.linear(np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]))[:, :2]
        way = max(SCAN_ORIENTATIONS, key=lambda orientation: float(np.sum(orientation.matrix * back)))
        evidence = limits.POSITIONS
    expected: dict[str, Place] = {}
    for mark in marks:
        if fitted is not None and mark.place is None:
            ((column, row),) = fitted.to_pixels(np.array([mark.calibrated]))
            expected[mark.name] = float(column), float(row)
    views, notices = _surroundings(photo, marks, expected, search.template), (*search.notices, *left_out)
    return PhotoOrientation(tuple(marks), fitted, way, evidence, search.template, notices, views, expected)


def _check_positions(photo: Photo, calibration: CameraCalibration, positions: Mapping[str, GivenPosition]) -> None:
    unknown = [name for name in positions if name not in calibration.marks]
    if unknown:
        raise PhotoError(messages.POSITION_UNKNOWN(mark=unknown[0], marks=", ".join(calibration.marks)))
    seen: dict[Place, str] = {}
    for name, position in positions.items():
        if not position.measure and not photo.contains(position.place):
            raise PhotoError(messages.POSITION_OUTSIDE(mark=name))
        for place, other in seen.items():
            if math.dist(place, position.place) < 1:
                raise PhotoError(messages.POSITIONS_AT_ONE_PLACE(mark=other, other=name))
        seen[position.place] = name


def _mark(name: str, calibrated: Place, given: Mapping[str, Place], search: MarkSearch) -> MarkResult:
    if name in given:
        return MarkResult(name, calibrated, limits.GIVEN, given[name])
    mark = search.results.get(name, MeasuredMark(reason=messages.MARK_NOT_ARRANGED()))
    status = limits.FAILED if mark.place is None else limits.MEASURED
    return MarkResult(name, calibrated, status, mark.place, mark.correlation, mark.reason)


def _without_doubles(marks: Sequence[MarkResult]) -> list[MarkResult]:
    """The marks, of which those measured at the place of another one fail."""
    made = list(marks)
    for index, mark in enumerate(marks):
        for other in marks:
            alike = other is not mark and within(mark.place, other.place, limits.ONE_PLACE_PX)
            if alike and made[index].status == limits.MEASURED:
                made[index] = _failed(mark, messages.MARK_TWICE(other=other.name))
    return made


def _supported(
    marks: Sequence[MarkResult], positions: Mapping[str, GivenPosition], template: MarkShape | CutOut | None
) -> list[MarkResult]:
    """The marks, of which those without a position fail where too few confirm each other: one more is needed where
    pictures hold such figures too."""
    placed = [mark for mark in marks if mark.place is not None]
    count, least = len(placed), limits.MIN_SUPPORT
    if isinstance(template, MarkShape) and template.kind in PLAIN_FIGURES and count:
        alike = float(np.mean([1.0 if mark.correlation is None else mark.correlation for mark in placed]))
        least += alike < SURE_OF_PLAIN
    if count >= least:
        return list(marks)
    reason = messages.MARK_UNSUPPORTED(count=count, least=least)
    return [
        _failed(mark, reason) if mark.status == limits.MEASURED and mark.name not in positions else mark
        for mark in marks
    ]


def _surroundings(
    photo: Photo, marks: Sequence[MarkResult], expected: Mapping[str, Place], template: MarkShape | CutOut | None
) -> dict[str, PhotoView]:
    """The photo around every mark, where it is or should be, for the report."""
    size = template.size if isinstance(template, MarkShape) else max(template.pixels.shape) if template else 0.0
    half = math.ceil(max(size, 2 * MIN_PICTURE_PX) * 0.75)
    places = {mark.name: mark.place or expected.get(mark.name) for mark in marks}
    inside = {name: place for name, place in places.items() if place is not None and photo.contains(place)}
    return {name: window_around(photo, place, half) for name, place in inside.items()}
