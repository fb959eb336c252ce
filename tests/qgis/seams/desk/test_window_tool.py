"""The map tool: clicks, drags, what is shown while moving, and what is left afterwards."""
from __future__ import annotations

from collections.abc import Iterator

import pytest
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsPointXY,
    QgsProject,
    QgsRasterLayer,
    QgsRectangle,
)
from qgis.gui import QgsMapCanvas, QgsMapMouseEvent, QgsRubberBand, QgsVertexMarker
from qgis.PyQt.QtCore import QEvent, QPoint, Qt
from qgis.PyQt.QtWidgets import QApplication, QLabel
from seam_inspector.plugin.imagery.grids import Grid, PixelWindow
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs
from seam_inspector.plugin.seams.desk.map.window_tool import WindowTool
from seam_inspector.plugin.seams.measure.window_records import WindowRecord

from tests.qgis.scenes import ORIGIN, PIXEL, Scene, at, windows
from tests.qgis.seams.desk.fake_session import FakeSession

LEFT, RIGHT, NONE = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton, Qt.MouseButton.NoButton
SHIFT, CONTROL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier
UTM33 = QgsCoordinateReferenceSystem("EPSG:32633")
WEB_MERCATOR = QgsCoordinateReferenceSystem("EPSG:3857")
MIDDLE = (2048, 1024)  # column and row in the middle of the session's mosaic


class Operator:
    """Mouse and keyboard over a map; places are columns and rows of the mosaic."""

    def __init__(self, canvas: QgsMapCanvas, tool: WindowTool, session: FakeSession) -> None:
        self.canvas, self.tool, self.session = canvas, tool, session
        self.modifiers = Qt.KeyboardModifier.NoModifier

    def press(self, place: tuple[float, float], button: Qt.MouseButton = LEFT) -> None:
        self.tool.canvasPressEvent(self._event(QEvent.Type.MouseButtonPress, place, button, button))

    def move(self, place: tuple[float, float], button: Qt.MouseButton = NONE) -> None:
        self.tool.canvasMoveEvent(self._event(QEvent.Type.MouseMove, place, NONE, button))

    def release(self, place: tuple[float, float], button: Qt.MouseButton = LEFT) -> None:
        self.tool.canvasReleaseEvent(self._event(QEvent.Type.MouseButtonRelease, place, button, NONE))

    def click(self, place: tuple[float, float], button: Qt.MouseButton = LEFT) -> None:
        self.press(place, button)
        self.release(place, button)

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        self.press(start)
        self.move(end, LEFT)
        self.release(end)

    def on_screen(self, place: tuple[float, float]) -> QPoint:
        point = self.canvas.getCoordinateTransform().transform(self.on_map(place))
        return QPoint(round(point.x()), round(point.y()))

    def on_map(self, place: tuple[float, float]) -> QgsPointXY:
        crs = self.canvas.mapSettings().destinationCrs()
        return QgsCoordinateTransform(UTM33, crs, QgsProject.instance()).transform(QgsPointXY(*at(*place)))

    def _event(
        self, kind: QEvent.Type, place: tuple[float, float], button: Qt.MouseButton, buttons: Qt.MouseButton
    ) -> QgsMapMouseEvent:
        return QgsMapMouseEvent(self.canvas, kind, self.on_screen(place), button, buttons, self.modifiers)

    # what there is to see

    @property
    def label(self) -> QLabel | None:
        return next((label for label in self.canvas.findChildren(QLabel) if label.isVisibleTo(self.canvas)), None)

    @property
    def text(self) -> str:
        return self.label.text() if self.label is not None else ""

    @property
    def outline(self) -> QgsRectangle:
        """The rubber band, on the map."""
        bands = [item for item in self.canvas.scene().items() if isinstance(item, QgsRubberBand)]
        return bands[0].asGeometry().boundingBox() if bands else QgsRectangle()

    @property
    def has_mark(self) -> bool:
        items = self.canvas.scene().items()
        return any(isinstance(item, QgsVertexMarker) and item.isVisible() for item in items)


