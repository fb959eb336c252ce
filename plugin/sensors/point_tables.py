"""Point layers and georeferencer files -> control and check points; points -> features."""
from __future__ import annotations

import math
import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import numpy as np
from osgeo import osr
from qgis.core import (
    QgsFeature,
    QgsFields,
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
from ..toolkit.table_fields import Attributes, attributes, column_fields, column_values, feature, number, text
from .measure import messages
from .measure.adjustment import Adjustment, Comparison, JudgedModel
from .measure.point_planning import ExpectedAccuracy
from .measure.points import CHECK, CONTROL, Points, control_points
from .measure.rpc import PIXEL_CENTRE


def heights_wkt(layer: QgsVectorLayer) -> str:
    """What says what a layer's heights are, or empty: QGIS forgets it, so the code and the file are asked."""
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
        found = None if part is None else part.GetSpatialRef()
        if found is not None and _has_heights(found):
            return str(found.ExportToWkt(["FORMAT=WKT2_2018"]))
    return ""


def _has_heights(system: osr.SpatialReference) -> bool:
    return bool(system.IsCompound()) or system.GetAxesCount() == 3


_SHOWN = 5


def layer_points(
    source: QgsProcessingFeatureSource, image_name: str = "", heights: str = ""
) -> tuple[Points, bool, list[Message]]:
    """The points of a layer, whether they have roles, and what was left out; of orthority's (``ji``, ``filename``)
    those of the image. ``heights``: the system that says what heights refer to. Raises SensorModelError."""
    names = [name.lower() for name in source.fields().names()]
    missing = [name for name in ("column", "row") if name not in names]
    of_orthority = bool(missing) and "ji" in names
    if missing and not of_orthority:
        raise SensorModelError(messages.POINTS_WITHOUT_FIELD(field=missing[0]))
    if not source.sourceCrs().isValid():
        raise SensorModelError(messages.POINTS_WITHOUT_SYSTEM(name=source.sourceName()))
    rows: list[tuple[str, list[float], str]] = []
    notices: list[Message] = []
    images: set[str] = set()
    for row in attributes(features(source), names):
        if of_orthority:
            images.add(named := text(row["filename"]))
            if named and image_name and Path(named).stem.lower() != Path(image_name).stem.lower():
                continue  # folders and endings do not count, as with orthority
        name = text(row["id"]) or str(row.feature.id())
        role = text(row["role"]).lower()
        numbers = _numbers(row, _orthority_place(row["ji"]) if of_orthority else None)
        if role not in ("", CONTROL, CHECK):
            notices.append(messages.POINT_LEFT_OUT(name=name, why=messages.POINT_ROLE_UNKNOWN(role=role)))
        elif not all(map(math.isfinite, numbers[:4])):
            notices.append(messages.POINT_LEFT_OUT(name=name, why=messages.POINT_WITHOUT_PLACE()))
        else:
            rows.append((name, numbers, role))
    if (len(images) > 1 and not image_name) or (images and not rows and not notices):
        raise SensorModelError(messages.POINTS_OF_OTHER_IMAGES(names=", ".join(sorted(images)[:_SHOWN])))
    if not rows:
        raise SensorModelError(messages.NO_POINTS_LEFT(why=notices[0]) if notices else messages.NO_POINTS())
    ids, found, roles = zip(*rows)
    values, check = np.array(found), np.array([role == CHECK for role in roles])
    points = control_points(ids, values[:, 0:2], values[:, 2:5], system_wkt(source.sourceCrs()))
    return replace(points, sigma_px=values[:, 5], check=check, heights_wkt=heights), any(roles), notices


def _orthority_place(value: object) -> tuple[float, float]:
    """Column and row of orthority's ji, which counts from the middle of the first pixel; NaN where it is none."""
    found = value if isinstance(value, (list, tuple)) else re.findall(r"[-+.\deE]+", text(value))
    numbers = [math.nan if (place := number(one)) is None else place + PIXEL_CENTRE for one in found]
    return (numbers[0], numbers[1]) if len(numbers) == 2 else (math.nan, math.nan)


def _numbers(row: Attributes, place: tuple[float, float] | None = None) -> list[float]:
    """Column, row, x, y, z, sigma; NaN for what is missing. ``place``: column and row, where no fields hold them."""
    geometry = row.feature.geometry()
    x = y = height = math.nan
    if not geometry.isNull() and not geometry.isEmpty() and geometry.type() == QgsWkbTypes.GeometryType.PointGeometry:
        vertex = geometry.vertexAt(0)
        x, y, height = vertex.x(), vertex.y(), vertex.z() if vertex.is3D() else math.nan
    found = (number(row[name]) for name in ("column", "row", "z", "sigma"))
    column, line, z, sigma = (math.nan if value is None else value for value in found)
    column, line = place or (column, line)
    return [column, line, x, y, height if math.isnan(z) else z, sigma]


_Judged = tuple[Comparison, JudgedModel]
_RESIDUALS: tuple[Column[tuple[Adjustment, int]], ...] = (
    Column("id", "text", lambda one: one[0].points.ids[one[1]]),
    Column("role", "text", lambda one: CHECK if one[0].points.check[one[1]] else CONTROL),
    Column("column", "real", lambda one: one[0].points.image[one[1], 0]),
    Column("row", "real", lambda one: one[0].points.image[one[1], 1]),
    Column("z", "real", lambda one: _finite(one[0].points.ground[one[1], 2])),
    Column("residual_column", "real", lambda one: one[0].residuals_px[one[1], 0]),
    Column("residual_row", "real", lambda one: one[0].residuals_px[one[1], 1]),
    Column("residual_x", "real", lambda one: one[0].residuals_m[one[1], 0]),
    Column("residual_y", "real", lambda one: one[0].residuals_m[one[1], 1]),
    Column("blunder", "integer", lambda one: int(one[0].blunder[one[1]])),
)
"""OUTPUT of ``fitsensormodel``: the points with what the model leaves."""
MODELS: tuple[Column[_Judged], ...] = (
    Column("model", "text", lambda one: one[1].request.kind.name),
    Column("order", "integer", lambda one: _order(one[1])),
    Column("variant", "text", lambda one: None if _order(one[1]) else one[1].request.variant.name or None),
    Column("mean_x", "real", lambda one: one[1].errors and one[1].errors.rmse_x),
    Column("mean_y", "real", lambda one: one[1].errors and one[1].errors.rmse_y),
    Column("max_x", "real", lambda one: one[1].errors and one[1].errors.max_x),
    Column("max_y", "real", lambda one: one[1].errors and one[1].errors.max_y),
    Column("control_count", "integer", lambda one: one[1].control_count),
    Column("check_count", "integer", lambda one: one[1].errors.count if one[1].errors else 0),
    Column("method", "text", lambda one: one[0].method),
    Column("control_mean_x", "real", lambda one: one[1].control and one[1].control.rmse_x),
    Column("control_mean_y", "real", lambda one: one[1].control and one[1].control.rmse_y),
    Column("condition", "real", lambda one: _finite(one[1].condition)),
    Column("recommended", "integer", lambda one: int(one[1] is one[0].recommended)),
    Column("reason", "text", lambda one: one[1].reason),
)
"""OUTPUT of ``comparesensormodels``: one row per model."""
PLANS: tuple[Column[tuple[str, ExpectedAccuracy]], ...] = (
    Column("model", "text", lambda one: one[0]),
    Column("control_count", "integer", lambda one: one[1].count),
    Column("image_50", "real", lambda one: one[1].image_usual),
    Column("image_90", "real", lambda one: one[1].image_most),
    Column("check_50", "real", lambda one: one[1].check_usual),
    Column("check_90", "real", lambda one: one[1].check_most),
    Column("failed", "integer", lambda one: one[1].failed),
    Column("reason", "text", lambda one: one[1].reason),
)
"""OUTPUT of ``planpoints``: one row per number of points."""


def _order(row: JudgedModel) -> int | None:
    name = row.request.variant.name
    return int(name) if name.isdigit() else None


def _finite(value: float | None) -> float | None:
    return float(value) if value is not None and math.isfinite(value) else None


def residual_fields() -> QgsFields:
    return column_fields(_RESIDUALS)


def residual_features(done: Adjustment) -> Iterator[QgsFeature]:
    fields = residual_fields()
    for index, place in enumerate(done.points.ground[:, :2].tolist()):
        point = QgsGeometry.fromPointXY(QgsPointXY(*place))
        yield feature(fields, column_values(_RESIDUALS, (done, index)), point)
