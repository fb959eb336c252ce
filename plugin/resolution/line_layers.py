"""The layer of lines across bar groups: made and changed, read as lines in pixels of the raster, written as results.

The field names are contracts.
"""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice
from pathlib import Path

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsFeature,
    QgsFields,
    QgsGeometry,
    QgsPointXY,
    QgsProject,
    QgsVectorLayer,
    QgsVectorLayerUtils,
    QgsWkbTypes,
)

from ..imagery import messages as imagery_messages
from ..imagery.errors import Message, SettingsError, WindowError, WindowLayerError
from ..imagery.grids import Grid
from ..imagery.records import Column
from ..imagery.statistics import DECIDED, VISIBLE
from ..toolkit import messages as toolkit_messages
from ..toolkit.geopackages import free_path, write_table
from ..toolkit.layer_styles import load_style
from ..toolkit.layers import edit_step
from ..toolkit.reference_systems import keep_system, transformation
from ..toolkit.table_fields import column_fields, column_values, feature, table_fields, text, whole_number
from ..toolkit.translation import sentence, tr
from .measure import messages
from .measure.bar_groups import GroupResult
from .measure.bars import BarLine
from .measure.profiles import Segment
from .measure.target import DIRECTIONS

MAX_LINE_BEND = 0.05  # of its length that a line across the bars may leave its chord

LARGEST_GROUP = 999
GROUP, DIRECTION, OBSERVER = "group", "direction", "observer"

_COLUMNS: tuple[Column[GroupResult], ...] = (
    Column(GROUP, "integer", lambda result: result.measured.line.group),
    Column(DIRECTION, "text", lambda result: result.measured.line.direction),
    Column("band", "text", lambda result: result.band or None),
    Column("grd", "real", lambda result: result.grd_cm),
    Column("grd_error", "real", lambda result: result.grd_error_cm),
    Column("bars_found", "integer", lambda result: result.reading and len(result.reading.bars)),
    Column("amplitude", "real", lambda result: result.reading and result.reading.amplitude),
    Column("full_amplitude", "real", lambda result: result.reading and result.reading.full_amplitude),
    Column("amplitude_error", "real", lambda result: result.reading and result.reading.amplitude_error),
    Column("modulation", "real", lambda result: result.reading and result.reading.modulation),
    Column("resolved", "integer", lambda result: result.reading and int(result.resolved)),
    Column("spurious", "integer", lambda result: result.reading and int(result.spurious)),
    Column("observers", "integer", lambda result: len(result.measured.line.seen) or None),
    Column("seen_by", "integer", lambda result: sum(result.measured.line.seen.values()) if result.measured.line.seen
           else None),
    Column("shift_px", "real", lambda result: result.measured.shifts.get(result.band)),
    Column("reason", "text", lambda result: None if result.reason is None else sentence(result.reason)),
)


def check_fields(names: Sequence[str]) -> None:
    for name in (GROUP, DIRECTION):
        if name not in names:
            raise SettingsError(messages.FIELD_MISSING(field=name))


def observer_fields(names: Sequence[str]) -> list[str]:
    """The fields in which observers say what they see: ``observer``, ``observer_2`` and so on."""
    return [name for name in names if name == OBSERVER or name.startswith(f"{OBSERVER}_")]


def bar_line(
    row: QgsFeature, grid: Grid, transform: QgsCoordinateTransform, observers: Sequence[str] = ()
) -> BarLine:
    """A line of the layer in pixels of a raster; what can't be measured says why. ``transform``: to the raster."""
    group, given = whole_number(row[GROUP], LARGEST_GROUP), text(row[DIRECTION])
    direction = given.lower()
    segment, reason = _segment(QgsGeometry(row.geometry()), grid, transform)
    if direction not in DIRECTIONS:
        reason = messages.DIRECTION_UNKNOWN(direction=given)
    if group is None:
        reason = messages.GROUP_NOT_GIVEN()
    words = {name: text(row[name]).lower() for name in observers}
    return BarLine(group, direction, segment, reason, {
        name: word == VISIBLE for name, word in words.items() if word in DECIDED
    })


def pixel_segment(points: Sequence[QgsPointXY], grid: Grid) -> Segment:
    """A line between two points of the map in pixels of the raster."""
    start, end = ((grid.column_at(point.x()), grid.row_at(point.y())) for point in points)
    return Segment(start, end)


def result_fields() -> QgsFields:
    return column_fields(_COLUMNS)


