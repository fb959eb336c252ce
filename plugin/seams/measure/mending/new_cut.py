"""The best cut between two images: the way along which they agree, from one end of a seam that stays to the other.

A mixture of two images p and q that are alike in tone loses |p - q|^2 / 4 of their detail (``feather_prediction``). So
the difference of the levelled images says what a seam costs at any place: it is large at roofs, cars and trees, which
the images show in different places, and where they don't fit. The new cut is the way that costs least.

And orthoimages in a mosaic's dress: in its tones and through the filter that came over it, band by band, where it is
followed and beyond; and the tones of two of them eased into each other at a cut.
"""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy import ndimage, sparse
from scipy.sparse import csgraph

from ....imagery.errors import Message
from ....imagery.lines import vertex_stations
from ....imagery.shifts import MIN_TILE_SHARE, Shift, find_shift, shifted
from .. import messages
from ..following.boxes import box_means, enlarged, in_squares, square_shares
from ..following.levelling import TONE_PX, gain_field, square_means, to_pixels
from ..following.source_filters import UNTOUCHED, filtered
from ..judgement.hard_cut import JudgedGround
from ..seamlines.seam_pieces import points_beside

CELL_PX = 4
"""Side of the cells of which a cut consists."""
MOST_MISFIT_PX = 2.5
"""Along the new cut: where images lie farther apart, an edge that it crosses is seen to break."""
LEAST_ALIKE = 0.1
"""Correlation of what is coarser than a cell along a cut; unrelated images have 0."""
_FAR = 32  # cells: what differs over more than that is tone
_LENGTH = 0.2  # of the middle cost, for every cell: a way round has to be worth it
_NEAR, _WIDE = 3, 9  # cells a side: what is beside a way, and what detail is coarser than
_STRETCH = 16  # cells of a way: images may lie apart in a part of it only
_TILE_PX = 128  # around its middle, in which images are compared
_CROSSED_PX = 12  # on either side of a way: what it crosses
_STRIP_PX = 40  # on either side of a way, in which images are compared


def cutting_cost(first: np.ndarray, second: np.ndarray, valid: np.ndarray) -> np.ndarray:
    """Mean square of what two planes (rows, columns) float32 differ by in fine detail and in tones, DN squared, by
    cells, (rows, columns) float32; infinite where one has no pixels.

    The sides are multiples of 8. ``valid``: bool, pixels that both have.
    """
    gain = gain_field(square_means(first), square_means(second), square_means(valid) == 1)
    rest = first - to_pixels(gain, first.shape) * second
    known, mean = in_squares(valid, CELL_PX).all(axis=(1, 3)), square_shares(rest, CELL_PX)
    weight, near = (
        ndimage.gaussian_filter(np.asarray(plane, np.float32), _FAR) for plane in (known, np.where(known, mean, 0))
    )
    tones = mean - near / np.maximum(weight, 1e-6)
    fine = np.maximum(square_shares(np.square(rest), CELL_PX) - np.square(mean), 0)
    return np.where(known, fine + np.square(tones), np.float32(np.inf))


