"""What ``acceptmosaic`` leaves: the layer of failures with its pictures, page and XML; what stands in its way."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import NULL, QgsGeometry, QgsRectangle, QgsVectorLayer

from tests.numbers.synthetic import write_raster
from tests.qgis.acceptance.papers import EVIL
from tests.qgis.acceptance.seam_scenes import UTM33, X, Y, sealed, seams
from tests.qgis.runs import Log, Run, assert_sentence, run
from tests.qgis.scenes import layer

pytestmark = pytest.mark.usefixtures("provider")

F, P = 0.5, 0.95
KEPT = [P, F, F, F, P, P, F, P]
FIELDS = [
    "defect", "sheet", "length", "kept_1", "kept_low", "kept_high", "band_width", "visibility", "cause",
    "left_source", "right_source", "left_date", "right_date", "x", "y", "remark", "picture",
]


@pytest.fixture(scope="module")
def mosaic(tmp_path_factory: pytest.TempPathFactory) -> str:
    """Noise of 0.25 m under the seam."""
    pixels = np.random.default_rng(1).integers(60, 190, (3, 600, 1000)).astype(np.uint8)
    path = tmp_path_factory.mktemp("mosaic") / "mosaic.tif"
    return write_raster(path, pixels, 0.25, (X - 25, Y + 75), system=UTM33)


def accept(*layers: QgsVectorLayer, **parameters: Any) -> Run:
    wanted = {"DEFECTS": None, "REPORT": None, "QUALITY": None, **parameters}
    outcome = run("acceptmosaic", SEAMS=list(layers) or [seams(KEPT)], **wanted)
    assert outcome.complaint is None
    assert outcome.results["ACCEPTED"] == 0
    return outcome


def opened(path: Path) -> QgsVectorLayer:
    result = QgsVectorLayer(str(path), "failures", "ogr")
    assert result.isValid()
    return result


def rows(path: Path) -> list[dict[str, Any]]:
    return [dict(zip(row.fields().names(), row.attributes())) for row in opened(path).getFeatures()]


def test_one_feature_per_failure_with_its_place_and_picture(tmp_path: Path, mosaic: str) -> None:
    path = tmp_path / "failures.gpkg"
    accept(DEFECTS=str(path), MOSAIC=[mosaic])
    assert opened(path).fields().names()[1:] == FIELDS
    first, second = rows(path)
    assert first["defect"] == 1
    assert (first["length"], second["length"]) == pytest.approx((75, 25), abs=3)
    assert (first["x"], first["y"]) == pytest.approx((X + 62.5, Y), abs=1)
    line = next(opened(path).getFeatures()).geometry()
    assert first["length"] == pytest.approx(line.length(), abs=0.01)  # cut where it begins and ends
    assert first["kept_1"] == 0.5
    assert (first["kept_low"], first["kept_high"]) == pytest.approx((0.45, 0.55))
    geometry = next(opened(path).getFeatures()).geometry()
    assert geometry.length() == pytest.approx(75, abs=3)
    assert geometry.constGet().numGeometries() == 1, "pieces that touch are one line"
    for row in (first, second):
        picture = gdal.Open(str(tmp_path / row["picture"]))
        assert picture.RasterXSize == 400
    assert first["picture"] == "failures_pictures/defect_001.jpg"


def test_dates_causes_and_remarks_come_along(tmp_path: Path) -> None:
    made = seams(KEPT)
    provider = made.dataProvider()
    names = ("left_source", "right_source", "left_date", "right_date")
    extra = layer("LineString", [], **{name: ("string", []) for name in names})
    provider.addAttributes(list(extra.fields()))
    made.updateFields()
    for row in made.getFeatures():
        values = {made.fields().indexOf(name): f"{name} {EVIL}" for name in names}
        provider.changeAttributeValues({row.id(): values})
    square = QgsGeometry.fromRect(QgsRectangle(X + 30, Y - 20, X + 70, Y + 20))
    windows = layer(
        "Polygon", [square] * 2, UTM33, window_id=("integer", [7, 8]),
        cause=("string", ["none", "feathering"]), remark=("string", ["", EVIL]), observer=("string", ["visible"] * 2),
    )  # fmt: skip
    path = tmp_path / "failures.gpkg"
    said = accept(made, DEFECTS=str(path), WINDOWS=windows).log.infos
    assert any("Windows that operators inspected: 2; with a cause: 1" in text for text in said)
    first, second = rows(path)
    assert first["cause"] == "feathering"
    assert EVIL.strip()[:20] in first["remark"]
    assert second["cause"] in (None, "NULL") or not second["cause"]
    assert first["left_date"].startswith("left_date")
    assert first["right_source"].startswith("right_source")


def test_a_scan_without_some_orthoimages_is_told() -> None:
    said = {"wavelet": "coif3", "seams": "found", "unexplained": "0.1386", "unexplained_at": "500010 5400020"}
    outcome = run("acceptmosaic", SEAMS=[sealed(seams(KEPT), **said)], REPORT=None, MAX_SHARE=100, MAX_RUN=1000)
    assert "match no orthoimage, 10\u00a0% is allowed; most around 500010.0, 5400020.0" in outcome.results["REASONS"]
    assert any("found the seams from the pixels" in said for said in outcome.log.warnings)
    assert accept().log.warnings == []


def test_the_cover_tells_what_the_scan_saw_beside_the_seams(tmp_path: Path) -> None:
    facts = {
        "wavelet": "coif3", "seams": "given", "unexplained": "0.0125", "unexplained_at": "500010 5400020 12 30",
        "unchanged_metres": "10.0", "unseen_metres": "400.0", "unseen_longest": "90.0",
        "unseen_at": "500100 5400200 6 90; 500300 5400400 8 60", "nodata_inside": "0.004",
        "nodata_at": "500001 5400002 3 4",
    }  # fmt: skip
    outcome = accept(sealed(seams(KEPT), **facts), REPORT=str(tmp_path / "r.html"))
    page = (tmp_path / "r.html").read_text(encoding="utf-8").replace("<wbr>", "").replace("\u00a0", " ")
    assert "coif3" in page
    total = outcome.results["TOTAL_METRES"]
    assert f"given: {total:.1f} m" in page
    assert "found and not given: 400.0 m, given and not found: 10.0 m" in page
    assert "given and not found: 10.0 m; most of it around 500100.0, 5400200.0 (6 x 90 m)" in page
    assert "1.2 % of the ground with texture; most of it around 500010.0, 5400020.0 (12 x 30 m)" in page
    assert "0.4 %; most of it around 500001.0, 5400002.0 (3 x 4 m)" in page


def test_orthoimages_that_hold_the_mosaic_or_were_not_given_are_findings_on_the_cover(tmp_path: Path) -> None:
    """In agreement with the decision, also where it is a rejection."""
    facts = {"wavelet": "coif3", "seams": "found", "unexplained": "0.0"}
    mixed = {"mixed_sources": "a.tif, b.tif", "mixed_metres": "50.0", "mixed_at": "500010 5400020"}
    for name, more, words in (
        ("mixed", mixed, "the mosaic is mixed into them along 50.0 m of seam, such as at 500010.0, 5400020.0"),
        ("missing", {"not_given": "c.tif"}, "not given: c.tif"),
    ):
        outcome = accept(sealed(seams([*KEPT, None]), **facts, **more), REPORT=str(tmp_path / f"{name}.html"))
        page = (tmp_path / f"{name}.html").read_text(encoding="utf-8").replace("<wbr>", "").replace("\u00a0", " ")
        assert outcome.results["DECISION"] == "rejected"
        row = page[page.index("<td>orthoimages along the seams") :].partition("</tr>")[0]
        assert "<b>With findings</b>" in row
        assert words in row


def test_a_run_that_is_stopped_leaves_no_layer_without_the_failures(tmp_path: Path, mosaic: str) -> None:
    log = Log()
    log.cancel()
    path = tmp_path / "failures.gpkg"
    given = {"DEFECTS": str(path), "REPORT": str(tmp_path / "r.html"), "QUALITY": None}
    run("acceptmosaic", log, SEAMS=[seams(KEPT)], MOSAIC=[mosaic], **given)
    assert [row["length"] for row in rows(path)] == [75, 25]
    assert [row["picture"] for row in rows(path)] == [NULL, NULL]
    assert any("The run was stopped: there is neither report nor XML" in said for said in log.warnings + log.errors)
    assert not (tmp_path / "r.html").exists()


@pytest.mark.parametrize("broken", ["missing", "broken", "elsewhere"])
def test_a_mosaic_that_shows_nothing_costs_the_pictures_only(tmp_path: Path, broken: str) -> None:
    path = tmp_path / "mosaic.tif"
    if broken == "broken":
        path.write_bytes(b"no raster")
    elif broken == "elsewhere":
        write_raster(path, np.full((64, 64), 9, np.uint8), 0.25, (X + 9000, Y), system=UTM33)
    outcome = accept(
        DEFECTS=str(tmp_path / "failures.gpkg"), REPORT=str(tmp_path / "decision.html"), MOSAIC=[str(path)]
    )
    (said,) = outcome.log.warnings
    assert_sentence(said, "mosaic|picture")
    assert len(rows(tmp_path / "failures.gpkg")) == 2
    assert (tmp_path / "decision.html").read_text(encoding="utf-8").count("data:image/jpeg") == 1  # the map
