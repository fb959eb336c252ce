"""The arithmetic of the decision: what counts as failed, what is not known, and each rule's limit."""
from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.acceptance.measure.acceptance_rules import SamplingRule
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.decision import PieceState
from seam_inspector.plugin.acceptance.measure.delivery import SeenWindow
from seam_inspector.plugin.imagery.errors import SettingsError

from tests.numbers.acceptance.deliveries import delivery, rules, seam

KEPT = st.one_of(st.none(), st.floats(0.0, 1.3))
SAMPLING = SamplingRule("1.0", "II", "normal", "contract")


@given(st.lists(st.tuples(st.lists(KEPT, min_size=1, max_size=12), st.floats(0.5, 40)), min_size=1, max_size=5),
       st.floats(0.0, 1.0), st.floats(0.0, 100.0), st.floats(0.05, 1.2))
def test_metres_add_up_and_the_rules_decide(
    seams: list[tuple[list[float | None], float]], most: float, longest: float, least: float
) -> None:
    made, number = [], 0
    for place, (kept, length) in enumerate(seams):
        made.append(seam(kept, length, f"sheet {place % 2}", str(place), (0, 1000 * place), number=number))
        number += len(kept)
    found = decide(delivery(*made), rules(most, longest, kept=least))
    pieces = [piece for pieces in made for piece in pieces]
    measured = math.fsum(one.length_m for one in pieces if one.kept_1 is not None)
    total = math.fsum(one.length_m for one in pieces)
    assert found.whole.measured_m == pytest.approx(measured)
    assert found.whole.total_m == pytest.approx(total)
    assert sum(sheet.failed_m for sheet in found.sheets) == pytest.approx(found.whole.failed_m)
    assert sum(run.length_m for run in found.runs) == pytest.approx(found.whole.failed_m)
    assert 0 <= found.whole.failed_m <= measured * (1 + 1e-9)
    assert sorted(number for run in found.runs for number in run.pieces) == [
        one.piece.number for one in found.pieces if one.state is PieceState.FAILED
    ]
    assert found.longest_failure_m == max((run.length_m for run in found.runs), default=0)
    assert found.longest_failure_m >= max((sheet.longest_failure_m for sheet in found.sheets), default=0) - 1e-9
    ruled = measured > 0 and found.whole.failed_share <= most and found.longest_failure_m <= longest
    assert found.accepted == (ruled and found.whole.measured_share >= 0.9)
    assert str(found.sentences[0]).startswith("Accepted" if found.accepted else "Rejected")
    if found.failed_share is not None:
        assert 0 <= found.failed_share.low <= found.failed_share.value <= found.failed_share.high <= 1


def test_exactly_the_limit_passes() -> None:
    pieces = seam([0.7, 0.7 - 1e-12, *([0.9] * 98)])
    found = decide(delivery(pieces), rules(share=1, run=1000))
    assert [one.state for one in found.pieces[:2]] == [PieceState.PASSED, PieceState.FAILED]
    share, longest = found.whole.failed_share, found.longest_failure_m
    assert share is not None
    assert decide(delivery(pieces), rules(share=share, run=longest)).accepted
    assert not decide(delivery(pieces), rules(share=share - 1e-6, run=longest)).accepted
    assert not decide(delivery(pieces), rules(share=share, run=longest - 1e-6)).accepted


def test_too_little_measured_is_not_accepted_and_says_so() -> None:
    found = decide(delivery(seam([0.9] * 8 + [None] * 2)), rules())
    assert not found.accepted
    assert "only 80.0% of the metres were measured" in str(found.sentences[0])
    assert any("20.0 of 100.0 m of seam could not be measured" in str(said) for said in found.sentences)


def test_nothing_measured_is_not_accepted() -> None:
    found = decide(delivery(seam([None] * 5)), rules())
    assert not found.accepted
    assert found.failed_share is None
    assert "can't be told" in str(found.sentences[0])


def test_what_the_interval_can_not_tell_is_said() -> None:
    found = decide(delivery(seam([0.68, 0.72, 0.4, 0.9, 0.75])), rules())
    assert [one.is_unclear for one in found.pieces] == [True, True, False, False, False]
    assert found.whole.unclear_m == 20


@pytest.mark.parametrize(
    ("low", "high", "state"),
    [
        (0.2, 0.9, PieceState.NOT_MEASURED),
        (0.1, 0.65, PieceState.FAILED),
        (0.7, 2.0, PieceState.PASSED),
        (None, None, PieceState.NOT_MEASURED),
    ],
)
def test_without_a_verdict_the_interval_has_to_tell(low: float | None, high: float | None, state: PieceState) -> None:
    (piece,) = seam([0.5])
    piece = replace(piece, kept_1=0.5 if high != 2.0 else 1.1, kept_low=low, kept_high=high, verdict="not_comparable")
    assert decide(delivery([piece]), rules()).pieces[0].state is state


@pytest.mark.parametrize(("failed", "accepted"), [(2, True), (3, False)])
def test_a_plan_decides_by_its_number(failed: int, accepted: bool) -> None:
    kept = [0.4] * failed + [0.9] * (80 - failed)
    found = decide(delivery(seam(kept)), rules(None, None, sampling=SAMPLING), lot_size=1000)
    assert found.accepted == accepted
    assert found.plan is not None
    assert (found.plan.plan.sample_size, found.plan.plan.acceptance_number) == (80, 2)
    assert (found.plan.inspected, found.plan.nonconforming) == (80, failed)
    assert f"{failed} of 80 inspected pieces failed" in str(found.sentences[0])
    assert "are rejected" in str(found.sentences[0])


