"""The arithmetic of the decision: what counts as failed, what is not known, and each rule's limit."""
from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.acceptance.measure.acceptance_rules import LONGEST_FAILURE, SamplingRule
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.decision import AcceptanceOutcome
from seam_inspector.plugin.acceptance.measure.delivery import (
    DeliveredLayer,
    DeliveredPiece,
    Delivery,
    Seal,
    SeamCover,
    SheetOutline,
    SheetState,
)
from seam_inspector.plugin.acceptance.measure.ruling import MOST_OF_RUN
from seam_inspector.plugin.acceptance.measure.scanned_files import file_doubts
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.file_identity import FileState, states_text
from seam_inspector.plugin.imagery.seam_totals import MOSAIC_FILES, SOURCE_FILES, PieceState

from tests.numbers.acceptance.deliveries import delivery, rules, seam

ACCEPTED, REJECTED, UNDECIDED = AcceptanceOutcome
KEPT = st.one_of(st.none(), st.floats(0.0, 1.3))
SAMPLING = SamplingRule("1.0", "II", "contract")
LACKING, SHORT = SeamCover(0.5, 0.2), SeamCover(1.0, 1.0, is_short=True)


@given(st.lists(st.tuples(st.lists(KEPT, min_size=1, max_size=12), st.floats(0.5, 40)), min_size=1, max_size=5),
       st.floats(0.0, 1.0), st.floats(0.0, 100.0), st.floats(0.05, 1.2))
def test_metres_add_up_and_the_rules_decide(
    seams: list[tuple[list[float | None], float]], most: float, longest: float, least: float
) -> None:
    made, number = [], 0
    for place, (kept, length) in enumerate(seams):
        made.append(seam(kept, length, f"sheet {place % 2}", str(place), (0, 1000 * place), number=number))
        number += len(kept)
    decision = decide(delivery(*made), rules(most, longest, kept=least))
    pieces = [piece for pieces in made for piece in pieces]
    measured = [piece for piece in pieces if is_measured(piece, least)]
    assert decision.whole.measured_m == pytest.approx(math.fsum(row.length_m for row in measured))
    assert decision.whole.total_m == pytest.approx(math.fsum(piece.length_m for piece in pieces))
    lost = [row for row in measured if row.kept_1 is not None and row.kept_1 < least]
    assert decision.whole.failed_m == pytest.approx(math.fsum(row.length_m for row in lost))
    assert sum(sheet.failed_m for sheet in decision.sheets) == pytest.approx(decision.whole.failed_m)
    assert sum(run.length_m for run in decision.runs) == pytest.approx(decision.whole.failed_m)
    assert sorted(number for run in decision.runs for number in run.pieces) == [row.number for row in lost]
    assert decision.longest_failure_m == max((run.length_m for run in decision.runs), default=0)
    assert decision.longest_failure_m >= max((sheet.longest_failure_m for sheet in decision.sheets), default=0) - 1e-9
    kept = bool(measured) and decision.whole.failed_share <= most and decision.longest_failure_m <= longest
    if decision.outcome is ACCEPTED:
        assert kept
        assert decision.whole.measured_share >= 0.9
    if decision.outcome is REJECTED:
        assert not kept
    coarsest = max((row.length_m for row in measured), default=0)
    hides = decision.whole.longest_unknown_m > longest or coarsest > MOST_OF_RUN * longest > 0
    if measured and decision.whole.measured_share >= 0.9 and not (decision.whole.unclear_m or hides):
        assert decision.accepted is kept  # nothing is open
    assert str(decision.sentences[0]).lower().startswith(decision.outcome.value)


def is_measured(piece: DeliveredPiece, least: float) -> bool:
    """An interval on one side of the limit, or one that says something by itself."""
    kept, low, high = piece.kept_1, piece.kept_low, piece.kept_high
    if kept is None or low is None or high is None:
        return False
    return not low < least <= high or (high <= 2 * low and (kept >= least or high < 1))


def sure(pieces: list[DeliveredPiece]) -> list[DeliveredPiece]:
    """With intervals that hold no limit."""
    return [replace(piece, kept_low=piece.kept_1, kept_high=piece.kept_1) for piece in pieces]


