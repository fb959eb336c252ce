"""The windows file: a GeoPackage with the layer ``windows`` and, beside it, what was measured in each of them.

The layer is QGIS's and written through its data provider (``window_layer``); the tables beside it are written here, by
GDAL alone, so that one copy of SQLite has the file. ``curves``, ``pairs`` and ``profiles`` are as ``inspectwindows``
writes them. ``results`` has a row a window: all that was measured, as the desk shows it again, and a fingerprint of
what that is of.
"""
from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, Callable, NamedTuple

from osgeo import gdal, ogr
from qgis.core import QgsFeature, QgsField, QgsFields, QgsWkbTypes

from ...imagery.errors import WindowLayerError
from ...imagery.gdal_calls import gdal_silenced
from ...imagery.gdal_paths import FEATURES, holds_only_tables, open_dataset
from ...imagery.records import Column, Row, record_of
from ...toolkit import messages as toolkit_messages
from ...toolkit.geopackages import free_path, write_table
from ...toolkit.table_fields import column_fields
from ..measure import messages
from ..measure.window.window_result import WindowResult
from ..measure.window.window_tables import (
    CURVE_COLUMNS,
    PAIR_COLUMNS,
    PROFILE_COLUMNS,
    WINDOW_FIELDS,
    curve_rows,
    pair_rows,
    profile_rows,
    result_of,
)
from ..measure.window_records import WindowRecord

TABLE = "windows"
_RESULTS = "results"
_MEASURED: dict[str, tuple[Sequence[Column[Any]], Callable[[Iterable[WindowResult]], list[Row]]]] = {
    "curves": (CURVE_COLUMNS, curve_rows), "pairs": (PAIR_COLUMNS, pair_rows),
    "profiles": (PROFILE_COLUMNS, profile_rows),
}  # fmt: skip
_NOTES = "seam_inspector"  # domain of the layer's metadata
_PATH, _CONTENT = "mosaic_path", "mosaic_content"
_BUSY_MS = 500  # at most, for another program or transaction that is writing: the desk stands still meanwhile


class KnownMosaic(NamedTuple):
    """A mosaic that is known again."""

    path: str
    content: str
    """``content_of`` its files: a copy elsewhere is the same mosaic, another one at the same path is not."""


def window_fields(levels: int, besides: Iterable[QgsField] = ()) -> QgsFields:
    """Fields of the layer, and others that its windows had elsewhere."""
    fields = column_fields(WINDOW_FIELDS, levels)
    for field in besides:
        if fields.indexOf(field.name()) < 0:
            fields.append(field)
    return fields


def write_window_file(
    wkt: str, folder: Path, fields: QgsFields, rows: Iterable[QgsFeature] = (),
    shape: QgsWkbTypes.Type = QgsWkbTypes.Type.Polygon,
) -> Path:
    """The new file of a window layer, with ``window_fields``. Raises WindowLayerError when it can't be written to the
    folder, or would not have the mosaic's reference system: GeoPackage takes none for degrees."""
    path = free_path(folder, TABLE)
    if not wkt:
        raise WindowLayerError(toolkit_messages.SYSTEM_NOT_WRITTEN(name=path.name))
    if write_table(path, TABLE, fields, shape, wkt, rows) is not None:
        raise WindowLayerError(messages.WINDOW_LAYER_NOT_CREATED(folder=folder))
    store(path, [])
    return path


def count_windows(path: Path) -> int | None:
    """How many windows a file holds that the desk has made, with rows that come to an end; None for any other, or one
    that can't be read now."""
    if not holds_only_tables(path) or (dataset := open_dataset(str(path), FEATURES)) is None:
        return None
    with gdal_silenced(), suppress(RuntimeError):
        windows, results = map(dataset.GetLayerByName, (TABLE, _RESULTS))
        return None if windows is None or results is None else int(windows.GetFeatureCount())
    return None


