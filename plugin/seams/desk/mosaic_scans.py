"""Scans the whole mosaic in the background: what is asked for, how far it is, its layers on the map, what it found."""
from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from functools import partial
from html import escape
from itertools import chain, count
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import (
    Qgis,
    QgsApplication,
    QgsLayerTreeGroup,
    QgsLayerTreeLayer,
    QgsMapLayer,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
)
from qgis.gui import QgsMessageBar, QgsMessageBarItem
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QDateTime, QObject, Qt, pyqtSignal
from qgis.PyQt.QtWidgets import QPushButton

from ...imagery.errors import INFO, Message, SeamInspectorError
from ...toolkit.background_tasks import BackgroundTasks, Cancelled, End, Job, Outcome
from ...toolkit.desk.message_bar import bar_level, write_log
from ...toolkit.desk.widgets import single_shot
from ...toolkit.layer_styles import load_style
from ...toolkit.reference_systems import keep_system
from ...toolkit.translation import filled, grouped_number, sentence, tr
from ..jobs import ScanDone, ScanFiles, ScanNews, ScanOrder, scan_job, time_left
from ..measure import messages
from ..measure.scan.whole_scan import JOURNAL_ENDING
from ..tables import scan_layers
from ..tables.scan_layers import ScanLayer

if TYPE_CHECKING:
    from .session import Session

_KEY = "scan"
_NOTES_IN_BAR = 2
_LONGEST_NAME = 50  # letters: with four bytes for each there is room for our endings


class MosaicScans(QObject):
    """One scan at a time. One that was stopped, in whatever way, goes on when it is started again."""

    changed = pyqtSignal()
    """A scan has begun or ended, or is as far as ``news`` says."""
    told = pyqtSignal(str, int)
    """A sentence and its Qgis.MessageLevel as int."""
    found = pyqtSignal(object)
    """A ScanDone whose layers are on the map."""

    def __init__(self, session: Session, parent: QObject) -> None:
        super().__init__(parent)
        self._session = session
        self._project = QgsProject.instance()
        self._group = ScanGroup(self._project, self)
        self._group.complete.connect(self.found)
        self._background = BackgroundTasks(self)
        self._background.failed.connect(self._tell)
        self._background.ended.connect(self._ended)
        self._is_closed = False
        self._notes = 0
        """Warnings about the scan, all of which are in the log."""
        self.news: ScanNews | None = None
        """How far the scan is; None while there is none."""
        self._project.cleared.connect(self._forget)

    @property
    def is_busy(self) -> bool:
        """Whether a scan is under way, and not being stopped."""
        return self.news is not None

    def why_not(self) -> str:
        """Why no scan can be started now; empty when one can."""
        if self.is_at_work:
            return tr("A scan is under way; it can be stopped below.")
        try:
            self._session.scan_order()
        except SeamInspectorError as error:
            return sentence(error.message)
        return ""

    @property
    def is_at_work(self) -> bool:
        """Whether a scan is under way or being stopped, or its layers are being opened."""
        return self.is_busy or self._group.is_busy or self._background.is_under_way(_KEY)

    def start(self) -> None:
        """Scan the mosaic; a scan of the same inputs that was stopped goes on."""
        if self.is_at_work:
            return
        try:
            order = self._session.scan_order()
        except SeamInspectorError as error:
            self._tell(error.message)
            return
        files = self._files(order)
        name = self._session.mosaic_layer()
        title = filled(tr("Scan of {mosaic}"), mosaic=name.name() if name is not None else order.mosaic.ref.name)
        self._group.begin(title, self._session.inputs.mosaic, files)
        self.news, self._notes = ScanNews(0.0, None), 0
        self._background.start(tr("Scan the mosaic"), scan_job(order, files), self._take, _KEY, steps=1)
        self.changed.emit()

    def stop(self) -> None:
        """What is measured stays, on the map and for a scan that goes on."""
        self._background.stop()

    def close(self) -> None:
        """Stop, and let go of project and map; once is enough."""
        if self._is_closed:
            return
        self._is_closed = True
        self._project.cleared.disconnect(self._forget)
        self._background.close()
        self._group.close()
        self.news = None

    def worst_layer(self) -> QgsVectorLayer | None:
        """The worst windows of the mosaic's last scan."""
        return worst_layer(self._project, self._session.inputs.mosaic)

    def progress(self) -> str:
        """``Scan: 42 %, some 4 min left``."""
        if self.news is None:
            return ""
        if not self.news.measured:
            return filled(tr("Scan: putting the blocks together, {percent} %"), percent=int(100 * self.news.share))
        text = filled(tr("Scan: {percent} %"), percent=int(100 * self.news.share))
        left = self.news.seconds_left
        return text if left is None else f"{text}, {time_left(left)}"

    def _files(self, order: ScanOrder) -> ScanFiles:
        """Beside the project; those of a scan that is not complete are taken again."""
        folder = Path(self._project.homePath() or QgsApplication.qgisSettingsDirPath())
        name = file_stem(order.mosaic.ref.name)
        for ending in chain([""], (f"_{number}" for number in count(2))):
            picture, so_far = (folder / f"{name}_loss{ending}{part}.tif" for part in ("", "_so_far"))
            files = ScanFiles(picture, folder / f"{name}_scan{ending}.gpkg", so_far)
            if _is_ours(files):
                break
        return files

    def _take(self, result: Any) -> None:
        if isinstance(result, ScanNews):
            if result.earlier is not None:
                self._tell(result.earlier)
            self._note(result.notices)
            self.news = result
            if result.has_picture:
                self._group.show_so_far()
        elif isinstance(result, ScanDone):
            self._note(result.notices)
            self._group.finish(result)
        self.changed.emit()

    def _ended(self, _key: object, outcome: Outcome) -> None:
        self.news = None
        if outcome.end is not End.DONE:
            self._group.rest()
        if outcome.end is End.CANCELLED:
            self._tell(messages.SCAN_STOPPED())
        self.changed.emit()

    def _forget(self) -> None:
        """The project is closed: its scan goes on when it is open again, and asked for."""
        self._background.abandon()
        self._group.abandon()
        self.news = None
        self.changed.emit()

    def _note(self, notices: Iterable[Message]) -> None:
        """In the log, since there may be one for each block; the first of those that matter in the bar, too."""
        for notice in notices:
            write_log([notice])
            if notice.level is not INFO:
                self._notes += 1
                if self._notes <= _NOTES_IN_BAR:
                    self._tell(notice)

    def _tell(self, message: Message) -> None:
        self.told.emit(sentence(message), bar_level(message))


