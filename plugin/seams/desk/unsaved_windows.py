"""What was changed in a window layer and is not saved in it yet, on disk at once; and how it comes back.

QGIS keeps changes in memory until the operator saves the layer, and saving empties undo; so they are written into a
folder beside the layer's file, window by window, which goes when the layer is saved or rolled back. What such a folder
holds when a layer is opened is what a QGIS left that ended without either.
"""
from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from contextlib import closing, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, NamedTuple

from osgeo import ogr
from qgis.core import QgsFeature, QgsFeatureRequest, QgsGeometry, QgsProject, QgsVectorLayer, QgsVectorLayerUtils
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...imagery.documents import json_document
from ...imagery.errors import SettingsError, WindowLayerError
from ...imagery.gdal_calls import gdal_silenced
from ...imagery.record_store import RecordFolder, RecordKeeper
from ...imagery.statistics import JUDGING_FIELDS
from ...toolkit import messages as toolkit_messages
from ...toolkit.connections import Connections
from ...toolkit.desk.widgets import single_shot
from ...toolkit.layers import edit_step
from ...toolkit.table_fields import is_known, whole_number
from ...toolkit.translation import tr
from .windows.window_watch import WindowWatch

_KIND = "Seam Inspector: windows not saved yet, 3"
_AT_ONCE = 25  # windows read and written in one step, some ms
_PATIENCE_S = 0.04  # with a disk that is busy
_NUMBER = "window_id"
_LARGEST = 2**63
_OWNER = "project"
_KEPT = (bool, int, float, str)
_PRIMARY_KEY = "fid"  # of a GeoPackage, which gives it itself


@dataclass(frozen=True)
class UnsavedWindow:
    """A window as it was."""

    number: int
    wkb: bytes | None
    """Its outline; None when it was removed."""
    values: Mapping[str, Any]
    """Values by the fields' names, those that had one."""
    is_stale: bool = False
    """Whether its result was outdated."""


class UnsavedWindows(QObject):
    """Follows one layer for as long as it is there, also when other windows are looked at meanwhile."""

    failed = pyqtSignal(object)
    """Why nothing can be kept."""

    def __init__(
        self, layer: QgsVectorLayer, path: Path, is_stale: Callable[[QgsVectorLayer, int], bool], parent: QObject,
        is_alone: bool = False,
    ) -> None:
        """``is_stale``: whether the results of the window with a number are outdated. ``is_alone``: no project knows
        the layer, so the record is there as long as the layer is followed, whatever is saved in it meanwhile.
        """
        super().__init__(parent)
        self._layer, self._is_stale, self._is_alone = layer, is_stale, is_alone
        self._keeper = RecordKeeper(path, _KIND, self.failed.emit)
        self._touched: dict[int, None] = {}  # in order
        self._numbers: dict[int, int] = {}  # by feature id
        self._is_saving = False
        self._writer = single_shot(self, self._write)
        self._connections = Connections(
            (layer.featureAdded, self._touch),
            (layer.featureDeleted, self._touch),
            (layer.attributeValueChanged, self._touch),
            (layer.geometryChanged, self._touch),
            (layer.beforeCommitChanges, self._about_to_be_saved),
            (layer.afterCommitChanges, self._settled),
            (layer.afterRollBack, self._settled),
        )
        self._saved = single_shot(self, self._not_saved)
        self._has_owner = False
        self._read_numbers()
        if layer.isModified():
            self._touch_all()
        elif is_alone and not path.is_dir():
            self._keep_owner()

    def left(self) -> list[UnsavedWindow]:
        """What a QGIS left that ended without saving."""
        held = self._keeper.all()
        found = (_read(payload) for name, payload in held.items() if name != _OWNER)
        return sorted((one for one in found if one is not None), key=lambda one: one.number)

    def drop(self) -> None:
        """What was left has been dealt with."""
        self._has_owner = False
        self._keeper.remove()
        if self._is_alone:
            self._keep_owner()

    def close(self, is_left: bool = False) -> None:
        """Write what is to be written and follow the layer no more. ``is_left``: QGIS itself asks what is to become of
        its changes."""
        if self._touched:
            self._write(len(self._touched))  # in one go: QGIS goes through all that was added each time it is asked
        self._writer.stop()
        self._saved.stop()
        self._connections.close()
        if is_left or (self._is_alone and not sip.isdeleted(self._layer) and not self._layer.isModified()):
            self._keeper.remove()
        self._keeper.close()

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
        request = QgsFeatureRequest().setFlags(QgsFeatureRequest.Flag.NoGeometry).setSubsetOfAttributes([index])
        features = self._layer.getFeatures(request) if index >= 0 else ()
        numbers = {feature.id(): whole_number(feature.attribute(index)) for feature in features}
        self._numbers = {fid: number for fid, number in numbers.items() if number is not None}

    def _write(self, most: int = _AT_ONCE) -> None:
        """In the keeper's thread, some ms later on the disk; only the next action waits for that. The last window is
        safe from a power cut too, which is the only one unless many change at once."""
        fids = list(self._touched)[:most]
        for fid in fids:
            del self._touched[fid]
        there = {one.id(): one for one in self._layer.getFeatures(QgsFeatureRequest().setFilterFids(fids))}
        for fid in fids:
            before, feature, is_last = self._numbers.pop(fid, None), there.get(fid), fid == fids[-1]
            number = None if feature is None else _number_of(feature)
            if before is not None and before != number:
                self._keep(UnsavedWindow(before, None, {}), is_last)
            if feature is not None and number is not None:
                self._numbers[fid] = number
                wkb, is_stale = bytes(feature.geometry().asWkb()), self._is_stale(self._layer, number)
                self._keep(UnsavedWindow(number, wkb, kept_values(feature), is_stale), is_last)
        if self._touched:
            self._writer.start()

    def _keep_owner(self) -> None:
        if not self._has_owner:
            self._has_owner, owner = True, QgsProject.instance().fileName().encode()
            self._keeper.save(_OWNER, lambda: owner)

    def _keep(self, window: UnsavedWindow, is_synced: bool) -> None:
        self._keep_owner()
        payload = json.dumps(
            {"number": window.number, "wkb": window.wkb and window.wkb.hex(), "values": window.values,
             "stale": window.is_stale}
        ).encode()  # fmt: skip
        self._keeper.save(str(window.number), lambda: payload, is_synced)