@pytest.fixture
def operator(qgis_canvas: QgsMapCanvas, project: QgsProject, scene: Scene) -> Iterator[Operator]:
    """The tool on a map of the mosaic at a quarter of its pixels."""
    layer = QgsRasterLayer(str(scene.mosaic), "mosaic")
    project.addMapLayer(layer)
    session = FakeSession(Inputs(mosaic=layer.id(), side_m=10))  # 128 px
    frame = 2 * qgis_canvas.frameWidth()
    qgis_canvas.resize(1024 + frame, 512 + frame)
    qgis_canvas.grab()  # a canvas that is not shown learns of its size only when it is painted
    qgis_canvas.setDestinationCrs(UTM33)
    qgis_canvas.setExtent(QgsRectangle(*Grid(*ORIGIN, PIXEL, PIXEL, 4096, 2048).extent))
    tool = WindowTool(qgis_canvas, session)
    qgis_canvas.setMapTool(tool)
    yield Operator(qgis_canvas, tool, session)
    tool.close()
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def test_click_places_the_standard_window_around_it(operator: Operator) -> None:
    operator.click(MIDDLE)
    assert operator.session.added == [PixelWindow(2048 - 64, 1024 - 64, 128, 128)]


def test_click_near_a_seam_is_moved_onto_it(operator: Operator) -> None:
    operator.session.seam_x = at(2048, 0)[0]
    operator.move((2048 + 40, 1024))  # 10 screen pixels beside it
    assert operator.has_mark
    operator.click((2048 + 40, 1024))
    operator.move((2048 + 80, 1024))
    assert not operator.has_mark
    operator.click((2048 + 80, 1024))
    assert [window.column for window in operator.session.added] == [2048 - 64, 2048 + 80 - 64]


def test_drag_is_snapped_while_it_is_drawn(operator: Operator) -> None:
    operator.press((400, 400))
    operator.move((1004, 812), LEFT)
    assert operator.text == "60.0 x 40.8 m, 600 x 408 px"
    operator.release((1004, 812))
    assert operator.session.added == [PixelWindow(402, 402, 600, 408)]
    assert operator.text == ""


@pytest.mark.parametrize(
    ("start", "end", "why"),
    [
        ((400, 400), (440, 900), "a side needs at least 64 px"),
        ((-900, 400), (-100, 900), "lies outside the mosaic"),
    ],
)
def test_label_says_why_a_drag_is_no_window(
    operator: Operator, start: tuple[int, int], end: tuple[int, int], why: str
) -> None:
    operator.canvas.setExtent(operator.canvas.extent().buffered(200))
    operator.press(start)
    operator.move(end, LEFT)
    assert why in operator.text
    operator.release(end)
    assert operator.session.added == []
    assert why in operator.text


def test_where_no_source_lies_the_outline_says_so_and_a_click_makes_it_all_the_same(operator: Operator) -> None:
    operator.session.source_count = 0
    operator.move(MIDDLE)
    assert operator.text.endswith("no source lies there")
    operator.click(MIDDLE)
    assert operator.session.added == [PixelWindow(2048 - 64, 1024 - 64, 128, 128)]


def test_where_nothing_can_be_compared_the_outline_says_so_once_that_is_known(operator: Operator) -> None:
    operator.move(MIDDLE)
    assert operator.text == "12.8 x 12.8 m, 128 x 128 px"
    operator.session.useless = PixelWindow(2048 - 64, 1024 - 64, 128, 128)
    operator.session.liveChanged.emit()
    assert operator.text == "12.8 x 12.8 m, 128 x 128 px, nothing can be compared there"
    operator.move((2048 + 40, 1024))
    assert operator.text == "12.8 x 12.8 m, 128 x 128 px"


