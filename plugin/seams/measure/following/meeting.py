"""More than two sources that meet in a wide feather, which mixes all of them: how much of each there is in the mosaic.

    m = sum of w_i x_i        by least squares over squares of 40 px, no weight below 0
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ..seam_cells import UNKNOWN
from .boxes import box_means, enlarged, in_squares, square_sums, widened
from .source_filters import cut_of

SHARES_PX = 8
REACH_PX = 128
"""How far from the ground that follows it a source may be mixed in: half a feather of 256 px."""

_SQUARES = 5  # a side that are looked at together
_MOST_LEFT = 0.8  # of what each source on its own side leaves over, for all of them to be mixed
_MOST_OF_ONE, _LEAST_THIRD = 0.6, 0.1  # shares where that which leaves least over need not be the greatest
_RIDGE, _LEAST_ENERGY = 1e-3, 1e-6  # so that weights are known of what has no detail


def where_several_meet(
    labels: np.ndarray, numbers: Sequence[int], valid: Mapping[int, np.ndarray]
) -> np.ndarray | None:
    """Sources of ``numbers`` that may be mixed in whole squares of 8 px, (sources, rows, columns) bool; more than two
    somewhere, else None. ``valid``: pixels that a source has, of those that don't have all."""
    rows, columns = (length // SHARES_PX for length in labels.shape)
    middles = np.s_[SHARES_PX // 2 :: SHARES_PX, SHARES_PX // 2 :: SHARES_PX]
    squares = labels[middles][:rows, :columns]
    near = np.stack([widened(squares == number, REACH_PX // SHARES_PX) for number in numbers])
    for mask, number in zip(near, numbers):
        if number in valid:
            mask &= in_squares(valid[number], SHARES_PX).all(axis=(1, 3))
    return near if (np.count_nonzero(near, axis=0) > 2).any() else None


def mixed_shares(
    mosaic: np.ndarray, sources: Mapping[int, np.ndarray], labels: np.ndarray, near: np.ndarray
) -> dict[int, np.ndarray]:
    """The share of every source, 0 to 1, in squares of 8 px, where several are mixed; 0 elsewhere.

    High-passed planes (rows, columns), the sources as the mosaic shows them; ``near`` as ``where_several_meet`` has it.
    """
    planes = [mosaic, *sources.values()]
    meet = np.count_nonzero(near, axis=0) > 2
    products = np.empty((int(np.count_nonzero(meet)), len(planes), len(planes)))
    for i, first in enumerate(planes):
        for j, second in enumerate(planes[i:], i):
            products[:, i, j] = products[:, j, i] = _around(first, second)[meet]
    weights = _weights(products[:, 1:, 1:], products[:, 0, 1:], near[:, meet].T)
    # A cut is no mixture, whatever lies around it.
    rest = mosaic - cut_of(mosaic, sources, labels)
    signed = np.concatenate([np.ones((len(weights), 1)), -weights], axis=1)
    left_over = np.einsum("ni,nij,nj->n", signed, products, signed)
    weights[left_over > _MOST_LEFT * _around(rest, rest)[meet]] = 0
    shares = np.zeros(near.shape, np.float32)
    shares[:, meet] = (weights / np.maximum(weights.sum(axis=1, keepdims=True), _LEAST_ENERGY)).T
    return dict(zip(sources, shares))


def by_shares(labels: np.ndarray, shares: Mapping[int, np.ndarray]) -> np.ndarray:
    """Labels (rows, columns) of the source that there is most of, where three are mixed and none is most of the mosaic:
    there a weak source leaves less over than that which is followed."""
    numbers, several = list(shares), np.stack(list(shares.values()))
    ordered = np.sort(several, axis=0)
    where = (ordered[-1] < _MOST_OF_ONE) & (ordered[-3] > _LEAST_THIRD)
    if not where.any():
        return labels
    most = np.array(numbers, np.uint8)[several.argmax(axis=0)]
    mixed = enlarged(where, SHARES_PX, labels.shape) & (labels != UNKNOWN)
    return np.where(mixed, enlarged(most, SHARES_PX, labels.shape), labels)


def _around(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Means of the products over 40 px around every square."""
    return box_means(square_sums(a, b, SHARES_PX), (_SQUARES,))[0]


def _weights(normal: np.ndarray, right: np.ndarray, near: np.ndarray) -> np.ndarray:
    """Weights of the sources, none below 0, (n, sources), by their products (n, sources, sources) and those with the
    mosaic (n, sources); ``near``, (n, sources) bool: the others weigh nothing."""
    identity = np.eye(right.shape[1])
    ridge = _LEAST_ENERGY + _RIDGE * np.einsum("nii->n", normal)
    normal = normal + ridge[:, np.newaxis, np.newaxis] * identity
    active = near.copy()
    for _ in range(right.shape[1]):
        both = active[:, :, np.newaxis] & active[:, np.newaxis, :]
        weights = np.linalg.solve(np.where(both, normal, identity), np.where(active, right, 0)[..., np.newaxis])[..., 0]
        if not (weights < 0).any():
            break
        active &= weights > 0
    return np.maximum(weights, 0)
