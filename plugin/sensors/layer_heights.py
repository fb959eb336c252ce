"""What the heights of a point layer refer to."""
from __future__ import annotations

from contextlib import suppress

from osgeo import gdal, osr
from qgis.core import QgsProviderRegistry, QgsVectorLayer

from ..imagery.gdal_calls import gdal_silenced
from ..toolkit.layers import layer_path


def heights_wkt(layer: QgsVectorLayer) -> str:
    """The compound or three-dimensional system of a layer; empty where it says nothing of heights.

    QGIS keeps a system's code and forgets its vertical part, so the code is looked up anew, and the file is asked.
    """
    system = osr.SpatialReference()
    with gdal_silenced(), suppress(RuntimeError):
        system.SetFromUserInput(layer.crs().authid())
    if _has_heights(system):
        return str(layer.crs().authid())
    path = layer_path(layer)
    if not path:
        return ""
    name = QgsProviderRegistry.instance().decodeUri("ogr", layer.source()).get("layerName")
    found = None
    with gdal_silenced(), suppress(RuntimeError):
        file = gdal.OpenEx(path, gdal.OF_VECTOR)
        part = None if file is None else file.GetLayerByName(name) if name else file.GetLayer(0)
        found = part.GetSpatialRef() if part is not None else None
    return str(found.ExportToWkt(["FORMAT=WKT2_2018"])) if found is not None and _has_heights(found) else ""


def _has_heights(system: osr.SpatialReference) -> bool:
    return bool(system.IsCompound()) or system.GetAxesCount() == 3
