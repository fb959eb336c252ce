"""A layer of inspected and judged windows -> what was seen in each."""
from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingFeatureSource, QgsWkbTypes

from ..imagery.errors import SettingsError, WindowError
from ..toolkit import layers
from ..toolkit.algorithms.run import Run
from ..toolkit.attribute_values import attributes, number, text
from .measure import messages
from .measure.delivery import SeenWindow


def judged_windows(
    source: QgsProcessingFeatureSource, crs: QgsCoordinateReferenceSystem, run: Run
) -> tuple[SeenWindow, ...]:
    """Those that have an outline, in a reference system; what is wrong with others is told.

    Raises SettingsError for a layer without polygons.
    """
    if QgsWkbTypes.geometryType(source.wkbType()) != QgsWkbTypes.GeometryType.PolygonGeometry:
        raise SettingsError(messages.WINDOWS_NO_POLYGONS(name=source.sourceName()))
    transform = run.transform(source, crs) if crs.isValid() else None
    found = []
    for row in attributes(layers.features(source), source.fields().names()):
        try:
            extent = layers.outline_extent(row.feature, transform)
        except WindowError as error:
            run.tell(error.message.as_warning())
            continue
        if extent is not None:
            found.append(
                SeenWindow(
                    text(row["window_id"]) or text(row.feature.id()), extent, text(row["cause"]), text(row["causes"]),
                    text(row["verdict"]), number(row["kept_1"]), text(row["observer"]), text(row["observer_2"]),
                    text(row["remark"]), text(row["remark_2"]),
                )
            )
    if not any(one.cause or one.verdict or one.observer or one.observer_2 or one.remark for one in found):
        run.tell(messages.WINDOWS_SAY_NOTHING(name=source.sourceName()))
    return tuple(found)
