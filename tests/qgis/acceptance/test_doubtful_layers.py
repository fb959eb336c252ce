"""Layers of seams that say what can't be meant: a sentence, and no decision on a guess."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsGeometry, QgsVectorLayer

from tests.qgis.acceptance.seam_scenes import UTM33, decide, decision, file, seams, straight
from tests.qgis.runs import Run
from tests.qgis.scenes import layer

pytestmark = pytest.mark.usefixtures("provider")

F, P = 0.5, 0.95


def pieces(count: int = 10, **fields: tuple[str, list[Any]]) -> QgsVectorLayer:
    made = layer("LineString", [straight(25 * place, 25) for place in range(count)], UTM33, **fields)
    made.setName("s")
    return made


def warned(outcome: Run, words: str) -> bool:
    return any(words in said for said in outcome.log.warnings)


def test_percent_is_no_share() -> None:
    outcome = decide(pieces(3, kept_1=("double", [86.0, 50.0, 30.0])))
    assert outcome.results["DECISION"] == "undecided"
    assert outcome.results["MEASURED_METRES"] == 0


def test_a_sheet_has_the_whole_name_of_its_file(tmp_path: Path) -> None:
    """Sheets of maps are numbered with dots."""
    given = [file(seams([P] * 3, y=50 * place), tmp_path / f"6.131.{place}.gpkg") for place in range(2)]
    sheets = decide(*given, SHEETS_OUT="TEMPORARY_OUTPUT")
    assert sheets.column("sheet", "SHEETS_OUT") == ["6.131.0", "6.131.1"]


def test_metres_of_web_mercator_are_those_on_the_ground() -> None:
    mercator = seams([P, F, F], epsg=3857, with_length=False)
    assert decide(mercator).results["TOTAL_METRES"] == pytest.approx(75, rel=2e-3)


def test_pieces_that_lie_nowhere_are_missed(tmp_path: Path) -> None:
    """Their figures are in the layer, and no second person could find them on the ground."""
    made = seams([P] * 30 + [F] * 2 + [P] * 30)
    made.dataProvider().changeGeometryValues({
        row.id(): QgsGeometry.fromWkt("LINESTRING(0 0, 0 0)") for row in made.getFeatures() if row["kept_1"] == F
    })  # fmt: skip
    outcome = decide(made)
    assert outcome.results["DECISION"] == "undecided"
    assert warned(outcome, "features without a line are left out (2)")
    assert "50 m of seam are missing" in decision(outcome)
