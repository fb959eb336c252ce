"""The transformation of a photo's marks, and which of them do not belong."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...imagery.errors import PhotoError
from ...imagery.message import Message
from . import limits, messages
from .orientation import FittedTransformation, MarkResult, MarkStatus
from .transformations import LEAST_MARKS, PlaneModel, fit_transformation, redundancy

CHANCE = 0.001  # that a photo without an outlier has a mark that stands out
TELLING_SHARE = 0.25  # of the limit: 0.05 mm on 23 cm, which film and scanner leave on good photos


def fail_misplaced_marks(marks: Sequence[MarkResult]) -> list[MarkResult]:
    """Marks that can't be where they are, since the others agree without them.

    A photo is its calibration shifted, turned and scaled, but for a thousandth of deformation: a similarity leaves
    two marks' worth of redundancy to four marks, enough to tell which one is off. With three it tells only that one is,
    and marks of which no more than half agree are all in doubt. A place that was given is judged like a measured one.
    """
    placed = [mark for mark in marks if mark.place is not None]
    left, out = placed, dict[str, Message]()
    while len(left) >= 3:
        limit, worst = largest_shift(left), _misfit(left)
        if worst <= limit:
            break
        if len(left) == 3 or 2 * (len(left) - 1) <= len(placed):
            reason = messages.MARKS_DISAGREE(worst=_misfit(placed), limit=limit)
            out = {mark.name: reason for mark in placed}
            break
        suspect = min(left, key=lambda mark: _misfit([other for other in left if other is not mark]))
        left = [mark for mark in left if mark is not suspect]
        out[suspect.name] = _off(suspect, worst, limit)
    return [_failed(mark, out[mark.name]) if mark.name in out else mark for mark in marks]


def largest_shift(marks: Sequence[MarkResult]) -> float:
    """How far a mark may lie from where the others want it, mm: it follows the frame."""
    return limits.FILM_DEFORMATION * float(np.ptp(_pairs(marks)[1], axis=0).max())


def _off(mark: MarkResult, worst: float, limit: float) -> Message:
    if mark.status is MarkStatus.GIVEN:
        return messages.GIVEN_OFF(worst=worst, limit=limit)
    return messages.MARK_OFF(worst=worst, limit=limit)


def _failed(mark: MarkResult, reason: Message) -> MarkResult:
    return replace(mark, status=MarkStatus.FAILED, place=None, reason=reason)


def _misfit(marks: Sequence[MarkResult]) -> float:
    """The largest residual of a similarity, mm."""
    source, target = _pairs(marks)
    try:
        made = fit_transformation(PlaneModel.SIMILARITY, source, target)
    except PhotoError:
        return 0.0
    return float(np.hypot(*(made(source) - target).T).max())


def _pairs(marks: Sequence[MarkResult]) -> tuple[np.ndarray, np.ndarray]:
    return np.array([mark.place for mark in marks], float), np.array([mark.calibrated for mark in marks], float)


def fit_marks(
    marks: Sequence[MarkResult], model: PlaneModel
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
            too_few = messages.TOO_FEW_MARKS(model=messages.WORDS[model.value], least=least, count=count)
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
        marks = [_failed(one, _off(one, shift, limit)) if one is mark else one for one in marks]
    residuals = 1000 * (made(source) - target)
    rms = np.sqrt(np.mean(residuals**2, axis=0))
    left_over = redundancy(model, len(placed))
    fitted = FittedTransformation(made, made.inverse, len(placed), left_over, float(rms[0]), float(rms[1]))
    by_name = {mark.name: (float(x), float(y)) for mark, (x, y) in zip(placed, residuals)}
    if fitted.redundancy < 1:
        notices.append(messages.NO_REDUNDANCY(model=messages.WORDS[model.value], count=len(placed)))
    return fitted, [replace(mark, residual=by_name.get(mark.name)) for mark in marks], notices


def _outlier(marks: Sequence[MarkResult], model: PlaneModel, least: float) -> tuple[MarkResult, float] | None:
    """The mark that stands out most, and how far off (mm, more than ``least``) the others want it; None without one.

    A mark's residual and its distance from where the others alone put it, multiplied, are its share of the sum of
    squares: against the others' own variance it follows F(2, their redundancy), which has this closed form.
    """
    source, target = _pairs(marks)
    residuals = np.hypot(*(fit_transformation(model, source, target)(source) - target).T)
    left_over = redundancy(model, len(marks) - 1)
    critical = left_over / 2 * ((CHANCE / len(marks)) ** (-2 / left_over) - 1)
    found: tuple[float, MarkResult, float] | None = None
    for index, mark in enumerate(marks):
        others = np.arange(len(marks)) != index
        try:
            made = fit_transformation(model, source[others], target[others])
        except PhotoError:
            continue
        off = np.hypot(*(made(source) - target).T)
        variance = float(np.sum(off[others] ** 2)) / left_over
        ratio = residuals[index] * off[index] / 2 / max(variance, 1e-12)
        if off[index] > least and ratio > critical and (found is None or ratio > found[0]):
            found = ratio, mark, float(off[index])
    return None if found is None else found[1:]
