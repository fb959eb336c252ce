"""Files of seamlines and source cells, read by GDAL; QGIS reads its layers itself."""
from __future__ import annotations

import os

from osgeo import gdal, ogr

from .....imagery import messages as imagery_messages
from .....imagery.errors import Message, RasterError, SeamlineError
from .....imagery.gdal_calls import check_raster_path, gdal_silenced
from .....imagery.rasters import Raster
from .....imagery.reference_systems import geometry_on
from ...seam_cells import Cell
from .. import messages
from .seam_features import SeamFeature, gathered
from .seam_fields import seam_fields

_LAYER = "|layername="  # as QGIS writes which layer of a file is meant
_DATES = (ogr.OFTDate, ogr.OFTDateTime)


def read_seam_features(path: str, wkt: str) -> tuple[list[SeamFeature], Message | None]:
    """Attributes and outlines of a vector file in a reference system, and how many can't be transformed.

    ``path`` is ``file`` or ``file|layername=name``; without a name the first layer counts. Raises SeamlineError when
    there is no such layer, RasterError for a path that must not be opened.
    """
    file, _, name = path.partition(_LAYER)
    with gdal_silenced():
        dataset = _opened(file)
        layer = None if dataset is None else (dataset.GetLayerByName(name) if name else dataset.GetLayer(0))
        if layer is None:
            if os.path.exists(file) or file.startswith("/vsi"):
                raise SeamlineError(messages.SEAM_FILE_NOT_READ(path=path))
            raise SeamlineError(imagery_messages.NOT_FOUND(path=file))
        system = layer.GetSpatialRef()
        own_wkt = wkt if system is None else str(system.ExportToWkt())
        features: list[SeamFeature] = []
        lost = 0
        for feature in layer:
            geometry = feature.GetGeometryRef()
            try:
                placed = None if geometry is None else geometry_on(geometry, own_wkt, wkt)
            except RasterError:
                lost += 1
                continue
            features.append((_attributes(feature), None if placed is None else bytes(placed.ExportToWkb(ogr.wkbNDR))))
    return features, messages.SEAM_FEATURES_NOT_TRANSFORMED(count=lost) if lost else None


def read_cells(path: str, mosaic: Raster) -> tuple[Cell, ...]:
    """The polygons of a vector file that name their source. Raises SeamlineError when none lies on the mosaic."""
    features, _ = read_seam_features(path, mosaic.wkt)
    return tuple(gathered(features, seam_fields([attributes for attributes, _ in features]), mosaic.grid).cells)


def _opened(file: str) -> gdal.Dataset | None:
    try:
        check_raster_path(file, os.path.basename(file))
        return gdal.OpenEx(file, gdal.OF_VECTOR | gdal.OF_READONLY)
    except RuntimeError:  # where GDAL's exceptions are on
        return None


def _attributes(feature: ogr.Feature) -> dict[str, object]:
    definitions = [feature.GetFieldDefnRef(number) for number in range(feature.GetFieldCount())]
    return {one.GetName(): _value(feature, number, one.GetType()) for number, one in enumerate(definitions)}


def _value(feature: ogr.Feature, number: int, kind: int) -> object:
    """Dates as 2019-07-04, lists of elements that a file repeats parted by commas."""
    value = feature.GetField(number)
    if kind in _DATES and isinstance(value, str):
        return value.replace("/", "-")
    return ", ".join(map(str, value)) if isinstance(value, (list, tuple)) else value
