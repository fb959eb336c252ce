"""Point layers and georeferencer files -> control and check points; points -> features."""
from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import numpy as np
from osgeo import osr
from qgis.core import (
    QgsFeature,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingFeatureSource,
    QgsProviderRegistry,
    QgsVectorLayer,
    QgsWkbTypes,
)

from ..imagery.errors import Message, SensorModelError
from ..imagery.gdal_calls import gdal_silenced
from ..imagery.gdal_paths import FEATURES, open_dataset
from ..imagery.records import Column
from ..toolkit.layers import features, layer_path, system_wkt
from ..toolkit.table_fields import Attributes, attributes, feature, number, table_fields, text
from .measure import messages
from .measure.adjustment import Adjustment, Comparison, JudgedModel
from .measure.point_planning import ExpectedAccuracy
from .measure.points import CHECK, CONTROL, Points, control_points


def heights_wkt(layer: QgsVectorLayer) -> str:
    """The system that says what a layer's heights are, or empty: QGIS forgets it, so code and file are asked."""
    system, code = osr.SpatialReference(), str(layer.crs().authid())
    with gdal_silenced(), suppress(RuntimeError):
        system.SetFromUserInput(code)
    if _has_heights(system):
        return code
    path = layer_path(layer)
    file = open_dataset(path, FEATURES) if path else None
    name = QgsProviderRegistry.instance().decodeUri("ogr", layer.source()).get("layerName")
    with gdal_silenced(), suppress(RuntimeError):
        part = None if file is None else file.GetLayerByName(name) if name else file.GetLayer(0)
        stored = None if part is None else part.GetSpatialRef()
        if stored is not None and _has_heights(stored):
            return str(stored.ExportToWkt(["FORMAT=WKT2_2018"]))
    return ""


def _has_heights(system: osr.SpatialReference) -> bool:
    return bool(system.IsCompound()) or system.GetAxesCount() == 3


def layer_points(source: QgsProcessingFeatureSource, heights: str = "") -> tuple[Points, bool, list[Message]]:
    """The points of a layer, whether they have roles, and what was left out. ``heights``: the system that says what
    heights refer to. Raises SensorModelError."""
    names = [name.lower() for name in source.fields().names()]
    for field in ("column", "row"):
        if field not in names:
            raise SensorModelError(messages.POINTS_WITHOUT_FIELD(field=field))
    if not source.sourceCrs().isValid():
        raise SensorModelError(messages.POINTS_WITHOUT_SYSTEM(name=source.sourceName()))
    rows: list[tuple[str, list[float], str]] = []
    notices: list[Message] = []
    for row in attributes(features(source), names):
        name = text(row["id"]) or str(row.feature.id())
        role = text(row["role"]).lower()
        point = _numbers(row)
        if role not in ("", CONTROL, CHECK):
            notices.append(messages.POINT_LEFT_OUT(name=name, why=messages.POINT_ROLE_UNKNOWN(role=role)))
        elif not all(map(math.isfinite, point[:4])):
            notices.append(messages.POINT_LEFT_OUT(name=name, why=messages.POINT_WITHOUT_PLACE()))
        else:
            rows.append((name, point, role))
    if not rows:
        raise SensorModelError(messages.NO_POINTS_LEFT(why=notices[0]) if notices else messages.NO_POINTS())
    ids, numbers, roles = zip(*rows)
    values, check = np.array(numbers), np.array([role == CHECK for role in roles])
    points = control_points(ids, values[:, 0:2], values[:, 2:5], system_wkt(source.sourceCrs()))
    return replace(points, sigma_px=values[:, 5], check=check, heights_wkt=heights), any(roles), notices


def _numbers(row: Attributes) -> list[float]:
    """Column, row, x, y, z, sigma; NaN for what is missing."""
    geometry = row.feature.geometry()
    x = y = height = math.nan
    if not geometry.isNull() and not geometry.isEmpty() and geometry.type() == QgsWkbTypes.GeometryType.PointGeometry:
        vertex = geometry.vertexAt(0)
        x, y, height = vertex.x(), vertex.y(), vertex.z() if vertex.is3D() else math.nan
    values = (number(row[name]) for name in ("column", "row", "z", "sigma"))
    column, line, z, sigma = (math.nan if value is None else value for value in values)
    return [column, line, x, y, height if math.isnan(z) else z, sigma]


RESIDUALS = (
    ("id", "text"), ("role", "text"), ("column", "real"), ("row", "real"), ("z", "real"), ("residual_column", "real"),
    ("residual_row", "real"), ("residual_x", "real"), ("residual_y", "real"), ("blunder", "integer"),
)  # fmt: skip
"""OUTPUT of ``fitsensormodel``: the points with what the model leaves."""
PLANS: tuple[Column[ExpectedAccuracy], ...] = (
    Column("model", "text", lambda plan: plan.model),
    Column("control_count", "integer", lambda plan: plan.count),
    Column("image_50", "real", lambda plan: plan.image_usual),
    Column("image_90", "real", lambda plan: plan.image_most),
    Column("check_50", "real", lambda plan: plan.check_usual),
    Column("check_90", "real", lambda plan: plan.check_most),
    Column("failed", "integer", lambda plan: plan.failed),
    Column("reason", "text", lambda plan: plan.reason),
)
"""OUTPUT of ``planpoints``: one row per number of points."""


def model_columns(result: Comparison) -> tuple[Column[JudgedModel], ...]:
    """OUTPUT of ``comparesensormodels``: one row per model."""
    return (
        Column("model", "text", lambda row: row.request.kind.name),
        Column("order", "integer", _order),
        Column("variant", "text", lambda row: None if _order(row) else row.request.variant.name or None),
        Column("mean_x", "real", lambda row: row.errors and row.errors.rmse_x),
        Column("mean_y", "real", lambda row: row.errors and row.errors.rmse_y),
        Column("max_x", "real", lambda row: row.errors and row.errors.max_x),
        Column("max_y", "real", lambda row: row.errors and row.errors.max_y),
        Column("control_count", "integer", lambda row: row.control_count),
        Column("check_count", "integer", lambda row: row.errors.count if row.errors else 0),
        Column("method", "text", lambda row: result.method),
        Column("control_mean_x", "real", lambda row: row.control and row.control.rmse_x),
        Column("control_mean_y", "real", lambda row: row.control and row.control.rmse_y),
        Column("condition", "real", lambda row: _finite(row.condition)),
        Column("recommended", "integer", lambda row: int(row is result.recommended)),
        Column("reason", "text", lambda row: row.reason),
    )


def _order(model: JudgedModel) -> int | None:
    name = model.request.variant.name
    return int(name) if name.isdigit() else None


def _finite(value: float | None) -> float | None:
    return float(value) if value is not None and math.isfinite(value) else None


def residual_features(done: Adjustment) -> Iterator[QgsFeature]:
    """A feature of each point, in the order of the points."""
    points, fields = done.points, table_fields(*RESIDUALS)
    numbers = np.column_stack([points.image, points.ground[:, 2], done.residuals_px, done.residuals_m])
    places = points.ground[:, :2].tolist()
    for name, check, row, blunder, place in zip(points.ids, points.check, numbers.tolist(), done.blunder, places):
        values = (name, CHECK if check else CONTROL, *map(_finite, row), int(blunder))
        yield feature(fields, list(values), QgsGeometry.fromPointXY(QgsPointXY(*place)))
