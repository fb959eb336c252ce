"""Rasters and layers of the examples, as files."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Union

import numpy as np
from osgeo import gdal, ogr, osr

Value = Union[int, float, str, None]
FIELD_TYPES = {int: ogr.OFTInteger, float: ogr.OFTReal, str: ogr.OFTString}


def system(epsg: int) -> osr.SpatialReference:
    """A reference system with the easting or longitude first."""
    made = osr.SpatialReference()
    made.ImportFromEPSG(epsg)
    made.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return made


def write_raster(path: Path, pixels: np.ndarray, epsg: int | None = None,
                 place: Sequence[float] | None = None) -> None:
    """Write (bands, rows, columns) as a compressed GeoTIFF; ``place`` is left, top and the pixel's side."""
    bands, rows, columns = pixels.shape
    kind = gdal.GDT_Byte if pixels.dtype == np.uint8 else gdal.GDT_Float32
    options = ["COMPRESS=DEFLATE", "TILED=YES"]
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), columns, rows, bands, kind, options)
    if epsg is not None and place is not None:
        left, top, side = place
        dataset.SetProjection(system(epsg).ExportToWkt())
        dataset.SetGeoTransform((left, side, 0.0, top, 0.0, -side))
    dataset.WriteArray(pixels)
    dataset.FlushCache()


def write_layer(path: Path, epsg: int, rows: Iterable[tuple[str, Mapping[str, Value]]]) -> None:
    """Write features, a geometry (WKT) and its fields each, as the only layer of a GeoPackage."""
    path.unlink(missing_ok=True)
    rows = list(rows)
    first, fields = rows[0]
    package = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
    kind = ogr.CreateGeometryFromWkt(first).GetGeometryType()
    layer = package.CreateLayer(path.stem, system(epsg), kind)
    for name, value in fields.items():
        layer.CreateField(ogr.FieldDefn(name, FIELD_TYPES[type(value)]))
    for wkt, values in rows:
        feature = ogr.Feature(layer.GetLayerDefn())
        feature.SetGeometry(ogr.CreateGeometryFromWkt(wkt))
        for name, one in values.items():
            if one is not None:
                feature.SetField(name, one)
        layer.CreateFeature(feature)


def box(left: float, bottom: float, right: float, top: float) -> str:
    """A rectangle as WKT."""
    corners = [(left, bottom), (right, bottom), (right, top), (left, top), (left, bottom)]
    return f"POLYGON (({', '.join(f'{x} {y}' for x, y in corners)}))"


def texture(shape: tuple[int, int], falloff: float, random: np.random.Generator) -> np.ndarray:
    """A texture of mean 0 and deviation 1 whose power falls with frequency as f^-falloff; 2 looks like ground."""
    rows, columns = shape
    frequency = np.hypot(np.fft.fftfreq(rows)[:, np.newaxis], np.fft.rfftfreq(columns))
    frequency[0, 0] = np.inf
    made = np.fft.irfft2(np.fft.rfft2(random.standard_normal(shape)) * frequency ** (-falloff / 2), shape)
    return np.asarray((made - made.mean()) / made.std())
