"""Every model on the same points: the paper's table, and which model to take."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Callable

import numpy as np

from .. import messages, thresholds
from ..errors import SeamInspectorError
from ..messages import Message
from . import bias, kinds
from .adjustment import Accuracy, accuracy, adjust, without
from .fitted import Fit
from .kinds import Wanted
from .points import Points
from .rational import Rational

CHECK_POINTS, LEAVE_ONE_OUT = "check_points", "leave_one_out"


@dataclass(frozen=True)
class Row:
    """One model of the table."""

    wanted: Wanted
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

    rows: tuple[Row, ...]
    method: str
    """``check_points`` or ``leave_one_out``."""
    recommended: Row | None
    reason: Message


def candidates(rpc: Rational | None, orbit_height_m: float, size: tuple[float, float] | None) -> list[Wanted]:
    """All models, in the paper's order; those with a vendor's RPC only where there is one."""
    found = [Wanted(kinds.POLYNOMIAL_2D, order) for order in (1, 2, 3)]
    found += [Wanted(kinds.POLYNOMIAL_3D, order) for order in (1, 2, 3)]
    found += [Wanted(kinds.RATIONAL, order) for order in (1, 2, 3)]
    found += [Wanted(kinds.DLT), Wanted(kinds.DLT, dlt_xy=True)]
    found += [Wanted(kinds.PUSHBROOM, orbit_height_m=orbit_height_m, size=size)]
    if rpc is not None:
        found += [Wanted(kinds.RPC_BIAS, bias=kind, rpc=rpc) for kind in (bias.SHIFT, bias.DRIFT, bias.AFFINE)]
    return found


def compare(
    points: Points,
    wanted: Sequence[Wanted],
    robust: bool,
    flat: bool,
    progress: Callable[[float], None] = lambda share: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> Comparison:
    """Fit every model, judge it on check points, or by leave-one-out where they are fewer than five.

    ``flat`` says whether the terrain moves the image by less than the errors asked for, so that a plane model may do.
    """
    few = np.count_nonzero(points.check) < thresholds.MIN_CHECK_POINTS
    rows: list[Row] = []
    for number, one in enumerate(wanted):
        if cancelled():
            break
        rows.append(_row(one, points, robust, few, cancelled))
        progress((number + 1) / len(wanted))
    best, reason = recommend(rows, flat)
    return Comparison(tuple(rows), LEAVE_ONE_OUT if few else CHECK_POINTS, best, reason)


def _row(wanted: Wanted, points: Points, robust: bool, few: bool, cancelled: Callable[[], bool]) -> Row:
    count = len(points) if few else int(np.count_nonzero(~points.check))
    try:
        if not few:
            done = adjust(wanted, points, robust)
            return Row(wanted, done.check, done.control, done.control.count, done.fit.condition, _doubt(done.fit))
        everyone = replace(points, check=np.zeros(len(points), bool))
        done = adjust(wanted, everyone, robust)
        good = everyone.only(~done.blunder)
        px, metres = [], []
        for group in _groups(len(good)):
            if cancelled():
                break
            one = adjust(wanted, without(good, group))
            px.append(one.residuals_px[group])
            metres.append(one.residuals_m[group])
        errors = accuracy(np.concatenate(px), np.concatenate(metres)) if px else None
        return Row(wanted, errors, done.control, done.control.count, done.fit.condition, _doubt(done.fit))
    except SeamInspectorError as error:
        return Row(wanted, None, None, count, None, error.message)


def _doubt(fit: Fit) -> Message | None:
    return None if fit.converged else messages.NOT_CONVERGED(iterations=fit.iterations)


def _groups(count: int) -> Iterator[np.ndarray]:
    """Masks (n,) of the points left out in turn."""
    turns = min(count, thresholds.MAX_LEFT_OUT)
    for turn in range(turns):
        yield np.arange(count) % turns == turn


def _rank(wanted: Wanted, flat: bool) -> int:
    """The paper's preference: parametric, vendor's RPC with bias, quotients by their order; plane models if flat."""
    order = {
        kinds.PUSHBROOM: 0,
        kinds.RPC_BIAS: 1,
        kinds.RATIONAL: 1 + wanted.order,
        kinds.DLT: 2,
        kinds.POLYNOMIAL_3D: 5 + wanted.order,
        kinds.POLYNOMIAL_2D: 9 + wanted.order,
    }[wanted.kind]
    return order if flat or wanted.kind != kinds.POLYNOMIAL_2D else order + 100


def recommend(rows: Sequence[Row], flat: bool) -> tuple[Row | None, Message]:
    """The model to take, and why: the paper's conclusions 1 to 3 applied to the errors measured.

    Of the models whose error is at most a quarter larger than the smallest one, the one that the paper prefers.
    """
    judged = [row for row in rows if row.errors is not None and row.errors.rmse is not None and row.reason is None]
    sound = [row for row in judged if flat or row.wanted.kind != kinds.POLYNOMIAL_2D] or judged
    if not sound:
        return None, messages.NOTHING_TO_RECOMMEND()
    error = {id(row): row.errors.rmse for row in sound if row.errors is not None and row.errors.rmse is not None}
    smallest = min(error.values())
    near = [row for row in sound if error[id(row)] <= thresholds.MAX_WORSE * smallest]
    chosen = min(near, key=lambda row: (_rank(row.wanted, flat), row.wanted.unknowns, error[id(row)]))
    why = {
        kinds.PUSHBROOM: messages.RECOMMEND_PUSHBROOM,
        kinds.RPC_BIAS: messages.RECOMMEND_RPC_BIAS,
        kinds.RATIONAL: messages.RECOMMEND_RATIONAL,
        kinds.DLT: messages.RECOMMEND_DLT,
        kinds.POLYNOMIAL_3D: messages.RECOMMEND_POLYNOMIAL_3D,
        kinds.POLYNOMIAL_2D: messages.RECOMMEND_POLYNOMIAL_2D,
    }[chosen.wanted.kind]
    return chosen, why(model=chosen.wanted.name, rmse=error[id(chosen)], best=smallest)
