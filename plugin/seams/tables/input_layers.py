"""Layers that are given: tile indexes of orthoimages, cells by source, seams as producers deliver them."""
from __future__ import annotations

import os
from collections.abc import Iterable, Sequence

from qgis.core import QgsCoordinateTransform, QgsFeature, QgsGeometry
from qgis.PyQt.QtCore import QDate, QDateTime, Qt

from ...imagery.errors import Message, SettingsError, WindowError
from ...imagery.gdal_paths import path_from
from ...imagery.rasters import RasterRef
from ...toolkit.layers import extent, line_wkb, transformed
from ...toolkit.table_fields import is_known, text
from ..measure import messages
from ..measure.seam_cells import Cell
from ..measure.seamlines.seam_features import SeamFeature, lost_features
from ..measure.source_images import Source

LOCATION_FIELD = "location"  # as gdaltindex writes it


def indexed_sources(
    rows: Iterable[QgsFeature], names: Sequence[str], index_path: str, transform: QgsCoordinateTransform
) -> list[Source]:
    """The orthoimages of an index layer as gdaltindex writes it, with their footprints.

    Relative locations start at the folder of the index file. No raster is opened.

    Raises SettingsError when the layer has no field ``location``.
    """
    if LOCATION_FIELD not in names:
        raise SettingsError(messages.INDEX_WITHOUT_LOCATION(field=LOCATION_FIELD))
    folder = os.path.dirname(os.path.abspath(index_path)) if index_path else ""
    sources = []
    for feature in rows:
        name, geometry = text(feature[LOCATION_FIELD]), QgsGeometry(feature.geometry())
        if name and not geometry.isEmpty():
            sources.append(Source(RasterRef(path_from(folder, name)), extent(transformed(geometry, transform))))
    return sources


CELL_FIELD = "source"


def seam_cells(rows: Iterable[QgsFeature], transform: QgsCoordinateTransform) -> list[Cell]:
    """Polygons that say in their field ``source`` which orthoimage the mosaic was cut from."""
    cells = []
    for feature in rows:
        name, geometry = text(feature[CELL_FIELD]), QgsGeometry(feature.geometry())
        if name and not geometry.isEmpty():
            outline = transformed(geometry, transform)
            cells.append(Cell(name, bytes(outline.asWkb()), extent(outline)))
    return cells


def seam_features(
    rows: Iterable[QgsFeature], names: Sequence[str], transform: QgsCoordinateTransform
) -> tuple[list[SeamFeature], Message | None]:
    """Attributes and outlines of a layer in the mosaic's system, and how many can't be transformed."""
    features: list[SeamFeature] = []
    lost = 0
    for row in rows:
        try:
            wkb = line_wkb(row, transform)
        except WindowError:
            lost += 1
            continue
        features.append(({name: plain_text(value) for name, value in zip(names, row.attributes())}, wkb))
    return features, lost_features(lost, features)


def plain_text(value: object) -> str:
    """What an attribute says, dates as 2019-07-04."""
    if isinstance(value, (QDate, QDateTime)):
        return str(value.toString(Qt.DateFormat.ISODate))
    if isinstance(value, (list, tuple)):  # elements that a GML file repeats
        return ", ".join(plain_text(part) for part in value)
    return text(value) if is_known(value) else ""
