"""Ground that no given source explains: a test against the noise that the mosaic's own sources have.

    m = sum of w_i s_i + n,        w >= 0 and even within 36 px, of at most two sources at a time

n is what compression, on either side, noise, resampling and rounding leave over. Its share of a source's detail is
learned source by source as a function of how strong the detail is, from the better explained part of its ground alone;
of weaker detail than it has there, it leaves over as much. The correlation of what is explained has a scatter that is
nearly even on Fisher's scale, z = artanh(rho) (Fisher 1921), so ground is foreign where squares are explained less than
chance allows in a window: in squares of 216 px by chance alone, which tells images that resemble each other as well; in
those of 56 and 104 px, where something may have moved, nearer to what another image of the same ground explains than to
what is expected besides. Where nothing was compressed less is enough: 104 px for images that resemble each other, 24 px
for others.
"""
from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from statistics import NormalDist

import numpy as np
from scipy import ndimage

from ..seam_cells import present
from .boxes import box_means, enlarged, narrowed, near_border, opened, widened
from .compression import IsCompressed
from .followed_source import FINE_CELL_PX, LEAST_ENERGY, WIDE_CELLS

NOISE_CELL_PX = 8
"""Side of the cells that noise is learned in: as large as the blocks of JPEG, which makes it block by block."""

_WIDE = (7, 13)  # cells a side: squares of 56 and 104 px, in which a stranger is told
_NARROW = 3  # the same: 24 px, for strips of noise where nothing was compressed
_CLEAN, _LARGE = 13, 27  # the same: 104 px where nothing was compressed, and 216 px, in which chance alone is asked
_BORDERS, _UNTOLD = (3, 7, 13, 27), 0.1  # the same, by which borders are told; of a part, that need not be told by them
_FALSE_ALARM = 0.01  # of a window, that chance finds a foreign part in it
_ALIKE = 0.05  # of what is explained elsewhere, that an image which resembles the true one leaves over
_STRANGER = 0.8  # share that another image of the same ground leaves over, 1 - rho^2
_MIN_TRUE = 0.55  # share explained of strong detail, of which JPEG at quality 60 leaves 0.6: with less a substitute
_MIN_TRUE_MIXED = 0.35  # the same of ground where two are mixed, each of which brings its noise
_EVEN_LEFT, _EVEN_SLOPE = 0.2, -0.15
"""Share that a substitute for the true image leaves over of strong detail, and its logarithm's slope by that of the
energy: noise grows less than detail does, what an image lacks is an even share of it."""
_OF_BEST = 0.7  # of the z of the best source: with less one is a substitute, unless compression took what it lacks
_EVEN_PART, _EVEN_SHARE = 0.5, 0.4  # of what is left over around: many cells leave so much
_LINE = 2.5  # cells that a line runs through, across itself
_MIXED, _MIXED_TOTAL = 0.2, 0.75  # the lesser of two weights, of their sum; and that sum, of ground that is mixed
_OF_MIXED = 254  # number of mixed ground: what is left over there is learned apart
_MIN_PART = 0.02  # of the ground: smaller parts are not reported
_LEAST = 0.3  # DN squared a pixel, that rounding leaves
_FEWEST_CELLS, _FEWEST_PATCHES = 160, 24  # that noise is learned from
_BORDER_WEIGHT = 1e-3  # of cells that a border runs through, which no single source explains
_TERMS = 0.75 * (WIDE_CELLS * FINE_CELL_PX) ** 2  # independent values in a neighbourhood, for Schwarz's criterion
_MOST_EXPLAINED = 0.98  # beyond it rounding decides
_LEAST_SCATTER = 0.05  # of z


def _normal(share: float) -> float:
    return NormalDist().inv_cdf(share)