def test_other_map_reference_system(operator: Operator) -> None:
    operator.canvas.setDestinationCrs(WEB_MERCATOR)
    operator.canvas.setExtent(QgsRectangle(operator.on_map((0, 2048)), operator.on_map((4096, 0))))
    operator.click(MIDDLE)
    operator.move(MIDDLE)
    window = operator.session.added[0]
    assert abs(window.column - 1984) <= 4
    assert abs(window.row - 960) <= 4
    for corner in ((window.column, window.row), (window.column + 128, window.row + 128)):
        assert operator.outline.buffered(0.01).contains(operator.on_map(corner))
    operator.drag((1000, 500), (1800, 1300))
    drawn = operator.session.added[1]
    assert abs(drawn.width - 800) <= 16
    assert abs(drawn.height - 800) <= 16


def test_right_click_ends_but_only_cancels_within_a_drag(operator: Operator) -> None:
    ended: list[None] = []
    operator.tool.finished.connect(lambda: ended.append(None))
    operator.press((400, 400))
    operator.move((1000, 800), LEFT)
    operator.click((1000, 800), RIGHT)
    operator.release((1000, 800))
    assert not ended
    operator.click(MIDDLE, RIGHT)
    assert len(ended) == 1
    assert operator.session.added == []


def test_nothing_is_left_after_another_tool_or_close(qgis_canvas: QgsMapCanvas, operator: Operator) -> None:
    items, children = len(qgis_canvas.scene().items()), len(qgis_canvas.findChildren(QLabel))
    receivers = qgis_canvas.receivers(qgis_canvas.extentsChanged)
    for _ in range(10):
        qgis_canvas.setMapTool(operator.tool)
        operator.session.seam_x = at(*MIDDLE)[0]
        operator.move(MIDDLE)
        assert len(qgis_canvas.scene().items()) == items + 2
        qgis_canvas.unsetMapTool(operator.tool)
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        assert len(qgis_canvas.scene().items()) == items
        assert len(qgis_canvas.findChildren(QLabel)) == children
        assert qgis_canvas.receivers(qgis_canvas.extentsChanged) == receivers
        assert operator.session.receivers(operator.session.inputsChanged) == 0


# Windows that are there


@pytest.fixture
def with_windows(operator: Operator) -> Operator:
    """Two windows that overlap by half, the second one to the right."""
    session = operator.session
    boxes = [(2000, 1000, 128, 128), (2064, 1000, 128, 128)]
    session.layer = windows(*boxes)
    session.rows = [
        WindowRecord(fid, Grid(*ORIGIN, PIXEL, PIXEL, 4096, 2048).window_extent(PixelWindow(*box)), fid=fid)
        for fid, box in enumerate(boxes, 1)
    ]
    return operator


def test_click_selects_the_window_that_is_there(with_windows: Operator) -> None:
    session = with_windows.session
    with_windows.click((2010, 1064))
    assert session.chosen == [1]
    with_windows.click((2100, 1064))  # in both, nearer to the middle of the second
    assert session.chosen == [2]
    assert session.added == []


def test_click_with_shift_adds_to_the_selection_and_takes_from_it(with_windows: Operator) -> None:
    with_windows.click((2010, 1064))
    with_windows.modifiers = SHIFT
    with_windows.click((2180, 1064))
    assert with_windows.session.chosen == [1, 2]
    with_windows.click((2010, 1064))
    assert with_windows.session.chosen == [2]


def test_click_with_control_and_a_drag_make_another_window_on_top(with_windows: Operator) -> None:
    with_windows.modifiers = CONTROL
    with_windows.click((2064, 1064))
    assert with_windows.session.added == [PixelWindow(2000, 1000, 128, 128)]
    with_windows.modifiers = Qt.KeyboardModifier.NoModifier
    with_windows.drag((2010, 1010), (2138, 1138))
    assert len(with_windows.session.added) == 2
    assert with_windows.session.chosen == []
