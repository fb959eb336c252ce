"""The dock of bar groups and its map tool: draw, watch the profile, find the lines in the layer, leave nothing."""
from __future__ import annotations

import importlib
import re
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsPointXY,
    QgsProject,
    QgsRasterLayer,
    QgsRectangle,
)
from qgis.gui import QgisInterface, QgsMapCanvas, QgsMapMouseEvent, QgsMapTool, QgsRubberBand
from qgis.PyQt.QtCore import QEvent, QPoint, Qt
from qgis.PyQt.QtGui import QKeyEvent
from qgis.PyQt.QtWidgets import QAction
from seam_inspector.plugin.resolution.desk import bar_dock
from seam_inspector.plugin.resolution.desk.bar_dock import BarDock

from tests.qgis.resolution.bar_scenes import COARSEST_CM, BarScene, make_bar_scene
from tests.qgis.scenes import at, layer
from tests.qgis.seams.desk.session_desk import settle, wait_for_tasks, wait_until

LEFT, RIGHT, NONE = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton, Qt.MouseButton.NoButton
Place = tuple[float, float]


class Operator:
    """Mouse over a map of the target; places are columns and rows."""

    def __init__(self, dock: BarDock, canvas: QgsMapCanvas, scene: BarScene) -> None:
        self.dock, self.canvas, self.scene, self.tool = dock, canvas, scene, dock.tool

    def event(self, kind: QEvent.Type, place: Place, button: Qt.MouseButton, held: Qt.MouseButton) -> QgsMapMouseEvent:
        point = self.canvas.getCoordinateTransform().transform(QgsPointXY(*at(*place)))
        return QgsMapMouseEvent(self.canvas, kind, QPoint(round(point.x()), round(point.y())), button, held)

    def press(self, place: Place, button: Qt.MouseButton = LEFT) -> None:
        self.tool.canvasPressEvent(self.event(QEvent.Type.MouseButtonPress, place, button, button))

    def move(self, place: Place) -> None:
        self.tool.canvasMoveEvent(self.event(QEvent.Type.MouseMove, place, NONE, LEFT))

    def release(self, place: Place, button: Qt.MouseButton = LEFT) -> None:
        self.tool.canvasReleaseEvent(self.event(QEvent.Type.MouseButtonRelease, place, button, NONE))

    def draw(self, group: int, direction: str = "along") -> None:
        start, end = self.ends(group, direction)
        self.press(start)
        self.move(end)
        self.release(end)

    def ends(self, group: int, direction: str = "along") -> tuple[Place, Place]:
        ends = self.scene.groups[group, direction].line()
        return ends[:2], ends[2:]

    def rows(self) -> list[tuple[int, str]]:
        lines = self.dock.line_layer()
        return [] if lines is None else [(row["group"], row["direction"]) for row in lines.getFeatures()]

    @property
    def bands(self) -> list[QgsRubberBand]:
        return [item for item in self.canvas.scene().items() if isinstance(item, QgsRubberBand)]


@pytest.fixture
def operator(
    qgis_iface: QgisInterface, qgis_canvas: QgsMapCanvas, project: QgsProject, tmp_path: Path
) -> Iterator[Operator]:
    """The dock on a map of the target at four screen pixels a pixel."""
    scene = make_bar_scene(tmp_path)
    project.setPresetHomePath(str(tmp_path))
    raster = QgsRasterLayer(scene.path, "target")
    project.addMapLayer(raster)
    canvas = qgis_iface.mapCanvas()
    frame = 2 * canvas.frameWidth()
    canvas.resize(4 * raster.width() + frame, 4 * raster.height() + frame)
    canvas.grab()  # a canvas that is not shown learns of its size only when it is painted
    canvas.setDestinationCrs(QgsCoordinateReferenceSystem("EPSG:32633"))
    canvas.setExtent(QgsRectangle(raster.extent()))
    dock = BarDock(qgis_iface)
    dock.image.setLayer(raster)
    dock.settings.reference_group.setValue(1)
    dock.settings.reference_grd.setValue(COARSEST_CM)
    wait_until(dock.draw.isEnabled, "for the image")
    dock.draw.trigger()
    yield Operator(dock, canvas, scene)
    dock.close_desk()
    wait_for_tasks()
    dock.deleteLater()
    settle()


def test_a_drawn_line_goes_into_a_layer_of_its_own_and_the_next_group_is_taken(operator: Operator) -> None:
    operator.draw(1)
    operator.draw(2)
    assert operator.rows() == [(1, "along"), (2, "along")]
    assert operator.dock.group.value() == 3
    lines = operator.dock.line_layer()
    assert lines is not None
    assert lines.isEditable()
    assert Path(lines.source().split("|")[0]).name == "bar_groups.gpkg"
    lines.undoStack().undo()
    assert operator.rows() == [(1, "along")]
    assert lines.commitChanges()


def test_the_profile_is_shown_while_the_line_moves(operator: Operator) -> None:
    start, end = operator.ends(1)
    operator.press(start)
    operator.move(end)
    wait_until(lambda: operator.dock.results, "for the profile")
    assert len(operator.dock.results) == 3
    assert all(len(result.reading.bars) == 3 for result in operator.dock.results if result.reading is not None)
    assert "resolved" in operator.dock.verdict.text()
    assert operator.rows() == []
    assert [band.isVisible() for band in operator.bands] == [True]


