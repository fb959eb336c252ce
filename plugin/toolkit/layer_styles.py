"""The looks of our layers (resources/styles), in the user's language."""
from __future__ import annotations

import re
from xml.sax.saxutils import escape

from qgis.core import QgsMapLayer
from qgis.PyQt.QtXml import QDomDocument, QDomElement

from .resources import style_path
from .translation import tr

_LABELLED = ("category", "range", "rule", "item", "paletteEntry")
_MARKED = re.compile(r"/\*tr\*/'([^']*)'")


def load_style(layer: QgsMapLayer, name: str) -> None:
    """Give a layer one of our styles, its legend, labels and map tip in the user's language."""
    document = QDomDocument()
    with open(style_path(name), encoding="utf-8") as file:
        document.setContent(_worded(file.read()))
    for tag in _LABELLED:
        found = document.elementsByTagName(tag)
        for place in range(found.count()):
            _translate_label(found.at(place).toElement())
    layer.importNamedStyle(document)


def _worded(style: str) -> str:
    """Texts within expressions are marked: ``/*tr*/'visible'``."""
    return _MARKED.sub(lambda found: "'" + escape(tr(found[1]).replace("'", "''"), {'"': "&quot;"}) + "'", style)


def _translate_label(element: QDomElement) -> None:
    if label := element.attribute("label"):
        element.setAttribute("label", tr(label))
