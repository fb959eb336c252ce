"""Sensor models fitted and judged: residuals on control and check points, blunders, and every model side by side."""
from __future__ import annotations

from collections.abc import Sequence
from contextlib import nullcontext, suppress
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any, Callable

import numpy as np

from ...imagery.errors import Message, SeamInspectorError, SensorModelError
from ...imagery.reference_systems import metres_per_unit
from ...imagery.statistics import robust_sigma
from . import limits, messages, registry
from .points import Points
from .polynomials import Rational
from .registry import ModelRequest
from .sensor_model import FittedModel, Scaling, SensorModel, least_squares, locate, reprojected

BLUNDER_PROBABILITY = 0.001  # Baarda: one good point in a thousand is suspected
RAYLEIGH_MEDIAN = 1.1774  # of the length of a vector of two normal coordinates of standard deviation 1
MAX_BLUNDER_SIGMAS = 5.0  # of check points, which the fit has not seen
TUKEY_SIGMAS = 4.685  # biweight, 95 % efficient for normal errors
ROBUST_STEPS = 15  # of each stage; the weights have settled before
MIN_CHECK_POINTS = 5  # fewer say little about an error: leave-one-out instead
MAX_LEFT_OUT = 40  # fits of leave-one-out; with more points they are left out in groups
LEFT_OUT_GROUPS = 10  # of control points beside check points
MAX_STANDARD_ERRORS = 1.0  # by which a model of fewer unknowns may be worse (the rule of Breiman et al. 1984)
MAX_CONDITION = 1e12  # float64 keeps four digits of the unknowns
CHECK_POINTS, LEAVE_ONE_OUT = "check_points", "leave_one_out"


def fit_model(request: ModelRequest, points: Points, weights: np.ndarray) -> FittedModel:
    """Fit to points of weights (n,), 1 / standard deviation, px; 0 for none. Raises SensorModelError, SettingsError."""
    used = weights > 0
    points, weights = points.only(used), weights[used]
    fewest = request.variant.fewest
    if len(points) < fewest:
        raise SensorModelError(messages.TOO_FEW_POINTS(model=request.name, count=len(points), fewest=fewest))
    _check_spread(request, points)
    system = request.kind.model_class().ground_system(points.wkt)
    points = replace(points, ground=reprojected(points.ground, points.wkt, system), wkt=system)
    return request.kind.fit(request, points, weights)


def _check_spread(request: ModelRequest, points: Points) -> None:
    """Refuse points that leave the linear part of a model open: on a line, or on a plane where Z has terms."""
    if request.variant.fewest < 3:
        return  # a model of so few points asks for no extent
    in_image = request.kind.corrects_rpc
    places = points.image if in_image else points.ground

    def is_open(axes: int) -> bool:
        linear = np.column_stack([np.ones(len(places)), Scaling.of(places).to(places)[:, :axes]])
        return least_squares(linear, places[:, 0])[1] > limits.MAX_LINEAR_CONDITION

    if is_open(2):
        raise SensorModelError(messages.POINTS_ON_A_LINE(model=request.name))
    if request.needs_heights and not in_image and is_open(3):
        raise SensorModelError(messages.POINTS_ON_A_PLANE(model=request.name))


@dataclass(frozen=True)
class Accuracy:
    """Errors of a group of points, m on the ground; None where the group is empty."""

    count: int
    rmse_x: float | None
    rmse_y: float | None
    max_x: float | None
    max_y: float | None
    rmse_column: float | None  # px
    rmse_row: float | None  # px

    @property
    def rmse(self) -> float | None:
        """Root mean square error of both coordinates together, m."""
        return None if self.rmse_x is None or self.rmse_y is None else float(np.hypot(self.rmse_x, self.rmse_y))


