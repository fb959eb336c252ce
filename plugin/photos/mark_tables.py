"""Fiducial marks as QGIS's point layers: positions in, measured marks out."""
from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path

from osgeo import gdal
from qgis.core import QgsDataProvider, QgsFeature, QgsFields, QgsGeometry, QgsPointXY, QgsVectorLayer, QgsWkbTypes

from ..imagery.errors import PhotoError
from ..imagery.gdal_paths import is_endless, is_layer_file
from ..toolkit.table_fields import attributes, feature, is_known, is_true, number, table_fields, text
from ..toolkit.translation import sentence
from .measure import messages
from .measure.mark_comparison import ComparedMark
from .measure.orientation import GivenPosition, MarkResult, read_measures
from .measure.photo import Photo

MARK, PHOTO, MEASURE = "mark", "photo", "measure"
MEASURES = "MeasuresIm-"  # how MicMac names its files
VECTOR_ENDINGS = (".gpkg", ".shp", ".geojson", ".csv", ".fgb", ".sqlite", ".gml", ".kml", ".tab", ".mif")


def mark_fields() -> QgsFields:
    """OUTPUT of ``interiororientation``: one point per mark of the calibration."""
    return table_fields(
        (MARK, "text"), ("column", "real"), ("row", "real"), ("x_mm", "real"), ("y_mm", "real"),
        ("residual_x", "real"), ("residual_y", "real"), ("correlation", "real"), ("status", "text"), ("reason", "text"),
        (PHOTO, "text"),
    )


def mark_feature(mark: MarkResult, photo: Photo) -> QgsFeature:
    """The row of a mark; one that failed has no place."""
    column, row = mark.place or (None, None)
    residual_x, residual_y = mark.residual or (None, None)
    geometry = None
    if mark.place is not None:
        place = gdal.ApplyGeoTransform(photo.raster.placement, *mark.place)
        geometry = QgsGeometry.fromPointXY(QgsPointXY(*place))
    reason = sentence(mark.reason) if mark.reason is not None else None
    values = [mark.name, column, row, *mark.calibrated, residual_x, residual_y, mark.correlation, mark.status]
    return feature(mark_fields(), [*values, reason, photo.ref.name], geometry)


def given_positions(
    rows: Iterable[QgsFeature], names: Sequence[str], photo: Photo, measure: bool
) -> dict[str, GivenPosition]:
    """The user's positions of marks; points without a name or a place are left out. Whether a position is measured says
    its field ``measure`` where there is one, else ``measure``. Raises PhotoError for a layer without the field ``mark``
    and for a mark that is there twice."""
    if MARK not in names:
        raise PhotoError(messages.POSITIONS_WITHOUT_MARK())
    made: dict[str, GivenPosition] = {}
    to_photo = gdal.InvGeoTransform(photo.raster.placement)
    for row in attributes(rows, names):
        name, asked, point = text(row[MARK]), row[MEASURE], _point(row.feature)
        if not name or point is None:
            continue
        if name in made:
            raise PhotoError(messages.POSITION_TWICE(mark=name))
        measured = is_true(asked) if is_known(asked) else measure
        column, row_of_point = gdal.ApplyGeoTransform(to_photo, point.x(), point.y())
        made[name] = GivenPosition((column, row_of_point), measured)
    if not made:
        raise PhotoError(messages.POSITIONS_EMPTY())
    return made


def compared_marks(
    rows: Iterable[QgsFeature], names: Sequence[str], layer: str, default_photo: str = ""
) -> list[ComparedMark]:
    """The marks of a layer to be compared: by ``column`` and ``row`` where it has them, else by the points themselves.
    Raises PhotoError for a layer without the field ``mark``."""
    if MARK not in names:
        raise PhotoError(messages.COMPARED_WITHOUT_MARK(layer=layer))
    photo = PHOTO if PHOTO in names else "layer"
    made = []
    for row in attributes(rows, names):
        name, column, line = text(row[MARK]), number(row["column"]), number(row["row"])
        point = None if {"column", "row"} <= set(names) else _point(row.feature)
        if point is not None:
            column, line = point.x(), -point.y()
        if not name or column is None or line is None:
            continue
        x_mm, y_mm = number(row["x_mm"]), number(row["y_mm"])
        calibrated = None if x_mm is None or y_mm is None else (x_mm, y_mm)
        made.append(ComparedMark(text(row[photo]) or default_photo, name, (column, line), calibrated))
    return made


def folder_marks(folder: Path) -> list[ComparedMark]:
    """The marks of all files of a folder: layers with a field ``mark``, and MicMac's MeasuresIm-*.xml. A layer that
    does not say the photo is of the photo that its file is called like; what is no file is left alone. Raises
    PhotoError for a folder that is not there or holds no marks."""
    made: list[ComparedMark] = []
    for path in sorted(folder.iterdir()) if os.path.isdir(folder) else ():
        if is_endless(str(path)):
            continue
        if path.suffix.lower() == ".xml" and path.name.startswith(MEASURES):
            made += [ComparedMark(photo, mark, place) for photo, mark, place in read_measures(path)]
        elif path.suffix.lower() in VECTOR_ENDINGS and is_layer_file(path):
            made += _file_marks(path)
    if not made:
        raise PhotoError(messages.COMPARED_NO_MARKS(path=folder))
    return made


def _file_marks(path: Path) -> list[ComparedMark]:
    """Marks of all layers of a file that have a field ``mark``."""
    made = []
    opened = QgsVectorLayer(str(path), path.stem, "ogr")
    parts = [part.split(QgsDataProvider.sublayerSeparator()) for part in opened.dataProvider().subLayers()]
    for name in [part[1] for part in parts] if opened.isValid() else []:
        layer = QgsVectorLayer(f"{path}|layername={name}", name, "ogr")
        if layer.isValid() and MARK in layer.fields().names():
            default = path.stem if len(parts) == 1 else name
            made += compared_marks(layer.getFeatures(), layer.fields().names(), name, default)
    return made


def _point(row: QgsFeature) -> QgsPointXY | None:
    geometry = row.geometry()
    if geometry.isNull() or geometry.isEmpty() or geometry.type() != QgsWkbTypes.GeometryType.PointGeometry:
        return None
    return geometry.centroid().asPoint()
