"""The sensor models, one entry each. Read when QGIS starts, so nothing heavy is imported before a model is fitted."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from math import comb
from typing import TYPE_CHECKING, Callable

from ...imagery.errors import Message
from . import limits, messages

if TYPE_CHECKING:
    import numpy as np

    from .points import Points
    from .polynomials import Rational
    from .sensor_model import FittedModel, SensorModel


@dataclass(frozen=True)
class Variant:
    """One form of a model: an order, a term or a correction."""

    name: str  # empty for a model's plain form
    unknowns: int  # how many the points have to fix; of a model with priors those that the priors leave open
    fewest: int  # the fewest control points
    rank: int  # the smallest is preferred: parametric, RPC corrected, quotients by order, polynomials, those of a plane
    with_priors: int | None = None  # all unknowns, where priors hold some of them


@dataclass(frozen=True)
class ModelKind:
    name: str  # as parameters, tables and model files call it
    variants: tuple[Variant, ...]
    code: tuple[str, str, str]
    """Module, class (what a model file holds), and the fit: it takes ground (n, 3), image (n, 2) and weights (n,) of
    points, and the ``options``, which are the order unless said otherwise."""
    recommendation: Message  # why it is the one to take
    options: Callable[[ModelRequest, Points], Sequence[object]] = lambda request, points: (int(request.variant.name),)
    corrects_rpc: bool = False  # whether it starts from the vendor's RPC and its unknowns are a correction in the image

    def model_class(self) -> type[SensorModel]:
        """The class, imported when it is asked for, as is the fit."""
        return getattr(import_module(self.code[0], __package__), self.code[1])

    def fit(self, request: ModelRequest, points: Points, weights: np.ndarray) -> FittedModel:
        """Fit to points whose ground is longitude and latitude where the class says so."""
        function = getattr(import_module(self.code[0], __package__), self.code[2])
        return function(points.ground, points.image, weights, *self.options(request, points))

    def request(
        self, *words: str, orbit_height_m: float = limits.DEFAULT_ORBIT_HEIGHT_KM * 1000,
        size: tuple[float, float] | None = None, rpc: Rational | None = None,
    ) -> ModelRequest:
        """The variant that one of the words names, the first one where none does."""
        chosen = next((variant for variant in self.variants if variant.name in words), self.variants[0])
        return ModelRequest(self, chosen, orbit_height_m, size, rpc)


@dataclass(frozen=True)
class ModelRequest:
    """A model to fit, and what it may need besides points."""

    kind: ModelKind
    variant: Variant
    orbit_height_m: float  # nominal
    size: tuple[float, float] | None  # the image's columns and rows; None where the image is not given
    rpc: Rational | None  # the image's own

    @property
    def name(self) -> str:
        """Kind and variant, for tables."""
        return f"{self.kind.name} {self.variant.name}".strip()

    @property
    def needs_heights(self) -> bool:
        return self.kind.model_class().SPATIAL


_TERMS_2D = {order: comb(order + 2, 2) for order in (1, 2, 3)}
_TERMS_3D = {order: comb(order + 3, 3) for order in (1, 2, 3)}

POLYNOMIAL_2D = ModelKind(
    "polynomial_2d", tuple(Variant(str(order), 2 * terms, terms, 9 + order) for order, terms in _TERMS_2D.items()),
    (".polynomials", "Polynomial2D", "fit_polynomial_2d"), messages.RECOMMEND_POLYNOMIAL_2D,
)
POLYNOMIAL_3D = ModelKind(
    "polynomial_3d", tuple(Variant(str(order), 2 * terms, terms, 5 + order) for order, terms in _TERMS_3D.items()),
    (".polynomials", "Polynomial3D", "fit_polynomial_3d"), messages.RECOMMEND_POLYNOMIAL_3D,
)
RATIONAL_TERMS = ModelKind(
    "rational_terms", (Variant("", 8, 12, 3),),  # it starts from 8 unknowns; fewer points have none to spare for more
    (".polynomials", "Rational", "fit_chosen_terms"), messages.RECOMMEND_RATIONAL, lambda request, points: (),
)  # fmt: skip
RATIONAL = ModelKind(
    "rational",
    tuple(Variant(str(order), 4 * terms - 2, 2 * terms - 1, 1 + order) for order, terms in _TERMS_3D.items()),
    (".polynomials", "Rational", "fit_rational"), messages.RECOMMEND_RATIONAL,
)  # fmt: skip
DLT = ModelKind(
    "dlt", (Variant("", 11, 6, 2), Variant("xy", 12, 6, 2)), (".polynomials", "Dlt", "fit_dlt"), messages.RECOMMEND_DLT,
    lambda request, points: (request.variant.name == "xy",),
)
PUSHBROOM = ModelKind(
    "pushbroom", (Variant("", 8, 4, 0, with_priors=20),), (".pushbroom", "Pushbroom", "fit_pushbroom"),
    messages.RECOMMEND_PUSHBROOM,
    lambda request, points: (request.orbit_height_m, request.size, not (points.sigma_px > 0).any()),
)
RPC_BIAS = ModelKind(
    "rpc_bias", (Variant("shift", 2, 1, 1), Variant("shift_drift", 3, 2, 1), Variant("affine", 6, 3, 1)),
    (".rpc", "BiasedRpc", "fit_bias"), messages.RECOMMEND_RPC_BIAS,
    lambda request, points: (request.variant.name, request.rpc), corrects_rpc=True,
)

KINDS = {kind.name: kind for kind in (POLYNOMIAL_2D, POLYNOMIAL_3D, RATIONAL, RATIONAL_TERMS, DLT, PUSHBROOM, RPC_BIAS)}
"""In the paper's order."""
