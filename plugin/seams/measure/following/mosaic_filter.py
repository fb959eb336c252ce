"""What came over a whole mosaic, as a linear filter: sharpening, blur, resampling, a shift of parts of a pixel.

Fitted by least squares where one source is followed, it makes of the sources what they would look like in this mosaic
if nothing had happened at its seams.
"""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ....imagery.filters import correlated

REACH_PX = 2
"""The filter has 5 x 5 taps."""
UNTOUCHED = np.pad(np.ones((1, 1), np.float32), REACH_PX)
"""The filter that leaves an image as it is."""
FEWEST_PIXELS = 2000
"""That a filter is learned from."""

_SIDE = 2 * REACH_PX + 1
_MOST_PIXELS = 12000
_AT_A_TIME = 384  # in float32, their sums in float64
_RIDGE = 1e-5
_MARGIN_PX = 8  # of the clip: what is beyond it is not known


def fit_filter(
    image: np.ndarray, reference: np.ndarray, where: np.ndarray, gain: float | None = None
) -> np.ndarray | None:
    """Taps (5, 5) with which ``reference`` comes nearest to ``image``, both high-passed, (rows, columns).

    ``where``, (rows, columns) bool: pixels that count. ``gain``: what the taps add up to, where that is known. None
    where too few pixels count.
    """
    found = fit_filters(image, [reference], where, gain)
    return None if found is None else found[0]


def fit_filters(
    image: np.ndarray, references: Sequence[np.ndarray], where: np.ndarray, gain: float | None = None
) -> np.ndarray | None:
    """The same of several images that are added up, (references, 5, 5); ``gain`` of each."""
    inside = np.flatnonzero(where[_MARGIN_PX:-_MARGIN_PX, _MARGIN_PX:-_MARGIN_PX])
    if len(inside) < FEWEST_PIXELS:
        return None
    columns, values = image.shape[1], [one.ravel() for one in references]
    down, across = np.divmod(inside[:: max(1, len(inside) // _MOST_PIXELS)], columns - 2 * _MARGIN_PX)
    places = (down + _MARGIN_PX) * columns + across + _MARGIN_PX
    offsets = np.add.outer(np.arange(-REACH_PX, REACH_PX + 1) * columns, np.arange(-REACH_PX, REACH_PX + 1)).ravel()
    count = len(references) * _SIDE**2
    normal, right = np.zeros((count, count)), np.zeros(count)
    for start in range(0, len(places), _AT_A_TIME):
        part = places[start : start + _AT_A_TIME]
        around = part[:, np.newaxis] + offsets
        samples = np.concatenate([one[around] for one in values], axis=1) if len(values) > 1 else values[0][around]
        normal += samples.T @ samples
        right += image.ravel()[part] @ samples
    mean = float(np.trace(normal)) / count
    if mean <= 0:
        return None
    normal += _RIDGE * mean * np.eye(count)
    if gain is not None:  # high-passed images say nothing of it, so it is given with weight
        normal += mean * np.kron(np.eye(len(references)), np.ones((_SIDE**2, _SIDE**2)))
        right += mean * gain
    return np.linalg.solve(normal, right).reshape(-1, _SIDE, _SIDE).astype(np.float32)


def filtered(plane: np.ndarray, taps: np.ndarray) -> np.ndarray:
    """A plane (rows, columns) float32 through the filter."""
    return correlated(plane, taps)
