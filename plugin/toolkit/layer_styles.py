"""The looks of our layers (resources/styles), in the user's language."""
from __future__ import annotations

import re
from xml.sax.saxutils import escape

from qgis.core import QgsEditorWidgetSetup, QgsMapLayer, QgsVectorLayer
from qgis.PyQt.QtXml import QDomDocument, QDomElement

from .field_titles import title_fields
from .resources import style_path
from .translation import tr

_LABELLED = ("category", "range", "rule", "item", "paletteEntry")
_MARKED = re.compile(r"/\*tr\*/'([^']*)'")


def load_style(layer: QgsMapLayer, name: str) -> None:
    """Give a layer one of our styles: its legend, labels, map tip and what its table says in the user's language."""
    document = _document(name)
    layer.importNamedStyle(document)
    if isinstance(layer, QgsVectorLayer):
        if expression := document.documentElement().firstChildElement("previewExpression").text():
            layer.setDisplayExpression(expression)
        _name_fields(layer, document)


def name_fields(layer: QgsVectorLayer, name: str) -> None:
    """Call the fields of a layer, and the words in them, as one of our styles does, where its user does not."""
    _name_fields(layer, _document(name))


def _name_fields(layer: QgsVectorLayer, document: QDomDocument) -> None:
    title_fields(layer)
    field = document.documentElement().firstChildElement("fieldWords").firstChildElement("field")
    while not field.isNull():
        items = field.elementsByTagName("item")
        found = (items.at(place).toElement() for place in range(items.count()))
        words = [{one.attribute("label"): one.attribute("value")} for one in found]
        for index in map(layer.fields().indexOf, field.attribute("names").split()):
            if index >= 0 and layer.editorWidgetSetup(index).isNull():
                layer.setEditorWidgetSetup(index, QgsEditorWidgetSetup("ValueMap", {"map": words}))
        field = field.nextSiblingElement("field")


def _document(name: str) -> QDomDocument:
    document = QDomDocument()
    with open(style_path(name), encoding="utf-8") as file:
        document.setContent(_worded(file.read()))
    for tag in _LABELLED:
        found = document.elementsByTagName(tag)
        for place in range(found.count()):
            _translate_label(found.at(place).toElement())
    return document


def _worded(style: str) -> str:
    """Texts within expressions are marked: ``/*tr*/'visible'``."""
    return _MARKED.sub(lambda found: "'" + escape(tr(found[1]).replace("'", "''"), {'"': "&quot;"}) + "'", style)


def _translate_label(element: QDomElement) -> None:
    if label := element.attribute("label"):
        element.setAttribute("label", tr(label))
