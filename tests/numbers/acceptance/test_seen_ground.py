"""What scans saw beside the seams of a delivery is held against them."""
from __future__ import annotations

from dataclasses import replace

import pytest
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.decision import AcceptanceOutcome, Decision
from seam_inspector.plugin.acceptance.measure.delivered_rows import united_settings
from seam_inspector.plugin.acceptance.measure.delivery import DeliveredLayer, Seal
from seam_inspector.plugin.acceptance.measure.seen_ground import SeenGround
from seam_inspector.plugin.imagery.seam_totals import MOSAIC_FILES

from tests.numbers.acceptance.deliveries import delivery, rules, seam

SOUND = [0.97] * 100  # 1 km
PLACE = "500036.8 4999944 6 102"


def decided(*scans: dict[str, str], share: float | None = 0.02, run: float | None = 50.0) -> Decision:
    """On a kilometre of sound seam, by what its scans say."""
    layers = tuple(DeliveredLayer(f"sheet {number}", True, 0.0, said) for number, said in enumerate(scans))
    return decide(replace(delivery(seam(SOUND)), layers=layers), rules(share=share, run=run))


def said(**figures: str) -> dict[str, str]:
    return {"seams": "found", "unexplained": "0.0000", **figures}


@pytest.mark.parametrize(("unseen", "outcome"), [(40, AcceptanceOutcome.ACCEPTED), (60, AcceptanceOutcome.UNDECIDED)])
def test_borders_that_no_seam_tells_of_leave_it_open(unseen: int, outcome: AcceptanceOutcome) -> None:
    decision = decided(said(unseen_metres=f"{unseen}.0", unseen_longest="20.0", unseen_at=PLACE))
    assert decision.outcome is outcome
    sentences = " ".join(map(str, decision.sentences))
    assert ("500036.8, 4999944.0 (6 x 102 m)" in sentences) is (outcome is AcceptanceOutcome.UNDECIDED)


def test_lines_along_which_nothing_changes_leave_it_open() -> None:
    decision = decided(said(seams="given", unchanged_metres="60.0"))
    assert decision.outcome is AcceptanceOutcome.UNDECIDED
    assert "m of seam that are judged both sides show the same orthoimage" in str(decision.sentences[0])


def test_one_border_longer_than_a_failure_may_be_leaves_it_open() -> None:
    long = said(unseen_metres="51.0", unseen_longest="51.0", unseen_at=PLACE)
    decision = decided(said(), long)
    assert decision.outcome is AcceptanceOutcome.UNDECIDED
    assert "along 51 m around 500036.8, 4999944.0 (6 x 102 m)" in str(decision.sentences[0])
    assert decided(said(unseen_metres="49.0", unseen_longest="49.0")).accepted


@pytest.mark.parametrize(("hidden", "accepted"), [("15.0", True), ("25.0", None)])
def test_a_border_that_nothing_explains_counts_as_if_it_failed(hidden: str, accepted: bool | None) -> None:
    decision = decided(said(unseen_metres=hidden, unseen_longest="12.0", hidden_metres=hidden, hidden_longest="12.0",
                         hidden_at=PLACE))
    assert decision.accepted is accepted
    assert ("neither explains the mosaic" in str(decision.sentences[0])) == (accepted is None)


@pytest.mark.parametrize("seams", ["given", "found"])
def test_ground_that_no_orthoimage_explains_leaves_it_open_by_its_area(seams: str) -> None:
    layer = DeliveredLayer("a", True, 0.0, said(seams=seams, unexplained="0.5"))
    decision = decide(replace(delivery(seam(SOUND)), layers=(layer,)), rules())
    assert decision.outcome is AcceptanceOutcome.UNDECIDED
    assert "50% of the mosaic of 'a' match no orthoimage" in str(decision.why)
    assert "What would decide it: a scan with the orthoimages that are missing" in str(decision.sentences[1])


@pytest.mark.parametrize("kept", [0.97, 0.3])
def test_a_mosaic_that_lies_beside_its_orthoimages_is_not_decided_on(kept: float) -> None:
    """Nothing is missing then, and what was measured may be of other ground: that neither accepts nor rejects."""
    layer = DeliveredLayer("a", True, 0.0, said(unexplained="0.43", mosaic_shift="1.50 -0.01"))
    decision = decide(replace(delivery(seam([kept] * 100)), layers=(layer,)), rules())
    assert decision.outcome is AcceptanceOutcome.UNDECIDED
    assert str(decision.sentences[0]) == (
        "Undecided by 'contract': the mosaic of 'a' does not lie where its orthoimages do: it lies +1.50 m to the "
        "east, -0.01 m to the north of all of them."
    )
    assert "a scan of mosaic and orthoimages that lie in the same place" in str(decision.sentences[1])


