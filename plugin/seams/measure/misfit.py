"""How far two images lie from each other as a mosaic has them, and what that costs where they are mixed."""
from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...imagery.shifts import Shift, shifted
from ...imagery.wavelets import placed_components
from .causes import Misfit
from .limits import MIN_MISREGISTRATION_PX

_LOOK_PX = 256  # side of the part that is looked at, about the seam
_EDGE_PX = 16  # of it, which wavelets and the shift don't know
_FEWEST_PX = 1000


def placed_misfit(between: Shift, first: Shift, second: Shift) -> tuple[float, float]:
    """How the first image lies to the right of and below the second as placed in the mosaic, px.

    ``between``: how the first lies on the second as they are given; ``first``, ``second``: how the mosaic lies on each
    of them where it follows it. What the mosaic has in common with both, or corrected, drops out.
    """
    return between.x + first.x - second.x, between.y + first.y - second.y


def misfit_of(
    misfit: tuple[float, float], shown: Mapping[int, np.ndarray], pair: tuple[int, int], seam: np.ndarray, wavelet: str
) -> Misfit:
    """What a misfit makes the finest detail of two images differ by.

    ``shown``: planes (rows, columns) as the mosaic shows its sources; ``seam``: (rows, columns) bool, the ground about
    the seam between the ``pair``. With rho the correlation of their finest details there, as placed and with the one
    moved to where the other is, a 50:50 feather keeps (1 + rho) / 2, so the share is that of 1 - rho.
    """
    length = float(np.hypot(*misfit))
    if length < MIN_MISREGISTRATION_PX or not seam.any():
        return Misfit(length, 0.0)
    place = _about(seam)
    first, second = (np.ascontiguousarray(shown[number][place]) for number in pair)
    moved = shifted(second, *misfit)
    (details,) = placed_components(np.stack([first, second, moved]), wavelet, 1)
    inner = np.s_[_EDGE_PX // 2 : -_EDGE_PX // 2]
    where = seam[place][::2, ::2][inner, inner]
    if np.count_nonzero(where) * 4 < _FEWEST_PX:
        return Misfit(length, 0.0)
    a, b, c = (details[:, k, inner, inner][:, where] for k in range(3))
    placed, aligned = _agreement(a, b), _agreement(a, c)
    return Misfit(length, float(np.clip((aligned - placed) / max(1 - placed, 1e-6), 0, 1)))


def _agreement(a: np.ndarray, b: np.ndarray) -> float:
    total = float(np.vdot(a, a) + np.vdot(b, b))
    return 2 * float(np.vdot(a, b)) / total if total > 0 else 1.0


def _about(seam: np.ndarray) -> tuple[slice, slice]:
    """The part, of an even number of rows and columns, in whose middle the seam is."""
    rows, columns = (
        _part(float(np.median(places)), length) for places, length in zip(np.nonzero(seam), seam.shape)
    )
    return rows, columns


def _part(middle: float, length: int) -> slice:
    side = min(_LOOK_PX, length)
    start = int(np.clip(middle - side / 2, 0, length - side)) // 2 * 2
    return slice(start, start + side)
