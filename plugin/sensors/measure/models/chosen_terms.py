"""Quotients with terms left out: only those that the points speak for."""
from __future__ import annotations

import numpy as np
from numpy.linalg import norm

from .least_squares import Scaling, least_squares
from .rational import (
    MAX_RATIONAL_ITERATIONS,
    MAX_RATIONAL_STEP_PX,
    Rational,
    off_poles,
)
from .sensor_model import FittedModel
from .terms import EXPONENTS_3D, terms_3d

FALSE_ALARM = 0.01  # that any of all terms offered comes in though it means nothing
SPARE = 3  # points more than an axis has unknowns, so that what is left over says something
LINEAR = 4  # the constant, x, y and z of the numerator are never left out
ORDER = 2  # of the terms offered: a higher one does not improve satellite images (Kurczynski and Wolniewicz)
_EXACT = 1e-12  # of the coordinates: nothing is left over that a term could explain
_TOO_ALIKE = 1e-6  # of a term's length that the chosen ones do not explain


def fit_chosen_terms(ground: np.ndarray, image: np.ndarray, weights: np.ndarray) -> FittedModel:
    """Fit quotients of order 2 with the terms that are significant, separately for column and row.

    It begins with the numerator's linear terms. Of all others, of numerator and denominator, the one comes in that
    takes most off the residuals, as long as an F-test over all that are offered says that it is no chance.
    """
    scale_g, scale_i = Scaling.of(ground), Scaling.of(image)
    terms, scaled = terms_3d(scale_g.to(ground), ORDER), scale_i.to(image)
    count = terms.shape[1]
    numerators, denominators = np.zeros((count, 2)), np.zeros((count, 2))
    condition, iterations, converged, unknowns = 1.0, 1, True, 0
    for axis in (0, 1):
        whole = np.hstack([terms, -scaled[:, axis, None] * terms[:, 1:]])
        chosen = _chosen(whole * weights[:, None], scaled[:, axis] * weights)
        values = np.zeros(whole.shape[1])
        denominator, last, settled = np.ones(len(terms)), np.full(len(terms), np.inf), False
        iteration = 0
        while not settled and iteration < MAX_RATIONAL_ITERATIONS:
            iteration += 1
            share = weights / denominator
            solution = least_squares(whole[:, chosen] * share[:, None], scaled[:, axis] * share)
            values[chosen] = solution.values
            denominator = off_poles(1 + terms[:, 1:] @ values[count:])
            seen = (terms @ values[:count]) / denominator
            settled = float(np.abs(seen - last).max()) * float(scale_i.scale[axis]) < MAX_RATIONAL_STEP_PX
            last = seen
        numerators[:, axis], denominators[:, axis] = values[:count], [1.0, *values[count:]]
        condition, iterations = max(condition, solution.condition), max(iterations, iteration)
        converged, unknowns = converged and settled, unknowns + len(chosen)
    model = Rational(ORDER, scale_g, scale_i, numerators, denominators)
    return FittedModel(model, condition, iterations, converged, unknowns)


def terms_told(model: Rational) -> str:
    """Which terms a model of chosen terms has, such as ``column: 1 x y z xz / 1 x; row: 1 x y z / 1``."""
    names = ["".join(letter * power for letter, power in zip("xyz", powers)) or "1" for powers in EXPONENTS_3D]
    parts = []
    for axis, side in enumerate(("column", "row")):
        above, below = (
            " ".join(name for name, value in zip(names, part[:, axis]) if value != 0)
            for part in (model.numerators, model.denominators)
        )
        parts.append(f"{side}: {above} / {below}")
    return "; ".join(parts)


def _chosen(design: np.ndarray, wanted: np.ndarray) -> list[int]:
    """Which columns of a design matrix (n, k) are taken, the linear ones first, by orthogonal forward selection.

    It goes on as far as the points allow, and back to the last term that was significant: the first of several may
    look like chance while the others are missing.
    """
    chosen, kept = list(range(LINEAR)), LINEAR
    basis = np.linalg.qr(design[:, chosen])[0]
    rest, left = design - basis @ (basis.T @ design), wanted - basis @ (basis.T @ wanted)
    lengths = norm(design, axis=0)
    steps = max(min(len(wanted) - SPARE, design.shape[1]) - LINEAR, 0)
    for _ in range(steps):
        size = norm(rest, axis=0)
        size[chosen] = 0
        offered = size > _TOO_ALIKE * lengths
        if not offered.any() or float(left @ left) <= (_EXACT * norm(wanted)) ** 2:
            break
        gain = np.where(offered, (left @ rest) ** 2 / np.where(offered, size, 1) ** 2, 0.0)
        best = int(np.argmax(gain))
        direction = rest[:, best] / size[best]
        chosen.append(best)
        left, rest = left - direction * (direction @ left), rest - np.outer(direction, direction @ rest)
        spare = len(wanted) - len(chosen)
        if gain[best] > f_limit(FALSE_ALARM / (np.count_nonzero(offered) * steps), spare) * (left @ left) / spare:
            kept = len(chosen)
    return chosen[:kept]


def f_limit(probability: float, freedom: int) -> float:
    """The value that F with 1 and ``freedom`` degrees exceeds with a probability: the square of Student's t."""
    angle = np.linspace(0, np.pi / 2, 200_001)[:-1]  # t = sqrt(freedom) tan(angle): the density is a power of cosine
    density = np.cos(angle) ** (freedom - 1)
    beyond = 1 - np.cumsum(density) / density.sum()
    return float(freedom * np.tan(angle[int(np.argmax(beyond <= probability))]) ** 2)
