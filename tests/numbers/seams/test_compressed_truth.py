"""Which missing orthoimages the benchmark of compressed deliveries counts: those that show what no given one does."""
from __future__ import annotations

import numpy as np
import pytest

from benchmarks.compressed import shows_missing
from tests.numbers.synthetic import texture

SHAPE = (192, 192)
PART = np.zeros(SHAPE, bool)
PART[:, 96:] = True


def bands(plane: np.ndarray) -> np.ndarray:
    return np.stack([plane.round().clip(0, 255)] * 3).astype(np.uint8)


def ground(seed: int, contrast: float = 12.0) -> np.ndarray:
    return np.asarray(120 + contrast * texture(SHAPE, 1.2, seed))


def test_ground_of_its_own_counts() -> None:
    missing = bands(ground(1))
    assert shows_missing(missing, [bands(ground(2)), bands(ground(3))], missing, PART)


@pytest.mark.parametrize("shift", [(0, 0), (2, -3)])
def test_what_a_given_image_shows_as_well_does_not_count(shift: tuple[int, int]) -> None:
    missing = bands(ground(1))
    given = np.roll(missing, shift, (1, 2))
    assert not shows_missing(missing, [bands(ground(2)), given], missing, PART)


def test_what_has_no_texture_or_less_than_a_codec_leaves_over_does_not_count() -> None:
    flat = bands(ground(1, 0.5))
    assert not shows_missing(flat, [bands(ground(2))], flat, PART)
    missing, coded = ground(1, 4.0), ground(1, 4.0) + ground(4, 6.0) - 120
    assert not shows_missing(bands(coded), [bands(ground(2))], bands(missing), PART)
