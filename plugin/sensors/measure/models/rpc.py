"""An RPC of any model in space."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....imagery.errors import SensorModelError
from .. import messages
from ..ground_system import GEOGRAPHIC, GroundSystem
from .locating import locate
from .rational import Rational, fit_rational
from .sensor_model import SensorModel

RPC_GRID = (21, 21, 7)  # columns, rows, heights of the terrain-independent fit: 39 unknowns an axis
MIN_RPC_HEIGHTS_M = 50.0  # half the range of heights at least, so that the quotient is sound around flat terrain


@dataclass(frozen=True)
class Domain:
    """Where a model is used."""

    columns: tuple[float, float]
    """First and last, px."""
    rows: tuple[float, float]
    """First and last, px."""
    heights: tuple[float, float]
    """Lowest and highest, m above the ellipsoid."""
    middle: tuple[float, float]
    """x and y on the ground of a place in it, in the frame of the model's points."""


@dataclass(frozen=True)
class RpcOfModel:
    """An RPC and how closely it follows the model it was made from."""

    rpc: Rational
    rms_px: float
    """Against the model, on places between those it was fitted to; 0 for a model that is an RPC already."""
    max_px: float

    @property
    def exact(self) -> bool:
        """Whether it is the model itself."""
        return self.max_px == 0


def rpc_of(model: SensorModel, wkt: str, domain: Domain) -> RpcOfModel:
    """A model in space as RPC: as it is where it has that form, else by a terrain-independent fit over the domain.

    ``wkt`` is the system of the points that the model was fitted to. Raises SensorModelError for a plane model.
    """
    frame = GEOGRAPHIC if model.GEOGRAPHIC else GroundSystem(wkt)
    if not model.SPATIAL:
        raise SensorModelError(messages.PLANE_MODEL_HAS_NO_RPC())
    exact = model.as_rational() if frame.is_wgs84 else None
    if exact is not None:
        assert isinstance(exact, Rational)
        return RpcOfModel(exact.padded(), 0.0, 0.0)
    columns, rows, heights = RPC_GRID
    fitted_to, judged_on = _grid(domain, RPC_GRID, 0.0), _grid(domain, (columns - 1, rows - 1, heights - 1), 0.5)
    ground = located(model, wkt, fitted_to, domain)
    rational = fit_rational(ground, fitted_to[:, :2], np.ones(len(ground)), 3).model
    assert isinstance(rational, Rational)
    misses = rational.project(located(model, wkt, judged_on, domain)) - judged_on[:, :2]
    distance = np.linalg.norm(misses, axis=1)
    return RpcOfModel(rational, float(np.sqrt(np.mean(distance**2))), float(distance.max()))


def _grid(domain: Domain, counts: tuple[int, int, int], inset: float) -> np.ndarray:
    """(n, 3) column, row, height; with ``inset`` 0.5 the middles of the grid's cells."""
    axes = []
    for (first, last), count in zip((domain.columns, domain.rows, rpc_heights(domain)), counts):
        cells = count if inset else count - 1
        axes.append(first + (np.arange(count) + inset) * (last - first) / cells)
    return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)


def rpc_heights(domain: Domain) -> tuple[float, float]:
    """The heights that an RPC is fitted to: those of the domain, 100 m at least."""
    low, high = domain.heights
    half = max((high - low) / 2, MIN_RPC_HEIGHTS_M)
    return (low + high) / 2 - half, (low + high) / 2 + half


def located(model: SensorModel, wkt: str, grid: np.ndarray, domain: Domain) -> np.ndarray:
    """(n, 3) longitude, latitude, height of grid places (n, 3) column, row, height.

    Raises SensorModelError where the model can't be inverted.
    """
    frame = GEOGRAPHIC if model.GEOGRAPHIC else GroundSystem(wkt)
    middle = np.array([[*domain.middle, float(np.mean(domain.heights))]])
    if model.GEOGRAPHIC:
        middle = GroundSystem(wkt).to_geographic(middle)
    found = locate(model.project, grid[:, :2], grid[:, 2], middle[:, :2], frame.metres(float(middle[0, 1])))
    return frame.to_geographic(np.column_stack([found, grid[:, 2]]))
