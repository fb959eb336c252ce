"""Minimum flying heights: equations 1 and 2 of the paper and its tables 4A and 4B."""
from __future__ import annotations

import statistics

import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.resolution.measure.minimum_height import Observation, minimum_heights

POSITIVE = st.floats(0.01, 1e5)


def test_the_papers_example() -> None:
    (result,) = minimum_heights([Observation(3000, 33.67)], 30)
    assert result.mean_m == pytest.approx(2673.0, abs=0.05)
    assert result.spread_m is None
    assert result.tolerance_percent is None


@pytest.mark.parametrize(
    ("mean", "reference", "percent"),
    [(2186, 2704, -19), (2628, 2704, -3), (2590, 2722, -5), (1314, 2015, -35), (1383, 2015, -31), (1453, 2015, -28)],
)
def test_tolerances_round_as_in_tables_4a_and_4b(mean: float, reference: float, percent: int) -> None:
    (result,) = minimum_heights([Observation(mean, 30)], 30, reference)
    assert result.tolerance_percent is not None
    assert round(result.tolerance_percent) == percent


@given(st.lists(st.tuples(POSITIVE, POSITIVE), min_size=2, max_size=8), POSITIVE)
def test_mean_and_spread_are_those_of_the_passes(passes: list[tuple[float, float]], required: float) -> None:
    (result,) = minimum_heights([Observation(*one) for one in passes], required)
    expected = [height * required / grd for height, grd in passes]
    assert result.mean_m == pytest.approx(statistics.fmean(expected))
    assert result.spread_m == pytest.approx(statistics.stdev(expected), abs=1e-6 * max(expected))


def test_groups_are_kept_apart_and_few_passes_are_told() -> None:
    passes = [Observation(3000, 30 + number, ("DMC",)) for number in range(5)] + [Observation(2500, 60, ("RCD",))]
    many, few = minimum_heights(passes, 30)
    assert (many.key, len(many.heights_m), many.notice) == (("DMC",), 5, None)
    assert few.mean_m == pytest.approx(1250)
    assert "1 passes over the target; the Open Skies treaty asks for 5" in str(few.notice)


@pytest.mark.parametrize(("required", "reference"), [(0.0, None), (-30.0, None), (30.0, 0.0), (30.0, -1.0)])
def test_numbers_that_are_not_positive_are_refused(required: float, reference: float | None) -> None:
    with pytest.raises(SettingsError, match="positive"):
        minimum_heights([Observation(3000, 30)], required, reference)


@pytest.mark.parametrize("values", [(0, 30), (3000, 0), (-1, 30), (float("nan"), 30)])
def test_an_observation_that_can_not_be_says_so(values: tuple[float, float]) -> None:
    assert "give positive numbers" in str(Observation(*values).fault)
