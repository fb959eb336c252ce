"""Mosaics of made-up sources over a known seam, and how much they truly keep, by PyWavelets."""
from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy import ndimage
from seam_inspector.plugin.imagery.wavelets import detail_components
from seam_inspector.plugin.seams.measure.profile.detail_cells import DetailCells, detail_cells

from tests.numbers.synthetic import texture, wavedec

WAVELET, LEVELS, SIDE = "coif3", 3, 512


@dataclass(frozen=True, eq=False)
class Blend:
    """Planes (rows, columns) float32."""

    hard: np.ndarray
    """The hard cut."""
    made: np.ndarray
    labels: np.ndarray
    distance: np.ndarray
    """From the nearest seam, px."""

    def cells(self, mosaic: np.ndarray | None = None, labels: np.ndarray | None = None) -> DetailCells:
        """Of the blend against its hard cut, or of another mosaic or other labels."""
        planes = np.stack([self.made if mosaic is None else mosaic, self.hard]).astype(np.float32)
        return detail_cells(list(detail_components(planes, WAVELET, LEVELS)), self.labels if labels is None else labels)

    def truth(self, near: float, far: float, level: int = 1) -> float:
        """Energy of the blend's detail over that of the hard cut, between two distances, by ``pywt.wavedec2``."""
        energies = [np.sum(np.square(wavedec(one, WAVELET, level)[1]), axis=0) for one in (self.made, self.hard)]
        rows, columns = energies[0].shape
        distance = self.distance.reshape(rows, 2**level, columns, 2**level).mean(axis=(1, 3))
        where = (distance >= near) & (distance < far)
        return float(energies[0][where].sum() / energies[1][where].sum())


@lru_cache(maxsize=8)
def sources(side: int = SIDE, seed: int = 0, in_common: float = 0.0) -> tuple[np.ndarray, ...]:
    """Three planes of ground that changes from place to place; ``in_common``: the share of variance that all show."""
    contrast = 14 * np.exp(0.5 * ndimage.gaussian_filter(texture((side, side), 3.0, seed + 77), 12, mode="wrap"))
    ground = texture((side, side), 1.2, seed + 100)
    return tuple(
        120 + contrast * (in_common**0.5 * ground + (1 - in_common) ** 0.5 * texture((side, side), 1.2, seed + i))
        for i in range(3)
    )


def crooked(side: int = SIDE, seed: int = 0, count: int = 2) -> np.ndarray:
    """Labels of sources that meet along a crooked line, a third of them below another."""
    row, column = np.mgrid[:side, :side]
    phase = np.random.default_rng(seed).uniform(0, 6, 2)
    labels = (column > side / 2 + 0.06 * side * np.sin(row / 40 + phase[0])).astype(np.uint8)
    if count == 3:
        labels[(labels == 1) & (row > side / 2 + 0.05 * side * np.cos(column / 30 + phase[1]))] = 2
    return labels


def blend(
    width_px: float, ramp: str = "cosine", side: int = SIDE, seed: int = 0, count: int = 2, in_common: float = 0.0
) -> Blend:
    """Feathered over a full width, 0 for a hard cut."""
    labels, planes = crooked(side, seed, count), sources(side, seed, in_common)
    depths = [_depth(labels == i) for i in range(count)]
    hard = np.choose(labels, planes[:count])
    if not width_px:
        return Blend(hard, hard, labels, np.abs(depths).min(axis=0))
    parts = [np.clip(depth / width_px + 0.5, 0, 1) for depth in depths]
    if ramp == "cosine":
        parts = [0.5 - 0.5 * np.cos(np.pi * part) for part in parts]
    total = np.sum(parts, axis=0)
    made = sum(part * plane for part, plane in zip(parts, planes)) / total
    return Blend(hard, np.asarray(made), labels, np.abs(depths).min(axis=0))


def _depth(inside: np.ndarray) -> np.ndarray:
    """Distance from the border, positive inside, px."""
    inner, outer = ndimage.distance_transform_edt(inside), ndimage.distance_transform_edt(~inside)
    return np.asarray(np.where(inside, inner - 0.5, 0.5 - outer))
