"""Traces of JPEG: fine waves vanish in the squares of one grid."""
from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.following.compression import was_compressed

from benchmarks.aftermaths import jpeg
from tests.numbers.synthetic import texture

SIDE = 512


def image(seed: int) -> np.ndarray:
    return np.asarray(128 + 30 * texture((SIDE, SIDE), 1.6, seed), np.float32)


def compressed(plane: np.ndarray, quality: int, off: tuple[int, int] = (0, 0)) -> np.ndarray:
    """Grey values through JPEG, its squares moved by ``off``."""
    placed = np.roll(plane, off, axis=(0, 1)).round().clip(0, 255).astype(np.uint8)
    bands = jpeg(quality)(np.stack([placed] * 3), np.random.default_rng(0))
    return np.roll(bands[0], (-off[0], -off[1]), axis=(0, 1)).astype(np.float32)


@pytest.mark.parametrize("quality", [60, 75, 85, 90, 95])
@pytest.mark.parametrize("off", [(0, 0), (3, 5)])
def test_jpeg_is_told_on_any_grid(quality: int, off: tuple[int, int]) -> None:
    assert was_compressed(compressed(image(1), quality, off))


@pytest.mark.parametrize(
    "change",
    [
        lambda plane: plane,
        lambda plane: plane + np.random.default_rng(1).normal(0, 4, plane.shape),
        lambda plane: ndimage.gaussian_filter(plane, 0.8),
        lambda plane: plane + 1.5 * (plane - ndimage.gaussian_filter(plane, 1.0)),
        lambda plane: np.full_like(plane, 90),
        lambda plane: plane[:12, :12],
    ],
    ids=["as it was", "noise", "blurred", "sharpened", "even", "tiny"],
)
def test_nothing_else_is_taken_for_it(change: object) -> None:
    assert not was_compressed(np.rint(change(image(2))))  # type: ignore[operator]


def test_an_image_that_was_resampled_from_a_jpeg_shows_none() -> None:
    moved = ndimage.shift(compressed(image(3), 75), (0.4, 0.3), order=3, mode="nearest")
    assert not was_compressed(np.rint(moved))
