"""Puts judging together: model, bar, keys and table, what is hidden while blind, and the room that the map gets."""
from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING

from qgis.core import QgsApplication, QgsLayerTreeNode, QgsProject, QgsRasterLayer, QgsRectangle
from qgis.gui import QgisInterface
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtWidgets import QAction, QDockWidget

from ...toolkit.connections import Connections
from ...toolkit.desk.tool_dock import ToolDock
from ...toolkit.desk.widgets import is_confirmed
from ...toolkit.translation import filled, tr
from .judge_bar import JudgeBar
from .judging import Judging
from .map.window_tool import ClickedPieces
from .map.window_view import WindowOutline, WindowView
from .mosaic_scans import worst_layer
from .window_home import FAILURES, HIDDEN
from .windows.windows_panel import WindowsPanel

if TYPE_CHECKING:
    from .session import Session

class JudgingDesk(QObject):
    """``model``, ``bar`` and ``action``, by which windows are judged one after another, are for the dock to use.

    All is as before once that is left, at the latest with the project or the dock.
    """

    def __init__(
        self, iface: QgisInterface, session: Session, windows: WindowsPanel, dock: ToolDock, view: WindowView
    ) -> None:
        super().__init__(dock)
        self._window, self._canvas = iface.mainWindow(), iface.mapCanvas()
        self._session, self._windows, self._dock = session, windows, dock
        self._panels: list[tuple[QDockWidget, bool]] = []  # that made room, and whether each was in sight
        self._outline = WindowOutline(self._canvas)
        self._project = QgsProject.instance()
        self.model = Judging(session, windows.ordered_fids, partial(is_confirmed, dock), self, view.is_seen)
        self.pieces = ClickedPieces(self._canvas, session, self, lambda: self.model.is_blind)
        self.bar = JudgeBar(session, self.model, self.pieces)
        self.action = QAction(QgsApplication.getThemeIcon("/mActionShowAllLayers.svg"), tr("Judge"), dock)
        self.action.setToolTip(
            tr("Judge window after window: hides QGIS's panels and what lies over the mosaic (J); again: shows them as "
               "before")
        )
        self.action.setCheckable(True)
        self._connections = Connections(
            (self.model.changed, self._follow), (windows.orderChanged, self.bar.refresh),
            (self.action.toggled, self._toggle), (dock.visibilityChanged, self._follow_dock),
            (session.begunAnew, self.leave), (session.inputsChanged, self._hide_windows),
            (session.selectionChanged, self._mark), (session.windowsChanged, self._mark),
        )  # fmt: skip
        self._follow()

    @property
    def is_on(self) -> bool:
        """Whether windows are judged now."""
        return bool(self.action.isChecked())

    def leave(self, *_: object) -> None:
        """All of the desk again, and what a project that was saved meanwhile has off its map."""
        self.action.setChecked(False)
        self._arrange_map()

    def close(self) -> None:
        """Leave nothing behind."""
        self.leave()
        self._connections.close()
        _put_back(self._project)
        self._outline.close()
        self.model.close()
        self.pieces.close()
        self.bar.close()

    def key_actions(self) -> dict[str, Callable[[], bool]]:
        """What the keys that judge do, by their names."""
        return {**self.bar.key_actions(), "seamlines": partial(toggle_seamlines, self._session)}

    def _follow(self) -> None:
        """The operator or what is hidden changed."""
        model = self.model
        self._windows.show_for(model.operator, model.is_blind)
        if model.is_blind:
            self._session.lost_detail.setChecked(False)
        self._arrange_map()
        self.bar.refresh()

    def _follow_dock(self, *_: object) -> None:
        if self._dock.isHidden():  # and not only behind another one, or with QGIS's window
            self.leave()

    def _toggle(self, is_on: bool) -> None:
        self._arrange_map()
        if is_on:
            self._make_room()
            self._canvas.setFocus()
        else:
            self._give_room()

    # The map

    def _arrange_map(self) -> None:
        """Off the map with what hides the mosaic, while it is judged: a verdict is of what is seen."""
        _put_back(self._project)
        session, root = self._session, self._project.layerTreeRoot()
        mosaic = root.findLayer(session.inputs.mosaic)
        if self.is_on:
            above = [] if mosaic is None else over_the_mosaic(session)
            for node in (*covering(session), *above):
                _take_off(node)
            if mosaic is not None and not mosaic.itemVisibilityChecked():
                mosaic.setCustomProperty(_SHOWN, True)
                mosaic.setItemVisibilityChecked(True)
        self._hide_windows()

    def _hide_windows(self) -> None:
        """All but the one that is judged: others would hide what is to be seen, and tell what is hidden while blind."""
        node = self._project.layerTreeRoot().findLayer(self._session.inputs.windows)
        if node is not None and (self.is_on or self.model.is_blind):
            _take_off(node)
        self._mark()

    def _mark(self, *_: object) -> None:
        """The window that is judged."""
        selected, layer = self._session.selected(), self._session.window_layer()
        row = self._session.row(selected[0]) if len(selected) == 1 else None
        is_alone = self.is_on or self.model.is_blind
        if not is_alone or row is None or row.extent is None or layer is None:
            self._outline.hide()
            return
        words = filled(tr("Window {number}"), number=row.window_id)
        self._outline.show(QgsRectangle(*row.extent), words, layer.crs())

    # QGIS's panels

    def _make_room(self) -> None:
        docks = [
            dock for dock in self._window.findChildren(QDockWidget)
            if dock is not self._dock and dock.toggleViewAction().isChecked() and not dock.isFloating()
        ]  # fmt: skip
        self._panels = [(dock, not dock.visibleRegion().isEmpty()) for dock in docks]
        for panel, _ in self._panels:
            panel.hide()

    def _give_room(self) -> None:
        panels, self._panels = self._panels, []
        there = [] if sip.isdeleted(self._window) else [pair for pair in panels if not sip.isdeleted(pair[0])]
        for panel, _ in there:
            panel.show()
        for panel, was_seen in there:
            if was_seen:
                panel.raise_()


