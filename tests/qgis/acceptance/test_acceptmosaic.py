"""``acceptmosaic`` as QGIS runs it: its contract, its arithmetic, its rules, and bad input."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsGeometry, QgsRectangle, QgsVectorLayer

from tests.pages import outline
from tests.qgis.acceptance.seam_scenes import UTM33, decide, decision, file, seams, straight
from tests.qgis.runs import Run, assert_refused, assert_sentence
from tests.qgis.scenes import layer

pytestmark = pytest.mark.usefixtures("provider")

NUMBERS = ("ACCEPTED", "TOTAL_METRES", "MEASURED_METRES", "FAILED_METRES", "FAILED_SHARE", "LONGEST_FAILURE")
F, P = 0.5, 0.95
RUN = {"check": "longest_failure", "most": 60, "source": "x"}
READY = Path(__file__).parents[3] / "resources" / "rules" / "acceptance"


def numbers(outcome: Run) -> dict[str, float]:
    assert outcome.complaint is None
    return {name: outcome.results.get(name) for name in NUMBERS}


def test_metres_share_and_longest_failure() -> None:
    outcome = decide(seams([P] * 90 + [0.1, F, P, F, 0.1, 0.3, *[P] * 5]))
    result = numbers(outcome)
    assert result == pytest.approx({
        "ACCEPTED": 0, "TOTAL_METRES": 2525, "MEASURED_METRES": 2525, "FAILED_METRES": 125,
        "FAILED_SHARE": 100 * 125 / 2525, "LONGEST_FAILURE": 75,
    })  # fmt: skip
    said = f"{result['FAILED_SHARE']:.2f}\u00a0% of the measured metres failed, 2\u00a0% is allowed"
    assert said in decision(outcome)
    assert f"is {result['LONGEST_FAILURE']:.1f} m and the limit is 50 m" in decision(outcome)


def test_several_sheets_make_a_lot_and_runs_cross_their_borders() -> None:
    west, east = seams([P, P, F, F], name="west"), seams([F, P, P], start=100, name="east")
    outcome = decide(west, east, MAX_SHARE=50)
    longest = outcome.results["LONGEST_FAILURE"]
    assert longest == 75
    assert outcome.results["ACCEPTED"] == 0


def test_what_could_not_be_measured_is_not_passed() -> None:
    outcome = decide(seams([None] * 3 + [P] * 7))
    assert numbers(outcome) == pytest.approx({
        "ACCEPTED": None, "TOTAL_METRES": 250, "MEASURED_METRES": 175, "FAILED_METRES": 0, "FAILED_SHARE": 0,
        "LONGEST_FAILURE": 0,
    })  # fmt: skip
    assert outcome.results["DECISION"] == "undecided"
    assert decide(seams([None] * 3 + [P] * 7), MIN_MEASURED=70, MAX_RUN=75, MAX_SHARE=30).results["ACCEPTED"] == 1
    nothing = decide(seams([None] * 3))
    assert nothing.results["DECISION"] == "undecided"
    assert nothing.results.keys().isdisjoint({"ACCEPTED", "FAILED_SHARE"})


def test_ready_rules_and_a_file_of_ones_own(tmp_path: Path) -> None:
    made = seams([0.75] * 2 + [P] * 98)
    assert decide(made).results["ACCEPTED"] == 1
    strict = decide(made, READY_RULES="strict")
    assert strict.results["ACCEPTED"] == 0
    assert "Strict" in decision(strict)
    rule_file = tmp_path / "contract's <own>.json"
    rules = [{"check": "kept", "least": 0.8, "source": "§ 4"}, RUN]
    rule_file.write_text(json.dumps({"name": "contract 7", "rules": rules}), encoding="utf-8")
    outcome = decide(made, RULES=str(rule_file))
    assert outcome.results["ACCEPTED"] == 1
    assert outcome.results["FAILED_METRES"] == 50
    assert decision(outcome).startswith("Accepted by 'contract 7'")


@pytest.mark.parametrize("path", sorted(READY.glob("*.json")), ids=lambda path: path.stem)
def test_every_ready_file_decides(path: Path) -> None:
    good, bad = seams([P] * 300), seams([F] * 300)
    assert [decide(made, READY_RULES=path.stem).results["ACCEPTED"] for made in (good, bad)] == [1, 0]


def test_a_parameter_that_contradicts_the_rules_is_refused(tmp_path: Path) -> None:
    given = {"SEAMS": [seams([P] * 4)], "READY_RULES": "strict"}
    assert_refused("acceptmosaic", "MAX_RUN is 30.*, and the rules in strict are given", MAX_RUN=30, **given)
    assert_refused("acceptmosaic", "PLAN is iso2859, and the rules in strict are given", PLAN="iso2859", **given)
    rule_file = tmp_path / "own.json"
    rule_file.write_text("{}")
    assert_refused("acceptmosaic", "strict.*own.json are given; choose one of them", RULES=str(rule_file), **given)


@pytest.mark.parametrize(
    ("rules", "words"),
    [
        ([{"check": "failed_share", "most": 0.02, "source": "x"}], "what a piece must keep"),
        ([{"check": "kept", "least": 0.7, "source": "x"}], "no rule to decide by"),
        ([{"check": "kept", "least": 0.7, "source": "x"}, {"check": "failed_share", "most": 2, "source": "x"}], "0.02"),
        ([{"check": "kept", "least": 0.7, "source": "x"}, {"check": "sampling", "aql": 3, "source": "x"}], "AQL '3'"),
        ([{"check": "kept", "least": 0.7, "source": "x"}] * 2, "two rules for 'kept'"),
        ([{"check": "kept", "source": "x"}, RUN], "needs 'least'"),
        ([{"check": "kept", "least": 0.7, "source": "x", "most": 1}, RUN], "unknown key 'most'"),
        ([{"check": "colour", "least": 0.7, "source": "x"}], "unknown check 'colour'"),
        ([{"check": "kept", "least": 0.7}, RUN], "no 'source'"),
    ],
)
def test_bad_rules_are_refused(rules: list[dict[str, object]], words: str, tmp_path: Path) -> None:
    path = tmp_path / "bad.json"
    path.write_text(json.dumps({"name": "bad", "rules": rules}))
    assert_refused("acceptmosaic", words, SEAMS=[seams([P])], RULES=str(path))


@pytest.mark.parametrize(
    "text",
    [
        '{"name": "n", "rules": [{"check": "kept", "least": 0.7, "least": 0.1, "source": "x"}]}',
        '{"name": "n", "rules": [], "rules": [{"check": "kept", "least": 0.1, "source": "x"}]}',
    ],
)
def test_a_key_that_stands_twice_is_refused(text: str, tmp_path: Path) -> None:
    path = tmp_path / "twice.json"
    path.write_text(text)
    key = "least" if "0.7" in text else "rules"
    assert_refused("acceptmosaic", f"twice.json has '{key}' twice", SEAMS=[seams([P])], RULES=str(path))


# --- layers of all kinds ---------------------------------------------------------------------------------------


def test_a_layer_given_twice_counts_once(tmp_path: Path) -> None:
    made = seams([P] * 4)
    outcome = decide(made, made)
    assert outcome.results["TOTAL_METRES"] == 100
    assert_sentence(outcome.log.warnings[0], "4 pieces of seam are given twice")
    paths = [file(made, tmp_path / name) for name in ("a.gpkg", "b.gpkg")]
    assert decide(*paths).results["TOTAL_METRES"] == 100


def empty(kind: str = "LineString", **fields: tuple[str, list[Any]]) -> QgsVectorLayer:
    return layer(kind, [], UTM33, **fields)


def test_bad_layers_are_refused() -> None:
    point = layer("Point", [QgsGeometry.fromWkt("POINT(0 0)")], kept_1=("double", [0.5]))
    for given, words in (
        ([], "No layer of seams is given"),
        (["/nowhere/seams.gpkg"], "/nowhere/seams.gpkg can't be read as a layer of lines"),
        ([point], "made can't be read as a layer of lines"),
        ([layer("LineString", [straight(0, 5)])], "has no field 'kept_1'"),
        ([seams([P]), layer("LineString", [straight(0, 5)], None, kept_1=("double", [P]))], "check the systems"),
    ):
        assert_refused("acceptmosaic", words, SEAMS=given)
    outcome = decide(empty(kept_1=("double", [])))
    assert_sentence(outcome.complaint, "layers of seams are empty")
    outcome = decide(seams([P] * 2), empty(kept_1=("double", [])))
    assert_sentence(outcome.log.warnings[0], "made is empty")


def test_a_piece_over_a_border_counts_in_the_sheet_of_its_middle(tmp_path: Path) -> None:
    """390 m in pieces of 30 m, sheets of 100 m."""
    pieces = seams([F if place in (2, 3, 9) else P for place in range(13)], length=30)
    corner = min((feature.geometry().vertexAt(0) for feature in pieces.getFeatures()), key=lambda point: point.x())
    squares = [
        QgsGeometry.fromRect(QgsRectangle(corner.x() + left, corner.y() - 50, corner.x() + left + 100, corner.y() + 50))
        for left in (0, 100, 200, 300)
    ]
    outlines = layer("Polygon", squares, UTM33, name=("string", ["a", "b", "c", "d"]))
    outcome = decide(pieces, SHEETS=outlines, REPORT=str(tmp_path / "decision.html"))
    assert outcome.results["TOTAL_METRES"] == pytest.approx(390)
    rows = outline((tmp_path / "decision.html").read_text(encoding="utf-8")).rows
    metres = {row[0]: row[2].replace("\u00a0", " ") for row in rows if len(row) > 5}
    assert [metres[name] for name in "abcd"] == ["90.0 m", "120.0 m", "90.0 m", "90.0 m"]
    failed = {row[0]: (row[4].replace("\u00a0", " "), row[7]) for row in rows if len(row) > 5}
    assert [failed[name] for name in "abcd"] == [
        ("30.0 m", "1 / 3"), ("30.0 m", "1 / 4"), ("30.0 m", "1 / 3"), ("0.0 m", "0 / 3")
    ]  # fmt: skip
