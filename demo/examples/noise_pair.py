"""Two images of one ground: by a clean sensor and on grainy film, with quiet fields between its woods."""
from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy import ndimage

from demo.block import EASTING, EPSG, NORTHING

from .files import texture, write_raster

SIDE = 1024  # px
PIXEL = 0.25  # m
READ_NOISE, GRAIN = 0.6, 7.0  # DN
GRAIN_PX = 0.6  # sigma of a grain


def make_noise_pair(folder: Path) -> None:
    """Write `sensor.tif` and `film.tif`."""
    random = np.random.default_rng(2009)
    folder.mkdir(parents=True, exist_ok=True)
    shape = (SIDE, SIDE)
    woods = 1 / (1 + np.exp(-8 * texture(shape, 5, random)))
    ground = 120 + 22 * woods * texture(shape, 2.7, random)
    place = (EASTING, NORTHING, PIXEL)
    for name, noise in (("sensor", READ_NOISE * random.standard_normal((3, *shape))), ("film", _grain(random, shape))):
        pixels = np.clip(np.rint(ground + noise), 1, 255).astype(np.uint8)
        write_raster(folder / f"{name}.tif", pixels, EPSG, place)


def _grain(random: np.random.Generator, shape: tuple[int, int]) -> np.ndarray:
    grain = ndimage.gaussian_filter(random.standard_normal((3, *shape)), (0, GRAIN_PX, GRAIN_PX))
    return np.asarray(GRAIN * grain / grain.std())
