"""The looks of our layers (resources/styles) and what their fields are called, in the user's language.

Names are aliases; the fields keep their own.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from xml.sax.saxutils import escape

from qgis.core import (
    QgsEditorWidgetSetup,
    QgsMapLayer,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingLayerPostProcessorInterface,
    QgsVectorLayer,
)
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QT_TR_NOOP
from qgis.PyQt.QtXml import QDomDocument

from .resources import style_path
from .translation import filled, tr

_TITLES = {
    "window_id": QT_TR_NOOP("window"),
    "seam_id": QT_TR_NOOP("seam"),
    "station": QT_TR_NOOP("station (m)"),
    "length": QT_TR_NOOP("length (m)"),
    "level": QT_TR_NOOP("piece or stretch"),
    "state": QT_TR_NOOP("counts as"),
    "verdict": QT_TR_NOOP("verdict"),
    "paper_verdict": QT_TR_NOOP("verdict by the paper's rule"),
    "reference": QT_TR_NOOP("verdict against"),
    "reason": QT_TR_NOOP("reason"),
    "sources": QT_TR_NOOP("sources that were used"),
    "source": QT_TR_NOOP("orthoimage"),
    "left_source": QT_TR_NOOP("orthoimage on the left"),
    "right_source": QT_TR_NOOP("orthoimage on the right"),
    "left_date": QT_TR_NOOP("its date, left"),
    "right_date": QT_TR_NOOP("its date, right"),
    "kept_low": QT_TR_NOOP("kept 1, at least"),
    "profile": QT_TR_NOOP("kept by distance from the seam"),
    "kept_high": QT_TR_NOOP("kept 1, at most"),
    "band_width": QT_TR_NOOP("width of the band (m)"),
    "feather_width": QT_TR_NOOP("width of the feather (m)"),
    "visibility": QT_TR_NOOP("visibility at 2x (JND)"),
    "mixture": QT_TR_NOOP("share of the other image"),
    "cause": QT_TR_NOOP("cause"),
    "causes": QT_TR_NOOP("all causes"),
    "observer": QT_TR_NOOP("observer"),
    "defect": QT_TR_NOOP("failure"),
    "sheet": QT_TR_NOOP("sheet"),
    "picture": QT_TR_NOOP("picture"),
}
_OF_LEVEL = {
    "kept": QT_TR_NOOP("kept {level}"),
    "window_kept": QT_TR_NOOP("kept {level} in the window"),
    "strip_kept": QT_TR_NOOP("kept {level} in the strip"),
    "contrast": QT_TR_NOOP("contrast {level}"),
    "sharpness": QT_TR_NOOP("sharpness {level}"),
    "added": QT_TR_NOOP("added detail {level}"),
}
"""Titles by the name in front of ``_1``..``_R``."""
_LEVELLED = re.compile(r"(\w+)_(\d+)")


def give_titles(titles: Mapping[str, str]) -> None:
    """Add titles of a table's fields; those of fields by level have ``{level}``."""
    for name, title in titles.items():
        (_OF_LEVEL if "{level}" in title else _TITLES)[name] = title


def field_title(name: str) -> str:
    """A field for the user; empty for one that is not of our tables."""
    if name in _TITLES:
        return tr(_TITLES[name])
    parts = _LEVELLED.fullmatch(name)
    if parts is None or parts[1] not in _OF_LEVEL:
        return ""
    return filled(tr(_OF_LEVEL[parts[1]]), level=parts[2])


_LABELLED = ("category", "range", "rule", "item", "paletteEntry")
_MARKED = re.compile(r"/\*tr\*/'([^']*)'")  # a text within an expression: ``/*tr*/'visible'``


def load_style(layer: QgsMapLayer, name: str) -> None:
    """Give a layer one of our styles: its legend, labels, map tip and what its table says in the user's language."""
    document = style_document(name)
    layer.importNamedStyle(document)
    if isinstance(layer, QgsVectorLayer):
        if expression := document.documentElement().firstChildElement("previewExpression").text():
            layer.setDisplayExpression(expression)
        name_fields(layer, document)


def name_fields(layer: QgsVectorLayer, document: QDomDocument) -> None:
    """Call the fields of a layer, and the words in them, as one of our styles does, where its user does not."""
    fields = layer.fields()
    widgets = [layer.editorWidgetSetup(index) for index in range(fields.count())]
    for index in range(fields.count()):
        if not fields.at(index).alias() and (title := field_title(fields.at(index).name())):
            layer.setFieldAlias(index, title)
    for index, widget in enumerate(widgets):  # a new alias loses those that a style has just brought
        if not widget.isNull() and layer.editorWidgetSetup(index).isNull():
            layer.setEditorWidgetSetup(index, widget)
    field = document.documentElement().firstChildElement("fieldWords").firstChildElement("field")
    while not field.isNull():
        items = field.elementsByTagName("item")
        elements = (items.at(place).toElement() for place in range(items.count()))
        words = [{item.attribute("label"): item.attribute("value")} for item in elements]
        for index in map(layer.fields().indexOf, field.attribute("names").split()):
            if index >= 0 and layer.editorWidgetSetup(index).isNull():
                layer.setEditorWidgetSetup(index, QgsEditorWidgetSetup("ValueMap", {"map": words}))
        field = field.nextSiblingElement("field")


def style_document(name: str) -> QDomDocument:
    """One of our styles, its words in the user's language."""

    def worded(marked: re.Match[str]) -> str:
        return "'" + escape(tr(marked[1]).replace("'", "''"), {'"': "&quot;"}) + "'"

    document = QDomDocument()
    with open(style_path(name), encoding="utf-8") as file:
        document.setContent(_MARKED.sub(worded, file.read()))
    for tag in _LABELLED:
        labelled = document.elementsByTagName(tag)
        for place in range(labelled.count()):
            element = labelled.at(place).toElement()
            if label := element.attribute("label"):
                element.setAttribute("label", tr(label))
    return document


class LayerStyler(QgsProcessingLayerPostProcessorInterface):
    """A post-processor that gives a layer its style once it is there."""

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
    _stylers.difference_update([known for known in _stylers if sip.isdeleted(known)])
    styler = LayerStyler(style)
    _stylers.add(styler)
    return styler