def test_an_orthoimage_that_is_named_and_was_not_given_is_the_first_reason() -> None:
    """It lies beside 20 of 100 pieces, where the mosaic follows no orthoimage; nothing else is in the headline."""
    scan = said(seams="given", not_given="cam2_101", unexplained="0.13", unexplained_border="30.0")
    pieces = seam([0.97] * 80 + [None] * 20)
    decision = decide(replace(delivery(pieces), layers=(DeliveredLayer("a", True, 0.0, scan),)), rules())
    assert str(decision.sentences[0]) == (
        "Undecided by 'contract': orthoimages that the seamlines name were not given to the scan (cam2_101), so seams "
        "beside them are not measured."
    )
    assert "What would decide it: a scan with the orthoimages that are missing" in str(decision.sentences[1])
    assert str(decision.sentences[2]).startswith("Open besides: 13% of the mosaic of 'a' match no orthoimage")
    assert str(decision.why).startswith(str(decision.foremost))
    assert decided(said(not_given="cam2_101")).accepted  # enough was measured without it


def test_an_orthoimage_that_may_be_a_copy_leaves_it_open() -> None:
    decision = decided(said(may_be_copies="extra.tif"))
    assert decision.outcome is AcceptanceOutcome.UNDECIDED
    assert "they hide what it lost: extra.tif" in str(decision.why)
    assert "the complete orthoimages as rectified" in str(decision.sentences[1])


def test_sheets_that_were_scanned_apart_are_told() -> None:
    def sentences(*mosaics: str) -> str:
        return " ".join(map(str, decided(*(said(**{MOSAIC_FILES: mosaic}) for mosaic in mosaics)).sentences))

    words = "2 mosaics were scanned one by one: seams on their borders do not count, where they overlap twice"
    assert words in sentences('[["a.tif", 1, 2, "3"]]', '[["b.tif", 1, 2, "3"]]')
    assert "one by one" not in sentences('[["a.tif", 1, 2, "3"]]', '[["a.tif", 1, 2, "3"]]')


def test_all_scans_together() -> None:
    layers = tuple(
        DeliveredLayer(name, True, 0.0, said(**figures)) for name, figures in (
            ("a", {"unseen_metres": "12.5, 7.5", "unseen_longest": "12.5, 7.5", "unseen_at": PLACE,
                   "looked_at": "0.4"}),
            ("b", {"unseen_metres": "30", "unseen_longest": "9", "unseen_at": "1 2", "seams": "given",
                   "unchanged_metres": "5", "nodata_inside": "0.01", "nodata_at": f"{PLACE}; 7 8 9 10"}),
        )
    )  # fmt: skip
    ground = SeenGround.of_delivery(replace(delivery(seam(SOUND)), layers=layers))
    assert (ground.total("unseen_metres"), ground.total("unchanged_metres")) == (50, 5)
    assert (ground.most("unseen_longest"), ground.looked_at) == (12.5, 0.4)
    assert ground.place("unseen_at", "unseen_longest") == "500036.8, 4999944.0 (6 x 102 m)"
    assert ground.place("nodata_at", "nodata_inside").endswith("(6 x 102 m)")


def test_a_sample_of_several_scans_says_what_they_say_together() -> None:
    """Two scans with the same metres, and with shares that are not the same."""
    scans = [DeliveredLayer("a", Seal.WHOLE, 0.0, said(unread=unread, unexplained=unread, **dict.fromkeys(
        ("unexplained_border", "unseen_metres", "hidden_metres", "unchanged_metres"), "12.5"))) for unread in "12"]
    united = DeliveredLayer("sample", Seal.WHOLE, 0.0, united_settings(scans))
    ground = SeenGround((united.settings,))
    assert (ground.most("unread"), ground.most("unexplained"), ground.total("unexplained_border")) == (2, 2, 25)
    assert [*map(ground.total, ("unseen_metres", "hidden_metres", "unchanged_metres"))] == [25, 25, 25]


def test_orthoimages_that_hold_the_mosaic_along_seams_are_not_accepted() -> None:
    mixed = said(mixed_sources="a.tif, b.tif", mixed_metres="99.5", mixed_at="500036.8 4999944")
    decision = decided(mixed, said())
    assert decision.outcome is AcceptanceOutcome.UNDECIDED
    words = "along 100 m of seam the mosaic is mixed into the orthoimages (a.tif, b.tif), which hides what it lost"
    assert words in str(decision.sentences[0])
    assert "complete orthoimages as rectified" in str(decision.sentences[1])
    both = SeenGround.of_delivery(decided(mixed, mixed).delivery)
    assert both.total("mixed_metres") == 199
    assert both.place("mixed_at", "mixed_metres") == "500036.8, 4999944.0"