def scan_sentence(done: ScanDone) -> str:
    """What a scan found."""
    words = tr("Scanned: no seam was found.")
    if done.seam_metres:
        words = tr("No significant loss on {metres} m of seams.")
        if done.failed_metres:
            words = tr("Significant loss on {failed} of {metres} m of seams.")
    return filled(words, metres=grouped_number(done.seam_metres), failed=grouped_number(done.failed_metres))


def file_stem(name: str) -> str:
    """What the names of files about a mosaic begin with."""
    return re.sub(r"[^\w.-]+", "_", Path(name).stem).lstrip("-.")[:_LONGEST_NAME]  # a table begins with neither


def _is_ours(files: ScanFiles) -> bool:
    """Whether nobody asked has to lose anything by them: none is there, or those of a scan that is not complete."""
    if os.path.lexists(files.layers) or any(os.path.islink(one) for one in (files.picture, files.so_far)):
        return False
    journal = files.picture.with_name(files.picture.name + JOURNAL_ENDING)
    return journal.is_dir() or not files.picture.exists()


_REPAINT_MS = 1000
_SCANNED, _MOSAIC = "seam_inspector/scanned", "seam_inspector/mosaic"
"""Custom properties of the layer of worst windows: when they were found, and in which mosaic layer."""


class ScanGroup(QObject):
    """The layers of one scan at a time. Its results are opened in the background: for a large picture QGIS takes a
    quarter of a second, as it looks for its least and largest values whatever its style is."""

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
        keep_system(layer)
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


def uncover(project: QgsProject, layer: QgsMapLayer) -> None:
    """Take the pictures of a scan off the map where its windows are to be looked at: they hide what is judged."""
    root = project.layerTreeRoot()
    node = root.findLayer(layer.id())
    if node is not None and node.parent() not in (None, root):
        for beside in node.parent().findLayers():
            if isinstance(beside.layer(), QgsRasterLayer):
                beside.setItemVisibilityChecked(False)


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


class ScanMessage(QObject):
    """Says how much was lost, and offers the worst places until they are taken, or the project closes."""

    def __init__(self, bar: QgsMessageBar, judge: Callable[[], None], parent: QObject) -> None:
        super().__init__(parent)
        self._bar, self._judge = bar, judge
        self._item: QgsMessageBarItem | None = None
        QgsProject.instance().cleared.connect(self.dismiss)

    def show(self, done: ScanDone) -> None:
        """Say it, in the place of what was said of a scan before."""
        self.dismiss()
        item = self._bar.createMessage(tr("Seam Inspector"), escape(scan_sentence(done), quote=False))
        if done.worst_count:
            words = tr("Judge the {count} worst") if done.worst_count > 1 else tr("Judge the worst")
            button = QPushButton(filled(words, count=done.worst_count), item)
            button.setToolTip(tr("Inspects the windows of the worst places; Next (N) leads through them, worst first."))
            button.clicked.connect(self._go_on)
            item.layout().addWidget(button)
        self._item = item
        self._bar.pushWidget(item, Qgis.MessageLevel.Warning if done.failed_metres else Qgis.MessageLevel.Success, 0)

    def close(self) -> None:
        """Leave nothing in the bar and follow the project no more."""
        QgsProject.instance().cleared.disconnect(self.dismiss)
        self.dismiss()

    def dismiss(self) -> None:
        """Leave nothing in the bar."""
        if self._item is not None and not sip.isdeleted(self._item):
            self._bar.popWidget(self._item)
        self._item = None

    def _go_on(self) -> None:
        self.dismiss()
        self._judge()
