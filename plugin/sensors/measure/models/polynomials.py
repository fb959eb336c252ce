"""Plain polynomials of the plane and of space."""
from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from .least_squares import Scaling, least_squares
from .locating import newton
from .rational import Rational
from .sensor_model import FittedModel, SensorModel
from .terms import terms_2d, terms_3d


@dataclass(frozen=True)
class Polynomial3D(SensorModel):
    """Image coordinates as polynomials of x, y and z. Source: Kurczynski and Wolniewicz, equation 2."""

    order: int
    ground: Scaling
    image: Scaling
    coefficients: np.ndarray
    """(terms, 2) of the scaled column and row, in the order of RPC00B."""

    def project(self, ground: np.ndarray) -> np.ndarray:
        return self.image.back(terms_3d(self.ground.to(ground), self.order) @ self.coefficients)

    def as_rational(self) -> Rational:
        ones = np.zeros_like(self.coefficients)
        ones[0] = 1.0
        return Rational(self.order, self.ground, self.image, self.coefficients, ones)


@dataclass(frozen=True)
class Polynomial2D(SensorModel):
    """Image coordinates as polynomials of x and y. Source: Kurczynski and Wolniewicz, equation 1."""

    SPATIAL: ClassVar[bool] = False

    order: int
    ground: Scaling
    """Of x and y."""
    image: Scaling
    coefficients: np.ndarray
    """(terms, 2) of the scaled column and row, or of the scaled x and y when ``to_ground``."""
    to_ground: bool
    """Whether x and y are the polynomials and column and row their arguments, as QGIS's georeferencer fits them."""

    def project(self, ground: np.ndarray) -> np.ndarray:
        scaled = self.ground.to(ground[:, :2])
        if not self.to_ground:
            return self.image.back(self._polynomial(scaled))
        start = (scaled - self.coefficients[0]) @ np.linalg.pinv(self.coefficients[1:3])
        return self.image.back(newton(self._polynomial, scaled, start))

    def _polynomial(self, scaled: np.ndarray) -> np.ndarray:
        return terms_2d(scaled, self.order) @ self.coefficients


def fit_polynomial_3d(ground: np.ndarray, image: np.ndarray, weights: np.ndarray, order: int) -> FittedModel:
    """Fit by linear least squares: ``ground`` (n, 3), ``image`` (n, 2) px, ``weights`` (n,) 1 / standard deviation."""
    scale_g, scale_i = Scaling.of(ground), Scaling.of(image)
    design = terms_3d(scale_g.to(ground), order) * weights[:, None]
    solution = least_squares(design, scale_i.to(image) * weights[:, None])
    model = Polynomial3D(order, scale_g, scale_i, solution.values)
    return FittedModel(model, solution.condition, 1, True, solution.values.size)


def fit_polynomial_2d(ground: np.ndarray, image: np.ndarray, weights: np.ndarray, order: int) -> FittedModel:
    """Fit a plane polynomial; the same arguments.

    The paper writes it from the ground to the image, a georeferencer fits it from the image to the ground. Beyond
    order 1 neither family holds the other. Both are fitted, and the one that leaves the smaller residuals in the
    image is kept; the paper's where they leave the same.
    """
    scale_g, scale_i = Scaling.of(ground[:, :2]), Scaling.of(image)
    scaled_g, scaled_i = scale_g.to(ground[:, :2]), scale_i.to(image)
    fits = []
    for to_ground, known, target in ((True, scaled_i, scaled_g), (False, scaled_g, scaled_i)):
        solution = least_squares(terms_2d(known, order) * weights[:, None], target * weights[:, None])
        model = Polynomial2D(order, scale_g, scale_i, solution.values, to_ground)
        misfit = (model.project(ground) - image) * weights[:, None]
        fitted = FittedModel(model, solution.condition, 1, True, solution.values.size)
        fits.append((float(np.sqrt(np.mean(misfit**2))), fitted))
    (backward, to_ground_fit), (forward, to_image_fit) = fits
    rounding = 1e-9 * float(np.max(scale_i.scale)) * float(weights.max())
    return to_ground_fit if backward + rounding < forward else to_image_fit
