"""The accuracy to expect from control points that are not measured yet: a planning figure, by simulation."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Callable

import numpy as np

from ...imagery.errors import Message, SensorModelError, SettingsError
from ...imagery.reference_systems import metres_per_unit
from . import limits, messages
from .adjustment import accuracy, adjust
from .points import Points
from .polynomials import Rational
from .pushbroom import SIGMAS, Pushbroom, geocentric, nominal_orbit
from .registry import ModelRequest
from .sensor_model import WGS84, SensorModel, locate

GRID, RANDOM, CORNER = limits.SPREADS
DRAWS = 50
_CHECK_CELLS = 8  # check points on each side of the image, one in each cell
_USUAL, _MOST = 0.5, 0.9  # of the draws have at most this error
_NOMINAL_PLACE = 0.0, 45.0  # longitude, latitude of a scene without RPC
_PITCH_RATE = 9  # of the parametric model's unknowns
_DRIFTS = slice(9, 18)  # of the same: rate, acceleration and jerk of the attitude


@dataclass(frozen=True)
class PlannedScene:
    """The image that points are planned for."""

    model: SensorModel  # from longitude, latitude and height to the image: taken for true
    size: tuple[float, float]  # columns and rows
    middle: tuple[float, float]  # longitude and latitude of a place in it, degrees
    heights: tuple[float, float]  # lowest and highest terrain, m above the ellipsoid; points lie anywhere between


@dataclass(frozen=True)
class PointPlan:
    """The way in which points are going to be measured."""

    spread: str  # ``grid`` (one in each cell of a grid over the image), ``random`` or ``corner``
    corner_share: float  # of the image's area that holds all points, for ``corner``
    sigma_m: float  # standard deviation of each of the three ground coordinates
    sigma_px: float  # standard deviation of each coordinate in the image


@dataclass(frozen=True)
class ExpectedAccuracy:
    """The outcome for a number of points. Errors are root mean squares in m, of both coordinates together."""

    model: str
    count: int
    failed: int  # draws that no model could be fitted to; they count as the largest errors
    image_usual: float | None  # of the whole image: half of the draws have at most this; None where they failed
    image_most: float | None  # 90 % of the draws have at most this
    check_usual: float | None  # at check points that are measured as well as the control points
    check_most: float | None
    reason: Message | None = None  # why draws failed: what the first of them said


def scene_of_rpc(rpc: Rational, size: tuple[float, float] | None, heights: tuple[float, float]) -> PlannedScene:
    """The image of an RPC; ``size`` None: as large as the RPC says."""
    columns, rows = (rpc.image.offset + rpc.image.scale).tolist()
    longitude, latitude, _ = rpc.ground.offset.tolist()
    return PlannedScene(rpc, size or (columns, rows), (longitude, latitude), heights)


def nominal_scene(
    orbit_height_m: float, view_angle: float, pixel_m: float, side_m: float, heights: tuple[float, float]
) -> PlannedScene:
    """A square image of a line scanner, tilted across its orbit by ``view_angle`` (degrees from the vertical).

    ``orbit_height_m`` and ``heights`` (lowest and highest terrain): above the ellipsoid. ``pixel_m``: on the ground.
    """
    count = side_m / pixel_m
    metres = metres_per_unit(WGS84, _NOMINAL_PLACE)
    x, y, up = np.meshgrid(*[np.linspace(-side_m / 2, side_m / 2, 3)] * 2, np.linspace(0, side_m / 10, 2))
    local = np.column_stack([x.ravel(), y.ravel(), up.ravel()])
    height = float(np.mean(heights))
    ground = np.array([*_NOMINAL_PLACE, height]) + local / [*metres, 1]
    across = local[:, 0] + local[:, 2] * np.tan(np.radians(view_angle))
    image = np.column_stack([across, -local[:, 1]]) / pixel_m + count / 2
    orbit = nominal_orbit(geocentric(ground), image, orbit_height_m, (count, count))
    still = Pushbroom(orbit, np.zeros(len(SIGMAS)))
    # The camera follows the ground below: it pitches at the rate that gives lines their width.
    trial = replace(still, unknowns=np.eye(len(SIGMAS))[_PITCH_RATE])
    ends = [int(np.argmin(image[:, 1])), int(np.argmax(image[:, 1]))]
    seen = image[:, 1], still.project(ground)[:, 1], trial.project(ground)[:, 1]
    wanted, before, after = (np.ptp(row[ends]) for row in seen)
    # The width of a line, not the number of lines, is linear in the rate.
    pitching = replace(still, unknowns=trial.unknowns * (1 / wanted - 1 / before) / (1 / after - 1 / before))
    return PlannedScene(pitching, (count, count), _NOMINAL_PLACE, heights)


def expected_accuracies(
    request: ModelRequest, scene: PlannedScene, plan: PointPlan, counts: tuple[int, ...], seed: int, draws: int = DRAWS,
    progress: Callable[[float], None] = lambda share: None, cancelled: Callable[[], bool] = lambda: False,
) -> Iterator[ExpectedAccuracy]:
    """The outcome for each number of points, whatever others are asked for. Raises SettingsError for too few."""
    fewest = request.variant.fewest
    if min(counts) < fewest:
        raise SettingsError(messages.TOO_FEW_POINTS(model=request.name, count=min(counts), fewest=fewest))
    for number, count in enumerate(counts):
        random = np.random.default_rng([seed, count])
        errors, reason = np.full((draws, 2), np.inf), None
        for draw in range(draws):
            if cancelled():
                return
            try:
                errors[draw] = _errors(request, scene, plan, count, random)
            except SensorModelError as error:
                reason = reason or error.message
            progress((number + (draw + 1) / draws) / len(counts))
        failed = int(np.count_nonzero(~np.isfinite(errors).all(axis=1)))
        within = np.sort(errors, axis=0)[[int(np.ceil(share * draws)) - 1 for share in (_USUAL, _MOST)]].T.ravel()
        usual, most, check_usual, check_most = (error if np.isfinite(error) else None for error in within.tolist())
        yield ExpectedAccuracy(request.name, count, failed, usual, most, check_usual, check_most, reason)


def _errors(
    request: ModelRequest, scene: PlannedScene, plan: PointPlan, count: int, random: np.random.Generator
) -> tuple[float, float]:
    """Errors of a draw, m: over the whole image and at check points as measured; infinite where that is no number."""
    truth = scene.model
    if isinstance(truth, Pushbroom):  # its attitude drifts as the priors say
        drift = np.zeros(len(SIGMAS))
        drift[_DRIFTS] = random.normal(size=_DRIFTS.stop - _DRIFTS.start)
        truth = replace(truth, unknowns=truth.unknowns + drift)
    size = np.array(scene.size)
    checks = _CHECK_CELLS**2
    corner = np.sqrt(plan.corner_share) if plan.spread == CORNER else 1.0
    control = _in_cells(count, random) if plan.spread == GRID else random.uniform(0, 1, (count, 2)) * corner
    image = np.concatenate([control, _in_cells(checks, random)]) * size
    heights = random.uniform(*scene.heights, len(image))
    metres = metres_per_unit(WGS84, scene.middle)
    ground = np.column_stack([locate(truth.project, image, heights, np.array([scene.middle]), metres), heights])
    measured = image + random.normal(0, plan.sigma_px, image.shape)
    surveyed = ground + random.normal(0, plan.sigma_m, ground.shape) / [*metres, 1]
    exact = slice(count, None)
    total = count + 2 * checks
    points = Points(
        tuple(map(str, range(total))), np.concatenate([measured, image[exact]]),
        np.concatenate([surveyed, ground[exact]]), WGS84, np.full(total, np.nan), np.arange(total) >= count,
    )
    done = adjust(request, points)
    groups = slice(count + checks, None), slice(count, count + checks)
    errors = [accuracy(done.residuals_px, done.residuals_m, group).rmse for group in groups]
    over_image, at_checks = (error if error is not None and np.isfinite(error) else np.inf for error in errors)
    return over_image, at_checks


def _in_cells(count: int, random: np.random.Generator) -> np.ndarray:
    """(n, 2) places in the cells of a square grid; points beyond a square number share cells by chance."""
    side = max(int(np.sqrt(count)), 2)  # two or three points lie in different quarters
    rounds = -(-count // side**2)
    cells = np.concatenate([random.permutation(side**2) for _ in range(rounds)])[:count]
    return (np.column_stack([cells % side, cells // side]) + random.uniform(0, 1, (count, 2))) / side
