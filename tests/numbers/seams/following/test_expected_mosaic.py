"""What a mosaic would look like cut hard: tones and sharpness are its own, losses at the seams are not in it."""
from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.following.followed_source import high_pass
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from benchmarks.scenes import cut, feather
from tests.numbers.seams.following.cuts import SHAPE, expected_of, made_sources, three_cells

LABELS = three_cells()
INNER = np.s_[12:-12, 12:-12]


@pytest.fixture(scope="module")
def sources() -> list[np.ndarray]:
    """Four images of one scene, (3, rows, columns) 8 bit."""
    return made_sources()


def grey(bands: np.ndarray) -> np.ndarray:
    return bands.mean(axis=0, dtype=np.float32)


def energy(plane: np.ndarray, where: np.ndarray) -> float:
    """Energy of fine detail."""
    return float(np.square(high_pass(plane)[where], dtype=np.float64).sum())


def test_the_hard_cut_is_expected_of_a_hard_cut(sources: list[np.ndarray]) -> None:
    mosaic = grey(cut(LABELS, sources))
    expected = expected_of(mosaic, [grey(source) for source in sources])
    assert (expected.labels == LABELS).mean() > 0.997
    rest = (expected.plane - mosaic)[INNER]
    assert np.median(np.abs(rest)) < 0.3
    assert rest.std() < 0.15 * high_pass(mosaic)[INNER].std()


@pytest.mark.parametrize("sigma", [4.0, 10.0])
def test_what_a_feather_took_is_in_what_is_expected(sources: list[np.ndarray], sigma: float) -> None:
    mosaic, hard = grey(feather(LABELS, sources, sigma)), grey(cut(LABELS, sources))
    expected = expected_of(mosaic, [grey(source) for source in sources])
    weight = ndimage.gaussian_filter((LABELS == 0).astype(float), sigma)
    band = (weight > 0.2) & (weight < 0.8)
    assert energy(mosaic, band) < 0.85 * energy(hard, band)
    assert energy(expected.plane, band) == pytest.approx(energy(hard, band), rel=0.06)
    assert (expected.labels == LABELS).mean() > 0.97


OPERATIONS = {
    "unsharp": lambda hard: 2 * hard - ndimage.gaussian_filter(hard, 1),
    "blur": lambda hard: ndimage.gaussian_filter(hard, 0.8),
    "half a pixel": lambda hard: ndimage.shift(hard, (0, 0.5), order=1, mode="nearest"),
    "gain": lambda hard: 0.6 * hard + 20,
    "dodged": lambda hard: hard * np.linspace(0.7, 1.1, SHAPE[1], dtype=np.float32),
}


@pytest.mark.parametrize("operation", OPERATIONS)
def test_what_came_over_the_whole_mosaic_is_expected(sources: list[np.ndarray], operation: str) -> None:
    hard = grey(cut(LABELS, sources))
    mosaic = OPERATIONS[operation](hard).astype(np.float32)
    expected = expected_of(mosaic, [grey(source) for source in sources])
    assert (expected.labels == LABELS).mean() > 0.98
    everywhere = np.zeros(SHAPE, bool)
    everywhere[INNER] = True
    assert energy(expected.plane, everywhere) == pytest.approx(energy(mosaic, everywhere), rel=0.04)
    rest = high_pass(expected.plane - mosaic)[INNER]
    assert rest.std() < 0.2 * high_pass(mosaic)[INNER].std()


def test_a_source_that_was_blurred_before_the_cut_has_a_filter_of_its_own(sources: list[np.ndarray]) -> None:
    soft = [source.astype(np.float32) for source in sources]
    soft[0] = ndimage.gaussian_filter(soft[0], (0, 1, 1))
    mosaic = grey(np.asarray(cut(LABELS, soft)))
    expected = expected_of(mosaic, [grey(source) for source in sources])
    for number in (0, 1, 2):
        inner = ndimage.distance_transform_edt(np.equal(LABELS, number)) > 8
        assert energy(expected.plane, inner) == pytest.approx(energy(mosaic, inner), rel=0.06), number


def test_balanced_sources_each_have_their_tone(sources: list[np.ndarray]) -> None:
    toned = [gain * grey(rgb) + bias for rgb, (gain, bias) in zip(sources, [(0.8, 30), (1.2, -25), (1.0, 5), (1, 0)])]
    mosaic = np.choose(LABELS, toned).astype(np.float32)
    expected = expected_of(mosaic, [grey(source) for source in sources])
    rest = (expected.plane - mosaic)[INNER]
    assert np.abs(np.median(rest)) < 0.3
    assert rest.std() < 0.25 * high_pass(mosaic)[INNER].std()


def test_where_no_source_explains_the_mosaic_stands_itself(sources: list[np.ndarray]) -> None:
    other = sources[2][:, ::-1, ::-1]  # of other ground, and missing
    mosaic = grey(cut(LABELS, [*sources[:2], other]))
    given = [grey(source) for source in sources[:2]]
    expected = expected_of(mosaic, given)
    unknown = expected.labels == UNKNOWN
    assert (unknown == (LABELS == 2)).mean() > 0.97
    np.testing.assert_array_equal(expected.plane[unknown], mosaic[unknown])
    np.testing.assert_array_equal(expected.unfiltered[unknown], mosaic[unknown])


def test_pixels_that_a_source_does_not_have_are_never_its(sources: list[np.ndarray]) -> None:
    planes = [grey(source) for source in sources]
    row = np.arange(SHAPE[0])[:, np.newaxis]
    valid = np.broadcast_to(row < 160, SHAPE)  # the second is cut off a little below where it ends
    planes[1] = np.where(valid, planes[1], planes[1][valid].mean())
    mosaic = grey(cut(LABELS, sources))
    expected = expected_of(mosaic, planes, valid={1: valid})
    assert not (expected.labels[~valid] == 1).any()
    assert (expected.labels == LABELS).mean() > 0.99