def toggle_seamlines(session: Session) -> bool:
    """Take the seamlines and what a scan found off the map, or put them on it again; False where there are none."""
    nodes = list(covering(session))
    is_shown = any(node.isVisible() for node in nodes)
    for node in nodes:
        if is_shown:
            node.setItemVisibilityChecked(False)
        else:
            node.setItemVisibilityCheckedParentRecursive(True)
    return bool(nodes)


def over_the_mosaic(session: Session) -> Iterator[QgsLayerTreeNode]:
    """Rasters that the map draws over the mosaic, such as another mosaic or a map of labels."""
    root = QgsProject.instance().layerTreeRoot()
    for layer in root.layerOrder():
        if layer.id() == session.inputs.mosaic:
            return
        if isinstance(layer, QgsRasterLayer) and (node := root.findLayer(layer.id())) is not None:
            yield node


def covering(session: Session) -> Iterator[QgsLayerTreeNode]:
    """The seamlines, failures of decisions, and the group that the last scan of the mosaic left."""
    project = QgsProject.instance()
    root = project.layerTreeRoot()
    for layer in project.mapLayers().values():
        if layer.customProperty(FAILURES) and (node := root.findLayer(layer.id())) is not None:
            yield node
    if (seamlines := root.findLayer(session.inputs.seamlines)) is not None:
        yield seamlines
    worst = worst_layer(project, session.inputs.mosaic)
    node = None if worst is None else root.findLayer(worst.id())
    if node is not None and node.parent() not in (None, root):
        yield node.parent()


_SHOWN = "seam_inspector/shown"  # of a mosaic that was not on it


def _take_off(node: QgsLayerTreeNode) -> None:
    if node.isVisible():
        node.setCustomProperty(HIDDEN, True)
        node.setItemVisibilityChecked(False)


def _put_back(project: QgsProject) -> None:
    """On the map again, what judging took off it."""
    root = project.layerTreeRoot()
    for node in (*root.findLayers(), *root.findGroups(True)):
        if node.customProperty(HIDDEN):
            node.removeCustomProperty(HIDDEN)
            node.setItemVisibilityCheckedParentRecursive(True)
        if node.customProperty(_SHOWN):
            node.removeCustomProperty(_SHOWN)
            node.setItemVisibilityChecked(False)
