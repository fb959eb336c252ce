"""The table of a radiometric acceptance: its fields, and rows from results. The field names are contracts."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransformContext,
    QgsFeature,
    QgsFields,
    QgsWkbTypes,
)

from ..imagery.errors import WindowError
from ..imagery.grids import PixelWindow
from ..imagery.rasters import Raster
from ..imagery.records import Column
from ..toolkit.layers import rectangle, transformed
from ..toolkit.reference_systems import reference_system, transformation
from ..toolkit.table_fields import column_features, column_fields, feature, table_fields
from ..toolkit.translation import sentence
from .image_set import has_map
from .measure import limits
from .measure.assessment import Assessment, CheckedFigure, decide_image
from .measure.rules import Rule
from .words import spot_words


class _Row(NamedTuple):
    result: Assessment
    checked: CheckedFigure
    decision: str


_COLUMNS: tuple[Column[_Row], ...] = (
    Column("raster", "text", lambda row: row.result.image.ref.name),
    Column("window_id", "integer", lambda row: row.result.window_id),
    Column("band", "text", lambda row: row.checked.band),
    Column("check", "text", lambda row: row.checked.rule.check),
    Column("value", "real", lambda row: row.checked.value),
    Column("limit", "text", lambda row: limit_text(row.checked.rule)),
    Column("passed", "integer", lambda row: None if row.checked.passed is None else int(row.checked.passed)),
    Column("source", "text", lambda row: row.checked.rule.source),
    Column("reason", "text", lambda row: sentence(row.checked.reason) if row.checked.reason else None),
    Column("least", "real", lambda row: row.checked.rule.least),
    Column("most", "real", lambda row: row.checked.rule.most),
    Column("required", "integer", lambda row: int(row.checked.rule.required)),
    Column("decision", "text", lambda row: row.decision),
    Column("place", "text", lambda row: spot_words(row.checked)),
    Column("x", "real", lambda row: None if row.checked.spot is None else row.checked.spot.place[0]),
    Column("y", "real", lambda row: None if row.checked.spot is None else row.checked.spot.place[1]),
)


_AREA_FIELDS = (("raster", "text"), ("red", "real"), ("green", "real"), ("blue", "real"), ("difference", "real"))


def radiometry_fields() -> QgsFields:
    """OUTPUT: one row per raster (or window of it), check and band. Shares are fractions of 1; ``passed`` is 1, 0, or
    nothing where the figure can't be measured or has no limit; ``decision`` is that on the raster or window; ``place``,
    ``x`` and ``y`` say where a figure comes from, in the raster's reference system."""
    return column_fields(_COLUMNS)


def radiometry_features(result: Assessment) -> Iterator[QgsFeature]:
    """The rows of OUTPUT for an image or a window of it."""
    decision = decide_image(result).outcome.value
    return column_features(_COLUMNS, (_Row(result, checked, decision) for checked in result.checked_figures))


def maybe_grey_layout(images: Sequence[Raster]) -> tuple[QgsFields, QgsWkbTypes.Type, QgsCoordinateReferenceSystem]:
    """MAYBE_GREY: polygons of areas that may be grey, in the reference system of the first raster on the map."""
    return table_fields(*_AREA_FIELDS), QgsWkbTypes.Type.Polygon, _first_system(images)


def maybe_grey_features(
    result: Assessment, images: Sequence[Raster], transforms: QgsCoordinateTransformContext
) -> Iterator[QgsFeature]:
    """The rows of MAYBE_GREY for an image; none for one without a place on the map."""
    areas, image = result.maybe_grey, result.image
    if areas is None or not has_map(image):
        return
    try:
        transform = transformation(reference_system(image.wkt), _first_system(images), transforms)
    except WindowError:
        return
    fields = table_fields(*_AREA_FIELDS)
    for (column, row), means, spread in zip(areas.corners.tolist(), areas.means.tolist(), areas.spreads.tolist()):
        window = PixelWindow(column, row, limits.AREA_PX, limits.AREA_PX)
        outline = rectangle(image.grid.window_extent(window))
        try:
            outline = transformed(outline, transform)
        except WindowError:
            continue
        yield feature(fields, [image.ref.name, *means, spread], outline)


def _first_system(images: Sequence[Raster]) -> QgsCoordinateReferenceSystem:
    wkt = next((image.wkt for image in images if has_map(image)), "")
    return reference_system(wkt)


def limit_text(rule: Rule) -> str | None:
    """The limits in the unit of the value; None without any."""
    if rule.least is not None and rule.most is not None:
        return f"{rule.least:g} to {rule.most:g}"
    if rule.most is not None:
        return f"<= {rule.most:g}"
    return None if rule.least is None else f">= {rule.least:g}"
