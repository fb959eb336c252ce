"""Quotients of polynomials with separate denominators, and the direct linear transformation."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .least_squares import Scaling, least_squares
from .sensor_model import FittedModel, SensorModel
from .terms import COUNT_3D, terms_3d

MAX_RATIONAL_ITERATIONS = 100  # real scenes take three to ten, noise in few points more
MAX_RATIONAL_STEP_PX = 1e-7  # below a tenth of the accuracy that exact points have to be recovered with
MIN_DENOMINATOR = 1e-6  # a quotient is kept away from its poles while it is iterated


@dataclass(frozen=True)
class Rational(SensorModel):
    """Column and row as quotients of polynomials of x, y and z. Source: Kurczynski and Wolniewicz, equation 3."""

    order: int
    ground: Scaling
    image: Scaling
    numerators: np.ndarray
    """(terms, 2) of column and row, in the order of RPC00B."""
    denominators: np.ndarray
    """(terms, 2), the first of each 1."""

    def project(self, ground: np.ndarray) -> np.ndarray:
        terms = terms_3d(self.ground.to(ground), self.order)
        with np.errstate(all="ignore"):
            return self.image.back((terms @ self.numerators) / (terms @ self.denominators))

    def as_rational(self) -> Rational:
        return self

    def padded(self) -> Rational:
        """The same function with the 20 terms of order 3."""
        numerators, denominators = np.zeros((20, 2)), np.zeros((20, 2))
        numerators[: COUNT_3D[self.order]] = self.numerators
        denominators[: COUNT_3D[self.order]] = self.denominators
        return Rational(3, self.ground, self.image, numerators, denominators)


@dataclass(frozen=True)
class Dlt(SensorModel):
    """Direct linear transformation: one common denominator. Source: Kurczynski and Wolniewicz, equation 4."""

    ground: Scaling
    image: Scaling
    coefficients: np.ndarray
    """(12,) a1..a12 of the scaled coordinates; a12, of the product of column and row, is 0 unless asked for."""

    def project(self, ground: np.ndarray) -> np.ndarray:
        return self.as_rational().project(ground)

    def as_rational(self) -> Rational:
        """The same function as quotients: y = (a5 + ...) / (1 + ... - a12 (a1 + ...))."""
        a = self.coefficients
        column_denominator = np.array([1.0, *a[8:11]])
        row_denominator = column_denominator - a[11] * a[0:4]
        lead = row_denominator[0]
        numerators = np.column_stack([a[0:4], a[4:8] / lead])
        denominators = np.column_stack([column_denominator, row_denominator / lead])
        return Rational(1, self.ground, self.image, numerators, denominators)


def fit_rational(ground: np.ndarray, image: np.ndarray, weights: np.ndarray, order: int) -> FittedModel:
    """Fit quotients by iterated least squares: each step is linear, divided by the last step's denominator.

    ``ground`` (n, 3), ``image`` (n, 2) px, ``weights`` (n,) 1 / standard deviation. Source: C. V. Tao and Y. Hu,
    A comprehensive study of the rational function model for photogrammetric processing, 2001 (without their ridge).
    """
    scale_g, scale_i = Scaling.of(ground), Scaling.of(image)
    terms, scaled = terms_3d(scale_g.to(ground), order), scale_i.to(image)
    axes = [_fit_quotient(terms, scaled[:, axis], weights, float(scale_i.scale[axis])) for axis in (0, 1)]
    count = terms.shape[1]
    numerators = np.column_stack([values[:count] for values, *_ in axes])
    denominators = np.column_stack([np.concatenate([[1.0], values[count:]]) for values, *_ in axes])
    return FittedModel(
        Rational(order, scale_g, scale_i, numerators, denominators),
        max(condition for _, condition, *_ in axes),
        max(iterations for *_, iterations, _ in axes),
        all(converged for *_, converged in axes),
        2 * (2 * count - 1),
    )


def _fit_quotient(
    terms: np.ndarray, wanted: np.ndarray, weights: np.ndarray, scale_px: float
) -> tuple[np.ndarray, float, int, bool]:
    """The unknowns of one quotient, the condition, the iterations and whether they converged."""
    count = terms.shape[1]
    whole = np.hstack([terms, -wanted[:, None] * terms[:, 1:]])
    denominator, last = np.ones(len(terms)), np.full(len(terms), np.inf)
    for iteration in range(1, MAX_RATIONAL_ITERATIONS + 1):
        row_weights = weights / denominator
        solution = least_squares(whole * row_weights[:, None], wanted * row_weights)
        denominator = off_poles(1 + terms[:, 1:] @ solution.values[count:])
        seen = (terms @ solution.values[:count]) / denominator
        change = float(np.abs(seen - last).max()) * scale_px
        last = seen
        if change < MAX_RATIONAL_STEP_PX:
            return solution.values, solution.condition, iteration, True
    return solution.values, solution.condition, MAX_RATIONAL_ITERATIONS, False


def off_poles(denominator: np.ndarray) -> np.ndarray:
    """Denominators kept away from zero while a fit is iterated."""
    return np.where(np.abs(denominator) < MIN_DENOMINATOR, MIN_DENOMINATOR, denominator)


def fit_dlt(ground: np.ndarray, image: np.ndarray, weights: np.ndarray, with_xy: bool) -> FittedModel:
    """Fit the direct linear transformation by iterated least squares; the arguments of ``fit_rational``."""
    scale_g, scale_i = Scaling.of(ground), Scaling.of(image)
    terms, scaled = terms_3d(scale_g.to(ground), 1), scale_i.to(image)
    x, y = scaled[:, :1], scaled[:, 1:]
    nothing = np.zeros_like(terms)
    product = np.vstack([np.zeros_like(x), x * y]) if with_xy else np.empty((2 * len(x), 0))
    shared = -np.vstack([x, y]) * np.tile(terms[:, 1:], (2, 1))
    whole = np.hstack([np.vstack([terms, nothing]), np.vstack([nothing, terms]), shared])
    wanted, both = np.concatenate([x, y])[:, 0], np.tile(weights, 2)
    denominator, bend, last, change = np.ones(len(x)), np.ones(len(x)), np.full((len(x), 2), np.inf), np.inf
    iteration = 0
    while iteration < MAX_RATIONAL_ITERATIONS and not change < MAX_RATIONAL_STEP_PX:
        iteration += 1
        divided = np.tile(1 / denominator, 2)
        bent = both * np.concatenate([np.ones(len(x)), 1 / bend])
        design = np.hstack([whole * divided[:, None], product]) * bent[:, None]
        solution = least_squares(design, wanted * divided * bent)
        coefficients = np.zeros(12)
        coefficients[: len(solution.values)] = solution.values
        model = Dlt(scale_g, scale_i, coefficients)
        denominator = off_poles(1 + terms[:, 1:] @ coefficients[8:11])
        bend = 1 - coefficients[11] * x[:, 0]
        seen = model.project(ground)
        change = float(np.abs(seen - last).max())
        last = seen
    return FittedModel(model, solution.condition, iteration, change < MAX_RATIONAL_STEP_PX, len(solution.values))
