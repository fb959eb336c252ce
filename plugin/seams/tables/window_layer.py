"""The window layer: an ordinary polygon layer that holds the windows and what was found in them.

What the desk does to it goes through ``write``, and is in the layer's file then. Layers of other formats are read, and
copied into a windows file.
"""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from qgis.core import (
    QgsFeature,
    QgsFeatureRequest,
    QgsField,
    QgsFields,
    QgsGeometry,
    QgsMapLayer,
    QgsProviderRegistry,
    QgsSingleSymbolRenderer,
    QgsVectorLayer,
    QgsWkbTypes,
)

from ...imagery.errors import WindowLayerError
from ...toolkit import messages as toolkit_messages
from ...toolkit.layer_styles import load_style, name_fields, style_document
from ...toolkit.layers import edit_step, has_numbers, layer_path, system_wkt
from ...toolkit.reference_systems import keep_system
from ...toolkit.table_fields import column_fields, column_values, feature, is_known
from ...toolkit.translation import tr
from ...toolkit.version_differences import field as made_field
from ..measure import messages
from ..measure.window.window_result import WindowResult
from ..measure.window.window_tables import MEASURED
from ..measure.window_records import WindowRecord
from . import (  # noqa: F401  result_tables gives the fields their titles
    result_tables,
    window_file,
)
from .input_layers import plain_text
from .record_tables import level_names, read_windows

UNNUMBERED = -(2**31)
"""``window_id`` of a window that has none in the layer."""
_MEASURED_COLUMNS = tuple(column for column in MEASURED if column.name not in ("window_id", "observer"))


def open_window_layer(path: Path) -> QgsVectorLayer:
    """The layer of such a file, styled. Raises WindowLayerError when it can't be opened."""
    layer = QgsVectorLayer(f"{path}|layername={window_file.TABLE}", tr("Windows"), "ogr")
    if not layer.isValid():
        raise WindowLayerError(messages.WINDOW_LAYER_NOT_CREATED(folder=path.parent))
    keep_system(layer)
    load_style(layer, "windows")
    return layer


def holds_windows(layer: QgsMapLayer | None) -> bool:
    """Whether a layer is one of polygons that can be read."""
    return (
        isinstance(layer, QgsVectorLayer)
        and layer.isValid()
        and layer.geometryType() == QgsWkbTypes.GeometryType.PolygonGeometry
    )


def read_layer(layer: QgsVectorLayer, fids: Iterable[int] | None = None) -> list[WindowRecord]:
    """Some windows, or all of them; where ``window_id`` is not filled in it is UNNUMBERED. None is stale yet."""
    request = QgsFeatureRequest() if fids is None else QgsFeatureRequest().setFilterFids(list(fids))
    return read_windows(layer.getFeatures(request), layer.fields().names(), unnumbered=UNNUMBERED)


def read_shapes(layer: QgsVectorLayer, fids: Iterable[int]) -> dict[int, QgsGeometry]:
    """The outlines of some windows."""
    request = QgsFeatureRequest().setFilterFids(list(fids)).setNoAttributes()
    return {feature.id(): QgsGeometry(feature.geometry()) for feature in layer.getFeatures(request)}


@dataclass(frozen=True)
class WindowChange:
    """What is done to a window layer in one go."""

    values: Mapping[int, Mapping[str, object]] = field(default_factory=dict)
    """Other values, by feature id and field; fields that the layer lacks are left out."""
    added: Sequence[QgsFeature] = ()
    removed: Sequence[int] = ()  # feature ids


def write(layer: QgsVectorLayer, change: WindowChange, words: str) -> None:
    """Write a change. It is in the file then, unless somebody edits the layer with QGIS's tools: then it is among his
    edits, a step of theirs called ``words``.

    Raises WindowLayerError when the layer can't be written.
    """
    fields = layer.fields()
    values = {
        fid: {index: value for name, value in changed.items() if (index := fields.indexOf(name)) >= 0}
        for fid, changed in change.values.items()
    }
    if layer.isEditable():
        with edit_step(layer, words):
            is_done = all(layer.changeAttributeValues(fid, changed) for fid, changed in values.items())
            is_done = is_done and all(layer.addFeature(QgsFeature(window)) for window in change.added)
            if not is_done or not layer.deleteFeatures(list(change.removed)):
                raise WindowLayerError(toolkit_messages.WINDOW_LAYER_READ_ONLY(name=layer.name()))
    else:
        _write_file(layer, change, values)
    layer.triggerRepaint()  # verdicts are the map's colours too, and QGIS does not redraw for attributes


def _write_file(layer: QgsVectorLayer, change: WindowChange, values: dict[int, dict[int, object]]) -> None:
    """Write by the data provider, which tells nobody; the layer's own signals tell the desk and QGIS's tables alike."""
    provider, added = layer.dataProvider(), [QgsFeature(window) for window in change.added]
    if layer.readOnly():
        raise WindowLayerError(toolkit_messages.WINDOW_LAYER_READ_ONLY(name=layer.name()))
    is_done = not values or provider.changeAttributeValues(values)
    if is_done and added:
        is_done, added = provider.addFeatures(added)
    if is_done and change.removed:
        is_done = provider.deleteFeatures(list(change.removed))
    if not is_done:
        error = provider.lastError() or layer.name()
        raise WindowLayerError(messages.WINDOWS_NOT_WRITTEN(path=layer_path(layer), error=error.rstrip(". ")))
    layer.updateExtents()
    for fid, changed in values.items():
        for index, value in changed.items():
            layer.attributeValueChanged.emit(fid, index, value)
    for window in added:
        layer.featureAdded.emit(window.id())
    for fid in change.removed:
        layer.featureDeleted.emit(fid)
    layer.deselect(list(change.removed))


