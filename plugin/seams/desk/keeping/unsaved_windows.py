"""What was changed in a window layer and is not saved in it yet, on disk at once.

QGIS keeps changes in memory until the operator saves the layer, and saving empties undo; so they are written into a
file beside the layer's own, window by window, which goes when the layer is saved or rolled back. What such a file holds
when a layer is opened is what a QGIS left that ended without either.
"""
from __future__ import annotations

import json
from contextlib import suppress
from pathlib import Path
from typing import Callable

from osgeo import ogr
from qgis.core import QgsFeature, QgsFeatureRequest, QgsProject, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtBoundSignal, pyqtSignal

from ....imagery.errors import SettingsError
from ....imagery.gdal_calls import gdal_silenced
from ....imagery.record_store import RecordKeeper, RecordStore
from ....toolkit.desk.widgets import single_shot
from ....toolkit.table_fields import whole_number
from .restoring import UnsavedWindow, kept_values

_KIND = "Seam Inspector: windows not saved yet, 3"
_AT_ONCE = 25  # windows read and written in one step, some ms
_PATIENCE_S = 0.04  # with a disk that is busy
_NUMBER = "window_id"
_LARGEST = 2**63
_OWNER, _NOBODY = "project", b"\0"


class UnsavedWindows(QObject):
    """Follows one layer for as long as it is there, also when other windows are looked at meanwhile."""

    failed = pyqtSignal(object)
    """Why nothing can be kept."""

    def __init__(
        self, layer: QgsVectorLayer, path: Path, is_stale: Callable[[QgsVectorLayer, int], bool], parent: QObject
    ) -> None:
        """``is_stale``: whether the results of the window with a number are outdated."""
        super().__init__(parent)
        self._layer, self._is_stale = layer, is_stale
        self._keeper = RecordKeeper(path, _KIND, self.failed.emit)
        self._touched: dict[int, None] = {}  # in order
        self._numbers: dict[int, int] = {}  # by feature id
        self._is_saving = False
        self._writer = single_shot(self, self._write)
        self._connections: list[tuple[pyqtBoundSignal, Callable[..., None]]] = [
            (layer.featureAdded, self._touch),
            (layer.featureDeleted, self._touch),
            (layer.attributeValueChanged, self._touch),
            (layer.geometryChanged, self._touch),
            (layer.beforeCommitChanges, self._about_to_be_saved),
            (layer.afterCommitChanges, self._settled),
            (layer.afterRollBack, self._settled),
        ]
        for signal, slot in self._connections:
            signal.connect(slot)
        self._saved = single_shot(self, self._not_saved)
        self._has_owner = False
        self._read_numbers()
        if layer.isModified():
            self._touch_all()

    @property
    def layer(self) -> QgsVectorLayer:
        """What it follows."""
        return self._layer

    def left(self) -> list[UnsavedWindow]:
        """What a QGIS left that ended without saving."""
        held = self._keeper.all()
        return [one for key, payload in held.items() if key != _OWNER and (one := _read(payload)) is not None]

    def drop(self) -> None:
        """What was left has been dealt with."""
        self._has_owner = False
        self._keeper.remove()

    def close(self) -> None:
        """Write what is to be written and follow the layer no more."""
        while self._touched:
            self._write()
        self._writer.stop()
        self._saved.stop()
        for signal, slot in self._connections:
            with suppress(TypeError, RuntimeError):  # the layer is gone already
                signal.disconnect(slot)
        self._keeper.close()

    def flush(self) -> None:
        """Wait until all is written."""
        while self._touched:
            self._write()
        self._keeper.flush()

    def _touch(self, fid: int, *_: object) -> None:
        if not self._is_saving:
            self._touched[fid] = None
            if not self._writer.isActive():
                self._keeper.wait(_PATIENCE_S)  # the action before this one is on the disk: a crash costs one at most
                self._writer.start()

    def _about_to_be_saved(self, *_: object) -> None:
        self._is_saving = True
        self._saved.start()

    def _not_saved(self) -> None:
        """Saving, which takes no turn of the interface, has failed; some may have been saved all the same."""
        if self._is_saving:
            self._is_saving = False
            self._touch_all()

    def _touch_all(self) -> None:
        buffer = self._layer.editBuffer()
        changes = (buffer.addedFeatures(), buffer.changedAttributeValues(), buffer.changedGeometries())
        for fid in (fid for changed in changes for fid in changed):
            self._touch(fid)

    def _settled(self) -> None:
        """The layer's file holds what the layer shows."""
        self._is_saving = False
        self._touched.clear()
        self._writer.stop()
        self.drop()
        self._read_numbers()

    def _read_numbers(self) -> None:
        index = self._layer.fields().indexOf(_NUMBER)
        if index < 0:
            self._numbers = {}
            return
        request = QgsFeatureRequest().setFlags(QgsFeatureRequest.Flag.NoGeometry).setSubsetOfAttributes([index])
        numbers = ((one.id(), whole_number(one.attribute(index))) for one in self._layer.getFeatures(request))
        self._numbers = {fid: number for fid, number in numbers if number is not None}

    def _write(self) -> None:
        """In the keeper's thread, some ms later on the disk; only the next action waits for that."""
        fids = list(self._touched)[:_AT_ONCE]
        for fid in fids:
            del self._touched[fid]
        there = {one.id(): one for one in self._layer.getFeatures(QgsFeatureRequest().setFilterFids(fids))}
        for fid in fids:
            before, feature = self._numbers.pop(fid, None), there.get(fid)
            number = None if feature is None else _number_of(feature)
            if before is not None and before != number:
                self._keep(UnsavedWindow(before, None, {}))
            if feature is not None and number is not None:
                self._numbers[fid] = number
                self._keep(_window(number, feature, self._is_stale(self._layer, number)))
        if self._touched:
            self._writer.start()

    def _keep(self, window: UnsavedWindow) -> None:
        if not self._has_owner:
            self._has_owner, owner = True, QgsProject.instance().fileName().encode()
            self._keeper.save(_OWNER, lambda: owner or _NOBODY)
        payload = json.dumps(
            {"number": window.number, "wkb": window.wkb and window.wkb.hex(), "values": window.values,
             "stale": window.is_stale}
        ).encode()  # fmt: skip
        self._keeper.save(str(window.number), lambda: payload)


