"""The verdict by the seam profile: its limits, its tolerance, and where there is none."""
from __future__ import annotations

import math
from types import SimpleNamespace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.errors import Message, SettingsError
from seam_inspector.plugin.imagery.seam_totals import MOST_SPREAD
from seam_inspector.plugin.seams.measure import limits
from seam_inspector.plugin.seams.measure import messages as seams_messages
from seam_inspector.plugin.seams.measure.judgement.causes import MIN_MIXED
from seam_inspector.plugin.seams.measure.judgement.verdicts import (
    MAX_KEPT_LOW,
    MAY_HIDE_SEAM,
    MIN_EXPLAINED,
    Judgement,
    Ratios,
    Verdict,
)
from seam_inspector.plugin.seams.measure.profile.seam_profile import SeamProfile
from seam_inspector.plugin.seams.measure.window.explained_window import judge_by_seam
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings
from seam_inspector.plugin.seams.measure.window_records import MAY_BE_SIGNIFICANT, OF_THE_REST

LITTLE = 1e-9
BLURRED = math.sqrt(limits.MAX_SIGNIFICANT_SHARPNESS_SQUARED)


def profile(kept: float, low: float | None = None, high: float | None = None) -> SeamProfile:
    """With an interval of 5 % either way unless told."""
    ends = 0.95 * kept if low is None else low, 1.05 * kept if high is None else high
    return SeamProfile((kept, 1.0, 1.0), *ends, 0.0, 0.0, ())


def judged(
    profile: SeamProfile | None, min_kept: float = limits.MAX_SIGNIFICANT_KEPT, sharpness: float | None = 1.0,
    **of_window: float,
) -> tuple[Verdict, Message | None]:
    figures = {"has_seam": True, "explained": 1.0, "mixed_share": 0.0, **of_window}
    return judge_by_seam(SimpleNamespace(profile=profile, sharpness=sharpness, **figures), min_kept)  # type: ignore[arg-type]


def verdict_of(profile: SeamProfile | None, sharpness: float | None = 1.0, has_seam: bool = True) -> Verdict:
    return judged(profile, sharpness=sharpness, has_seam=has_seam)[0]


def reason_of(profile: SeamProfile | None, sharpness: float | None = 1.0, has_seam: bool = True) -> str | None:
    reason = judged(profile, sharpness=sharpness, has_seam=has_seam)[1]
    return reason.template if reason else None


def test_what_is_kept_decides() -> None:
    assert verdict_of(profile(0.3)) is Verdict.SIGNIFICANT
    assert verdict_of(profile(0.85)) is Verdict.REDUCED
    assert verdict_of(profile(1.0)) is Verdict.PRESERVED
    assert verdict_of(profile(1.15)) is Verdict.PRESERVED
    assert reason_of(profile(0.3)) is reason_of(profile(0.85)) is reason_of(profile(1.0)) is None


@pytest.mark.parametrize("limit", [0.3, 0.5, 0.9])
def test_the_user_may_move_that_limit(limit: float) -> None:
    assert judged(profile(limit), limit) == (Verdict.SIGNIFICANT, None)
    assert judged(profile(limit + LITTLE), limit) == (Verdict.REDUCED, None)


@pytest.mark.parametrize("limit", [0.3, 0.5, 0.7, 0.9])
def test_significant_is_said_only_where_the_interval_ends_half_way_to_all(limit: float) -> None:
    """Else it is a loss for sure, and may be a significant one."""
    half = (limit + 1) / 2
    low = max(0.9 * limit, 0.5 * half)
    assert judged(profile(limit, low, half), limit) == (Verdict.SIGNIFICANT, None)
    verdict, reason = judged(profile(limit, low, half + LITTLE), limit)
    assert verdict is Verdict.REDUCED
    assert reason.template == seams_messages.MAY_BE_SIGNIFICANT.template
    assert f"{100 * low:.0f} to {100 * half:.0f} %" in str(reason)


def test_significant_is_said_only_where_the_interval_spans_no_more_than_a_factor_of_two() -> None:
    assert MOST_SPREAD == 2
    assert judged(profile(0.5, 0.4, 0.8)) == (Verdict.SIGNIFICANT, None)
    verdict, reason = judged(profile(0.5, 0.4, 0.8 + LITTLE))
    assert verdict is Verdict.REDUCED
    assert reason.template == seams_messages.MAY_BE_SIGNIFICANT.template


