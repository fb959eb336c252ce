"""A fit judged: residuals in the image and on the ground, on control and on check points, with or without blunders."""
from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .. import messages, thresholds
from ..errors import SensorModelError
from . import kinds
from .fitted import Fit
from .ground import Frame
from .kinds import Wanted
from .locating import locate
from .points import Points


@dataclass(frozen=True)
class Accuracy:
    """Errors of a group of points, m on the ground; None where the group is empty."""

    count: int
    rmse_x: float | None
    rmse_y: float | None
    max_x: float | None
    max_y: float | None
    rmse_column: float | None
    """px, as the next."""
    rmse_row: float | None

    @property
    def rmse(self) -> float | None:
        """Of both coordinates together, m."""
        if self.rmse_x is None or self.rmse_y is None:
            return None
        return float(np.hypot(self.rmse_x, self.rmse_y))


@dataclass(frozen=True)
class Adjustment:
    """A model fitted to control points and judged on all."""

    wanted: Wanted
    points: Points
    fit: Fit
    residuals_px: np.ndarray
    """(n, 2) model minus measured: column, row."""
    residuals_m: np.ndarray
    """(n, 2) model minus given, at the point's height: x, y."""
    blunder: np.ndarray
    """(n,) bool."""
    sigma_px: float
    """Standard deviation of a control point's coordinate, from the residuals and the redundancy; NaN without any."""

    @property
    def control(self) -> Accuracy:
        """Of the control points that took part."""
        return self._accuracy(~self.points.check & ~self.blunder)

    @property
    def check(self) -> Accuracy:
        """Of the check points that are no blunders."""
        return self._accuracy(self.points.check & ~self.blunder)

    def _accuracy(self, group: np.ndarray) -> Accuracy:
        return accuracy(self.residuals_px[group], self.residuals_m[group])


def accuracy(residuals_px: np.ndarray, residuals_m: np.ndarray) -> Accuracy:
    """Root mean squares and maxima of (n, 2) residuals in px and in m."""
    if not len(residuals_m):
        return Accuracy(0, None, None, None, None, None, None)
    rmse_m, rmse_px = np.sqrt(np.mean(residuals_m**2, axis=0)), np.sqrt(np.mean(residuals_px**2, axis=0))
    largest = np.abs(residuals_m).max(axis=0)
    return Accuracy(len(residuals_m), *map(float, (*rmse_m, *largest, *rmse_px)))


def adjust(wanted: Wanted, points: Points, robust: bool = False) -> Adjustment:
    """Fit a model to the control points and judge it on all.

    ``robust`` looks for blunders: least absolute residuals first, then Tukey's biweight, then a test of each point;
    the model is fitted to those that pass. Raises SensorModelError where points are too few or determine nothing.
    """
    control = points.only(~points.check)
    needed = points.ground if wanted.spatial else points.ground[:, :2]
    if not np.isfinite(needed).all():
        raise SensorModelError(messages.NO_HEIGHTS(model=wanted.name))
    if len(control) < wanted.fewest:
        raise SensorModelError(messages.TOO_FEW_POINTS(model=wanted.name, count=len(control), fewest=wanted.fewest))
    kept = _without_blunders(wanted, control) if robust else np.ones(len(control), bool)
    fitted = kinds.fit(wanted, control, control.weights * kept)
    blunder = np.zeros(len(points), bool)
    blunder[~points.check] = ~kept
    residuals_px = project(fitted, points) - points.image
    if not np.isfinite(residuals_px).all():
        raise SensorModelError(messages.NOT_INVERTED())
    sigma = _sigma(wanted, residuals_px[~points.check][kept] * _relative(control)[kept, None])
    if robust and points.check.any():
        blunder[points.check] = _check_blunders(residuals_px[points.check], sigma)
    return Adjustment(wanted, points, fitted, residuals_px, _on_ground(fitted, points), blunder, sigma)


def project(fitted: Fit, points: Points) -> np.ndarray:
    """Where a model sees points: (n, 2) column, row."""
    ground = np.where(np.isfinite(points.ground), points.ground, 0.0)
    return fitted.model.project(Frame(points.wkt).to_geographic(ground) if fitted.model.GEOGRAPHIC else ground)


