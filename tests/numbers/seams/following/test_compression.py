"""Sources that lie in the squares of the mosaic's JPEG already are told from those that it rounded anew."""
from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from seam_inspector.plugin.seams.measure.following.compression import compressed_alike
from seam_inspector.plugin.seams.measure.following.followed_source import high_pass
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from benchmarks.aftermaths import jpeg
from tests.numbers.synthetic import texture

SIDE = 512
OFF = (3, 5)
"""Rows and columns by which the squares of the second image lie elsewhere."""


def compressed(plane: np.ndarray, quality: int, off: tuple[int, int] = (0, 0)) -> np.ndarray:
    """Grey values through JPEG, its squares moved by ``off``."""
    placed = np.roll(plane, off, axis=(0, 1)).round().clip(0, 255).astype(np.uint8)
    bands = jpeg(quality)(np.stack([placed] * 3), np.random.default_rng(0))
    return np.roll(bands[0], (-off[0], -off[1]), axis=(0, 1)).astype(np.float32)


def image(seed: int) -> np.ndarray:
    return np.asarray(128 + 30 * texture((SIDE, SIDE), 2.4, seed), np.float32)


def halves() -> np.ndarray:
    return np.repeat(np.arange(2, dtype=np.uint8), SIDE // 2)[np.newaxis].repeat(SIDE, axis=0)


def are_alike(mosaic: np.ndarray, first: np.ndarray, second: np.ndarray, labels: np.ndarray) -> bool:
    return not (compressed_alike(high_pass(mosaic), {0: high_pass(first), 1: high_pass(second)}, labels))


@pytest.mark.parametrize("quality", [60, 75, 85])
def test_what_lay_in_other_squares_is_compressed_alike(quality: int) -> None:
    labels = halves()
    first, second = compressed(image(1), quality), compressed(image(2), quality, OFF)
    mosaic = compressed(np.where(labels == 0, first, second), quality)
    assert not are_alike(mosaic, first, second, labels)
    # That is what makes the difference: one comes out as it was, the other does not.
    left = np.square(mosaic - np.where(labels == 0, first, second))
    assert left[:, : SIDE // 2 - 8].mean() < 0.1 * left[:, SIDE // 2 + 8 :].mean()
    unknown = np.where(np.arange(SIDE) < 40, np.uint8(UNKNOWN), labels)
    assert not are_alike(mosaic, first, second, unknown)


def test_what_was_not_compressed_before_is_compressed_alike() -> None:
    labels = halves()
    first, second = compressed(image(1), 75), image(2)
    assert not are_alike(compressed(np.where(labels == 0, first, second), 75), first, second, labels)


@pytest.mark.parametrize(
    "toned",
    [lambda plane: 0.8 * plane + 10, lambda plane: 255 * (plane / 255).clip(0) ** 1.4],
    ids=["gain", "gamma"],
)
def test_what_was_brought_to_other_tones_is_compressed_anew(toned: Callable[[np.ndarray], np.ndarray]) -> None:
    """Though it lies in its own squares, and the other one came out as it was."""
    labels = halves()
    first, second = (compressed(image(seed), 75) for seed in (1, 2))
    mosaic = compressed(np.where(labels == 0, first, toned(second).round()), 75)
    found = compressed_alike(high_pass(mosaic), {0: high_pass(first), 1: high_pass(second)}, labels)
    assert set(found) >= {frozenset({0}), frozenset({1})}


def test_another_image_is_not_taken_for_one_that_was_compressed_anew() -> None:
    labels = halves()
    first, second, other = (compressed(image(seed), 75) for seed in (1, 2, 3))
    mosaic = compressed(np.where(labels == 0, first, second), 75)
    assert are_alike(mosaic, first, (second + other) / 2, labels)


def test_one_that_alone_was_compressed_leaves_over_what_the_others_do_not() -> None:
    labels = halves()
    mosaic = np.where(labels == 0, image(1), compressed(image(2), 75))
    assert not are_alike(mosaic, image(1), image(2), labels)


@pytest.mark.parametrize("off", [(0, 0), OFF])
def test_where_all_or_none_are_nothing_differs(off: tuple[int, int]) -> None:
    labels = halves()
    first, second = (compressed(image(seed), 75, off) for seed in (1, 2))
    assert are_alike(compressed(np.where(labels == 0, first, second), 75), first, second, labels)


def test_a_mosaic_that_is_not_compressed_rounds_nothing() -> None:
    """Though its sources were, each in squares of its own."""
    labels = halves()
    first, second = compressed(image(1), 75), compressed(image(2), 75, OFF)
    assert are_alike(np.where(labels == 0, first, second), first, second, labels)
    plain = image(1), image(2)
    assert are_alike(np.where(labels == 0, *plain), *plain, labels)


def test_a_long_edge_of_the_ground_is_no_square_of_jpeg() -> None:
    labels = halves()
    first, second = image(1), image(2)
    for plane in (first, second):
        plane[:, 80:] += 60
        plane[200:] += 60
    assert are_alike(np.where(labels == 0, first, second), first, second, labels)
