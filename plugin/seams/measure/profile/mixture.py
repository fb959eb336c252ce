"""What a mosaic is made of beside a seam: how much of either source, by distance.

    m = w_s s + w_o o + t k        by least squares in every bin of distance

s is the source that is followed, o the one beyond the seam, k what a hard cut has beside s (``cell_table``); the share
of o is alpha = w_o / (w_s + w_o), by distance one ramp from one source to the other (``ramps``). That is the feather
itself. What such a mixture leaves of the detail follows from the sources alone,

    kept = sum |(1 - alpha) p + alpha q|^2 / sum |p|^2

with p and q the same sources before anything came over the whole mosaic, which may have left only what they agree in,
without any ground to compare with. All functions take many seams at once.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .cell_table import EDGES_PX, MIXED_BINS, PRODUCTS, MixtureTable
from .energy_sums import ALONG, BLOCK_CELLS
from .ground import FAR_PX
from .intervals import Kept
from .ramps import BEYOND, fit_ramps
from .seam_profile import UNMIXED_SHARE, in_strip, strip_bins

SLOTS = 2 * MIXED_BINS
"""Bins on either side: first those that follow the source of the lower number, then the others."""

_AREA, _MM, _MS, _MO, _MK, _SS, _SO, _SK, _OO, _OK, _KK, _PP, _PQ, _QQ, _CODEC = range(len(PRODUCTS))
_NORMAL = np.array([[_SS, _SO, _SK], [_SO, _OO, _OK], [_SK, _OK, _KK]])
_RIGHT = np.array([_MS, _MO, _MK])
_SHOWN, _BEFORE = (_SS, _SO, _OO), (_PP, _PQ, _QQ)
_RIDGE = 1e-4
_LEAST_EDGE = 1e-3  # of the energy: less is no edge, and says nothing of t
_LEAST_WEIGHT = 0.1  # of both sources together: with less the mosaic has neither
_EDGE_BINS = EDGES_PX.index(6)  # in which a cut's edge is
_SOFT, _SHARP = 0.15, 0.5
"""Values of t / (w_s + w_o): with less a seam is so soft that k only takes from the mixture and is left out, with more
it is needed. A cosine feather of 13 px has 0.45, one of 33 px 0.2."""
_EITHER, _FOLLOWED = 0.4, 0.6
"""Shares of a source in a mixture: what has surely more than half of it follows it; of halves nobody knows which is
followed."""
_FAR = EDGES_PX.index(FAR_PX)
MOST_UNEVEN = 2.0
"""What codecs and noise leave over at most, as a multiple of what they do on the ground in the mean. With 1.0 two of 17
hard cuts whose orthoimages were compressed since read 0.64 and 0.65 for 0.84 and 0.76; 3.0 changed none of 107
mosaics."""
MOST_EVERYWHERE = 0.25
"""Share of the other source far off, from which on a mixture has no end; a width is taken above one that is less."""


@dataclass(frozen=True, eq=False)
class Mixtures:
    """Mixtures of n seams."""

    other: np.ndarray
    """(n, SLOTS): share of the other source, 0 to 1: alpha."""
    unsure: np.ndarray
    """(n, SLOTS): standard deviation of ``other`` between the feathers that may be."""
    blended: np.ndarray
    """(n, 1): how likely it is that the seam is no cut."""
    edge: np.ndarray
    """(n, levels, SLOTS): energy of the mosaic's detail that is the cut's edge, DN squared."""
    left_over: np.ndarray
    """(n, levels, SLOTS): energy that neither source nor the edge explains, DN squared."""
    soft_left_over: np.ndarray
    """(n, levels, SLOTS): as much of it as a feather's ramp makes of what the sources differ by, or a codec of their
    mixture, DN squared; a cut has neither."""
    rounded: np.ndarray
    """(n, levels, SLOTS): as much of that as a codec makes, DN squared."""
    carried: np.ndarray
    """(n, SLOTS): weights of both sources together: less than on the ground where something else is in their place."""
    known: np.ndarray
    """(n, SLOTS) bool: bins in which the share is known."""


def _shares(products: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Share of the other source in every bin by itself, (..., SLOTS), from ``PRODUCTS`` (..., SLOTS, PRODUCTS); NaN
    where the mosaic has neither."""
    total = weights[..., 0] + weights[..., 1]
    known = (total > _LEAST_WEIGHT) & (products[..., _AREA] > 0)
    share = np.divide(weights[..., 1], total, out=np.full_like(total, np.nan), where=known)
    return np.asarray(np.clip(share, -0.5, 1.5))