@pytest.mark.parametrize(("kept", "low"), [(0.01, 0.0), (0.3, 0.1)])
def test_significant_is_said_of_any_interval_below_the_limit(kept: float, low: float) -> None:
    limit = limits.MAX_SIGNIFICANT_KEPT
    assert verdict_of(profile(kept, low, limit)) is Verdict.SIGNIFICANT
    assert verdict_of(profile(kept, low, limit + LITTLE)) is Verdict.REDUCED


@pytest.mark.parametrize("kept", [0.6, 0.8, 0.97])
def test_a_loss_that_may_be_none_is_no_loss(kept: float) -> None:
    """The interval is the verdict's tolerance: a sound hard cut is not called reduced by a coin toss."""
    assert verdict_of(profile(kept, 0.55, 1.0 - LITTLE)) in (Verdict.REDUCED, Verdict.SIGNIFICANT)
    without = Verdict.NOT_COMPARABLE if kept <= limits.MAX_SIGNIFICANT_KEPT else Verdict.PRESERVED
    assert verdict_of(profile(kept, 0.55, 1.0)) is without  # so little is kept, and nothing lost: no number


def test_a_wide_interval_is_no_verdict() -> None:
    """An interval that holds both a loss and none decides nothing; a loss for sure stays one, however wide."""
    assert verdict_of(profile(0.8, 0.55, MOST_SPREAD * 0.55)) is Verdict.PRESERVED
    wide = profile(0.8, 0.55, MOST_SPREAD * 0.55 + LITTLE)
    assert verdict_of(wide) is Verdict.NOT_COMPARABLE
    assert reason_of(wide) == seams_messages.INTERVAL_TOO_WIDE.template
    assert "55 and 110 %" in str(judged(wide)[1])
    assert verdict_of(profile(0.8, 0.45, 0.95)) is Verdict.REDUCED


def test_too_little_ground_is_no_verdict() -> None:
    assert verdict_of(None) is Verdict.NOT_COMPARABLE
    assert reason_of(None) == seams_messages.TOO_LITTLE_GROUND.template


def test_more_than_any_seam_leaves_is_no_verdict() -> None:
    """The sources that it seems to follow are not those that it was made from."""
    assert verdict_of(profile(1.3, MAX_KEPT_LOW, 1.4)) is Verdict.PRESERVED
    assert reason_of(profile(1.3, MAX_KEPT_LOW + LITTLE, 1.4)) == seams_messages.MORE_ALONG_THE_SEAM.template


@pytest.mark.parametrize("has_seam", [True, False])
def test_without_a_profile_a_part_from_no_source_is_no_verdict(has_seam: bool) -> None:
    verdict, reason = judged(None, has_seam=has_seam, explained=MIN_EXPLAINED - LITTLE)
    assert verdict is Verdict.NOT_COMPARABLE
    assert reason.template == seams_messages.SEAM_UNEXPLAINED.template
    assert judged(None, has_seam=False, explained=MIN_EXPLAINED)[0] is Verdict.PRESERVED


def test_a_sound_seam_beside_a_part_from_no_source_is_no_verdict() -> None:
    for kept, verdict in ((0.5, Verdict.SIGNIFICANT), (0.85, Verdict.REDUCED), (1.0, Verdict.NOT_COMPARABLE)):
        assert judged(profile(kept), explained=MIN_EXPLAINED - LITTLE)[0] is verdict
    assert judged(profile(1.0), explained=MIN_EXPLAINED)[0] is Verdict.PRESERVED


def test_without_a_seam_the_sharpness_alone_is_judged_and_that_is_said() -> None:
    for sharpness, verdict in ((1.0, Verdict.PRESERVED), (0.8, Verdict.REDUCED), (1.5, Verdict.PRESERVED)):
        assert verdict_of(None, sharpness, has_seam=False) is verdict
        assert reason_of(None, sharpness, has_seam=False) == seams_messages.NO_SEAM.template
    assert verdict_of(None, 0.2, has_seam=False) is Verdict.SIGNIFICANT


@pytest.mark.parametrize("measured", [profile(1.0), profile(0.9), None])
def test_a_gross_blur_is_significant_whatever_the_seam_kept(measured: SeamProfile | None) -> None:
    assert verdict_of(measured, BLURRED - LITTLE) is Verdict.SIGNIFICANT
    assert verdict_of(measured, BLURRED + LITTLE) is not Verdict.SIGNIFICANT


