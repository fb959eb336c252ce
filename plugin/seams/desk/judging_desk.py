"""Puts judging together: model, bar, keys and table, what is hidden while blind, and the room that the map gets."""
from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING

from qgis.core import (
    QgsApplication,
    QgsFillSymbol,
    QgsLayerTreeNode,
    QgsPalLayerSettings,
    QgsProject,
    QgsProperty,
    QgsRasterLayer,
    QgsRectangle,
    QgsSimpleLineSymbolLayer,
    QgsSingleSymbolRenderer,
    QgsVectorLayer,
    QgsVectorLayerSimpleLabeling,
)
from qgis.gui import QgisInterface
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtWidgets import QAction, QDockWidget, QWidget

from ...toolkit.connections import Connections
from ...toolkit.desk.tool_dock import ToolDock
from ...toolkit.desk.widgets import is_confirmed
from ...toolkit.layer_styles import label_settings
from ...toolkit.translation import filled, tr
from .judge_bar import JudgeBar
from .judging import Judging
from .map.window_view import WindowOutline
from .mosaic_scans import worst_layer
from .windows.windows_panel import WindowsPanel

if TYPE_CHECKING:
    from .session import Session

_NUMBER = "window_id"  # the one column that tells nothing


class JudgingDesk(QObject):
    """``model`` and ``bar`` are for the dock to use."""

    def __init__(
        self, session: Session, windows: WindowsPanel, dock: QWidget, is_in_view: Callable[[int], bool]
    ) -> None:
        super().__init__(dock)
        self._session = session
        self._windows = windows
        self._hidden: QgsVectorLayer | None = None  # the layer whose verdicts are hidden
        self.model = Judging(session, windows.ordered_fids, partial(is_confirmed, dock), self, is_in_view)
        self.bar = JudgeBar(session, self.model)
        self.model.changed.connect(self._follow)
        windows.orderChanged.connect(self.bar.refresh)
        session.inputsChanged.connect(self._hide_on_map)
        session.loss_view.changed.connect(self._hide_loss)
        self._follow()

    def close(self) -> None:
        """Leave nothing behind."""
        self._show_on_map()
        self.model.close()
        self.bar.close()

    def key_actions(self) -> dict[str, Callable[[], bool]]:
        """What the keys that judge do, by their names."""
        return {**self.bar.key_actions(), "seamlines": partial(toggle_seamlines, self._session)}

    def _follow(self) -> None:
        """The operator or what is hidden changed."""
        model = self.model
        self._windows.show_for(model.operator, model.is_blind)
        self._hide_loss()
        self._hide_on_map()
        self.bar.refresh()

    # What the map tells

    def _hide_loss(self, *_: object) -> None:
        if self.model.is_blind:
            self._session.loss_view.show(False)

    def _hide_on_map(self) -> None:
        layer = self._session.window_layer()
        if self._hidden is not None and (layer is not self._hidden or not self.model.is_blind):
            self._show_on_map()
        if self.model.is_blind and layer is not None:
            self._hidden = layer
            hide_verdicts(layer)
        elif layer is not None:
            show_verdicts(layer)  # a project that was saved blind

    def _show_on_map(self) -> None:
        layer, self._hidden = self._hidden, None
        if layer is not None and not sip.isdeleted(layer):
            show_verdicts(layer)


_NAME = "seam_inspector_blind"  # of the layer's style; its user's own one is kept beside it
_BEFORE = "seam_inspector/style"  # custom property of the layer: the style that is to come back
_LINES = ("0,0,0,150", "1.0"), ("255,255,255", "0.6")  # colour and width, mm


def hide_verdicts(layer: QgsVectorLayer) -> None:
    """Show a window layer without what was found in it, or what was said of it."""
    styles = layer.styleManager()
    if styles.currentStyle() != _NAME:
        layer.setCustomProperty(_BEFORE, styles.currentStyle())
        styles.removeStyle(_NAME)
        styles.addStyleFromLayer(_NAME)
        styles.setCurrentStyle(_NAME)
    layer.setRenderer(QgsSingleSymbolRenderer(_outline()))
    layer.setLabeling(_labels())
    layer.setLabelsEnabled(True)
    layer.setMapTipTemplate("")
    layer.setDisplayExpression('"window_id"')
    layer.triggerRepaint()


def show_verdicts(layer: QgsVectorLayer) -> None:
    """Give a window layer the style back that it had before."""
    styles = layer.styleManager()
    if _NAME not in styles.styles():
        return
    if styles.currentStyle() == _NAME:
        others = [name for name in styles.styles() if name != _NAME]
        before = layer.customProperty(_BEFORE, "")
        styles.setCurrentStyle(before if before in others else others[0])
    styles.removeStyle(_NAME)
    layer.triggerRepaint()


def _outline() -> QgsFillSymbol:
    """Symbol of lines: QGIS fills even an empty polygon with the selection's colour, and hides what is to be judged."""
    symbol = QgsFillSymbol.createSimple({})
    for colour, mm in _LINES:
        symbol.appendSymbolLayer(QgsSimpleLineSymbolLayer.create({"line_color": colour, "line_width": mm}))
    symbol.deleteSymbolLayer(0)
    return symbol


def _labels() -> QgsVectorLayerSimpleLabeling:
    """Numbers alone, where the plugin's own style has its labels: in a corner, off the seam."""
    settings = label_settings("windows")
    settings.fieldName = f'"{_NUMBER}"'  # an expression, as in that style
    properties = settings.dataDefinedProperties()
    for telling in (QgsPalLayerSettings.Property.Show, QgsPalLayerSettings.Property.Priority):
        properties.setProperty(telling, QgsProperty())
    settings.setDataDefinedProperties(properties)
    return QgsVectorLayerSimpleLabeling(settings)


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
    """The seamlines, and the group that the last scan of the mosaic left."""
    project = QgsProject.instance()
    root = project.layerTreeRoot()
    if (seamlines := root.findLayer(session.inputs.seamlines)) is not None:
        yield seamlines
    worst = worst_layer(project, session.inputs.mosaic)
    node = None if worst is None else root.findLayer(worst.id())
    if node is not None and node.parent() not in (None, root):
        yield node.parent()


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
