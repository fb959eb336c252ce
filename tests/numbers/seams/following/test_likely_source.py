"""The exact border between sources in a mosaic, and where none of them explains it."""
from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.following.followed_source import follow_planes, high_pass
from seam_inspector.plugin.seams.measure.following.likely_source import FineDetail, LikelySource, likely_source

from tests.numbers.synthetic import texture

SHAPE = (256, 256)
BORDER = 120


def plane(contrast: float, seed: int) -> np.ndarray:
    """(rows, columns) float32: a scene that all show, and fine detail of its own."""
    return (120 + 20 * texture(SHAPE, 3.0, 50) + contrast * texture(SHAPE, 0.8, seed)).astype(np.float32)


def found_in(
    mosaic: np.ndarray, planes: list[np.ndarray], valid: Mapping[int, np.ndarray] | None = None
) -> LikelySource:
    fine = [high_pass(plane) for plane in (mosaic, *planes)]
    rough = follow_planes(fine)
    sources = {i: fine[1 + i] for i in range(len(planes)) if i in rough.followed}
    detail = FineDetail(fine[0], sources, valid or {})
    return likely_source(detail, rough.labels, rough.clear)


def cut_at(border: int, first: np.ndarray, second: np.ndarray) -> np.ndarray:
    return np.where(np.arange(SHAPE[1]) < border, first, second)


def borders(likely: LikelySource) -> np.ndarray:
    """Column of each row where the first source ends."""
    return np.asarray((likely.labels == 0).sum(axis=1))


@pytest.mark.parametrize(("west", "east"), [(6.0, 6.0), (12.0, 4.0), (4.0, 12.0), (20.0, 4.0)])
def test_the_border_leans_towards_neither_the_weak_nor_the_strong(west: float, east: float) -> None:
    first, second = plane(west, 1), plane(east, 2)
    columns = borders(found_in(cut_at(BORDER, first, second), [first, second]))
    assert np.median(columns) == pytest.approx(BORDER, abs=2)
    assert np.mean(columns) == pytest.approx(BORDER, abs=1.5)
    assert np.std(columns) < 3


@pytest.mark.parametrize("change", ["gain", "noise", "unsharp", "blur"])
def test_the_border_stays_whatever_came_over_the_mosaic(change: str) -> None:
    first, second = plane(12, 1), plane(5, 2)
    mosaic = cut_at(BORDER, first, second)
    smooth = ndimage.gaussian_filter(mosaic, 0.7)
    changed = {
        "gain": 0.6 * mosaic + 20, "noise": mosaic + np.random.default_rng(3).normal(0, 2, SHAPE),
        "unsharp": 2 * mosaic - smooth, "blur": smooth,
    }[change].astype(np.float32)
    columns = borders(found_in(changed, [first, second]))
    assert np.mean(columns) == pytest.approx(BORDER, abs=2)


@pytest.mark.parametrize("width", [16, 40])
def test_in_a_feather_the_border_is_where_both_weigh_the_same(width: int) -> None:
    first, second = plane(8, 1), plane(8, 2)
    weight = np.clip((np.arange(SHAPE[1]) + 0.5 - BORDER) / width + 0.5, 0, 1)
    columns = borders(found_in(((1 - weight) * first + weight * second).astype(np.float32), [first, second]))
    assert np.mean(columns) == pytest.approx(BORDER, abs=2)


@pytest.mark.parametrize("side", [64, 120])
def test_a_part_from_no_given_source_is_found(side: int) -> None:
    first, second, missing = plane(9, 1), plane(9, 2), plane(9, 3)
    gap = np.s_[40 : 40 + side, 100 : 100 + side]
    mosaic = cut_at(BORDER, first, second)
    mosaic[gap] = missing[gap]
    unexplained = found_in(mosaic, [first, second]).unexplained
    inside = np.zeros(SHAPE, bool)
    inside[gap] = True
    assert unexplained[ndimage.binary_erosion(inside, iterations=7)].mean() > 0.97  # cells of 8 px
    assert unexplained[~inside].mean() < 0.025  # told by squares of 36 px
    assert unexplained.mean() == pytest.approx(inside.mean(), rel=0.35 if side == 64 else 0.2)


@pytest.mark.parametrize("alike", [0.2, 0.4])
@pytest.mark.parametrize("share", [0.3, 0.5, 0.7])
def test_a_missing_source_is_found_though_its_detail_is_like_that_of_one_given(alike: float, share: float) -> None:
    """Orthoimages of one ground have fine detail in common, and the missing one may well hold most of the window."""
    common = texture(SHAPE, 0.8, 60)
    first, missing = (
        (plane(0, 1) + 9 * (alike**0.5 * common + (1 - alike) ** 0.5 * texture(SHAPE, 0.8, seed))).astype(np.float32)
        for seed in (1, 3)
    )
    border = round((1 - share) * SHAPE[1])
    unexplained = found_in(cut_at(border, first, missing), [first]).unexplained
    assert unexplained[:, border + 10 : -10].mean() > 0.9
    assert unexplained[:, 10 : border - 10].mean() < 0.05


