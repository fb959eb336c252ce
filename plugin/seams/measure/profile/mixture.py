"""What a mosaic is made of beside a seam: how much of either source, by distance.

    m = w_s s + w_o o + t k        by least squares in every bin of distance

s is the source that is followed, o the one beyond the seam, k what a hard cut has beside s (``cell_table``); the share
of o is alpha = w_o / (w_s + w_o), and the share of the source of the higher number grows evenly from one side of the
seam to the other (isotonic regression, Barlow et al. 1972). That is the feather itself. What such a mixture leaves of
the detail follows from the sources alone,

    kept = sum |(1 - alpha) p + alpha q|^2 / sum |p|^2

with p and q the same sources before anything came over the whole mosaic, which may have left only what they agree in,
without any ground to compare with. All functions take many seams at once.
"""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .cell_table import EDGES_PX, MIXED_BINS, PRODUCTS
from .seam_profile import UNMIXED_SHARE

SLOTS = 2 * MIXED_BINS
"""Bins on either side: first those that follow the source of the lower number, then the others."""

_AREA, _MM, _MS, _MO, _MK, _SS, _SO, _SK, _OO, _OK, _KK, _PP, _PQ, _QQ = range(len(PRODUCTS))
_NORMAL = np.array([[_SS, _SO, _SK], [_SO, _OO, _OK], [_SK, _OK, _KK]])
_ENERGIES = {False: (_SS, _SO, _OO), True: (_PP, _PQ, _QQ)}
_RIGHT = np.array([_MS, _MO, _MK])
_RIDGE = 1e-4
_LEAST_EDGE = 1e-3  # of the energy: less is no edge, and says nothing of t
_LEAST_COUNT = 1e-6  # of a bin that says nothing, so that means have something to be divided by
_LEAST_WEIGHT = 0.1  # of both sources together: with less the mosaic has neither
_EDGE_BINS = EDGES_PX.index(6)  # in which a cut's edge is
_SOFT, _SHARP = 0.15, 0.5
"""Of t / (w_s + w_o): with less a seam is so soft that k only takes from the mixture and is left out, with more it is
needed. A cosine feather of 13 px has 0.45, one of 33 px 0.2."""
_NO_MIXTURE, _A_MIXTURE = 0.15, 0.25
"""Of the other source beside the border, where a feather mixes halves: what is no more there, and everywhere alike, is
what one image resampled takes of another of the same ground."""
_EITHER, _FOLLOWED = 0.4, 0.6
"""Of a mixture: what has surely more of a source than halves follows that. Of halves nobody knows which is followed."""
MOST_EVERYWHERE = 0.25
"""The same far off, of which a width is taken above that."""
_CUT, _FEATHERED = 1.0, 0.6
"""The same: a cut has 0.9 to 1, and mixes nothing."""


@dataclass(frozen=True, eq=False)
class Mixtures:
    """Of n seams, (n, SLOTS) each."""

    other: np.ndarray
    """Share of the other source, 0 to 1: alpha."""
    edge: np.ndarray
    """Energy of the mosaic's detail that is the cut's edge, DN squared."""
    left: np.ndarray
    """Energy that neither source nor the edge explains, DN squared."""
    soft: np.ndarray
    """(n, 1): 1 for a feather so wide that its ramp makes detail of its own out of what the sources differ by, 0 for a
    cut."""


def fit_mixtures(products: np.ndarray) -> Mixtures:
    """From ``PRODUCTS`` of one level, (n, SLOTS, PRODUCTS)."""
    with_edge, without = _weights(products, True), _weights(products, False)
    near = np.zeros(SLOTS, bool)
    near[np.arange(SLOTS) % MIXED_BINS < _EDGE_BINS] = True
    edges = products[:, near, _KK]
    total, t = with_edge[:, near, :2].sum(axis=2), with_edge[:, near, 2]
    left = (t * edges).sum(axis=1) / np.maximum((np.maximum(total, _LEAST_WEIGHT) * edges).sum(axis=1), 1e-12)
    sharp = np.clip((left - _SOFT) / (_SHARP - _SOFT), 0, 1)[:, np.newaxis, np.newaxis]
    weights = sharp * with_edge + (1 - sharp) * without
    softness = np.clip((_CUT - left) / (_CUT - _FEATHERED), 0, 1)[:, np.newaxis]
    normal, right = products[..., _NORMAL], products[..., _RIGHT]
    of_edge = np.einsum("ns,nsi,nsi->ns", weights[..., 2], weights, products[..., [_SK, _OK, _KK]])
    of_edge += np.einsum("ns,nsi,nsi->ns", weights[..., 2], weights[..., :2], products[..., [_SK, _OK]])
    fitted = np.einsum("nsi,nsij,nsj->ns", weights, normal, weights) - 2 * np.einsum("nsi,nsi->ns", weights, right)
    soft, other = 1 - sharp[:, :, 0], _shares(products, weights)
    most = other[:, near].max(axis=1, keepdims=True)
    softness *= np.clip((most - _NO_MIXTURE) / (_A_MIXTURE - _NO_MIXTURE), 0, 1)
    return Mixtures(softness * other, of_edge, np.maximum(products[..., _MM] + fitted, 0), soft)


def mixed_energy(products: np.ndarray, other: np.ndarray, before: bool = True) -> np.ndarray:
    """Of the detail of sources mixed so, DN squared; (..., SLOTS, PRODUCTS) and (..., SLOTS). ``before``: anything came
    over the whole mosaic."""
    own, (ss, so, oo) = 1 - other, (products[..., of] for of in _ENERGIES[before])
    return np.asarray(own**2 * ss + 2 * own * other * so + other**2 * oo)


