"""Sources of one scene and the cells that they are cut to."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from unittest.mock import Mock

import numpy as np
from scipy import ndimage
from seam_inspector.plugin.imagery.rasters import Raster
from seam_inspector.plugin.seams.measure.compared_image import ComparedImage
from seam_inspector.plugin.seams.measure.following.expected_mosaic import ExpectedMosaic, expected_mosaic
from seam_inspector.plugin.seams.measure.following.placed_sources import follow_given

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


def expected_of(
    mosaic: np.ndarray,
    planes: Sequence[np.ndarray],
    valid: Mapping[int, np.ndarray] | None = None,
    known: np.ndarray | None = None,
) -> ExpectedMosaic:
    """The hard cut of planes (rows, columns) float32 that lie where the mosaic does."""
    masks = valid or {}
    image, *images = (
        ComparedImage(plane[np.newaxis], ("judged",), {}, {}, Mock(Raster), valid=masks.get(i), judged=plane)
        for i, plane in enumerate((mosaic, *planes), -1)
    )
    return expected_mosaic(follow_given(image, images).with_known(known))
