"""What no given source explains, in compressed mosaics: parts of another image, and none that a codec made."""
from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from seam_inspector.plugin.seams.measure.following.followed_source import follow_planes, high_pass
from seam_inspector.plugin.seams.measure.following.foreign_ground import foreign_patches
from seam_inspector.plugin.seams.measure.following.likely_source import FineDetail, likely_source

from benchmarks.aftermaths import jpeg
from tests.numbers.synthetic import texture

SHAPE = (512, 512)
COLUMNS = np.arange(SHAPE[1])
Stored = Callable[[np.ndarray], np.ndarray]


def stored(quality: int) -> Stored:
    """Through JPEG; 0: as it was."""
    if not quality:
        return lambda plane: np.rint(plane)
    return lambda plane: jpeg(quality)(np.stack([plane.round().clip(0, 255).astype(np.uint8)] * 3),
                                       np.random.default_rng(0))[0].astype(np.float32)


def image(seed: int, common: float = 0.5) -> np.ndarray:
    """An image of one ground: a part of the finest detail is each image's own."""
    ground, detail = texture(SHAPE, 1.2, 1), texture(SHAPE, 1.2, 10 + seed)
    return np.asarray(120 + 18 * (np.sqrt(common) * ground + np.sqrt(1 - common) * detail), np.float32)


def unexplained(mosaic: np.ndarray, sources: list[np.ndarray]) -> np.ndarray:
    fine = [high_pass(plane) for plane in (mosaic, *sources)]
    first = follow_planes(fine)
    given = {i: fine[1 + i] for i in range(len(sources)) if i in first.followed}
    detail = FineDetail(fine[0], given, is_compressed=lambda number: number is None or number in given)
    return likely_source(detail, first.labels, first.clear).unexplained


def cut(*parts: np.ndarray) -> np.ndarray:
    """Strips of equal width."""
    return np.choose(np.broadcast_to(COLUMNS * len(parts) // SHAPE[1], SHAPE), parts)


@pytest.mark.parametrize("of_mosaic", [60, 75, 85, 95])
@pytest.mark.parametrize("way", ["lossless", "before", "since", "one"])
def test_a_codec_makes_nothing_foreign(of_mosaic: int, way: str) -> None:
    through, sources = stored(of_mosaic), [image(1), image(2)]
    if way in ("before", "one"):
        sources = [through(sources[0]), sources[1] if way == "one" else through(sources[1])]
    mosaic = through(cut(*sources))
    given = [through(source) for source in sources] if way == "since" else sources
    assert unexplained(mosaic, given).mean() < 0.01


@pytest.mark.parametrize("of_mosaic", [75, 85, 90])
def test_smooth_ground_of_a_source_that_is_textured_elsewhere_is_not_foreign(of_mosaic: int) -> None:
    """No other ground of that source tells how much noise leaves over of weak detail."""
    contrast = np.ones(SHAPE, np.float32)
    contrast[180:330, 300:460] = 0.15
    planes = [120 + contrast * (image(seed) - 120) for seed in (1, 2)]
    assert unexplained(stored(of_mosaic)(cut(*planes)), planes).mean() < 0.01


@pytest.mark.parametrize("of_mosaic", [0, 75, 90])
@pytest.mark.parametrize("of_sources", [0, 75])
@pytest.mark.parametrize("common", [0.2, 0.6])
def test_a_part_of_an_image_that_is_not_given_is_foreign(of_mosaic: int, of_sources: int, common: float) -> None:
    images = [stored(of_sources)(image(seed, common)) for seed in (1, 2, 3)]
    mosaic = stored(of_mosaic)(cut(images[0], images[1], images[1], images[2]))
    foreign = unexplained(mosaic, images[:2])
    assert foreign[:, 400:].mean() > 0.7
    assert foreign[:, :370].mean() < 0.03


@pytest.mark.parametrize("of_mosaic", [75, 90])
def test_an_image_that_resembles_the_given_one_is_told_where_there_is_much_of_it(of_mosaic: int) -> None:
    first, other = image(1, 0.9), image(2, 0.9)
    foreign = unexplained(stored(of_mosaic)(cut(first, first, other)), [first])
    assert foreign[:, 370:].mean() > 0.7
    assert foreign[:, :310].mean() < 0.03


@pytest.mark.parametrize("common", [0.2, 0.65])
def test_a_source_of_which_all_is_foreign_is_told_where_others_are_true(common: float) -> None:
    images = [image(seed, common) for seed in (1, 2, 3)]
    foreign = unexplained(stored(75)(cut(images[0], images[2])), images[:2])
    assert foreign[:, 270:].mean() > 0.7
    assert foreign[:, :240].mean() < 0.03


def test_a_feather_of_given_images_is_not_foreign() -> None:
    first, second = image(1), image(2)
    share = np.clip((COLUMNS - 256) / 150 + 0.5, 0, 1)
    assert unexplained(stored(75)((1 - share) * first + share * second), [first, second]).mean() < 0.02


def test_patches_are_judged_by_the_noise_of_their_own_source() -> None:
    rng = np.random.default_rng(3)
    energy = np.exp(rng.normal(4, 0.7, (20, 20)))
    labels = np.zeros((20, 20), np.uint8)
    labels[:, 10:] = 1
    left_over = energy * np.where(labels == 0, 0.05, 0.3) * np.exp(rng.normal(0, 0.1, energy.shape))
    foreign, _ = foreign_patches(energy, left_over, labels, lambda number: True)
    assert not foreign.any()
    left_over[5:8, 2:6] = 0.85 * energy[5:8, 2:6]
    foreign, _ = foreign_patches(energy, left_over, labels, lambda number: True)
    assert foreign[5:8, 2:6].mean() > 0.9
    foreign[5:8, 2:6] = False
    assert not foreign.any()
    assert not np.any(foreign_patches(np.zeros((4, 4)), np.zeros((4, 4)), np.zeros((4, 4), np.uint8), lambda _: True))