def test_a_sample_is_drawn_with_its_seed() -> None:
    made = delivery(seam([0.4] * 30 + [0.9] * 970))
    first, again, other = (
        decide(made, rules(None, None, sampling=SAMPLING), seed=seed) for seed in (1, 1, 2)
    )
    drawn = [[one.piece.number for one in found.pieces if one.is_sampled] for found in (first, again, other)]
    assert drawn[0] == drawn[1] != drawn[2]
    assert {len(numbers) for numbers in drawn} == {80}
    assert first.whole.failed_m == pytest.approx(300, abs=3)  # the figures are of all that was measured


def test_a_sample_that_lacks_pieces_decides_only_what_they_can_not_change() -> None:
    def found(failed: int, missing: int) -> bool | None:
        kept = [0.4] * failed + [None] * missing + [0.9] * (80 - failed - missing)
        pieces = [replace(piece, sample_number=place + 1) for place, piece in enumerate(seam(kept))]
        made = replace(delivery(pieces), lot_size=1000)
        return decide(made, rules(None, None, measured=0, sampling=SAMPLING)).outcomes[0].passed

    assert (found(1, 1), found(1, 2), found(3, 5)) == (True, None, False)


@pytest.mark.parametrize("sampling", [None, SAMPLING])
def test_a_sample_does_not_tell_how_long_failures_are(sampling: SamplingRule | None) -> None:
    pieces = [replace(piece, sample_number=place + 1) for place, piece in enumerate(seam([0.4] + [0.9] * 79))]
    part = replace(delivery(pieces), lot_size=1000)
    found = decide(part, rules(share=0.02, run=50.0, sampling=sampling))
    outcome = next(one for one in found.outcomes if one.check == "longest_failure")
    assert (outcome.passed, outcome.value, found.accepted) == (None, None, False)
    assert found.longest_failure_m is None
    assert {one.longest_failure_m for one in (found.whole, *found.sheets)} == {None}
    told = [str(said) for said in found.sentences]
    assert "can't be told from a sample" in told[0]
    assert any("a sample of 80 pieces" in said for said in told)
    assert not any("without a break: " in said for said in told)
    assert any("decide by the plan" in said for said in told) == (sampling is None)
    assert decide(part, rules(share=0.02, run=None, sampling=sampling)).accepted  # the share can be estimated
    too_long = next(one for one in decide(part, rules(run=5.0)).outcomes if one.check == "longest_failure")
    assert too_long.passed is False  # what the sample shows is at least as long in the delivery
    whole = decide(replace(part, lot_size=80), rules(share=0.02, run=50.0))
    assert whole.accepted
    assert whole.longest_failure_m == whole.runs[0].length_m


def test_too_small_a_sample_is_not_accepted() -> None:
    found = decide(delivery(seam([0.9] * 40)), rules(None, None, sampling=SAMPLING), lot_size=1000)
    assert not found.accepted
    assert "needs a sample of 80 pieces and 40 were measured" in str(found.sentences[0])


def test_a_lot_smaller_than_its_pieces_is_refused() -> None:
    with pytest.raises(SettingsError, match="The lot size is 10 and the layers hold 40 pieces"):
        decide(delivery(seam([0.9] * 40)), rules(None, None, sampling=SAMPLING), lot_size=10)


def test_an_observer_decides_where_he_is_asked_to() -> None:
    words = [("visible", ""), ("unsure", "visible"), ("invisible", "visible"), ("unsure", "")]
    windows = tuple(
        SeenWindow(str(place), (10.0 * place, -1, 10.0 * place + 10, 1), observer=one, observer_2=two)
        for place, (one, two) in enumerate(words)
    )
    made = replace(delivery(seam([None, 0.9, 0.1, 0.9, 0.9])), windows=windows)
    found = decide(made, rules(), by_observer=True)
    failed, passed, lacking = PieceState.FAILED, PieceState.PASSED, PieceState.NOT_MEASURED
    assert [one.state for one in found.pieces] == [failed, failed, passed, lacking, lacking]
    assert found.longest_failure_m == 20
    assert any("the operator saw a loss" in str(said) for said in found.sentences)


def test_windows_over_a_piece_and_what_operators_say() -> None:
    words = [("visible", "visible", "significant"), ("invisible", "visible", "preserved"), ("", "", "reduced"),
             ("visible", "unsure", "significant")]
    windows = tuple(
        SeenWindow(str(number), (10.0 * number - 8, -10, 10.0 * number + 18, 10), verdict=verdict, observer=one,
                   observer_2=two, remark=f"seen {number}")
        for number, (one, two, verdict) in enumerate(words)
    )
    found = decide(replace(delivery(seam([0.4] * 4)), windows=windows), rules())
    assert [window.window_id for window in found.pieces[1].windows] == ["1", "0", "2"]
    assert found.observers is not None
    assert found.observers.both is not None
    assert (found.observers.both.count, found.observers.both.agreed) == (2, 1)
    assert found.observers.with_tool is not None
    assert (found.observers.with_tool.count, found.observers.with_tool.agreed) == (3, 3)
