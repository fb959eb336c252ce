"""Pixels to millimetres and back: similarity, affine and projective, by least squares."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from ...imagery.errors import PhotoError
from . import limits, messages

MIN_WIDTH = 0.05  # of marks across the line that they lie along: thinner, an error grows twentyfold beside it
MIN_CONDITION = 0.02  # of the projective model's equations: four corners have 0.38, three on a line and one beside 0.01

LEAST_MARKS = {limits.SIMILARITY: 2, limits.AFFINE: 3, limits.PROJECTIVE: 4}  # with none left over for a check
_PARAMETERS = {limits.SIMILARITY: 4, limits.AFFINE: 6, limits.PROJECTIVE: 8}


@dataclass(frozen=True, eq=False)
class Transformation:
    model: str
    matrix: np.ndarray  # (3, 3) homogeneous, its last element 1

    def __call__(self, points: np.ndarray) -> np.ndarray:
        """(n, 2) transformed."""
        made = np.column_stack([points, np.ones(len(points))]) @ self.matrix.T
        return np.asarray(made[:, :2] / made[:, 2:])

    @property
    def inverse(self) -> Transformation:
        matrix = np.linalg.inv(self.matrix)
        return Transformation(self.model, matrix / matrix[2, 2])

    def linear(self, points: np.ndarray) -> np.ndarray:
        """(2, 3): the affine transformation that comes nearest at some points; itself unless projective."""
        if self.model != limits.PROJECTIVE:
            return np.asarray(self.matrix[:2])
        return np.asarray(fit_transformation(limits.AFFINE, points, self(points), mirrored=None).matrix[:2])


def redundancy(model: str, marks: int) -> int:
    """Degrees of freedom: observed coordinates less unknowns. Below 1 the residuals say nothing."""
    return 2 * marks - _PARAMETERS[model]


def fit_transformation(
    model: str, source: np.ndarray, target: np.ndarray, mirrored: bool | None = None
) -> Transformation:
    """The transformation of (n, 2) points to (n, 2) points with the least squares of residuals in the target. A
    similarity keeps its sense of rotation or, when ``mirrored``, turns it round; None takes the better one. Raises
    PhotoError for too few points or for points in one place or on one line."""
    if len(source) < LEAST_MARKS[model]:
        least, word = LEAST_MARKS[model], messages.WORDS[model]
        raise PhotoError(messages.TOO_FEW_MARKS(model=word, least=least, count=len(source)))
    source, target = np.asarray(source, dtype=np.float64), np.asarray(target, dtype=np.float64)
    centre, size = source.mean(axis=0), max(float(np.abs(source - source.mean(axis=0)).max()), 1e-300)
    for points in (source, target):
        spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
        if spread[0] < 1e-9 or (model != limits.SIMILARITY and spread[1] < MIN_WIDTH * spread[0]):
            raise PhotoError(messages.MARKS_ON_A_LINE(model=messages.WORDS[model]))
    normalise = np.array([[1 / size, 0, -centre[0] / size], [0, 1 / size, -centre[1] / size], [0, 0, 1]])
    scaled = (source - centre) / size
    if model == limits.SIMILARITY:
        made = min(
            (_similarity(scaled, target, mirror) for mirror in ((False, True) if mirrored is None else (mirrored,))),
            key=lambda matrix: float(np.sum((Transformation(limits.AFFINE, matrix)(scaled) - target) ** 2)),
        )
    elif model == limits.AFFINE:
        made = _affine(scaled, target)
    else:
        made = _projective(scaled, target)
    matrix = made @ normalise
    return Transformation(model, matrix / matrix[2, 2])


def _similarity(source: np.ndarray, target: np.ndarray, mirrored: bool) -> np.ndarray:
    """A complex factor and shift; the points are mirrored before."""
    sign = -1.0 if mirrored else 1.0
    numbers, aim = source @ [1, sign * 1j], target @ [1, 1j]
    factor, shift = np.linalg.lstsq(np.column_stack([numbers, np.ones(len(numbers))]), aim, rcond=None)[0]
    a, b = factor.real, factor.imag
    return np.array([[a, -sign * b, shift.real], [b, sign * a, shift.imag], [0.0, 0.0, 1.0]])


def _affine(source: np.ndarray, target: np.ndarray) -> np.ndarray:
    rows = np.column_stack([source, np.ones(len(source))])
    return np.vstack([np.linalg.lstsq(rows, target, rcond=None)[0].T, [0.0, 0.0, 1.0]])


def _projective(source: np.ndarray, target: np.ndarray) -> np.ndarray:
    """The least squares of the residuals themselves, from the affine transformation on."""
    shift, scale = target.mean(axis=0), max(float(np.abs(target - target.mean(axis=0)).max()), 1e-300)
    aim = (target - shift) / scale

    def matrix(parameters: np.ndarray) -> np.ndarray:
        return np.append(parameters, 1.0).reshape(3, 3)

    def residuals(parameters: np.ndarray) -> np.ndarray:
        return (Transformation(limits.PROJECTIVE, matrix(parameters))(source) - aim).ravel()

    start = np.append(_affine(source, aim)[:2].ravel(), [0.0, 0.0])
    made = least_squares(residuals, start, "3-point", ftol=1e-15, xtol=1e-15, gtol=1e-15)
    singular = np.linalg.svd(made.jac, compute_uv=False)
    if singular[-1] < MIN_CONDITION * singular[0]:
        raise PhotoError(messages.MARKS_ON_A_LINE(model=messages.WORDS[limits.PROJECTIVE]))
    back = np.array([[scale, 0, shift[0]], [0, scale, shift[1]], [0, 0, 1]])
    return np.asarray(back @ matrix(made.x))
