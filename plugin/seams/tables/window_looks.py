"""How a layer of windows looks that nobody has given any looks yet."""
from __future__ import annotations

from qgis.core import QgsSingleSymbolRenderer, QgsSymbol, QgsVectorLayer, QgsWkbTypes

from ...toolkit.layer_styles import load_style

_STYLED = "seam_inspector/styled"  # custom property of the layer: its looks are its user's from now on


def style_if_plain(layer: QgsVectorLayer) -> None:
    """Show verdicts where QGIS has filled the windows with some colour, as it does in a layer that is added anew.

    Once for each layer: what its user makes of it then is his.
    """
    if not layer.customProperty(_STYLED):
        layer.setCustomProperty(_STYLED, True)
        if _is_plain(layer):
            load_style(layer, "windows")
            layer.triggerRepaint()


def _is_plain(layer: QgsVectorLayer) -> bool:
    """Whether it looks as QGIS makes all polygons look, but for their colour."""
    renderer, default = layer.renderer(), QgsSymbol.defaultSymbol(QgsWkbTypes.GeometryType.PolygonGeometry)
    if not isinstance(renderer, QgsSingleSymbolRenderer) or layer.labelsEnabled() or layer.opacity() < 1:
        return False
    symbol = renderer.symbol().clone()
    symbol.setColor(default.color())
    return _look(symbol) == _look(default)


def _look(symbol: QgsSymbol) -> tuple[float, list[tuple[str, dict[str, str]]]]:
    return symbol.opacity(), [(layer.layerType(), layer.properties()) for layer in symbol.symbolLayers()]
