"""What a scan found as a GeoPackage and back, with its seal, as the plugin writes and reads it."""
from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from osgeo import gdal, ogr, osr

from ..plugin.imagery import messages as imagery_messages
from ..plugin.imagery.atomic_files import whole_file
from ..plugin.imagery.errors import SettingsError
from ..plugin.imagery.gdal_calls import gdal_silenced, gdal_writing
from ..plugin.imagery.gdal_paths import FEATURES, open_dataset
from ..plugin.imagery.lines import line_wkt
from ..plugin.imagery.records import GEOMETRY, Column, Row, TableRows, rows_of
from ..plugin.imagery.seam_totals import TOTALS_DOMAIN
from ..plugin.seams.measure.blocks.scan_settings import ScanSettings
from ..plugin.seams.measure.planning.window_placing import PLACED_COLUMNS
from ..plugin.seams.measure.scan.scan_request import ScanRequest
from ..plugin.seams.measure.scan.scan_result import CELL_COLUMNS, SEAM_COLUMNS, ScanResult, seam_notes
from ..plugin.seams.measure.scan.whole_scan import rectangle
from ..plugin.seams.measure.window.inspection import Block, PathLike
from . import messages
from .outputs import CELLS, GEOPACKAGE, SEAMS, WORST, check_writing

SEAMLINES = "seamlines_file"
"""Key, among what a scan tells, of the file of seams that it was given."""
_KINDS = {"integer": ogr.OFTInteger, "real": ogr.OFTReal, "text": ogr.OFTString}


@dataclass(frozen=True, eq=False)
class SeamTable:
    """The table of seams that a scan left in a file."""

    rows: TableRows
    """Rows as ``seam_rows`` makes them."""
    notes: dict[str, str]
    """What its scan tells beside them, the seal among it."""


def write_scan(path: PathLike, result: ScanResult, block: Block, settings: ScanSettings | None = None) -> None:
    """Write what a scan found as a GeoPackage: the tables ``seams``, ``source_cells`` and ``worst_windows``.

    The file, ``.gpkg``, is there whole or not at all, over no input and nothing but another scan. ``settings``: those
    of the scan. Raises SettingsError where it can't be.
    """
    settings, place, wkt = settings or ScanSettings(), Path(os.fspath(path)), block.mosaic.wkt
    names = ScanRequest(block.mosaic, block.sources, settings).source_names
    outlines = (ogr.CreateGeometryFromWkt(line_wkt(feature.piece.vertices)) for feature in result.features)
    failure = imagery_messages.FILE_NOT_WRITTEN(path=place, error="GeoPackage")
    read = filter(None, (*block.paths, *block.files, result.told.get(SEAMLINES, "")))
    outputs = {"output": (os.fspath(path), GEOPACKAGE)}
    check_writing(outputs, read)
    with whole_file(place) as unfinished, gdal_writing(failure):
        made = gdal.GetDriverByName("GPKG").Create(str(unfinished), 0, 0, 0, gdal.GDT_Unknown)
        _write(made, WORST, ogr.wkbPolygon, wkt, PLACED_COLUMNS, result.worst, (
            rectangle(*block.mosaic.grid.window_extent(worst.window)) for worst in result.worst
        ))  # fmt: skip
        seams = _write(made, SEAMS, ogr.wkbLineString, wkt, SEAM_COLUMNS, result.features, outlines, settings.levels)
        cells = [names[polygon.source] for polygon in result.polygons]
        _write(made, CELLS, ogr.wkbMultiPolygon, wkt, CELL_COLUMNS, cells, (
            ogr.CreateGeometryFromWkb(polygon.wkb) for polygon in result.polygons
        ))  # fmt: skip
        seams.SetMetadata(seam_notes(result, settings, wkt), TOTALS_DOMAIN)
        del seams, made


def _write(
    made: gdal.Dataset, name: str, kind: int, wkt: str, columns: Sequence[Column[Any]], results: Sequence[object],
    outlines: Iterable[ogr.Geometry], levels: int = 0,
) -> ogr.Layer:
    layer = made.CreateLayer(name, osr.SpatialReference(wkt), kind)
    for column in columns:
        for field in column.names(levels):
            layer.CreateField(ogr.FieldDefn(field, _KINDS[column.kind]))
    for row, outline in zip(rows_of(columns, results, levels), outlines):
        feature = ogr.Feature(layer.GetLayerDefn())
        for field, value in row.items():
            if value is not None:
                feature[field] = value
        feature.SetGeometry(outline)
        layer.CreateFeature(feature)
    return layer


def read_seams(path: PathLike) -> SeamTable:
    """The table of seams in a file that a scan wrote, here or in QGIS; ``file|layername=name`` where it is called
    otherwise. Raises SettingsError where there is none."""
    file, _, name = os.fspath(path).partition("|layername=")
    with gdal_silenced():
        opened = open_dataset(file, FEATURES)
        layer = opened and (opened.GetLayerByName(name or SEAMS) or (None if name else opened.GetLayer(0)))
        if layer is None or layer.GetLayerDefn().GetFieldIndex("kept_1") < 0:
            raise SettingsError(messages.NO_LAYER_OF_SEAMS(path=path))
        system, rows = layer.GetSpatialRef(), []
        for feature in layer:
            row: Row = {**feature.items()}
            points = None if (outline := feature.GetGeometryRef()) is None else outline.GetPoints(2)
            rows.append({**row, GEOMETRY: line_wkt(np.array(points)) if points else ""})  # to the last digit
        wkt = "" if system is None else system.ExportToWkt()
        return SeamTable(TableRows(rows, wkt), dict(layer.GetMetadata(TOTALS_DOMAIN) or {}))
