"""Outputs that can't be are refused before anything is measured or written."""
from __future__ import annotations

import errno
import os
import sqlite3
import stat
from contextlib import closing
from typing import Any
from urllib.parse import quote

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterRasterDestination,
)

from ...imagery import messages as imagery_messages
from ...imagery.errors import SettingsError
from ...imagery.messages import system_reason
from .. import messages
from .output_files import is_database, is_file, output_text, table_place

_IN_MEMORY = "/vsimem/"
_NO_TABLE_BEGINS_WITH = "`~!@#$%^&*()+-={}|[]\\:\";'<>?,/"  # as GDAL's GeoPackage has it
_JOURNAL = "-journal"  # SQLite's, beside the database


def refuse_impossible(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> None:
    """Raise SettingsError for an output of features or a raster that can't be written where it is to go.

    Pages and charts are written last, and what keeps them from that is told then: it costs nothing that was measured.
    """
    for definition in algorithm.destinationParameterDefinitions():
        text, title = output_text(parameters.get(definition.name()), context), definition.description()
        if "\0" in text:
            raise SettingsError(messages.OUTPUT_NAMES_NO_FILE(output=title, path=text))
        if text and isinstance(definition, QgsProcessingParameterRasterDestination):
            _check_raster(text, title)
        elif text and isinstance(definition, QgsProcessingParameterFeatureSink):
            _check_table(text, title)


def _check_raster(text: str, title: str) -> None:
    if not is_file(text) or text.startswith("ogr:") or not text.strip():
        raise SettingsError(messages.OUTPUT_NAMES_NO_FILE(output=title, path=text))
    _check_file(text, title)


def _check_table(text: str, title: str) -> None:
    if not is_file(text):
        return  # a database server, of which QGIS asks and tells itself
    if not text.strip():
        raise SettingsError(messages.OUTPUT_NAMES_NO_FILE(output=title, path=text))
    place = table_place(text)
    if os.path.exists(text) and not os.path.isfile(text):
        _refuse(text, errno.EISDIR if os.path.isdir(text) else errno.EPERM)
    _check_file(text if text.endswith(("/", os.sep)) else place.path, title)
    name = os.path.basename(place.path)
    if is_database(place.path) and not place.table and name[0] in _NO_TABLE_BEGINS_WITH:
        raise SettingsError(messages.TABLE_BEGINS_WRONG(output=title, name=name, begins=name[0]))
    if is_database(place.path) and os.path.isfile(place.path) and _is_locked(place.path):
        raise SettingsError(messages.OUTPUT_IN_USE(path=place.path))


def _check_file(path: str, title: str) -> None:
    """Raise SettingsError where no file can be."""
    if path.startswith(_IN_MEMORY):
        return
    if path.startswith("/vsi"):  # archives and servers: most of GDAL's can't be written, and are left half-made
        raise SettingsError(messages.OUTPUT_NAMES_NO_FILE(output=title, path=path))
    if path.endswith(("/", os.sep)):
        _refuse(path, errno.EISDIR)
    try:
        found = _state(path)
        if is_database(path):
            _state(path + _JOURNAL)
        os.stat(os.path.join(os.path.dirname(os.path.realpath(path)), ""))
    except OSError as error:
        raise SettingsError(imagery_messages.FILE_NOT_WRITTEN(path=path, error=system_reason(error))) from None
    if found is not None and not stat.S_ISREG(found.st_mode):
        _refuse(path, errno.EISDIR if stat.S_ISDIR(found.st_mode) else errno.EPERM)
    if not os.access(path if found is not None else os.path.dirname(os.path.realpath(path)), os.W_OK):
        _refuse(path, errno.EACCES)


def _state(path: str) -> os.stat_result | None:
    """None where there is no such file. Raises OSError where there can be none."""
    try:
        return os.stat(path)
    except FileNotFoundError:
        return None


def _is_locked(path: str) -> bool:
    """Whether another program is writing a database. Nothing is written to it."""
    try:
        with closing(sqlite3.connect(f"file:{quote(os.path.abspath(path))}?mode=rw", timeout=0, uri=True)) as database:
            database.execute("BEGIN IMMEDIATE")
            database.rollback()
    except sqlite3.DatabaseError as error:
        return "locked" in str(error)
    return False


def _refuse(path: str, number: int) -> None:
    reason = system_reason(OSError(number, os.strerror(number)))
    raise SettingsError(imagery_messages.FILE_NOT_WRITTEN(path=path, error=reason))