def _on_ground(fitted: Fit, points: Points) -> np.ndarray:
    """(n, 2) m along x and y: where the model puts the measured image point, at the point's height, minus given.

    Where a model is too bent to be inverted, what its slope at the point makes of the residual in the image.
    """
    frame = Frame(points.wkt)
    metres = frame.metres(float(np.mean(points.ground[:, 1])))
    heights = np.nan_to_num(points.ground[:, 2])
    given = points.ground[:, :2]

    def seen(ground: np.ndarray) -> np.ndarray:
        return fitted.model.project(frame.to_geographic(ground) if fitted.model.GEOGRAPHIC else ground)

    step = (1 / metres[0], 1 / metres[1])
    found = locate(seen, points.image, heights, given, step, partly=True)
    bent = ~np.isfinite(found).all(axis=1)
    found[bent] = locate(seen, points.image[bent], heights[bent], given[bent], step, partly=True, steps=1)
    return (found - given) * metres


def _relative(points: Points) -> np.ndarray:
    """(n,) weights of points relative to their median: residuals times these are alike."""
    return points.weights / np.median(points.weights)


def _sigma(wanted: Wanted, residuals: np.ndarray) -> float:
    redundancy = residuals.size - wanted.unknowns
    return float(np.sqrt(np.sum(residuals**2) / redundancy)) if redundancy > 0 else float("nan")


def _without_blunders(wanted: Wanted, control: Points) -> np.ndarray:
    """(n,) bool: which control points pass."""
    everyone = np.ones(len(control), bool)
    if 2 * len(control) - wanted.unknowns < 2:
        return everyone  # nothing to tell a blunder by
    base, relative = control.weights, _relative(control)

    def residuals(weights: np.ndarray) -> np.ndarray:
        return (project(kinds.fit(wanted, control, weights), control) - control.image) * relative[:, None]

    found = residuals(base)
    for _ in range(thresholds.ROBUST_STEPS):  # least absolute residuals
        size = np.linalg.norm(found, axis=1)
        floor = max(thresholds.MIN_SIGMA_PX, 1e-3 * float(np.median(size)))
        found = residuals(base / np.sqrt(np.maximum(size, floor)))
    for _ in range(thresholds.ROBUST_STEPS):  # Tukey's biweight
        reach = thresholds.TUKEY_SIGMAS * _robust_sigma(wanted, found)
        share = np.minimum(np.linalg.norm(found, axis=1) / reach, 0.999)
        found = residuals(base * (1 - share**2))
    kept = np.abs(found).max(axis=1) <= thresholds.BLUNDER_SIGMAS * _robust_sigma(wanted, found)
    for _ in range(thresholds.ROBUST_STEPS):
        if np.count_nonzero(kept) <= wanted.fewest:
            raise SensorModelError(messages.TOO_MANY_BLUNDERS(model=wanted.name, count=np.count_nonzero(~kept)))
        found = residuals(base * kept)
        sigma = max(_sigma(wanted, found[kept]), thresholds.MIN_SIGMA_PX)
        passing = np.abs(found).max(axis=1) <= thresholds.BLUNDER_SIGMAS * sigma
        if np.array_equal(passing, kept):
            break
        kept = passing
    return kept


def _robust_sigma(wanted: Wanted, residuals: np.ndarray) -> float:
    """From the median absolute residual, those that the fit can bring to zero set aside."""
    ordered = np.sort(np.abs(residuals).ravel())
    rest = ordered[min(wanted.unknowns, len(ordered) - 2) :]
    return max(1.4826 * float(np.median(rest)), thresholds.MIN_SIGMA_PX)


def _check_blunders(residuals: np.ndarray, sigma: float) -> np.ndarray:
    """(n,) bool: check points that differ from the others as well as from what the control points let expect."""
    usual = 1.4826 * float(np.median(np.abs(residuals)))
    limit = thresholds.MAX_BLUNDER_SIGMAS * max(usual, np.nan_to_num(sigma), thresholds.MIN_SIGMA_PX)
    return np.abs(residuals).max(axis=1) > limit


def without(points: Points, left_out: np.ndarray) -> Points:
    """All points as control, but for those of a mask, which only judge."""
    return replace(points, check=left_out)
