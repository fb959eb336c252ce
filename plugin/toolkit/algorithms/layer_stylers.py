"""Our styles for layers that QGIS loads when an algorithm has ended."""
from __future__ import annotations

from qgis.core import QgsMapLayer, QgsProcessingContext, QgsProcessingFeedback, QgsProcessingLayerPostProcessorInterface
from qgis.PyQt import sip

from ..layer_styles import load_style


class LayerStyler(QgsProcessingLayerPostProcessorInterface):
    """Gives a layer its style once it is there."""

    def __init__(self, style: str) -> None:
        super().__init__()
        self._style = style

    def postProcessLayer(
        self, layer: QgsMapLayer, context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> None:
        load_style(layer, self._style)
        layer.triggerRepaint()


_stylers: set[LayerStyler] = set()


def layer_styler(style: str) -> LayerStyler:
    """A new one for each layer: QGIS deletes it with the context of its run, and until then does not keep it alive."""
    _stylers.difference_update([one for one in _stylers if sip.isdeleted(one)])
    styler = LayerStyler(style)
    _stylers.add(styler)
    return styler
