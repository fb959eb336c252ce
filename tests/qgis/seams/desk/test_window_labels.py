"""The labels of the windows on the map: none over another, and the selected window's always there."""
from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from qgis.core import (
    QgsApplication,
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsExpression,
    QgsExpressionContext,
    QgsExpressionContextUtils,
    QgsFeature,
    QgsGeometry,
    QgsMapRendererParallelJob,
    QgsMapSettings,
    QgsProject,
    QgsRectangle,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QLocale, QSize
from seam_inspector.plugin.seams.desk.windows.window_columns import COLUMNS
from seam_inspector.plugin.seams.measure.window_records import WindowRecord

from tests.qgis.seams.desk.selections import selection_scope
from tests.qgis.seams.desk.session_desk import wait_until

RATIOS = {1: 0.83, 2: 0.82, 3: 0.49, 4: 1.1}
CORNERS = {1: (0, 100), 2: (60, 100), 3: (120, 110), 4: (62, 60)}
SIDE_M = 100.0


@pytest.fixture
def windows(project: QgsProject, repository: Path) -> QgsVectorLayer:
    """Four of them that overlap, in their style."""
    fields = "field=window_id:integer&field=verdict:string&field=reason:string&field=ratio_1:double"
    layer = QgsVectorLayer(f"Polygon?crs=EPSG:2180&{fields}", "windows", "memory")
    for number, (x, y) in CORNERS.items():
        feature = QgsFeature(layer.fields())
        feature.setAttributes([number, "reduced", None, RATIOS[number]])
        feature.setGeometry(QgsGeometry.fromRect(box(x, y, x + SIDE_M, y + SIDE_M)))
        layer.dataProvider().addFeature(feature)
    message, worked = layer.loadNamedStyle(str(repository / "resources" / "styles" / "windows.qml"))
    assert worked, message
    project.addMapLayer(layer)
    return layer


def box(xmin: float, ymin: float, xmax: float, ymax: float) -> QgsRectangle:
    return QgsRectangle(500_000 + xmin, 500_000 + ymin, 500_000 + xmax, 500_000 + ymax)


def labels(
    windows: QgsVectorLayer, extent: QgsRectangle, selected: list[int], crs: str = "EPSG:2180"
) -> dict[int, QgsRectangle]:
    """Places of the labels of windows on the map, by the windows' numbers."""
    windows.selectByIds([feature.id() for feature in windows.getFeatures() if feature["window_id"] in selected])
    settings = QgsMapSettings()
    settings.setLayers([windows])
    settings.setDestinationCrs(QgsCoordinateReferenceSystem(crs))
    settings.setOutputSize(QSize(700, 450))
    to_map = QgsCoordinateTransform(windows.crs(), settings.destinationCrs(), QgsProject.instance())
    settings.setExtent(to_map.transformBoundingBox(extent))
    context = QgsExpressionContext()
    for scope in (
        QgsExpressionContextUtils.projectScope(QgsProject.instance()),
        selection_scope(windows),
        QgsExpressionContextUtils.mapSettingsScope(settings),
    ):
        context.appendScope(scope)
    settings.setExpressionContext(context)
    job = QgsMapRendererParallelJob(settings)
    job.start()
    wait_until(lambda: not job.isActive(), "for the map")
    result = job.takeLabelingResults().labelsWithinRect(settings.visibleExtent())
    return {int(label.labelText.split(" · ")[0]): label.labelRect for label in result if not label.isUnplaced}


@pytest.mark.parametrize("crs", ["EPSG:2180", "EPSG:4326"])
def test_each_window_has_its_label_in_its_corner(windows: QgsVectorLayer, crs: str) -> None:
    items = labels(windows, box(-20, 40, 240, 230), [], crs)
    assert set(items) == set(CORNERS)
    if crs == "EPSG:2180":
        for number, rect in items.items():
            x, y = CORNERS[number]
            assert box(x, y + 0.8 * SIDE_M, x + 0.4 * SIDE_M, y + SIDE_M).contains(rect)


@pytest.fixture
def own_locale(qgis_app: QgsApplication) -> Iterator[None]:
    """How numbers are written, to be changed."""
    before = QLocale()
    yield
    QLocale.setDefault(before)


@pytest.mark.parametrize("omits_groups", [False, True])  # as QGIS is set to, unless its user wants them
def test_a_label_tells_the_loss_as_the_table_does(
    project: QgsProject, repository: Path, own_locale: None, omits_groups: bool
) -> None:
    if omits_groups:
        locale = QLocale()
        locale.setNumberOptions(QLocale.NumberOption.OmitGroupSeparator)
        QLocale.setDefault(locale)
    layer = QgsVectorLayer("Polygon?field=window_id:integer&field=loss:double", "windows", "memory")
    message, worked = layer.loadNamedStyle(str(repository / "resources" / "styles" / "windows.qml"))
    assert worked, message
    label = QgsExpression(layer.labeling().settings().fieldName)
    (column,) = [item for item in COLUMNS if item.name == "loss"]
    for loss in (None, 0.0, 0.26, 9.94, 10.0, 81.4, 8704.0):
        feature = QgsFeature(layer.fields())
        feature.setAttributes([1, loss])
        context = QgsExpressionContext()
        context.setFeature(feature)
        shown = column.text(WindowRecord(1, (0, 0, 1, 1), "significant", loss=loss))
        assert label.evaluate(context) == " · ".join(filter(None, ("1", shown)))
