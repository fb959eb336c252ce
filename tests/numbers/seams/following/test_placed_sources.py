"""Which sources a window is followed through: those that explain something of their own."""
from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.following.followed_source import follow, high_pass, like_the_mosaic

from benchmarks import aftermaths
from tests.numbers.synthetic import texture

SIDE = 384


@pytest.fixture(scope="module")
def images() -> list[np.ndarray]:
    ground = texture((SIDE, SIDE), 1.2, 1)
    return [(120 + 10 * ground + 12 * texture((SIDE, SIDE), 1.2, 2 + i)).astype(np.float32) for i in range(3)]


def feathered(images: list[np.ndarray], width: float) -> np.ndarray:
    share = np.clip((np.arange(SIDE) - SIDE / 2) / max(width, 0.1) + 0.5, 0, 1).astype(np.float32)
    return np.rint((1 - share) * images[0] + share * images[1])


def suspect(mosaic: np.ndarray, sources: list[np.ndarray]) -> int | None:
    fine = [high_pass(one.astype(np.float32)) for one in (mosaic, *sources)]
    found = follow(lambda start, stop: [one[start:stop] for one in fine], mosaic.shape, len(sources))
    return like_the_mosaic(fine, found.followed)


@pytest.mark.parametrize("width", [0, 33, 100])
@pytest.mark.parametrize("place", [0, 1, 2])
def test_a_copy_of_the_mosaic_is_told_wherever_it_stands(images: list[np.ndarray], width: float, place: int) -> None:
    mosaic, sources = feathered(images, width), images[:2]
    sources = [*sources[:place], mosaic, *sources[place:]]
    assert suspect(mosaic, sources) == place


@pytest.mark.parametrize("place", [0, 1, 2])
@pytest.mark.parametrize("part", [np.s_[:, SIDE // 2 - 90 :], np.s_[60:300, 120:300], np.s_[: SIDE // 2]])
def test_a_part_of_the_mosaic_is_told_and_no_true_source_instead(
    images: list[np.ndarray], part: tuple[slice, ...], place: int
) -> None:
    """A tile of it, or an older edition that is another image elsewhere, hides the seam where it lies."""
    mosaic, (first, second, other) = feathered(images, 33), images
    for elsewhere in (np.zeros_like(other), other):
        tile = elsewhere.copy()
        tile[part] = mosaic[part]
        sources = [first, second]
        sources.insert(place, tile)
        assert suspect(mosaic, sources) == place


def test_what_is_there_twice_and_spans_no_seam_stays(images: list[np.ndarray]) -> None:
    mosaic, (first, second, _) = feathered(images, 33), images
    assert suspect(mosaic, [first, second, first.copy()]) is None


@pytest.mark.parametrize("width", [33, 100])
def test_a_compressed_copy_is_told_where_it_would_hide_a_feather(images: list[np.ndarray], width: float) -> None:
    mosaic = feathered(images, width)
    copy = aftermaths.jpeg(90)(np.stack([mosaic] * 3).astype(np.uint8), np.random.default_rng(1))[0]
    assert suspect(mosaic, [*images[:2], copy.astype(np.float32)]) in (2, None)


@pytest.mark.parametrize("width", [0, 33, 100])
def test_orthoimages_are_none_however_alike(images: list[np.ndarray], width: float) -> None:
    alike = [0.85 * images[0] + 0.15 * one for one in images]
    for sources in (images, alike):
        assert suspect(feathered(sources, width), sources) is None
        soft = ndimage.gaussian_filter(feathered(sources, width), 0.5)
        assert suspect(soft, sources) is None


def test_nothing_is_told_of_nothing(images: list[np.ndarray]) -> None:
    assert like_the_mosaic([high_pass(one) for one in images], ()) is None
