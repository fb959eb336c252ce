"""The window layer: made, completed with fields, edited in steps of undo, saved in the formats that people use."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from qgis.core import (
    NULL,
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransformContext,
    QgsFeature,
    QgsFields,
    QgsProject,
    QgsRasterLayer,
    QgsVectorFileWriter,
    QgsVectorLayer,
    QgsWkbTypes,
)
from seam_inspector.plugin.imagery.errors import WindowLayerError
from seam_inspector.plugin.seams.measure.verdicts import Judgement, Ratios, Verdict
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult
from seam_inspector.plugin.seams.tables import window_layer
from seam_inspector.plugin.seams.tables.window_layer import UNNUMBERED
from seam_inspector.plugin.toolkit import layers as layer_editing
from seam_inspector.plugin.toolkit.version_differences import field

from tests.numbers.synthetic import wkt
from tests.qgis.runs import assert_sentence
from tests.qgis.scenes import BLURRED, SHARP, UTM33, Scene, layer, outline, windows

CRS, WKT = QgsCoordinateReferenceSystem(f"EPSG:{UTM33}"), wkt(UTM33)
OLD_FIELDS = (
    ["window_id", "verdict", "reason", "sources", "ratio_1", "ratio_2", "ratio_3", "background_ratio", "observer"]
)
"""Those of a layer that was made before causes were looked for."""
FIELDS = [
    *OLD_FIELDS,
    *("composite_ratio_1", "composite_ratio_2", "composite_ratio_3"),
    *("expected_ratio_1", "expected_ratio_2", "expected_ratio_3", "unclear_share", "cause"),
    *("causes", "reference", "paper_verdict", "kept_1", "kept_2", "kept_3", "kept_low", "kept_high", "band_width"),
    "feather_width",
    "visibility",
    "misfit",
    *("contrast_1", "sharpness_1", "added_1", "explained", "loss", "reason_code"),
]
RATIOS = (0.123456789012, 0.9, None)


def result(number: int) -> WindowResult:
    return WindowResult(number, None, Judgement(Verdict.REDUCED, Ratios(RATIOS, 0.97), None), Verdict.REDUCED)


def drawn_layer(kind: str, folder: Path) -> QgsVectorLayer:
    """A layer of one format with a column of the user's own and one window."""
    fields = QgsFields()
    fields.append(field("remark", "text"))
    if kind == "memory":
        made = layer("Polygon", [outline(SHARP)], remark=("string", ["mine"]))
    else:
        options = QgsVectorFileWriter.SaveVectorOptions()
        options.driverName = kind
        path = folder / {"GPKG": "drawn.gpkg", "ESRI Shapefile": "drawn.shp", "GeoJSON": "drawn.geojson"}[kind]
        writer = QgsVectorFileWriter.create(
            str(path), fields, QgsWkbTypes.Type.Polygon, CRS, QgsCoordinateTransformContext(), options
        )
        feature = QgsFeature(fields)
        feature.setAttributes(["mine"])
        feature.setGeometry(outline(SHARP))
        assert writer.addFeature(feature)
        del writer
        made = QgsVectorLayer(str(path), "drawn", "ogr")
    assert made.isValid()
    return made


def test_a_new_layer_has_all_fields_and_a_style(qgis_app: object, tmp_path: Path) -> None:
    first, second = (
        window_layer.open_window_layer(window_layer.write_window_file(WKT, levels, tmp_path)) for levels in (3, 2)
    )
    assert first.fields().names() == ["fid", *FIELDS]
    assert "ratio_3" not in second.fields().names()
    assert first.crs() == CRS
    assert first.source() != second.source()
    assert first.renderer().type() != "singleSymbol"
    assert window_layer.holds_windows(first)


