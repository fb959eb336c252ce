"""How windows look on the map while the tool's verdict is hidden: outlines and numbers, thin where they are judged."""
from __future__ import annotations

from qgis.core import (
    QgsFillSymbol,
    QgsMapLayerStyle,
    QgsPalLayerSettings,
    QgsRuleBasedRenderer,
    QgsTextBufferSettings,
    QgsTextFormat,
    QgsVectorLayer,
    QgsVectorLayerSimpleLabeling,
)
from qgis.PyQt.QtGui import QColor

from ....toolkit.translation import tr
from ...measure.observers import Operator

_NAME = "seam_inspector_blind"  # of the layer's style; its user's own one is kept beside it
_PLAIN = {"style": "no", "outline_color": "255,255,255", "outline_width": "0.6"}
_CASING = {"style": "no", "outline_color": "0,0,0,150", "outline_width": "1.0"}
_DONE = {"style": "no", "outline_color": "255,255,255,150", "outline_width": "0.2"}


def hide_verdicts(layer: QgsVectorLayer, operator: Operator) -> None:
    """Show a window layer without what was found in it, and without what the other operator said."""
    styles = layer.styleManager()
    if styles.currentStyle() != _NAME:
        styles.removeStyle(_NAME)
        styles.addStyle(_NAME, QgsMapLayerStyle())
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
        styles.setCurrentStyle(next(name for name in styles.styles() if name != _NAME))
    styles.removeStyle(_NAME)
    layer.triggerRepaint()


def _renderer(operator: Operator) -> QgsRuleBasedRenderer:
    open_one = QgsFillSymbol.createSimple(_CASING)
    open_one.appendSymbolLayer(QgsFillSymbol.createSimple(_PLAIN).symbolLayer(0).clone())
    renderer = QgsRuleBasedRenderer(QgsFillSymbol.createSimple(_PLAIN))
    root = renderer.rootRule()
    done = QgsRuleBasedRenderer.Rule(QgsFillSymbol.createSimple(_DONE))
    done.setFilterExpression(f"coalesce(attribute('{operator.observer}'), '') <> ''")
    done.setLabel(tr("judged"))
    rest = QgsRuleBasedRenderer.Rule(open_one)
    rest.setIsElse(True)
    rest.setLabel(tr("to be judged"))
    root.removeChildAt(0)
    root.appendChild(done)
    root.appendChild(rest)
    return renderer


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