def test_exactly_the_limit_passes() -> None:
    pieces = sure([*seam([0.7, *([0.9] * 98)]), *seam([0.7 - 1e-12], seam_id="2", start=(0, 50), number=99)])
    decision = decide(delivery(pieces), rules(share=1, run=1000))
    assert [decision.pieces[number].state for number in (0, 99)] == [PieceState.PASSED, PieceState.FAILED]
    share, longest = decision.whole.failed_share, decision.longest_failure_m
    assert decide(delivery(pieces), rules(share=share, run=longest)).accepted
    assert decide(delivery(pieces), rules(share=share - 1e-6, run=longest)).outcome is REJECTED
    assert decide(delivery(pieces), rules(share=share, run=longest - 1e-6)).outcome is REJECTED


def text_of(decision: object) -> str:
    return " ".join(map(str, decision.sentences))  # type: ignore[attr-defined]


def test_too_little_measured_is_undecided_and_says_what_would_decide_it() -> None:
    """Not a piece of it failed, so there is nothing to reject it for."""
    decision = decide(delivery(seam([0.9] * 8 + [None] * 2)), rules())
    assert (decision.outcome, decision.accepted) == (UNDECIDED, None)
    assert str(decision.sentences[0]).startswith("Undecided by 'contract': ")
    assert "80.0% of the metres were measured" in str(decision.sentences[0])
    assert "measuring at least 18 of the 20 m that were not measured" in text_of(decision)
    assert "20.0 of 100.0 m of seam could not be measured" in text_of(decision)
    files = {SOURCE_FILES: states_text([("/a.tif", FileState(1, 1, "d"))])}
    wide = [replace(item, kept_low=0.48, kept_high=1.2, verdict="not_comparable") for item in seam([0.76] * 10)]
    made = replace(delivery(wide), layers=(DeliveredLayer("a", Seal.WHOLE, 0.0, files),))
    advised = str(decide(made, rules()).sentences[1])
    assert "with pieces of 20 m (PIECE), with which some 100% of the metres would be measured" in advised
    whole_seams = [replace(piece, seam_id=str(piece.number)) for piece in wide]
    wider = [replace(piece, kept_low=0.42, kept_high=1.45) for piece in wide]  # enough only in pieces of 40 m
    by_look = "an operator's look at what was not measured, at least 100 of 100 m; whoever signs decides by that"
    for pieces, run in ((wide, 10.0), (whole_seams, 50.0), (wider, 50.0)):
        words = text_of(decide(replace(made, pieces=tuple(pieces)), rules(run=run)))
        assert by_look in words
        assert "a scan with pieces" not in words
    assert "with pieces of 40 m" in text_of(decide(replace(made, pieces=tuple(wider)), rules(run=80.0)))


def test_what_was_measured_rejects_where_the_rest_could_not_save_it() -> None:
    """30 of 100 m failed, and 20 were not measured: 30 % even if they are sound; at 1 of 40 it is 2.5 %."""
    assert decide(delivery(seam([0.4] * 3 + [0.9] * 5 + [None] * 2)), rules()).outcome is REJECTED
    seams = seam([0.4]), seam([0.9] * 31 + [None] * 8, seam_id="2", start=(0, 50), number=1)
    assert decide(delivery(*seams), rules(share=0.024)).outcome is REJECTED
    assert decide(delivery(*seams), rules(share=0.026)).outcome is UNDECIDED  # 3.1 % of what was measured


def test_pieces_too_coarse_for_what_may_fail_leave_it_open() -> None:
    """40 of 1600 m failed inside of a seam and 32 m may. Pieces of 20 m leave 16 m of that open, those of 2 m 1.6 m."""
    coarse = decide(delivery(seam([0.9] * 30 + [0.4] * 2 + [0.9] * 48, 20.0)), rules())
    assert (coarse.outcome, coarse.whole.failed_m) == (UNDECIDED, 40)
    assert "with pieces of 20 m the failed length is known only to 16 m, and 32 m may fail" in text_of(coarse)
    assert decide(delivery(seam([0.9] * 300 + [0.4] * 20 + [0.9] * 480, 2.0)), rules()).outcome is REJECTED
    whole_seam = seam([0.4] * 2, 20.0), seam([0.9] * 78, 20.0, seam_id="2", start=(0, 50), number=2)
    assert decide(delivery(*whole_seam), rules()).outcome is REJECTED  # it ends where the seam does
    assert decide(delivery(seam([0.9] * 80, 20.0)), rules()).outcome is ACCEPTED