def add_levels(layer: QgsVectorLayer, levels: int) -> None:
    """Give a layer the fields of more levels. Raises WindowLayerError when that can't be now."""
    missing = [field for field in window_file.window_fields(levels) if layer.fields().indexOf(field.name()) < 0]
    if missing:
        if layer.isEditable() or not layer.dataProvider().addAttributes(missing):
            raise WindowLayerError(messages.FIELD_NOT_HELD(name=layer.name(), field=missing[0].name()))
        layer.updateFields()
        name_fields(layer, style_document("windows"))


def new_windows(
    layer: QgsVectorLayer, outlines: Iterable[QgsGeometry], first: int, values: Iterable[Mapping[str, object]]
) -> list[QgsFeature]:
    """Windows that are to be added, numbered from ``first`` on, and what is known of each."""
    fields, is_multi, features = layer.fields(), QgsWkbTypes.isMultiType(layer.wkbType()), []
    for number, (outline, known) in enumerate(zip(outlines, values), first):
        if is_multi:
            outline.convertToMultiType()
        made = feature(fields, [None] * fields.count(), outline)
        for name, value in {"window_id": number, **known}.items():
            if fields.indexOf(name) >= 0:
                made[name] = value
        features.append(made)
    return features


def measured_values(layer: QgsVectorLayer, result: WindowResult) -> dict[str, object]:
    """What is written of a result. The observer's word stays; ratios of more levels, of another inspection, go."""
    levels = len(result.judgement.ratios.detail)
    values = zip(column_fields(_MEASURED_COLUMNS, levels).names(), column_values(_MEASURED_COLUMNS, result, levels))
    return {**dict.fromkeys(measured_names(layer)), **dict(values)}


def measured_names(layer: QgsVectorLayer) -> list[str]:
    """The fields of a layer that an inspection fills."""
    names = layer.fields().names()
    by_level = [name for column in _MEASURED_COLUMNS if column.by_level for name in level_names(column.name, names)]
    return [*by_level, *(column.name for column in _MEASURED_COLUMNS if not column.by_level and column.name in names)]


def held_values(layer: QgsVectorLayer, fids: Iterable[int], names: Sequence[str]) -> dict[int, dict[str, object]]:
    """What windows hold in some fields, by feature id; None for nothing."""
    request = QgsFeatureRequest().setFilterFids(list(fids)).setFlags(QgsFeatureRequest.Flag.NoGeometry)
    there = [name for name in names if layer.fields().indexOf(name) >= 0]
    return {
        window.id(): {name: window[name] if is_known(window[name]) else None for name in there}
        for window in layer.getFeatures(request)
    }


def copy_to_file(layer: QgsVectorLayer, levels: int, wkt: str, folder: Path) -> Path:
    """Copy the windows of any layer into a new windows file, their other columns too; ``wkt``: for a layer without a
    reference system. Raises WindowLayerError."""
    names = layer.fields().names()
    besides = [made_field(field.name(), _kind(field)) for field in layer.fields() if field.name().lower() != "fid"]
    fields = window_file.window_fields(max(levels, len(level_names("ratio", names))), besides)
    is_multi = QgsWkbTypes.isMultiType(layer.wkbType())
    shape = QgsWkbTypes.Type.MultiPolygon if is_multi else QgsWkbTypes.Type.Polygon
    rows = (_copied(row, names, fields) for row in layer.getFeatures())
    return window_file.write_window_file(system_wkt(layer.crs()) or wkt, folder, fields, rows, shape)


def _kind(layer_field: QgsField) -> str:
    """The kind of field that holds its values in a windows file."""
    kinds = (kind for kind in ("integer", "real", "text") if made_field("", kind).type() == layer_field.type())
    return next(kinds, "real" if layer_field.isNumeric() else "text")


def _copied(row: QgsFeature, names: Sequence[str], fields: QgsFields) -> QgsFeature:
    made = QgsFeature(fields)
    if row.hasGeometry() and has_numbers(row.geometry()):
        made.setGeometry(row.geometry())
    for name, value in zip(names, row.attributes()):
        if fields.indexOf(name) >= 0 and is_known(value):
            made[name] = value if isinstance(value, (bool, int, float, str)) else plain_text(value)
    return made


def is_in_file(layer: QgsVectorLayer) -> bool:
    """Whether the layer is that of a windows file, which is all that the desk writes to."""
    uri = QgsProviderRegistry.instance().decodeUri(layer.providerType(), layer.source())
    path = Path(layer_path(layer) or ".")
    is_named = path.suffix.lower() == ".gpkg" and (uri.get("layerName") or path.stem) == window_file.TABLE
    return is_named and window_file.is_window_file(path)


_STYLED = "seam_inspector/styled"  # custom property of the layer: its looks are its user's from now on


def style_once(layer: QgsVectorLayer) -> None:
    """Show verdicts in a windows file that was added anew, where QGIS has filled the windows with some colour."""
    if not layer.customProperty(_STYLED):
        layer.setCustomProperty(_STYLED, True)
        if isinstance(layer.renderer(), QgsSingleSymbolRenderer):
            load_style(layer, "windows")
            layer.triggerRepaint()
