"""The papers name every sheet, say by whose word pieces failed, and draw what their sentences say."""
from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from qgis.core import QgsGeometry, QgsRectangle
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.delivery import SheetOutline
from seam_inspector.plugin.acceptance.paper.decision_map import decision_map

from tests.numbers.acceptance.made_decisions import decided
from tests.numbers.acceptance.public_schemas import NAMESPACES, faults
from tests.pages import outline
from tests.qgis.acceptance.papers import record_of
from tests.qgis.acceptance.seam_scenes import UTM33, X, Y, seams
from tests.qgis.acceptance.test_acceptance_report import page_of
from tests.qgis.acceptance.test_failure_pages import picture
from tests.qgis.runs import run
from tests.qgis.scenes import layer

pytestmark = pytest.mark.usefixtures("provider")

NAMES = ("sheet_10", "sheet_2", "sheet_1", "sheet_3")


def index(names: tuple[str, ...] = NAMES) -> object:
    """Sheets of 100 m side by side from west to east, as gdaltindex lists them; the seam lies in the first two."""
    boxes = [
        f"POLYGON(({X + 100 * n} {Y - 50},{X + 100 * n + 100} {Y - 50},{X + 100 * n + 100} {Y + 50},"
        f"{X + 100 * n} {Y + 50},{X + 100 * n} {Y - 50}))" for n in range(len(names))
    ]  # fmt: skip
    paths = [f"/sheets/{name}.tif" for name in names]
    return layer("Polygon", list(map(QgsGeometry.fromWkt, boxes)), UTM33, location=("string", paths))


def test_all_sheets_that_were_given_are_named_in_order(tmp_path: Path) -> None:
    page, record = tmp_path / "decision.html", tmp_path / "quality.xml"
    made = run("acceptmosaic", SEAMS=[seams([0.5] * 8)], SHEETS=index(), DEFECTS=None, REPORT=str(page),
               QUALITY=str(record))
    assert made.complaint is None
    sheets = [row for row in outline(page.read_text(encoding="utf-8")).rows if len(row) == 9][1:]
    assert [row[0] for row in sheets] == ["sheet_1", "sheet_2", "sheet_3", "sheet_10", "all"]
    assert [row[1] for row in sheets] == ["No seams", "Rejected", "No seams", "Rejected", ""]
    assert sheets[0][3:] == ["\u2013"] * 6
    text = record.read_text(encoding="utf-8")
    assert faults(text) == []
    (scope,) = ET.fromstring(text.encode()).iterfind(".//mdq:DQ_DataQuality/mdq:scope", NAMESPACES)
    named = [item for item in "".join(scope.itertext()).split() if item.startswith("sheet_")]
    assert named == ["sheet_1", "sheet_2", "sheet_3", "sheet_10"]


def test_the_map_draws_the_sheets_as_they_were_given() -> None:
    decision = decided(["a", "b"], failed=[(0, 3)])
    box = bytes(QgsGeometry.fromRect(QgsRectangle(499000, 5499000, 503000, 5502000)).asWkb())
    given = replace(decision, delivery=replace(decision.delivery, outlines=(SheetOutline("far", box),)))
    plain, drawn = (picture(decision_map(item, ()) or b"") for item in (decision, given))
    assert (np.abs(drawn - [142, 1, 82]).sum(axis=2) < 60).any()  # failures in their colour
    assert drawn.shape[1] / drawn.shape[0] == pytest.approx(4 / 3, rel=0.1)  # the outline's, not that of the seams
    assert plain.shape[1] / plain.shape[0] == pytest.approx(1, rel=0.1)  # no higher than a page


def test_a_sample_is_not_the_delivery(tmp_path: Path) -> None:
    plain = decided(["sheet_1"], failed=[(0, 3)])
    pieces = tuple(replace(piece, sample_number=place + 1) for place, piece in enumerate(plain.delivery.pieces))
    page = page_of(tmp_path, record_of(decide(replace(plain.delivery, pieces=pieces, lot_size=400), plain.rules)))
    assert "metres and shares are those of the sample" in page.words
    assert "seams of all sheets" not in page.words