@dataclass(frozen=True)
class Adjustment:
    """A model fitted to control points and judged on all."""

    request: ModelRequest  # the model that was asked for
    points: Points  # control and check points
    fitted: FittedModel  # to the control points that are no blunders
    residuals_px: np.ndarray  # (n, 2) model minus measured: column, row
    residuals_m: np.ndarray  # (n, 2) model minus given, at the point's height: x, y; by its slope where it is bent
    blunder: np.ndarray  # (n,) bool
    sigma_px: float  # of a control point's coordinate, from residuals and redundancy; NaN without any

    @property
    def control(self) -> Accuracy:
        return accuracy(self.residuals_px, self.residuals_m, ~self.points.check & ~self.blunder)

    @property
    def check(self) -> Accuracy:
        return accuracy(self.residuals_px, self.residuals_m, self.points.check & ~self.blunder)

    @property
    def notices(self) -> list[Message]:
        """What makes it doubtful."""
        fitted, doubts = self.fitted, []
        if not fitted.converged:
            doubts.append(messages.NOT_CONVERGED(iterations=fitted.iterations))
        if fitted.condition > MAX_CONDITION:
            doubts.append(messages.ILL_CONDITIONED(condition=fitted.condition))
        if self.check.count == 0:
            doubts.append(messages.CHECK_POINTS_MISSING())
        if names := self.points.named(self.blunder):
            doubts.append(messages.BLUNDERS_FOUND(count=len(names), names=", ".join(names[:20])))
        elif names := self.points.named(suspects(self)):
            doubts.append(messages.BLUNDERS_POSSIBLE(count=len(names), names=", ".join(names[:20])))
        return doubts


def accuracy(residuals_px: np.ndarray, residuals_m: np.ndarray, group: np.ndarray | slice = slice(None)) -> Accuracy:
    """Root mean squares and maxima of (n, 2) residuals in px and in m, all or a group."""
    residuals_px, residuals_m = residuals_px[group], residuals_m[group]
    if not len(residuals_m):
        return Accuracy(0, None, None, None, None, None, None)
    rmse_m, rmse_px = (np.sqrt(np.mean(residuals**2, axis=0)) for residuals in (residuals_m, residuals_px))
    return Accuracy(len(residuals_m), *map(float, (*rmse_m, *np.abs(residuals_m).max(axis=0), *rmse_px)))


def adjust(request: ModelRequest, points: Points, robust: bool = False) -> Adjustment:
    """Fit a model to the control points and judge it on all. ``robust`` looks for blunders: least absolute residuals,
    Tukey's biweight, a test of each point. Raises SensorModelError where points are too few or determine nothing."""
    control = points.only(~points.check)
    if not np.isfinite(points.ground[:, : 3 if request.needs_heights else 2]).all():
        raise SensorModelError(messages.NO_HEIGHTS(model=request.name))
    kept = _without_blunders(request, control) if robust else np.ones(len(control), bool)
    fitted = fit_model(request, control, control.weights * kept)
    blunder = np.zeros(len(points), bool)
    blunder[~points.check] = ~kept
    residuals_px = project(fitted, points) - points.image
    if not np.isfinite(residuals_px).all():
        raise SensorModelError(messages.NOT_INVERTED())
    weighted = residuals_px[~points.check][kept] * _relative(control)[kept, None]
    redundancy = weighted.size - fitted.unknowns
    sigma = float(np.sqrt(np.sum(weighted**2) / redundancy)) if redundancy > 0.5 else np.nan
    if robust and points.check.any():
        checks = residuals_px[points.check]
        usual = max(robust_sigma(checks), np.nan_to_num(sigma), limits.MIN_SIGMA_PX)  # of the others, and as expected
        blunder[points.check] = np.abs(checks).max(axis=1) > MAX_BLUNDER_SIGMAS * usual
    metres, heights = metres_per_unit(points.wkt, points.ground.mean(axis=0)), np.nan_to_num(points.ground[:, 2])
    seen = partial(_seen, fitted.model, points.wkt)
    places = locate(seen, points.image, heights, points.ground[:, :2], metres, partly=True)
    residuals_m = (places - points.ground[:, :2]) * metres
    return Adjustment(request, points, fitted, residuals_px, residuals_m, blunder, sigma)


def project(fitted: FittedModel, points: Points) -> np.ndarray:
    """The places (n, 2), column and row, where a model sees points."""
    return _seen(fitted.model, points.wkt, np.where(np.isfinite(points.ground), points.ground, 0.0))


def _seen(model: SensorModel, wkt: str, ground: np.ndarray) -> np.ndarray:
    return model.project(reprojected(ground, wkt, model.ground_system(wkt)))


def _relative(points: Points) -> np.ndarray:
    """(n,) weights of points relative to their median: residuals times these are alike."""
    return points.weights / np.median(points.weights)


