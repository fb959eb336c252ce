"""What the benchmark of the detection stands on: windows in two halves, operations, and how much they truly left."""
from __future__ import annotations

import numpy as np
import pytest

from benchmarks.known_windows import Imagery, KnownWindow, PlacedImage
from benchmarks.operations import HARD, KINDS, NOTHING, OPERATIONS
from benchmarks.production import HALVES, Operation
from benchmarks.readings import read
from benchmarks.seam_makings import cut_or_feathered, seam_distance
from benchmarks.true_profile import truth_of
from tests.numbers.synthetic import orthoimage, texture

SIDE = 128


def made_up(side: int) -> Imagery:
    """Four images that cover the same ground and have half of their detail in common."""
    shape = (3 * side, 8 * side)
    scene = orthoimage(shape) // 2
    placed = tuple(PlacedImage(scene + orthoimage(shape, seed=seed) // 2, 0, 0, 0) for seed in range(1, 5))
    return Imagery("made up", 0.1, placed, *shape)


@pytest.fixture(scope="module")
def imagery() -> Imagery:
    """For windows of the usual side."""
    return made_up(SIDE)


@pytest.fixture(scope="module")
def window(imagery: Imagery) -> KnownWindow:
    """One with three sources."""
    return next(window for window in imagery.windows(SIDE, 6, held_back=False) if len(window.sources) == 3)


def test_the_halves_have_no_ground_in_common(imagery: Imagery) -> None:
    where = np.broadcast_to(1 + np.arange(imagery.columns) // 8, (3, imagery.rows, imagery.columns)).astype(np.uint8)
    tape = Imagery("measuring tape", 0.1, (PlacedImage(where, 0, 0, 0),) * 2, imagery.rows, imagery.columns)
    used, held = (np.stack([window.sources[0] for window in tape.windows(SIDE, 30, half)]) for half in (False, True))
    assert len(used) == len(held) == 30
    assert used.max() < held.min()


def test_windows_stay_the_same(imagery: Imagery) -> None:
    once, again = (imagery.windows(SIDE, 8, held_back=True) for _ in range(2))
    for first, second in zip(once, again):
        assert first.number == second.number
        assert np.array_equal(first.labels, second.labels)
        assert np.array_equal(first.sources, second.sources)


def test_half_of_the_operations_are_held_back_and_none_stands_twice() -> None:
    assert len({one.name for one in OPERATIONS}) == len(OPERATIONS)
    assert 0.4 < np.mean([one.half == HALVES[1] for one in OPERATIONS]) < 0.6
    for name in HALVES[:2]:
        half = [one for one in OPERATIONS if one.in_half(name)]
        assert {making.name for making in KINDS} == {one.making.name for one in half if one.making in KINDS}
        assert {"none", "feathering", "missing source", "balanced"} <= {one.true_causes[0] for one in half}


@pytest.mark.release
@pytest.mark.parametrize("operation", OPERATIONS, ids=lambda one: one.name)
def test_detail_is_lost_along_the_seam_where_an_operation_says_so(operation: Operation, window: KnownWindow) -> None:
    made = operation.make(window)
    assert made.bands.dtype == np.uint8
    assert made.bands.shape == window.sources[0].shape
    if made.foreign[window.middle].any():
        assert np.isnan(made.truth)
    elif operation.lost_in_strip:
        assert made.truth < 0.93
    else:
        assert made.truth == pytest.approx(1, abs=0.05)


def test_a_hard_cut_keeps_all_of_images_that_have_nothing_in_common() -> None:
    planes = [128 + 30 * texture((256, 256), 0, seed) for seed in (1, 2)]
    bands = [np.repeat(plane[np.newaxis], 3, axis=0) for plane in planes]
    labels = (np.arange(256) >= 128)[np.newaxis].repeat(256, axis=0).astype(np.uint8)
    distance, whole = seam_distance(labels), (slice(0, 256),) * 2
    assert truth_of(cut_or_feathered(bands, labels), distance, whole).near == pytest.approx(1, abs=1e-6)
    wide = cut_or_feathered(bands, labels, 200)
    assert truth_of(wide, distance, whole).near == pytest.approx(0.5, abs=0.05)


@pytest.mark.parametrize("operation", [one for one in OPERATIONS if "missing" in one.name], ids=lambda one: one.name)
def test_a_source_that_is_missing_has_its_share_of_the_window(operation: Operation, window: KnownWindow) -> None:
    made = operation.make(window)
    share = int(operation.name.split("%")[0].split()[-1]) / 100
    assert made.foreign[window.middle].mean() == pytest.approx(share, abs=0.02)
    assert len(made.sources) == len(window.sources) - 1


def test_the_plugin_reads_what_was_made() -> None:
    side = 192
    window = next(window for window in made_up(side).windows(side, 6, held_back=False) if len(window.sources) == 3)
    plain = next(one for one in OPERATIONS if one.making is HARD and one.aftermath is NOTHING)
    reading = read(plain.make(window), window)
    assert reading.has_verdict
    assert reading.verdict == "preserved"
    assert reading.cause == "none"
    assert reading.contrast == pytest.approx(1, abs=0.01)
    assert reading.kept == pytest.approx(1, abs=0.05)
    assert reading.low < 1 < reading.high
    assert reading.source_count == 3
    assert reading.explained == pytest.approx(1, abs=0.01)
