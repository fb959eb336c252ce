"""Layers look as resources/styles says, in the user's language."""
from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from qgis.core import QgsApplication, QgsExpression, QgsExpressionContext, QgsFeature, QgsVectorLayer
from qgis.PyQt.QtCore import QCoreApplication, QTranslator
from seam_inspector.plugin.toolkit.layer_styles import load_style
from seam_inspector.plugin.toolkit.resources import style_path


class Shouting(QTranslator):
    """A language that is told from English everywhere but in the names of values."""

    def translate(self, context: str, text: str, disambiguation: str | None = None, count: int = -1) -> str:
        return re.sub(r"\{\w+\}|[^{]+", lambda match: match[0] if match[0][0] == "{" else match[0].upper(), text)

    def isEmpty(self) -> bool:
        return False


@pytest.fixture
def shouted(qgis_app: QgsApplication) -> Iterator[None]:
    translator = Shouting()
    QCoreApplication.installTranslator(translator)
    yield
    QCoreApplication.removeTranslator(translator)


def windows() -> QgsVectorLayer:
    fields = ("window_id:integer", "verdict:string", "reason:string", "reference:string", "kept_1:double",
              "kept_low:double", "kept_high:double", "feather_width:double", "visibility:double", "misfit:double",
              "causes:string",
              "observer:string")  # fmt: skip
    return QgsVectorLayer("Polygon?crs=EPSG:2180&" + "&".join(f"field={field}" for field in fields), "w", "memory")


def tip(layer: QgsVectorLayer, **values: object) -> str:
    """What the map says of a feature under the mouse."""
    feature = QgsFeature(layer.fields())
    for name, value in values.items():
        feature[name] = value
    context = QgsExpressionContext(layer.createExpressionContext())
    context.setFeature(feature)
    return str(QgsExpression.replaceExpressionText(layer.mapTipTemplate(), context))


FOUND = {
    "window_id": 7, "verdict": "significant", "reference": "seam", "kept_1": 0.434, "kept_low": 0.3, "kept_high": 0.56,
    "feather_width": 1.53, "visibility": 1.36, "misfit": 2.04, "causes": "feathering; blur", "observer": "unsure",
}  # fmt: skip


def test_the_legend_is_in_the_users_language(shouted: None) -> None:
    layer = windows()
    load_style(layer, "windows")
    labels = [category.label() for category in layer.renderer().categories()]
    assert labels == ["SIGNIFICANT LOSS", "REDUCED", "PRESERVED", "NOT COMPARABLE", "NOT INSPECTED"]
    assert layer.renderer().categories()[0].value() == "significant"


def test_a_map_tip_says_all_that_was_found(qgis_app: QgsApplication) -> None:
    layer = windows()
    load_style(layer, "windows")
    assert tip(layer, **FOUND) == (
        "<b>Window 7</b>: significant loss<br>kept along the seam: 43 % (30\u201356 %), in a width of 1.5 m"
        "<br>visibility at 2x (JND): 1.4<br>images apart in the mosaic (px): 2.0"
        "<br>feathering; blur<br>observer: not sure"
    )
    assert tip(layer, window_id=8) == "<b>Window 8</b>: not inspected"
    reason = "Pick another place."
    assert tip(layer, window_id=9, verdict="not_comparable", reason=reason).endswith(f"not comparable<br>{reason}")


def test_the_table_is_in_the_users_language_and_its_fields_keep_their_names(shouted: None) -> None:
    layer = windows()
    names = layer.fields().names()
    layer.setFieldAlias(names.index("reason"), "why")  # what its user calls a field stays
    load_style(layer, "windows")
    assert layer.fields().names() == names
    assert [field.alias() for field in layer.fields()] == [
        "WINDOW", "VERDICT", "why", "VERDICT AGAINST", "KEPT 1", "KEPT 1, AT LEAST", "KEPT 1, AT MOST",
        "WIDTH OF THE FEATHER (M)", "VISIBILITY AT 2X (JND)", "IMAGES APART IN THE MOSAIC (PX)", "ALL CAUSES",
        "OBSERVER",
    ]  # fmt: skip
    words = layer.editorWidgetSetup(names.index("verdict"))
    formatter = QgsApplication.fieldFormatterRegistry().fieldFormatter("ValueMap")
    shown = formatter.representValue(layer, names.index("verdict"), words.config(), None, "significant")
    assert shown == "SIGNIFICANT LOSS"
    assert layer.editorWidgetSetup(names.index("kept_1")).isNull()


def test_the_style_without_the_plugin_is_the_english_one(qgis_app: QgsApplication) -> None:
    plain, ours = windows(), windows()
    assert plain.loadNamedStyle(style_path("windows"))[1]
    load_style(ours, "windows")
    assert tip(plain, **FOUND) == tip(ours, **FOUND)
    assert plain.renderer().dump() == ours.renderer().dump()
