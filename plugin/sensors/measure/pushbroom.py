"""The parametric model, one perspective per line: a nominal orbit, then an adjustment with priors."""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
from scipy.spatial.transform import Rotation

from ...imagery.errors import SensorModelError
from . import limits, messages
from .sensor_model import FittedModel, SensorModel, least_squares

WGS84_FLATTENING = 1 / 298.257223563
_SQUARED_ECCENTRICITY = WGS84_FLATTENING * (2 - WGS84_FLATTENING)
PUSHBROOM_POSITION_SIGMAS_M = (5e3, 5e3, 5e4)  # along, across, away: the affine camera's view, the orbit's height
PUSHBROOM_MOTION_SIGMAS_M = (1e3, 1e3, 300.0)  # over half the lines: the orbit is near circular
PUSHBROOM_ROTATION_SIGMAS = (  # rad about each axis: attitude, its rate, acceleration and jerk over half the lines
    (1e-2, 1e-2, 1e-2),
    (2e-3, 2e-3, 2e-3),  # agile satellites pitch while they scan
    (1e-5, 1e-5, 1e-5),  # 2": what star trackers resolve (Fraser 2000, cited by Kurczynski and Wolniewicz)
    (3e-6, 3e-6, 3e-6),
)
PUSHBROOM_SCALE_SIGMA = 5e-3
PRINCIPAL_SIGMA_PX = 50.0  # of the principal column around the image's middle
PRINCIPAL_SHARE = 0.1  # of the points' width where the image's is not known
PUSHBROOM_DIFFERENCE = 1e-2  # of a prior: derivatives good to 1e-7 px
MAX_PUSHBROOM_STEP_PX = 1e-6
MIN_REDUNDANCY = 1e-9  # where the points determine as much as they can
MAX_SIGMA_ROUNDS = 12
MAX_SIGMA_CHANGE = 0.1  # relative: the standard deviation of the points has settled
DEFAULT_SIGMA_PX = 0.5  # a point identified in an image

SIGMAS = np.array([
    *PUSHBROOM_POSITION_SIGMAS_M, *PUSHBROOM_MOTION_SIGMAS_M, *np.ravel(PUSHBROOM_ROTATION_SIGMAS),
    PUSHBROOM_SCALE_SIGMA, 1.0,  # the principal column's stands in the orbit: it depends on the image's width
])  # fmt: skip
"""Prior standard deviations of the unknowns, in the order of ``Pushbroom.unknowns``."""


@np.errstate(invalid="ignore", over="ignore")  # places that are none have none here either
def geocentric(geographic: np.ndarray) -> np.ndarray:
    """(n, 3) longitude and latitude in degrees and height above the ellipsoid in m -> (n, 3) X, Y, Z in m."""
    (longitude, latitude), height = np.radians(geographic[:, :2]).T, geographic[:, 2]
    prime_vertical = limits.WGS84_SEMI_MAJOR_M / np.sqrt(1 - _SQUARED_ECCENTRICITY * np.sin(latitude) ** 2)
    across = (prime_vertical + height) * np.cos(latitude)
    polar = (prime_vertical * (1 - _SQUARED_ECCENTRICITY) + height) * np.sin(latitude)
    return np.column_stack([across * np.cos(longitude), across * np.sin(longitude), polar])


def unit(vectors: np.ndarray) -> np.ndarray:
    """Vectors (..., 3) of length 1."""
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


@dataclass(frozen=True)
class Orbit:
    """The nominal geometry that the unknowns correct, geocentric (WGS 84), in m and m per line."""

    position: np.ndarray  # (3,) of the projection centre at the central line
    motion: np.ndarray  # (3,) per line
    camera: np.ndarray  # (3, 3) rows: along the detectors, along the track, along the view
    track: np.ndarray  # (3, 3) rows: along the orbit, across it, back along the view, as the position's unknowns
    distance: float  # to the ground along the view, m
    focal_px: float  # in detector widths; it grows with the distance, so that a pixel keeps its size on the ground
    centre: np.ndarray  # (2,) principal column, and the row that time starts from
    half_lines: float  # lines from the centre to the ends: time runs from -1 to 1
    principal_sigma_px: float  # prior standard deviation of the principal column


