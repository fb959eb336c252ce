"""What a scan found as a GeoPackage and back, with its seal, as the plugin writes and reads it."""
from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from osgeo import gdal, ogr, osr

from ..plugin.imagery import messages as imagery_messages
from ..plugin.imagery.atomic_files import whole_file
from ..plugin.imagery.errors import SettingsError
from ..plugin.imagery.file_identity import known_states, states_in
from ..plugin.imagery.gdal_calls import gdal_silenced, gdal_writing
from ..plugin.imagery.gdal_paths import FEATURES, open_dataset
from ..plugin.imagery.limits import PATH_TYPES, check_type
from ..plugin.imagery.lines import line_wkt
from ..plugin.imagery.records import GEOMETRY, Column, Row, TableRows, rows_of
from ..plugin.imagery.seam_totals import MOSAIC_FILES, TOTALS_DOMAIN
from ..plugin.seams.measure.planning.window_placing import PLACED_COLUMNS
from ..plugin.seams.measure.scan.scan_result import CELL_COLUMNS, SEAM_COLUMNS, ScanResult, seam_notes, seam_rows
from ..plugin.seams.measure.seamlines.seam_tracing import rectangle
from ..plugin.seams.measure.window.inspection import Block, PathLike
from . import messages
from .outputs import CELLS, GEOPACKAGE, SEAMS, WORST, check_writing

SEAMLINES = "seamlines_file"  # key, among what a scan tells, of the file of seams that it was given
_KINDS = {"integer": ogr.OFTInteger, "real": ogr.OFTReal, "text": ogr.OFTString}


def write_scan(path: PathLike, result: ScanResult, block: Block) -> None:
    """Write what a scan found as a GeoPackage: the tables ``seams``, ``source_cells`` and ``worst_windows``.

    The file, ``.gpkg``, is there whole or not at all, over no input and nothing but another scan. ``block``: that was
    scanned. Raises SettingsError where it can't be, or another mosaic was scanned.
    """
    check_type("path", path, *PATH_TYPES)
    check_type("result", result, ScanResult)
    check_type("block", block, Block)
    read = filter(None, (*block.paths, result.told.get(SEAMLINES, "")))
    check_writing({"output": (os.fspath(path), GEOPACKAGE)}, read)
    check_scanned(result.told, block)
    failure = imagery_messages.RASTER_NOT_WRITTEN(path=path)
    with whole_file(Path(path)) as unfinished, gdal_writing(failure):
        _write_tables(str(unfinished), result, block)


def check_scanned(notes: Mapping[str, str], block: Block) -> None:
    """Raise SettingsError for notes of a scan of another mosaic, which is known by its files' paths or contents."""
    ref = (block.sheet or block.mosaic).ref
    files, scanned = known_states(ref.paths, ask=False), dict(states_in(notes.get(MOSAIC_FILES, "")))
    held, known = ({state.content for state in states.values() if state.digest} for states in (files, scanned))
    if files.keys() != scanned.keys() and (not held or held != known):
        raise SettingsError(messages.SCAN_OF_ANOTHER(name=ref.name))


def _write_tables(path: str, result: ScanResult, block: Block) -> None:
    made = gdal.GetDriverByName("GPKG").Create(path, 0, 0, 0, gdal.GDT_Unknown)
    wkt, grid = block.mosaic.wkt, block.mosaic.grid
    lines = (ogr.CreateGeometryFromWkt(line_wkt(feature.piece.vertices)) for feature in result.features)
    windows = (rectangle(*grid.window_extent(worst.window)) for worst in result.worst)
    polygons = (ogr.CreateGeometryFromWkb(polygon.wkb) for polygon in result.polygons)
    cells = [result.sources[polygon.source] for polygon in result.polygons]
    _write(made, WORST, ogr.wkbPolygon, wkt, PLACED_COLUMNS, result.worst, windows)
    seams = _write(
        made, SEAMS, ogr.wkbLineString, wkt, SEAM_COLUMNS, result.features, lines, int(result.told["levels"])
    )
    _write(made, CELLS, ogr.wkbMultiPolygon, wkt, CELL_COLUMNS, cells, polygons)
    seams.SetMetadata(seam_notes(result), TOTALS_DOMAIN)


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


def read_seams(given: ScanResult | PathLike) -> tuple[TableRows, Mapping[str, str]]:
    """The table of seams of a scan, or of a file that one wrote, here or in QGIS, with what it tells beside them, the
    seal among it; ``file|layername=name`` where it is called otherwise. Raises SettingsError where there is none."""
    if isinstance(given, ScanResult):
        return seam_rows(given), given.told
    file, _, name = os.fspath(given).partition("|layername=")
    with gdal_silenced():
        opened = open_dataset(file, FEATURES)
        layer = opened and (opened.GetLayerByName(name or SEAMS) or (None if name else opened.GetLayer(0)))
        if layer is None or layer.GetLayerDefn().GetFieldIndex("kept_1") < 0:
            raise SettingsError(messages.NO_LAYER_OF_SEAMS(path=given))
        system, rows = layer.GetSpatialRef(), []
        for feature in layer:
            row: Row = {**feature.items()}
            points = None if (outline := feature.GetGeometryRef()) is None else outline.GetPoints(2)
            rows.append({**row, GEOMETRY: line_wkt(np.array(points)) if points else ""})  # to the last digit
        wkt = "" if system is None else system.ExportToWkt()
        return TableRows(rows, wkt), dict(layer.GetMetadata(TOTALS_DOMAIN) or {})