def cheapest_way(
    cost: np.ndarray, allowed: np.ndarray, start: tuple[int, int], end: tuple[int, int]
) -> np.ndarray | None:
    """Rows and columns (n, 2) of the cells from start to end; None where there is no way.

    ``allowed``: (rows, columns) bool. Start and end are taken as they are.
    """
    free = allowed & np.isfinite(cost)
    if not free.any():
        return None
    cost = np.where(free, cost / (cost[free].max() or 1), 0)  # the way is the same, and no sum of them overflows
    near = box_means(cost, (_NEAR,))[0] / np.maximum(box_means(free, (_NEAR,))[0], 1e-6)
    near += _LENGTH * np.float32(np.median(near[free])) + np.float32(1e-6)
    free[start], free[end] = True, True
    numbers = np.arange(free.size).reshape(free.shape)
    rows, columns = free.shape
    steps = []
    for down, across in ((0, 1), (1, 0), (1, 1), (1, -1)):
        here = np.s_[: rows - down, max(-across, 0) : columns - max(across, 0)]
        there = np.s_[down:, max(across, 0) : columns - max(-across, 0)]
        both = free[here] & free[there]
        lengths = np.hypot(down, across) * (near[here] + near[there]) / 2
        steps.append([column[both] for column in (lengths, numbers[here], numbers[there])])
    lengths, heads, tails = map(np.concatenate, zip(*steps))
    graph = sparse.coo_matrix((lengths, (heads, tails)), (free.size, free.size)).tocsr()
    before = csgraph.dijkstra(graph, directed=False, indices=numbers[start], return_predecessors=True)[1]
    way = [numbers[end]]
    while way[-1] != numbers[start]:
        if before[way[-1]] < 0:
            return None
        way.append(before[way[-1]])
    return np.column_stack(np.unravel_index(way[::-1], free.shape))


