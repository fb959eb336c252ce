"""Tile indexes of orthoimages, as gdaltindex writes them."""
from __future__ import annotations

import os
from collections.abc import Iterable, Sequence

from qgis.core import QgsCoordinateTransform, QgsFeature, QgsGeometry

from ...imagery.errors import SettingsError
from ...imagery.rasters import RasterRef
from ...toolkit.layers import _transformed, extent
from ...toolkit.table_fields import text
from ..measure import messages
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
        path, geometry = text(feature[LOCATION_FIELD]), QgsGeometry(feature.geometry())
        if not path or geometry.isEmpty():
            continue
        if folder and not (os.path.isabs(path) or path.startswith("/vsi") or ":" in path):
            path = os.path.normpath(os.path.join(folder, path))
        sources.append(Source(RasterRef(path), extent(_transformed(geometry, transform))))
    return sources