def test_ground_without_detail_is_no_part_of_what_is_judged() -> None:
    """26 of 100 pieces on smooth fields leave 74, all of which were measured."""
    smooth = [replace(piece, kept_1=None, verdict="not_comparable", has_detail=False) for piece in seam([None] * 26)]
    sound = seam([0.98] * 74, seam_id="2", start=(0, 50), number=26)
    decision = decide(delivery(smooth, sound), rules())
    assert decision.outcome is ACCEPTED
    assert (decision.whole.total_m, decision.whole.no_detail_m, decision.whole.judged_m) == (1000, 260, 740)
    assert decision.whole.measured_share == 1
    assert "260 of 1000 m of seam lie on ground without detail" in text_of(decision)
    nothing = decide(delivery(smooth), rules())
    assert (nothing.outcome, nothing.whole.measured_share) == (UNDECIDED, 0)
    assert "an operator's look" in text_of(nothing)


def test_a_share_that_intervals_leave_open_is_undecided() -> None:
    """Pieces of 0.65 [0.55, 0.76]: each as likely as not on the other side; surely failed ones decide."""
    unclear = [replace(piece, kept_low=0.55, kept_high=0.76) for piece in seam([0.65] * 3 + [0.95] * 97)[:3]]
    rest = seam([0.95] * 97, start=(30, 0), number=3)
    decision = decide(delivery(unclear, rest), rules(run=None))
    assert (decision.outcome, decision.whole.failed_m) == (UNDECIDED, 30)  # by value, as anybody adds it up
    assert "an operator's look at the pieces whose intervals include the limit (30 m, pieces: 3)" in text_of(decision)
    assert decision.outcomes[0].low < 0.02 < decision.whole.failed_share < decision.outcomes[0].high
    assert decide(delivery(sure(unclear), rest), rules(run=None)).outcome is REJECTED
    row = [replace(item, kept_low=0.6, kept_high=0.79) for item in seam([0.69] * 8)]  # one that passed would break it
    assert decide(delivery(row), rules(share=1.0)).outcome is UNDECIDED
    assert decide(delivery(sure(row)), rules(share=1.0)).outcome is REJECTED
    feather = [replace(item, kept_low=0.5, kept_high=0.72) for item in seam([0.6] * 8)]  # it keeps 0.57 to 0.64
    assert decide(delivery(feather), rules(share=1.0)).outcome is REJECTED


@pytest.mark.parametrize(("count", "failed", "low", "cover", "outcome"), [
    (3, 0, None, LACKING, UNDECIDED), (2, 0, None, LACKING, ACCEPTED), (3, 3, None, LACKING, REJECTED),
    (3, 2, None, LACKING, UNDECIDED), (3, 0, None, SHORT, ACCEPTED), (3, 0, 0.5, LACKING, ACCEPTED),
    (3, 0, None, SHORT._replace(is_short=False, both=0.2), UNDECIDED), (50, 0, 0.5, LACKING, UNDECIDED),
    (3, 0, None, SHORT._replace(is_short=False), UNDECIDED),
])  # fmt: skip
def test_what_orthoimages_do_not_show_counts_as_the_worst_that_it_may_be(
    count: int, failed: int, low: float | None, cover: SeamCover, outcome: AcceptanceOutcome
) -> None:
    """Two of 100 pieces may fail. With an interval a piece fails as likely as that says: 16 % of [0.5, 2]. Short pieces
    are left to the share that has to be measured, others are not, be they shown by both orthoimages or cut from both.
    """
    blank = [replace(item, kept_1=None, kept_low=None, kept_high=None) for item in seam([0.9] * count)]
    rough = [replace(item, kept_1=1.0, kept_low=low, kept_high=2.0, verdict="not_comparable") for item in blank]
    rest = seam([0.3] * failed + [0.95] * (100 - count - failed), 10, "a", "2", (0, 99), number=count)
    made = delivery(blank if low is None else rough, rest)
    made = replace(made, files=replace(made.files, cover=dict.fromkeys(range(count), cover)))
    decision = decide(made, rules(run=None, measured=0.4))
    assert decision.outcome is outcome
    assert decision.whole.not_measured_m == 10 * count


@pytest.mark.parametrize(("count", "outcome"), [(2, ACCEPTED), (4, UNDECIDED)])
def test_a_piece_that_passed_by_a_part_hides_what_orthoimages_do_not_show(
    count: int, outcome: AcceptanceOutcome
) -> None:
    made = delivery(seam([0.95] * 100))
    made = replace(made, files=replace(made.files, cover=dict.fromkeys(range(count), SeamCover(0.2, 0.2))))
    assert decide(made, rules(run=None)).outcome is outcome


