"""What layers of others hold is shown by our map tips as it is, and none of it is markup, a script or an address."""
from __future__ import annotations

import pytest
from qgis.core import QgsExpression, QgsExpressionContext, QgsExpressionContextUtils, QgsVectorLayer
from seam_inspector.plugin.toolkit.layer_styles import load_style

from tests.pages import outline
from tests.qgis.scenes import SHARP, layer, line
from tests.qgis.scenes import outline as box

EVIL = '<img src="//evil/x.png" onerror=alert(1)><script>alert(2)</script>"> & [% 7*7 %]'
FIELDS = ("reason", "causes", "source", "left_source", "right_source", "left_date", "right_date", "sheet", "cause",
          "remark", "picture", "verdict", "observer", "window_id", "defect", "reference")  # fmt: skip
STYLES = {"windows": "Polygon", "seams": "LineString", "source_cells": "Polygon", "defects": "LineString"}


def tip(style: str, values: dict[str, str]) -> str:
    """What QGIS shows over a feature whose fields all hold text."""
    shape = box(SHARP) if STYLES[style] == "Polygon" else line((0, 0), (9, 9))
    names = ("kept_1", "kept_low", "kept_high", "band_width", "feather_width", "visibility", "misfit", "length")
    numbers = {name: ("double", [0.5]) for name in names}
    made: QgsVectorLayer = layer(STYLES[style], [shape], **{k: ("string", [v]) for k, v in values.items()}, **numbers)
    load_style(made, style)
    context = QgsExpressionContext(QgsExpressionContextUtils.globalProjectLayerScopes(made))
    context.setFeature(next(made.getFeatures()))
    return str(QgsExpression.replaceExpressionText(made.mapTipTemplate(), context))


@pytest.mark.usefixtures("qgis_app")
@pytest.mark.parametrize("style", STYLES)
def test_no_field_becomes_markup(style: str) -> None:
    shown = tip(style, dict.fromkeys(FIELDS, EVIL))
    assert "<img" not in shown
    assert "<script" not in shown
    assert "49" not in shown
    assert EVIL in outline(shown).words


@pytest.mark.usefixtures("qgis_app")
def test_a_picture_is_one_of_ours() -> None:
    plain = dict.fromkeys(FIELDS, "x")
    for good in ("/a/pictures/defect_012.jpg", "C:/a b/pictures/defect_1.jpg"):  # of a layer in memory
        assert good in tip("defects", {**plain, "picture": good})
    for bad in ("//evil/share/defect_001.jpg", "\\\\evil\\share\\defect_001.jpg", "http://evil/defect_001.jpg",
                'x" onerror="alert(1)/defect_001.jpg', "/etc/passwd", "a.svg", "/\\evil/defect_001.jpg"):  # fmt: skip
        assert "<img" not in tip("defects", {**plain, "picture": bad}), bad
