"""The window layer: an ordinary polygon layer that holds the windows and what was found in them.

All changes go through its edit buffer, fields that it lacks included, so undo, saving and the attribute table are
QGIS's own.
"""
from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsFeatureRequest,
    QgsField,
    QgsGeometry,
    QgsMapLayer,
    QgsProject,
    QgsSingleSymbolRenderer,
    QgsSymbol,
    QgsVectorLayer,
    QgsVectorLayerUtils,
    QgsWkbTypes,
)

from ...imagery.errors import WindowError, WindowLayerError
from ...imagery.gdal_paths import holds_only_tables
from ...imagery.statistics import FIRST, JUDGING_FIELDS
from ...toolkit import messages as toolkit_messages
from ...toolkit.geopackages import free_path, write_table
from ...toolkit.layer_styles import load_style, name_fields
from ...toolkit.layers import change_quietly, edit_step, transformed
from ...toolkit.reference_systems import keep_system, transformation
from ...toolkit.table_fields import column_fields, column_values, is_known
from ...toolkit.translation import tr
from ...toolkit.version_differences import field
from ..measure import messages
from ..measure.window.window_result import WindowResult
from ..measure.window.window_tables import MEASURED
from ..measure.window_records import WindowRecord
from .record_tables import level_names, read_windows
from .result_tables import output_fields  # which gives the fields their titles

UNNUMBERED = -(2**31)
"""``window_id`` of a window that has none in the layer."""
TABLE = "windows"
"""In a file that the desk made."""
_OURS = {"window_id", "verdict", "observer"}  # fields that every version has written
_FULL_BOX = 0.9  # of its box: a rectangle of another system is turned a little
_BUSY_S = 0.05  # at most, for one that another program is writing
_SHAPEFILE = "ESRI Shapefile"
_SHAPEFILE_NAME = 10  # letters at most, so it goes without background_ratio
_SHAPEFILE_LENGTHS = {"integer": (9, 0), "real": (20, 15), "text": (254, 0)}  # and decimals


def write_window_file(wkt: str, levels: int, folder: Path) -> Path:
    """The file of a new, empty window layer. Raises WindowLayerError when it can't be written to the folder, or would
    not have the mosaic's reference system: GeoPackage takes none for degrees."""
    path = free_path(folder, TABLE)
    if not wkt:
        raise WindowLayerError(toolkit_messages.SYSTEM_NOT_WRITTEN(name=path.name))
    if write_table(path, TABLE, output_fields(levels, ()), QgsWkbTypes.Type.Polygon, wkt) is not None:
        raise WindowLayerError(messages.WINDOW_LAYER_NOT_CREATED(folder=folder))
    return path


def open_window_layer(path: Path) -> QgsVectorLayer:
    """The layer of such a file, styled. Raises WindowLayerError when it can't be opened."""
    layer = QgsVectorLayer(f"{path}|layername={TABLE}", tr("Windows"), "ogr")
    if not layer.isValid():
        raise WindowLayerError(messages.WINDOW_LAYER_NOT_CREATED(folder=path.parent))
    keep_system(layer)
    load_style(layer, "windows")
    return layer


def count_windows(path: Path) -> int | None:
    """How many windows a file holds; None for one that the desk did not make, or that can't be read now."""
    if not holds_only_tables(path):
        return None
    try:
        with contextlib.closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", _BUSY_S, uri=True)) as file:
            names = {row[1] for row in file.execute(f"PRAGMA table_info({TABLE})")}
            return file.execute(f"SELECT count(*) FROM {TABLE}").fetchone()[0] if names >= _OURS else None
    except (OSError, sqlite3.Error):
        return None


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


