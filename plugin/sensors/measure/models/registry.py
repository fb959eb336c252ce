"""The sensor models, one entry each: what it is called, what it needs, how it is fitted and how it ranks.

Read when QGIS starts, so nothing heavy is imported before a model is fitted.
"""
from __future__ import annotations

from dataclasses import dataclass
from math import comb
from typing import TYPE_CHECKING, Callable, NamedTuple

from ....imagery.message import Message
from .. import limits, messages

if TYPE_CHECKING:
    import numpy as np

    from ..points import Points
    from .rational import Rational
    from .sensor_model import FittedModel, SensorModel


@dataclass(frozen=True)
class Variant:
    """One form of a model: an order, a term or a correction."""

    name: str
    """Empty for a model's plain form."""
    unknowns: int
    """How many the points have to fix; of a model with priors those that the priors leave open."""
    fewest: int
    """The fewest control points."""
    rank: int
    """Place in the preference of Kurczynski and Wolniewicz, the smallest first: parametric, the vendor's RPC corrected,
    quotients by their order, polynomials for small areas, those of the plane where it is flat."""
    with_priors: int | None = None
    """All unknowns, where priors hold some of them."""


class Implementation(NamedTuple):
    """The code of a model."""

    model: type[SensorModel]
    """Its class: what a model file holds."""
    fit: Callable[[ModelRequest, Points, np.ndarray], FittedModel]
    """Fits it to control points with weights (n,), 1 / standard deviation in px. The points' ground is longitude and
    latitude where the class says so."""


@dataclass(frozen=True)
class ModelKind:
    """A sensor model that can be chosen."""

    name: str
    """As parameters, tables and model files call it."""
    variants: tuple[Variant, ...]
    load: Callable[[], Implementation]
    """Imports the code."""
    recommendation: Message
    """Why it is the one to take; with ``model``, ``rmse`` and ``best``."""
    corrects_rpc: bool = False
    """Whether it starts from the vendor's RPC and its unknowns are a correction in the image."""

    def request(
        self,
        *words: str,
        orbit_height_m: float = limits.DEFAULT_ORBIT_HEIGHT_KM * 1000,
        size: tuple[float, float] | None = None,
        rpc: Rational | None = None,
    ) -> ModelRequest:
        """The variant that one of the words names, the first one where none does."""
        variant = next((one for one in self.variants if one.name in words), self.variants[0])
        return ModelRequest(self, variant, orbit_height_m, size, rpc)


@dataclass(frozen=True)
class ModelRequest:
    """Which model to fit, and what it may need besides points."""

    kind: ModelKind
    variant: Variant
    orbit_height_m: float
    """Nominal."""
    size: tuple[float, float] | None
    """The image's columns and rows; None where the image is not given."""
    rpc: Rational | None
    """The image's own."""

    @property
    def name(self) -> str:
        """Kind and variant, for tables."""
        return f"{self.kind.name} {self.variant.name}".strip()

    @property
    def needs_heights(self) -> bool:
        """Whether heights play a part."""
        return self.kind.load().model.SPATIAL


def _polynomial_2d() -> Implementation:
    from .polynomials import Polynomial2D, fit_polynomial_2d

    return Implementation(Polynomial2D, lambda request, points, weights: fit_polynomial_2d(
        points.ground, points.image, weights, int(request.variant.name)
    ))


def _polynomial_3d() -> Implementation:
    from .polynomials import Polynomial3D, fit_polynomial_3d

    return Implementation(Polynomial3D, lambda request, points, weights: fit_polynomial_3d(
        points.ground, points.image, weights, int(request.variant.name)
    ))


def _rational() -> Implementation:
    from .rational import Rational
    from .rational_fit import fit_rational

    return Implementation(Rational, lambda request, points, weights: fit_rational(
        points.ground, points.image, weights, int(request.variant.name)
    ))


def _dlt() -> Implementation:
    from .rational import Dlt
    from .rational_fit import fit_dlt

    return Implementation(Dlt, lambda request, points, weights: fit_dlt(
        points.ground, points.image, weights, request.variant.name == "xy"
    ))


def _pushbroom() -> Implementation:
    from .pushbroom import Pushbroom
    from .pushbroom_fit import fit_pushbroom

    return Implementation(Pushbroom, lambda request, points, weights: fit_pushbroom(
        points.ground, points.image, weights, request.orbit_height_m, request.size, not points.sigma_known
    ))


def _rpc_bias() -> Implementation:
    from .bias import BiasedRpc, fit_bias

    return Implementation(BiasedRpc, lambda request, points, weights: fit_bias(
        request.rpc, points.ground, points.image, weights, request.variant.name
    ))


_TERMS_2D = {order: comb(order + 2, 2) for order in (1, 2, 3)}
_TERMS_3D = {order: comb(order + 3, 3) for order in (1, 2, 3)}

POLYNOMIAL_2D = ModelKind(
    "polynomial_2d",
    tuple(Variant(str(order), 2 * terms, terms, 9 + order) for order, terms in _TERMS_2D.items()),
    _polynomial_2d,
    messages.RECOMMEND_POLYNOMIAL_2D,
)
POLYNOMIAL_3D = ModelKind(
    "polynomial_3d",
    tuple(Variant(str(order), 2 * terms, terms, 5 + order) for order, terms in _TERMS_3D.items()),
    _polynomial_3d,
    messages.RECOMMEND_POLYNOMIAL_3D,
)
RATIONAL = ModelKind(
    "rational",
    tuple(Variant(str(order), 4 * terms - 2, 2 * terms - 1, 1 + order) for order, terms in _TERMS_3D.items()),
    _rational,
    messages.RECOMMEND_RATIONAL,
)
DLT = ModelKind("dlt", (Variant("", 11, 6, 2), Variant("xy", 12, 6, 2)), _dlt, messages.RECOMMEND_DLT)
PUSHBROOM = ModelKind(
    "pushbroom", (Variant("", 8, 4, 0, with_priors=20),), _pushbroom, messages.RECOMMEND_PUSHBROOM
)
RPC_BIAS = ModelKind(
    "rpc_bias",
    (Variant("shift", 2, 1, 1), Variant("shift_drift", 3, 2, 1), Variant("affine", 6, 3, 1)),
    _rpc_bias,
    messages.RECOMMEND_RPC_BIAS,
    corrects_rpc=True,
)

KINDS = {kind.name: kind for kind in (POLYNOMIAL_2D, POLYNOMIAL_3D, RATIONAL, DLT, PUSHBROOM, RPC_BIAS)}
"""In the paper's order."""
