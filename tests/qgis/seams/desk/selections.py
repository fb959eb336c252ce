"""What the desk tells the map of the selection, for maps without a desk."""
from __future__ import annotations

from qgis.core import QgsExpressionContextScope, QgsVectorLayer
from seam_inspector.plugin.seams.desk.map.window_view import SELECTED


def selection_scope(layer: QgsVectorLayer) -> QgsExpressionContextScope:
    """To be appended to a map's expression context."""
    scope = QgsExpressionContextScope()
    scope.setVariable(SELECTED, {f"{layer.id()} {fid}": True for fid in layer.selectedFeatureIds()})
    return scope
