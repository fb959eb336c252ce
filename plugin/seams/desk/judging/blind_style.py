"""How windows look on the map while the tool's verdict is hidden: outlines and numbers, thin where they are judged."""
from __future__ import annotations

from qgis.core import (
    QgsFillSymbol,
    QgsPalLayerSettings,
    QgsRuleBasedRenderer,
    QgsSimpleLineSymbolLayer,
    QgsTextBufferSettings,
    QgsTextFormat,
    QgsVectorLayer,
    QgsVectorLayerSimpleLabeling,
)
from qgis.PyQt.QtGui import QColor

from ....imagery.statistics import Operator
from ....toolkit.translation import tr

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
    """Of lines alone: QGIS fills even an empty polygon with the selection's colour, and hides what is to be judged."""
    symbol = QgsFillSymbol.createSimple({})
    for colour, mm in lines:
        symbol.appendSymbolLayer(QgsSimpleLineSymbolLayer.create({"line_color": colour, "line_width": str(mm)}))
    symbol.deleteSymbolLayer(0)
    return symbol


def _labels() -> QgsVectorLayerSimpleLabeling:
    halo = QgsTextBufferSettings()
    halo.setEnabled(True)
    halo.setSize(0.8)
    halo.setColor(QColor(0, 0, 0, 180))
    text = QgsTextFormat()
    text.setSize(9)
    text.setColor(QColor("#ffffff"))
    text.setBuffer(halo)
    settings = QgsPalLayerSettings()
    settings.fieldName = "window_id"
    settings.setFormat(text)
    return QgsVectorLayerSimpleLabeling(settings)
