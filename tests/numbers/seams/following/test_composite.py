"""The hard-cut composite: each pixel from the source that its label names, as it is and in the mosaic's tones."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.seams.measure.following.followed_source import FollowedSource, follow_planes, high_pass
from seam_inspector.plugin.seams.measure.judgement.hard_cut import follows_at, make_composite
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN
from seam_inspector.plugin.seams.measure.tone import Tone

from benchmarks.scenes import cut
from tests.numbers.seams.following.cuts import made_sources, three_cells

NAMES = ("red", "green", "blue")
LABELS = three_cells()
AS_THEY_ARE: list[dict[str, Tone | None]] = [{}] * 4


@pytest.fixture(scope="module")
def sources() -> list[np.ndarray]:
    """Four images of one scene, (3, rows, columns) 8 bit."""
    return made_sources()


@pytest.fixture(scope="module")
def followed(sources: list[np.ndarray]) -> FollowedSource:
    planes = [high_pass(bands.mean(axis=0, dtype=np.float32)) for bands in (cut(LABELS, sources), *sources)]
    return follow_planes(planes)


def test_the_composite_of_a_hard_cut_is_the_mosaic(sources: list[np.ndarray]) -> None:
    mosaic = cut(LABELS, sources)
    composite = make_composite(mosaic, sources, NAMES, LABELS, AS_THEY_ARE)
    np.testing.assert_array_equal(composite.bands, mosaic)
    assert composite.bands.dtype == np.uint8
    np.testing.assert_array_equal(composite.levelled, mosaic)
    assert composite.names == NAMES


def test_the_levelled_composite_has_the_mosaics_grey_values(sources: list[np.ndarray]) -> None:
    tones = [{name: Tone(0.5 + 0.1 * i, 3.0 * i) for name in NAMES} for i in range(4)]
    composite = make_composite(cut(LABELS, sources), sources, NAMES, LABELS, tones)
    for i in range(3):
        own = np.equal(LABELS, i)
        np.testing.assert_array_equal(composite.bands[:, own], sources[i][:, own])
        np.testing.assert_allclose(composite.levelled[:, own], (0.5 + 0.1 * i) * sources[i][:, own] + 3 * i, rtol=1e-6)


def test_where_no_source_explains_nothing_is_gained_or_lost(sources: list[np.ndarray]) -> None:
    """The mosaic's own pixels stand there: as they are in its tones, and by the main source's tone in the sources'."""
    labels = LABELS.copy()
    labels[40:90, 200:260] = UNKNOWN
    main = int(np.bincount(LABELS.ravel()).argmax())
    tones = [{name: Tone(0.8, 12.0) for name in NAMES} for _ in range(4)]
    mosaic = np.rint(0.8 * cut(LABELS, sources) + 12).astype(np.uint8)
    composite = make_composite(mosaic, sources, NAMES, labels, tones)
    unknown = labels == UNKNOWN
    np.testing.assert_array_equal(composite.levelled[:, unknown], mosaic[:, unknown])
    tone = tones[main]["red"]
    back = (mosaic[:, unknown] - tone.bias) / tone.gain
    np.testing.assert_allclose(composite.bands[:, unknown], np.clip(back, 0, 255), atol=0.51)
    known = ~unknown
    np.testing.assert_array_equal(composite.bands[:, known], cut(LABELS, sources)[:, known])


def test_only_squares_of_one_source_count(followed: FollowedSource) -> None:
    whole = follows_at(followed, 1, 3)
    assert whole.any()
    own = followed.labels == 1
    for row, column in np.argwhere(whole):
        assert own[8 * row : 8 * row + 8, 8 * column : 8 * column + 8].all()
