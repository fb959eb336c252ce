"""Layers of seam cells: which source each part of a mosaic was cut from."""
from __future__ import annotations

from collections.abc import Iterable

from qgis.core import QgsCoordinateTransform, QgsFeature, QgsGeometry

from ...toolkit.layers import _transformed, extent
from ...toolkit.table_fields import text
from ..measure.seam_cells import Cell

CELL_FIELD = "source"


def seam_cells(rows: Iterable[QgsFeature], transform: QgsCoordinateTransform) -> list[Cell]:
    """Polygons that say in their field ``source`` which orthoimage the mosaic was cut from."""
    cells = []
    for feature in rows:
        name, geometry = text(feature[CELL_FIELD]), QgsGeometry(feature.geometry())
        if name and not geometry.isEmpty():
            outline = _transformed(geometry, transform)
            cells.append(Cell(name, bytes(outline.asWkb()), extent(outline)))
    return cells