def result_features(results: Sequence[GroupResult], grid: Grid) -> Iterator[QgsFeature]:
    """The rows of OUTPUT: the lines as they were measured, turned to be perpendicular to the bars."""
    fields = result_fields()
    for result in results:
        segment = result.measured.segment or result.measured.line.segment
        ends = [] if segment is None else [grid.to_map(*end) for end in (segment.start, segment.end)]
        line = QgsGeometry.fromPolylineXY([QgsPointXY(*end) for end in ends]) if ends else None
        yield feature(fields, column_values(_COLUMNS, result), line)


def _segment(
    geometry: QgsGeometry, grid: Grid, transform: QgsCoordinateTransform
) -> tuple[Segment | None, Message | None]:
    if geometry.isEmpty() or geometry.constGet().partCount() > 1:
        return None, messages.BAR_LINE_BENT()
    try:
        geometry.transform(transform)
    except QgsCsException:
        return None, imagery_messages.EXTENT_NOT_TRANSFORMED()
    points = [QgsPointXY(point.x(), point.y()) for point in geometry.vertices()]
    chord = QgsGeometry.fromPolylineXY([points[0], points[-1]])
    bend = max(chord.distance(QgsGeometry.fromPointXY(point)) for point in points)
    segment = pixel_segment((points[0], points[-1]), grid)
    if chord.length() == 0 or bend > MAX_LINE_BEND * chord.length():
        return None if chord.length() == 0 else segment, messages.BAR_LINE_BENT()
    return segment, None


_LAYER_NAME = "bar_groups"
_MOST_LINES = 1000


def create_bar_layer(wkt: str, folder: Path) -> QgsVectorLayer:
    """A new, empty GeoPackage in a folder, styled; ``wkt``: its reference system. Raises WindowLayerError when it can't
    be written there."""
    path, fields = free_path(folder, _LAYER_NAME), table_fields((GROUP, "integer"), (DIRECTION, "text"))
    error = write_table(path, _LAYER_NAME, fields, QgsWkbTypes.Type.LineString, wkt)
    layer = QgsVectorLayer(f"{path}|layername={_LAYER_NAME}", tr("Bar groups"), "ogr")
    if error is not None or not layer.isValid():
        raise WindowLayerError(messages.BAR_LAYER_NOT_CREATED(folder=folder))
    keep_system(layer)
    load_style(layer, "bar_groups")
    return layer


def add_bar_line(
    layer: QgsVectorLayer, line: QgsGeometry, transform: QgsCoordinateTransform, group: int, direction: str
) -> int:
    """Add a line as one step of undo; its feature id. ``transform``: from the line's system to the layer's.

    Raises SettingsError when the layer lacks the fields, WindowLayerError when it can't be edited.
    """
    check_fields(layer.fields().names())
    shape = QgsGeometry(line)
    try:
        shape.transform(transform)
    except QgsCsException:
        raise WindowLayerError(imagery_messages.EXTENT_NOT_TRANSFORMED()) from None
    with edit_step(layer, tr("Add a bar group")):
        values = {layer.fields().indexOf(GROUP): group, layer.fields().indexOf(DIRECTION): direction}
        feature = QgsVectorLayerUtils.createFeature(layer, shape, values)
        if not layer.addFeature(feature):
            raise WindowLayerError(toolkit_messages.WINDOW_LAYER_READ_ONLY(name=layer.name()))
    return int(feature.id())


def next_group(layer: QgsVectorLayer | None, direction: str) -> int | None:
    """The number above the largest of a direction; None where the layer has none."""
    if layer is None or not {GROUP, DIRECTION} <= set(layer.fields().names()):
        return None
    rows = (row for row in layer.getFeatures() if row[DIRECTION] == direction)
    numbers = [row[GROUP] for row in rows if isinstance(row[GROUP], int)]
    return max(numbers) + 1 if numbers else None


def drawn_lines(layer: QgsVectorLayer | None, grid: Grid, crs: QgsCoordinateReferenceSystem) -> list[BarLine]:
    """The lines of a layer in pixels of an image, as far as they can be measured; the first thousand, to stay quick."""
    if layer is None or not {GROUP, DIRECTION} <= set(layer.fields().names()):
        return []
    try:
        transform = transformation(layer.crs(), crs, QgsProject.instance().transformContext())
    except WindowError:
        return []
    lines = (bar_line(row, grid, transform) for row in islice(layer.getFeatures(), _MOST_LINES))
    return [line for line in lines if line.reason is None]
