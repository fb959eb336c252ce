"""New GeoPackages of ours, written by GDAL alone: QGIS's writer leaves the reference system out where PROJ fails it."""
from __future__ import annotations

import os
from collections.abc import Iterable
from contextlib import suppress
from itertools import chain, count
from pathlib import Path

from osgeo import gdal, ogr, osr
from qgis.core import QgsFeature, QgsFields, QgsWkbTypes

from ..imagery.errors import WindowLayerError
from ..imagery.gdal_calls import gdal_silenced
from ..imagery.gdal_paths import FEATURES, open_dataset
from ..imagery.reference_systems import same_system
from . import messages
from .table_fields import is_known
from .version_differences import field

_TYPES = {"integer": ogr.OFTInteger, "real": ogr.OFTReal, "text": ogr.OFTString}


def free_path(folder: Path, name: str, ending: str = ".gpkg") -> Path:
    """A path in a folder that is not taken yet."""
    names = chain([f"{name}{ending}"], (f"{name}_{number}{ending}" for number in count(2)))
    return next(path for path in map(folder.joinpath, names) if not os.path.lexists(path))


def write_table(
    path: Path, name: str, fields: QgsFields, geometry: QgsWkbTypes.Type, wkt: str, rows: Iterable[QgsFeature] = ()
) -> str | None:
    """Write a table into a file, beside those that it has; None, or what is said of why it can't be.

    Raises WindowLayerError when the table does not have the reference system that it should have; a file that was made
    for it is removed.
    """
    is_new = not path.exists()
    with gdal_silenced():
        gdal.ErrorReset()
        try:
            _write(path, name, fields, geometry, wkt, rows)
        except RuntimeError as error:
            return gdal.GetLastErrorMsg() or str(error)
        if gdal.GetLastErrorType() >= gdal.CE_Failure:
            return gdal.GetLastErrorMsg()
    dataset = open_dataset(str(path), FEATURES) if wkt else None
    system = dataset and dataset.GetLayerByName(name).GetSpatialRef()
    if wkt and not same_system(wkt, str(system.ExportToWkt(["FORMAT=WKT2_2019"])) if system else ""):
        if is_new:
            path.unlink()
        raise WindowLayerError(messages.SYSTEM_NOT_WRITTEN(name=path.name))
    return None


def _write(
    path: Path, name: str, fields: QgsFields, geometry: QgsWkbTypes.Type, wkt: str, rows: Iterable[QgsFeature]
) -> None:
    dataset = open_dataset(str(path), FEATURES, gdal.OF_UPDATE) if path.exists() else (
        gdal.GetDriverByName("GPKG").Create(str(path), 0, 0, 0, gdal.GDT_Unknown))  # fmt: skip
    if dataset is None:  # where GDAL's exceptions are off
        raise RuntimeError
    system = osr.SpatialReference()
    with suppress(RuntimeError):  # a text that means nothing is seen when the file is read
        system.SetFromUserInput(wkt)
    gdal.ErrorReset()
    shape = int(getattr(geometry, "value", geometry))  # an enum from QGIS 3.30 on
    layer = dataset.CreateLayer(name, system if wkt else None, shape, ["OVERWRITE=YES"])
    kinds = {field("", kind).type(): of_gdal for kind, of_gdal in _TYPES.items()}
    for column in fields:
        layer.CreateField(ogr.FieldDefn(column.name(), kinds[column.type()]))
    layer.StartTransaction()
    for row in rows:
        written = ogr.Feature(layer.GetLayerDefn())
        for index, value in enumerate(row.attributes()):
            if is_known(value):
                written.SetField(index, value)
        if row.hasGeometry():
            written.SetGeometryDirectly(ogr.CreateGeometryFromWkb(bytes(row.geometry().asWkb())))
        layer.CreateFeature(written)
    layer.CommitTransaction()
    dataset.FlushCache()
