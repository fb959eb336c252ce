"""Orthoimages in a mosaic's dress: in its tones and through the filter that came over it, band by band, where it is
followed and beyond; and the tones of two of them eased into each other at a cut."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy import ndimage

from ....imagery.lines import vertex_stations
from ....imagery.shifts import shifted
from ..following.levelling import SQUARE_PX, gain_field, square_means, to_pixels
from ..following.source_filters import UNTOUCHED, filtered
from ..judgement.hard_cut import JudgedGround
from ..seamlines.seam_pieces import points_beside

FEWEST_SQUARES = 48
"""Fewest squares of 8 px on which a source is alone: with less nobody can tell its tones."""
EASED_PX = 96
"""From a cut, over which tones are eased."""

_MIN_UNMIXED = 0.9  # of a square's pixels
_REACHES = 54.0, 18.0, 6.0, 2.0  # squares: what a tone is carried on by, the nearest that tells it
_LEAST = 0.05
_EASED_SQUARES = 1.0, 2.0, EASED_PX / SQUARE_PX / 3  # by scale: the finest are eased nearest to the cut
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
    where, filters = square_means(unmixed) > _MIN_UNMIXED, ground.expected.filters
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


def tells_tones(unmixed: np.ndarray) -> bool:
    """Whether such ground is enough."""
    return int(np.count_nonzero(square_means(unmixed) > _MIN_UNMIXED)) >= FEWEST_SQUARES


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
