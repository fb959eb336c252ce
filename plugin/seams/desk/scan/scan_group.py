"""The layers of a scan on the map: the picture as it grows, then all that was found, in a group on top."""
from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsApplication,
    QgsLayerTreeGroup,
    QgsLayerTreeLayer,
    QgsMapLayer,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QDateTime, QObject, Qt, pyqtSignal

from ....toolkit.background_tasks import BackgroundTasks, Cancelled, End, Job, Outcome
from ....toolkit.desk.widgets import single_shot
from ....toolkit.layer_styles import load_style
from ....toolkit.translation import tr
from ...scan_job import ScanDone, ScanFiles
from ...tables import scan_layers
from ...tables.scan_layers import ScanLayer

_REPAINT_MS = 1000
_SCANNED, _MOSAIC = "seam_inspector/scanned", "seam_inspector/mosaic"
"""Custom properties of the layer of worst windows: when they were found, and in which mosaic layer."""


class ScanGroup(QObject):
    """Of one scan at a time. Its results are opened in the background: for a large picture QGIS takes a quarter of a
    second, as it looks for its least and largest values whatever its style is."""

    complete = pyqtSignal(object)
    """All layers of this ScanDone are on the map."""

    def __init__(self, project: QgsProject, parent: QObject) -> None:
        super().__init__(parent)
        self._project = project
        self._background = BackgroundTasks(self)
        self._background.ended.connect(self._opened)
        self._repainter = single_shot(self, self._repaint, _REPAINT_MS)
        self.begin("", "", None)

    @property
    def is_busy(self) -> bool:
        """Whether results are being opened."""
        return self._background.is_busy

    def begin(self, title: str, mosaic: str, files: ScanFiles | None) -> None:
        """Another scan, of a mosaic layer."""
        self._title, self._mosaic, self._files = title, mosaic, files
        self._so_far = ""  # id of the layer with the picture so far
        self._top = ""  # id of the layer that was added last
        self._was_shown = False

    def show_so_far(self) -> None:
        """There is more in the picture: show it, at most once a second. What the operator removed stays away."""
        if self._files is None:
            return
        if not self._was_shown:
            self._was_shown = True
            self._so_far = self._known_so_far(self._files.so_far) or self._add_so_far(self._files.so_far)
        if not self._repainter.isActive():
            self._repainter.start()

    def finish(self, done: ScanDone) -> None:
        """Replace the picture so far by what was found."""
        self._repainter.stop()
        self._background.start(tr("Open the scan's layers"), _opening_job(done), self._take, done, steps=1)

    def rest(self) -> None:
        """The scan was stopped: the picture so far stays, up to date."""
        if self._repainter.isActive():
            self._repainter.stop()
            self._repaint()

    def abandon(self) -> None:
        """The project is closed, and its layers are gone."""
        self._repainter.stop()
        self._background.abandon()
        self.begin("", "", None)

    def close(self) -> None:
        """Leave no timer, nor a picture that nobody will complete."""
        self._repainter.stop()
        self._background.close()
        if self._so_far:
            self._remove_so_far()

    # The picture so far

    def _known_so_far(self, path: Path) -> str:
        """The layer that an earlier scan of the same files left."""
        for layer in self._project.mapLayers().values():
            if isinstance(layer, QgsRasterLayer) and layer.isValid() and Path(layer.source()) == path:
                return str(layer.id())
        return ""

    def _add_so_far(self, path: Path) -> str:
        layer = _picture(path, tr("Picture of losses, so far"))
        if not layer.isValid():
            return ""
        self._project.addMapLayer(layer, False)
        self._group().addLayer(layer)
        return str(layer.id())

    def _repaint(self) -> None:
        layer = self._project.mapLayer(self._so_far)
        if isinstance(layer, QgsRasterLayer):
            layer.dataProvider().reloadData()  # else GDAL answers from what it read before
            layer.triggerRepaint()

    def _remove_so_far(self) -> None:
        if (layer := self._project.mapLayer(self._so_far)) is not None:
            group = self._parent_of(layer)
            self._project.removeMapLayer(layer.id())
            if group is not None and not group.children() and group.parent() is not None:
                group.parent().removeChildNode(group)
        self._so_far = ""
        if self._files is not None:
            for path in (self._files.so_far, Path(f"{self._files.so_far}.aux.xml")):
                with suppress(OSError):
                    path.unlink()

    # What was found

    def _take(self, found: Any) -> None:
        """The next layer goes on top of the one before."""
        layer, kind = found
        before = self._project.mapLayer(self._top or self._so_far)
        group = (self._parent_of(before) if before is not None else None) or self._group()
        if kind is scan_layers.WORST:
            layer.setCustomProperty(_SCANNED, QDateTime.currentDateTime().toString(Qt.DateFormat.ISODateWithMs))
            layer.setCustomProperty(_MOSAIC, self._mosaic)
        node = self._add(layer, group)
        node.setExpanded(kind in (None, scan_layers.SEAMS))
        node.setItemVisibilityChecked(kind is not scan_layers.WORST)  # fifty windows would hide what they are of
        self._top = layer.id()
        if kind is None:
            self._remove_so_far()

    def _opened(self, done: Any, outcome: Outcome) -> None:
        if outcome.end is End.DONE:
            self.complete.emit(done)

    def _add(self, layer: QgsMapLayer, group: QgsLayerTreeGroup) -> QgsLayerTreeLayer:
        """On top of the group."""
        self._project.addMapLayer(layer, False)
        return group.insertLayer(0, layer)

    def _group(self) -> QgsLayerTreeGroup:
        """On top of all layers."""
        root = self._project.layerTreeRoot()
        for older in root.findGroups():
            if older.name() == self._title:  # else two pictures and twice the labels lie on top of each other
                older.setItemVisibilityChecked(False)
        group = root.insertGroup(0, self._title)
        group.setExpanded(True)
        return group

    def _parent_of(self, layer: QgsMapLayer) -> QgsLayerTreeGroup | None:
        """The group that a layer is in; None where that is the whole tree."""
        node = self._project.layerTreeRoot().findLayer(layer.id())
        group = node.parent() if node is not None else None
        return group if group is not None and group is not self._project.layerTreeRoot() else None


