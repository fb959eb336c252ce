"""Quotients of polynomials with separate denominators, and the direct linear transformation."""
from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from .least_squares import Scaling
from .terms import COUNT_3D, terms_3d


@dataclass(frozen=True)
class Rational:
    """Column and row as quotients of polynomials of x, y and z. Source: Kurczynski and Wolniewicz, equation 3."""

    GEOGRAPHIC: ClassVar[bool] = False
    SPATIAL: ClassVar[bool] = True

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
class Dlt:
    """Direct linear transformation: one common denominator. Source: Kurczynski and Wolniewicz, equation 4."""

    GEOGRAPHIC: ClassVar[bool] = False
    SPATIAL: ClassVar[bool] = True

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
        return Rational(
            1, self.ground, self.image, numerators, np.column_stack([column_denominator, row_denominator / lead])
        )