def owner_of(path: Path) -> str | None:
    """The project, empty for one without a file, in which such a file was made; None while a QGIS has it open."""
    try:
        file = RecordStore(path, _KIND)
    except (OSError, SettingsError):
        return None
    try:
        owner = file.load(_OWNER)
    except OSError:
        return None
    finally:
        file.close()
    return None if owner is None else owner.rstrip(_NOBODY).decode(errors="replace")


def _number_of(feature: QgsFeature) -> int | None:
    index = feature.fields().indexOf(_NUMBER)
    return whole_number(feature.attribute(index)) if index >= 0 else None


def _window(number: int, feature: QgsFeature, is_stale: bool) -> UnsavedWindow:
    return UnsavedWindow(number, bytes(feature.geometry().asWkb()), kept_values(feature), is_stale)


def _read(payload: bytes) -> UnsavedWindow | None:
    try:
        held = json.loads(payload)
        wkb = None if held["wkb"] is None else bytes.fromhex(held["wkb"])
        values = {name: value for name, value in held["values"].items() if _is_plain(value)}
        if type(held["number"]) is not int or not _is_plain(held["number"]) or not _is_shape(wkb or b""):
            return None
        return UnsavedWindow(held["number"], wkb, values, bool(held["stale"]))
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):  # whatever somebody wrote there
        return None


def _is_shape(wkb: bytes) -> bool:
    """Whether a geometry is what it says, none at all too: QGIS makes room for as many points as it is told of."""
    with gdal_silenced():
        try:
            return not wkb or ogr.CreateGeometryFromWkb(wkb) is not None
        except RuntimeError:
            return False


def _is_plain(value: object) -> bool:
    """Whether a field can hold it."""
    return type(value) in (bool, float, str) or (type(value) is int and abs(value) < _LARGEST)
