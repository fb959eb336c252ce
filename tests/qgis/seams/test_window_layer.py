"""The window layer: made, completed with fields, edited in steps of undo, saved in the formats that people use."""
from __future__ import annotations

from pathlib import Path

import pytest
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransformContext,
    QgsProject,
    QgsVectorFileWriter,
    QgsVectorLayer,
)
from seam_inspector.plugin.imagery.errors import WindowLayerError
from seam_inspector.plugin.seams.measure.judgement.verdicts import Judgement, Ratios, Verdict
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult
from seam_inspector.plugin.seams.tables import window_file, window_layer
from seam_inspector.plugin.seams.tables.window_file import StoredResult
from seam_inspector.plugin.seams.tables.window_layer import WindowChange

from tests.numbers.synthetic import wkt
from tests.qgis.runs import assert_sentence
from tests.qgis.scenes import BLURRED, SHARP, UTM33, outline, windows

CRS, WKT = QgsCoordinateReferenceSystem(f"EPSG:{UTM33}"), wkt(UTM33)
FIELDS = [
    *("window_id", "verdict", "reason", "sources", "ratio_1", "ratio_2", "ratio_3", "background_ratio", "observer"),
    *("composite_ratio_1", "composite_ratio_2", "composite_ratio_3"),
    *("expected_ratio_1", "expected_ratio_2", "expected_ratio_3", "unclear_share", "cause"),
    *("causes", "reference", "paper_verdict", "kept_1", "kept_2", "kept_3", "kept_low", "kept_high", "band_width"),
    "feather_width",
    "visibility",
    "misfit",
    *("contrast_1", "sharpness_1", "added_1", "explained", "loss", "reason_code"),
    *("observer_2", "confidence", "confidence_2", "remark", "remark_2", "seam_id", "station", "origin"),
]
RATIOS = (0.123456789012, 0.9, None)


def result(number: int) -> WindowResult:
    return WindowResult(number, None, Judgement(Verdict.REDUCED, Ratios(RATIOS, 0.97), None), Verdict.REDUCED)


def made_layer(folder: Path, levels: int = 3) -> QgsVectorLayer:
    path = window_file.write_window_file(WKT, folder, window_file.window_fields(levels))
    return window_layer.open_window_layer(path)


def add(drawn: QgsVectorLayer, *boxes: tuple[int, int, int, int]) -> list[int]:
    """Windows numbered from 1 on."""
    made = window_layer.new_windows(drawn, map(outline, boxes), 1, [{"origin": "drawn"}] * len(boxes))
    window_layer.write(drawn, WindowChange(added=made), "Add")
    return [row.fid for row in sorted(window_layer.read_layer(drawn), key=lambda row: row.window_id)]


def test_a_new_layer_has_all_fields_and_a_style(qgis_app: object, tmp_path: Path) -> None:
    first, second = made_layer(tmp_path), made_layer(tmp_path, 2)
    assert first.fields().names() == ["fid", *FIELDS]
    assert "ratio_3" not in second.fields().names()
    assert first.crs() == CRS
    assert first.source() != second.source()
    assert first.renderer().type() != "singleSymbol"
    assert window_layer.holds_windows(first)
    assert window_layer.is_in_file(first)
    verdict = first.fields().indexOf("verdict")
    assert first.attributeAlias(verdict) == "verdict"
    window_layer.add_levels(second, 4)
    assert "ratio_4" in second.fields().names()


