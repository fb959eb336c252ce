"""The canvas that the demonstration scene is drawn on.

Coordinates are metres from the upper left corner of the mosaic, x to the east, y to the south.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Callable

import numpy as np

PIXEL = 0.10  # m, of the scene, the orthoimages and the mosaic
BLOCK_ROWS = 256  # rows worked on at once: bounds the memory of the temporary arrays

Colour = Sequence[float]
Curve = Callable[[np.ndarray], np.ndarray]
Extent = tuple[float, float]  # width and depth of the mosaic, m


@dataclass(frozen=True)
class Canvas:
    """Reflectance (3, rows, cols) and height in metres (rows, cols) being drawn, with two textures to draw from."""

    reflectance: np.ndarray
    height: np.ndarray
    left: float
    top: float
    grain: np.ndarray
    patches: np.ndarray

    def x(self) -> np.ndarray:
        """Pixel centres to the east, m."""
        return (self.left + (np.arange(self.height.shape[1]) + 0.5) * PIXEL).astype(np.float32)

    def y(self) -> np.ndarray:
        """Pixel centres to the south, m."""
        return (self.top + (np.arange(self.height.shape[0]) + 0.5) * PIXEL).astype(np.float32)


@dataclass(frozen=True)
class Patch:
    """A small part of a canvas with the coordinates u, v (m) of an object's own frame."""

    reflectance: np.ndarray
    height: np.ndarray
    grain: np.ndarray
    patches: np.ndarray
    u: np.ndarray
    v: np.ndarray

    def cover(self, distance: np.ndarray) -> np.ndarray:
        """Share of each pixel inside the shape whose signed distance this is."""
        return np.clip(0.5 - distance / PIXEL, 0, 1)

    def box(self, half_u: float, half_v: float, u: float = 0.0, v: float = 0.0) -> np.ndarray:
        """Cover of a rectangle about (u, v)."""
        return self.cover(np.maximum(np.abs(self.u - u) - half_u, np.abs(self.v - v) - half_v))

    def paint(self, cover: np.ndarray, colour: Colour, shade: np.ndarray | float = 1.0) -> None:
        """Lay a colour over the ground."""
        for band in range(3):
            self.reflectance[band] += cover * (colour[band] * shade - self.reflectance[band])

    def raise_to(self, cover: np.ndarray, height: np.ndarray | float) -> None:
        """Lift the surface to a height above the ground."""
        self.height[...] += cover * (height - self.height)


def patch_at(canvas: Canvas, x: float, y: float, angle: float, radius: float) -> Patch:
    """The square part of the canvas around a point; u runs along `angle`. May be empty at the border."""
    rows, cols = canvas.height.shape
    col = [int(np.clip((x + side - canvas.left) / PIXEL, 0, cols)) for side in (-radius, radius)]
    row = [int(np.clip((y + side - canvas.top) / PIXEL, 0, rows)) for side in (-radius, radius)]
    window = slice(row[0], row[1]), slice(col[0], col[1])
    dx = (canvas.left + (np.arange(*col) + 0.5) * PIXEL - x).astype(np.float32)[None, :]
    dy = (canvas.top + (np.arange(*row) + 0.5) * PIXEL - y).astype(np.float32)[:, None]
    cosine, sine = np.float32(np.cos(angle)), np.float32(np.sin(angle))
    return Patch(canvas.reflectance[(slice(None), *window)], canvas.height[window], canvas.grain[window],
                 canvas.patches[window], dx * cosine + dy * sine, dy * cosine - dx * sine)
