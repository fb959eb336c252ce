"""Sources of one scene and the cells that they are cut to."""
from __future__ import annotations

import numpy as np
from scipy import ndimage

from tests.numbers.synthetic import orthoimage

SHAPE = (320, 384)


def made_sources() -> list[np.ndarray]:
    """Four images, each with its own noise, tone and place, (3, rows, columns) 8 bit."""
    scene = orthoimage((SHAPE[0] + 8, SHAPE[1] + 8)).astype(np.float32)
    rng = np.random.default_rng(5)
    images = []
    for number, (gain, bias) in enumerate([(1.0, 0.0), (0.95, 8.0), (1.04, -6.0), (0.9, 4.0)]):
        placed = ndimage.shift(scene, (0, 0.8 * number, -0.6 * number), order=3)[:, 4:-4, 4:-4]
        noisy = gain * placed + bias + rng.normal(0, 4, placed.shape)
        images.append(np.clip(np.rint(noisy), 0, 255).astype(np.uint8))
    return images


def three_cells() -> np.ndarray:
    """Labels with a crooked border."""
    row, column = np.mgrid[: SHAPE[0], : SHAPE[1]]
    border = 150 + 30 * np.sin(row / 25)
    return np.where(column < border, 0, np.where(row < 140 + 10 * np.cos(column / 17), 1, 2)).astype(np.uint8)
