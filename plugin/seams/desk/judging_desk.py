"""Puts judging together: the model, its bar and keys, the table that follows it, and what is hidden while blind."""
from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING

from qgis.core import (
    QgsFillSymbol,
    QgsLayerTreeNode,
    QgsPalLayerSettings,
    QgsProject,
    QgsProperty,
    QgsRasterLayer,
    QgsRuleBasedRenderer,
    QgsSimpleLineSymbolLayer,
    QgsVectorLayer,
    QgsVectorLayerSimpleLabeling,
)
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtWidgets import QWidget

from ...imagery.statistics import Operator
from ...toolkit.desk.widgets import is_confirmed
from ...toolkit.layer_styles import label_settings
from ...toolkit.translation import tr
from .judge_bar import JudgeBar
from .judging import Judging
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
            hide_verdicts(layer, self.model.operator)
        elif layer is not None:
            show_verdicts(layer)  # a project that was saved blind

    def _show_on_map(self) -> None:
        layer, self._hidden = self._hidden, None
        if layer is not None and not sip.isdeleted(layer):
            show_verdicts(layer)


_NAME = "seam_inspector_blind"  # of the layer's style; its user's own one is kept beside it
_BEFORE = "seam_inspector/style"  # custom property of the layer: the style that is to come back
_CASING, _LINE = ("0,0,0,150", 1.0), ("255,255,255", 0.6)  # colour and width, mm
_DONE = ("255,255,255,150", 0.2)


def hide_verdicts(layer: QgsVectorLayer, operator: Operator) -> None:
    """Show a window layer without what was found in it, and without what the other operator said."""
    styles = layer.styleManager()
    if styles.currentStyle() != _NAME:
        layer.setCustomProperty(_BEFORE, styles.currentStyle())
        styles.removeStyle(_NAME)
        styles.addStyleFromLayer(_NAME)
        styles.setCurrentStyle(_NAME)
    layer.setRenderer(_renderer(operator))
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


def _renderer(operator: Operator) -> QgsRuleBasedRenderer:
    root = QgsRuleBasedRenderer.Rule(None)
    done = QgsRuleBasedRenderer.Rule(_outline(_DONE))
    done.setFilterExpression(f"coalesce(attribute('{operator.observer}'), '') <> ''")
    done.setLabel(tr("judged"))
    root.appendChild(done)
    rest = QgsRuleBasedRenderer.Rule(_outline(_CASING, _LINE))
    rest.setIsElse(True)
    rest.setLabel(tr("to be judged"))
    root.appendChild(rest)
    return QgsRuleBasedRenderer(root)


def _outline(*lines: tuple[str, float]) -> QgsFillSymbol:
    """Symbol of lines: QGIS fills even an empty polygon with the selection's colour, and hides what is to be judged."""
    symbol = QgsFillSymbol.createSimple({})
    for colour, mm in lines:
        symbol.appendSymbolLayer(QgsSimpleLineSymbolLayer.create({"line_color": colour, "line_width": str(mm)}))
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
