"""Orthoimages in a mosaic's dress: in its tones and through the filter that came over it, band by band, where it is
followed and beyond; and the tones of two of them eased into each other at a cut."""
from __future__ import annotations

import numpy as np
from scipy import ndimage

from ....imagery.shifts import shifted
from ..following.hard_cut import JudgedGround
from ..following.levelling import SQUARE_PX, gain_field, square_means, to_pixels
from ..following.source_filters import UNTOUCHED, filtered

FEWEST_SQUARES = 48
"""Of 8 px, on which a source is alone: with less nobody can tell its tones."""
EASED_PX = 96
"""From a cut, over which tones are eased."""

_MIN_OWN = 0.9  # of a square's pixels
_REACHES = 54.0, 18.0, 6.0, 2.0  # squares: what a tone is carried on by, the nearest that tells it
_LEAST = 0.05
_EASED_SQUARES = 1.0, 2.0, EASED_PX / SQUARE_PX / 3  # by scale: the finest are eased nearest to the cut
_RIM_SQUARES = 2.0  # what is wider are the mosaic's tones at the rim of a patch


def placed_bands(ground: JudgedGround, source: int, bands: np.ndarray, valid: np.ndarray) -> np.ndarray:
    """Bands (bands, rows, columns) of a source as float32, where they lie in the mosaic; what is not ``valid``, (rows,
    columns) bool, is as the nearest that is, since filters see beyond the image's rim."""
    found = bands.astype(np.float32)
    if not valid.all():
        found = found[(slice(None), *_nearest(valid))]
    move = ground.followed.moves.get(_plane(ground, source))
    return found if move is None else np.stack([shifted(band, move.x, move.y) for band in found])


def _nearest(known: np.ndarray) -> tuple[np.ndarray, ...]:
    """Rows and columns of the known sample that is nearest to each."""
    return tuple(ndimage.distance_transform_edt(~known, return_distances=False, return_indices=True))


def dressed(ground: JudgedGround, source: int, band: np.ndarray, mosaic: np.ndarray, own: np.ndarray) -> np.ndarray:
    """A band of a placed source as the mosaic's band shows it where it is followed, and would elsewhere; (rows,
    columns) float32 each. ``own``: pixels, bool, on which the mosaic is of this source alone.

    Gain and filter are the estimator's; the bias is that of the nearest ground that tells it, at the scale of squares
    and wider, so that nothing finer is taken over from the mosaic.
    """
    share, means, reference = square_means(own), square_means(mosaic), square_means(band)
    where = share > _MIN_OWN
    gains = gain_field(means, reference, where)
    bias = _carried_on(means - gains * reference, where)
    plane = to_pixels(gains, band.shape) * band + to_pixels(bias, band.shape)
    filters = ground.expected.filters
    if not filters.taps:
        return plane
    common = next(iter(filters.taps.values())) if filters.came_over_cuts else UNTOUCHED
    return filtered(plane, filters.taps.get(_plane(ground, source), common))


def _plane(ground: JudgedGround, source: int) -> int:
    """Which of a source's planes the mosaic follows most: as it is, or moved to where it lies in the mosaic."""
    planes = [plane for plane, of in enumerate(ground.followed.source_of) if of == source]
    return max(planes, key=lambda plane: ground.followed.following.shares[plane])


def tells_tones(own: np.ndarray) -> bool:
    """Whether such ground is enough."""
    return int(np.count_nonzero(square_means(own) > _MIN_OWN)) >= FEWEST_SQUARES


def eased(
    first: np.ndarray, second: np.ndarray, weight: np.ndarray, mosaic: np.ndarray, inside: np.ndarray,
    valid: np.ndarray,
) -> np.ndarray:
    """Two dressed bands cut where ``weight``, that of the first one, passes one half, all (rows, columns) float32.

    What is coarser than squares of 8 px is eased, each scale as far as it is wide, tones over ``EASED_PX``: what is
    finer is of one image alone, but for the few pixels in which the weight is neither 0 nor 1. Towards the edge of the
    patch, ``inside`` 0 there and 1 within, tones are those of the mosaic, so that it shows no edge. ``valid``: bool,
    pixels that all three have; beyond them tones are those of the nearest.
    """
    places = _nearest(square_means(valid) == 1)
    made = weight * first + (1 - weight) * second
    share, apart = square_means(weight), square_means(first - second)[places]
    # Of every scale what is added differs across the cut by as much as the images do, and fades as far as it is wide.
    for reach in _EASED_SQUARES:
        wider = ndimage.gaussian_filter(apart, reach, mode="nearest") if reach < _EASED_SQUARES[-1] else 0
        even = ndimage.gaussian_filter(share, reach, mode="nearest")
        made += (to_pixels(even, made.shape) - weight) * to_pixels(apart - wider, made.shape)
        apart = wider
    rest = ndimage.gaussian_filter(square_means(mosaic - made)[places], _RIM_SQUARES, mode="nearest")
    return np.asarray(made + (1 - inside) * to_pixels(rest, made.shape), np.float32)


def _carried_on(bias: np.ndarray, known: np.ndarray) -> np.ndarray:
    """Smoothed where it is known, and carried on from there."""
    found = np.full(bias.shape, bias[known].mean(), np.float32)
    for reach in _REACHES:
        weight = ndimage.gaussian_filter(known.astype(np.float32), reach, mode="nearest")
        near = ndimage.gaussian_filter(np.where(known, bias, 0).astype(np.float32), reach, mode="nearest")
        found = (near + _LEAST * found) / (weight + _LEAST)
    return np.asarray(found, np.float32)
