"""A village and its fields seen from above, drawn from nothing but a random seed.

The scene is two layers on a 0.10 m grid: reflectance in three bands and surface height. Light does the rest: relief
shading and cast shadows come from the heights, so roofs, crowns, ridges of soil and cabbages get their bright and
dark sides from one sun. The small things a mosaic tends to lose are all there: kerbs, drain grates, lane markings,
roof tiles, plough marks, vegetables in rows.
"""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import fft

from .canvas import BLOCK_ROWS, PIXEL, Canvas, Curve, Extent
from .ground import draw_ground
from .village import draw_objects

# Sun in the south-south-east: shadows fall one pixel to the west for every two to the north, 48 degrees high.
SUN_STEP = (2, 1)
SUN_TAN = 1.1
AMBIENT = np.array([0.37, 0.41, 0.47], dtype=np.float32)
DIRECT = np.array([0.84, 0.80, 0.72], dtype=np.float32)


@dataclass(frozen=True)
class Scene:
    """Reflectance (3, rows, cols) and direct sunlight (rows, cols), both float32 around 0..1.

    `left` and `top` place the upper left corner; `main_road` gives x of the road's axis for a y and `side_road` y for
    an x, so that seamlines can follow them.
    """

    reflectance: np.ndarray
    sunlight: np.ndarray
    left: float
    top: float
    main_road: Curve
    side_road: Curve

    def radiance(self, rows: slice, cols: slice, sun: float) -> np.ndarray:
        """Light that leaves the ground, (3, rows, cols): 1 is a clear day, 0 a closed cloud cover."""
        direct = DIRECT * np.float32(sun)
        ambient = AMBIENT + (DIRECT - direct) * np.float32(0.6)
        light = self.sunlight[rows, cols] * direct[:, None, None] + ambient[:, None, None]
        return self.reflectance[:, rows, cols] * light


def make_scene(extent_m: Extent, margin_m: float, rng: np.random.Generator) -> Scene:
    """Draw the ground, the objects on it and the light, over the extent and a margin around it."""
    cols, rows = (int(round((side + 2 * margin_m) / PIXEL)) for side in extent_m)
    canvas = Canvas(
        reflectance=np.empty((3, rows, cols), dtype=np.float32),
        height=np.zeros((rows, cols), dtype=np.float32),
        left=-margin_m, top=-margin_m,
        grain=fractal_noise((rows, cols), 1.7, rng),
        patches=fractal_noise((rows, cols), 3.2, rng),
    )
    main_road, side_road = roads(extent_m)
    draw_ground(canvas, extent_m, main_road, side_road, rng)
    draw_objects(canvas, extent_m, main_road, side_road, rng)
    sunlight = shading(canvas.height)
    sunlight *= 1 - cast_shadow(canvas.height)
    return Scene(canvas.reflectance, sunlight, canvas.left, canvas.top, main_road, side_road)


def fractal_noise(shape: tuple[int, int], beta: float, rng: np.random.Generator) -> np.ndarray:
    """Noise with the power spectrum 1/f^beta, zero mean, unit variance."""
    padded = tuple(fft.next_fast_len(side, real=True) for side in shape)
    columns = padded[1] // 2 + 1
    fy = fft.fftfreq(padded[0]).astype(np.float32)[:, None]
    fx = fft.rfftfreq(padded[1]).astype(np.float32)[None, :]
    power = fy * fy + fx * fx
    power[0, 0] = np.inf
    power **= -beta / 4
    spectrum = np.empty((padded[0], columns), dtype=np.complex64)
    spectrum.real = rng.standard_normal(spectrum.shape, dtype=np.float32)
    spectrum.imag = rng.standard_normal(spectrum.shape, dtype=np.float32)
    spectrum *= power
    noise = fft.irfft2(spectrum, padded, overwrite_x=True)[:shape[0], :shape[1]]
    return np.ascontiguousarray((noise - noise.mean()) / noise.std())


def roads(extent_m: Extent) -> tuple[Curve, Curve]:
    """Axes of the two roads that cross in the village: x of the main one by y, y of the side one by x."""
    width, depth = extent_m

    def main_road(y: np.ndarray) -> np.ndarray:
        return 0.32 * width + 0.015 * width * np.sin(2.2 * np.pi * y / depth) + 0.03 * width * (y / depth - 0.5)

    def side_road(x: np.ndarray) -> np.ndarray:
        return 0.49 * depth + 0.02 * depth * np.sin(1.7 * np.pi * x / width + 0.6)

    return main_road, side_road


def shading(height: np.ndarray) -> np.ndarray:
    """Cosine of the sun's incidence relative to flat ground, from the surface's slopes."""
    sun = np.array([SUN_STEP[1], SUN_STEP[0], np.hypot(*SUN_STEP) * SUN_TAN], dtype=np.float32)
    light = np.empty_like(height)
    for start in range(0, height.shape[0], BLOCK_ROWS):
        first, stop = max(start - 1, 0), min(start + BLOCK_ROWS + 1, height.shape[0])
        slope_y, slope_x = np.gradient(height[first:stop], np.float32(PIXEL))
        # Walls would else be brighter than anything the camera can see from above.
        np.clip(slope_x, -1.6, 1.6, out=slope_x)
        np.clip(slope_y, -1.6, 1.6, out=slope_y)
        value = (1 - (slope_x * sun[0] + slope_y * sun[1]) / sun[2])
        value /= np.sqrt(1 + slope_x * slope_x + slope_y * slope_y)
        keep = slice(start - first, start - first + BLOCK_ROWS)
        light[start:start + BLOCK_ROWS] = np.clip(value[keep], 0, 1.6)
    return light


def cast_shadow(height: np.ndarray) -> np.ndarray:
    """Share of the sun that higher things to the south take away, 0..1, with a narrow penumbra.

    The upper hull along the sun's ray is found by doubling the step, so that 64 pixels cost six passes.
    """
    hull = height.copy()
    np.maximum(hull[:-1], height[1:] - np.float32(PIXEL * SUN_TAN), out=hull[:-1])
    for k in range(7):
        down, right = SUN_STEP[0] << k, SUN_STEP[1] << k
        if down >= height.shape[0] or right >= height.shape[1]:
            break
        drop = np.float32(np.hypot(down, right) * PIXEL * SUN_TAN)
        np.maximum(hull[:-down, :-right], hull[down:, right:] - drop, out=hull[:-down, :-right])
    hull -= height
    hull /= np.float32(0.18)
    return np.clip(hull, 0, 1, out=hull)