def show_layer(project: QgsProject, layer: QgsMapLayer) -> None:
    """On the map, whatever group it is in."""
    node = project.layerTreeRoot().findLayer(layer.id())
    if node is not None:
        node.setItemVisibilityCheckedParentRecursive(True)


def worst_layer(project: QgsProject, mosaic: str) -> QgsVectorLayer | None:
    """The worst windows of the last scan of a mosaic layer, while the project has them."""
    found = [
        layer for layer in project.mapLayers().values()
        if isinstance(layer, QgsVectorLayer) and layer.isValid() and layer.customProperty(_MOSAIC) == mosaic
    ]
    return max(found, key=lambda layer: str(layer.customProperty(_SCANNED)), default=None) if mosaic else None


def _opening_job(done: ScanDone) -> Job:
    """Opens what a scan left; yields each layer that is there and what table it is of, the lowest first."""

    def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        interface = QgsApplication.instance().thread()
        makers = [
            (partial(_picture, done.files.picture, tr("Picture of losses")), None),
            *((partial(_table, done.files.layers, kind, title), kind) for kind, title in (
                (scan_layers.CELLS, tr("Source cells")), (scan_layers.SEAMS, tr("Seams")),
                (scan_layers.WORST, tr("Worst places")),
            )),
        ]
        for number, (make, kind) in enumerate(makers, 1):
            layer = make()
            if layer.isValid():
                layer.moveToThread(interface)
                yield number / len(makers), (layer, kind)

    return job


def _picture(path: Path, title: str) -> QgsRasterLayer:
    options = QgsRasterLayer.LayerOptions()
    options.loadDefaultStyle = False  # which would look for the least and the largest value of every band
    layer = QgsRasterLayer(str(path), title, "gdal", options)
    if layer.isValid():
        load_style(layer, "loss")
    return layer


def _table(path: Path, kind: ScanLayer, title: str) -> QgsVectorLayer:
    layer = QgsVectorLayer(f"{path}|layername={kind.name}", title, "ogr")
    if layer.isValid():
        load_style(layer, kind.style)
    return layer
