"""QGIS's own check of the values, without its opening of rasters."""
from __future__ import annotations

from collections.abc import Collection
from typing import Any

from qgis.core import QgsProcessingAlgorithm, QgsProcessingParameterRasterLayer, QgsRasterLayer

from .parameters import takes_rasters


def without_rasters(
    algorithm: QgsProcessingAlgorithm, values: dict[str, Any], lists: Collection[str] = ()
) -> dict[str, Any]:
    """The values with nothing to open in place of each raster, each list of rasters, and each of the other ``lists``.

    QGIS would load them all, write statistics beside them (into them, where they are VRTs), and refuse one that it
    can't open without a reason.
    """
    emptied = dict(values)
    for one in algorithm.parameterDefinitions():
        name, value = one.name(), values.get(one.name())
        if isinstance(one, QgsProcessingParameterRasterLayer):
            if isinstance(value, str) and value:
                emptied[name] = QgsRasterLayer()
        elif name in values and (name in lists or takes_rasters(one)):
            emptied[name] = []
    return emptied