def _without_blunders(request: ModelRequest, control: Points) -> np.ndarray:
    """(n,) bool: which control points pass."""
    base, relative = control.weights, _relative(control)

    def residuals_of(weights: np.ndarray) -> tuple[np.ndarray, float]:
        """Residuals (n, 2), in standard deviations of a usual point, and the redundancy."""
        fitted = fit_model(request, control, weights)
        residuals = (project(fitted, control) - control.image) * relative[:, None]
        return residuals, 2 * int(np.count_nonzero(weights)) - fitted.unknowns

    residuals, redundancy = residuals_of(base)
    if redundancy < 2:
        return np.ones(len(control), bool)  # nothing to tell a blunder by
    for _ in range(ROBUST_STEPS):  # least absolute residuals
        size = np.linalg.norm(residuals, axis=1)
        floor = max(limits.MIN_SIGMA_PX, 1e-3 * float(np.median(size)))
        residuals, redundancy = residuals_of(base / np.sqrt(np.maximum(size, floor)))
    for _ in range(ROBUST_STEPS):  # Tukey's biweight
        reach = TUKEY_SIGMAS * _robust_sigma(residuals, redundancy)
        share = np.minimum(np.linalg.norm(residuals, axis=1) / reach, 0.999)
        residuals, redundancy = residuals_of(base * (1 - share**2))
    sigma = _robust_sigma(residuals, redundancy)
    kept = np.linalg.norm(residuals, axis=1) <= _blunder_limit(redundancy) * sigma
    for _ in range(ROBUST_STEPS):
        if np.count_nonzero(kept) <= request.variant.fewest:
            raise SensorModelError(messages.TOO_MANY_BLUNDERS(model=request.name, count=int(np.count_nonzero(~kept))))
        residuals, redundancy = residuals_of(base * kept)
        if redundancy < 2:
            break
        # It only shrinks: else one blunder let in would open the door to the next.
        sigma = max(min(sigma, float(np.sqrt(np.sum(residuals[kept] ** 2) / redundancy))), limits.MIN_SIGMA_PX)
        # The fit gives way to the points in it, and is not exact where the others are: on average by this much.
        share = 1 - redundancy / (2 * int(np.count_nonzero(kept)))
        usual = sigma * np.sqrt(np.where(kept, max(1 - share, 0.0), 1 + share))
        passing = np.linalg.norm(residuals, axis=1) <= _blunder_limit(redundancy) * usual
        if np.array_equal(passing, kept):
            break
        kept = passing
    return kept


def _blunder_limit(redundancy: float) -> float:
    """The longest residual of a good point, in standard deviations: half its square is F-distributed."""
    return float(np.sqrt(redundancy * (BLUNDER_PROBABILITY ** (-2 / redundancy) - 1)))


def _robust_sigma(residuals: np.ndarray, redundancy: float) -> float:
    """Sigma of a coordinate, from the median length of residuals, those that the fit can bring to zero set aside."""
    ordered = np.sort(np.linalg.norm(residuals, axis=1))
    rest = ordered[min(round(len(ordered) - redundancy / 2), len(ordered) - 1) :]
    return max(float(np.median(rest)) / RAYLEIGH_MEDIAN, limits.MIN_SIGMA_PX)


def suspects(done: Adjustment) -> np.ndarray:
    """(n,) bool: control points that miss the model by far more than most of them do, blunders perhaps."""
    control, size = ~done.points.check & ~done.blunder, np.linalg.norm(done.residuals_px, axis=1)
    usual = float(np.median(size[control])) / RAYLEIGH_MEDIAN if control.any() else 0.0
    return np.asarray(control & (size > MAX_BLUNDER_SIGMAS * max(usual, limits.MIN_SIGMA_PX)))


@dataclass(frozen=True)
class JudgedModel:
    request: ModelRequest
    errors: Accuracy | None  # on points that the fit has not seen; None where it could not be fitted
    control: Accuracy | None  # on the control points themselves
    control_count: int
    condition: float | None
    reason: Message | None = None  # why there are no errors, or why to distrust them
    misses: np.ndarray = field(default_factory=lambda: np.zeros(0))  # (n,) m, of points unseen by a fit; NaN: blunders
    unknowns: float = 0.0  # how many the points have determined


@dataclass(frozen=True)
class Comparison:
    """The paper's table."""

    rows: tuple[JudgedModel, ...]
    method: str  # ``check_points`` or ``leave_one_out``
    recommended: JudgedModel | None
    reason: Message


def all_requests(rpc: Rational | None, orbit_height_m: float, size: tuple[float, float] | None) -> list[ModelRequest]:
    """Every form of every model, in the paper's order; those that correct a vendor's RPC only where there is one."""
    kinds = [kind for kind in registry.KINDS.values() if rpc is not None or not kind.corrects_rpc]
    options: dict[str, Any] = {"orbit_height_m": orbit_height_m, "size": size, "rpc": rpc}
    return [kind.request(variant.name, **options) for kind in kinds for variant in kind.variants]


