"""Grounds that are drawn: three dates of one place, three satellite images of one scene."""
from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy import ndimage

from demo.camera import Box, Exposure, take
from demo.canvas import PIXEL
from demo.scene import Scene, fractal_noise, make_scene

from .known_windows import Imagery, PlacedImage
from .seam_makings import whole_values

MARGIN_M = 3.0
DATES_EXTENT = (196.0, 84.0)
"""Width and depth, m."""
OTHER_COVER = 0.4
"""Share of the land cover that differs between two dates."""
DATES = (
    Exposure("first", shift=(0.2, -0.15), warp=0.15),
    Exposure("second", sun=0.8, blur=0.42, gain=(1.05, 1.0, 0.96), bias=(4, 2, 0), shift=(-0.2, 0.1), warp=0.15),
    Exposure("third", sun=0.9, gain=(0.94, 0.97, 1.0), bias=(3, 3, 6), gamma=1.05, shift=(0.1, 0.3), warp=0.15),
)
SATELLITE_EXTENT = (760.0, 330.0)
COARSE = 5
"""Pixels of the scene that one of the satellite is wide and high."""
SATELLITE_CONTRAST, SATELLITE_LEVEL = 70.0, 45.0
"""Grey values of light 1, and of none: haze takes texture."""
SATELLITE_TONES = ((1.0, 0.0), (0.96, 5.0), (1.05, -4.0))
SATELLITE_STEPS = ((0, 0), (1, 2), (3, -1))
"""How much farther down and right each image was taken, in pixels of the scene: parts of the satellite's."""
SATELLITE_NOISE = 1.0


def dates() -> Imagery:
    """Three orthoimages (0.10 m) of one place, each with other crops and trees in a part of it and light of its own."""
    first = _scene(DATES_EXTENT, 1)
    images = []
    for number, exposure in enumerate(DATES):
        scene = first if number == 0 else _later(first, number)
        width, depth = DATES_EXTENT
        images.append(take(scene, exposure, Box(0.0, 0.0, width, depth), np.random.default_rng(10 + number)))
    left, top = min(image.left for image in images), min(image.top for image in images)
    placed = tuple(
        PlacedImage(one.pixels, round((one.top - top) / PIXEL), round((one.left - left) / PIXEL), 0) for one in images
    )
    return _imagery("dates", PIXEL, placed)


def satellites() -> Imagery:
    """Three images (0.5 m) of one scene that hardly differ: little texture, parts of a pixel apart, 1 DN of noise."""
    scene = _scene(SATELLITE_EXTENT, 3)
    rows, columns = (int(size / PIXEL) // COARSE * COARSE for size in SATELLITE_EXTENT[::-1])
    first = int(MARGIN_M / PIXEL)
    placed = []
    for (gain, bias), (down, right) in zip(SATELLITE_TONES, SATELLITE_STEPS):
        rng = np.random.default_rng([down, right + COARSE])
        light = _averaged(scene, first + down, first + right, rows, columns)
        signal = SATELLITE_LEVEL + SATELLITE_CONTRAST * light
        noise = rng.normal(0, SATELLITE_NOISE, signal.shape)
        placed.append(PlacedImage(whole_values(np.maximum(gain * signal + bias + noise, 1)), 0, 0, 0))
    return _imagery("satellites", COARSE * PIXEL, tuple(placed))


def _averaged(scene: Scene, row: int, column: int, rows: int, columns: int) -> np.ndarray:
    """Light of each pixel of the satellite, (bands, rows, columns)."""
    strips = []
    for start in range(row, row + rows, 64 * COARSE):
        stop = min(start + 64 * COARSE, row + rows)
        light = scene.radiance(slice(start, stop), slice(column, column + columns), 1.0)
        strips.append(light.reshape(3, -1, COARSE, columns // COARSE, COARSE).mean(axis=(2, 4)))
    return np.concatenate(strips, axis=1)


def _scene(extent_m: tuple[float, float], seed: int) -> Scene:
    return make_scene(extent_m, MARGIN_M, np.random.default_rng(seed))


def _later(first: Scene, number: int) -> Scene:
    """The scene at another date: another one in patches that are some ten metres wide."""
    other = _scene(DATES_EXTENT, 1 + number)
    rng = np.random.default_rng(100 + number)
    patches = ndimage.gaussian_filter(fractal_noise(first.sunlight.shape, 2.0, rng), 4 / PIXEL)
    changed = patches > np.quantile(patches, 1 - OTHER_COVER)
    return replace(
        first,
        reflectance=np.where(changed, other.reflectance, first.reflectance),
        sunlight=np.where(changed, other.sunlight, first.sunlight),
    )


def _imagery(name: str, pixel_m: float, placed: tuple[PlacedImage, ...]) -> Imagery:
    rows = max(one.row + one.bands.shape[1] for one in placed)
    columns = max(one.column + one.bands.shape[2] for one in placed)
    return Imagery(name, pixel_m, placed, rows, columns)
