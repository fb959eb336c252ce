"""How much detail a spoilt mosaic truly kept, by distance from the seam: against the known hard cut, by PyWavelets."""
from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import pywt

from .production import Made

BIN_PX = 8
FARTHEST_PX = 64
MIN_PIXELS = 256
"""Of a bin."""


@dataclass(frozen=True)
class TrueProfile:
    """The share of the detail energy that is left, by distance from the seam."""

    kept: tuple[float, ...]
    """In bins of ``BIN_PX`` from the seam on; nan where there is too little of one."""

    @property
    def near(self) -> float:
        """In the first bin."""
        return self.kept[0]

    @property
    def least(self) -> float:
        """In the bin that lost most."""
        return float(np.nanmin(self.kept))


def truth_kept(
    hard: np.ndarray, made: np.ndarray, distance_px: np.ndarray, level: int, wavelet: str,
    where: tuple[slice, slice] = (slice(None), slice(None)),
) -> TrueProfile:
    """The energies of two planes, (rows, columns), pixel by pixel; ``where`` narrows what is looked at.

    The transform is the undecimated one, so it makes no difference where on the grid of the decimated one a seam lies.
    """
    energies = [detail_energy(plane, level, wavelet)[where] for plane in (hard, made)]
    bins = (distance_px[where] / BIN_PX).astype(np.intp).clip(max=FARTHEST_PX // BIN_PX).ravel()
    count = FARTHEST_PX // BIN_PX + 1
    of_hard, of_made = (np.bincount(bins, one.ravel(), count) for one in energies)
    enough = (np.bincount(bins, minlength=count) >= MIN_PIXELS) & (of_hard > 0)
    kept = np.divide(of_made, of_hard, out=np.full(count, np.nan), where=enough)
    return TrueProfile(tuple(kept[:-1].tolist()))


def truth_of(made: Made, where: tuple[slice, slice], level: int = 1, wavelet: str = "coif3") -> TrueProfile:
    """Of the luminance."""
    weights = np.array((0.299, 0.587, 0.114))
    hard, spoilt = (np.tensordot(weights, bands.astype(np.float64), 1) for bands in (made.hard, made.bands))
    return truth_kept(hard, spoilt, made.distance, level, wavelet, where)


def detail_energy(plane: np.ndarray, level: int, wavelet: str) -> np.ndarray:
    """Squares of the three details of a level, (rows, columns), each at the pixel that it stands for."""
    return _energy(plane, level, wavelet, _delay(level, wavelet))


def _energy(plane: np.ndarray, level: int, wavelet: str, delay: int) -> np.ndarray:
    details = pywt.swt2(plane, wavelet, level, norm=True, trim_approx=True)[1]
    return np.roll(np.sum(np.square(details), axis=0), (-delay, -delay), (0, 1))


@lru_cache
def _delay(level: int, wavelet: str) -> int:
    """By how many pixels the coefficients lag behind what they come from: where the energy of a point lies."""
    side = 2 ** (level + 6)
    point = np.zeros((side, side))
    point[side // 2, side // 2] = 1
    across = _energy(point, level, wavelet, 0).sum(axis=1)
    return round(float(across @ np.arange(side) / across.sum())) - side // 2