def boxed_windows(layer: QgsVectorLayer, fids: Iterable[int], crs: QgsCoordinateReferenceSystem) -> int:
    """How many windows leave much of the box around them free, in the mosaic's system, which is what is measured."""
    count = 0
    with contextlib.suppress(WindowError):  # which is told of each window that is inspected
        transform = transformation(layer.crs(), crs, QgsProject.instance().transformContext())
        for shape in read_shapes(layer, fids).values():
            shape = transformed(shape, transform)
            count += 0 < shape.area() < _FULL_BOX * shape.boundingBox().area()
    return count


def lacks_fields(layer: QgsVectorLayer, levels: int, besides: Iterable[str] = ()) -> bool:
    """Whether ``complete_fields`` has something to do."""
    return bool(_missing_fields(layer, levels, besides))


def complete_fields(layer: QgsVectorLayer, levels: int, besides: Iterable[str] = ()) -> dict[int, int]:
    """Give a layer that was drawn or placed elsewhere the fields it lacks, as one step of undo.

    ``besides``: fields of what operators say that are used from now on.
    Returns the new ids of features that had to be replaced: QGIS 3.22 saves one that was added before a field
    without that field's value.
    """
    missing = _missing_fields(layer, levels, besides)
    if not missing:
        return {}
    with edit_step(layer, tr("Add fields")):
        if not all(map(layer.addAttribute, missing)):
            raise WindowLayerError(toolkit_messages.WINDOW_LAYER_READ_ONLY(name=layer.name()))
        unsaved = [layer.getFeature(fid) for fid in layer.editBuffer().addedFeatures()]
        renewed = {}
        for old in sorted(unsaved, key=lambda feature: -feature.id()):
            new = QgsFeature(layer.fields())
            new.setGeometry(old.geometry())
            new.setAttributes(old.attributes())
            layer.deleteFeature(old.id())
            layer.addFeature(new)
            renewed[old.id()] = new.id()
    name_fields(layer, "windows")
    return renewed


def _missing_fields(layer: QgsVectorLayer, levels: int, besides: Iterable[str]) -> list[QgsField]:
    is_shapefile, missing = layer.storageType() == _SHAPEFILE, []
    wanted = [(name, column.kind) for column in MEASURED for name in column.names(levels)]
    wanted += [(name, JUDGING_FIELDS[name]) for name in besides if name != FIRST.observer]
    for name, kind in wanted:
        if layer.fields().indexOf(name) >= 0 or (is_shapefile and len(name) > _SHAPEFILE_NAME):
            continue
        made = field(name, kind)
        if is_shapefile:  # QGIS does not save a field whose length comes out as another one
            length, precision = _SHAPEFILE_LENGTHS[kind]
            made.setLength(length)
            made.setPrecision(precision)
        missing.append(made)
    return missing


def read_shapes(layer: QgsVectorLayer, fids: Iterable[int]) -> dict[int, QgsGeometry]:
    """The outlines of some windows."""
    request = QgsFeatureRequest().setFilterFids(list(fids)).setNoAttributes()
    return {feature.id(): QgsGeometry(feature.geometry()) for feature in layer.getFeatures(request)}


def add_windows(
    layer: QgsVectorLayer, outlines: Sequence[QgsGeometry], first: int, at_once: int = 0
) -> Iterator[list[int]]:
    """Add windows, numbered from ``first`` on, as one step of undo, so many of them ``at_once`` (0: all).

    Yields the feature ids each time; a generator that is closed before its end takes all of them back.
    """
    index, part = layer.fields().indexOf("window_id"), at_once or max(len(outlines), 1)
    with edit_step(layer, tr("Add windows")):
        for start in range(0, len(outlines), part):
            fids = []
            for number, outline in enumerate(outlines[start : start + part], first + start):
                feature = QgsVectorLayerUtils.createFeature(layer, outline, {index: number})
                if not layer.addFeature(feature):
                    raise WindowLayerError(toolkit_messages.WINDOW_LAYER_READ_ONLY(name=layer.name()))
                fids.append(feature.id())
            yield fids


