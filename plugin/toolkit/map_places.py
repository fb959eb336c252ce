"""Places of a map in another reference system; None where they are not to be had there."""
from __future__ import annotations

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsPointXY,
    QgsProject,
    QgsRectangle,
)


def transformed_point(
    point: QgsPointXY, crs: QgsCoordinateReferenceSystem, target: QgsCoordinateReferenceSystem
) -> QgsPointXY | None:
    """By the project's choice of transformations."""
    try:
        return QgsCoordinateTransform(crs, target, QgsProject.instance()).transform(point)
    except QgsCsException:
        return None


def transformed_box(
    box: QgsRectangle, crs: QgsCoordinateReferenceSystem, target: QgsCoordinateReferenceSystem
) -> QgsRectangle | None:
    """The rectangle around a transformed one."""
    try:
        return QgsCoordinateTransform(crs, target, QgsProject.instance()).transformBoundingBox(box)
    except QgsCsException:
        return None
