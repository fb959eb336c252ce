"""The map while somebody judges blind: no verdict in colours, labels or tips, and all of it back afterwards."""
from __future__ import annotations

import pytest
from qgis.core import QgsPalLayerSettings, QgsProject, QgsRenderContext, QgsVectorLayer
from seam_inspector.plugin.seams.desk.judging_desk import hide_verdicts, show_verdicts
from seam_inspector.plugin.toolkit.resources import style_path

from tests.qgis.scenes import BLURRED, SHARP, windows


@pytest.fixture
def judged(project: QgsProject) -> QgsVectorLayer:
    """Two windows in the plugin's own style, one of them judged."""
    layer = windows(
        SHARP, BLURRED, window_id=("integer", [1, 2]), verdict=("string", ["preserved", "significant"]),
        observer=("string", ["", "visible"]),
    )  # fmt: skip
    layer.loadNamedStyle(style_path("windows"))
    project.addMapLayer(layer)
    return layer


def looks(layer: QgsVectorLayer) -> list[tuple[object, ...]]:
    """Colours and widths of the outlines, window by window."""
    context, renderer = QgsRenderContext(), layer.renderer().clone()
    renderer.startRender(context, layer.fields())
    items = []
    for feature in layer.getFeatures():
        context.expressionContext().setFeature(feature)
        symbols = renderer.symbolsForFeature(feature, context)
        items.append(tuple((symbol.color().name(), symbol.symbolLayer(0).width()) for symbol in symbols))
    renderer.stopRender(context)
    return items


def _expressions(labels: QgsPalLayerSettings) -> list[str]:
    properties = labels.dataDefinedProperties()
    return [properties.property(key).expressionString() for key in properties.propertyKeys()]


def test_nothing_on_the_map_tells_what_was_found(judged: QgsVectorLayer) -> None:
    before = judged.renderer().dump(), judged.mapTipTemplate()
    hide_verdicts(judged)
    symbol = judged.renderer().symbol()
    assert all(layer.layerType() == "SimpleLine" for layer in symbol.symbolLayers())  # a fill would hide the selected
    first, second = looks(judged)
    assert first == second
    assert "verdict" not in judged.renderer().dump()
    assert judged.mapTipTemplate() == ""
    labels = judged.labeling().settings()
    assert labels.getLabelExpression().expression() == '"window_id"'
    assert not any(word in expression for expression in _expressions(labels) for word in ("verdict", "kept", "ratio"))
    assert "y_max(@seen)" in labels.geometryGenerator  # in a corner, not on the seam that is judged
    show_verdicts(judged)
    assert (judged.renderer().dump(), judged.mapTipTemplate()) == before
    assert judged.styleManager().styles() == ["default"]


def test_the_users_own_style_comes_back(judged: QgsVectorLayer) -> None:
    judged.setOpacity(0.5)
    judged.styleManager().addStyleFromLayer("mine")
    judged.styleManager().setCurrentStyle("mine")
    hide_verdicts(judged)
    show_verdicts(judged)
    assert judged.styleManager().currentStyle() == "mine"
    assert judged.opacity() == 0.5