def write_numbers(layer: QgsVectorLayer, numbers: Mapping[int, int]) -> None:
    """Write ``window_id``, by feature id, as one step of undo."""
    with edit_step(layer, tr("Number windows")):
        for fid, number in numbers.items():
            _change(layer, fid, {"window_id": number})


def write_results(layer: QgsVectorLayer, results: Mapping[int, WindowResult]) -> None:
    """Write results, by feature id. The observer's word stays; ratios of more levels, left by another inspection, go.

    They are no step of undo: they come by themselves, between what the operator does and wants to take back.
    """
    measured = [column for column in MEASURED if column.name not in ("window_id", "observer")]
    names = layer.fields().names()
    nothing = {name: None for column in measured if column.by_level for name in level_names(column.name, names)}
    changes = {}
    for fid, result in results.items():
        levels = len(result.judgement.ratios.detail)
        values = zip(column_fields(measured, levels).names(), column_values(measured, result, levels))
        changes[fid] = {**nothing, **dict(values)}
    change_quietly(layer, changes, tr("Inspect windows"))


def not_judged_so(layer: QgsVectorLayer, fids: Iterable[int], values: Mapping[str, object]) -> list[int]:
    """Those windows of which an operator said something else so far."""
    names, asked = layer.fields().names(), list(fids)
    if not set(names).issuperset(values):
        return asked
    held = layer.getFeatures(QgsFeatureRequest().setFilterFids(asked).setFlags(QgsFeatureRequest.Flag.NoGeometry))
    same = {
        feature.id()
        for feature in held
        if all((feature[name] if is_known(feature[name]) else None) == value for name, value in values.items())
    }
    return [fid for fid in asked if fid not in same]


def write_judgement(layer: QgsVectorLayer, fids: Iterable[int], values: Mapping[str, object]) -> None:
    """Write what an operator says, by the fields' names, as one step of undo; None takes it back.

    Raises WindowLayerError when the layer has no such field.
    """
    with edit_step(layer, tr("Judge windows")):
        for name in values:
            if layer.fields().indexOf(name) < 0:
                raise WindowLayerError(messages.FIELD_NOT_HELD(name=layer.name(), field=name))
        for fid in fids:
            _change(layer, fid, values)


def remove_windows(layer: QgsVectorLayer, fids: Iterable[int]) -> None:
    """Remove windows as one step of undo."""
    with edit_step(layer, tr("Remove windows")):
        layer.deleteFeatures(list(fids))


def _change(layer: QgsVectorLayer, fid: int, values: Mapping[str, object]) -> None:
    for name, value in values.items():
        index = layer.fields().indexOf(name)
        if index >= 0:
            layer.changeAttributeValue(fid, index, value)


_STYLED = "seam_inspector/styled"  # custom property of the layer: its looks are its user's from now on


def style_if_plain(layer: QgsVectorLayer) -> None:
    """Show verdicts where QGIS has filled the windows with some colour, as it does in a layer that is added anew.

    Once for each layer: what its user makes of it then is his.
    """
    if not layer.customProperty(_STYLED):
        layer.setCustomProperty(_STYLED, True)
        if _is_plain(layer):
            load_style(layer, "windows")
            layer.triggerRepaint()


def _is_plain(layer: QgsVectorLayer) -> bool:
    """Whether it looks as QGIS makes all polygons look, but for their colour."""
    renderer, default = layer.renderer(), QgsSymbol.defaultSymbol(QgsWkbTypes.GeometryType.PolygonGeometry)
    if not isinstance(renderer, QgsSingleSymbolRenderer) or layer.labelsEnabled() or layer.opacity() < 1:
        return False
    symbol = renderer.symbol().clone()
    symbol.setColor(default.color())
    return _look(symbol) == _look(default)


def _look(symbol: QgsSymbol) -> tuple[float, list[tuple[str, dict[str, str]]]]:
    return symbol.opacity(), [(layer.layerType(), layer.properties()) for layer in symbol.symbolLayers()]
