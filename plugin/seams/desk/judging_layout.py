"""While windows are judged: the map has QGIS's window, and the dock what was found and the buttons that judge."""
from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from qgis.core import QgsApplication, QgsProject, QgsRectangle
from qgis.gui import QgisInterface
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject, QSize, Qt
from qgis.PyQt.QtWidgets import QAction, QDockWidget

from ...toolkit.connections import Connections
from ...toolkit.desk.tool_dock import ToolDock
from ...toolkit.desk.widgets import single_shot
from ...toolkit.translation import filled, tr
from .judging_desk import covering, over_the_mosaic
from .map.seam_ticks import SeamTicks
from .map.window_outline import WindowOutline

if TYPE_CHECKING:
    from .session import Session

_HIDDEN = "seam_inspector/hidden"  # custom property of what was taken off the map
_SHOWN = "seam_inspector/shown"  # of a mosaic that was not on it
_CHARACTERS = 71  # of the sentence on a line: the dock's width then
_SIDES = (Qt.DockWidgetArea.LeftDockWidgetArea, Qt.DockWidgetArea.RightDockWidgetArea)


class JudgingLayout(QObject):
    """``action`` enters and leaves it. All is as before once it is left, at the latest with the project or the dock."""

    def __init__(self, iface: QgisInterface, dock: ToolDock, session: Session, fold: Callable[[bool], None]) -> None:
        """``fold`` leaves of the dock what judging takes."""
        super().__init__(dock)
        self._window, self._canvas = iface.mainWindow(), iface.mapCanvas()
        self._dock, self._session, self._fold = dock, session, fold
        self._sizes: list[tuple[QDockWidget, QSize]] = []  # of the docks around the map, ours among them
        self._given: list[tuple[QDockWidget, QSize]] = []  # those that they have back
        self._later = single_shot(self, self._resize_given)
        self._panels: list[tuple[QDockWidget, bool]] = []  # that made room, and whether each was in sight
        self._outline = WindowOutline(self._canvas)
        self.ticks = SeamTicks(self._canvas, session)
        self.action = QAction(QgsApplication.getThemeIcon("/mActionShowAllLayers.svg"), tr("Judge"), dock)
        self.action.setToolTip(
            tr("Judge window after window: the map takes the room, and what lies over the mosaic goes (J); again: all "
               "is as before")
        )
        self.action.setCheckable(True)
        self.action.toggled.connect(self._toggle)
        self._project = QgsProject.instance()
        self._connections = Connections(
            (self._project.cleared, self.leave), (self._project.readProject, self.leave),
            (dock.visibilityChanged, self._follow_dock), (session.selectionChanged, self._mark),
            (session.windowsChanged, self._mark), (session.resultArrived, self._mark),
        )  # fmt: skip
        _put_back(self._project)

    @property
    def is_on(self) -> bool:
        """Whether windows are judged now."""
        return bool(self.action.isChecked())

    def leave(self, *_: object) -> None:
        """All of the desk again, and what a project that was saved meanwhile has off its map."""
        self.action.setChecked(False)
        _put_back(self._project)

    def close(self) -> None:
        """Leave nothing behind."""
        self.leave()
        self._later.stop()
        self._outline.close()
        self.ticks.close()
        self._connections.close()

    def _toggle(self, is_on: bool) -> None:
        if is_on:
            self._make_room()
        self._fold(is_on)
        if is_on:
            self._narrow()
            self._canvas.setFocus()
        else:
            self._give_room()
        self._mark()

    def _mark(self, *_: object) -> None:
        """The one window that is judged, and where its seam is: all others would hide what is to be seen."""
        selected, layer = self._session.selected(), self._session.window_layer()
        row = self._session.row(selected[0]) if self.is_on and len(selected) == 1 else None
        self.ticks.show(None if row is None else row.fid)
        if row is None or row.extent is None or layer is None:
            self._outline.hide()
            return
        words = filled(tr("Window {number}"), number=row.window_id)
        self._outline.show(QgsRectangle(*row.extent), words, layer.crs())

    def _follow_dock(self, *_: object) -> None:
        if self._dock.isHidden():  # and not only behind another one, or with QGIS's window
            self.leave()

    def _make_room(self) -> None:
        docks = [
            one for one in self._window.findChildren(QDockWidget)
            if one.toggleViewAction().isChecked() and not one.isFloating()
        ]  # fmt: skip
        self._sizes = [(one, one.size()) for one in docks]
        self._panels = [(one, not one.visibleRegion().isEmpty()) for one in docks if one is not self._dock]
        for panel, _ in self._panels:
            panel.hide()
        self._uncover()

    def _uncover(self) -> None:
        """Off the map with what hides the mosaic: a verdict is of what is seen."""
        session, root = self._session, self._project.layerTreeRoot()
        windows, mosaic = root.findLayer(session.inputs.windows), root.findLayer(session.inputs.mosaic)
        above = [] if mosaic is None else over_the_mosaic(session)
        for node in (*covering(session), *above, *([windows] if windows is not None else [])):
            if node.isVisible():
                node.setCustomProperty(_HIDDEN, True)
                node.setItemVisibilityChecked(False)
        if mosaic is not None and not mosaic.itemVisibilityChecked():
            mosaic.setCustomProperty(_SHOWN, True)
            mosaic.setItemVisibilityChecked(True)

    def _narrow(self) -> None:
        if not self._dock.isFloating():
            width = _CHARACTERS * self._dock.fontMetrics().averageCharWidth()
            self._resize([(self._dock, QSize(width, self._dock.minimumSizeHint().height()))])

    def _give_room(self) -> None:
        panels, self._panels = self._panels, []
        self._given, self._sizes = self._sizes, []
        _put_back(self._project)
        if sip.isdeleted(self._window):
            return
        left = [(panel, was_seen) for panel, was_seen in panels if not sip.isdeleted(panel)]
        for panel, _ in left:
            panel.show()
        for panel, was_seen in left:
            if was_seen:
                panel.raise_()
        self._resize_given()
        self._later.start()  # a dock that was wider meanwhile is asked again how narrow its bar may be

    def _resize_given(self) -> None:
        if not self.is_on and not sip.isdeleted(self._window):
            self._resize([(one, size) for one, size in self._given if not sip.isdeleted(one)])

    def _resize(self, sizes: list[tuple[QDockWidget, QSize]]) -> None:
        """Docks beside the map in width, those above and below it in height."""
        for is_beside, way in ((True, Qt.Orientation.Horizontal), (False, Qt.Orientation.Vertical)):
            found = [pair for pair in sizes if (self._window.dockWidgetArea(pair[0]) in _SIDES) == is_beside]
            pixels = [size.width() if is_beside else size.height() for _, size in found]
            if found:
                self._window.resizeDocks([one for one, _ in found], pixels, way)


def _put_back(project: QgsProject) -> None:
    """On the map again, what judging took off it."""
    root = project.layerTreeRoot()
    for node in (*root.findLayers(), *root.findGroups(True)):
        if node.customProperty(_HIDDEN):
            node.removeCustomProperty(_HIDDEN)
            node.setItemVisibilityCheckedParentRecursive(True)
        if node.customProperty(_SHOWN):
            node.removeCustomProperty(_SHOWN)
            node.setItemVisibilityChecked(False)
