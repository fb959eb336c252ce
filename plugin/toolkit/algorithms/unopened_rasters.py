"""QGIS's own check of the values, without its opening of rasters."""
from __future__ import annotations

from collections.abc import Collection
from typing import Any

from qgis.core import QgsProcessingAlgorithm, QgsProcessingParameterRasterLayer, QgsRasterLayer


def without_rasters(
    algorithm: QgsProcessingAlgorithm, values: dict[str, Any], lists: Collection[str] = ()
) -> dict[str, Any]:
    """The values with nothing to open in place of each raster, and of each of the ``lists`` of layers.

    QGIS would load them all, write statistics beside them (into them, where they are VRTs), and refuse one that it
    can't open without a reason.
    """
    rasters = {
        one.name() for one in algorithm.parameterDefinitions() if isinstance(one, QgsProcessingParameterRasterLayer)
    }
    rasters = {name for name in rasters if isinstance(values.get(name), str) and values[name]}
    return {**values, **{name: [] for name in lists if name in values}, **{name: QgsRasterLayer() for name in rasters}}