def test_a_slight_blur_is_reduced_beyond_its_tolerance() -> None:
    assert verdict_of(profile(1.0), 1 - limits.SHARPNESS_TOLERANCE) is Verdict.PRESERVED
    assert verdict_of(profile(1.0), 1 - limits.SHARPNESS_TOLERANCE - LITTLE) is Verdict.REDUCED


@pytest.mark.parametrize("sharpness", [1.2, 2.0])
def test_sharpening_hides_no_seam(sharpness: float) -> None:
    assert verdict_of(profile(0.5), sharpness) is Verdict.SIGNIFICANT
    assert verdict_of(profile(0.85), sharpness) is Verdict.REDUCED


def test_what_no_source_explains_is_not_judged() -> None:
    for has_seam in (True, False):
        assert verdict_of(profile(0.4), None, has_seam) is Verdict.NOT_COMPARABLE
        assert reason_of(profile(0.4), None, has_seam) == seams_messages.COMPOSITE_UNCLEAR.template


@given(sharpness=st.floats(0.4, 0.97))
def test_nothing_but_a_gross_blur_is_significant_by_the_sharpness_whatever_is_mixed(sharpness: float) -> None:
    """No cliff: a little more or less of a mixture moved the limit."""
    assert BLURRED < 0.4
    for measured in (profile(1.04, 0.93, 1.1), profile(1.0)):
        assert verdict_of(measured, sharpness) is Verdict.REDUCED
    assert verdict_of(None, sharpness, has_seam=False) is Verdict.REDUCED


@given(
    kept=st.floats(0.05, 2), below=st.floats(0.5, 1), above=st.floats(1, 2), sharpness=st.floats(0.05, 3),
    less=st.floats(0.3, 1),
)
def test_less_kept_is_never_judged_better(
    kept: float, below: float, above: float, sharpness: float, less: float
) -> None:
    order = [Verdict.SIGNIFICANT, Verdict.REDUCED, Verdict.PRESERVED]
    better = verdict_of(profile(kept, kept * below, kept * above), sharpness)
    worse = verdict_of(profile(kept * less, kept * less * below, kept * less * above), sharpness)
    if better is not Verdict.NOT_COMPARABLE:
        assert order.index(worse) <= order.index(better)
    duller = verdict_of(profile(kept, kept * below, kept * above), sharpness * less)
    if better is not Verdict.NOT_COMPARABLE:
        assert order.index(duller) <= order.index(better)


@pytest.mark.parametrize("name", ["max_ratio", "min_kept"])
@pytest.mark.parametrize("limit", [0.0, 1.0, -0.5, 1.5, math.nan, math.inf])
def test_a_limit_that_is_no_share_is_refused(name: str, limit: float) -> None:
    with pytest.raises(SettingsError, match=r"give a (number between 0 and 1|finite number)"):
        InspectionSettings(**{name: limit}).check()


@pytest.mark.parametrize(("sharpness", "verdict"), [(1.0, Verdict.NOT_COMPARABLE), (0.7, Verdict.REDUCED)])
def test_preserved_is_never_said_of_a_mixture(sharpness: float, verdict: Verdict) -> None:
    said, reason = judged(None, sharpness=sharpness, has_seam=False, mixed_share=MIN_MIXED)
    assert (said, reason and reason.template) == (verdict, seams_messages.MIXED_ALL_OVER.template)
    assert judged(None, has_seam=False, mixed_share=MIN_MIXED - LITTLE)[0] is Verdict.PRESERVED


def test_a_seam_under_ground_that_nothing_explains_is_no_verdict() -> None:
    for explained, reason in (
        (MAY_HIDE_SEAM - LITTLE, seams_messages.SEAM_UNEXPLAINED), (MAY_HIDE_SEAM, seams_messages.TOO_LITTLE_GROUND),
    ):
        verdict, why = judged(None, explained=explained)
        assert (verdict, why and why.template) == (Verdict.NOT_COMPARABLE, reason.template)


def test_logic_reads_a_code_and_no_sentence() -> None:
    def code(reason: Message | None) -> str:
        return Judgement(Verdict.REDUCED, Ratios((None,), None), reason).reason_code

    assert code(None) == code(seams_messages.NO_SEAM()) == ""
    doubtful = seams_messages.MAY_BE_SIGNIFICANT(low=35.0, high=94.0)
    assert code(doubtful) == MAY_BE_SIGNIFICANT
    assert code(seams_messages.VERDICT_OF_THE_REST(share=9.9)) == OF_THE_REST