@dataclass(frozen=True)
class Pushbroom(SensorModel):
    """Collinearity in every line, position linear and attitude cubic in time (Kurczynski and Wolniewicz)."""

    GEOGRAPHIC: ClassVar[bool] = True

    orbit: Orbit
    unknowns: np.ndarray
    """(20,) in units of their priors: position along, across, away; motion likewise; rotation about the camera's axes,
    then linear, quadratic and cubic in time; scale; principal column."""

    def project(self, ground: np.ndarray) -> np.ndarray:
        """(n, 3) longitude, latitude, height -> (n, 2) column, row. Raises SensorModelError for what no line sees."""
        places = geocentric(ground)
        rows = np.full(len(places), self.orbit.centre[1])
        columns, slip = self.in_line(places, rows)
        for _ in range(limits.MAX_NEWTON_ITERATIONS):  # three suffice on real scenes
            slope = self.in_line(places, rows + 1)[1] - slip
            step = -slip / slope
            rows = rows + step
            columns, slip = self.in_line(places, rows)
            if np.abs(step).max(initial=0) < limits.EXACT_STEP_PX:
                return np.column_stack([columns, rows])
        raise SensorModelError(messages.NOT_INVERTED())

    def in_line(self, places: np.ndarray, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Column of geocentric points (n, 3) as seen from given lines (n,), and their distance from the line, px."""
        orbit, moved = self.orbit, self.unknowns * SIGMAS
        lines = rows - orbit.centre[1]
        time = lines / orbit.half_lines
        start = orbit.position + moved[0:3] @ orbit.track
        motion = orbit.motion + moved[3:6] @ orbit.track / orbit.half_lines  # m per line
        fall = -(motion @ motion) / (start @ start) * start  # m per line squared, as on a circular orbit
        positions = start + lines[:, None] * motion + 0.5 * lines[:, None] ** 2 * fall
        camera = Rotation.from_rotvec(moved[6:9]).as_matrix().T @ orbit.camera
        turns = (time[:, None] ** [1, 2, 3]) @ moved[9:18].reshape(3, 3)
        seen = np.einsum("nji,nj->ni", Rotation.from_rotvec(turns).as_matrix(), (places - positions) @ camera.T)
        focal = orbit.focal_px * (1 + moved[2] / orbit.distance) * (1 + moved[18])
        principal = orbit.centre[0] + moved[19] * orbit.principal_sigma_px
        return principal + focal * seen[:, 0] / seen[:, 2], focal * seen[:, 1] / seen[:, 2]


@np.errstate(all="ignore")  # points that mean nothing are told by the fit that does not converge
def fit_pushbroom(
    ground: np.ndarray, image: np.ndarray, weights: np.ndarray, orbit_height_m: float,
    size: tuple[float, float] | None = None, estimate_sigma: bool = True,
) -> FittedModel:
    """Adjust to points and priors; ``size``: columns and rows, whose middle is the nominal principal column. With
    ``estimate_sigma`` weights (n,) are relative. Raises SensorModelError for points on a plane, or if it diverges."""
    places = geocentric(ground)
    model = Pushbroom(nominal_orbit(places, image, orbit_height_m, size), np.zeros(len(SIGMAS)))
    sigma_px = 1 / np.maximum(weights, np.finfo(float).tiny)
    if estimate_sigma:
        sigma_px = sigma_px * DEFAULT_SIGMA_PX / np.median(sigma_px)
    iterations, factor = 0, 1.0
    for _ in range(MAX_SIGMA_ROUNDS if estimate_sigma else 1):
        weights = np.repeat(1 / (sigma_px * factor), 2)
        converged, iteration = False, 0
        while not converged and iteration < limits.MAX_NEWTON_ITERATIONS:
            iteration += 1
            residuals, jacobian = _linearised(model, places, image)
            design = np.vstack([jacobian * weights[:, None], np.eye(len(SIGMAS))])
            change, condition = least_squares(design, np.concatenate([-residuals * weights, -model.unknowns]))
            model = replace(model, unknowns=model.unknowns + change)
            if not np.isfinite(model.unknowns).all():
                raise SensorModelError(messages.FIT_DIVERGED())
            moved = jacobian @ change
            converged = bool(np.abs(moved).max() < MAX_PUSHBROOM_STEP_PX)
        iterations += iteration
        singular = np.linalg.svd(jacobian / np.repeat(sigma_px * factor, 2)[:, None], compute_uv=False)
        unknowns = float(np.sum(singular**2 / (1 + singular**2)))  # by the points, not by the priors: each by its share
        redundancy = max(residuals.size - unknowns, MIN_REDUNDANCY)
        misfit = float(np.sqrt(np.sum(((residuals + moved) / np.repeat(sigma_px, 2)) ** 2) / redundancy))
        before, factor = factor, max(misfit, limits.MIN_SIGMA_PX)
        if abs(factor / before - 1) < MAX_SIGMA_CHANGE:
            break
    return FittedModel(model, condition, iterations, converged, unknowns)


def nominal_orbit(
    places: np.ndarray, image: np.ndarray, orbit_height_m: float, size: tuple[float, float] | None
) -> Orbit:
    """The orbit that the affine camera through the points implies: the common null direction of its gradients is the
    view. Raises SensorModelError where the points do not fix one."""
    middle = places.mean(axis=0)
    affine, condition = least_squares(np.column_stack([np.ones(len(places)), places - middle]), image)
    if condition > limits.MAX_LINEAR_CONDITION:
        raise SensorModelError(messages.POINTS_ON_A_PLANE(model="pushbroom"))
    gradients = affine[1:].T  # px per m, (2, 3)
    up = unit(middle)
    view = unit(np.cross(gradients[0], gradients[1]))
    view = -view if view @ up > 0 else view
    per_px = np.linalg.pinv(gradients)  # (3, 2) m per column and per row, across the view
    on_ground = per_px - np.outer(view, (up @ per_px) / (view @ up))
    low, high = (image.min(axis=0), image.max(axis=0)) if size is None else (np.zeros(2), np.array(size))
    centre = (low + high) / 2
    middle = middle + on_ground @ (centre - affine[0])
    along = middle @ view
    radius = limits.WGS84_SEMI_MAJOR_M + orbit_height_m
    distance = along + np.sqrt(along**2 - middle @ middle + radius**2)
    position = middle - view * distance
    detectors = unit(per_px[:, 0])
    motion = on_ground[:, 1] * radius / np.linalg.norm(middle)
    outward = unit(position)
    across = unit(np.cross(outward, motion))
    camera = np.stack([detectors, np.cross(view, detectors), view])
    track = np.stack([np.cross(across, outward), across, -view])
    focal, half = float(distance / np.linalg.norm(per_px[:, 0])), float(max((high[1] - low[1]) / 2, 1.0))
    sigma = PRINCIPAL_SHARE * (high[0] - low[0]) if size is None else PRINCIPAL_SIGMA_PX
    return Orbit(position, motion, camera, track, float(distance), focal, centre, half, sigma)


def _linearised(model: Pushbroom, places: np.ndarray, image: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Residuals (2n,) px, column and row in turn, and derivatives (2n, 20), by a Newton step from the measured line."""
    columns, slip = model.in_line(places, image[:, 1])
    next_columns, next_slip = model.in_line(places, image[:, 1] + 1)
    slope, drift = next_slip - slip, next_columns - columns

    def stepped(columns: np.ndarray, slip: np.ndarray) -> np.ndarray:
        rows = -slip / slope
        return np.column_stack([columns + drift * rows - image[:, 0], rows]).ravel()

    residuals = stepped(columns, slip)
    moved = np.column_stack([
        stepped(*replace(model, unknowns=unknowns).in_line(places, image[:, 1]))
        for unknowns in model.unknowns + PUSHBROOM_DIFFERENCE * np.eye(len(SIGMAS))
    ])
    return residuals, (moved - residuals[:, None]) / PUSHBROOM_DIFFERENCE