def test_layers_that_lack_seams_are_not_accepted() -> None:
    layer = DeliveredLayer("north", Seal.BROKEN, 40.0, {})
    made = replace(delivery(seam([0.95] * 40)), layers=(layer,))
    decision = decide(made, rules())
    assert decision.outcome is UNDECIDED
    assert "40 m of seam are missing" in str(decision.sentences[0])
    lost = decide(replace(made, pieces=tuple(seam([0.4] * 40))), rules())
    assert lost.outcome is REJECTED
    for opened in (decision, lost, decide(replace(made, layers=(replace(layer, lacking_m=0.0),)), rules())):
        assert str(opened.sentences[0]).endswith(" layers of seams were changed since their scan: 1 (north).")
        assert opened.outcome is not ACCEPTED
    whole = decide(replace(made, layers=(replace(layer, seal=Seal.WHOLE, lacking_m=0.0),)), rules())
    assert whole.outcome is ACCEPTED
    assert "as their scans left them" in text_of(whole)


def test_sheets_are_decided_by_the_same_limits() -> None:
    sound, lost = seam([0.95] * 59), seam([0.4] * 2, sheet="b", start=(0, 99), number=59)
    rest = seam([0.95] * 38, sheet="b", seam_id="2", start=(0, 200), number=61)
    unknown = seam([0.95] + [None] * 9, sheet="c", start=(0, 300), number=99)
    decision = decide(delivery(sound, lost, rest, unknown), rules(share=0.02, run=100.0))
    assert decision.sheet_outcomes == (ACCEPTED, REJECTED, UNDECIDED)
    assert decision.whole.failed_share == pytest.approx(0.02)
    assert decision.outcome is ACCEPTED  # of 109 pieces 100 were measured
    north = seam([0.4] * 3 + [0.95] * 200, 10, "b", "2", (0, 2030), (0, 1), 203)
    decision = decide(delivery(seam([0.95] * 200 + [0.4] * 3, way=(0, 1)), north), rules())
    assert (decision.outcome, decision.sheet_outcomes) == (REJECTED, (REJECTED, REJECTED))  # by one failure of 60 m


def test_sheets_that_were_not_measured_alike_are_told() -> None:
    lengths = {"a": "10", "b": "25"}
    sheets = [DeliveredLayer(name, Seal.WHOLE, 0.0, {"piece_m": length}) for name, length in lengths.items()]
    decision = decide(replace(delivery(seam([0.95] * 40)), layers=tuple(sheets)), rules())
    assert "measured with different settings: piece_m is 10, 25" in text_of(decision)


@pytest.mark.parametrize(("piece", "limit", "accepted"), [
    (37.5, 50.0, True), (37.5, 25.0, True), (80.0, 50.0, None), (200.0, 50.0, None), (200.0, 0.0, True)
])  # fmt: skip
def test_a_piece_that_is_longer_than_a_failure_may_be_hides_it(piece: float, limit: float, accepted: bool) -> None:
    """A single long one of many is enough, and where none may fail its length does not matter."""
    made = delivery(seam([0.95] * 400), seam([0.95], piece, seam_id="2", start=(0, 99), number=400))
    decision = decide(made, rules(run=limit))
    assert decision.accepted is accepted
    if not accepted:
        assert f"pieces are up to {piece:.1f} m long, which can hide a longer one" in str(decision.sentences[0])
        assert "pieces of 25 m or less" in text_of(decision)
        assert "look at the rows" not in text_of(decision)


@pytest.mark.parametrize(
    ("kept", "low", "high", "with_verdict", "without"),
    [
        (0.5, 0.2, 0.9, PieceState.NOT_MEASURED, PieceState.NOT_MEASURED),  # more than a factor of two
        (0.54, 0.18, 1.5, PieceState.NOT_MEASURED, PieceState.NOT_MEASURED),
        (0.5, 0.1, 0.65, PieceState.FAILED, PieceState.FAILED),  # wide, but all below the limit
        (1.1, 0.7, 2.0, PieceState.PASSED, PieceState.PASSED),
        (0.6, 0.5, 0.72, PieceState.FAILED, PieceState.NOT_MEASURED),
        (0.65, 0.55, 1.05, PieceState.NOT_MEASURED, PieceState.NOT_MEASURED),  # nothing may be lost at all
        (0.75, 0.6, 1.1, PieceState.PASSED, PieceState.NOT_MEASURED),
        (0.5, None, None, PieceState.FAILED, PieceState.NOT_MEASURED),
    ],
)
def test_a_number_is_measured_where_its_interval_says_something(
    kept: float, low: float | None, high: float | None, with_verdict: PieceState, without: PieceState
) -> None:
    (piece,) = seam([kept])
    for verdict, state in (("reduced", with_verdict), ("not_comparable", without)):
        judged = replace(piece, kept_low=low, kept_high=high, verdict=verdict)
        assert decide(delivery([judged]), rules()).pieces[0].state is state


