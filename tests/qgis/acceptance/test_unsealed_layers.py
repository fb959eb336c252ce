"""A layer that is not as a scan left it is never accepted; a row of pieces that nobody measured may be a failure."""
from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from osgeo import gdal
from qgis.core import QgsVectorLayer

from tests.qgis.acceptance.seam_scenes import decide, decision, file, sealed, seams
from tests.qgis.runs import Run, run
from tests.qgis.scenes import saved

pytestmark = pytest.mark.usefixtures("provider")

F, P = 0.5, 0.95
CHANGED, UNSEALED = "were changed since their scan: 1 (seams)", "without the seal of a scan: 1 (seams)"


def sql(*statements: str) -> Callable[[Path], None]:
    """Changes the file as anybody can; the triggers of its index need functions that only GDAL has."""

    def change(path: Path) -> None:
        dataset = gdal.OpenEx(str(path), gdal.OF_VECTOR | gdal.OF_UPDATE)
        for statement in statements:
            dataset.ExecuteSQL(statement, dialect="SQLITE" if statement.startswith("INSERT") else "")

    return change


def stripped(path: Path) -> None:
    dataset = gdal.OpenEx(str(path), gdal.OF_VECTOR | gdal.OF_UPDATE)
    dataset.GetLayer(0).SetMetadata({}, "SEAM_INSPECTOR")


def other_settings(path: Path) -> None:
    layer = (dataset := gdal.OpenEx(str(path), gdal.OF_VECTOR | gdal.OF_UPDATE)).GetLayer(0)
    layer.SetMetadata({**layer.GetMetadata("SEAM_INSPECTOR"), "unexplained": "0.0"}, "SEAM_INSPECTOR")
    del dataset


def other_system(path: Path) -> None:
    """All as it was, and called another zone's."""
    gdal.VectorTranslate(str(path.with_name("moved.gpkg")), str(path), options=["-a_srs", "EPSG:32634"])
    path.with_name("moved.gpkg").replace(path)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (sql("UPDATE seams SET kept_1 = 0.95, kept_low = 0.9, kept_high = 1.0 WHERE kept_1 < 0.7"), CHANGED),
        (sql("DELETE FROM seams WHERE kept_1 < 0.7"), CHANGED),
        (sql("UPDATE seams SET level = 'stretch' WHERE kept_1 < 0.7"), CHANGED),
        (stripped, UNSEALED), (other_settings, CHANGED), (other_system, CHANGED),
    ],
)
def test_a_layer_that_was_changed_is_not_accepted(
    change: Callable[[Path], None], words: str, tmp_path: Path
) -> None:
    """Whatever the rules and the paper say: with these it would be accepted."""
    path = tmp_path / "seams.gpkg"
    made = seams([P] * 40 + [F] + [P] * 40)
    file(sealed(made, unexplained="0.02"), path)
    given = {"MAX_SHARE": 10.0, "TITLE": "REMARKS: rows were corrected as agreed"}
    assert decide(str(path), **given).results["DECISION"] == "accepted"
    change(path)
    outcome = decide(str(path), **given)
    assert outcome.results["DECISION"] == "undecided"
    assert words in decision(outcome)
    assert any("in the GeoPackages themselves or copies of these files" in text for text in outcome.log.warnings)


def test_edits_that_are_not_saved_yet_break_the_seal() -> None:
    made = seams([P] * 10)
    made.startEditing()
    made.changeAttributeValue(next(made.getFeatures()).id(), made.fields().indexOf("length"), 250.0)
    assert CHANGED in decision(decide(made))


def test_copies_that_keep_the_seal_are_the_scan_s_and_exports_are_told_the_way(tmp_path: Path) -> None:
    path = file(seams([P] * 10), tmp_path / "seams.gpkg")
    copy, shape = str(tmp_path / "copy.gpkg"), str(tmp_path / "seams.shp")
    gdal.VectorTranslate(copy, path)
    assert decide(copy).results["DECISION"] == "accepted"
    saved(QgsVectorLayer(path, "seams", "ogr"), Path(shape))
    exported = saved(QgsVectorLayer(path, "seams", "ogr"), tmp_path / "exported.gpkg")
    for written in (shape, exported):
        outcome = decide(written)
        assert outcome.results["DECISION"] == "undecided"
        assert any("exports, merged layers and other formats lose the seal" in text for text in outcome.log.warnings)


# --- samples ----------------------------------------------------------------------------------------------------


def sample(*layers: QgsVectorLayer | str, output: str = "TEMPORARY_OUTPUT") -> Run:
    made = run("planinspection", SEAMS=list(layers), PLAN="count", COUNT=20, OUTPUT=output)
    assert made.complaint is None
    return made


def test_a_sample_is_sealed_as_what_it_was_drawn_of(tmp_path: Path) -> None:
    whole, plan = [seams([P] * 20, name="a"), seams([P] * 20, y=99, name="b")], {"PLAN": "iso2859", "AQL": "4.0"}
    drawn = sample(*whole, output=str(tmp_path / "sample.gpkg"))
    assert decide(drawn.results["OUTPUT"], **plan).results["DECISION"] == "accepted"
    sql("UPDATE sample SET lot_size = 30")(tmp_path / "sample.gpkg")
    assert decide(drawn.results["OUTPUT"], **plan).results["DECISION"] == "undecided"
    whole[1].removeCustomProperty("SEAM_INSPECTOR/digest")
    unsealed = sample(*whole)
    assert decide(unsealed.layer(), **plan).results["DECISION"] == "undecided"