def fit_mixtures(products: np.ndarray, spread: np.ndarray) -> Mixtures:
    """Mixtures by ``PRODUCTS`` of every level, (n, levels, SLOTS, PRODUCTS), and the standard deviation of the finest
    level's shares (n, SLOTS)."""
    weights, sharp = _sharp_weights(products)
    source, other, edge = np.moveaxis(weights, -1, 0)
    of_edge = edge * (2 * (source * products[..., _SK] + other * products[..., _OK]) + edge * products[..., _KK])
    fitted = np.einsum("...i,...ij,...j->...", weights, products[..., _NORMAL], weights)
    left_over = np.maximum(products[..., _MM] + fitted - 2 * (weights * products[..., _RIGHT]).sum(axis=-1), 0)
    soft, carried = 1 - sharp[:, :1], np.maximum(source + other, 0)
    rounded = soft * _rounded(products, left_over)
    difference = products[..., _SS] - 2 * products[..., _SO] + products[..., _OO]
    told_apart = np.maximum(carried**2 * difference, 1e-12)
    spread = _at_least(spread, products[:, 0, :, _AREA], left_over[:, 0], told_apart[:, 0])
    shares, spread = _over_levels(_shares(products, weights), spread, ALONG**2 * rounded / told_apart)
    mixed, unsure, blended = fit_ramps(shares, spread, _most_floor(products[:, 0], left_over[:, 0]))
    return Mixtures(
        mixed, unsure, blended, of_edge, left_over, soft * left_over, rounded, carried[:, 0], np.isfinite(spread)
    )


def _at_least(spread: np.ndarray, area: np.ndarray, left_over: np.ndarray, told_apart: np.ndarray) -> np.ndarray:
    """Standard deviations of shares, none too small by chance, as those of few groups are; (n, SLOTS), as the others.

    By regression their squares go with the ground's noise, which is ``left_over`` there, and with the inverse of the
    energy that the sources are ``told_apart`` by; the median of a seam's bins tells the factor (as Smyth 2004 does)."""
    is_ground = np.arange(SLOTS) % MIXED_BINS >= BEYOND
    noise, ground = ((values * is_ground).sum(axis=1, keepdims=True) for values in (left_over, area))
    known = np.isfinite(spread) & (area > 0) & (noise > 0)
    deviation = np.where(known, np.sqrt(noise / np.maximum(ground, 1) / told_apart), 0)
    factor = np.ma.median(np.ma.masked_where(~known, spread / np.where(known, deviation, 1)), axis=1).filled(0)
    return np.asarray(np.maximum(spread, factor[:, np.newaxis] * deviation))


def _rounded(products: np.ndarray, left_over: np.ndarray) -> np.ndarray:
    """Energy that a codec makes of a mixture which it rounds for the first time, (n, levels, SLOTS), DN squared.

    Where the mosaic shows traces of a codec, it is what is left over beside the seam alone, as a share of the mosaic's
    detail in the strip more than at the next coarser level: a mixture that varies along the seam leaves over much the
    same share at all levels, a codec the less the coarser.
    """
    area, mm, ss, codec = (products[..., name] for name in (_AREA, _MM, _SS, _CODEC))
    followed, around = (
        values.reshape(*values.shape[:-1], 2, MIXED_BINS)[..., _FAR:].sum(axis=-1) for values in (ss, left_over)
    )
    beside = left_over - MOST_UNEVEN * np.repeat(around / np.maximum(followed, 1e-12), MIXED_BINS, axis=-1) * ss
    strip = np.stack([np.arange(SLOTS) % MIXED_BINS < strip_bins(level).stop for level in range(mm.shape[1])])
    share = np.maximum((beside * strip).sum(axis=-1), 0) / np.maximum((mm * strip).sum(axis=-1), 1e-12)
    more = share - np.concatenate([share[:, 1:], share[:, -1:]], axis=1)
    part = np.maximum(more, 0) / np.maximum(share, 1e-12)
    return np.asarray(part[..., np.newaxis] * np.maximum(beside, 0) * codec / np.maximum(area, 1))