def alike_planes(alike: float) -> list[np.ndarray]:
    """Three images of one ground, as of one satellite's triplet: that much of their fine detail is the same."""
    common = texture(SHAPE, 0.8, 60)
    return [
        (plane(0, 1) + 9 * (alike**0.5 * common + (1 - alike) ** 0.5 * texture(SHAPE, 0.8, seed))).astype(np.float32)
        for seed in (1, 2, 3)
    ]


@pytest.mark.parametrize("noise", [0.0, 1.0])
@pytest.mark.parametrize("alike", [0.8, 0.9])
def test_a_missing_image_of_a_triplet_is_not_taken_for_its_neighbours(alike: float, noise: float) -> None:
    """What is left over is compared with other ground: 0.2 to 0.35 where true sources leave 0.001 to 0.05."""
    first, second, missing = alike_planes(alike)
    mosaic = cut_at(80, first, second)
    mosaic[:, 170:] = missing[:, 170:]
    mosaic += np.float32(noise) * np.random.default_rng(4).standard_normal(SHAPE, np.float32)
    unexplained = found_in(mosaic, [first, second]).unexplained
    assert unexplained[:, 180:-8].mean() > 0.9
    assert unexplained[:, :160].mean() < 0.02


def test_a_source_that_was_resampled_leaves_more_over_than_others() -> None:
    """It leaves as much everywhere, so it is none that is missing."""
    first, second, resampled = alike_planes(0.985)
    assert found_in(cut_at(BORDER, first, resampled), [first, second]).unexplained.mean() < 0.01


@pytest.mark.parametrize("width", [1, 33, 120])
def test_images_of_a_triplet_that_are_all_given_explain_their_mosaic(width: int) -> None:
    first, second, _ = alike_planes(0.85)
    weight = np.clip((np.arange(SHAPE[1]) - BORDER) / width + 0.5, 0, 1)
    mosaic = ((1 - weight) * first + weight * second).astype(np.float32)
    mosaic += np.random.default_rng(4).standard_normal(SHAPE, np.float32)
    assert found_in(mosaic, [first, second]).unexplained.mean() < 0.01


def test_a_mosaic_that_is_wholly_of_another_image_of_a_triplet_is_not_explained() -> None:
    """There is no better ground to compare with; but no noise leaves the same share over of weak and strong detail."""
    first, second, missing = (plane.copy() for plane in alike_planes(0.7))
    fields = np.linspace(0.4, 1.6, SHAPE[0], dtype=np.float32)[:, np.newaxis]
    planes = [120 + fields * (plane - 120) for plane in (first, second, missing)]
    assert found_in(planes[2], planes[:2]).unexplained.mean() > 0.9


def test_a_source_that_is_given_and_nowhere_to_be_seen_explains_nothing() -> None:
    likely = found_in(plane(9, 3), [plane(9, 1)])
    assert likely.unexplained.mean() > 0.98


@pytest.mark.parametrize("step", [8, 24, 60])
@pytest.mark.parametrize("contrast", [1.5, 4.0])
def test_a_step_of_tones_is_no_source_that_is_missing(step: float, contrast: float) -> None:
    """Pixels of two images as they are, one of them lighter: the edge between them outweighs weak texture."""
    first, second = (np.rint(plane(contrast, seed)) for seed in (1, 2))
    seam = BORDER + 20 * np.abs((np.arange(SHAPE[0]) / 24) % 2 - 1)  # a zigzag
    mosaic = np.where(np.arange(SHAPE[1]) < seam[:, np.newaxis], first, second + np.float32(step)).astype(np.float32)
    assert not found_in(mosaic, [first, second]).unexplained.any()


def test_ground_without_texture_is_not_unexplained() -> None:
    first, second = plane(9, 1), plane(9, 2)
    for image in (first, second):
        image[:100, :100] = 90
    assert not found_in(cut_at(BORDER, first, second), [first, second]).unexplained.any()


def test_a_source_is_followed_only_where_it_has_pixels() -> None:
    first, second = plane(9, 1), plane(9, 2)
    valid = np.broadcast_to(np.arange(SHAPE[1]) >= 90, SHAPE)
    mosaic = cut_at(BORDER, first, second)
    likely = found_in(mosaic, [first, np.where(valid, second, second[valid].mean())], {1: valid})
    assert not (likely.labels[~valid] == 1).any()
    assert np.mean(borders(likely)) == pytest.approx(BORDER, abs=2)
    assert not likely.unexplained.any()


@pytest.mark.parametrize("change", ["feather", "noise", "blur", "gain"])
def test_what_was_spoilt_is_still_explained(change: str) -> None:
    first, second = plane(9, 1), plane(9, 2)
    weight = np.clip((np.arange(SHAPE[1]) - BORDER) / 60 + 0.5, 0, 1)
    mosaic = cut_at(BORDER, first, second)
    changed = {
        "feather": (1 - weight) * first + weight * second, "gain": 0.5 * mosaic + 30,
        "noise": mosaic + np.random.default_rng(3).normal(0, 5, SHAPE), "blur": ndimage.gaussian_filter(mosaic, 0.9),
    }[change].astype(np.float32)
    assert found_in(changed, [first, second]).unexplained.mean() < 0.01
