"""The hands and eyes of a scenario that is played in the real QGIS desktop. See demo/desktop.py."""
from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from qgis.core import QgsPointXY, QgsProject, QgsRasterLayer, QgsRectangle, QgsVectorLayer
from qgis.PyQt.QtCore import QEventLoop, QPoint, Qt, QTimer
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QTabWidget, QWidget
from qgis.utils import iface, plugins

from demo.project import SEAM_COLOUR, SEAM_WIDTH_MM

PATIENCE = 4  # times what a wait may take on a machine of its own: a slow or busy one is no fault of the plugin
Point = tuple[float, float]
_LEFT, _NO_KEY = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier


class Desk:
    """The main window, the map, and the plugin's dock once it is open."""

    def __init__(self, job: dict[str, Any], raised: list[str]) -> None:
        self._raised = raised
        self.folder = Path(job["folder"])
        self.parameters: dict[str, Any] = job["parameters"]
        self.report: dict[str, Any] = {}
        self.window = iface.mainWindow()
        self.canvas = iface.mapCanvas()
        self.project = QgsProject.instance()
        screen = self.window.screen().availableGeometry()
        self.window.showNormal()
        self.window.setGeometry(screen)
        for name in ("Browser", "mPanelToolbar"):
            panel = self.window.findChild(QWidget, name)
            if panel is not None:
                panel.hide()
        self.pause(0.5)

    @property
    def plugin(self) -> Any:
        """The plugin, as QGIS loaded it."""
        return plugins["seam_inspector"]

    @property
    def dock(self) -> Any:
        """The inspection desk; None before it was opened."""
        return self.plugin.desk("seamInspectorAction").dock

    @property
    def session(self) -> Any:
        """The dock's model."""
        return self.dock.session

    # Waiting

    def wait(self, condition: Callable[[], object], seconds: float, what: str) -> None:
        """Let a true event loop run until the condition holds, ``PATIENCE`` times as long as it should take.

        Raises AssertionError when the time is up, or when a slot raised meanwhile.
        """
        loop, timer = QEventLoop(), QTimer()
        end = time.monotonic() + PATIENCE * seconds
        held = bool(condition())  # what held for a moment has held, though the next task may have begun since

        def look() -> None:
            nonlocal held
            held = bool(condition())
            if held or time.monotonic() > end or self._raised:
                timer.stop()
                loop.quit()

        timer.timeout.connect(look)
        if not held:
            timer.start(10)
            loop.exec()
        assert not self._raised, f"{what}: not before a slot raised"
        assert held, f"{what}: not after {seconds:g} s"

    def pause(self, seconds: float) -> None:
        """Let events run for a while."""
        loop = QEventLoop()
        QTimer.singleShot(int(seconds * 1000), loop.quit)
        loop.exec()

    def wait_for_work(self, seconds: float = 60) -> None:
        """Until no window is being placed or inspected, and the map is drawn."""
        self.wait(lambda: not self.session.is_busy, seconds, "background work done")
        self.wait_for_map()

    def wait_for_map(self, seconds: float = 30) -> None:
        """Until the map is drawn."""
        self.pause(0.3)
        self.wait(lambda: not self.canvas.isDrawing(), seconds, "map drawn")
        self.pause(0.2)

    # Loading

    def load_rasters(self, paths: list[Path]) -> list[QgsRasterLayer]:
        """Add rasters, the last one on top."""
        layers = [QgsRasterLayer(str(path), path.stem) for path in paths]
        assert all(layer.isValid() for layer in layers)
        for layer in layers:
            self.project.addMapLayer(layer)
        for node in self.project.layerTreeRoot().findLayers():
            node.setExpanded(False)
        return layers

    def load_seamlines(self, path: Path) -> QgsVectorLayer:
        """Add the layer ``seamlines`` of a GeoPackage, in a colour that is seen on the mosaic."""
        layer = QgsVectorLayer(f"{path}|layername=seamlines", "seamlines")
        assert layer.isValid()
        layer.renderer().symbol().setColor(QColor(SEAM_COLOUR))
        layer.renderer().symbol().setWidth(SEAM_WIDTH_MM)
        self.project.addMapLayer(layer)
        return layer

    def open_dock(self) -> None:
        """Open the dock by the button of the toolbar."""
        action = next(
            action for action in iface.rasterToolBar().actions() if action.objectName() == "seamInspectorAction"
        )
        if self.dock is None or not self.dock.isVisible():
            action.trigger()
        self.wait(lambda: self.dock is not None and self.dock.isVisible(), 20, "dock open")
        self.pause(0.2)

    def set_up(self, block: Path, side_m: float, spacing_m: float, mosaic: str = "mosaic") -> None:
        """Load a block of orthoimages with its mosaic, open the dock, set the inputs, show the whole mosaic."""
        images = sorted(path for path in block.glob("*.tif") if not path.stem.startswith(("mosaic", "source_label")))
        *sources, top = self.load_rasters([*images, block / f"{mosaic}.tif"])
        seamlines = self.load_seamlines(block / "seamlines.gpkg")
        self.open_dock()
        self.session.set_inputs(
            replace(
                self.session.inputs,
                mosaic=top.id(),
                sources=tuple(layer.id() for layer in sources),
                seamlines=seamlines.id(),
                side_m=side_m,
                spacing_m=spacing_m,
            )
        )
        self.wait(lambda: self.session.mosaic_grid() is not None, 20, "mosaic open")
        self.show_all(top.extent())

    def show_all(self, extent: QgsRectangle) -> None:
        """Zoom out to an extent."""
        self.canvas.setExtent(extent.buffered(0.02 * extent.width()))
        self.canvas.refresh()
        self.wait_for_map()

    # Mouse and keys

    def pixel(self, point: Point) -> QPoint:
        """Where a point of the map is on the canvas."""
        place = self.canvas.getCoordinateTransform().transform(QgsPointXY(*point))
        return QPoint(round(place.x()), round(place.y()))

    def move(self, point: Point) -> None:
        """Move the mouse over the map."""
        QTest.mouseMove(self.canvas.viewport(), self.pixel(point))
        self.pause(0.1)

    def click(self, point: Point, modifiers: Qt.KeyboardModifier = _NO_KEY) -> None:
        """Click on the map; with Ctrl our tool makes a window also where there is one already."""
        QTest.mouseMove(self.canvas.viewport(), self.pixel(point))
        QTest.mouseClick(self.canvas.viewport(), _LEFT, modifiers, self.pixel(point))

    def drag(self, start: Point, end: Point, before_release: Callable[[], None] | None = None) -> None:
        """Drag on the map. Moves coalesce under X, so nothing depends on how many were seen."""
        view, first, last = self.canvas.viewport(), self.pixel(start), self.pixel(end)
        QTest.mousePress(view, _LEFT, _NO_KEY, first)
        for step in range(1, 11):
            QTest.mouseMove(view, first + (last - first) * step / 10)
            self.pause(0.02)
        if before_release is not None:
            before_release()
        QTest.mouseRelease(view, _LEFT, _NO_KEY, last)

    def press(self, key: Qt.Key) -> None:
        """Press a key where the focus is, in the dock's table."""
        self.window.activateWindow()
        self.dock.windows.table.setFocus()
        self.wait(lambda: QApplication.focusWidget() is self.dock.windows.table, 5, "focus in the table")
        QTest.keyClick(self.dock.windows.table, key)
        self.pause(0.3)

    def press_on_map(self, key: Qt.Key) -> None:
        """Press a key where the map has the focus, and wait until it is up."""
        self.window.activateWindow()
        self.canvas.setFocus()
        self.wait(self.canvas.hasFocus, 5, "focus on the map")
        QTest.keyClick(self.canvas, key)
        self.pause(0.1)

    def press_in(self, widget: QWidget, key: Qt.Key, modifiers: Qt.KeyboardModifier = _NO_KEY) -> None:
        """Press a key where a widget has the focus, and wait until it is up."""
        widget.window().activateWindow()
        widget.setFocus()
        self.pause(0.1)
        QTest.keyClick(QApplication.focusWidget() or widget, key, modifiers)
        self.pause(0.15)

    def place_and_inspect(self) -> None:
        """Windows along the seams, with their verdicts."""
        self.dock.place.trigger()
        self.wait(lambda: self.session.windows() and not self.session.is_busy, 60, "windows placed")
        self.dock.inspect.trigger()
        self.wait(lambda: all(row.verdict for row in self.session.windows()), 120, "all windows inspected")
        self.wait_for_work()

    @contextmanager
    def judging(self) -> Iterator[None]:
        """J unless judging is on, and at the end all of the desk again."""
        layout = self.dock.judging
        if not layout.is_on:
            self.press_on_map(Qt.Key.Key_J)
        self.wait(lambda: layout.is_on, 5, "judging")
        yield
        self.press_on_map(Qt.Key.Key_J)
        self.wait(lambda: not layout.is_on, 5, "all of the desk again")

    def rest_mouse(self) -> None:
        """Away from the map, so that no draft is on the screenshots; nor a message."""
        iface.messageBar().clearWidgets()
        QTest.mouseMove(self.window, QPoint(5, 5))
        self.pause(0.2)

    # Seeing

    def screenshot(self, path: str | Path) -> None:
        """Save the main window's picture."""
        self.pause(0.3)
        path = Path(path)
        path.parent.mkdir(parents=True, exist_ok=True)
        assert self.window.grab().save(str(path)), f"can't write {path}"
        self.report.setdefault("screenshots", []).append(str(path))

    def show_tab(self, number: int) -> None:
        """0: curves, 1: images."""
        self.dock.findChild(QTabWidget).setCurrentIndex(number)
        self.pause(0.3)

    def sort_by_loss(self) -> None:
        """By a click on its heading: the worst first."""
        table = self.dock.windows.table
        header, first = table.horizontalHeader(), Qt.ItemDataRole.InitialSortOrderRole
        orders = [
            table.model().headerData(section, Qt.Orientation.Horizontal, first)
            for section in range(header.count())
        ]
        section = orders.index(Qt.SortOrder.DescendingOrder)
        place = QPoint(header.sectionViewportPosition(section) + header.sectionSize(section) // 2, header.height() // 2)
        QTest.mouseClick(header.viewport(), Qt.MouseButton.LeftButton, _NO_KEY, place)

    def headings(self) -> list[str]:
        """The headings of the windows' table that are seen."""
        table = self.dock.windows.table
        places = [place for place in range(table.model().columnCount()) if not table.isColumnHidden(place)]
        return [str(table.model().headerData(place, Qt.Orientation.Horizontal)) for place in places]

    def table(self) -> list[list[str]]:
        """The texts of the windows' table, row by row."""
        model = self.dock.windows.table.model()
        role = Qt.ItemDataRole.DisplayRole
        return [
            [str(model.index(row, column).data(role) or "") for column in range(model.columnCount())]
            for row in range(model.rowCount())
        ]

    def curves_of(self, fid: int) -> bool:
        """Whether the chart shows a window's curves."""
        result, panel = self.session.result(fid), self.dock.curves.curves
        return bool(result is not None and panel.shown == [result])

    def first_curves_of(self, fid: int) -> bool:
        """Whether the chart shows the curves of a window's clips, whatever else is still to come."""
        clips, panel = self.session.clips(fid), self.dock.curves.curves
        return bool(clips is not None and panel.shown == [clips])

    # Leaving

    def save_and_reopen(self) -> None:
        """The project is saved; the project opened again has inputs, windows and judgements."""
        before, inputs = self._windows(), self.session.inputs
        path = str(self.folder / "project.qgz")
        assert self.project.write(path)
        self.new_project()
        assert self.session.windows() == []
        assert not self.session.inputs.mosaic
        assert self.project.read(path)
        self.wait(lambda: len(self.session.windows()) == len(before), 20, "windows back")
        self.wait(lambda: self.session.mosaic_grid() is not None, 20, "mosaic open again")
        assert self._windows() == before
        assert self.session.inputs == inputs

    def _windows(self) -> list[tuple[Any, ...]]:
        """What the project keeps of the windows."""
        return [
            (row.window_id, row.verdict, row.ratios, row.observer, row.stale) for row in self.session.windows()
        ]

    def new_project(self) -> None:
        """An empty project, as by QGIS's own button."""
        self.drop_changes()
        iface.newProject(False)
        self.pause(0.3)

    def drop_changes(self) -> None:
        """Forget what is not saved, so that no dialog asks."""
        for layer in self.project.mapLayers().values():
            if isinstance(layer, QgsVectorLayer) and layer.isEditable():
                layer.rollBack()
        self.project.setDirty(False)