def _over_levels(shares: np.ndarray, spread: np.ndarray, variance: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Shares of all levels together, (n, SLOTS), and their standard deviation, infinite where none is known.

    All levels are mixed alike. The finest tells it best, with most coefficients and the least of a cut's edge; coarser
    ones, each with a quarter of them, which codecs round less, count as far as rounding makes the finest unsure.
    ``variance``: by that rounding, (n, levels, SLOTS)."""
    weights = 1 / (4.0 ** np.arange(shares.shape[1])[:, np.newaxis] * np.square(spread)[:, np.newaxis] + variance)
    weights[:, 1:] *= 1 - weights[:, :1] * np.where(np.isfinite(spread), np.square(spread), 0)[:, np.newaxis]
    weights[np.isnan(shares)] = 0
    total = weights.sum(axis=1)
    with np.errstate(divide="ignore"):
        deviation = np.sqrt(1 / total)
    return (weights * np.nan_to_num(shares)).sum(axis=1) / np.maximum(total, 1e-12), deviation


def _most_floor(products: np.ndarray, left_over: np.ndarray) -> np.ndarray:
    """Share of the other source that noise of either side's own one can make of pure ground, (n, 2), by what is left
    over beyond the strip, DN squared.

    With rho the correlation of the sources, the other one explains at most rho^2 of what noise took of the followed
    one, w_o^2 oo (1 - rho^2), and leaves over (1 - rho^2) / rho^2 times as much. A mixture leaves nothing over.
    """
    ss, so, oo, rest = (
        values.reshape(-1, 2, MIXED_BINS)[..., BEYOND:].sum(axis=2)
        for values in (*(products[..., product] for product in _SHOWN), left_over)
    )
    rho = np.clip(so / np.sqrt(np.maximum(ss * oo, 1e-12)), 0, 0.99)
    return np.asarray(rho / (1 - rho**2) * np.sqrt(rest / np.maximum(oo, 1e-12)))


def _sharp_weights(products: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """w_s, w_o and t of every bin, (..., SLOTS, 3), and how sharp each seam is, (..., 1)."""
    with_edge, without = _weights(products, True), _weights(products, False)
    near = np.arange(SLOTS) % MIXED_BINS < _EDGE_BINS
    edges = products[..., near, _KK]
    total, t = with_edge[..., near, :2].sum(axis=-1), with_edge[..., near, 2]
    part = (t * edges).sum(axis=-1) / np.maximum((np.maximum(total, _LEAST_WEIGHT) * edges).sum(axis=-1), 1e-12)
    sharp = np.clip((part - _SOFT) / (_SHARP - _SOFT), 0, 1)[..., np.newaxis]
    return sharp[..., np.newaxis] * with_edge + (1 - sharp[..., np.newaxis]) * without, sharp


def mixed_energy(products: np.ndarray, other: np.ndarray, names: Sequence[int] = _BEFORE) -> np.ndarray:
    """Energy of the detail of sources mixed so, DN squared; (..., SLOTS, PRODUCTS) and (..., SLOTS). ``names``: the
    products of the sources before anything came over the whole mosaic, or as it shows them."""
    followed, (ss, so, oo) = 1 - other, (products[..., name] for name in names)
    return np.asarray(followed**2 * ss + 2 * followed * other * so + other**2 * oo)


def followed_energy(products: np.ndarray, other: np.ndarray, names: Sequence[int] = _BEFORE) -> np.ndarray:
    """Energy of the detail of the source that is truly followed, DN squared; beyond a border that was drawn in the
    wrong place that is the other one, and of halves that do not end it is the mean of both: a border that is drawn
    through them goes round whatever has more detail."""
    ss, _, oo = (products[..., name] for name in names)
    either = np.clip((other - _EITHER) / (_FOLLOWED - _EITHER), 0, 1)
    of_other = np.where(_is_endless(products[..., _AREA], other), either, other > _FOLLOWED)
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
    edges, reached = np.array(EDGES_PX[: MIXED_BINS + 1], float), []
    middles = (edges[:-1] + edges[1:]) / 2
    for side in other.reshape(2, MIXED_BINS):
        unmixed = UNMIXED_SHARE + (side[-1] if side[-1] < MOST_EVERYWHERE else 0.0)
        beyond = int(np.append(0, np.flatnonzero(side >= unmixed) + 1)[-1])  # of the last bin that is mixed
        if 0 < beyond < MIXED_BINS:
            ends = np.s_[beyond - 1 : beyond + 1]
            reached.append(float(np.interp(-unmixed, -side[ends], middles[ends])))
        else:
            reached.append(float(edges[beyond]))
    least, most = sorted(reached)
    width = 2 * least if 0 < least < most == edges[-1] else least + most
    return width / (1 - 2 * UNMIXED_SHARE)


def _weights(products: np.ndarray, with_edge: bool) -> np.ndarray:
    """w_s, w_o and t of every bin, (..., SLOTS, 3); those of the followed source alone where there is nothing."""
    normal, right = products[..., _NORMAL].astype(float), products[..., _RIGHT].astype(float)
    diagonal = np.einsum("...ii->...i", normal)  # a view
    energy = np.maximum(diagonal[..., 0], diagonal[..., 1])
    no_edge = diagonal[..., 2] < _LEAST_EDGE * energy if with_edge else np.ones(energy.shape, bool)
    for part in (normal[..., 2, :2], normal[..., :2, 2]):
        part[no_edge] = 0
    right[no_edge, 2], diagonal[no_edge, 2] = 0, 1
    diagonal *= 1 + _RIDGE
    np.maximum(diagonal, _RIDGE * energy[..., np.newaxis], out=diagonal)  # a source without detail weighs nothing
    empty = energy <= 0
    normal[empty], right[empty] = np.eye(3), (1, 0, 0)
    return np.linalg.solve(normal, right[..., np.newaxis])[..., 0]


GROUPS = 8
"""Groups of blocks of 32 px, each left out in turn: the jackknife (Tukey 1958)."""
SHARE_ERROR, BORDER_ERROR = 0.003, 0.05
"""Errors of a share, however much there is in its bin: what rounding leaves; and within 2 px of the border: one that
is drawn with a standard deviation of a quarter of a pixel gives a twentieth of that bin to the wrong source."""
LEAST_ERROR = 0.02
"""Least relative error of kept, however long the seam: a border drawn where the mosaic fits best follows a mixture's
noise."""
WIDE_ERROR, WIDE_PX = 0.05, 200.0
"""Relative error of kept of a feather so wide: there is less unmixed ground to learn tones and filters of."""
NARROW_ERROR, NARROW_PX = 0.06, 8.0
"""Relative error of kept of a feather narrower than that: it may be a cut whose border was drawn in the wrong place, as
along the squares of JPEG, or blended at the coarser scales alone."""
MIN_BESIDE_PX = 500
"""Pixels of the strip beside which another source is known: with fewer nothing is said of a mixture."""


class MixtureSums:
    """Adds up the rows of ``count`` pieces of seam, pair by pair of sources."""

    def __init__(self, count: int, levels: int) -> None:
        self._count, self._levels = count, levels
        self._sums: dict[int, np.ndarray] = {}  # by piece and the lower and higher number of the sources, in one code

    def add(self, table: MixtureTable, piece: np.ndarray) -> None:
        """Some rows; ``piece`` (n,): the one that each belongs to, or -1. Numbers of sources must mean the same every
        time."""
        table, piece = table.chosen(piece >= 0), piece[piece >= 0]
        lower, higher = np.minimum(table.source, table.other), np.maximum(table.source, table.other)
        codes, seam = np.unique((piece.astype(np.int64) << 32) + (lower.astype(np.int64) << 16) + higher,
                                return_inverse=True)
        group = (table.row // BLOCK_CELLS * 3 + table.column // BLOCK_CELLS) % GROUPS
        slices = np.stack([group, *(np.full_like(group, GROUPS - 1 + level) for level in range(1, self._levels))])
        slot = (table.source > table.other) * MIXED_BINS + table.bin
        size = (GROUPS + self._levels - 1) * SLOTS
        place = ((seam * size + slot) + slices * SLOTS).ravel()
        sums = [np.bincount(place, product.ravel(), len(codes) * size) for product in table.products]
        for code, of_seam in zip(codes.tolist(), np.stack(sums).reshape(len(PRODUCTS), -1, size).swapaxes(0, 1)):
            self._sums[code] = self._sums.get(code, 0) + of_seam

    def result(self) -> MixedStrips:
        """Mixtures of all pieces."""
        codes = np.array(sorted(self._sums), np.int64)
        sums = np.array([self._sums[code] for code in codes.tolist()])
        sums = sums.reshape(len(codes), len(PRODUCTS), GROUPS + self._levels - 1, SLOTS)
        return MixedStrips(codes >> 32, np.moveaxis(sums, 1, -1), self._count)


class MixedStrips:
    """What ``count`` pieces are mixed of. ``piece`` (n,): that each seam between two sources belongs to; ``sums``
    (n, groups of level 1 and then the other levels, SLOTS, products)."""

    def __init__(self, piece: np.ndarray, sums: np.ndarray, count: int) -> None:
        self._piece, self._count = piece, count
        finest = sums[:, :GROUPS]
        whole = np.concatenate([finest.sum(axis=1, keepdims=True), sums[:, GROUPS:]], axis=1)
        left_out = finest.sum(axis=1, keepdims=True) - finest
        shares = _shares(left_out, _sharp_weights(left_out)[0])
        deviations = shares - shares.mean(axis=1, keepdims=True)
        fitted = fit_mixtures(whole, _spread(deviations))
        self._other, self._area, other = fitted.other, whole[:, 0, :, _AREA], fitted.other[:, np.newaxis]
        self.edge, self.left_over, self.soft_left_over, self.rounded = map(
            self._both_sides, (fitted.edge, fitted.left_over, fitted.soft_left_over, fitted.rounded)
        )
        """(levels, bins, count) each, DN squared, of ``Mixtures``."""
        mixed, plain, shown, self.plain = (
            self._both_sides(energy(whole, other, names))
            for names in (_BEFORE, _SHOWN) for energy in (mixed_energy, followed_energy)
        )
        """(levels, bins, count), DN squared: energy of the sources' detail as the mosaic shows it."""
        carried = self._both_sides(fitted.carried * followed_energy(whole[:, 0], fitted.other, _SHOWN))
        self.carried = carried[strip_bins(0)].sum(axis=0) / np.maximum(in_strip(self.plain)[0], 1e-12)
        """(count,): share of its sources' finest detail that the mosaic has in the strip, of either."""
        self.apart = self._apart(whole[:, 0])
        """(count,): what the two sources differ by in the strip, as a share of what they do farther off."""
        unsure = fitted.unsure[:, np.newaxis]
        more, less = (mixed_energy(whole, np.clip(other + way * unsure, 0, 1)) for way in (1, -1))
        self._unsure = np.abs(in_strip(self._both_sides(more - less))[0]) / 2 / np.maximum(in_strip(plain)[0], 1e-12)
        self.bins, self.before = _ratio(mixed, plain), _ratio(mixed * self.plain, plain * shown, 1.0)
        """(levels, bins, count) each: kept, NaN where nothing is known; and that as a multiple of what is kept of the
        sources as the mosaic shows them, 1 where nothing is known."""
        mixed, plain, shown, source = map(in_strip, (mixed, plain, shown, self.plain))
        self.before_in_strip = _ratio(mixed * source, plain * shown, 1.0)
        """(levels, count): such a multiple of the strip."""
        enough = self._both_sides(self._area * fitted.known)[strip_bins(0)].sum(axis=0) >= MIN_BESIDE_PX
        self.levels = np.where(enough, _ratio(mixed, plain), np.nan)
        """kept_r (levels, count), NaN where nothing can be told."""
        self.kept = self._kept(left_out, other + fitted.blended[:, np.newaxis] * np.nan_to_num(deviations))

    @cached_property
    def feather_widths_px(self) -> np.ndarray:
        """(count,): of the seam between two sources that is longest in each piece; NaN where there is none."""
        widths = np.full(self._count, np.nan)
        longest = np.zeros(self._count)
        for number, piece in enumerate(self._piece.tolist()):
            area = float(self._area[number].sum())
            if area > longest[piece]:
                widths[piece], longest[piece] = feather_width_px(self._other[number]), area
        return widths

    def _apart(self, products: np.ndarray) -> np.ndarray:
        """See ``apart``; ``products`` of the finest level, (n, SLOTS, PRODUCTS)."""
        ss, so, oo = (self._both_sides(products[..., product]) for product in _SHOWN)
        near, far = (
            _ratio((ss - 2 * so + oo)[bins].sum(axis=0), (ss + oo)[bins].sum(axis=0), 1.0)
            for bins in (strip_bins(0), slice(_FAR, None))
        )
        return _ratio(near, far, 1.0)

    def shares(self) -> np.ndarray:
        """Shares of the other source, (bins, count): the mean of both sides, NaN where there is nothing."""
        return _ratio(*map(self._both_sides, (self._other * self._area, self._area)))

    def _kept(self, left_out: np.ndarray, other: np.ndarray) -> Kept:
        """kept_1 from sums without each group in turn, (n, groups, SLOTS, products), and the shares of the other source
        in these (n, groups, SLOTS)."""
        other = np.clip(other, 0, 1)
        mixed, plain = (
            self._both_sides(way(left_out, other))[:, strip_bins(0)].sum(axis=1)
            for way in (mixed_energy, followed_energy)
        )
        estimates = mixed / np.maximum(plain, 1e-12)
        deviations = estimates - estimates.mean(axis=0)
        variance = (GROUPS - 1) / GROUPS * (deviations**2).sum(axis=0)
        value = self.levels[0]
        error = np.sqrt(variance) / np.maximum(value, 1e-6)
        widths = np.nan_to_num(self.feather_widths_px)
        wide = WIDE_ERROR * np.minimum(widths / WIDE_PX, 1)
        narrow = np.where((widths > 0) & (widths < NARROW_PX), NARROW_ERROR, 0)
        total = np.sqrt(error**2 + LEAST_ERROR**2 + wide**2 + narrow**2 + (self._unsure / np.maximum(value, 1e-6)) ** 2)
        # The floor is known, the rest comes of few groups (Welch and Satterthwaite).
        freedom = (GROUPS - 1) * (total / np.maximum(error, 1e-3)) ** 4
        return Kept.of(value, total, freedom)

    def _both_sides(self, values: np.ndarray) -> np.ndarray:
        """Sums over both sides and all seams of a piece, (..., bins, count), of values (n, ..., SLOTS)."""
        sides = values.reshape(*values.shape[:-1], 2, MIXED_BINS).sum(axis=-2)
        sums = np.zeros((self._count, *sides.shape[1:-1], len(EDGES_PX)))
        np.add.at(sums[..., :MIXED_BINS], self._piece, sides)
        return np.moveaxis(sums, 0, -1)


def _spread(deviations: np.ndarray) -> np.ndarray:
    """Standard deviation of the raw share of every bin, (n, SLOTS), by the jackknife: from how far the shares without
    each group in turn, (n, groups, SLOTS), lie from their mean."""
    variance = (GROUPS - 1) / GROUPS * np.square(deviations).sum(axis=1)
    known = np.where(np.arange(SLOTS) % MIXED_BINS > 0, SHARE_ERROR, BORDER_ERROR)
    return np.asarray(np.sqrt(np.where(np.isnan(variance), np.inf, variance) + known**2))


def _ratio(part: np.ndarray, whole: np.ndarray, unknown: float = np.nan) -> np.ndarray:
    return np.divide(part, whole, out=np.full(part.shape, unknown), where=whole > 0)
