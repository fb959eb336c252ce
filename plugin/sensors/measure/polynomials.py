"""Polynomials and their quotients, of plane and space, and the DLT; terms in the order of RPC00B."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, ClassVar

import numpy as np
from numpy.linalg import norm

from ...imagery.statistics import critical_t
from . import limits
from .sensor_model import FittedModel, Scaling, SensorModel, least_squares, newton

EXPONENTS_3D = (
    (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1),
    (1, 1, 0), (1, 0, 1), (0, 1, 1), (2, 0, 0), (0, 2, 0), (0, 0, 2),
    (1, 1, 1), (3, 0, 0), (1, 2, 0), (1, 0, 2), (2, 1, 0), (0, 3, 0), (0, 1, 2), (2, 0, 1), (0, 2, 1), (0, 0, 3),
)  # fmt: skip
"""Powers of x (longitude), y (latitude), z (height): 4, 10 and 20 terms make orders 1, 2 and 3."""
MAX_RATIONAL_ITERATIONS = 100  # real scenes take three to ten, noise in few points more
MIN_DENOMINATOR = 1e-6  # a quotient is kept away from its poles while it is iterated
FALSE_ALARM = 0.01  # that any of all terms offered comes in though it means nothing
SPARE = 3  # points more than an axis has unknowns, so that what is left over says something
LINEAR = 4  # the constant, x, y and z of the numerator are never left out
CHOSEN_ORDER = 2  # of the terms offered: a higher one does not improve satellite images (Kurczynski and Wolniewicz)
_EXACT = 1e-12  # of the coordinates: nothing is left over that a term could explain
_TOO_ALIKE = 1e-6  # of a term's length that the chosen ones do not explain
_Choice = Callable[[np.ndarray, np.ndarray], list[int]]


@np.errstate(over="ignore", invalid="ignore")  # what is not finite is told by the fit, or where the model is inverted
def polynomial_terms(scaled: np.ndarray, order: int, axes: int = 3) -> np.ndarray:
    """Products of (n, ``axes`` or more) coordinates up to an order: (n, 4 | 10 | 20), (n, 3 | 6 | 10) in a plane."""
    exponents = [powers for powers in EXPONENTS_3D if sum(powers) <= order and not any(powers[axes:])]
    terms = np.ones((len(exponents), len(scaled)))
    for term, powers in zip(terms, exponents):
        for axis, power in enumerate(powers):
            for _ in range(power):
                term *= scaled[:, axis]
    return np.ascontiguousarray(terms.T)


@dataclass(frozen=True)
class Rational(SensorModel):
    """Column and row as quotients of polynomials of x, y and z. Source: Kurczynski and Wolniewicz, equation 3."""

    order: int
    ground: Scaling
    image: Scaling
    numerators: np.ndarray  # (terms, 2) of column and row, in the order of RPC00B
    denominators: np.ndarray  # (terms, 2), the first of each 1

    def project(self, ground: np.ndarray) -> np.ndarray:
        terms = polynomial_terms(self.ground.to(ground), self.order)
        with np.errstate(all="ignore"):
            return self.image.back((terms @ self.numerators) / (terms @ self.denominators))

    def as_rational(self) -> Rational:
        return self

    def padded(self) -> Rational:
        """This function with the 20 terms of order 3."""
        missing = ((0, len(EXPONENTS_3D) - len(self.numerators)), (0, 0))
        numerators, denominators = np.pad(self.numerators, missing), np.pad(self.denominators, missing)
        return Rational(3, self.ground, self.image, numerators, denominators)


@dataclass(frozen=True)
class Dlt(SensorModel):
    """Direct linear transformation: one common denominator. Source: Kurczynski and Wolniewicz, equation 4."""

    ground: Scaling
    image: Scaling
    coefficients: np.ndarray  # (12,) a1..a12 of the scaled coordinates; a12, of column times row, is 0 unless asked for

    def as_rational(self) -> Rational:
        """This function as quotients: y = (a5 + ...) / (1 + ... - a12 (a1 + ...))."""
        a = self.coefficients
        of_column = np.array([1.0, *a[8:11]])
        of_row = of_column - a[11] * a[0:4]
        numerators = np.column_stack([a[0:4], a[4:8] / of_row[0]])
        return Rational(1, self.ground, self.image, numerators, np.column_stack([of_column, of_row / of_row[0]]))


def fit_chosen_terms(ground: np.ndarray, image: np.ndarray, weights: np.ndarray) -> FittedModel:
    """Fit of order 2: linear numerators, and of other terms those that an F-test finds significant, one by one."""
    return fit_rational(ground, image, weights, CHOSEN_ORDER, _significant_terms)


def fit_rational(
    ground: np.ndarray, image: np.ndarray, weights: np.ndarray, order: int, choose: _Choice | None = None
) -> FittedModel:
    """Fit by iterated least squares, each step divided by the last one's denominator; ``weights`` (n,) 1 / standard
    deviation; ``choose`` tells which columns of a design matrix are taken. Source: Tao and Hu, A comprehensive study of
    the rational function model, 2001 (without their ridge)."""
    scale_g, scale_i = Scaling.of(ground), Scaling.of(image)
    terms, scaled = polynomial_terms(scale_g.to(ground), order), scale_i.to(image)
    count = terms.shape[1]
    numerators, denominators = np.zeros((count, 2)), np.zeros((count, 2))
    condition, iterations, converged, unknowns = 1.0, 1, True, 0
    for axis in (0, 1):
        wanted = scaled[:, axis]
        design = np.hstack([terms, -wanted[:, None] * terms[:, 1:]])
        chosen = choose(design * weights[:, None], wanted * weights) if choose else list(range(design.shape[1]))
        values = np.zeros(design.shape[1])
        denominator, last, settled, iteration = np.ones(len(terms)), np.full(len(terms), np.inf), False, 0
        while not settled and iteration < MAX_RATIONAL_ITERATIONS:
            iteration += 1
            row_weights = weights / denominator
            weighted = design[:, chosen] * row_weights[:, None]
            values[chosen], last_condition = least_squares(weighted, wanted * row_weights)
            denominator = off_poles(1 + terms[:, 1:] @ values[count:])
            seen = (terms @ values[:count]) / denominator
            settled = float(np.abs(seen - last).max()) * float(scale_i.scale[axis]) < limits.EXACT_STEP_PX
            last = seen
        numerators[:, axis], denominators[:, axis] = values[:count], [1.0, *values[count:]]
        condition, iterations = max(condition, last_condition), max(iterations, iteration)
        converged, unknowns = converged and settled, unknowns + len(chosen)
    model = Rational(order, scale_g, scale_i, numerators, denominators)
    return FittedModel(model, condition, iterations, converged, unknowns)


def _significant_terms(design: np.ndarray, wanted: np.ndarray) -> list[int]:
    """The columns of a design matrix (n, k) that are taken, the linear ones first, by orthogonal forward selection: as
    far as the points allow, and back to the last significant one, since the first of several may look like chance."""
    chosen, kept = list(range(LINEAR)), LINEAR
    basis = np.linalg.qr(design[:, chosen])[0]
    rest, unexplained = design - basis @ (basis.T @ design), wanted - basis @ (basis.T @ wanted)
    lengths = norm(design, axis=0)
    steps = max(min(len(wanted) - SPARE, design.shape[1]) - LINEAR, 0)
    for _ in range(steps):
        size = norm(rest, axis=0)
        size[chosen] = 0
        offered = size > _TOO_ALIKE * lengths
        if not offered.any() or float(unexplained @ unexplained) <= (_EXACT * norm(wanted)) ** 2:
            break
        gain = np.where(offered, (unexplained @ rest) ** 2 / np.where(offered, size, 1) ** 2, 0.0)
        best = int(np.argmax(gain))
        direction = rest[:, best] / size[best]
        chosen.append(best)
        unexplained = unexplained - direction * (direction @ unexplained)
        rest = rest - np.outer(direction, direction @ rest)
        spare = len(wanted) - len(chosen)
        chance = FALSE_ALARM / (np.count_nonzero(offered) * steps)
        # F with 1 and so many degrees of freedom is the square of Student's t.
        if gain[best] > critical_t(1 - chance, spare) ** 2 * (unexplained @ unexplained) / spare:
            kept = len(chosen)
    return chosen[:kept]


def off_poles(denominator: np.ndarray) -> np.ndarray:
    """Denominators kept away from zero while a fit is iterated."""
    return np.where(np.abs(denominator) < MIN_DENOMINATOR, MIN_DENOMINATOR, denominator)


def fit_dlt(ground: np.ndarray, image: np.ndarray, weights: np.ndarray, with_xy: bool) -> FittedModel:
    """Fit the direct linear transformation by iterated least squares; the arguments of ``fit_rational``."""
    scale_g, scale_i = Scaling.of(ground), Scaling.of(image)
    terms, scaled = polynomial_terms(scale_g.to(ground), 1), scale_i.to(image)
    x, y = scaled[:, :1], scaled[:, 1:]
    product = np.vstack([np.zeros_like(x), x * y]) if with_xy else np.empty((2 * len(x), 0))
    shared = -np.vstack([x, y]) * np.tile(terms[:, 1:], (2, 1))
    whole = np.hstack([np.kron(np.eye(2), terms), shared])
    wanted, both = np.concatenate([x, y])[:, 0], np.tile(weights, 2)
    denominator, bend, last, change = np.ones(len(x)), np.ones(len(x)), np.full((len(x), 2), np.inf), np.inf
    iteration = 0
    while iteration < MAX_RATIONAL_ITERATIONS and not change < limits.EXACT_STEP_PX:
        iteration += 1
        divided = np.tile(1 / denominator, 2)
        bent = both * np.concatenate([np.ones(len(x)), 1 / bend])
        design = np.hstack([whole * divided[:, None], product]) * bent[:, None]
        fitted, condition = least_squares(design, wanted * divided * bent)
        coefficients = np.zeros(12)
        coefficients[: len(fitted)] = fitted
        model = Dlt(scale_g, scale_i, coefficients)
        denominator = off_poles(1 + terms[:, 1:] @ coefficients[8:11])
        bend = 1 - coefficients[11] * x[:, 0]
        seen = model.project(ground)
        change = float(np.abs(seen - last).max())
        last = seen
    return FittedModel(model, condition, iteration, change < limits.EXACT_STEP_PX, len(fitted))


@dataclass(frozen=True)
class Polynomial3D(SensorModel):
    """Image coordinates as polynomials of x, y and z. Source: Kurczynski and Wolniewicz, equation 2."""

    order: int
    ground: Scaling
    image: Scaling
    coefficients: np.ndarray  # (terms, 2) of the scaled column and row, in the order of RPC00B

    def as_rational(self) -> Rational:
        ones = np.zeros_like(self.coefficients)
        ones[0] = 1.0
        return Rational(self.order, self.ground, self.image, self.coefficients, ones)


@dataclass(frozen=True)
class Polynomial2D(SensorModel):
    """Image coordinates as polynomials of x and y. Source: Kurczynski and Wolniewicz, equation 1."""

    SPATIAL: ClassVar[bool] = False

    order: int
    ground: Scaling  # of x and y
    image: Scaling
    coefficients: np.ndarray  # (terms, 2) of the scaled column and row, or of the scaled x and y when ``to_ground``
    to_ground: bool  # whether column and row are the arguments, as QGIS's georeferencer fits them

    def project(self, ground: np.ndarray) -> np.ndarray:
        scaled = self.ground.to(ground[:, :2])
        if not self.to_ground:
            return self.image.back(self._polynomial(scaled))
        start = (scaled - self.coefficients[0]) @ np.linalg.pinv(self.coefficients[1:3])
        return self.image.back(newton(self._polynomial, scaled, start))

    def _polynomial(self, scaled: np.ndarray) -> np.ndarray:
        return polynomial_terms(scaled, self.order, 2) @ self.coefficients


def fit_polynomial_3d(ground: np.ndarray, image: np.ndarray, weights: np.ndarray, order: int) -> FittedModel:
    """Fit by linear least squares: ``ground`` (n, 3), ``image`` (n, 2) px, ``weights`` (n,) 1 / standard deviation."""
    scale_g, scale_i = Scaling.of(ground), Scaling.of(image)
    design = polynomial_terms(scale_g.to(ground), order) * weights[:, None]
    values, condition = least_squares(design, scale_i.to(image) * weights[:, None])
    return FittedModel(Polynomial3D(order, scale_g, scale_i, values), condition, 1, True, values.size)


def fit_polynomial_2d(ground: np.ndarray, image: np.ndarray, weights: np.ndarray, order: int) -> FittedModel:
    """Fit a plane polynomial from the ground to the image, as the paper, and the other way round, as a georeferencer;
    the one that leaves the smaller residuals in the image is kept."""
    scale_g, scale_i = Scaling.of(ground[:, :2]), Scaling.of(image)
    scaled_g, scaled_i = scale_g.to(ground[:, :2]), scale_i.to(image)
    fits = []
    for to_ground, known, target in ((True, scaled_i, scaled_g), (False, scaled_g, scaled_i)):
        design = polynomial_terms(known, order, 2) * weights[:, None]
        values, condition = least_squares(design, target * weights[:, None])
        model = Polynomial2D(order, scale_g, scale_i, values, to_ground)
        misfit = (model.project(ground) - image) * weights[:, None]
        fits.append((float(np.sqrt(np.mean(misfit**2))), FittedModel(model, condition, 1, True, values.size)))
    (backward, to_ground_fit), (forward, to_image_fit) = fits
    rounding = 1e-9 * float(np.max(scale_i.scale)) * float(weights.max())
    return to_ground_fit if backward + rounding < forward else to_image_fit