@dataclass(frozen=True, eq=False)
class CellSums:
    """Sums of products of fine detail over cells of 4 px, (rows, columns) each."""

    mosaic: np.ndarray
    """Products of the mosaic with itself."""
    energies: Mapping[int, np.ndarray]
    """Products of each source with itself."""
    shared: Mapping[int, np.ndarray]
    """Products of each source with the mosaic."""
    cut: np.ndarray
    """What the sources leave over, pixel by pixel as they are followed."""
    labels: np.ndarray
    """uint8: the source that is followed."""
    valid: Mapping[int, np.ndarray]
    """bool: cells that a source has, of those that don't have all."""
    between: Callable[[int, int], np.ndarray]
    """Products of two sources with each other."""


def foreign_ground(sums: CellSums, is_compressed: IsCompressed, is_window: bool) -> np.ndarray:
    """Cells that no source and no mixture of two explains, (rows, columns) bool as those of the sums.

    ``is_window``: whether all of the ground may be foreign; a part of a scan has too little to say that.
    """
    cells = _NoiseCells.of(sums, {})
    foreign = cells.foreign(is_compressed, is_window)
    if len(sums.energies) > 1 and foreign.any():
        pairs = {pair: sums.between(*pair) for pair in combinations(sums.energies, 2)}
        foreign = _NoiseCells.of(sums, pairs).foreign(is_compressed, is_window)
    return enlarged(foreign, NOISE_CELL_PX // FINE_CELL_PX, sums.mosaic.shape)


def foreign_patches(
    energy: np.ndarray, left_over: np.ndarray, labels: np.ndarray, is_compressed: IsCompressed
) -> tuple[np.ndarray, np.ndarray]:
    """The patches of a scan that no source explains, (rows, columns) bool, and those that none explains as well as
    others are.

    ``energy``: of the mosaic's fine detail, 0 where nothing can be told; ``left_over``: by its sources; ``labels``: the
    source that each follows.
    """
    textured = energy > 0
    logs, z = np.log(np.maximum(energy, 1e-3)), _fisher(1 - left_over / np.maximum(energy, 1e-3))
    grounds: dict[int, _Ground] = {}
    for number in present(np.where(textured, labels, np.uint8(255))):
        followed = textured & (labels == number)
        if np.count_nonzero(followed) >= _FEWEST_PATCHES:
            at, middle, scatter = _by_energy(logs[followed], z[followed])
            # Of weaker detail no more is left over: half of the patches, all weak, may be of another image.
            energies = np.exp(at)
            left = np.minimum.accumulate(((1 - np.tanh(middle) ** 2) * energies)[::-1])[::-1]
            share = _curve(at, left / energies)
            strong = float(np.quantile(_fisher(1 - share(energy[followed])), 0.8))
            grounds[number] = _Ground(share, 0.0, float(np.median(scatter)), strong)
    true = _true_sources(grounds, is_compressed)
    if not true:
        return np.zeros_like(textured), np.zeros_like(textured)
    expected_left, _, spread = _assigned(energy, labels, grounds, true)
    expected = _fisher(1 - expected_left / np.maximum(energy, 1e-3))
    unlikely = textured & (z < expected - _normal(1 - _FALSE_ALARM / energy.size) * spread)
    return unlikely & (z < (expected + _fisher(1 - _STRANGER)) / 2), unlikely & (z < _alike(expected))


@dataclass(frozen=True, eq=False)
class _Ground:
    """What a source leaves over where it is followed, and how its squares lie about that on Fisher's scale."""

    share: Callable[[np.ndarray], np.ndarray]
    """Share left over by the energy."""
    middle: float
    scatter: float
    strong: float
    """What is explained of strong detail."""
    is_even: bool = False
    """Whether what is left over is an even share of weak and strong detail: of an image that is not given."""


@dataclass(frozen=True, eq=False)
class _NoiseCells:
    """Means over cells of 8 px, (rows, columns) each."""

    energy: np.ndarray
    """Energy of the mosaic, DN squared a pixel."""
    left_over: np.ndarray
    labels: np.ndarray
    """uint8: the source that is followed, or ``_OF_MIXED``."""
    border: np.ndarray
    """bool: where a border runs through, of labels or of a source's pixels."""
    seen: np.ndarray
    """bool: where any source has pixels."""

    @classmethod
    def of(cls, sums: CellSums, pairs: Mapping[tuple[int, int], np.ndarray]) -> _NoiseCells:
        """Cells by weights of one source in every neighbourhood, or of two where that pays; ``pairs``: their sums."""
        weights = _weights(sums, pairs)
        rest = sums.mosaic.copy()
        used = {i: weight * sums.valid.get(i, np.True_) for i, weight in weights.items()}
        for i, weight in used.items():
            rest += weight * (weight * sums.energies[i] - 2 * sums.shared[i])
        for (i, j), both in pairs.items():
            rest += 2 * used[i] * used[j] * both
        energy, cut = _means(sums.mosaic), _means(sums.cut)
        rows, columns = energy.shape
        labels = sums.labels[1::2, 1::2][:rows, :columns]
        masks = [valid[1::2, 1::2][:rows, :columns] for valid in sums.valid.values()]
        border = np.logical_or.reduce([near_border(plane, 1) for plane in (labels, *masks)])
        seen = np.logical_or.reduce(masks) if len(masks) == len(sums.energies) else np.ones_like(border)
        if pairs:
            ordered = np.sort(np.stack([_means(weight) * FINE_CELL_PX**2 for weight in weights.values()]), axis=0)
            total = ordered[-1] + ordered[-2]
            is_mixed = (ordered[-2] >= _MIXED * total) & (total > _MIXED_TOTAL)
            labels = np.where(is_mixed, np.uint8(_OF_MIXED), labels)
        return cls(energy, np.minimum(_means(np.maximum(rest, 0)), cut), labels, border, seen)

    def foreign(self, is_compressed: IsCompressed, is_window: bool) -> np.ndarray:
        """What squares of any size find, (rows, columns) bool; parts of images that resemble the true one count where
        they reach far beyond strangers, whose borders are known better."""
        clean = not is_compressed(None)
        strangers, resembling = (
            [side for side in sides if side <= min(self.energy.shape)]
            for sides in (((_NARROW, *_WIDE), (_LARGE, _CLEAN)) if clean else (_WIDE, (_LARGE,)))
        )
        squares = {side: _Squares.of(self, side) for side in {*strangers, *resembling}}
        foreign = np.zeros_like(self.border)
        for side in strangers:
            foreign |= squares[side].foreign(is_compressed, is_window, False)
        for side in resembling:
            alike = squares[side].foreign(is_compressed, is_window, True)
            beyond = opened(alike & ~widened(foreign, side // 2), side // 4)  # more than their squares blur a border by
            foreign = foreign | ndimage.binary_propagation(beyond, mask=alike)
        return foreign


@dataclass(frozen=True, eq=False)
class _Squares:
    """Means over squares about every cell, those with a border hardly counted."""

    cells: _NoiseCells
    side: int
    """Cells."""
    counted: np.ndarray
    """Weight of every cell."""
    energy: np.ndarray
    z: np.ndarray
    """Share explained, on Fisher's scale."""
    textured: np.ndarray
    """bool: what can be told at all."""
    even: np.ndarray
    """bool: where so much is left over in many cells."""

    @classmethod
    def of(cls, cells: _NoiseCells, side: int) -> _Squares:
        counted = np.where(cells.border | ~cells.seen, np.float32(_BORDER_WEIGHT), np.float32(1))
        total, energy, left_over = _box_means((counted, cells.energy * counted, cells.left_over * counted), side)
        energy, left_over = np.maximum(energy / total, 1e-3), np.maximum(left_over / total, 1e-4)
        z = _fisher(1 - left_over / energy)
        # A step of tones leaves over much along a line, and nothing beside that.
        much = cells.left_over * energy >= _EVEN_PART * left_over * cells.energy
        is_even = box_means(much, (side,))[0] >= max(_EVEN_SHARE, _LINE / side)
        return cls(cells, side, counted, energy, z, (energy > _LEAST) & cells.seen, is_even)

    def foreign(self, is_compressed: IsCompressed, is_window: bool, is_alike: bool) -> np.ndarray:
        """Cells of foreign parts, (rows, columns) bool; ``is_alike``: of images that resemble the true one, too."""
        cells, stranger, nothing = self.cells, _fisher(1 - _STRANGER), np.zeros_like(self.textured)
        opening = self.side // 2 if is_alike else max(self.side - 2, 2)
        chance = _normal(1 - _FALSE_ALARM / max(cells.energy.size / self.side**2, 1))
        highest = _fisher(1.0) - chance * _LEAST_SCATTER if is_alike else (_fisher(1.0) + stranger) / 2
        if not opened(self.textured & (self.z < highest), opening).any():
            return nothing  # whatever is expected
        grounds = {number: ground for number in present(cells.labels) if (ground := self._ground(number)) is not None}
        true = _true_sources(grounds, is_compressed)
        if not grounds or not true:
            return self.textured if grounds and is_window else nothing
        left_over, middle, scatter = _assigned(cells.energy, cells.labels, grounds, true)
        total, around = _box_means((self.counted, left_over * self.counted), self.side)
        expected = _fisher(1 - around / total / self.energy) + middle
        limit = _alike(expected) if is_alike else (expected + stranger) / 2
        parts = opened(self.textured & self.even & (self.z < expected - chance * scatter) & (self.z < limit), opening)
        return self._to_borders(parts, expected)

    def _ground(self, number: int) -> _Ground | None:
        """Ground of a source, by squares that count its cells alone; none where it is too small."""
        cells = self.cells
        counted = np.where(cells.labels == number, self.counted, np.float32(0))
        total, energy, left_over = _box_means((counted, cells.energy * counted, cells.left_over * counted), self.side)
        followed = self.textured & (cells.labels == number)
        if np.count_nonzero(followed) < _FEWEST_CELLS:
            return None
        energy = np.maximum(energy / np.maximum(total, 1e-9), 1e-3)
        z, logs = _fisher(1 - left_over / np.maximum(total, 1e-9) / energy), np.log(energy)
        at, middle, scatter = _by_energy(logs[followed], z[followed])
        good = followed & ~cells.border & (z > np.interp(logs, at, middle - scatter))
        if np.count_nonzero(good) < _FEWEST_CELLS // 4:
            return None
        share = _share_left(cells.energy[good], cells.left_over[good])
        weak, strong = np.quantile(cells.energy[followed], (0.1, 0.9))
        weak_left, strong_left = share(np.array([weak, strong])).tolist()
        is_even = strong_left > _EVEN_LEFT and (
            np.log(strong_left / weak_left) > _EVEN_SLOPE * max(np.log(strong / weak), 0.2)
        )
        around = _box_means((share(cells.energy) * cells.energy * counted,), self.side)[0]
        expected = _fisher(1 - around / np.maximum(total, 1e-9) / energy)
        most = float(np.quantile(expected[followed], 0.8))
        uneven = followed & (expected < _fisher(1.0))  # where rounding decides all squares are alike
        if np.count_nonzero(uneven) >= _FEWEST_CELLS // 2:
            followed = uneven
        expected, z = expected[followed], z[followed]
        off = z - expected
        quantiles = np.quantile(off, (0.6, 0.7, 0.8, 0.93))
        # Of two spans the narrower: the upper end is long where compression took nothing in places.
        spans = ((quantiles[3] - quantiles[1]) / (_normal(0.93) - _normal(0.7)),
                 (quantiles[2] - quantiles[0]) / (_normal(0.8) - _normal(0.6)))
        scatter = max(min(spans), _LEAST_SCATTER)
        middle = quantiles[2] - _normal(0.8) * scatter
        # Once more without what is nearer to a stranger, be it nearly half of the ground.
        likely = off[z > (expected + middle + _fisher(1 - _STRANGER)) / 2]
        if len(likely) >= _FEWEST_CELLS // 2:
            middle, high = np.quantile(likely, (0.5, 0.9))
            scatter = min(scatter, max((high - middle) / _normal(0.9), _LEAST_SCATTER))
        return _Ground(share, float(middle), float(scatter), most, bool(is_even))

    def _to_borders(self, parts_found: np.ndarray, expected: np.ndarray) -> np.ndarray:
        """Parts that squares found up to where half of a smaller one is within them, by correlation: the smallest that
        tells nearly all of what was found from what is explained."""
        if not parts_found.any():
            return parts_found
        cells, least = self.cells, 1 - np.tanh(expected) ** 2
        for side in (width for width in _BORDERS if width <= self.side):
            energy, left_over = _box_means((cells.energy, cells.left_over), side)
            part = (left_over / np.maximum(energy, 1e-3) - least) / np.maximum(1 - least, 0.05)
            low, inside = np.clip(np.quantile(part[parts_found], (_UNTOLD, 0.5)), 0, 1).tolist()
            half = 1 - (0.5 + 0.5 * np.sqrt(1 - inside)) ** 2
            if low > half:
                break
        near = widened(parts_found, self.side) & self.textured & (part > half)
        near = narrowed(widened(near, 1), 1) & self.textured
        parts_found = opened(ndimage.binary_propagation(parts_found & near, mask=near), min(side, _LARGE // 2))
        parts, _ = ndimage.label(parts_found)
        sizes = np.bincount(parts.ravel())
        sizes[0] = 0
        return np.asarray((sizes >= _MIN_PART * parts_found.size)[parts])


def _weights(sums: CellSums, pairs: Mapping[tuple[int, int], np.ndarray]) -> dict[int, np.ndarray]:
    """Weight of every source in the neighbourhood of every cell, (rows, columns) each: of the one that leaves least
    over, or of two where Schwarz's criterion says that the second pays."""
    least = np.float32(LEAST_ENERGY * FINE_CELL_PX**2)
    mosaic = box_means(sums.mosaic, (WIDE_CELLS,))[0]
    shared = {i: np.maximum(box_means(products, (WIDE_CELLS,))[0], 0) for i, products in sums.shared.items()}
    energies = {i: box_means(products, (WIDE_CELLS,))[0] + least for i, products in sums.energies.items()}
    weights, single = {i: np.zeros_like(mosaic) for i in energies}, np.full_like(mosaic, np.inf)
    for i in energies:
        weight = shared[i] / energies[i]
        rest = mosaic - weight * shared[i]
        better = rest < single
        np.copyto(single, rest, where=better)
        for j in energies:
            np.copyto(weights[j], weight if j == i else 0, where=better)
    best, pays = single.copy(), np.float32(1 - np.exp(-2 * np.log(_TERMS) / _TERMS))
    for (i, j), sums_of_both in pairs.items():
        both = box_means(sums_of_both, (WIDE_CELLS,))[0]
        determinant = 1.0001 * energies[i] * energies[j] - both**2 + 1e-9
        first = (shared[i] * energies[j] - shared[j] * both) / determinant
        second = (shared[j] * energies[i] - shared[i] * both) / determinant
        rest = mosaic - first * shared[i] - second * shared[j]
        better = (first > 0) & (second > 0) & (rest < best - pays * single)
        np.copyto(best, rest, where=better)
        for k in energies:
            np.copyto(weights[k], first if k == i else second if k == j else 0, where=better)
    return weights


def _means(cells: np.ndarray) -> np.ndarray:
    """Means a pixel over cells of 8 px from sums over those of 4 px."""
    rows, columns = (length // 2 * 2 for length in cells.shape)
    down = cells[0:rows:2, :columns] + cells[1:rows:2, :columns]
    return np.asarray((down[:, 0::2] + down[:, 1::2]) * np.float32(NOISE_CELL_PX**-2))


def _box_means(planes: Sequence[np.ndarray], side: int) -> list[np.ndarray]:
    """Means over squares of ``side`` cells about every cell, of several planes."""
    return [box_means(plane, (side,))[0] for plane in planes]


def _fisher(share: np.ndarray | float) -> np.ndarray:
    """Fisher's z of the correlation whose square is explained."""
    return np.asarray(np.arctanh(np.sqrt(np.clip(share, 0, _MOST_EXPLAINED))))


def _alike(expected: np.ndarray) -> np.ndarray:
    """What an image that resembles the true one explains at most, on Fisher's scale."""
    return _fisher((1 - _ALIKE) * np.tanh(expected) ** 2)


def _by_energy(logs: np.ndarray, z: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """What is explained by the logarithm of the energy, with its scatter, of the better explained half of the ground:
    log energies, z and scatter of some bins. Of stronger detail no less is explained."""
    bins = np.array_split(np.argsort(logs), max(2, min(6, len(logs) // 40)))
    at = np.array([logs[part].mean() for part in bins])
    quantiles = np.array([np.quantile(z[part], (0.75, 0.85, 0.95)) for part in bins])
    scatter = (quantiles[:, 2] - quantiles[:, 0]) / (_normal(0.95) - _normal(0.75))
    scatter = np.maximum(scatter, _LEAST_SCATTER)
    scatter = np.minimum(scatter, np.median(scatter))  # a bin may be mostly foreign
    return at, np.maximum.accumulate(quantiles[:, 1] - _normal(0.85) * scatter), scatter


def _share_left(energy: np.ndarray, left_over: np.ndarray) -> Callable[[np.ndarray], np.ndarray]:
    """Share left over in a cell as a function of its energy."""
    logs = np.log(np.maximum(energy, 1e-3))
    bins = np.array_split(np.argsort(logs), max(2, min(10, len(logs) // 60)))
    at = np.array([logs[part].mean() for part in bins])
    share = np.minimum.accumulate([left_over[part].sum() / max(energy[part].sum(), 1e-9) for part in bins])
    return _curve(at, share)


def _curve(at: np.ndarray, share: np.ndarray) -> Callable[[np.ndarray], np.ndarray]:
    """Share left over by the energy, between those of some logarithms of it: of weaker detail as much is left over as
    of the weakest of them."""

    def left_of(energies: np.ndarray) -> np.ndarray:
        logs = np.log(np.maximum(energies, 1e-3))
        return np.asarray(np.minimum(np.interp(logs, at, share) * np.exp(np.maximum(at[0] - logs, 0)), 1))

    return left_of


def _true_sources(grounds: Mapping[int, _Ground], is_compressed: IsCompressed) -> list[int]:
    """Sources that are no substitutes for another image wherever they are followed."""
    most, true = max((ground.strong for ground in grounds.values()), default=0.0), []
    for number, ground in grounds.items():
        if is_compressed(None if number == _OF_MIXED else number):
            is_true = np.tanh(ground.strong) ** 2 >= (_MIN_TRUE_MIXED if number == _OF_MIXED else _MIN_TRUE)
        else:
            is_true = not ground.is_even and ground.strong >= _OF_BEST * most
        if is_true:
            true.append(number)
    # What is mixed with a substitute is one.
    return true if grounds.keys() <= {*true, _OF_MIXED} else [number for number in true if number != _OF_MIXED]


def _assigned(
    energy: np.ndarray, labels: np.ndarray, grounds: Mapping[int, _Ground], true: Sequence[int]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """What is left over at every place, the middle and the scatter of its squares, by the source that is followed
    there, or by the best true one where that is a substitute."""
    best = max(true, key=lambda number: grounds[number].strong)
    left_over, middle, scatter = (np.zeros(labels.shape) for _ in range(3))
    for number in np.unique(labels).tolist():
        ground, followed = grounds[number if number in true else best], labels == number
        np.copyto(left_over, ground.share(energy) * energy, where=followed)
        np.copyto(middle, ground.middle, where=followed)
        np.copyto(scatter, ground.scatter, where=followed)
    return left_over, middle, scatter