def followed_energy(products: np.ndarray, other: np.ndarray, before: bool = True) -> np.ndarray:
    """Of the detail of the source that is truly followed, DN squared; beyond a border that was drawn in the wrong place
    that is the other one, and of halves that do not end it is the mean of both: a border that is drawn through them
    goes round whatever has more detail."""
    ss, _, oo = (products[..., of] for of in _ENERGIES[before])
    of_other = np.where(other > _FOLLOWED, 1.0, 0.0)
    of_either = np.clip((other - _EITHER) / (_FOLLOWED - _EITHER), 0, 1)
    of_other = np.where(_is_endless(products[..., _AREA], other), of_either, of_other)
    return np.asarray((1 - of_other) * ss + of_other * oo)


def _is_endless(area: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Slots on a side on which the mixture is one of halves as far as it is known, (..., SLOTS) bool."""
    sides = (*area.shape[:-1], 2, MIXED_BINS)
    known, shares = (area > 0).reshape(sides), np.broadcast_to(other, area.shape).reshape(sides)
    last = MIXED_BINS - 1 - known[..., ::-1].argmax(axis=-1)
    far = np.take_along_axis(shares, last[..., np.newaxis], axis=-1) >= _EITHER
    return np.asarray(np.broadcast_to(far, shares.shape).reshape(area.shape))


def feather_width_px(other: np.ndarray) -> float:
    """Full width of a linear feather that takes as far as this from a share of 10 to one of 90 %, by shares of the
    other source (SLOTS,); 0 for a cut. As wide as can be seen where it does not end; on one side alone it ends on the
    other as well, since all that tells of a mixture there is too weak."""
    middles = [(near + far) / 2 for near, far in zip(EDGES_PX, EDGES_PX[1 : MIXED_BINS + 1])]
    reached = []
    for side in other.reshape(2, MIXED_BINS):
        everywhere = float(side[-1]) if side[-1] < MOST_EVERYWHERE else 0.0
        unmixed = UNMIXED_SHARE + everywhere
        mixed = np.flatnonzero(side >= unmixed)
        last = int(mixed[-1]) if len(mixed) else -1
        if last < 0:
            reached.append(0.0)
        elif last == MIXED_BINS - 1:
            reached.append(float(EDGES_PX[MIXED_BINS]))
        else:
            share = (side[last] - unmixed) / max(side[last] - side[last + 1], 1e-9)
            reached.append(middles[last] + float(share) * (middles[last + 1] - middles[last]))
    least, most = sorted(reached)
    width = 2 * least if 0 < least < most == EDGES_PX[MIXED_BINS] else least + most
    return width / (1 - 2 * UNMIXED_SHARE)


def _weights(products: np.ndarray, with_edge: bool) -> np.ndarray:
    """w_s, w_o and t of every bin, (n, SLOTS, 3); those of the followed source alone where there is nothing."""
    normal, right = products[..., _NORMAL].astype(float), products[..., _RIGHT].astype(float)
    diagonal = np.einsum("nsii->nsi", normal)  # a view
    energy = np.maximum(diagonal[..., 0], diagonal[..., 1])
    no_edge = diagonal[..., 2] < _LEAST_EDGE * energy if with_edge else np.ones(energy.shape, bool)
    for part in (normal[..., 2, :2], normal[..., :2, 2]):
        part[no_edge] = 0
    right[no_edge, 2], diagonal[no_edge, 2] = 0, 1
    diagonal *= 1 + _RIDGE
    empty = energy <= 0
    normal[empty], right[empty] = np.eye(3), (1, 0, 0)
    return np.linalg.solve(normal, right[..., np.newaxis])[..., 0]


def _shares(products: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Of the other source in every bin: those of the higher number never fall on the way across the seam."""
    total = weights[..., 0] + weights[..., 1]
    known = (total > _LEAST_WEIGHT) & (products[..., _AREA] > 0)
    other = np.clip(np.divide(weights[..., 1], total, out=np.zeros_like(total), where=known), -0.5, 1.5)
    difference = np.maximum(products[..., _SS] + products[..., _OO] - 2 * products[..., _SO], 0)
    counts = np.where(known, difference, 0)
    counts += _LEAST_COUNT * counts.max(axis=1, keepdims=True) + _LEAST_COUNT
    lower, higher = slice(MIXED_BINS - 1, None, -1), slice(MIXED_BINS, None)
    across = np.concatenate([other[:, lower], 1 - other[:, higher]], axis=1)
    rising = isotonic(across, np.concatenate([counts[:, lower], counts[:, higher]], axis=1)).clip(0, 1)
    return np.concatenate([rising[:, lower], 1 - rising[:, higher]], axis=1)


def isotonic(values: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """The nearest rows of values that never fall, by weighted least squares, (n, length) each: by the formula of the
    largest of the smallest means (Barlow et al. 1972), which takes all rows at once."""
    sums, counts = (
        np.pad(np.cumsum(one, axis=1), ((0, 0), (1, 0))) for one in (values * weights, weights)
    )
    length = values.shape[1]
    first, last = np.triu_indices(length)
    means = np.full((len(values), length, length), np.inf)
    means[:, first, last] = (sums[:, last + 1] - sums[:, first]) / (counts[:, last + 1] - counts[:, first])
    least = np.minimum.accumulate(means[:, :, ::-1], axis=2)[:, :, ::-1]
    least[:, np.tril(np.ones((length, length), bool), -1)] = -np.inf  # runs that begin behind a place
    return np.asarray(least.max(axis=1))
