"""Where the features of a run go: each layer is whole when the run ends, or it is told that it is not.

A disk that is full shows as a file is closed, if at all: neither QGIS nor GDAL tells. So what was written is counted.
"""
from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable, Optional

from osgeo import gdal
from qgis.core import QgsFeature, QgsFeatureSink, QgsProcessingException
from qgis.PyQt import sip

from ...imagery.atomic_files import drop_unfinished, unfinished_name
from ...imagery.documents.printable import cell_text
from ...imagery.gdal_calls import gdal_silenced
from ...imagery.message import Message
from .. import messages
from ..translation import sentence, tr
from .output_files import DataPlace, files_beside

Sink = tuple[Optional[QgsFeatureSink], Optional[str]]

_COUNTED = (".csv", ".fgb", ".geojson", ".gpkg", ".kml", ".shp", ".sqlite")  # formats that hold all that they are given
_SPREADSHEETS = (".csv", ".ods", ".tsv", ".xlsx")
_OF_DATABASES = ("-wal", "-shm", "-journal")


@dataclass
class _OpenSink:
    """A layer that is being written."""

    sink: QgsFeatureSink
    destination: str
    place: DataPlace | None
    """None for one in memory or on a server."""
    older: _OlderFile | None
    written: int = 0
    has_failed: bool = False

    @property
    def is_spreadsheet(self) -> bool:
        """Whether a program that calculates will open it."""
        return self.place is not None and self.place.path.lower().endswith(_SPREADSHEETS)

    def keep_part(self, held: int) -> Message:
        """Leave what is in a file that is not whole, where it takes the place of no other; what to say of it."""
        path = self.destination if self.place is None else self.place.path
        if self.older is None or (self.older.folder is None and 0 < held < self.written):
            return messages.LAYER_IN_PART(path=path, held=min(held, self.written), count=self.written)
        self.older.restore()
        return messages.LAYER_NOT_WRITTEN(path=path)


@dataclass
class FeatureSinks:
    """The layers of one run."""

    lost: dict[str, Message] = field(default_factory=dict)
    """What to say of those that could not be written, by their destinations; known when they are closed."""
    has_whole: bool = False
    """Whether another one was written; known likewise."""
    _open: list[_OpenSink] = field(default_factory=list)

    def open(self, make: Callable[[], Sink], place: DataPlace | None) -> Sink:
        """What ``make`` opens, at a place that is a file of ours alone or a table in one.

        Raises QgsProcessingException where that can't be; an older file is as it was then, and nothing is left of a
        new one.
        """
        older = _OlderFile.of(place)
        try:
            with gdal_silenced():
                sink, destination = make()
        except QgsProcessingException as error:
            if older is not None:
                older.restore()
            raise QgsProcessingException(_why_not(place, str(error))) from None
        self._open.append(_OpenSink(sink, str(destination), place, older))
        return sink, destination

    def write(self, sink: QgsFeatureSink, features: Iterable[QgsFeature]) -> None:
        """Add features at once, so that they stay whatever comes after.

        One layer that can't be written does not cost the others; raises QgsProcessingException when none is left.
        """
        of = next(one for one in self._open if one.sink is sink)
        for feature in features:
            if of.has_failed:
                return
            if of.is_spreadsheet:
                _disarm(feature)
            with gdal_silenced():
                of.has_failed = not sink.addFeature(feature, QgsFeatureSink.Flag.FastInsert)
            of.written += 1
            if of.has_failed and all(one.has_failed for one in self._open):
                said = sink.lastError() or tr("A result can't be written; is the disk full?")
                raise QgsProcessingException(_why_not(of.place, said))

    def close(self, has_failed: bool = False) -> None:
        """Make layers whole: they are so without their sinks only, which a frame or a cycle may still hold.

        Of a run that failed nothing is left where nothing was written.
        """
        while self._open:
            of = self._open.pop()
            with gdal_silenced():
                gdal.ErrorReset()
                sip.delete(of.sink)
                has_closed = gdal.GetLastErrorType() < gdal.CE_Failure
            if has_failed and not of.written and of.older is not None:
                of.older.restore()
                continue
            held = of.written * has_closed
            if of.place is not None and of.place.path.lower().endswith(_COUNTED):
                held = _count(of.place)
            if of.has_failed or held < of.written:
                self.lost[of.destination] = of.keep_part(held)
            else:
                self.has_whole = True
                if of.older is not None:
                    of.older.drop()


def _disarm(feature: QgsFeature) -> None:
    """What others called their files becomes no formula."""
    for index, value in enumerate(feature.attributes()):
        if isinstance(value, str):
            feature.setAttribute(index, cell_text(value))


def _why_not(place: DataPlace | None, said: str) -> str:
    """In our words for a file; a server has its own reasons."""
    return said if place is None else sentence(messages.LAYER_NOT_WRITTEN(path=place.path))


def _count(place: DataPlace) -> int:
    """How many features a file holds."""
    with gdal_silenced(), suppress(RuntimeError):
        dataset = gdal.OpenEx(place.path, gdal.OF_VECTOR)
        table = place.table
        layer = dataset and (dataset.GetLayerByName(table) if table else dataset.GetLayer(0))
        return int(layer.GetFeatureCount()) if layer else 0
    return 0


@dataclass
class _OlderFile:
    """What was there before, put aside while a new one is written."""

    path: Path
    folder: Path | None
    """Where it is meanwhile; None where there was nothing, and what is half-made goes."""

    @classmethod
    def of(cls, place: DataPlace | None) -> _OlderFile | None:
        """None for what is no file of its own, or can't be put aside."""
        if place is None or place.table or place.path.startswith("/vsi"):
            return None
        path = Path(os.path.realpath(place.path))
        if not os.path.lexists(path):
            return cls(path, None)
        try:
            folder = Path(tempfile.mkdtemp(prefix=unfinished_name(path), dir=path.parent))
        except OSError:
            return None
        made = cls(path, folder)
        try:
            for file in made._files():
                os.replace(file, folder / file.name)
        except OSError:  # as on Windows, where it is open in QGIS
            made._put_back()
            return None
        return made

    def restore(self) -> None:
        """Nothing of the new file stays, and the older one is as it was."""
        for file in self._files():
            with suppress(OSError):
                file.unlink()
        if self.folder is not None:
            self._put_back()

    def drop(self) -> None:
        """The new file is whole."""
        drop_unfinished(self.path)  # and what was put aside by processes that were killed

    def _put_back(self) -> None:
        for file in self.folder.iterdir() if self.folder is not None else ():
            with suppress(OSError):
                os.replace(file, self.path.with_name(file.name))
        if self.folder is not None:
            with suppress(OSError):  # what can't be put back stays there
                self.folder.rmdir()

    def _files(self) -> list[Path]:
        names = [self.path, *map(Path, files_beside(str(self.path)))]
        names += [Path(f"{self.path}{ending}") for ending in _OF_DATABASES]
        return [name for name in names if os.path.lexists(name)]
