"""The ROC curve of an observer's verdicts, against scipy and against what its definitions say."""
from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats
from seam_inspector.plugin.seams.measure.calibration.threshold_calibration import (
    STANDARD_LIMITS,
    Neighbourhoods,
    Verdicts,
    area_interval,
    calibrate,
    roc_area,
    step_at,
    wanted_verdicts,
)
from seam_inspector.plugin.seams.measure.limits import MAX_SIGNIFICANT_SHARPNESS_SQUARED

VALUES = st.lists(st.integers(0, 40).map(lambda number: number / 20), min_size=5, max_size=30)


def normal_verdicts(visible: int, invisible: int, apart: float = 1.5, seed: int = 1) -> Verdicts:
    """Values around 0.5 where a loss is visible, ``apart`` standard deviations higher where it is not."""
    random = np.random.default_rng(seed)
    low, high = random.normal(0.5, 0.15, visible), random.normal(0.5 + 0.15 * apart, 0.15, invisible)
    return Verdicts("ratio_1", tuple(low.tolist()), tuple(high.tolist()))


@given(VALUES, VALUES)
def test_the_area_is_mann_whitneys(visible: list[float], invisible: list[float]) -> None:
    result = calibrate(Verdicts("ratio_1", tuple(visible), tuple(invisible)))
    statistic = stats.mannwhitneyu(invisible, visible).statistic
    assert result.area is not None
    assert result.area.value == pytest.approx(statistic / (len(visible) * len(invisible)))
    assert 0 <= result.area.low <= result.area.high <= 1
    x, y = zip((0, 0), *((1 - step.specificity, step.sensitivity) for step in result.steps))
    assert sum((y[i] + y[i + 1]) / 2 * (x[i + 1] - x[i]) for i in range(len(x) - 1)) == pytest.approx(result.area.value)


@given(VALUES, VALUES)
def test_the_threshold_is_told_with_what_it_does_to_the_judged_windows(
    visible: list[float], invisible: list[float]
) -> None:
    verdicts = Verdicts("ratio_1", tuple(visible), tuple(invisible))
    result = calibrate(verdicts, most=1.0)
    if result.best is None:
        assert any("threshold" in str(notice) for notice in result.notices)
    else:
        assert result.best == step_at(verdicts, result.best.threshold)
        assert 0 < result.best.youden <= max(step.youden for step in result.steps)
        assert result.best.threshold < 1
        assert result.best_range is not None
        assert result.best_range[0] <= result.best.threshold <= result.best_range[1] <= 1
    assert result.steps == tuple(step_at(verdicts, value) for value in sorted({*visible, *invisible}))


@given(VALUES, VALUES)
def test_a_measure_of_loss_is_calibrated_as_what_is_left_is(visible: list[float], invisible: list[float]) -> None:
    """Visibility is high where kept is low: the same curve, and thresholds that flag what lies at or above them."""
    left = calibrate(Verdicts("kept_1", tuple(3 - value for value in visible), tuple(3 - value for value in invisible)))
    verdicts = Verdicts("visibility", tuple(visible), tuple(invisible), is_loss=True)
    result = calibrate(verdicts)
    assert result.verdicts == verdicts
    assert result.area == left.area
    assert result.steps == tuple(step_at(verdicts, value) for value in sorted({*visible, *invisible}, reverse=True))
    for step in result.steps:
        assert step.flagged_visible == sum(value >= step.threshold for value in visible)
        assert step.flagged_invisible == sum(value >= step.threshold for value in invisible)
    if result.best and result.best_range:
        assert result.best == step_at(verdicts, result.best.threshold)
        assert result.best_range[0] <= result.best.threshold <= result.best_range[1]


def test_the_interval_is_that_of_scipys_bootstrap() -> None:
    verdicts = normal_verdicts(30, 60)
    interval = calibrate(verdicts).area

    def area(visible: np.ndarray, invisible: np.ndarray, axis: int = -1) -> np.ndarray:
        return np.mean(visible[..., :, np.newaxis] < invisible[..., np.newaxis, :], axis=(-1, -2))

    groups = verdicts.visible, verdicts.invisible
    with_scipy = stats.bootstrap(groups, area, method="percentile", n_resamples=4000, batch=500, random_state=1)
    assert interval is not None
    assert (interval.low, interval.high) == pytest.approx(tuple(with_scipy.confidence_interval), abs=0.01)


def test_the_same_verdicts_give_the_same_numbers() -> None:
    assert calibrate(normal_verdicts(20, 30)) == calibrate(normal_verdicts(20, 30))


def test_the_interval_holds_the_true_area() -> None:
    true = stats.norm.cdf(1.5 / math.sqrt(2))
    held, places = 0, Neighbourhoods(range(25), range(25, 65))
    for seed in range(100):
        verdicts = normal_verdicts(25, 40, seed=seed)
        area = roc_area(np.array(verdicts.visible), np.array(verdicts.invisible), places)
        held += area.low <= true <= area.high
    assert held >= 88  # 95 expected, give or take chance