def is_window_file(path: Path) -> bool:
    """Whether a file is one that the desk has made, with rows that come to an end."""
    return count_windows(path) is not None


def fingerprint(row: WindowRecord, inputs: str) -> str:
    """What the values of a window are of: where it lies, the ``inputs`` by their own fingerprint, and the values."""
    return hashlib.sha256(repr((row.extent, inputs, row.measured)).encode()).hexdigest()[:32]


class StoredResult(NamedTuple):
    """What is stored of a window."""

    window_id: int
    fingerprint: str
    result: WindowResult | None = None  # none: what is there of it stays


def store(path: Path, results: Iterable[StoredResult]) -> None:
    """Write what was measured in windows, in the place of what was there of them. Raises WindowLayerError."""
    with _writing(path) as dataset:
        for number, mark, result in results:
            if result is None:
                quoted = mark.replace("'", "''")  # the file may be somebody else's
                dataset.ExecuteSQL(f"UPDATE {_RESULTS} SET fingerprint = '{quoted}' WHERE window_id = {number}")
                continue
            for name in (*_MEASURED, _RESULTS):
                dataset.ExecuteSQL(f"DELETE FROM {name} WHERE window_id = {number}")
            for name, (_columns, rows_of) in _MEASURED.items():
                _insert(dataset.GetLayerByName(name), rows_of([result]))
            record = {"window_id": number, "fingerprint": mark, "record": record_of(result)}
            _insert(dataset.GetLayerByName(_RESULTS), [record])


def add_fingerprints(path: Path, marks: Mapping[int, str]) -> None:
    """Say of windows that were measured elsewhere what they are of. Raises WindowLayerError."""
    with _writing(path) as dataset:
        rows = ({"window_id": number, "fingerprint": mark} for number, mark in marks.items())
        _insert(dataset.GetLayerByName(_RESULTS), rows)


def fingerprints(path: Path) -> dict[int, str]:
    """Fingerprints that were stored, by window number; none of a file without them."""
    rows = _selected(path, "window_id, fingerprint", "WHERE window_id IS NOT NULL")
    return {number: mark or "" for number, mark in rows}


def load_result(path: Path, window_id: int) -> WindowResult | None:
    """What was last measured in a window; None where that is not there, or of another version."""
    record = load_records(path, [window_id]).get(window_id)
    return result_of(record) if record else None


def load_records(path: Path, numbers: Iterable[int]) -> dict[int, bytes]:
    """Results of windows as the file has them (``result_of``), some 30 to 150 kB each."""
    listed = ", ".join(str(int(number)) for number in numbers)
    return dict(_selected(path, "window_id, record", f"WHERE window_id IN ({listed}) AND record IS NOT NULL"))


def known_mosaic(path: Path) -> KnownMosaic | None:
    """The mosaic that the windows of a file are of."""
    dataset = open_dataset(str(path), FEATURES)
    with gdal_silenced(), suppress(RuntimeError):
        layer = dataset and dataset.GetLayerByName(TABLE)
        notes = layer.GetMetadata(_NOTES) if layer is not None else {}
        if _PATH in notes and _CONTENT in notes:
            return KnownMosaic(notes[_PATH], notes[_CONTENT])
    return None


def note_mosaic(path: Path, mosaic: KnownMosaic) -> None:
    """Its windows are of this mosaic. Raises WindowLayerError."""
    with _writing(path) as dataset:
        dataset.GetLayerByName(TABLE).SetMetadata({_PATH: mosaic.path, _CONTENT: mosaic.content}, _NOTES)


def copy_file(old: Path, new: Path) -> None:
    """A copy as it is this moment, whoever has the file open. Raises WindowLayerError with GDAL's words."""
    name = str(new).replace("'", "''")
    with _changed(old, gdal.OF_READONLY) as dataset:
        dataset.ExecuteSQL(f"VACUUM INTO '{name}'")


