"""While windows are judged: QGIS's panels make room for the map, and what lies over the mosaic is off it."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsApplication, QgsProject, QgsRectangle
from qgis.gui import QgisInterface
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtWidgets import QAction, QDockWidget

from ...toolkit.connections import Connections
from ...toolkit.desk.tool_dock import ToolDock
from ...toolkit.translation import filled, tr
from .judging_desk import covering, over_the_mosaic
from .map.window_outline import WindowOutline

if TYPE_CHECKING:
    from .session import Session

_HIDDEN = "seam_inspector/hidden"  # custom property of what was taken off the map
_SHOWN = "seam_inspector/shown"  # of a mosaic that was not on it


class JudgingLayout(QObject):
    """``action`` enters and leaves it. All is as before once it is left, at the latest with the project or the dock."""

    def __init__(self, iface: QgisInterface, dock: ToolDock, session: Session) -> None:
        super().__init__(dock)
        self._window, self._canvas = iface.mainWindow(), iface.mapCanvas()
        self._dock, self._session = dock, session
        self._panels: list[tuple[QDockWidget, bool]] = []  # that made room, and whether each was in sight
        self._outline = WindowOutline(self._canvas)
        self.action = QAction(QgsApplication.getThemeIcon("/mActionShowAllLayers.svg"), tr("Judge"), dock)
        self.action.setToolTip(
            tr("Judge window after window: hides QGIS's panels and what lies over the mosaic (J); again: shows them as "
               "before")
        )
        self.action.setCheckable(True)
        self.action.toggled.connect(self._toggle)
        self._project = QgsProject.instance()
        self._connections = Connections(
            (self._project.cleared, self.leave), (self._project.readProject, self.leave),
            (dock.visibilityChanged, self._follow_dock), (session.selectionChanged, self._mark),
            (session.windowsChanged, self._mark),
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
        self._outline.close()
        self._connections.close()

    def _toggle(self, is_on: bool) -> None:
        if is_on:
            self._make_room()
            self._canvas.setFocus()
        else:
            self._give_room()
        self._mark()

    def _mark(self, *_: object) -> None:
        """The one window that is judged: all others would hide what is to be seen."""
        selected, layer = self._session.selected(), self._session.window_layer()
        row = self._session.row(selected[0]) if self.is_on and len(selected) == 1 else None
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
            dock for dock in self._window.findChildren(QDockWidget)
            if dock is not self._dock and dock.toggleViewAction().isChecked() and not dock.isFloating()
        ]  # fmt: skip
        self._panels = [(dock, not dock.visibleRegion().isEmpty()) for dock in docks]
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

    def _give_room(self) -> None:
        panels, self._panels = self._panels, []
        _put_back(self._project)
        there = [] if sip.isdeleted(self._window) else [pair for pair in panels if not sip.isdeleted(pair[0])]
        for panel, _ in there:
            panel.show()
        for panel, was_seen in there:
            if was_seen:
                panel.raise_()


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
