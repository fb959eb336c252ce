"""Which window lies under a point of the map."""
from __future__ import annotations

from collections.abc import Iterable

from qgis.core import QgsCoordinateReferenceSystem, QgsPointXY, QgsVectorLayer

from ....toolkit.layers import transformed_point
from ...measure.window_records import WindowRecord


def window_under(
    windows: Iterable[WindowRecord], layer: QgsVectorLayer, point: QgsPointXY, crs: QgsCoordinateReferenceSystem
) -> WindowRecord | None:
    """The window of a layer under a point; of several the one whose middle is nearest. None where there is none."""
    here = transformed_point(point, crs, layer.crs())
    if here is None:
        return None
    found = [row for row in windows if _holds(row, here.x(), here.y())]
    return min(found, key=lambda row: _distance(row, here.x(), here.y()), default=None)


def _holds(row: WindowRecord, x: float, y: float) -> bool:
    if row.extent is None:
        return False
    xmin, ymin, xmax, ymax = row.extent
    return xmin <= x <= xmax and ymin <= y <= ymax


def _distance(row: WindowRecord, x: float, y: float) -> float:
    assert row.extent is not None
    xmin, ymin, xmax, ymax = row.extent
    return ((xmin + xmax) / 2 - x) ** 2 + ((ymin + ymax) / 2 - y) ** 2
