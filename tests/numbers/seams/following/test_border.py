"""The border between two sources, from where it is known nearly to the pixel."""
from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.following.border import BORDER_PX, to_the_pixel

from tests.numbers.synthetic import texture

SHAPE = (150, 170)


@pytest.fixture(scope="module")
def planes() -> dict[int, np.ndarray]:
    """Three images of one scene, (rows, columns) float32."""
    scene = 120 + 20 * texture((160, 170), 2.5, 9)[:150]
    return {i: (scene + 8 * texture((160, 170), 0.8, i)[:150]).astype(np.float32) for i in (0, 1, 4)}


def crooked() -> np.ndarray:
    row, column = np.mgrid[: SHAPE[0], : SHAPE[1]]
    labels = np.where(column < 80 + 12 * np.sin(row / 9), 0, np.where(row < 70 + column / 10, 1, 4))
    return labels.astype(np.uint8)


def cut(planes: dict[int, np.ndarray], labels: np.ndarray) -> np.ndarray:
    mosaic = np.zeros(SHAPE, np.float32)
    for i, plane in planes.items():
        mosaic[labels == i] = plane[labels == i]
    return mosaic


@pytest.mark.parametrize("off", [(0, 0), (0, 3), (3, -2), (-4, 0)])
def test_a_border_that_is_some_pixels_off_is_put_right(planes: dict[int, np.ndarray], off: tuple[int, int]) -> None:
    labels = crooked()
    rough = ndimage.shift(labels, off, order=0, mode="nearest")
    found = to_the_pixel(cut(planes, labels), planes, rough, {})
    assert found.dtype == np.uint8
    assert np.mean(found != labels) < max(0.3 * np.mean(rough != labels), 0.006)


def test_away_from_the_border_nothing_is_moved(planes: dict[int, np.ndarray]) -> None:
    labels = crooked()
    stranger = planes[1][::-1].copy()
    found = to_the_pixel(stranger, planes, labels, {})
    side = 2 * BORDER_PX + 1
    far = ndimage.minimum_filter(labels, side) == ndimage.maximum_filter(labels, side)
    np.testing.assert_array_equal(found[far], labels[far])
    assert (found[~far] != labels[~far]).any()


def test_tones_that_are_off_beside_it_do_not_move_it(planes: dict[int, np.ndarray]) -> None:
    labels = crooked()
    off = {i: plane + tone for (i, plane), tone in zip(planes.items(), (0, 5, -4))}
    rough = ndimage.shift(labels, (2, -2), order=0, mode="nearest")
    found = to_the_pixel(cut(planes, labels), off, rough, {})
    assert np.mean(found != labels) < 0.01


def test_a_source_gets_no_pixel_that_it_does_not_have(planes: dict[int, np.ndarray]) -> None:
    labels = crooked()
    valid = ndimage.binary_erosion(labels == 1, iterations=2)
    rough = np.where((labels == 1) & ~valid, 0, labels).astype(np.uint8)
    found = to_the_pixel(cut(planes, labels), planes, rough, {1: valid})
    assert not ((found == 1) & ~valid).any()