def test_a_layer_that_cant_be_written_is_told(qgis_app: object, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    fields = window_file.window_fields(3)
    for folder in (tmp_path / "missing", tmp_path / "file"):
        with pytest.raises(WindowLayerError) as raised:
            window_file.write_window_file(WKT, folder, fields)
        assert_sentence(str(raised.value), folder.name)
    with pytest.raises(WindowLayerError) as raised:  # windows of no system are not written as degrees
        window_file.write_window_file("", tmp_path, fields)
    assert_sentence(str(raised.value), "reference system")
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


@pytest.mark.parametrize("is_edited", [False, True])
def test_what_is_written_is_in_the_file_or_among_the_edits(
    project: QgsProject, tmp_path: Path, is_edited: bool
) -> None:
    drawn = made_layer(tmp_path)
    messages: list[str] = []
    for name in ("featureAdded", "featureDeleted", "attributeValueChanged"):
        getattr(drawn, name).connect(lambda *_, name=name: messages.append(name))
    if is_edited:
        drawn.startEditing()
    first, second, third = add(drawn, SHARP, BLURRED, SHARP)
    window_layer.write(drawn, WindowChange(removed=[third]), "Remove")
    values = {"observer": "visible", "nowhere": 1, **window_layer.measured_values(drawn, result(1))}
    window_layer.write(drawn, WindowChange({first: values}), "Judge")
    names = ["verdict", "observer", "nowhere"]
    assert window_layer.held_values(drawn, [first, second], names) == {
        first: {"verdict": "reduced", "observer": "visible"}, second: {"verdict": None, "observer": None}
    }
    assert {"featureAdded", "featureDeleted", "attributeValueChanged"} <= set(messages)
    saved = QgsVectorLayer(drawn.source(), "saved", "ogr")
    assert saved.featureCount() == (0 if is_edited else 2)
    if is_edited:
        assert drawn.undoStack().count() == 3
        assert drawn.commitChanges(), drawn.commitErrors()
    row, other = window_layer.read_layer(drawn)
    assert (row.verdict, row.observer, row.ratios, row.background_ratio) == ("reduced", "visible", RATIOS, 0.97)
    assert (other.verdict, other.window_id) == ("", 2)


@pytest.mark.parametrize("kind", ["GPKG", "ESRI Shapefile", "GeoJSON", "memory"])
def test_windows_of_any_format_are_copied_with_all_they_say(project: QgsProject, tmp_path: Path, kind: str) -> None:
    said = {"window_id": ("integer", [4]), "verdict": ("string", ["reduced"]), "ratio_1": ("double", [0.8])}
    made = windows(SHARP, **said, soil=("string", ["loam"]), seen=("date", ["2019-07-04"]))
    if kind != "memory":
        options = QgsVectorFileWriter.SaveVectorOptions()
        options.driverName = kind
        path = tmp_path / {"GPKG": "drawn.gpkg", "ESRI Shapefile": "drawn.shp", "GeoJSON": "drawn.geojson"}[kind]
        QgsVectorFileWriter.writeAsVectorFormatV3(made, str(path), QgsCoordinateTransformContext(), options)
        made = QgsVectorLayer(str(path), "drawn", "ogr")
        made.setCrs(CRS)
    assert not window_layer.is_in_file(made)
    copied = window_layer.open_window_layer(window_layer.copy_to_file(made, 3, "", tmp_path))
    assert window_layer.is_in_file(copied)
    (row,) = window_layer.read_layer(copied)
    assert (row.window_id, row.verdict, row.ratio) == (4, "reduced", pytest.approx(0.8))
    (feature,) = copied.getFeatures()
    assert (feature["soil"], feature["seen"]) == ("loam", "2019-07-04")
    assert row.extent == pytest.approx(window_layer.read_layer(made)[0].extent)
    assert set(FIELDS) <= set(copied.fields().names())


def test_a_layer_that_cant_be_written_to_is_told(project: QgsProject, tmp_path: Path) -> None:
    locked = made_layer(tmp_path)
    project.addMapLayer(locked)  # errors that are kept would keep it beyond the end of QGIS
    add(locked, SHARP)
    locked.setReadOnly(True)
    for change in (WindowChange({1: {"observer": "visible"}}), WindowChange(removed=[1])):
        with pytest.raises(WindowLayerError) as raised:
            window_layer.write(locked, change, "Judge")
        assert_sentence(str(raised.value), "can't be edited")
    with pytest.raises(WindowLayerError):
        add(locked, BLURRED)
    assert locked.featureCount() == 1


def test_what_is_stored_of_a_window_is_found_and_replaced(project: QgsProject, tmp_path: Path) -> None:
    path = window_file.write_window_file(WKT, tmp_path, window_file.window_fields(3))
    assert window_file.fingerprints(path) == {}
    for mark in ("first", "second"):
        window_file.store(path, [StoredResult(1, mark, result(1)), StoredResult(2, mark, result(2))])
    window_file.store(path, [StoredResult(2, "third")])
    assert window_file.fingerprints(path) == {1: "second", 2: "third"}
    assert window_file.load_result(path, 2) == result(2)
    assert window_file.load_result(path, 3) is None
    mosaic = window_file.KnownMosaic("/a b/mosaic.tif", "content")
    window_file.note_mosaic(path, mosaic)
    copied = tmp_path / "it's a copy.gpkg"
    window_file.copy_file(path, copied)
    assert window_file.known_mosaic(copied) == mosaic
    assert window_file.fingerprints(copied) == {1: "second", 2: "third"}
    with pytest.raises(WindowLayerError):
        window_file.copy_file(path, tmp_path / "no" / "folder.gpkg")
    with pytest.raises(WindowLayerError):
        window_file.store(tmp_path / "nothing.gpkg", [])


def test_what_an_operator_saw_is_told_of_a_selected_window(repository: Path) -> None:
    """From 3.40 on QGIS paints a whole marker in the colour of the selection, unless the style asks it not to."""
    style = (repository / "resources" / "styles" / "windows.qml").read_text("utf-8")
    markers = [line for line in style.splitlines() if 'class="SvgMarker"' in line]
    assert markers
    assert [line for line in markers if 'userFlags="DisableSelectionRecoloring"' not in line] == []