@pytest.mark.parametrize(("failed", "accepted"), [(2, True), (3, False)])
def test_a_plan_decides_by_its_number(failed: int, accepted: bool) -> None:
    kept = [0.4] * failed + [0.9] * (80 - failed)
    decision = decide(delivery(seam(kept)), rules(None, None, sampling=SAMPLING), lot_size=1000)
    assert decision.accepted == accepted
    assert (decision.plan.plan.sample_size, decision.plan.plan.acceptance_number) == (80, 2)
    assert (decision.plan.inspected, decision.plan.nonconforming) == (80, failed)
    assert f"{failed} of 80 inspected pieces failed" in str(decision.sentences[0])


def test_a_sample_is_drawn_with_its_seed() -> None:
    made = delivery(seam([0.4] * 30 + [0.9] * 970))
    first, again, other = (
        decide(made, rules(None, None, sampling=SAMPLING), seed=seed) for seed in (1, 1, 2)
    )
    assert first.plan == again.plan
    assert (other.plan.seed, other.plan.inspected) == (2, 80)
    assert first.whole.failed_m == 300  # the figures are of all that was measured


def test_a_sample_that_lacks_pieces_decides_only_what_they_can_not_change() -> None:
    def passed(failed: int, missing: int) -> bool | None:
        kept = [0.4] * failed + [None] * missing + [0.9] * (80 - failed - missing)
        pieces = [replace(piece, sample_number=place + 1) for place, piece in enumerate(seam(kept))]
        made = replace(delivery(pieces), lot_size=1000)
        return decide(made, rules(None, None, measured=0, sampling=SAMPLING)).outcomes[0].passed

    assert (passed(1, 1), passed(1, 2), passed(3, 5)) == (True, None, False)


@pytest.mark.parametrize("sampling", [None, SAMPLING])
def test_a_sample_does_not_tell_how_long_failures_are(sampling: SamplingRule | None) -> None:
    pieces = [replace(piece, sample_number=place + 1) for place, piece in enumerate(seam([0.4] + [0.9] * 79))]
    part = replace(delivery(pieces), lot_size=1000)
    decision = decide(part, rules(share=0.02, run=50.0, sampling=sampling))
    outcome = next(outcome for outcome in decision.outcomes if outcome.check == "longest_failure")
    assert (outcome.passed, outcome.value, decision.outcome) == (None, None, UNDECIDED)
    assert decision.longest_failure_m is None
    assert {sheet.longest_failure_m for sheet in (decision.whole, *decision.sheets)} == {None}
    assert "can't be determined from a sample" in str(decision.sentences[0])
    assert "a sample of 80 pieces" in text_of(decision)
    assert "the layers of the whole scan" in text_of(decision)
    assert decide(part, rules(share=0.02, run=None, sampling=sampling)).accepted  # the share can be estimated
    too_long = next(outcome for outcome in decide(part, rules(run=5.0)).outcomes if outcome.check == "longest_failure")
    assert too_long.passed is False  # what the sample shows is at least as long in the delivery
    whole = decide(replace(part, lot_size=80), rules(share=0.02, run=50.0))
    assert whole.accepted
    assert whole.longest_failure_m == whole.runs[0].length_m


def test_too_small_a_sample_is_undecided() -> None:
    decision = decide(delivery(seam([0.9] * 40)), rules(None, None, sampling=SAMPLING), lot_size=1000)
    assert decision.outcome is UNDECIDED
    assert "needs a sample of 80 pieces and 40 were measured" in str(decision.sentences[0])


def test_a_lot_smaller_than_its_pieces_is_refused() -> None:
    with pytest.raises(SettingsError, match="The lot size is 10 and the layers hold 40 pieces"):
        decide(delivery(seam([0.9] * 40)), rules(None, None, sampling=SAMPLING), lot_size=10)


