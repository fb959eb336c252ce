"""Orthoimages of the demonstration scene, each with the light, tone, blur, noise and shift of its own exposure."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .canvas import BLOCK_ROWS, PIXEL
from .scene import Scene

REACH = 4  # pixels on either side that the interpolation looks at
PHASES = 64  # positions between two pixels that the interpolation tells apart


@dataclass(frozen=True)
class Exposure:
    """How one image was taken; lengths in pixels unless said otherwise."""

    name: str
    sun: float = 1.0  # share of direct light
    turn: float = 0.0  # of the footprint, degrees
    blur: float = 0.38  # sigma of the optics' Gaussian
    gain: tuple[float, float, float] = (1.0, 1.0, 1.0)
    bias: tuple[float, float, float] = (0.0, 0.0, 0.0)
    gamma: float = 1.0
    falloff: tuple[float, float] = (0.0, 0.0)  # relative change of brightness across the image, east and south
    shift: tuple[float, float] = (0.0, 0.0)  # mean misregistration, east and south
    warp: float = 0.3  # amplitude of the local misregistration around the mean
    origin: tuple[float, float] = (0.0, 0.0)  # of the image's grid relative to the mosaic's


@dataclass(frozen=True)
class Box:
    """A rectangle in metres, x to the east, y to the south."""

    left: float
    top: float
    right: float
    bottom: float


@dataclass(frozen=True)
class Orthoimage:
    """8-bit pixels (3, rows, cols), 0 in all bands where there is nothing; `left`, `top` in metres."""

    name: str
    pixels: np.ndarray
    left: float
    top: float


def take(scene: Scene, exposure: Exposure, footprint: Box, rng: np.random.Generator) -> Orthoimage:
    """Photograph and rectify the part of the scene under a footprint."""
    half_u, half_v = (footprint.right - footprint.left) / 2, (footprint.bottom - footprint.top) / 2
    middle_x, middle_y = footprint.left + half_u, footprint.top + half_v
    turn = np.radians(exposure.turn)
    half_x = half_u * np.cos(turn) + half_v * abs(np.sin(turn))
    half_y = half_v * np.cos(turn) + half_u * abs(np.sin(turn))
    left = np.floor((middle_x - half_x) / PIXEL) * PIXEL + exposure.origin[0] * PIXEL
    top = np.floor((middle_y - half_y) / PIXEL) * PIXEL + exposure.origin[1] * PIXEL
    cols, rows = int(np.ceil(2 * half_x / PIXEL)), int(np.ceil(2 * half_y / PIXEL))
    x = (left + (np.arange(cols) + 0.5) * PIXEL - middle_x).astype(np.float32)[None, :]
    y = (top + (np.arange(rows) + 0.5) * PIXEL - middle_y).astype(np.float32)[:, None]
    phases = rng.uniform(0, 2 * np.pi, 8)
    pixels = np.zeros((3, rows, cols), dtype=np.uint8)
    for start in range(0, rows, BLOCK_ROWS):
        part = slice(start, min(start + BLOCK_ROWS, rows))
        shifts = misregistration(x, y[part], exposure, 2 * max(half_u, half_v), phases)
        first = int(round((top - scene.top) / PIXEL - exposure.origin[1])) + part.start
        column = int(round((left - scene.left) / PIXEL - exposure.origin[0]))
        light = sample(scene, first, column, shifts, exposure)
        light *= 1 + exposure.falloff[0] * x / half_u + exposure.falloff[1] * y[part] / half_v
        signal = expose(light, exposure)
        # Photon noise grows with the signal; the sum has a sigma of 1 to 1.5 DN.
        sigma = np.sqrt(np.float32(0.5) + np.float32(0.009) * signal)
        signal += sigma * rng.standard_normal(signal.shape, dtype=np.float32)
        # A valid pixel is never black in all bands, since that is how nodata looks.
        digital = np.clip(np.rint(signal), 1, 255).astype(np.uint8)
        pixels[:, part] = digital * inside(x, y[part], turn, half_u, half_v, phases)
    return Orthoimage(exposure.name, pixels, float(left), float(top))


def inside(x: np.ndarray, y: np.ndarray, turn: float, half_u: float, half_v: float, phases: np.ndarray) -> np.ndarray:
    """Where a turned footprint has pixels; rectification over terrain leaves its border slightly wavy."""
    u = x * np.cos(turn) + y * np.sin(turn)
    v = y * np.cos(turn) - x * np.sin(turn)
    wave = 0.006 * min(half_u, half_v)
    edge_u = half_u - wave * (1 + np.sin(9 * v / half_v + phases[0]) * np.sin(4 * v / half_v + phases[1]))
    edge_v = half_v - wave * (1 + np.sin(8 * u / half_u + phases[2]) * np.sin(5 * u / half_u + phases[3]))
    return (np.abs(u) <= edge_u) & (np.abs(v) <= edge_v)


def misregistration(x: np.ndarray, y: np.ndarray, exposure: Exposure, size: float,
                    phases: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Smooth shift of each pixel in pixels, east and south, about the image's mean shift."""
    wave = np.float32(2 * np.pi / size)
    east = np.sin(2.1 * wave * x + 1.3 * wave * y + phases[4]) * np.cos(1.7 * wave * y + phases[5])
    south = np.cos(1.6 * wave * x + phases[6]) * np.sin(2.3 * wave * y - 1.1 * wave * x + phases[7])
    return (exposure.shift[0] + exposure.origin[0] + exposure.warp * east,
            exposure.shift[1] + exposure.origin[1] + exposure.warp * south)


