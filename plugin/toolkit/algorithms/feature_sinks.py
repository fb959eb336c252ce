"""The layers that a run writes: each is whole when the run ends, or the user is told that it is not.

A disk that is full shows as a file is closed, if at all: neither QGIS nor GDAL tells. So what was written is counted.
"""
from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable, Optional

from osgeo import gdal
from qgis.core import QgsFeature, QgsFeatureSink, QgsProcessingException
from qgis.PyQt import sip

from ...imagery import messages as imagery_messages
from ...imagery.atomic_files import UnfinishedFile, drop_unfinished
from ...imagery.errors import Message, cell_text
from ...imagery.file_identity import DataPlace
from ...imagery.gdal_calls import gdal_silenced
from ...imagery.gdal_paths import FEATURES, open_dataset
from .. import messages
from ..translation import sentence, tr

Sink = tuple[Optional[QgsFeatureSink], Optional[str]]

_COUNTED = (".csv", ".fgb", ".geojson", ".gpkg", ".kml", ".shp", ".sqlite")  # formats that hold all that they are given
_SPREADSHEETS = (".csv", ".ods", ".tsv", ".xlsx")
_NOT_THERE = -1  # features: fewer than an empty layer has
_OF_DATABASES = ("-wal", "-shm", "-journal")


@dataclass
class _OpenSink:
    sink: QgsFeatureSink
    destination: str
    place: DataPlace | None  # None for one in memory or on a server
    file: UnfinishedFile | None  # None where it is written in its place: a table among others
    written: int = 0
    has_failed: bool = False

    @property
    def path(self) -> str:
        return self.destination if self.place is None else self.place.path

    def count(self, has_closed: bool) -> int:
        """The number of features, as far as it can be told, ``_NOT_THERE`` without the layer; ``has_closed``: whether
        GDAL closed it well."""
        if not self.written or self.place is None or not self.path.lower().endswith(_COUNTED):
            return self.written if has_closed and not self.has_failed else _NOT_THERE
        return _count(self.place if self.file is None else DataPlace(str(self.file.written)))


@dataclass
class FeatureSinks:
    lost: dict[str, Message] = field(default_factory=dict)
    """What to say of those that could not be written, by their destinations; known when they are closed."""
    beside: dict[str, tuple[str, Message]] = field(default_factory=dict)
    """The places of layers that may not replace an older one, and what to say of each, likewise."""
    has_whole: bool = False  # whether another one was written; known likewise
    _open: list[_OpenSink] = field(default_factory=list)

    def open(self, make: Callable[[str | None], Sink], place: DataPlace | None) -> Sink:
        """The sink that ``make`` opens at a place, a file of ours alone or a table in one, and its
        destination. ``make`` is given the path to write to meanwhile, None for the place itself.

        Raises QgsProcessingException where that can't be; an older file is as it was then, and nothing is left of a
        new one.
        """
        file = None
        if place is not None and not place.table and not place.path.startswith("/vsi"):
            with suppress(OSError):
                file = UnfinishedFile(Path(place.path))
        try:
            with gdal_silenced():
                sink, destination = make(None if file is None else str(file.written))
        except QgsProcessingException as error:
            if file is not None:
                file.drop()
            raise QgsProcessingException(_why_not(place, str(error))) from None
        self._open.append(_OpenSink(sink, str(destination), place, file))
        return sink, destination

    def write(self, sink: QgsFeatureSink, features: Iterable[QgsFeature]) -> None:
        """Add features at once, so that they stay whatever comes after.

        One layer that can't be written does not cost the others; raises QgsProcessingException when none is left.
        """
        layer = next(layer for layer in self._open if layer.sink is sink)
        is_spreadsheet = layer.place is not None and layer.path.lower().endswith(_SPREADSHEETS)
        for feature in features:
            if layer.has_failed:
                return
            for index, value in enumerate(feature.attributes()) if is_spreadsheet else ():
                if isinstance(value, str):  # formulas: others named their files
                    feature.setAttribute(index, cell_text(value))
            with gdal_silenced():
                layer.has_failed = not sink.addFeature(feature, QgsFeatureSink.Flag.FastInsert)
            layer.written += 1
            if layer.has_failed and all(other.has_failed for other in self._open):
                said = sink.lastError() or tr("A result can't be written; is the disk full?")
                raise QgsProcessingException(_why_not(layer.place, said))

    def close(self, has_failed: bool = False, is_cancelled: bool = False) -> None:
        """Make layers whole: they are so without their sinks only, which a frame or a cycle may still hold.

        What a run that failed or was cancelled has measured replaces nothing.
        """
        while self._open:
            layer = self._open.pop()
            with gdal_silenced():
                gdal.ErrorReset()
                sip.delete(layer.sink)
                held = layer.count(gdal.GetLastErrorType() < gdal.CE_Failure)
            file, path = layer.file, layer.path
            if file is not None and has_failed and not layer.written:
                file.drop()
                continue
            if file is not None and held < layer.written and (file.replaces or held <= 0):
                file.drop()
                held = _NOT_THERE
            elif file is not None:
                try:
                    path = _placed(file, path, is_cancelled or has_failed)
                except OSError:
                    file.drop()
                    held = _NOT_THERE
            if held >= layer.written:
                self.has_whole = True
                if path != layer.path:
                    self.beside[layer.destination] = path, messages.LAYER_BESIDE(path=layer.path, part=path)
            elif held > 0:
                self.lost[layer.destination] = messages.LAYER_IN_PART(path=path, held=held, count=layer.written)
            else:
                self.lost[layer.destination] = imagery_messages.RASTER_NOT_WRITTEN(path=path)


def _placed(file: UnfinishedFile, path: str, replaces_nothing: bool) -> str:
    """The place that a file takes: where it was to be, else beside the older one. Raises OSError where it can't."""
    if not (replaces_nothing and file.replaces):
        with suppress(OSError):  # as on Windows, where the older one is open in QGIS
            file.keep(file.written.name + ending for ending in _OF_DATABASES)
            drop_unfinished(Path(path))  # what processes left that were killed
            return path
    return str(file.keep_beside())


def _why_not(place: DataPlace | None, said: str) -> str:
    """The reason why a layer can't be written: our words for a file, those of the server for a table."""
    return said if place is None else sentence(imagery_messages.RASTER_NOT_WRITTEN(path=place.path))


def _count(place: DataPlace) -> int:
    """The number of features in a file; ``_NOT_THERE`` for one without the layer."""
    with gdal_silenced(), suppress(RuntimeError):
        dataset = open_dataset(place.path, FEATURES)
        layer = dataset and (dataset.GetLayerByName(place.table) if place.table else dataset.GetLayer(0))
        return _NOT_THERE if layer is None else int(layer.GetFeatureCount())
    return _NOT_THERE