@pytest.mark.parametrize(
    ("row", "longest", "outcome"),
    [
        ([None] * 5, 50, ACCEPTED), ([None] * 6, 60, UNDECIDED), ([None] * 4 + [0.4] * 2, 60, UNDECIDED),
        ([0.4] * 6 + [None], 70, REJECTED), ([None] * 4 + [0.9] + [None] * 4, 40, ACCEPTED),
    ],
)
def test_a_row_of_pieces_without_a_measurement_may_be_a_failure(
    row: list[float | None], longest: float, outcome: AcceptanceOutcome
) -> None:
    decision = decide(delivery(seam([0.95] * 200 + row + [0.95] * 200)), rules())
    assert decision.outcome is outcome
    assert decision.whole.longest_unknown_m == longest
    assert [run.length_m for run in decision.unknown_runs] == ([] if longest <= 50 else [longest])
    if outcome is UNDECIDED:
        (rule,) = (outcome for outcome in decision.outcomes if outcome.check == LONGEST_FAILURE)
        assert (rule.passed, rule.high) == (None, longest)
        assert decision.unknown_runs[0].place == pytest.approx((2000 + longest / 2, 0))
        assert "What would decide it: measuring at least" in text_of(decision)


def test_how_much_of_what_failed_is_unclear_is_a_number() -> None:
    decision = decide(delivery(seam([0.68, 0.72, 0.4, 0.4, 0.9])), rules())
    assert (decision.whole.failed_m, decision.whole.failed_unclear_m, decision.whole.unclear_m) == (30, 10, 20)


@pytest.mark.parametrize("kept", [0.95, 0.3])
def test_two_scans_of_one_mosaic_decide_nothing(kept: float) -> None:
    """Each metre would count twice; a layer that is given under two names counts once."""
    files = {MOSAIC_FILES: states_text([("/m.tif", FileState(1, 0, "d"))])}
    first, second = (DeliveredLayer(name, Seal.WHOLE, 0.0, files, digest=name) for name in "ab")
    pieces = delivery(sure(seam([kept] * 20)))
    for layers, count in ((first, second), 2), ((first, replace(first, name="b")), 0):
        made = replace(pieces, layers=layers)
        doubts = replace(file_doubts(made, (), ()), gone=())
        decision = decide(replace(made, files=doubts), rules())
        assert (decision.outcome is UNDECIDED) is bool(count)
        assert ("different scans of one mosaic are given: 2 (a, b)" in str(decision.sentences[0])) is bool(count)


def test_what_nobody_has_looked_at_is_not_passed_over() -> None:
    """A scan that could not read all, sheets out of the mosaic or hidden in it, sheets of which nothing is known."""
    sound = delivery(seam([0.95] * 100))
    assert decide(sound, rules()).outcome is ACCEPTED
    read = DeliveredLayer("a", True, 0.0, {"unread": "0.004", "unread_at": "10 20"})
    blank = replace(read, name="b", settings={}, is_blank=True)
    unknown = seam([None], sheet="b", start=(0, 99), number=100)
    for words, unseen in (
        ("0.40% of the mosaic of 'a' could not be read, such as around 10 20", replace(sound, layers=(read,))),
        ("sheets of which nothing was measured: 1 (b)", replace(sound, layers=(blank,))),
        ("sheets of which nothing was measured: 1 (b)", delivery(seam([0.95] * 100), unknown)),
        ("missing in the mosaic that was scanned: 1 (x)", with_sheet(sound, SheetState.LEFT_OUT)),
        ("whose pixels can't all be read: 1 (x)", with_sheet(sound, SheetState.DAMAGED)),
        ("which nobody has checked: 1 (x)", with_sheet(sound, SheetState.OVERLAPS)),
    ):  # fmt: skip
        decision = decide(unseen, rules())
        assert decision.outcome is UNDECIDED
        assert words in str(decision.sentences[0])
        assert "What would decide it: a scan of all sheets" in str(decision.sentences[1])
    for state in (SheetState.SHOWN, SheetState.NOT_ORDERED):
        assert decide(with_sheet(sound, state), rules()).outcome is ACCEPTED


def with_sheet(made: Delivery, state: SheetState) -> Delivery:
    return replace(made, outlines=(SheetOutline("a", b""), SheetOutline("x", b"", state=state)))


def test_a_corner_of_a_sheet_in_one_scan_of_many_is_no_sheet_by_itself() -> None:
    """40 m that could not be measured, less than may fail without a break; with 60 m nobody knows the sheet."""
    for count, outcome in ((4, ACCEPTED), (6, UNDECIDED)):
        corner = seam([None] * count, sheet="b", start=(0, 99), number=200)
        made = replace(delivery(seam([0.95] * 200), corner), outlines=(SheetOutline("a", b""), SheetOutline("b", b"")))
        assert decide(made, rules(measured=0.5)).outcome is outcome
