"""What a run of a sensor model is given: image, RPC, terrain, points of layers and files; and points -> features."""
from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property
from pathlib import Path

import numpy as np
from qgis.core import QgsFeature, QgsGeometry, QgsPointXY, QgsProcessingFeatureSource, QgsWkbTypes

from ..imagery.errors import Message, SensorModelError, SettingsError
from ..imagery.rasters import RasterRef
from ..imagery.records import Column
from ..toolkit.algorithms.run import Run
from ..toolkit.layers import features, system_wkt
from ..toolkit.table_fields import Attributes, attributes, feature, number, table_fields, text
from ..toolkit.translation import tr
from . import sensor_parameters as common
from .measure import heights, limits, messages, points
from .measure.adjustment import Adjustment, Comparison, JudgedModel
from .measure.heights import Datum
from .measure.point_planning import ExpectedAccuracy
from .measure.points import CHECK, CONTROL, ImageBox, Points
from .measure.polynomials import Rational
from .measure.registry import ModelRequest
from .measure.rpc import open_image, own_rpc, read_rpc, rpc_of_image_part
from .measure.sensor_model import bounding_box

ORBIT_HEIGHTS_KM = {  # by the satellite's name in the image's metadata; the operators' data sheets
    "PHR": 694.0, "PLEIADES": 694.0, "SPOT": 694.0, "PNEO": 620.0, "IK": 681.0, "QB": 450.0, "WV01": 496.0,
    "WV02": 770.0, "WV03": 617.0, "WV04": 617.0, "GE01": 681.0, "GEOEYE": 681.0, "EROS": 480.0, "KOMPSAT": 685.0,
}  # fmt: skip


class SensorInputs:
    """Image, RPC, terrain and points that a run is given."""

    def __init__(
        self, run: Run, image: RasterRef | None, dem: RasterRef | None, heights_wkt: str, rpc_name: str
    ) -> None:
        """``heights_wkt``: of the points' layer, as in ``Points``; ``rpc_name``: the parameter of the RPC's file."""
        self._run, self._dem, self._heights_wkt, self._rpc_name = run, dem, heights_wkt, rpc_name
        self.image = open_image(image) if image is not None else None

    @property
    def size(self) -> tuple[float, float] | None:
        """Columns and rows of the image."""
        return None if self.image is None else (float(self.image.columns), float(self.image.rows))

    def box(self, given: Points) -> ImageBox:
        """The image's rectangle, or that of the points where there is no image."""
        return bounding_box(given.image) if self.size is None else (0.0, 0.0, *self.size)

    def read_points(self, request: ModelRequest | None = None) -> Points:
        """The points with roles, and heights where the model (None: any) needs them, held against the image's RPC."""
        run, image_rpc = self._run, self.rpc
        given, with_roles, notices = self._points_given()
        run.tell(*notices)
        points.check_plausible(given)
        if request is None or request.needs_heights:
            datum, dem_datum = height_datums(run, common.HEIGHTS, common.DEM_HEIGHTS)
            given, notices = heights.with_heights(given, datum, self._dem, dem_datum, tr("the points"))
            run.tell(*notices)
        if not len(given):
            raise SettingsError(messages.NO_POINTS())
        if self.image is not None:
            run.tell(*points.check_inside(given, (self.image.columns, self.image.rows), image_rpc))
        if image_rpc is not None:
            run.tell(*points.check_against_rpc(given, image_rpc))
        return given if with_roles else points.choose_check_points(given, run.real(common.CHECK_SHARE))

    def _points_given(self) -> tuple[Points, bool, list[Message]]:
        """The points as given, whether they have roles, and what was left out."""
        run, image = self._run, self.image
        given = run.parameters.get(common.GCPS)
        path, wkt = common.points_path(given), system_wkt(run.crs(common.GCPS_CRS))
        if path.lower().endswith(common.POINTS_SUFFIX):
            transform = image.raster.geotransform if image is not None else None
            of_file, notices = points.file_points(Path(path), wkt, transform)
            return of_file, False, notices
        if given and not path:
            return layer_points(run.source(common.GCPS), self._heights_wkt)
        image = open_image(RasterRef(path, wkt)) if path else image
        if image is None:
            raise SettingsError(messages.NO_POINTS())
        return points.image_points(image), False, []

    @cached_property
    def rpc(self) -> Rational | None:
        """The RPC of a file, or the image's own, in the image's own pixels; None where there is none."""
        path, image = self._run.path(self._rpc_name), self.image
        read = read_rpc(Path(path)) if path else own_rpc(image) if image is not None else None
        if read is None or image is None or (not path and image.dataset.GetMetadata("RPC")):
            return read
        read, notice = rpc_of_image_part(read, image.raster)
        if notice is not None:
            self._run.tell(notice)
        return read

    @property
    def orbit_height_m(self) -> float:
        """Height of the orbit as given, else by the satellite that the image's metadata name, else the default."""
        data = self.image.dataset if self.image is not None else None
        about = {**(data.GetMetadata() or {}), **(data.GetMetadata("IMAGERY") or {})} if data is not None else {}
        name = str(about.get("SATELLITEID") or about.get("NITF_ISORCE") or "").upper()
        known = (height for word, height in ORBIT_HEIGHTS_KM.items() if name.startswith(word))
        return (self._run.real(common.ORBIT_HEIGHT) or next(known, limits.DEFAULT_ORBIT_HEIGHT_KM)) * 1000


def height_datums(run: Run, *names: str) -> list[Datum]:
    """The datums of heights by these parameters, with the grid of GEOID. Raises SettingsError without it, or unused."""
    words, path = [run.text(name) for name in names], run.path(common.GEOID)
    if (heights.GEOID in words) != bool(path):
        raise SettingsError(messages.GEOID_OR_NONE())
    return [RasterRef(path) if word == heights.GEOID else word for word in words]


def layer_points(source: QgsProcessingFeatureSource, heights_wkt: str) -> tuple[Points, bool, list[Message]]:
    """The points of a layer, whether they have roles, and what was left out. ``heights_wkt``: the system that says
    what heights refer to. Raises SensorModelError."""
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
    known = points.control_points(ids, values[:, 0:2], values[:, 2:5], system_wkt(source.sourceCrs()))
    return replace(known, sigma_px=values[:, 5], check=check, heights_wkt=heights_wkt), any(roles), notices


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
