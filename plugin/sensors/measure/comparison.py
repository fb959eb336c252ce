"""Every model on the same points: the paper's table, and which model to take."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Callable

import numpy as np

from ...imagery.errors import SeamInspectorError
from ...imagery.message import Message
from . import messages
from .adjustment import Accuracy, accuracy, adjust, without
from .models import bias, registry
from .models.rational import Rational
from .models.registry import Wanted
from .models.sensor_model import Fit
from .points import Points

MIN_CHECK_POINTS = 5  # fewer say little about an error: leave-one-out instead
MAX_LEFT_OUT = 40  # fits of leave-one-out; with more points they are left out in groups
MAX_WORSE = 1.25  # a model that the paper prefers may be this much worse than the best, relative

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
    found = [Wanted(registry.POLYNOMIAL_2D, order) for order in (1, 2, 3)]
    found += [Wanted(registry.POLYNOMIAL_3D, order) for order in (1, 2, 3)]
    found += [Wanted(registry.RATIONAL, order) for order in (1, 2, 3)]
    found += [Wanted(registry.DLT), Wanted(registry.DLT, dlt_xy=True)]
    found += [Wanted(registry.PUSHBROOM, orbit_height_m=orbit_height_m, size=size)]
    if rpc is not None:
        found += [Wanted(registry.RPC_BIAS, bias=kind, rpc=rpc) for kind in (bias.SHIFT, bias.DRIFT, bias.AFFINE)]
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
    few = np.count_nonzero(points.check) < MIN_CHECK_POINTS
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
    turns = min(count, MAX_LEFT_OUT)
    for turn in range(turns):
        yield np.arange(count) % turns == turn


def _rank(wanted: Wanted, flat: bool) -> int:
    """The paper's preference: parametric, vendor's RPC with bias, quotients by their order; plane models if flat."""
    order = {
        registry.PUSHBROOM: 0,
        registry.RPC_BIAS: 1,
        registry.RATIONAL: 1 + wanted.order,
        registry.DLT: 2,
        registry.POLYNOMIAL_3D: 5 + wanted.order,
        registry.POLYNOMIAL_2D: 9 + wanted.order,
    }[wanted.kind]
    return order if flat or wanted.kind != registry.POLYNOMIAL_2D else order + 100


def recommend(rows: Sequence[Row], flat: bool) -> tuple[Row | None, Message]:
    """The model to take, and why: the paper's conclusions 1 to 3 applied to the errors measured.

    Of the models whose error is at most a quarter larger than the smallest one, the one that the paper prefers.
    """
    judged = [row for row in rows if row.errors is not None and row.errors.rmse is not None and row.reason is None]
    sound = [row for row in judged if flat or row.wanted.kind != registry.POLYNOMIAL_2D] or judged
    if not sound:
        return None, messages.NOTHING_TO_RECOMMEND()
    error = {id(row): row.errors.rmse for row in sound if row.errors is not None and row.errors.rmse is not None}
    smallest = min(error.values())
    near = [row for row in sound if error[id(row)] <= MAX_WORSE * smallest]
    chosen = min(near, key=lambda row: (_rank(row.wanted, flat), row.wanted.unknowns, error[id(row)]))
    why = {
        registry.PUSHBROOM: messages.RECOMMEND_PUSHBROOM,
        registry.RPC_BIAS: messages.RECOMMEND_RPC_BIAS,
        registry.RATIONAL: messages.RECOMMEND_RATIONAL,
        registry.DLT: messages.RECOMMEND_DLT,
        registry.POLYNOMIAL_3D: messages.RECOMMEND_POLYNOMIAL_3D,
        registry.POLYNOMIAL_2D: messages.RECOMMEND_POLYNOMIAL_2D,
    }[chosen.wanted.kind]
    return chosen, why(model=chosen.wanted.name, rmse=error[id(chosen)], best=smallest)
