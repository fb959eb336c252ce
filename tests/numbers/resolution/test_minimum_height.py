"""Minimum flying heights: equations 1 and 2 of the paper and its tables 4A and 4B."""
from __future__ import annotations

import math
import statistics

import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.resolution.measure.minimum_height import (
    Observation,
    doubts,
    minimum_heights,
    read_references,
)

POSITIVE = st.floats(0.01, 1e5)

TABLE_4A = (
    (2186, -19), (2186, -19), (2628, -3), (2590, -5), (2649, -2), (2885, 6), (2378, -12), (2431, -10), (2490, -8)
)
TABLE_4B = ((1314, -35), (1383, -31), (1453, -28))  # mean minimum heights, m, and their tolerances, %


def test_observers_of_a_pass_are_averaged_and_their_spread_is_told() -> None:
    """Two passes of three and two observers, after tables 3A and 3B: groups of a target whose ninth has 30 cm."""
    passes = [Observation(3000, (33.67, 30.0, 37.8)), Observation(2500, (30.0, 33.67))]
    (result,) = minimum_heights(passes, 30)
    each = [[3000 * 30 / grd for grd in passes[0].grds_cm], [2500 * 30 / grd for grd in passes[1].grds_cm]]
    assert result.heights_m == pytest.approx([statistics.fmean(heights) for heights in each])
    assert result.mean_m == pytest.approx(statistics.fmean(result.heights_m))
    assert result.observers == 5
    pooled = (2 * statistics.variance(each[0]) + statistics.variance(each[1])) / 3
    assert result.observer_spread_m == pytest.approx(pooled**0.5)
    assert "2 passes" in str(result.notice)  # observers are no passes
    assert minimum_heights([Observation(3000, (30.0,))], 30)[0].observer_spread_m is None


@given(st.lists(st.tuples(POSITIVE, POSITIVE), min_size=2, max_size=8), POSITIVE)
def test_mean_and_spread_are_those_of_the_passes(passes: list[tuple[float, float]], required: float) -> None:
    (result,) = minimum_heights([Observation(height, (grd,)) for height, grd in passes], required)
    expected = [height * required / grd for height, grd in passes]
    assert result.mean_m == pytest.approx(statistics.fmean(expected))
    assert result.spread_m == pytest.approx(statistics.stdev(expected), abs=1e-6 * max(expected))


@pytest.mark.parametrize("reference", [0.0, -1.0, math.inf])
def test_references_that_are_not_positive_are_refused(reference: float) -> None:
    with pytest.raises(SettingsError, match="positive"):
        read_references(str(reference))


@pytest.mark.parametrize("values", [
    (0, 30), (3000, 0), (-1, 30), (math.nan, 30), (math.inf, 30), (3000, math.inf), (1e300, 1e-300)
])
def test_an_observation_that_can_not_be_says_so(values: tuple[float, float]) -> None:
    assert "give positive numbers" in str(Observation(values[0], (30.0, values[1])).fault)


@pytest.mark.parametrize(("height", "grd", "words"), [
    (33.67, 3000, "interchanged"),  # the paper's example with its columns changed over
    (3000, 0.3367, "holds metres"),
    (3000, 33.67, None),
    (100, 3, None),  # a drone
    (500_000, 30, None),  # a satellite
])
def test_distances_that_no_camera_resolves_are_doubted(height: float, grd: float, words: str | None) -> None:
    """Once each, however many passes there are."""
    notices = doubts([Observation(height, (grd,)), Observation(height, (grd, grd))])
    assert len(notices) == (words is not None)
    assert all(str(words) in str(notice) for notice in notices)


def test_tables_4a_and_4b_are_one_run_with_a_reference_each() -> None:
    both = [(name, *row) for name, table in (("DMC", TABLE_4A), ("RC20", TABLE_4B)) for row in table]
    passes = [Observation(mean, (30,), (name, str(place))) for place, (name, mean, _) in enumerate(both)]
    runs = minimum_heights(passes, 30, read_references("DMC 2714; RC20 = 2015"))
    assert [round(run.tolerance_percent or 0) for run in runs] == [percent for *_, percent in both]


@pytest.mark.parametrize(("words", "said"), [("DMC", "not a reference height"), ("RMK 2000", "for RMK, but")])
def test_a_reference_that_is_none_or_of_no_group_is_told(words: str, said: str) -> None:
    with pytest.raises(SettingsError, match=said):
        minimum_heights([Observation(3000, (30,), ("DMC",))], 30, read_references(words))
