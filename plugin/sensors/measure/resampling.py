"""Pixels at places between pixels, by the kernels that GDAL's warper has under the same names."""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Callable

import numpy as np

_PHASES = 4096  # places between two pixels that weights are tabled for: at most 0.0001 px off
_SMALLEST_WEIGHT = 1e-6
_AT_ONCE = 16384  # places whose sums stay in a processor's own memory


def _catmull_rom(distance: np.ndarray) -> np.ndarray:
    near = (1.5 * distance - 2.5) * distance**2 + 1
    return np.where(distance < 1, near, ((2.5 - 0.5 * distance) * distance - 4) * distance + 2)


def _b_spline(distance: np.ndarray) -> np.ndarray:
    return np.where(distance < 1, (distance / 2 - 1) * distance**2 + 2 / 3, (2 - distance) ** 3 / 6)


_NEAREST = "nearest"
KERNELS: dict[str, tuple[float, Callable[[np.ndarray, float], np.ndarray]]] = {
    _NEAREST: (1.0, lambda distance, wide: np.ones_like(distance)),
    "bilinear": (1.0, lambda distance, wide: 1 - distance / wide),
    "cubic": (2.0, lambda distance, wide: _catmull_rom(distance / wide)),
    "cubicspline": (2.0, lambda distance, wide: _b_spline(distance / wide)),
    "lanczos": (3.0, lambda distance, wide: np.sinc(distance / wide) * np.sinc(distance / wide / 3)),
    "average": (1.0, lambda distance, wide: np.clip(wide / 2 + 0.5 - distance, 0, 1)),
}
"""How far pixels have a weight, in pixels or steps, whichever are wider; and how much, by their distance from the place
and by the wider of a pixel and a step, px."""


@dataclass(frozen=True)
class Resampler:
    """A kernel for a step between places, widened where places are further apart than pixels."""

    tables: tuple[np.ndarray, np.ndarray]
    """(taps, phases + 1) float32 weights along columns and rows, the sum of each phase 1."""
    nearest: bool
    """Whether the pixel that a place lies in is all."""

    @classmethod
    def of(cls, name: str, step_px: tuple[float, float]) -> Resampler:
        """``name``: one of ``KERNELS``; ``step_px``: between neighbouring places, along columns and rows."""
        radius, weight = KERNELS[name]
        tables = []
        for step in step_px:
            wide = max(step, 1.0)
            half = math.ceil(radius * wide)
            distance = np.abs(np.arange(1 - half, half + 1)[:, None] - np.arange(_PHASES + 1) / _PHASES)
            weights = np.where(distance < radius * wide, weight(distance, wide), 0.0)
            tables.append((weights / weights.sum(axis=0)).astype(np.float32))
        return cls((tables[0], tables[1]), name == _NEAREST)

    @property
    def margin_px(self) -> tuple[int, int]:
        """Pixels around a place, along columns and rows, that have a share."""
        return len(self.tables[0]) // 2, len(self.tables[1]) // 2

    def at(
        self, bands: np.ndarray, valid: np.ndarray | None, columns: np.ndarray, rows: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """(bands, n) values at places (n,), 0.5 the middle of the first pixel, and (n,) bool where there are any: where
        the pixel that a place lies in is ``valid`` (rows, columns). ``bands`` reach ``margin_px`` beyond the places."""
        width = bands.shape[2]
        column, row = columns.astype(np.int64), rows.astype(np.int64)
        own = row * width + column
        valid = None if valid is not None and valid.all() else valid
        sound = np.ones(len(columns), bool) if valid is None else valid.ravel().take(own)
        if self.nearest:
            return bands.reshape(len(bands), -1).take(own, axis=1), sound
        left, top = np.floor(columns - 0.5), np.floor(rows - 0.5)
        phases = [((place - 0.5 - first) * _PHASES + 0.5).astype(np.int32)
                  for place, first in ((columns, left), (rows, top))]
        before = [side - 1 for side in self.margin_px]
        first = (top.astype(np.int64) - before[1]) * width + left.astype(np.int64) - before[0]
        planes = [np.where(valid, band, 0) for band in bands] if valid is not None else list(bands)
        if valid is not None:
            planes.append(valid)
        pixels = [np.ascontiguousarray(plane, np.result_type(bands, np.float32)).ravel() for plane in planes]
        found = np.zeros((len(planes), len(columns)), pixels[0].dtype)
        for start in range(0, len(columns), _AT_ONCE):
            some = slice(start, start + _AT_ONCE)
            weights = [[line.take(phase[some]) for line in table] for table, phase in zip(self.tables, phases)]
            for plane, sums in zip(pixels, found):
                _add_convolved(sums[some], plane, width, first[some], *weights)
        if valid is None:
            return found, sound
        sound &= found[-1] > _SMALLEST_WEIGHT
        return found[:-1] / np.where(sound, found[-1], 1), sound


def _add_convolved(
    sums: np.ndarray, pixels: np.ndarray, width: int, first: np.ndarray, across: list[np.ndarray],
    down: list[np.ndarray],
) -> None:  # fmt: skip
    """Add pixels from ``first`` on (n,), the flat index of the upper left one, weighted."""
    taken, line = np.empty_like(sums), np.empty_like(sums)
    for below, weight_down in enumerate(down):
        line.fill(0)
        for beside, weight in enumerate(across):
            pixels[below * width + beside :].take(first, out=taken, mode="clip")
            taken *= weight
            line += taken
        line *= weight_down
        sums += line
