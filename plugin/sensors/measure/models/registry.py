"""The models by name: what each needs, and its fit."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....imagery.errors import SensorModelError, SettingsError
from .. import limits, messages
from ..ground_system import GroundSystem
from ..points import Points
from . import bias
from .least_squares import Scaling, least_squares
from .polynomials import fit_polynomial_2d, fit_polynomial_3d
from .pushbroom_fit import fit_pushbroom
from .rational import Rational, fit_dlt, fit_rational
from .sensor_model import Fit
from .terms import COUNT_2D, COUNT_3D

POLYNOMIAL_2D, POLYNOMIAL_3D, RATIONAL = "polynomial_2d", "polynomial_3d", "rational"
DLT, PUSHBROOM, RPC_BIAS = "dlt", "pushbroom", "rpc_bias"
KINDS = (POLYNOMIAL_2D, POLYNOMIAL_3D, RATIONAL, DLT, PUSHBROOM, RPC_BIAS)
WITH_ORDER = (POLYNOMIAL_2D, POLYNOMIAL_3D, RATIONAL)


@dataclass(frozen=True)
class Wanted:
    """Which model to fit."""

    kind: str
    """One of ``KINDS``."""
    order: int = 1
    """Of a polynomial or quotient, 1 to 3."""
    dlt_xy: bool = False
    """Whether the direct linear transformation has the term a12 xy."""
    bias: str = bias.SHIFT
    """``shift``, ``shift_drift`` or ``affine``."""
    orbit_height_m: float = limits.DEFAULT_ORBIT_HEIGHT_KM * 1000
    """Nominal, of the parametric model."""
    size: tuple[float, float] | None = None
    """The image's columns and rows, of the parametric model; None where the image is not given."""
    rpc: Rational | None = None
    """The image's own, for ``rpc_bias``."""

    @property
    def name(self) -> str:
        """Kind and order or variant, for tables."""
        if self.kind in WITH_ORDER:
            return f"{self.kind} {self.order}"
        if self.kind == RPC_BIAS:
            return f"{self.kind} {self.bias}"
        return f"{self.kind} xy" if self.kind == DLT and self.dlt_xy else self.kind

    @property
    def unknowns(self) -> int:
        """How many unknowns the points have to fix; of the parametric model's 20 those that its priors leave open."""
        return {
            POLYNOMIAL_2D: 2 * COUNT_2D[self.order],
            POLYNOMIAL_3D: 2 * COUNT_3D[self.order],
            RATIONAL: 4 * COUNT_3D[self.order] - 2,
            DLT: 12 if self.dlt_xy else 11,
            PUSHBROOM: 8,
            RPC_BIAS: bias.UNKNOWNS[self.bias],
        }[self.kind]

    @property
    def fewest(self) -> int:
        """The fewest control points."""
        if self.kind == RPC_BIAS:
            return bias.FEWEST[self.bias]
        return {
            POLYNOMIAL_2D: COUNT_2D[self.order],
            POLYNOMIAL_3D: COUNT_3D[self.order],
            RATIONAL: 2 * COUNT_3D[self.order] - 1,
            DLT: 6,
            PUSHBROOM: 4,
        }[self.kind]

    @property
    def spatial(self) -> bool:
        """Whether heights play a part."""
        return self.kind != POLYNOMIAL_2D


def fit(wanted: Wanted, points: Points, weights: np.ndarray) -> Fit:
    """Fit a model to points with weights (n,), 1 / standard deviation in px; points of weight 0 do not count.

    Raises SensorModelError where they are too few or do not determine it, SettingsError where an RPC is missing.
    """
    used = weights > 0
    points, weights = points.only(used), weights[used]
    if len(points) < wanted.fewest:
        raise SensorModelError(messages.TOO_FEW_POINTS(model=wanted.name, count=len(points), fewest=wanted.fewest))
    _check_spread(wanted, points)
    ground, image = points.ground, points.image
    if wanted.kind == POLYNOMIAL_2D:
        return fit_polynomial_2d(ground, image, weights, wanted.order)
    if wanted.kind == POLYNOMIAL_3D:
        return fit_polynomial_3d(ground, image, weights, wanted.order)
    if wanted.kind == RATIONAL:
        return fit_rational(ground, image, weights, wanted.order)
    if wanted.kind == DLT:
        return fit_dlt(ground, image, weights, wanted.dlt_xy)
    geographic = GroundSystem(points.wkt).to_geographic(ground)
    if wanted.kind == PUSHBROOM:
        return fit_pushbroom(geographic, image, weights, wanted.orbit_height_m, wanted.size, not points.sigma_known)
    if wanted.rpc is None:
        raise SettingsError(messages.NO_RPC())
    return bias.fit_bias(wanted.rpc, geographic, image, weights, wanted.bias)


def _check_spread(wanted: Wanted, points: Points) -> None:
    """Refuse points that leave the linear part of a model open: on a line, or on a plane where Z has terms."""
    if wanted.kind == RPC_BIAS and wanted.bias != bias.AFFINE:
        return
    places = points.image if wanted.kind == RPC_BIAS else points.ground[:, :2]
    linear = np.column_stack([np.ones(len(places)), Scaling.of(places).to(places)])
    flat = least_squares(linear, places[:, 0])
    if flat.rank < 3 or flat.condition > limits.MAX_LINEAR_CONDITION:
        raise SensorModelError(messages.POINTS_ON_A_LINE(model=wanted.name))
    if wanted.spatial and wanted.kind != RPC_BIAS:
        linear = np.column_stack([linear, Scaling.of(points.ground[:, 2:]).to(points.ground[:, 2:])])
        solid = least_squares(linear, places[:, 0])
        if solid.rank < 4 or solid.condition > limits.MAX_LINEAR_CONDITION:
            raise SensorModelError(messages.POINTS_ON_A_PLANE(model=wanted.name))