@pytest.mark.parametrize(("visible", "invisible"), [(4, 50), (50, 4), (0, 0)])
def test_too_few_verdicts_give_words_and_no_number(visible: int, invisible: int) -> None:
    result = calibrate(normal_verdicts(visible, invisible))
    assert (result.steps, result.area, result.best, result.best_range, result.wanted) == ((), None, None, None, None)
    (notice,) = result.notices
    assert f"{visible} visible and {invisible} invisible" in str(notice)
    assert "judge more windows" in str(notice)


def test_verdicts_fully_apart_are_no_certainty() -> None:
    result = calibrate(Verdicts("ratio_1", (0.1, 0.2, 0.3, 0.35, 0.4), (0.62, 0.7, 0.8, 0.9, 1.2)), most=1.0)
    assert result.area is not None
    assert result.best is not None
    assert result.area.value == result.area.high == 1
    assert result.area.low < 0.75  # ten verdicts: far from sure
    assert 0.4 < result.best.threshold < 0.62
    assert result.best.threshold == 0.5  # of all in the gap's middle the one with the fewest decimals
    assert "resampling" in str(result.notices[0])


def test_a_measure_that_tells_nothing_says_so() -> None:
    result = calibrate(normal_verdicts(40, 40, apart=0))
    assert result.area is not None
    assert result.area.low < 0.5 < result.area.high
    assert any("0.5 is a guess" in str(notice) for notice in result.notices)


def test_losses_above_what_can_be_set_are_told() -> None:
    result = calibrate(Verdicts("ratio_1", (1.1, 1.2, 1.3, 1.4, 1.5), (1.6, 1.7, 1.8, 1.9, 2.0)), most=1.0)
    assert result.best is None
    assert result.best_range is None
    assert any("threshold of 1.55" in str(notice) and "below 1" in str(notice) for notice in result.notices)


# --- how many verdicts are enough ------------------------------------------------------------------------------


def hanley_mcneil(area: float, visible: int, invisible: int) -> float:
    """The standard error as Hanley and McNeil 1982 write it."""
    q1, q2 = area / (2 - area), 2 * area**2 / (1 + area)
    spread = area * (1 - area) + (visible - 1) * (q1 - area**2) + (invisible - 1) * (q2 - area**2)
    return math.sqrt(spread / (visible * invisible))


@given(st.floats(0.2, 0.8), st.integers(200, 2000))
def test_the_score_interval_is_hanley_and_mcneils_with_many_verdicts(area: float, count: int) -> None:
    low, high = area_interval(area, count, count)
    reach = 1.96 * hanley_mcneil(area, count, count)
    assert (low, high) == pytest.approx((area - reach, area + reach), abs=0.15 * reach)


@given(st.floats(0, 1), st.integers(5, 300), st.integers(5, 300))
def test_the_score_interval_holds_the_area(area: float, visible: int, invisible: int) -> None:
    low, high = area_interval(area, visible, invisible)
    assert 0 <= low <= area <= high <= 1
    assert high - low > 0
    mirrored = area_interval(1 - area, visible, invisible)
    assert mirrored == pytest.approx((1 - high, 1 - low), abs=1e-9)


@given(st.floats(0.5, 1), st.integers(5, 60), st.integers(5, 60))
def test_wanted_verdicts_are_just_enough(area: float, visible: int, invisible: int) -> None:
    wanted = wanted_verdicts(area, visible, invisible)
    low, high = area_interval(area, *wanted)
    assert high - low <= 0.1
    assert min(wanted) >= 5
    if min(wanted) > 8:
        fewer = [max(5, int(count * 0.85)) for count in wanted]
        low, high = area_interval(area, *fewer)
        assert high - low > 0.1
        assert wanted[0] / sum(wanted) == pytest.approx(visible / (visible + invisible), abs=0.07)


def test_verdicts_of_one_place_are_told() -> None:
    lonely = normal_verdicts(10, 10)
    together = replace(lonely, places=((0,) * 10, (0,) * 10))
    result = calibrate(together)
    assert result.best_range == calibrate(lonely).best_range
    assert result.neighbourhoods is None
    assert any("one neighbourhood" in str(notice) for notice in result.notices)


def test_the_standard_limits_are_those_of_the_guide(repository: Path) -> None:
    default_limits, visibility = (
        (repository / "docs" / "method" / f"{page}.md").read_text(encoding="utf-8").replace("\n", " ")
        for page in ("default_limits", "visibility")
    )
    assert f"**kept_1 is {STANDARD_LIMITS['kept_1']} or less**" in default_limits
    assert f"**square of sharpness_1 is {MAX_SIGNIFICANT_SHARPNESS_SQUARED} or less**" in default_limits
    assert f"{STANDARD_LIMITS['visibility']:.0f} is one *just noticeable difference*" in visibility