def compare(
    points: Points, requests: Sequence[ModelRequest], robust: bool, flat: bool,
    progress: Callable[[float], None] = lambda share: None, cancelled: Callable[[], bool] = lambda: False,
) -> Comparison:
    """Fit every model and judge it on check points, by leave-one-out where they are fewer than five. ``flat``: whether
    the terrain lets a plane model do."""
    one_by_one = np.count_nonzero(points.check) < MIN_CHECK_POINTS
    rows: list[JudgedModel] = []
    for request in requests:
        if cancelled():
            break
        rows.append(_judged(request, points, robust, one_by_one, cancelled))
        progress(len(rows) / len(requests))
    best, reason = recommend(rows, flat)
    return Comparison(tuple(rows), LEAVE_ONE_OUT if one_by_one else CHECK_POINTS, best, reason)


def _judged(
    request: ModelRequest, points: Points, robust: bool, one_by_one: bool, cancelled: Callable[[], bool]
) -> JudgedModel:
    given = replace(points, check=np.zeros(len(points), bool)) if one_by_one else points
    control = int(np.count_nonzero(~given.check))
    try:
        done = adjust(request, given, robust)
        unseen = given.check & ~done.blunder
        residuals = done.residuals_px, done.residuals_m
        px, metres = (np.where(unseen[:, None], values, np.nan) for values in residuals)
        with nullcontext() if one_by_one else suppress(SeamInspectorError):  # fewer points may be too few
            _leave_out(request, given, ~given.check & ~done.blunder, px, metres, cancelled)
    except SeamInspectorError as error:
        return JudgedModel(request, None, None, control, None, error.message)
    judging = np.isfinite(metres).all(axis=1) if one_by_one else unseen
    errors = accuracy(px, metres, judging) if judging.any() else None
    fitted = done.fitted
    doubt = None if fitted.converged else messages.NOT_CONVERGED(iterations=fitted.iterations)
    return JudgedModel(
        request, errors, done.control, done.control.count, fitted.condition, doubt, np.linalg.norm(metres, axis=1),
        fitted.unknowns,
    )


def _leave_out(
    request: ModelRequest, points: Points, used: np.ndarray, px: np.ndarray, metres: np.ndarray,
    cancelled: Callable[[], bool],
) -> None:
    """Put the residuals of the ``used`` control points, each left out of the fit in turn, into (n, 2) px and m."""
    seen = np.flatnonzero(used)
    turns = min(len(seen), LEFT_OUT_GROUPS if points.check.any() else MAX_LEFT_OUT)
    for turn in range(turns):
        if cancelled():
            break
        left_out = np.arange(len(seen)) % turns == turn
        done = adjust(request, replace(points.only(used), check=left_out))
        px[seen[left_out]], metres[seen[left_out]] = done.residuals_px[left_out], done.residuals_m[left_out]


def recommend(rows: Sequence[JudgedModel], flat: bool) -> tuple[JudgedModel | None, Message]:
    """The model to take, and why: of those whose errors on the same points are not worse than the best's by more than
    chance the one of fewest unknowns, then the one that the paper prefers; plane ones on ``flat`` ground only."""
    judged = [(row.errors.rmse, row) for row in rows if row.errors is not None and row.reason is None]
    known = [(error, row) for error, row in judged if error is not None and np.isfinite(error)]
    sound = [(error, row) for error, row in known if flat or row.request.needs_heights] or known
    if not sound:
        return None, messages.NOTHING_TO_RECOMMEND()
    smallest, best = min(sound, key=lambda judged: judged[0])
    near = [(round(row.unknowns), row.request.variant.rank, error, row) for error, row in sound
            if row is best or _is_as_good(row, best)]  # fmt: skip
    *_, error, chosen = min(near, key=lambda ranked: ranked[:3])
    why = chosen.request.kind.recommendation()
    return chosen, messages.RECOMMENDED(model=chosen.request.name, rmse=error, best=smallest, why=why)


def _is_as_good(row: JudgedModel, best: JudgedModel) -> bool:
    """Whether a model's squared errors exceed another's by no more than the standard error of their differences."""
    worse = row.misses**2 - best.misses**2
    worse = worse[np.isfinite(worse)]
    return len(worse) > 1 and bool(worse.mean() <= MAX_STANDARD_ERRORS * worse.std(ddof=1) / np.sqrt(len(worse)))