def test_a_layer_that_cant_be_written_is_told(qgis_app: object, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    for folder in (tmp_path / "missing", tmp_path / "file"):
        with pytest.raises(WindowLayerError) as raised:
            window_layer.write_window_file(WKT, 3, folder)
        assert_sentence(str(raised.value), folder.name)


def test_windows_of_no_system_are_not_written_as_degrees(qgis_app: object, tmp_path: Path) -> None:
    with pytest.raises(WindowLayerError) as raised:
        window_layer.write_window_file("", 3, tmp_path)
    assert_sentence(str(raised.value), "reference system")
    assert not list(tmp_path.iterdir())


def test_only_polygons_hold_windows(qgis_app: object, scene: Scene) -> None:
    others = [None, layer("Point", []), layer("LineString", []), QgsRasterLayer(str(scene.mosaic), "mosaic")]
    assert not any(map(window_layer.holds_windows, [*others, QgsVectorLayer("/nowhere.gpkg", "gone", "ogr")]))
    assert window_layer.holds_windows(layer("MultiPolygon", []))


@pytest.mark.parametrize("kind", ["GPKG", "ESRI Shapefile", "GeoJSON", "memory"])
def test_what_is_written_is_saved_whatever_the_format(project: QgsProject, tmp_path: Path, kind: str) -> None:
    drawn = drawn_layer(kind, tmp_path)
    drawn.startEditing()
    unsaved = QgsFeature(drawn.fields())
    unsaved.setGeometry(outline(BLURRED))
    unsaved["remark"] = "new"
    assert drawn.addFeature(unsaved)
    renewed = window_layer.complete_fields(drawn, 3)
    assert list(renewed) == [unsaved.id()]
    assert window_layer.complete_fields(drawn, 3) == {}
    verdict = drawn.fields().indexOf("verdict")
    assert drawn.attributeAlias(verdict) == "verdict"
    assert {"significant loss": "significant"} in drawn.editorWidgetSetup(verdict).config()["map"]
    fids = sorted(row.fid for row in window_layer.read_layer(drawn))
    window_layer.write_numbers(drawn, {fid: number for number, fid in enumerate(fids, 1)})
    window_layer.write_results(drawn, {fid: result(number) for number, fid in enumerate(fids, 1)})
    window_layer.write_judgement(drawn, fids[:1], {"observer": "visible"})
    before = {row.window_id: row for row in window_layer.read_layer(drawn)}
    assert drawn.commitChanges(), drawn.commitErrors()
    after = {row.window_id: row for row in window_layer.read_layer(drawn)}
    assert set(after) == set(before) == {1, 2}
    for number, row in after.items():
        assert row.verdict == "reduced"
        assert row.ratios[:2] == pytest.approx(RATIOS[:2])
        assert row.ratios[2] is None
        assert row.background_ratio == (None if kind == "ESRI Shapefile" else 0.97)  # its names are short
        assert row.observer == before[number].observer
        assert row.extent == pytest.approx(before[number].extent)
    assert {feature["remark"] for feature in drawn.getFeatures()} == {"mine", "new"}


def test_fields_are_one_step_of_undo(project: QgsProject) -> None:
    drawn = layer("Polygon", [outline(SHARP)])
    window_layer.complete_fields(drawn, 3)
    assert drawn.fields().names() == FIELDS
    assert drawn.undoStack().count() == 1
    window_layer.complete_fields(drawn, 5)
    assert "ratio_5" in drawn.fields().names()
    drawn.undoStack().undo()
    drawn.undoStack().undo()
    assert drawn.fields().names() == []


def test_a_layer_from_before_causes_is_read_as_it_is_and_completed(project: QgsProject) -> None:
    values = [7, "reduced", None, 2, 0.8, 0.9, 0.95, 1.0, "visible"]
    kinds = ["integer", "string", "string", "integer", *["double"] * 4, "string"]
    old = windows(SHARP, **{name: (kind, [value]) for name, kind, value in zip(OLD_FIELDS, kinds, values)})
    (before,) = window_layer.read_layer(old)
    assert (before.window_id, before.verdict, before.sources) == (7, "reduced", 2)
    assert (before.ratios, before.background_ratio, before.observer) == ((0.8, 0.9, 0.95), 1.0, "visible")
    window_layer.complete_fields(old, 3)
    assert old.fields().names() == FIELDS
    (same,) = window_layer.read_layer(old)
    assert replace(same, composite_ratios=(), expected_ratios=(), kept=()) == before
    window_layer.write_results(old, {before.fid: result(7)})
    (after,) = window_layer.read_layer(old)
    assert (after.ratios[:2], after.observer) == (RATIOS[:2], "visible")


def test_ratios_of_more_levels_go_when_fewer_are_written(project: QgsProject) -> None:
    stale = {f"{kind}ratio_{level}": ("double", [0.5]) for kind in ("", "composite_", "expected_") for level in (1, 4)}
    drawn = windows(SHARP, window_id=("integer", [1]), ratio_x=("double", [0.25]), **stale)  # type: ignore[arg-type]
    window_layer.write_results(drawn, {1: result(1)})
    (feature,) = drawn.getFeatures()
    assert [feature[name] for name in stale if name.endswith("_4")] == [NULL] * 3
    assert feature["ratio_x"] == 0.25  # not one of ours


def test_rows_of_a_layer_without_our_fields(project: QgsProject) -> None:
    (row,) = window_layer.read_layer(layer("Polygon", [outline(SHARP)], ratio_x=("double", [1.0])))
    assert (row.window_id, row.verdict, row.sources, row.ratios, row.observer) == (UNNUMBERED, "", None, (), "")


def test_ratios_are_in_their_order(project: QgsProject) -> None:
    kinds = {f"ratio_{level}": ("double", [level / 10]) for level in (8, 2, 1, 3, 7, 6, 5, 4)}
    (row,) = window_layer.read_layer(layer("Polygon", [outline(SHARP)], **kinds))  # type: ignore[arg-type]
    assert row.ratios == tuple(level / 10 for level in range(1, 9))


def test_a_window_without_outline_is_a_row_too(project: QgsProject) -> None:
    nowhere, somewhere = window_layer.read_layer(layer("Polygon", [None, outline(SHARP)]))
    assert nowhere.extent is None
    assert somewhere.extent is not None


def test_some_rows_can_be_read(project: QgsProject) -> None:
    drawn = windows(SHARP, BLURRED, window_id=("integer", [4, 7]))
    assert [row.window_id for row in window_layer.read_layer(drawn, [2])] == [7]
    assert window_layer.read_layer(drawn, []) == []


def test_a_step_that_fails_leaves_nothing(project: QgsProject) -> None:
    drawn = windows(SHARP, window_id=("integer", [1]))

    def fail() -> None:
        with layer_editing.edit_step(drawn, "broken"):
            drawn.changeAttributeValue(1, 0, 5)
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        fail()
    assert [row.window_id for row in window_layer.read_layer(drawn)] == [1]
    assert not drawn.isEditCommandActive()


def test_a_layer_that_cant_be_edited_is_told(project: QgsProject) -> None:
    locked = windows(SHARP, window_id=("integer", [1]))
    locked.setReadOnly(True)
    for change in (
        lambda: window_layer.complete_fields(locked, 3),
        lambda: window_layer.write_judgement(locked, [1], {"observer": "visible"}),
        lambda: window_layer.remove_windows(locked, [1]),
        lambda: list(window_layer.add_windows(locked, [outline(BLURRED)], 2)),
    ):
        with pytest.raises(WindowLayerError) as raised:
            change()
        assert_sentence(str(raised.value), "can't be edited")
    assert locked.featureCount() == 1


@pytest.mark.parametrize("kind", ["memory", "GPKG"])
def test_what_operators_say_is_kept_and_survives_another_inspection(
    project: QgsProject, tmp_path: Path, kind: str
) -> None:
    """The fields come when they are used, in a layer with a feature that is not saved yet, too."""
    drawn = drawn_layer(kind, tmp_path)
    drawn.startEditing()
    window_layer.complete_fields(drawn, 3)
    unsaved = QgsFeature(drawn.fields())
    unsaved.setGeometry(outline(BLURRED))
    assert drawn.addFeature(unsaved)
    assert "observer_2" not in drawn.fields().names()
    said = {"observer_2": "unsure", "confidence_2": 70, "remark_2": "by the kerb"}
    window_layer.complete_fields(drawn, 3, said)
    assert "confidence" not in drawn.fields().names()
    rows = window_layer.read_layer(drawn)
    window_layer.write_numbers(drawn, {row.fid: number for number, row in enumerate(rows, 1)})
    window_layer.write_judgement(drawn, [row.fid for row in rows], said)
    assert drawn.commitChanges(False), drawn.commitErrors()
    fids = [row.fid for row in window_layer.read_layer(drawn)]
    window_layer.write_results(drawn, {fid: result(number) for number, fid in enumerate(fids, 1)})
    assert drawn.commitChanges(), drawn.commitErrors()
    for row in window_layer.read_layer(drawn):
        assert (row.observer_2, row.confidence_2, row.remark_2) == ("unsure", 70, "by the kerb")
        assert (row.verdict, row.observer, row.is_judged) == ("reduced", "", False)


def test_a_field_that_a_file_cant_hold_is_told(project: QgsProject, tmp_path: Path) -> None:
    drawn = drawn_layer("ESRI Shapefile", tmp_path)
    drawn.startEditing()
    window_layer.complete_fields(drawn, 3, ["confidence_2"])
    with pytest.raises(WindowLayerError, match="confidence_2"):
        window_layer.write_judgement(drawn, [1], {"confidence_2": 70})


def test_where_a_window_stands_on_its_seam_is_read(project: QgsProject) -> None:
    placed = windows(SHARP, seam_id=("integer", [4]), station=("double", [12.5]))
    (row,) = window_layer.read_layer(placed)
    assert (row.seam_id, row.station) == (4, 12.5)


def test_what_an_operator_saw_is_told_of_a_selected_window(repository: Path) -> None:
    """From 3.40 on QGIS paints a whole marker in the colour of the selection, unless the style asks it not to."""
    style = (repository / "resources" / "styles" / "windows.qml").read_text("utf-8")
    markers = [line for line in style.splitlines() if 'class="SvgMarker"' in line]
    assert markers
    assert [line for line in markers if 'userFlags="DisableSelectionRecoloring"' not in line] == []
