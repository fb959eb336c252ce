"""Rasters with room for fifty windows of 1024 px."""
from __future__ import annotations

from pathlib import Path

import numpy as np

from tests.numbers.synthetic import orthoimage, write_raster

SIDE = 1024  # px
BOXES = [(430 * column, 330 * row, SIDE, SIDE) for row in range(7) for column in range(8)][:50]
"""Column, row, width and height of each window."""


def make_large_rasters(folder: Path) -> list[Path]:
    """A mosaic and two sources of 4096 x 4096 px, three bands."""
    tile = orthoimage((SIDE, SIDE))
    paths = []
    for number, name in enumerate(("mosaic", "west", "east")):
        noise = np.random.default_rng(number).integers(-3, 4, tile.shape)
        pixels = np.tile(np.clip(tile + noise, 1, 255).astype(np.uint8), (1, 4, 4))
        paths.append(folder / f"{name}.tif")
        write_raster(paths[-1], pixels, nodata=0, options=("TILED=YES",))
    return paths
