"""What users drew, laid on an image: seamlines with the features they come from, and grey areas."""
from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsFeatureRequest,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingFeatureSource,
    QgsWkbTypes,
)

from ..toolkit import layers
from ..toolkit.algorithms.run import Run

if TYPE_CHECKING:
    from ..imagery.lines import Seam
    from ..imagery.rasters import Raster
    from .measure.grey_areas import GreyArea
    from .measure.seam_steps import SeamStep

_REACH_PX = 3  # between a seam and the features it comes from: it was straightened by 1.5 px


def has_map(image: Raster) -> bool:
    """Whether layers can be laid on an image."""
    return image.is_north_up and image.has_place and bool(image.wkt)


def seams_on(seamlines: QgsProcessingFeatureSource, image: Raster, run: Run) -> list[Seam]:
    """The seams in the image's reference system; none for an image without a place on the map."""
    from ..imagery.lines import find_seams

    if not has_map(image):
        return []
    transform = run.transform(seamlines, _crs(image))
    lines = (layers.line_wkb(feature, transform) for feature in layers.features(seamlines))
    return find_seams(lines, image.grid.pixel_width)


def grey_areas_on(areas: QgsProcessingFeatureSource, image: Raster, run: Run) -> list[GreyArea]:
    """The polygons in the image's reference system; features without one are nothing grey."""
    from .measure.grey_areas import GreyArea

    if not has_map(image):
        return []
    transform = run.transform(areas, _crs(image))
    found = []
    for feature in layers.features(areas):
        geometry = feature.geometry()
        if geometry.isEmpty() or geometry.type() != QgsWkbTypes.GeometryType.PolygonGeometry:
            continue
        wkb = layers.line_wkb(feature, transform)
        if wkb is not None:
            found.append(GreyArea(feature.id(), wkb))
    return found


def with_features(
    steps: Iterable[SeamStep], seamlines: QgsProcessingFeatureSource, image: Raster, run: Run
) -> tuple[SeamStep, ...]:
    """Each seam with the numbers of the features that run along it where its tone steps."""
    back = QgsCoordinateTransform(_crs(image), seamlines.sourceCrs(), run.context.transformContext())
    reach = _REACH_PX * max(image.grid.pixel_width, image.grid.pixel_height)
    name = seamlines.sourceName()
    return tuple(
        replace(step, features=_features_at(seamlines, step.places[0], reach, back), layer=name) for step in steps
    )


def _features_at(
    source: QgsProcessingFeatureSource, place: tuple[float, float], reach: float, back: QgsCoordinateTransform
) -> tuple[str, ...]:
    around = QgsGeometry.fromPointXY(QgsPointXY(*place)).buffer(reach, 8)
    try:
        around.transform(back)
    except QgsCsException:
        return ()
    request = QgsFeatureRequest().setFilterRect(around.boundingBox())
    found = []
    for feature in source.getFeatures(request, QgsProcessingFeatureSource.Flag.FlagSkipGeometryValidityChecks):
        geometry = feature.geometry()
        if geometry.type() == QgsWkbTypes.GeometryType.PolygonGeometry:
            geometry = QgsGeometry(geometry.constGet().boundary())
        if geometry.intersects(around):
            found.append(str(feature.id()))
    return tuple(sorted(found, key=int))


def _crs(image: Raster) -> QgsCoordinateReferenceSystem:
    return QgsCoordinateReferenceSystem.fromWkt(image.wkt)
