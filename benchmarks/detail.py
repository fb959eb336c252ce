"""Finest detail as PyWavelets has it, pixel by pixel: apart from the code under test."""
from __future__ import annotations

from functools import lru_cache

import numpy as np
import pywt

MIRRORED_PX = 32
"""Farther than the wavelets look, and a multiple of 2^level."""
LUMINANCE = np.array((0.299, 0.587, 0.114), np.float32)


def luminance_of(bands: np.ndarray) -> np.ndarray:
    """(rows, columns) float32 of three bands."""
    return np.asarray(np.tensordot(LUMINANCE, bands.astype(np.float32), 1))


def detail_energy(plane: np.ndarray, level: int, wavelet: str) -> np.ndarray:
    """Squares of the three details of a level, (rows, columns), each at the pixel that it stands for."""
    return np.asarray(np.square(details(plane, level, wavelet)).sum(axis=0))


def details(plane: np.ndarray, level: int, wavelet: str) -> np.ndarray:
    """The three details of a level by the undecimated transform, (3, rows, columns), each at its own pixel.

    The plane is mirrored at its edges: the step from one edge to the other, which a periodic transform shows there, is
    no detail.
    """
    rows, columns = plane.shape
    padded = np.pad(plane, [(MIRRORED_PX, MIRRORED_PX + -size % 2**level) for size in plane.shape], mode="symmetric")
    found = _details(padded, level, wavelet)
    placed = [np.roll(one, (-down, -across), (0, 1)) for one, (down, across) in zip(found, _delays(level, wavelet))]
    return np.stack(placed)[:, MIRRORED_PX : MIRRORED_PX + rows, MIRRORED_PX : MIRRORED_PX + columns]


def _details(plane: np.ndarray, level: int, wavelet: str) -> np.ndarray:
    return np.array(pywt.swt2(plane, wavelet, level, norm=True, trim_approx=True)[1])


@lru_cache
def _delays(level: int, wavelet: str) -> tuple[tuple[int, int], ...]:
    """How many pixels, downwards and to the right, the coefficients of each detail lag behind what they come from:
    where the energy of a point lies."""
    side = 2 ** (level + 6)
    point = np.zeros((side, side))
    point[side // 2, side // 2] = 1
    energies = np.square(_details(point, level, wavelet))
    at = np.arange(side) - side // 2
    return tuple(
        (round(float(energy.sum(axis=1) @ at / energy.sum())), round(float(energy.sum(axis=0) @ at / energy.sum())))
        for energy in energies
    )
