"""Windows that a QGIS left which ended without saving are brought back into their layer, as one step of undo."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from qgis.core import QgsFeature, QgsGeometry, QgsVectorLayer, QgsVectorLayerUtils

from ....imagery.errors import WindowLayerError
from ....imagery.statistics import JUDGING_FIELDS
from ....toolkit import messages as toolkit_messages
from ....toolkit.layer_editing import edit_step
from ....toolkit.table_fields import is_known
from ....toolkit.translation import tr
from ..windows.window_watch import WindowWatch

_KEPT = (bool, int, float, str)
_PRIMARY_KEY = "fid"  # of a GeoPackage, which gives it itself


@dataclass(frozen=True)
class UnsavedWindow:
    """A window as it was."""

    number: int
    wkb: bytes | None
    """Its outline; None when it was removed."""
    values: Mapping[str, Any]
    """By the fields' names, those that had one."""
    is_stale: bool = False
    """Whether its result was outdated."""


def restore(watch: WindowWatch, windows: Sequence[UnsavedWindow], levels: int) -> int:
    """How many windows are other ones now. Raises WindowLayerError when the layer can't be edited."""
    layer = watch.layer
    assert layer is not None
    there = {row.window_id: layer.getFeature(row.fid) for row in watch.rows()}
    other = [one for one in windows if _is_other(one, there.get(one.number))]
    if not other:
        return 0
    judging = {name for one in other for name in one.values if name in JUDGING_FIELDS}
    with edit_step(layer, tr("Restore windows")):
        watch.prepare([], levels, judging)
        fids = {row.window_id: row.fid for row in watch.rows()}
        layer.deleteFeatures([fids[one.number] for one in other if one.wkb is None])
        for one in other:
            if one.wkb is not None:
                _bring_back(layer, fids.get(one.number), one)
    watch.mark_stale([one.number for one in other if one.is_stale])
    return len(other)


def _is_other(window: UnsavedWindow, feature: QgsFeature | None) -> bool:
    if feature is None or window.wkb is None:
        return (feature is None) != (window.wkb is None)
    return bytes(feature.geometry().asWkb()) != window.wkb or kept_values(feature) != dict(window.values)


def kept_values(feature: QgsFeature) -> dict[str, Any]:
    """By the fields' names: numbers and texts, as windows have them."""
    named = zip(feature.fields().names(), feature.attributes())
    return {name: value for name, value in named if type(value) in _KEPT and name != _PRIMARY_KEY}


def _bring_back(layer: QgsVectorLayer, fid: int | None, window: UnsavedWindow) -> None:
    outline = QgsGeometry()
    outline.fromWkb(window.wkb)
    fields = layer.fields()
    values = {index: value for name, value in window.values.items() if (index := fields.indexOf(name)) >= 0}
    if fid is None:
        if not layer.addFeature(QgsVectorLayerUtils.createFeature(layer, outline, values)):
            raise WindowLayerError(toolkit_messages.WINDOW_LAYER_READ_ONLY(name=layer.name()))
        return
    feature = layer.getFeature(fid)
    if bytes(feature.geometry().asWkb()) != window.wkb:
        layer.changeGeometry(fid, outline)
    for index, held in enumerate(feature.attributes()):
        value = values.get(index)
        is_kept = fields.at(index).name() != _PRIMARY_KEY and (type(held) in _KEPT or not is_known(held))
        if is_kept and (held if is_known(held) else None) != value:
            layer.changeAttributeValue(fid, index, value)
