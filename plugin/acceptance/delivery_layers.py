"""Layers of seams, as scans and ``planinspection`` write them, and of inspected windows -> plain data.

Layers are looked up in their own thread, and their rows read in another.
"""
from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeatureRequest,
    QgsGeometry,
    QgsProcessingContext,
    QgsProcessingFeatureSource,
    QgsProcessingUtils,
    QgsVectorLayer,
    QgsVectorLayerFeatureSource,
    QgsWkbTypes,
)

from ..imagery.errors import SettingsError, WindowError
from ..imagery.seam_totals import TOTALS_DOMAIN
from ..toolkit import layers
from ..toolkit.algorithms.run import Run
from ..toolkit.table_fields import attributes, text
from ..toolkit.translation import tr
from .measure import messages
from .measure.delivered_rows import ScannedLayer, SeamRow
from .measure.delivery import SeenWindow


def inspected_windows(
    source: QgsProcessingFeatureSource, crs: QgsCoordinateReferenceSystem, run: Run
) -> tuple[SeenWindow, ...]:
    """The windows that have an outline, in a reference system; what is wrong with others is told."""
    transform = run.transform(source, crs) if crs.isValid() else None
    windows = []
    for row in attributes(layers.features(source), source.fields().names()):
        try:
            extent = layers.outline_extent(row.feature, transform)
        except WindowError as error:
            run.tell(error.message.as_warning())
            continue
        if extent is not None:
            remarks = filter(None, (text(row["remark"]), text(row["remark_2"])))
            cause = "" if text(row["cause"]) == _NO_CAUSE else text(row["cause"])
            windows.append(SeenWindow(extent, cause, tuple(remarks), text(row["observer"])))
    return tuple(windows)


_NO_CAUSE = "none"  # the inspection's word
_OF_SCAN_FILE = "seams"  # the table of a scan's file with several
_LINE = QgsWkbTypes.GeometryType.LineGeometry


def seam_layers(values: Sequence[object], context: QgsProcessingContext) -> list[ScannedLayer]:
    """The layers behind a parameter's values, to be read in any thread.

    Raises SettingsError where one is no layer of lines with what is kept, or is filtered.
    """
    given = [_line_layer(value, context) for value in values]
    for layer in given:
        if layer.subsetString():
            raise SettingsError(messages.LAYER_FILTERED(name=layer.name(), filter=layer.subsetString()))
        if "kept_1" not in layer.fields().names():
            raise SettingsError(messages.LAYER_WITHOUT_KEPT(name=layer.name()))
    if not given:
        raise SettingsError(messages.NO_LAYERS())
    return [
        ScannedLayer(
            name, _rows(QgsVectorLayerFeatureSource(layer), layer.fields().names()), layers.system_wkt(layer.crs()),
            layers.layer_notes(layer, TOTALS_DOMAIN), address=layers.layer_address(layer),
        )
        for name, layer in zip(_names(given), given)
    ]


def _rows(source: QgsVectorLayerFeatureSource, names: Sequence[str]) -> Iterator[tuple[SeamRow, np.ndarray]]:
    for feature in source.getFeatures(QgsFeatureRequest()):
        values = zip(names, feature.attributes())
        row = {name: value if isinstance(value, (int, float)) else text(value) for name, value in values}
        yield row, _vertices(feature.geometry())


def _line_layer(value: object, context: QgsProcessingContext) -> QgsVectorLayer:
    layer = value
    if isinstance(value, str):
        vector = QgsProcessingUtils.LayerHint.Vector
        layer = QgsProcessingUtils.mapLayerFromString(value, context, True, vector)
        if not _has_lines(layer) and "|" not in value and os.path.isfile(value):
            layer = QgsVectorLayer(f"{value}|layername={_OF_SCAN_FILE}", Path(value).stem, "ogr")
            layer = layer if layer.isValid() else QgsVectorLayer(value, Path(value).stem, "ogr")
    if not isinstance(layer, QgsVectorLayer) or not _has_lines(layer):
        raise SettingsError(messages.LAYER_NOT_FOUND(name=layer.name() if hasattr(layer, "name") else value))
    return layer


def _has_lines(layer: object) -> bool:
    return isinstance(layer, QgsVectorLayer) and layer.isValid() and layer.geometryType() == _LINE


def _name(layer: QgsVectorLayer) -> str:
    """Name of the layer; of its file where the layer has the title that scans give theirs, or that of a file with dots,
    whose name ends at the first one for QGIS."""
    name, file = layer.name(), Path(layers.layer_path(layer))
    return file.stem if file.stem and name in (file.name.split(".")[0], tr("Seams")) else name


def _names(seams: Sequence[QgsVectorLayer]) -> list[str]:
    """Names of layers; those of one name are told apart by their folder, else by a number."""
    names = [_name(layer) for layer in seams]
    counts = Counter(names)
    folders = [Path(layers.layer_path(layer)).parent.name if layers.layer_path(layer) else "" for layer in seams]
    names = [f"{folder}/{name}" if counts[name] > 1 and folder else name for name, folder in zip(names, folders)]
    seen: Counter[str] = Counter()
    unique = []
    for name in names:
        seen[name] += 1
        unique.append(name if seen[name] == 1 else f"{name} ({seen[name]})")
    return unique


def _vertices(line: QgsGeometry) -> np.ndarray:
    """(n, 2) of a line, its parts one after the other."""
    if line.isEmpty() or line.type() != _LINE:
        return np.empty((0, 2))
    merged = line.mergeLines() if line.isMultipart() else line
    parts = merged.asMultiPolyline() if merged.isMultipart() else [merged.asPolyline()]
    return np.array([(point.x(), point.y()) for part in parts for point in part], float).reshape(-1, 2)
