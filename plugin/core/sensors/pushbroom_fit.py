"""Fitting the parametric model: a nominal orbit from the points' affine camera, then an adjustment with priors."""
from __future__ import annotations

from dataclasses import replace

import numpy as np

from .. import messages, thresholds
from ..errors import SensorModelError
from .earth import geocentric, unit
from .fitted import Fit
from .pushbroom import SIGMAS, Orbit, Pushbroom
from .solve import least_squares


def fit_pushbroom(
    ground: np.ndarray, image: np.ndarray, weights: np.ndarray, orbit_height_m: float, estimate_sigma: bool = True
) -> Fit:
    """Adjust the parametric model to points and to its priors.

    ``ground`` (n, 3) longitude, latitude in degrees and ellipsoidal height in m; ``image`` (n, 2) column, row;
    ``weights`` (n,) 1 / standard deviation in px. With ``estimate_sigma`` the weights are relative: their common
    factor is estimated from the residuals (variance components), so that exact points are followed exactly and noisy
    ones are not. Raises SensorModelError when the adjustment does not converge or the points lie on a plane.
    """
    places = geocentric(ground)
    model = Pushbroom(_nominal_orbit(places, image, orbit_height_m), np.zeros(len(SIGMAS)))
    sigma_px = 1 / np.maximum(weights, np.finfo(float).tiny)
    if estimate_sigma:
        sigma_px = sigma_px * thresholds.DEFAULT_SIGMA_PX / np.median(sigma_px)
    iterations, factor = 0, 1.0
    for _ in range(thresholds.MAX_SIGMA_ROUNDS if estimate_sigma else 1):
        model, condition, taken, converged = _adjusted(model, places, image, sigma_px * factor)
        iterations += taken
        if not estimate_sigma:
            break
        before, factor = factor, _variance_factor(model, places, image, sigma_px, factor)
        if abs(factor / before - 1) < thresholds.MAX_SIGMA_CHANGE:
            break
    return Fit(model, condition, iterations, converged)


def _adjusted(
    model: Pushbroom, places: np.ndarray, image: np.ndarray, sigma_px: np.ndarray
) -> tuple[Pushbroom, float, int, bool]:
    """The model after Gauss and Newton's iteration, its condition, the iterations and whether they converged."""
    weights = np.repeat(1 / sigma_px, 2)
    for iteration in range(1, thresholds.MAX_PUSHBROOM_ITERATIONS + 1):
        residuals, jacobian = _linearised(model, places, image)
        design = np.vstack([jacobian * weights[:, None], np.eye(len(SIGMAS))])
        solution = least_squares(design, np.concatenate([-residuals * weights, -model.unknowns]))
        model = replace(model, unknowns=model.unknowns + solution.values)
        if np.abs(jacobian @ solution.values).max() < thresholds.MAX_PUSHBROOM_STEP_PX:
            return model, solution.condition, iteration, True
        if not np.isfinite(model.unknowns).all():
            raise SensorModelError(messages.PUSHBROOM_DIVERGED())
    return model, solution.condition, thresholds.MAX_PUSHBROOM_ITERATIONS, False


def _nominal_orbit(places: np.ndarray, image: np.ndarray, orbit_height_m: float) -> Orbit:
    """The orbit that the affine camera through the points implies.

    Its two gradients have the viewing direction as their common null direction; the projection centre lies on it at
    the orbit's height. Raises SensorModelError where the points do not fix an affine camera.
    """
    middle = places.mean(axis=0)
    affine = least_squares(np.column_stack([np.ones(len(places)), places - middle]), image)
    if affine.rank < 4 or affine.condition > thresholds.MAX_LINEAR_CONDITION:
        raise SensorModelError(messages.POINTS_ON_A_PLANE())
    gradients = affine.values[1:].T  # px per m, (2, 3)
    up = unit(middle)
    view = unit(np.cross(gradients[0], gradients[1]))
    view = -view if view @ up > 0 else view
    per_px = np.linalg.pinv(gradients)  # (3, 2) m per column and per row, across the view
    on_ground = per_px - np.outer(view, (up @ per_px) / (view @ up))
    centre = (image.min(axis=0) + image.max(axis=0)) / 2
    middle = middle + on_ground @ (centre - affine.values[0])
    along = middle @ view
    radius = thresholds.WGS84_SEMI_MAJOR_M + orbit_height_m
    distance = along + np.sqrt(along**2 - middle @ middle + radius**2)
    position = middle - view * distance
    detectors = unit(per_px[:, 0])
    motion = on_ground[:, 1] * radius / np.linalg.norm(middle)
    speed = np.sqrt(thresholds.EARTH_GRAVITY_M3_S2 / radius)
    seconds_per_line = np.linalg.norm(motion) / speed
    outward = unit(position)
    acceleration = -thresholds.EARTH_GRAVITY_M3_S2 / radius**2 * seconds_per_line**2 * outward
    across = unit(np.cross(outward, motion))
    return Orbit(
        position,
        motion,
        acceleration,
        np.stack([detectors, np.cross(view, detectors), view]),
        np.stack([np.cross(across, outward), across, outward]),
        float(distance / np.linalg.norm(per_px[:, 0])),
        centre,
        float(max((image[:, 1].max() - image[:, 1].min()) / 2, 1.0)),
    )


def _linearised(model: Pushbroom, places: np.ndarray, image: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Residuals (2n,) in px, column and row in turn, and their derivatives (2n, 19) by central differences."""
    residuals = _residuals(model, places, image)
    jacobian = np.empty((len(residuals), len(model.unknowns)))
    for index in range(len(model.unknowns)):
        step = np.zeros(len(model.unknowns))
        step[index] = thresholds.PUSHBROOM_DIFFERENCE
        after = _residuals(replace(model, unknowns=model.unknowns + step), places, image)
        before = _residuals(replace(model, unknowns=model.unknowns - step), places, image)
        jacobian[:, index] = (after - before) / (2 * thresholds.PUSHBROOM_DIFFERENCE)
    return residuals, jacobian


def _residuals(model: Pushbroom, places: np.ndarray, image: np.ndarray) -> np.ndarray:
    """Model minus measured, px, by one Newton step from the measured line: exact where the residual vanishes."""
    columns, slip = model.in_line(places, image[:, 1])
    next_columns, next_slip = model.in_line(places, image[:, 1] + 1)
    rows = -slip / (next_slip - slip)
    return np.column_stack([columns + (next_columns - columns) * rows - image[:, 0], rows]).ravel()


def _variance_factor(
    model: Pushbroom, places: np.ndarray, image: np.ndarray, sigma_px: np.ndarray, factor: float
) -> float:
    """The factor of the points' standard deviations that their residuals show, by their share of the redundancy."""
    residuals, jacobian = _linearised(model, places, image)
    weights = np.repeat(1 / sigma_px, 2)
    design = jacobian * weights[:, None] / factor
    _, singular, _ = np.linalg.svd(design, full_matrices=False)
    redundancy = len(residuals) - np.sum(singular**2 / (1 + singular**2))
    estimate = np.sqrt(np.sum((residuals * weights) ** 2) / max(redundancy, 1e-9))
    return float(np.clip(estimate, thresholds.MIN_SIGMA_PX, None))