def sample(scene: Scene, row: int, column: int, shifts: tuple[np.ndarray, np.ndarray],
           exposure: Exposure) -> np.ndarray:
    """Light at the shifted pixels, (3, rows, cols): the optics' blur and the interpolation in one kernel.

    The kernel is a Gaussian cut to the band of the pixel grid, so each sub-pixel position is equally sharp.
    """
    east, south = shifts
    rows, cols = east.shape
    span = REACH + int(np.ceil(max(np.abs(east).max(), np.abs(south).max())))
    light = scene.radiance(slice(row - span, row + rows + span), slice(column - span, column + cols + span),
                           exposure.sun)
    table = kernel_table(exposure.blur, span)
    # The shift changes by thousandths of a pixel over the few rows of margin: the border's value will do.
    index = phase_index(np.pad(east, ((span, span), (0, 0)), mode="edge"), span)
    across = np.zeros((3, rows + 2 * span, cols), dtype=np.float32)
    for tap in range(2 * span + 1):
        across += table[tap].take(index) * light[:, :, tap:tap + cols]
    index = phase_index(south, span)
    result = np.zeros((3, rows, cols), dtype=np.float32)
    for tap in range(2 * span + 1):
        result += table[tap].take(index) * across[:, tap:tap + rows]
    return result


def phase_index(shift: np.ndarray, span: int) -> np.ndarray:
    """Entry of the kernel table for a shift."""
    return np.rint((shift + span) * PHASES).astype(np.intp)


def kernel_table(blur: float, span: int) -> np.ndarray:
    """Weights (2 span + 1 taps, shifts from -span to span) of the blurred interpolation kernel."""
    shift = np.arange(-span * PHASES, span * PHASES + 1) / PHASES
    distance = np.arange(-span, span + 1)[:, None] - shift[None, :]
    frequency = (np.arange(64) + 0.5) / 128
    transfer = np.exp(-2 * (np.pi * blur * frequency) ** 2)
    weights = (transfer * np.cos(2 * np.pi * frequency * distance[..., None])).sum(axis=-1)
    weights *= np.where(np.abs(distance) < REACH, np.cos(np.pi * distance / (2 * REACH)) ** 2, 0)
    return (weights / weights.sum(axis=0)).astype(np.float32)


def expose(light: np.ndarray, exposure: Exposure) -> np.ndarray:
    """Digital numbers of the light in the image's own tone: DN = bias + gain * 200 * light^gamma."""
    signal = np.maximum(light, np.float32(1e-3))
    if exposure.gamma != 1.0:
        signal **= np.float32(exposure.gamma)
    for band in range(3):
        signal[band] *= np.float32(200 * exposure.gain[band])
        signal[band] += np.float32(exposure.bias[band])
    return signal
