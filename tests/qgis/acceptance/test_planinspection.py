"""``planinspection`` as QGIS runs it: how many, which, and that the sample goes on into the decision and the desk."""
from __future__ import annotations

from typing import Any

import pytest
from qgis.core import QgsVectorLayer

from tests.qgis.acceptance.seam_scenes import seams
from tests.qgis.runs import Run, assert_refused, assert_sentence, run
from tests.qgis.scenes import Scene, layer, line

pytestmark = pytest.mark.usefixtures("provider")

P = 0.95


def plan(*layers: QgsVectorLayer | str, **parameters: Any) -> Run:
    return run("planinspection", SEAMS=list(layers), **parameters)


def numbers(outcome: Run) -> tuple[object, ...]:
    assert outcome.complaint is None
    names = ("SAMPLE_SIZE", "ACCEPTANCE_NUMBER", "LOT_SIZE", "CODE_LETTER")
    return tuple(outcome.results.get(name) for name in names)


def test_a_sample_by_the_standard_in_proportion_from_every_sheet() -> None:
    west, east = seams([P] * 900, name="west"), seams([P] * 300, y=50, name="east")
    outcome = plan(west, east)
    assert numbers(outcome) == (80, 2, 1200, "J")
    rows = outcome.rows()
    assert [row["sample"] for row in rows] == list(range(1, 81))
    assert {row["lot_size"] for row in rows} == {1200}
    assert [sum(row["sheet"] == sheet for row in rows) for sheet in ("west", "east")] == [60, 20]
    assert len({(row["sheet"], row["station"]) for row in rows}) == 80
    assert plan(west, east).rows() == rows
    assert plan(west, east, SEED=7).rows() != rows


def test_an_isolated_lot_has_a_sample_by_its_limiting_quality() -> None:
    outcome = plan(seams([P] * 1200), PLAN="iso2859_2", LQ="8.00")
    assert numbers(outcome) == (50, 1, 1200, None)
    assert any("ISO 2859-2:1985, isolated lot of 1200" in text for text in outcome.log.infos)
    decided = run("acceptmosaic", SEAMS=[outcome.layer()], PLAN="iso2859_2", LQ=8, DEFECTS=None, REPORT=None)
    assert decided.results["DECISION"] == "accepted"
    assert "is '1.25'; give one of 2.00" in str(plan(seams([P] * 40), PLAN="iso2859_2", LQ=1.25).complaint)


def test_the_sample_is_decided_on() -> None:
    made = seams([0.5] * 200 + [P] * 800)
    planned = plan(made, PLAN="iso2859", AQL="1.0")  # its layer lives as long
    sample = planned.layer()
    parameters = {"DEFECTS": None, "REPORT": None, "QUALITY": None}
    outcome = run("acceptmosaic", SEAMS=[sample], PLAN="iso2859", AQL="1.0", **parameters)
    failed = sum(feature["kept_1"] < 0.7 for feature in sample.getFeatures())
    assert outcome.results["ACCEPTED"] == 0
    (said,) = (text for text in outcome.log.infos if text.startswith("Rejected"))
    assert f"{failed} of 80 inspected pieces failed" in said
    assert any("lot of 1000" in text for text in outcome.log.infos)
    judged = run("acceptmosaic", SEAMS=[sample], **parameters)
    assert any("The layers are a sample of 80 pieces" in text for text in judged.log.infos)
    assert judged.results.get("LONGEST_FAILURE") is None


def test_bad_input_is_refused(scene: Scene) -> None:
    made = seams([P] * 10)
    for parameters, words in (
        ({"SEAMS": ["x" * 5000]}, "can't be read as a layer of lines"),  # longer than any file's name
        ({"UNIT": "windows"}, "give MOSAIC, or take pieces"),
    ):
        assert_refused("planinspection", words, **{"SEAMS": [made], **parameters})
    assert_sentence(plan(made, LOT_SIZE=5).complaint, "The lot size is 5 and the layers hold 10")
    assert_sentence(plan(seams([P])).complaint, "at least 2")
    lines = [line((200, 0), (300, 256)), line((300, 256), (350, 256))]
    short = layer("LineString", lines, kept_1=("double", [P] * 2))
    wide = plan(short, UNIT="windows", MOSAIC=str(scene.mosaic))
    assert_sentence(wide.complaint, "smaller than a window of 1024 px, the power of two that spans 100 m")


def test_a_sample_larger_than_what_is_given_is_told() -> None:
    outcome = plan(seams([P] * 40), LOT_SIZE=1000)
    assert outcome.results["SAMPLE_SIZE"] == 40
    assert_sentence(outcome.log.warnings[0], "The plan needs 80 pieces and the layers hold 40")
