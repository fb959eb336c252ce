"""The parametric model: one perspective per image line, from a position and an attitude that change with time."""
from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from ....imagery.errors import SensorModelError
from .. import messages
from .earth import geocentric, rotations
from .sensor_model import SensorModel

PUSHBROOM_POSITION_SIGMAS_M = (5e3, 5e3, 5e4)  # along, across, away: the affine camera's view, the orbit's height
PUSHBROOM_MOTION_SIGMAS_M = (1e3, 1e3, 300.0)  # over half the lines: the orbit is near circular
PUSHBROOM_ROTATION_SIGMAS = (  # rad about each axis: attitude, its rate, acceleration and jerk over half the lines
    (1e-2, 1e-2, 1e-2),
    (2e-3, 2e-3, 2e-3),  # agile satellites pitch while they scan
    (1e-5, 1e-5, 1e-5),  # 2": what star trackers resolve (Fraser 2000, cited by Kurczynski and Wolniewicz)
    (3e-6, 3e-6, 3e-6),
)
PUSHBROOM_SCALE_SIGMA = 5e-3
MAX_LINE_ITERATIONS = 30  # the line that sees a point: Newton's method, three steps suffice on real scenes
MAX_LINE_STEP_PX = 1e-7

SIGMAS = np.array([
    *PUSHBROOM_POSITION_SIGMAS_M,
    *PUSHBROOM_MOTION_SIGMAS_M,
    *(sigma for sigmas in PUSHBROOM_ROTATION_SIGMAS for sigma in sigmas),
    PUSHBROOM_SCALE_SIGMA,
    1.0,  # the principal column's stands in the orbit: it depends on whether the image's width is known
])
"""Prior standard deviations of the unknowns, in the order of ``Pushbroom.unknowns``."""


@dataclass(frozen=True)
class Orbit:
    """The nominal geometry that the unknowns correct, geocentric (WGS 84), in m and m per line."""

    position: np.ndarray
    """(3,) of the projection centre at the central line."""
    motion: np.ndarray
    """(3,) per line."""
    camera: np.ndarray
    """(3, 3) rows: along the detectors, along the track, along the view."""
    track: np.ndarray
    """(3, 3) rows: along the orbit, across it, back along the view; the directions of the position's unknowns."""
    distance: float
    """To the ground along the view, m."""
    focal_px: float
    """Focal length in detector widths; it grows with the distance, so that a pixel keeps its size on the ground."""
    centre: np.ndarray
    """(2,) principal column, and the row that time starts from."""
    half_lines: float
    """Lines from the centre to the ends: time runs from -1 to 1."""
    principal_sigma_px: float
    """Prior standard deviation of the principal column."""


@dataclass(frozen=True)
class Pushbroom(SensorModel):
    """Collinearity in every line; position linear and attitude cubic in time, on top of a nominal orbit.

    Source: Kurczynski and Wolniewicz, "model parametryczny"; collinearity of one line at a time.
    """

    GEOGRAPHIC: ClassVar[bool] = True

    orbit: Orbit
    unknowns: np.ndarray
    """(20,) in units of their priors: position along, across, away; motion in these directions over half the lines;
    rotation about the camera's three axes, then about the rotated ones linear, quadratic and cubic in time; scale;
    principal column."""

    def project(self, ground: np.ndarray) -> np.ndarray:
        """(n, 3) longitude, latitude, ellipsoidal height -> (n, 2) column, row.

        Raises SensorModelError where a point is seen in no line.
        """
        places = geocentric(ground)
        rows = np.full(len(places), self.orbit.centre[1])
        columns, slip = self.in_line(places, rows)
        for _ in range(MAX_LINE_ITERATIONS):
            slope = self.in_line(places, rows + 1)[1] - slip
            step = -slip / slope
            rows = rows + step
            columns, slip = self.in_line(places, rows)
            if np.abs(step).max(initial=0) < MAX_LINE_STEP_PX:
                return np.column_stack([columns, rows])
        raise SensorModelError(messages.LINE_NOT_FOUND())

    def in_line(self, places: np.ndarray, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Where geocentric points (n, 3) are seen from given lines (n,): column, and distance from the line, px."""
        orbit, moved = self.orbit, self.unknowns * SIGMAS
        lines = rows - orbit.centre[1]
        time = lines / orbit.half_lines
        start = orbit.position + moved[0:3] @ orbit.track
        motion = orbit.motion + moved[3:6] @ orbit.track / orbit.half_lines  # m per line
        fall = -(motion @ motion) / (start @ start) * start  # m per line squared, as on a circular orbit
        positions = start + lines[:, None] * motion + 0.5 * lines[:, None] ** 2 * fall
        camera = rotations(moved[None, 6:9])[0].T @ orbit.camera
        turns = (time[:, None] ** [1, 2, 3]) @ moved[9:18].reshape(3, 3)
        seen = np.einsum("nji,nj->ni", rotations(turns), (places - positions) @ camera.T)
        focal = orbit.focal_px * (1 + moved[2] / orbit.distance) * (1 + moved[18])
        principal = orbit.centre[0] + moved[19] * orbit.principal_sigma_px
        return principal + focal * seen[:, 0] / seen[:, 2], focal * seen[:, 1] / seen[:, 2]
