"""The transformation of a photo's marks, and which of them do not belong."""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...imagery.errors import PhotoError
from ...imagery.message import Message
from . import limits, messages
from .orientation import FittedTransformation, MarkResult, MarkStatus
from .transformations import LEAST_MARKS, PlaneModel, fit_transformation, redundancy

OUTLIER_RATIO = 5.0  # of the others' standard deviation: with a redundancy of two, one in a thousand by chance
MIN_OUTLIER_MM = 0.05  # film and scanner leave up to that on good photos


def fail_misplaced_marks(marks: Sequence[MarkResult], model: PlaneModel) -> tuple[list[MarkResult], list[Message]]:
    """Marks that can't be where they are, since the others agree without them.

    A photo is its calibration shifted, turned and scaled, but for a thousandth of deformation: a similarity leaves
    two marks' worth of redundancy to four marks, enough to tell which one is off. With three it tells only that one is.
    """
    placed = [mark for mark in marks if mark.place is not None]
    notices: list[Message] = []
    out: dict[str, Message] = {}
    while len(placed) - len(out) >= 3:
        left = [mark for mark in placed if mark.name not in out]
        # how far a mark may lie from where a similarity puts it, mm
        limit = limits.FILM_DEFORMATION * float(np.ptp(_pairs(left)[1], axis=0).max())
        worst = _misfit(left)
        if worst <= limit:
            break
        trials = [(_misfit([other for other in left if other is not mark]), mark) for mark in left]
        misfit, suspect = min(trials, key=lambda trial: trial[0])
        if len(left) == 3 or misfit > limit:
            reason = messages.MARKS_DISAGREE(worst=worst, limit=limit)
            out.update({mark.name: reason for mark in left if mark.status is MarkStatus.MEASURED})
            break
        if suspect.status is MarkStatus.GIVEN:
            notices.append(messages.GIVEN_IS_OFF(mark=suspect.name, worst=worst))
            break
        out[suspect.name] = messages.MARK_OFF(worst=worst, limit=limit)
    return [
        replace(mark, status=MarkStatus.FAILED, place=None, reason=out[mark.name]) if mark.name in out else mark
        for mark in marks
    ], notices


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

    A mark is left out as an outlier where the others, without it, predict another place for it: only with enough
    marks to leave a redundancy of two. (An affine transformation of four marks has two, and without one of them
    none: there the residuals say how well the four agree, never which is wrong.)
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
        suspect = _outlier(placed, model) if redundancy(model, len(placed) - 1) >= 2 else None
        if suspect is None:
            break
        index, shift = suspect
        if placed[index].status is MarkStatus.GIVEN:
            notices.append(messages.GIVEN_IS_OFF(mark=placed[index].name, worst=shift))
            break
        reason = messages.MARK_OFF(worst=shift, limit=MIN_OUTLIER_MM)
        marks[marks.index(placed[index])] = replace(placed[index], status=MarkStatus.FAILED, place=None, reason=reason)
    residuals = 1000 * (made(source) - target)
    rms = np.sqrt(np.mean(residuals**2, axis=0))
    left_over = redundancy(model, len(placed))
    fitted = FittedTransformation(made, made.inverse, len(placed), left_over, float(rms[0]), float(rms[1]))
    by_name = {mark.name: (float(x), float(y)) for mark, (x, y) in zip(placed, residuals)}
    if fitted.redundancy < 1:
        notices.append(messages.NO_REDUNDANCY(model=messages.WORDS[model.value], count=len(placed)))
    return fitted, [replace(mark, residual=by_name.get(mark.name)) for mark in marks], notices


def _outlier(marks: Sequence[MarkResult], model: PlaneModel) -> tuple[int, float] | None:
    """The mark that the others put elsewhere, and how far, mm; None where all agree."""
    found: tuple[float, int, float] | None = None
    for index in range(len(marks)):
        others = [mark for mark in marks if mark is not marks[index]]
        source, target = _pairs(others)
        try:
            made = fit_transformation(model, source, target)
        except PhotoError:
            continue
        spread = math.sqrt(float(np.sum((made(source) - target) ** 2)) / redundancy(model, len(others)))
        own, aim = _pairs([marks[index]])
        shift = float(np.hypot(*(made(own) - aim)[0]))
        ratio = shift / max(spread, MIN_OUTLIER_MM / OUTLIER_RATIO)
        if ratio > OUTLIER_RATIO and (found is None or ratio > found[0]):
            found = ratio, index, shift
    return None if found is None else found[1:]
