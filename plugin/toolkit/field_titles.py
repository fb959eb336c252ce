"""What the fields of our tables are called for the user: aliases of layers, whose fields keep their names."""
from __future__ import annotations

import re
from collections.abc import Mapping

from qgis.core import QgsVectorLayer
from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from .translation import filled, tr

_TITLES = {
    "window_id": QT_TRANSLATE_NOOP("@default", "window"),
    "seam_id": QT_TRANSLATE_NOOP("@default", "seam"),
    "station": QT_TRANSLATE_NOOP("@default", "station (m)"),
    "length": QT_TRANSLATE_NOOP("@default", "length (m)"),
    "verdict": QT_TRANSLATE_NOOP("@default", "verdict"),
    "paper_verdict": QT_TRANSLATE_NOOP("@default", "verdict by the paper's rule"),
    "reference": QT_TRANSLATE_NOOP("@default", "verdict against"),
    "reason": QT_TRANSLATE_NOOP("@default", "reason"),
    "sources": QT_TRANSLATE_NOOP("@default", "sources that took part"),
    "source": QT_TRANSLATE_NOOP("@default", "orthoimage"),
    "left_source": QT_TRANSLATE_NOOP("@default", "orthoimage on the left"),
    "right_source": QT_TRANSLATE_NOOP("@default", "orthoimage on the right"),
    "left_date": QT_TRANSLATE_NOOP("@default", "its date, left"),
    "right_date": QT_TRANSLATE_NOOP("@default", "its date, right"),
    "kept_low": QT_TRANSLATE_NOOP("@default", "kept 1, at least"),
    "kept_high": QT_TRANSLATE_NOOP("@default", "kept 1, at most"),
    "band_width": QT_TRANSLATE_NOOP("@default", "width of the band (m)"),
    "feather_width": QT_TRANSLATE_NOOP("@default", "width of the feather (m)"),
    "visibility": QT_TRANSLATE_NOOP("@default", "visibility at 2x (JND)"),
    "mixture": QT_TRANSLATE_NOOP("@default", "share of the other image"),
    "cause": QT_TRANSLATE_NOOP("@default", "cause"),
    "causes": QT_TRANSLATE_NOOP("@default", "all causes"),
    "observer": QT_TRANSLATE_NOOP("@default", "observer"),
    "defect": QT_TRANSLATE_NOOP("@default", "failure"),
    "sheet": QT_TRANSLATE_NOOP("@default", "sheet"),
    "picture": QT_TRANSLATE_NOOP("@default", "picture"),
}
_OF_LEVEL = {
    "kept": QT_TRANSLATE_NOOP("@default", "kept {level}"),
    "window_kept": QT_TRANSLATE_NOOP("@default", "kept {level} in the window"),
    "strip_kept": QT_TRANSLATE_NOOP("@default", "kept {level} in the strip"),
    "contrast": QT_TRANSLATE_NOOP("@default", "contrast {level}"),
    "sharpness": QT_TRANSLATE_NOOP("@default", "sharpness {level}"),
    "added": QT_TRANSLATE_NOOP("@default", "added detail {level}"),
}
"""By the name in front of ``_1``..``_R``."""
_LEVELLED = re.compile(r"(\w+)_(\d+)")


def give_titles(titles: Mapping[str, str]) -> None:
    """Those of one table's own fields; of fields by level with ``{level}``."""
    for name, title in titles.items():
        (_OF_LEVEL if "{level}" in title else _TITLES)[name] = title


def field_title(name: str) -> str:
    """A field for the user; empty for one that is not of our tables."""
    if name in _TITLES:
        return tr(_TITLES[name])
    found = _LEVELLED.fullmatch(name)
    if found is None or found[1] not in _OF_LEVEL:
        return ""
    return filled(tr(_OF_LEVEL[found[1]]), level=found[2])


def title_fields(layer: QgsVectorLayer) -> None:
    """Call the fields of a layer so, but for those that are called something already."""
    fields = layer.fields()
    widgets = [layer.editorWidgetSetup(index) for index in range(fields.count())]
    for index in range(fields.count()):
        field = fields.at(index)
        if not field.alias() and (title := field_title(field.name())):
            layer.setFieldAlias(index, title)
    for index, widget in enumerate(widgets):  # a new alias loses those that a style has just brought
        if not widget.isNull() and layer.editorWidgetSetup(index).isNull():
            layer.setEditorWidgetSetup(index, widget)
