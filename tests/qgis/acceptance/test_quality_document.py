"""The XML of a decision: the structure of ISO/TS 19157-2, the figures of the decision, any name."""
from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import replace
from datetime import datetime, timezone
from pathlib import Path

import pytest
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.decision import Decision
from seam_inspector.plugin.acceptance.paper.quality_document import quality_document, save_quality_document

from tests.numbers.acceptance.made_decisions import PLAN, decided, window_on, with_windows
from tests.numbers.acceptance.public_schemas import NAMESPACES, faults
from tests.qgis.acceptance.papers import EVIL, record_of, scanned_with

SHEETS = ("sheet_1", "sheet_2")
FAILED = [(0, 3), (0, 4), (1, 20)]


def text(element: ET.Element, path: str) -> str:
    result = element.find(path, NAMESPACES)
    assert result is not None, path
    return "".join(result.itertext()).strip()


def elements(document: str) -> dict[str, ET.Element]:
    """Elements by their identifiers."""
    assert faults(document) == []
    root = ET.fromstring(document.encode())
    return {item.get("id", ""): item for report in root.iterfind(".//mdq:report", NAMESPACES) for item in report}


def values(element: ET.Element) -> list[float]:
    """Values of all sheets together."""
    first = element.find("mdq:result/mdq:DQ_QuantitativeResult", NAMESPACES)
    assert first is not None
    return [float(name.text or "") for name in first.iterfind("mdq:value/gco:Record", NAMESPACES)]


def unit(element: ET.Element) -> str:
    result = element.find("mdq:result/mdq:DQ_QuantitativeResult/mdq:valueUnit", NAMESPACES)
    assert result is not None
    return result.attrib[f"{{{NAMESPACES['xlink']}}}href"]


def passed(element: ET.Element) -> str:
    return text(element, "mdq:result/mdq:DQ_ConformanceResult/mdq:pass")


def test_one_report_per_measure_with_value_unit_and_conformance() -> None:
    decision = decided(SHEETS, failed=FAILED)
    result = elements(quality_document(record_of(decision)))
    assert list(result) == ["acceptance", "failed_share", "longest_failure", "kept", "measured_share"]
    share = decision.whole.failed_share
    assert share is not None
    assert values(result["failed_share"]) == pytest.approx([100 * share])
    assert unit(result["failed_share"]).endswith("UCUM/%25")
    assert passed(result["failed_share"]) == passed(result["acceptance"]) == "false"
    assert values(result["longest_failure"]) == pytest.approx([decision.longest_failure_m])
    assert unit(result["longest_failure"]).endswith("UCUM/m")
    assert passed(result["longest_failure"]) == "true"
    assert values(result["kept"]) == pytest.approx([0.45])
    assert values(result["measured_share"]) == pytest.approx([100.0])
    assert text(result["failed_share"], "mdq:result/mdq:DQ_ConformanceResult/mdq:specification") == "contract"
    explained = text(result["failed_share"], "mdq:result/mdq:DQ_ConformanceResult/mdq:explanation")
    assert f"{100 * share:.2f}\u00a0%" in explained


def test_each_sheet_has_a_result_of_its_own() -> None:
    decision = decided(SHEETS, failed=FAILED)
    items = elements(quality_document(record_of(decision)))["failed_share"]
    results = {
        text(name, "mdq:resultScope//mcc:dataset"): float(text(name, "mdq:value"))
        for name in items.iterfind("mdq:result/mdq:DQ_QuantitativeResult", NAMESPACES)
        if name.find("mdq:resultScope", NAMESPACES) is not None
    }
    assert results == pytest.approx({sheet.name: 100 * (sheet.failed_share or 0) for sheet in decision.sheets})


def test_scope_time_and_lineage() -> None:
    at = datetime(2026, 11, 22, 13, 5, tzinfo=timezone.utc)
    decision = scanned_with(decided(SHEETS), "coif3")
    record = record_of(decision, made_at=at, report="/x/report.html", rules="/r.json")
    document = quality_document(record)
    root = ET.fromstring(document.encode())
    assert faults(document) == []
    scope = root.find(".//mdq:DQ_DataQuality/mdq:scope", NAMESPACES)
    assert scope is not None
    assert [name.text for name in scope.iterfind(".//mcc:dataset/gco:CharacterString", NAMESPACES)] == list(SHEETS)
    west, east = (float(text(scope, f".//gex:{side}BoundLongitude")) for side in ("west", "east"))
    assert 14.9 < west < east < 15.1
    assert 49 < float(text(scope, ".//gex:southBoundLatitude")) < 50
    assert text(root, "mdb:referenceSystemInfo") == "EPSG:32633"
    assert text(root, "mdb:dateInfo//cit:date") == "2026-11-22T13:05:00+00:00"
    assert text(root, ".//mdq:reportReference") == "report.html"
    lineage = text(root, "mdb:resourceLineage")
    for words in ("Seam Inspector 0.1.0", "wavelet: coif3", "70", "sheet_1: /deliveries/sheet_1.gpkg", "/r.json"):
        assert words in lineage


def test_a_plan_is_told() -> None:
    seen = decided(SHEETS, failed=FAILED, sampling=PLAN)
    assert seen.plan is not None
    result = elements(quality_document(record_of(seen)))
    assert values(result["sampling"]) == [seen.plan.nonconforming]
    method = "mdq:evaluationMethod/mdq:DQ_SampleBasedInspection/mdq:"
    assert text(result["sampling"], f"{method}samplingRatio") == f"{seen.plan.plan.sample_size} / 80"
    assert "AQL 1" in text(result["sampling"], f"{method}samplingScheme")


def nothing_measured() -> Decision:
    decision = decided()
    pieces = tuple(replace(piece, kept_1=None, kept_low=None, kept_high=None) for piece in decision.delivery.pieces)
    return decide(replace(decision.delivery, pieces=pieces), decision.rules)


def test_what_was_not_measured_has_no_number() -> None:
    result = elements(quality_document(record_of(nothing_measured())))
    assert "kept" not in result
    assert result["failed_share"].find("mdq:result/mdq:DQ_QuantitativeResult", NAMESPACES) is None
    for code in ("acceptance", "failed_share"):
        assert passed(result[code]) == ""  # undecided: neither true nor false


@pytest.mark.parametrize("name", [EVIL, "]]>", "Łódź 東京", "\ud800", "a" * 300])
def test_any_name_is_text(name: str, tmp_path: Path) -> None:
    decision = decided([name, "other"], failed=FAILED, images=(name, name))
    seen = scanned_with(with_windows(decision, window_on(decision, 3, name, name)), name)
    record = record_of(seen, windows=name, rules=name, report=name)
    save_quality_document(tmp_path / "quality.xml", record)
    document = (tmp_path / "quality.xml").read_text(encoding="utf-8")
    assert faults(document) == []
    shown = name.replace("\x07", "\ufffd").replace("\u202e", "\ufffd").replace("\ud800", "\ufffd")
    assert shown in [element.text for element in ET.fromstring(document.encode()).iter()]
