"""The layer of lines across bar groups: an ordinary line layer, changed through its edit buffer."""
from __future__ import annotations

import os
from itertools import islice
from pathlib import Path

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsCsException,
    QgsGeometry,
    QgsProject,
    QgsVectorFileWriter,
    QgsVectorLayer,
    QgsVectorLayerUtils,
    QgsWkbTypes,
)

from ..imagery import messages as imagery_messages
from ..imagery.errors import WindowLayerError
from ..imagery.grids import Grid
from ..toolkit import messages as toolkit_messages
from ..toolkit.layer_editing import edit_step
from ..toolkit.layer_styles import load_style
from ..toolkit.table_fields import table_fields
from ..toolkit.translation import tr
from .line_table import DIRECTION, GROUP, bar_line
from .measure import messages
from .measure.bar_lines import BarLine

_LAYER_NAME = "bar_groups"
_MOST_LINES = 1000


def create_bar_layer(crs: QgsCoordinateReferenceSystem, folder: Path) -> QgsVectorLayer:
    """A new, empty GeoPackage in a folder, styled. Raises WindowLayerError when it can't be written there."""
    path, number = folder / f"{_LAYER_NAME}.gpkg", 1
    while os.path.lexists(path):
        number += 1
        path = folder / f"{_LAYER_NAME}_{number}.gpkg"
    options = QgsVectorFileWriter.SaveVectorOptions()
    options.driverName, options.layerName, options.fileEncoding = "GPKG", _LAYER_NAME, "UTF-8"
    fields = table_fields((GROUP, "integer"), (DIRECTION, "text"))
    writer = QgsVectorFileWriter.create(
        str(path), fields, QgsWkbTypes.Type.LineString, crs, QgsCoordinateTransformContext(), options
    )
    failed = writer.hasError() != QgsVectorFileWriter.WriterError.NoError
    del writer  # closes the file
    layer = QgsVectorLayer(f"{path}|layername={_LAYER_NAME}", tr("Bar groups"), "ogr")
    if failed or not layer.isValid():
        raise WindowLayerError(messages.BAR_LAYER_NOT_CREATED(folder=folder))
    load_style(layer, "bar_groups")
    return layer


def add_bar_line(
    layer: QgsVectorLayer, line: QgsGeometry, transform: QgsCoordinateTransform, group: int, direction: str
) -> int:
    """Add a line as one step of undo; its feature id. ``transform``: from the line's system to the layer's.

    Raises WindowLayerError when the layer lacks the fields or can't be edited.
    """
    shape = QgsGeometry(line)
    try:
        shape.transform(transform)
    except QgsCsException:
        raise WindowLayerError(imagery_messages.EXTENT_NOT_TRANSFORMED()) from None
    places = [layer.fields().indexOf(name) for name in (GROUP, DIRECTION)]
    if min(places) < 0:
        raise WindowLayerError(messages.FIELD_MISSING(field=(GROUP, DIRECTION)[places.index(min(places))]))
    with edit_step(layer, tr("Add a bar group")):
        feature = QgsVectorLayerUtils.createFeature(layer, shape, dict(zip(places, (group, direction))))
        if not layer.addFeature(feature):
            raise WindowLayerError(toolkit_messages.WINDOW_LAYER_READ_ONLY(name=layer.name()))
    return int(feature.id())


def next_group(layer: QgsVectorLayer | None, direction: str) -> int | None:
    """One above the largest number of a direction; None where the layer has none."""
    if layer is None or not {GROUP, DIRECTION} <= set(layer.fields().names()):
        return None
    rows = (row for row in layer.getFeatures() if row[DIRECTION] == direction)
    numbers = [row[GROUP] for row in rows if isinstance(row[GROUP], int)]
    return max(numbers) + 1 if numbers else None


def drawn_lines(layer: QgsVectorLayer | None, grid: Grid, crs: QgsCoordinateReferenceSystem) -> list[BarLine]:
    """The lines of a layer in pixels of an image, as far as they can be measured; the first thousand, to stay quick."""
    if layer is None or not {GROUP, DIRECTION} <= set(layer.fields().names()):
        return []
    transform = QgsCoordinateTransform(layer.crs(), crs, QgsProject.instance().transformContext())
    lines = (bar_line(row, grid, transform) for row in islice(layer.getFeatures(), _MOST_LINES))
    return [line for line in lines if line.reason is None]