@pytest.fixture
def slow_header(operator: Operator, monkeypatch: pytest.MonkeyPatch) -> Iterator[threading.Event]:
    """Images open once it is set, at the latest at the test's end."""
    may_end, genuine = threading.Event(), bar_dock.describe_north_up

    def describe(ref):  # type: ignore[no-untyped-def]
        may_end.wait()
        return genuine(ref)

    monkeypatch.setattr(bar_dock, "describe_north_up", describe)
    yield may_end
    may_end.set()
    wait_for_tasks()


def another_image(operator: Operator) -> QgsRasterLayer:
    """The target's file as a second layer, chosen in the dock."""
    image = QgsRasterLayer(operator.scene.path, "the same")
    QgsProject.instance().addMapLayer(image)
    operator.dock.image.setLayer(image)
    return image


def test_the_lines_of_a_target_are_judged_together(operator: Operator) -> None:
    """What the layer holds counts, whoever drew it; the distance and its deviation are of all lines."""
    for group in (1, 2, 3):
        operator.dock.group.setValue(2 * group - 1)  # the scene's are two steps of the dock's target apart
        operator.draw(group)
    wait_for_tasks()
    wait_until(lambda: "Group 5" in operator.dock.verdict.text(), "for the last line")
    line, together = operator.dock.verdict.text().split("\n")
    assert re.match(r"Group 5, 63\.00 ± \d\.\d\d cm, resolved \(amplitude \d\d\u00a0% of the full one\)", line)
    assert re.match(r"All lines: along the flight: 63\.00 ± \d\.\d\d cm; contrast of the target [45]\.\d:1", together)
    assert {result.measured.line.group for result in operator.dock.results} == {5}


def test_an_image_that_opens_slowly(operator: Operator, slow_header: threading.Event) -> None:
    another_image(operator)
    start, end = operator.ends(1)
    operator.press(start)
    operator.move(end)
    operator.release(end)
    settle()
    assert operator.dock.verdict.text() == "Reading the pictures ..."
    assert not operator.dock.draw.isEnabled()
    assert operator.rows() == []
    assert not operator.dock.results
    slow_header.set()
    wait_until(operator.dock.draw.isEnabled, "for the image")
    assert operator.dock.draw.isChecked()  # the tool stays at hand meanwhile
    operator.draw(1)
    assert operator.rows() == [(1, "along")]


def test_an_image_that_can_not_be_opened_says_why(operator: Operator, tmp_path: Path) -> None:
    gone = tmp_path / "gone.tif"
    gone.write_bytes(Path(operator.scene.path).read_bytes())
    image = QgsRasterLayer(str(gone), "gone")
    QgsProject.instance().addMapLayer(image)
    gone.unlink()
    operator.dock.image.setLayer(image)
    wait_until(lambda: "gone.tif does not exist" in operator.dock.verdict.text())
    assert not operator.dock.draw.isEnabled()
    assert not operator.dock.draw.isChecked()


def test_a_closed_dock_gives_the_map_its_former_tool_back(operator: Operator) -> None:
    dock, canvas = operator.dock, operator.canvas
    former = QgsMapTool(canvas)
    canvas.setMapTool(former)
    dock.setFloating(True)
    dock.show()
    dock.draw.trigger()
    assert canvas.mapTool() is dock.tool
    dock.hide()
    assert canvas.mapTool() is former
    assert not dock.draw.isChecked()


def test_escape_and_the_right_button(operator: Operator) -> None:
    start, end = operator.ends(1)
    operator.press(start)
    operator.move(end)
    operator.canvas.keyPressed.emit(QKeyEvent(QEvent.Type.KeyPress, Qt.Key.Key_Escape, Qt.KeyboardModifier.NoModifier))
    operator.release(end)
    assert operator.rows() == []
    operator.press(start)
    operator.release(end, RIGHT)
    assert operator.dock.draw.isChecked()
    operator.release(end, RIGHT)
    assert not operator.dock.draw.isChecked()


def test_the_previous_tool_comes_back_and_nothing_stays(operator: Operator) -> None:
    canvas = operator.canvas
    operator.dock.draw.trigger()
    items = len(canvas.scene().items())
    previous = QgsMapTool(canvas)
    canvas.setMapTool(previous)
    for _ in range(3):
        operator.dock.draw.trigger()
        start, end = operator.ends(1)
        operator.press(start)
        operator.move(end)
        operator.dock.draw.trigger()
        assert canvas.mapTool() is previous
        assert len(canvas.scene().items()) == items
    canvas.unsetMapTool(previous)


def test_the_plugin_shows_the_dock_and_takes_it_along(qgis_iface: QgisInterface, project: QgsProject) -> None:
    plugin = importlib.import_module("seam_inspector").classFactory(qgis_iface)
    window = qgis_iface.mainWindow()
    for _ in range(2):
        plugin.initGui()
        action = window.findChild(QAction, "seamInspectorBarAction")
        action.trigger()
        assert window.findChildren(BarDock)
        plugin.unload()
        settle()
        assert not window.findChildren(BarDock)
        assert window.findChild(QAction, "seamInspectorBarAction") is None


def test_lines_of_other_things_are_not_offered(operator: Operator) -> None:
    seams = layer("LineString", [])
    seams.setName("seams")
    QgsProject.instance().addMapLayer(seams)
    names = [operator.dock.lines.itemText(row) for row in range(operator.dock.lines.count())]
    assert names == ["new layer"]
    assert operator.dock.line_layer() is None