@contextmanager
def _writing(path: Path) -> Iterator[gdal.Dataset]:
    """All that is written is there at the end, or none of it; tables that the file lacks are made."""
    with _changed(path, gdal.OF_UPDATE) as dataset:
        dataset.ExecuteSQL(f"PRAGMA busy_timeout = {_BUSY_MS}")
        dataset.ExecuteSQL("PRAGMA synchronous = NORMAL")  # safe from a crash; a power cut may cost the last results
        dataset.StartTransaction()
        try:
            _add_tables(dataset)
            yield dataset
            dataset.FlushCache()  # what GDAL notes of each table when it closes the file would be a write each
            if gdal.GetLastErrorType() < gdal.CE_Failure:
                dataset.CommitTransaction()
        except BaseException:
            dataset.RollbackTransaction()
            raise


@contextmanager
def _changed(path: Path, access: int) -> Iterator[gdal.Dataset]:
    dataset = open_dataset(str(path), FEATURES, access)
    with gdal_silenced():
        gdal.ErrorReset()
        error = "" if dataset is not None else path.name
        try:
            if dataset is not None:
                yield dataset
        except RuntimeError as raised:
            error = str(raised)
        if not error and gdal.GetLastErrorType() >= gdal.CE_Failure:
            error = gdal.GetLastErrorMsg()
    if error:
        raise WindowLayerError(messages.WINDOWS_NOT_WRITTEN(path=path, error=error))


def _add_tables(dataset: gdal.Dataset) -> None:
    levels = sum(definition.GetName().startswith("ratio_") for definition in dataset.GetLayerByName(TABLE).schema)
    kinds = {"integer": ogr.OFTInteger, "real": ogr.OFTReal, "text": ogr.OFTString, "binary": ogr.OFTBinary}
    columns = {name: [(field_name, column.kind) for column in columns for field_name in column.names(levels)]
               for name, (columns, _rows) in _MEASURED.items()}  # fmt: skip
    columns[_RESULTS] = [("window_id", "integer"), ("fingerprint", "text"), ("record", "binary")]
    for name, fields in columns.items():
        layer = dataset.GetLayerByName(name)
        is_new = layer is None
        if is_new:
            layer = dataset.CreateLayer(name, None, ogr.wkbNone)
        there = {definition.GetName() for definition in layer.schema}
        for field_name, kind in fields:
            if field_name not in there:
                layer.CreateField(ogr.FieldDefn(field_name, kinds[kind]))
        if is_new:
            dataset.ExecuteSQL(f"CREATE INDEX {name}_of_window ON {name} (window_id)")


def _insert(layer: ogr.Layer, rows: Iterable[Row]) -> None:
    defined = layer.GetLayerDefn()
    for row in rows:
        made = ogr.Feature(defined)
        for name, value in row.items():
            place = defined.GetFieldIndex(name)
            if isinstance(value, bytes):
                made.SetFieldBinaryFromHexString(place, value.hex())
            elif value is not None and place >= 0:
                made.SetField(place, value)
        layer.CreateFeature(made)


def _selected(path: Path, columns: str, where: str) -> Sequence[tuple[Any, ...]]:
    """Rows of ``results``; none of a file that can't be read."""
    dataset = open_dataset(str(path), FEATURES)
    values: list[tuple[Any, ...]] = []
    with gdal_silenced(), suppress(RuntimeError):
        rows = dataset.ExecuteSQL(f"SELECT {columns} FROM {_RESULTS} {where}") if dataset is not None else None
        if rows is not None and dataset is not None:
            values = [tuple(_value(row, place) for place in range(row.GetFieldCount())) for row in rows]
            dataset.ReleaseResultSet(rows)
    return values


def _value(row: ogr.Feature, place: int) -> object:
    is_binary = row.GetFieldDefnRef(place).GetType() == ogr.OFTBinary
    return bytes(row.GetFieldAsBinary(place)) if is_binary else row.GetField(place)
