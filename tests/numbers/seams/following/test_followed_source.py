"""The source that a mosaic follows and where it mixes two, by a first estimate, on mosaics made from known cuts."""
from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.following.followed_source import FollowedSource, follow_planes, high_pass
from seam_inspector.plugin.seams.measure.following.likely_source import MIN_FIT
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from benchmarks.scenes import cut, feather
from tests.numbers.seams.following.cuts import SHAPE, made_sources, three_cells
from tests.numbers.synthetic import orthoimage

MOST_MIXED = 0.005  # of the pixels of a hard cut, whose borders are not quite sure


@pytest.fixture(scope="module")
def sources() -> list[np.ndarray]:
    """Four images of one scene, each with its own noise, tone and place, (3, rows, columns) 8 bit."""
    return made_sources()


@pytest.fixture(scope="module")
def labels() -> np.ndarray:
    """Three cells; the fourth source is not used."""
    return three_cells()


def followed(mosaic: np.ndarray, sources: Sequence[np.ndarray]) -> FollowedSource:
    planes = [bands.mean(axis=0, dtype=np.float32) for bands in (mosaic, *sources)]
    return follow_planes([high_pass(plane) for plane in planes])


def right(result: FollowedSource, labels: np.ndarray) -> float:
    return float((result.labels == labels).mean())


def test_of_sources_that_are_the_same_neither_is_followed_for_sure_but_where_there_is_nothing_to_see() -> None:
    detail = orthoimage(SHAPE).mean(axis=0, dtype=np.float32)
    detail[:, : SHAPE[1] // 2] = 120
    fine = high_pass(detail)
    clear = follow_planes([fine, fine, fine]).clear
    assert clear[:, : SHAPE[1] // 2 - 32].all()
    assert not clear[:, SHAPE[1] // 2 + 32 :].any()


@pytest.mark.parametrize("rows", [7, 128, 131, 300])
def test_a_high_band_is_high_passed_as_a_whole(rows: int) -> None:
    band = np.random.default_rng(rows).integers(0, 256, (rows, 40)).astype(np.uint8)
    smooth = band.astype(np.float64)
    for kernel in ([1, 2, 1], [1, 0, 2, 0, 1]):
        for axis in (0, 1):
            smooth = ndimage.correlate1d(smooth, np.array(kernel) / 4, axis, mode="nearest")
    np.testing.assert_allclose(high_pass(band), band - smooth, atol=1e-4)


def test_a_hard_cut_is_found(sources: list[np.ndarray], labels: np.ndarray) -> None:
    result = followed(cut(labels, sources), sources)
    assert right(result, labels) >= 0.99
    assert result.followed == (0, 2, 1)
    assert result.unclear_share < 0.03
    assert result.mixed_share < MOST_MIXED
    assert result.fit > 0.98
    assert not result.unexplained.any()


@pytest.mark.parametrize("sigma", [6.7, 13.3])
def test_a_feather_is_found_as_a_mixture(sources: list[np.ndarray], labels: np.ndarray, sigma: float) -> None:
    result = followed(feather(labels, sources, sigma), sources)
    inner = ndimage.gaussian_filter((labels == 0).astype(np.float32), sigma)
    zone = (inner > 0.2) & (inner < 0.8)
    assert right(result, labels) >= 0.97
    assert result.mixed_share > 0.5 * float(zone.mean())
    assert result.clear[zone].mean() < 0.3


def test_a_blurred_mosaic_follows_areas_and_no_specks(sources: list[np.ndarray], labels: np.ndarray) -> None:
    blurred = ndimage.gaussian_filter(cut(labels, sources).astype(np.float32), (0, 2, 2))
    result = followed(blurred, sources)
    cells = result.labels[::4, ::4]  # what is followed is told for squares of 4 px
    alone = [ndimage.uniform_filter((cells == i).astype(float), 3)[cells == i] < 1.5 / 9 for i in range(len(sources))]
    assert sum(map(np.count_nonzero, alone)) == 0  # none that is like no neighbour
    assert right(result, labels) > 0.95


def test_a_stranger_is_not_explained(sources: list[np.ndarray]) -> None:
    stranger = orthoimage(SHAPE, seed=99)[:, ::-1]
    result = followed(stranger, sources)
    assert result.fit < MIN_FIT
    assert result.unexplained.mean() > 0.95


def test_sources_that_show_the_same_are_not_mixed() -> None:
    rng = np.random.default_rng(4)
    scene = orthoimage(SHAPE).astype(np.float32)
    mosaic, first, second = (scene + rng.normal(0, 1.5, scene.shape) for _ in range(3))
    result = followed(mosaic, [first, second])  # either alone explains what both together do
    assert result.fit > 0.9
    assert result.mixed_share == 0
    assert 0.3 < result.shares[0] < 0.7


def test_known_labels_decide_what_is_followed_and_where_sources_are_mixed(
    sources: list[np.ndarray], labels: np.ndarray
) -> None:
    """Here what is no seam looks like a mixture, as resampled images may, and nothing of it is clear."""
    result = followed(feather(labels, sources, 6.7), sources)
    mixed, clear = result.mixed.copy(), result.clear.copy()
    away = np.s_[200:260, 20:60]  # from all borders
    mixed[away], clear[away] = True, False
    result = dataclasses.replace(result, mixed=mixed, clear=clear)
    known = labels.copy()
    known[:, :10] = UNKNOWN
    with_known = result.with_known(known)
    np.testing.assert_array_equal(with_known.labels[:, 10:], labels[:, 10:])
    np.testing.assert_array_equal(with_known.labels[:, :10], result.labels[:, :10])
    assert not with_known.mixed[away].any()
    assert with_known.clear[away].all()
    inner = ndimage.gaussian_filter((labels == 0).astype(np.float32), 6.7)
    along_seam = (inner > 0.35) & (inner < 0.65)
    assert with_known.mixed[along_seam].mean() > 0.5
    assert not (with_known.mixed & with_known.clear)[:, 10:].any()
    assert with_known.unclear_share < result.unclear_share
    assert sum(with_known.shares) == pytest.approx(1)
