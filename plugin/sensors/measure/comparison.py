"""Every model on the same points: the paper's table, and which model to take."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Callable

import numpy as np

from ...imagery.errors import SeamInspectorError
from ...imagery.message import Message
from . import messages
from .adjustment import Accuracy, accuracy, adjust
from .models import registry
from .models.rational import Rational
from .models.registry import ModelRequest
from .points import Points

MIN_CHECK_POINTS = 5  # fewer say little about an error: leave-one-out instead
MAX_LEFT_OUT = 40  # fits of leave-one-out; with more points they are left out in groups
MAX_WORSE = 1.25  # a model that the paper prefers may be this much worse than the best, relative

CHECK_POINTS, LEAVE_ONE_OUT = "check_points", "leave_one_out"


@dataclass(frozen=True)
class JudgedModel:
    """One model of the table."""

    request: ModelRequest
    errors: Accuracy | None
    """On points that the fit has not seen; None where it could not be fitted."""
    control: Accuracy | None
    """On the control points themselves."""
    control_count: int
    condition: float | None
    reason: Message | None = None
    """Why there are no errors, or why to distrust them."""


@dataclass(frozen=True)
class Comparison:
    """The paper's table."""

    rows: tuple[JudgedModel, ...]
    method: str
    """``check_points`` or ``leave_one_out``."""
    recommended: JudgedModel | None
    reason: Message


def all_requests(rpc: Rational | None, orbit_height_m: float, size: tuple[float, float] | None) -> list[ModelRequest]:
    """Every form of every model, in the paper's order; those that correct a vendor's RPC only where there is one."""
    return [
        kind.request(variant.name, orbit_height_m=orbit_height_m, size=size, rpc=rpc)
        for kind in registry.KINDS.values()
        if rpc is not None or not kind.corrects_rpc
        for variant in kind.variants
    ]


def compare(
    points: Points,
    requests: Sequence[ModelRequest],
    robust: bool,
    flat: bool,
    progress: Callable[[float], None] = lambda share: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> Comparison:
    """Fit every model, judge it on check points, or by leave-one-out where they are fewer than five.

    ``flat`` says whether the terrain moves the image by less than the errors asked for, so that a plane model may do.
    """
    one_by_one = np.count_nonzero(points.check) < MIN_CHECK_POINTS
    rows: list[JudgedModel] = []
    for number, request in enumerate(requests):
        if cancelled():
            break
        rows.append(_judged(request, points, robust, one_by_one, cancelled))
        progress((number + 1) / len(requests))
    best, reason = recommend(rows, flat)
    return Comparison(tuple(rows), LEAVE_ONE_OUT if one_by_one else CHECK_POINTS, best, reason)


def _judged(
    request: ModelRequest, points: Points, robust: bool, one_by_one: bool, cancelled: Callable[[], bool]
) -> JudgedModel:
    count = len(points) if one_by_one else int(np.count_nonzero(~points.check))
    given = replace(points, check=np.zeros(len(points), bool)) if one_by_one else points
    try:
        done = adjust(request, given, robust)
        errors = _left_out_errors(request, given.only(~done.blunder), cancelled) if one_by_one else done.check
    except SeamInspectorError as error:
        return JudgedModel(request, None, None, count, None, error.message)
    fitted = done.fitted
    doubt = None if fitted.converged else messages.NOT_CONVERGED(iterations=fitted.iterations)
    return JudgedModel(request, errors, done.control, done.control.count, fitted.condition, doubt)


def _left_out_errors(request: ModelRequest, points: Points, cancelled: Callable[[], bool]) -> Accuracy | None:
    """The errors of points that were left out of the fit in turn; None when cancelled before the first."""
    px, metres = [], []
    turns = min(len(points), MAX_LEFT_OUT)
    for turn in range(turns):
        if cancelled():
            break
        left_out = np.arange(len(points)) % turns == turn
        done = adjust(request, replace(points, check=left_out))
        px.append(done.residuals_px[left_out])
        metres.append(done.residuals_m[left_out])
    return accuracy(np.concatenate(px), np.concatenate(metres)) if px else None


def recommend(rows: Sequence[JudgedModel], flat: bool) -> tuple[JudgedModel | None, Message]:
    """The model to take, and why: the paper's conclusions 1 to 3 applied to the errors measured.

    Of the models whose error is at most a quarter larger than the smallest one, the one that the paper prefers.
    """
    judged = [row for row in rows if row.errors is not None and _is_number(row.errors.rmse) and row.reason is None]
    sound = [row for row in judged if flat or row.request.needs_heights] or judged
    if not sound:
        return None, messages.NOTHING_TO_RECOMMEND()
    error = {id(row): row.errors.rmse for row in sound if row.errors is not None and row.errors.rmse is not None}
    smallest = min(error.values())
    near = [row for row in sound if error[id(row)] <= MAX_WORSE * smallest]
    chosen = min(near, key=lambda row: (row.request.variant.rank, row.request.variant.unknowns, error[id(row)]))
    why = chosen.request.kind.recommendation
    return chosen, why(model=chosen.request.name, rmse=error[id(chosen)], best=smallest)


def _is_number(error: float | None) -> bool:
    return error is not None and bool(np.isfinite(error))
