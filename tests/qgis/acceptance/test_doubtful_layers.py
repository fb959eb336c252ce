"""Layers of seams that say what can't be meant: a sentence, and no decision on a guess."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsGeometry, QgsVectorLayer

from tests.qgis.acceptance.seam_scenes import UTM33, X, Y, file, seams, straight
from tests.qgis.runs import Run, assert_refused, run
from tests.qgis.scenes import layer

pytestmark = pytest.mark.usefixtures("provider")

F, P = 0.5, 0.95


def decide(*layers: QgsVectorLayer | str, **parameters: Any) -> Run:
    wanted = {"DEFECTS": None, "REPORT": None, "QUALITY": None, "CHART": None, **parameters}
    return run("acceptmosaic", SEAMS=list(layers), **wanted)


def pieces(count: int = 10, **fields: tuple[str, list[Any]]) -> QgsVectorLayer:
    made = layer("LineString", [straight(25 * place, 25) for place in range(count)], UTM33, **fields)
    made.setName("s")
    return made


def warned(outcome: Run, words: str) -> bool:
    return any(words in said for said in outcome.log.warnings)


def test_percent_is_no_share() -> None:
    given = pieces(3, kept_1=("double", [86.0, 50.0, 30.0]))
    assert_refused("acceptmosaic", "kept_1 in s is 50 in the middle.* write 86 % as 0.86", SEAMS=[given])


def test_a_sheet_has_the_whole_name_of_its_file(tmp_path: Path) -> None:
    """Sheets of maps are numbered with dots."""
    whole, spoilt = [file(seams([kept] * 3, y=50 * place), tmp_path / f"6.131.{place}.gpkg")
                     for place, kept in enumerate((P, 86.0))]  # fmt: skip
    assert_refused("acceptmosaic", "kept_1 in 6.131.1 is 86", SEAMS=[whole, spoilt])


def test_shares_that_can_not_be_are_told() -> None:
    outcome = decide(pieces(kept_1=("double", [-1.0, 7.5, 1e308] + [P] * 7)))
    assert warned(outcome, "kept_1 of 1 pieces of s is below 0")
    assert warned(outcome, "kept_1 of 2 pieces of s is more than a seam can keep (up to 1e+308); they count as not m")
    assert outcome.results["MEASURED_METRES"] == pytest.approx(175, rel=1e-3)
    assert outcome.results["FAILED_METRES"] == 0
    comma = decide(pieces(kept_1=("string", ["1,0", "0,5"] + ["0.9"] * 8)))
    assert warned(comma, "kept_1 of 2 pieces of s is not a number (such as '1,0'")
    assert comma.results["DECISION"] == "undecided"


def test_what_a_scan_could_not_compare_is_no_doubt() -> None:
    """Its interval is wide without orthoimages, and nothing is claimed there; where it is, the number is told."""
    verdicts = ("string", ["not_comparable"] + ["preserved"] * 9)
    assert not warned(decide(pieces(kept_1=("double", [7.5] + [P] * 9), verdict=verdicts)), "more than a seam")
    claimed = decide(pieces(kept_1=("double", [7.5, 4.0] + [P] * 8), verdict=verdicts))
    assert warned(claimed, "kept_1 of 1 pieces of s is more than a seam can keep (up to 4)")


def test_a_length_that_the_line_does_not_have_is_told() -> None:
    outcome = decide(pieces(kept_1=("double", [P] * 10), length=("double", [1e9] + [25.0] * 9)))
    assert warned(outcome, "length of 1 pieces of s differs from their lines (at worst 1e+09 m")
    assert not warned(decide(seams([P] * 10)), "says something else")


@pytest.mark.parametrize("length", [0.0, -3.0, None])
def test_a_piece_without_a_length_has_that_of_its_line(length: float | None) -> None:
    lengths = [25.0] * 3 + [length] + [25.0] * 6
    outcome = decide(pieces(kept_1=("double", [P] * 3 + [F] + [P] * 6), length=("double", lengths)))
    assert outcome.results["TOTAL_METRES"] == pytest.approx(250, rel=1e-3)
    assert outcome.results["FAILED_METRES"] == pytest.approx(25, rel=1e-3)


def test_a_sheet_under_two_names_counts_once(tmp_path: Path) -> None:
    made = seams([P] * 6 + [F] * 2 + [P] * 2)
    twice = [file(made, tmp_path / name) for name in ("a.gpkg", "b.gpkg")]
    outcome = decide(*twice)
    assert warned(outcome, "10 pieces of seam are given twice")
    assert (outcome.results["TOTAL_METRES"], outcome.results["LONGEST_FAILURE"]) == pytest.approx((250, 50), rel=1e-3)


def test_sheets_that_were_scanned_with_overlap_are_told() -> None:
    west = seams([P] * 10, name="west")
    east = seams([P] * 10, start=187, y=0.03, name="east")
    outcome = decide(west, east)
    (said,) = (text for text in outcome.log.warnings if "lie on other seams" in text)
    assert "in east, west" in said
    assert float(said.split()[0]) == pytest.approx(63, abs=6)
    assert not warned(decide(west, seams([P] * 10, start=250, name="east")), "lie on other seams")
    assert not warned(decide(west, seams([P] * 10, y=3, name="beside")), "lie on other seams")


def boxes(side: float = 25, **fields: tuple[str, list[Any]]) -> QgsVectorLayer:
    count = len(next(iter(fields.values()))[1])
    made = layer("Polygon", [straight(25 * place, 25).buffer(side / 2, 1).orientedMinimumBoundingBox()[0]
                             for place in range(count)], UTM33, **fields)
    made.setName("w")
    return made


def test_windows_that_nobody_judged_decide_nothing() -> None:
    given = {"SEAMS": [seams([P] * 4)], "JUDGE": "observer"}
    outcome = run("acceptmosaic", WINDOWS=boxes(window_id=("integer", [1, 2, 3, 4])), REPORT=None, **given)
    assert outcome.complaint is not None
    assert "None of the 4 windows was judged; judge them in the desk and save the edits" in outcome.complaint


def test_windows_that_say_nothing_are_told() -> None:
    made = seams([P, F] * 4)
    assert warned(decide(made, WINDOWS=boxes(name=("string", ["a", "b"]))), "windows in w were neither inspected")
    outcome = decide(made, WINDOWS=made)
    assert "seams holds no windows" in str(outcome.complaint)


def test_windows_much_wider_than_the_pieces_are_told() -> None:
    for side, told in ((100, True), (20, False)):
        outcome = decide(seams([P] * 4), WINDOWS=boxes(side, observer=("string", ["invisible"] * 4)), JUDGE="observer")
        assert warned(outcome, "a piece fails by what was seen beside it") == told


def test_metres_of_web_mercator_are_those_on_the_ground() -> None:
    mercator = seams([P, F, F], epsg=3857, with_length=False)
    assert decide(mercator).results["TOTAL_METRES"] == pytest.approx(75, rel=1e-3)


def test_the_order_of_layers_decides_nothing() -> None:
    one, other = seams([F] * 6 + [P] * 144, name="one"), seams([P] * 150, y=500, name="other")
    for seed in range(8):
        found = [decide(*given, PLAN="iso2859", SEED=seed).log.infos[0] for given in ((one, other), (other, one))]
        assert found[0] == found[1]
    planned = [
        run("planinspection", SEAMS=given, PLAN="count", COUNT=41, OUTPUT="TEMPORARY_OUTPUT").rows()
        for given in ([one, other], [other, one])
    ]
    drawn = [[(row["sheet"], row["station"]) for row in rows] for rows in planned]
    assert drawn[0] == drawn[1]


def test_pieces_that_lie_nowhere_are_missed(tmp_path: Path) -> None:
    """Their figures are in the layer, and no second person could find them on the ground."""
    made = seams([P] * 30 + [F] * 2 + [P] * 30)
    made.dataProvider().changeGeometryValues({
        row.id(): QgsGeometry.fromWkt("LINESTRING(0 0, 0 0)") for row in made.getFeatures() if row["kept_1"] == F
    })  # fmt: skip
    outcome = decide(made)
    assert outcome.results["DECISION"] == "undecided"
    assert warned(outcome, "features without a line are left out (2)")
    assert warned(outcome, "lacks 50 m of seam")


@pytest.mark.parametrize(("date", "is_one"), [("2026-02-30", False), ("soon", False), ("2.11.2026", True), ("", True)])
def test_the_date_of_a_delivery_is_one(date: str, is_one: bool) -> None:
    said = decide(seams([P] * 4), DELIVERY_DATE=date).complaint
    assert said is None if is_one else f"DELIVERY_DATE is '{date}', which is no date" in str(said)


def test_a_sheet_without_a_name_is_refused() -> None:
    box = f"POLYGON(({X} {Y - 9}, {X + 99} {Y - 9}, {X + 99} {Y + 9}, {X} {Y + 9}, {X} {Y - 9}))"
    sheets = layer("Polygon", [QgsGeometry.fromWkt(box)], UTM33, sheet=("string", [None]))
    refused = decide(seams([P] * 4), SHEETS=sheets)
    assert str(refused.complaint) == "The sheet no. 1 has no name in the field sheet; write it there."


def test_a_sheet_of_which_nothing_was_measured_is_not_passed_over(tmp_path: Path) -> None:
    """Its layer is empty, as that of a scan that could read nothing was."""
    good = seams([0.97] * 100, name="good")
    broken = layer("LineString", [], UTM33, kept_1=("double", []), verdict=("string", []))
    broken.setName("broken")
    assert run("acceptmosaic", SEAMS=[good]).results["DECISION"] == "accepted"
    found = run("acceptmosaic", SEAMS=[good, broken])
    assert found.results["DECISION"] == "undecided"
    told = found.log.infos + found.log.warnings
    assert any("sheets of which nothing was measured: 1 (broken)" in one for one in told)