def fit_along(
    way: np.ndarray, first: np.ndarray, second: np.ndarray, valid: np.ndarray
) -> tuple[float | None, Message | None, np.ndarray]:
    """How far two planes lie from each other along a way (n, 2), rows and columns of cells, px, where it is most, None
    where nothing in common shows it; why they can't be cut there; and (n,) bool: where they lie too far apart."""
    off = np.ones([length // CELL_PX for length in valid.shape], bool)
    off[tuple(way.T)] = False
    from_way = CELL_PX * ndimage.distance_transform_edt(off)
    beside, crossed = from_way <= _STRIP_PX, enlarged(from_way <= _CROSSED_PX, CELL_PX) & valid
    shift = find_shift(first, second, enlarged(beside, CELL_PX) & valid)
    stretches = np.array_split(way, max(1, round(len(way) / _STRETCH)))
    shifts = []
    for cells in stretches:
        middle = cells[len(cells) // 2] * CELL_PX + CELL_PX // 2
        tile = tuple(map(slice, np.maximum(middle - _TILE_PX // 2, 0), middle + _TILE_PX // 2))
        shifts.append(_apart(first[tile], second[tile], valid[tile], crossed[tile]))
    lengths = [0.0 if offset is None else offset.length for offset in shifts]
    far = np.repeat(np.array(lengths) > MOST_MISFIT_PX, [len(stretch) for stretch in stretches])
    misfit = max((offset.length for offset in (shift, *shifts) if offset is not None), default=None)
    if misfit is not None:
        return misfit, messages.IMAGES_MISFIT(misfit=misfit) if misfit > MOST_MISFIT_PX else None, far
    beside &= in_squares(valid, CELL_PX).all(axis=(1, 3))
    cells = (square_shares(plane, CELL_PX) for plane in (first, second))
    a, b = ((means - ndimage.uniform_filter(means, _WIDE))[beside] for means in cells)
    alike = float(a @ b) >= LEAST_ALIKE * float(np.sqrt((a @ a) * (b @ b)))
    return None, None if alike else messages.IMAGES_UNLIKE(), far


def _apart(first: np.ndarray, second: np.ndarray, valid: np.ndarray, crossed: np.ndarray) -> Shift | None:
    """How two planes lie around a place on a way, where the ground that is ``crossed`` there shows it, and not just an
    object beside it that it leads around."""
    shift = find_shift(first, second) if valid.mean() >= MIN_TILE_SHARE else None
    if shift is None or shift.length <= MOST_MISFIT_PX:
        return shift
    a, b, moved = (
        (plane - ndimage.uniform_filter(plane, _WIDE * CELL_PX))[crossed]
        for plane in (first, second, shifted(second, shift.x, shift.y))
    )
    return shift if np.square(a - moved).sum() < np.square(a - b).sum() else None


FEWEST_SQUARES = 48
"""Fewest squares of 8 px on which a source is alone: with less nobody can tell its tones."""
MIN_UNMIXED = 0.9
"""Least share of the pixels of a square that is of one image alone."""
EASED_PX = 96
"""From a cut, over which tones are eased."""

_REACHES = 54.0, 18.0, 6.0, 2.0  # squares: what a tone is carried on by, the nearest that tells it
_LEAST = 0.05
_EASED_SQUARES = 1.0, 2.0, EASED_PX / TONE_PX / 3  # by scale: the finest are eased nearest to the cut
_APART_PX = 2  # whose difference is fine detail
_ROUNDED = 2.0  # mean square of such differences on ground that shows little but rounding
_LEAST_ALIKE = 0.3  # correlation of such differences
_RIM_SQUARES = 2.0  # what is wider are the mosaic's tones at the rim of a patch


def placed_bands(ground: JudgedGround, source: int, bands: np.ndarray, valid: np.ndarray) -> np.ndarray:
    """Bands (bands, rows, columns) of a source as float32, where they lie in the mosaic; what is not ``valid``, (rows,
    columns) bool, is as the nearest that is, since filters see beyond the image's rim."""
    placed = bands.astype(np.float32)
    if not valid.all():
        placed = placed[(slice(None), *_nearest(valid))]
    move = ground.followed.moves.get(_plane(ground, source))
    return placed if move is None else np.stack([shifted(band, move.x, move.y) for band in placed])


def _nearest(known: np.ndarray) -> tuple[np.ndarray, ...]:
    """Rows and columns of the known sample that is nearest to each."""
    return tuple(ndimage.distance_transform_edt(~known, return_distances=False, return_indices=True))


def dress(ground: JudgedGround, source: int, bands: np.ndarray, mosaic: np.ndarray, unmixed: np.ndarray) -> None:
    """Bands of a placed source become what the mosaic's show of it where it is followed, and would elsewhere; (bands,
    rows, columns), float32 of the source. ``unmixed``: pixels, bool, on which the mosaic is of this source alone.

    Gain and filter are the estimator's; the bias is that of the nearest ground that tells it, at the scale of squares
    and wider, so that nothing finer is taken over from the mosaic.
    """
    where, filters = square_means(unmixed) > MIN_UNMIXED, ground.expected.filters
    common = next(iter(filters.taps.values()), UNTOUCHED) if filters.came_over_cuts else UNTOUCHED
    taps = filters.taps.get(_plane(ground, source), common)
    pairs = [(square_means(shown.astype(np.float32)), square_means(band)) for shown, band in zip(mosaic, bands)]
    gains = [gain_field(shown, given, where) for shown, given in pairs]
    offsets = np.stack([shown - gain * given for gain, (shown, given) in zip(gains, pairs)])
    biases = np.broadcast_to(offsets[:, where].mean(axis=1)[:, np.newaxis, np.newaxis], offsets.shape)
    for reach in _REACHES:  # the nearest ground that tells it counts most
        near = _smoothed(np.where(where, offsets, np.float32(0)), reach)
        biases = (near + _LEAST * biases) / (_smoothed(where.astype(np.float32), reach) + np.float32(_LEAST))
    for band, gain, bias in zip(bands, gains, biases):
        band *= to_pixels(gain, band.shape)
        band += to_pixels(bias, band.shape)
        if filters.taps:
            band[...] = filtered(band, taps)


def _plane(ground: JudgedGround, source: int) -> int:
    """The one of a source's planes that the mosaic follows most: as it is, or moved to where it lies in the mosaic."""
    planes = [plane for plane, of in enumerate(ground.followed.source_of) if of == source]
    return max(planes, key=lambda plane: ground.followed.following.shares[plane])


def shown_detail(band: np.ndarray, mosaic: np.ndarray, unmixed: np.ndarray) -> float | None:
    """How much a dressed band shows of the fine detail that it has in common with the mosaic where that is of its
    source alone, (rows, columns) each, ``unmixed`` bool: 0 to 1; the share of it that is common to both where that is
    little, as compression leaves more. None where the mosaic has no detail but for rounding."""
    both = unmixed[:, _APART_PX:] & unmixed[:, :-_APART_PX]
    shown, made = ((plane[:, _APART_PX:] - plane[:, :-_APART_PX])[both] for plane in (mosaic.astype(np.float32), band))
    energy, common, held = float(shown @ shown), float(shown @ made), float(made @ made)
    if energy <= (0.0 if mosaic.dtype.kind == "f" else _ROUNDED * len(shown)):
        return None
    alike = common / max(float(np.sqrt(energy * held)), float(np.finfo(np.float32).tiny))
    return min(held / common, 1.0) if alike > _LEAST_ALIKE else max(alike, 0.0) ** 2


def eased(
    images: Sequence[np.ndarray], weight: np.ndarray, mosaic: np.ndarray, inside: np.ndarray, valid: np.ndarray
) -> np.ndarray:
    """Dressed bands (bands, rows, columns) float32 of two images cut where ``weight``, the first's, passes one half.

    What is coarser than squares of 8 px is eased, each scale as far as it is wide, tones over ``EASED_PX``: what is
    finer is of one image alone, but for the few pixels in which the weight is neither 0 nor 1. Towards the edge of the
    patch, ``inside`` 0 there and 1 within, tones are those of the mosaic, so that it shows no edge. ``weight`` and
    ``inside``: (rows, columns); ``valid``: bool, pixels that all have; beyond them tones are those of the nearest.
    """
    places, share = _nearest(square_means(valid) == 1), square_means(weight)
    spreads = [to_pixels(_smoothed(share, reach), weight.shape) - weight for reach in _EASED_SQUARES]
    made = weight * images[0] + (1 - weight) * images[1]
    for band, first, second, shown in zip(made, *images, mosaic):
        apart = square_means(first - second)[places]
        # Of every scale what is added differs across the cut by as much as images do, and fades as far as it is wide.
        for reach, spread in zip(_EASED_SQUARES, spreads):
            wider = _smoothed(apart, reach) if reach < _EASED_SQUARES[-1] else np.zeros_like(apart)
            band += spread * to_pixels(apart - wider, weight.shape)
            apart = wider
        rest = _smoothed(square_means(shown - band)[places], _RIM_SQUARES)
        band += (1 - inside) * to_pixels(rest, weight.shape)
    return made


def _smoothed(values: np.ndarray, reach: float) -> np.ndarray:
    """Gaussian filter along the last two axes, the edges repeated."""
    return np.asarray(ndimage.gaussian_filter(values, [0] * (values.ndim - 2) + [reach] * 2, mode="nearest"))


_NEAR_PX, _FAR_PX = 2, 10  # on either side of a cut, as the French order of 2003 has it
_STATION_PX = 16
_FEWEST_STATIONS = 4


def tone_step(plane: np.ndarray, points: np.ndarray, valid: np.ndarray) -> float | None:
    """The step of tone, DN, across a line of (n, 2) columns and rows in a plane (rows, columns); None: it is too short.

    The median over stations of 16 px of the left mean less the right one. ``plane`` is less what images without a cut
    show there, so that what changes on the ground is no step. ``valid``: (rows, columns) bool.
    """
    along = vertex_stations(points)
    places = np.arange(0.5, along[-1] // _STATION_PX * _STATION_PX)
    offsets = tuple((np.arange(_NEAR_PX, _FAR_PX) + 0.5).tolist())
    rows_columns = points_beside(points, along, places, offsets)[..., ::-1].transpose(3, 0, 1, 2) - 0.5
    tones = ndimage.map_coordinates(np.where(valid, plane, np.nan), rows_columns, order=0, cval=np.nan)
    sides = tones.reshape(2, -1, _STATION_PX * len(offsets))
    known = np.isfinite(sides)
    usable = (2 * known.sum(axis=2) >= sides.shape[2]).all(axis=0)
    if np.count_nonzero(usable) < _FEWEST_STATIONS:
        return None
    left, right = np.nanmean(sides[:, usable], axis=2)
    return abs(float(np.median(left - right)))