class Left(NamedTuple):
    """What a QGIS left that ended without saving."""

    project: str
    """Its file; empty for one that had none."""
    unsaved: int
    """How many windows were not saved."""


def left_by(path: Path) -> Left | None:
    """What a record says; None for one that a QGIS has open, or that can't be read."""
    try:
        records = RecordFolder(path, _KIND)
    except (OSError, SettingsError):
        return None
    with closing(records), suppress(OSError):
        if (owner := records.files.load(_OWNER)) is not None:
            return Left(owner.decode(errors="replace"), len(records.files.names) - 1)
    return None


def _number_of(feature: QgsFeature) -> int | None:
    index = feature.fields().indexOf(_NUMBER)
    return whole_number(feature.attribute(index)) if index >= 0 else None


def _read(payload: bytes) -> UnsavedWindow | None:
    try:
        held = json_document(payload)
        wkb = None if held["wkb"] is None else bytes.fromhex(held["wkb"])
        values = {name: value for name, value in held["values"].items() if _is_plain(value)}
        if type(held["number"]) is not int or not _is_plain(held["number"]) or not _is_shape(wkb or b""):
            return None
        return UnsavedWindow(held["number"], wkb, values, bool(held["stale"]))
    except (ValueError, TypeError, KeyError, AttributeError):  # whatever somebody wrote there
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


def restore(watch: WindowWatch, windows: Sequence[UnsavedWindow], levels: int) -> int:
    """How many windows are other ones now. Raises WindowLayerError when the layer can't be edited."""
    layer = watch.layer
    assert layer is not None
    there = {row.window_id: layer.getFeature(row.fid) for row in watch.rows()}
    other = [one for one in windows if _is_other(one, there.get(one.number))]
    if not other:
        return 0
    judging = {name for one in other for name in one.values if name in JUDGING_FIELDS}
    with edit_step(layer, tr("Restore windows")):
        watch.prepare([], levels, judging)
        fids = {row.window_id: row.fid for row in watch.rows()}
        layer.deleteFeatures([fids[one.number] for one in other if one.wkb is None])
        for one in other:
            if one.wkb is not None:
                _bring_back(layer, fids.get(one.number), one)
    watch.mark_stale([one.number for one in other if one.is_stale])
    return len(other)


def _is_other(window: UnsavedWindow, feature: QgsFeature | None) -> bool:
    if feature is None or window.wkb is None:
        return (feature is None) != (window.wkb is None)
    return bytes(feature.geometry().asWkb()) != window.wkb or kept_values(feature) != dict(window.values)


def kept_values(feature: QgsFeature) -> dict[str, Any]:
    """Values of a window by the fields' names: numbers and texts, as windows have them."""
    named = zip(feature.fields().names(), feature.attributes())
    return {name: value for name, value in named if type(value) in _KEPT and name != _PRIMARY_KEY}


def _bring_back(layer: QgsVectorLayer, fid: int | None, window: UnsavedWindow) -> None:
    outline = QgsGeometry()
    outline.fromWkb(window.wkb)
    fields = layer.fields()
    values = {index: value for name, value in window.values.items() if (index := fields.indexOf(name)) >= 0}
    if fid is None:
        if not layer.addFeature(QgsVectorLayerUtils.createFeature(layer, outline, values)):
            raise WindowLayerError(toolkit_messages.WINDOW_LAYER_READ_ONLY(name=layer.name()))
        return
    feature = layer.getFeature(fid)
    if bytes(feature.geometry().asWkb()) != window.wkb:
        layer.changeGeometry(fid, outline)
    for index, held in enumerate(feature.attributes()):
        value = values.get(index)
        is_kept = fields.at(index).name() != _PRIMARY_KEY and (type(held) in _KEPT or not is_known(held))
        if is_kept and (held if is_known(held) else None) != value:
            layer.changeAttributeValue(fid, index, value)
