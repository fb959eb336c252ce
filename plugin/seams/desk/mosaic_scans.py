"""Scans the whole mosaic in the background: what is asked for, how far it is, its layers on the map, what it found."""
from __future__ import annotations

import os
import re
from collections.abc import Callable, Sequence
from html import escape
from itertools import chain, count
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import Qgis, QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.gui import QgsMessageBar, QgsMessageBarItem
from qgis.PyQt.QtCore import QDateTime, QObject, Qt, pyqtSignal
from qgis.PyQt.QtGui import QCursor
from qgis.PyQt.QtWidgets import QPushButton, QWhatsThis

from ...imagery.errors import INFO, Message, SeamInspectorError
from ...imagery.seam_totals import STANDARD_LEAST_KEPT
from ...toolkit.background_tasks import BackgroundTasks, Outcome
from ...toolkit.connections import Connections
from ...toolkit.desk.tool_dock import bar_level, write_log
from ...toolkit.desk.widgets import rich_tip
from ...toolkit.layer_styles import load_style
from ...toolkit.reference_systems import keep_system
from ...toolkit.translation import filled, percent, sentence, tr
from ..jobs import ScanDone, ScanFiles, ScanNews, ScanOrder, scan_job, time_left
from ..measure import messages
from ..measure.scan.whole_scan import JOURNAL_ENDING
from ..tables import scan_layers
from ..tables.scan_layers import ScanLayer
from . import window_home
from .messages import SCAN_WITHOUT_MOSAIC

if TYPE_CHECKING:
    from .session import Session

_KEY = "scan"
_NOTES_IN_BAR = 2
_LONGEST_NAME = 50  # letters: with four bytes for each there is room for our endings


class MosaicScans(QObject):
    """One scan at a time. One that was stopped, in whatever way, goes on when it is started again."""

    changed = pyqtSignal()  # a scan has begun or ended, or is as far as ``news`` says
    notified = pyqtSignal(str, int)  # a sentence and its Qgis.MessageLevel as int
    scanned = pyqtSignal(object)  # a ScanDone whose layers are on the map

    def __init__(self, session: Session, parent: QObject) -> None:
        super().__init__(parent)
        self._session = session
        self._project = QgsProject.instance()
        self._background = BackgroundTasks(self)
        self._background.failed.connect(self._tell)
        self._background.ended.connect(self._ended)
        self.warnings: list[Message] = []  # about the scan, which are in the log, too
        self.news: ScanNews | None = None  # how far the scan is; None while there is none
        self._mosaic = ""  # the layer that is scanned, while it is there
        self._connections = Connections((self._project.layersWillBeRemoved, self._leave_layers))

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
        """Whether a scan is under way or being stopped."""
        return self.news is not None or self._background.is_under_way(_KEY)

    def start(self) -> None:
        """Scan the mosaic; a scan of the same inputs that was stopped goes on."""
        if self.is_at_work:
            return
        try:
            order = self._session.scan_order()
        except SeamInspectorError as error:
            self._tell(error.message)
            return
        files, layer = self._files(order), self._session.mosaic_layer()
        mosaic = layer.name() if layer is not None else order.mosaic.ref.name
        self._title, self._mosaic = filled(tr("Scan of {mosaic}"), mosaic=mosaic), self._session.inputs.mosaic
        self.news, self.warnings = ScanNews(0.0, None), []
        self._background.start(tr("Scan the mosaic"), scan_job(order, files), self._take, _KEY, steps=1)
        self.changed.emit()

    def stop(self) -> None:
        """What is measured stays, for a scan that goes on."""
        self._background.stop()

    def close(self) -> None:
        """Stop, and let go of project and map; once is enough."""
        self._connections.close()
        self._background.close()
        self.news = None

    def worst_layer(self) -> QgsVectorLayer | None:
        """The worst windows of the mosaic's last scan."""
        return worst_layer(self._project, self._session.inputs.mosaic)

    def progress(self) -> str:
        """``Scan: 42 %, some 4 min left``."""
        if self.news is None:
            return ""
        if not self.news.measured:
            return tr("Scan: putting the blocks together")
        text = filled(tr("Scan: {percent} %"), percent=int(100 * self.news.share))
        seconds_left = self.news.seconds_left
        return text if seconds_left is None else f"{text}, {time_left(seconds_left)}"

    def _files(self, order: ScanOrder) -> ScanFiles:
        """Beside the project; those of a scan that is not complete are taken again."""
        folder = Path(self._project.homePath() or window_home.unsaved_folder())
        name = output_stem(order.mosaic.ref.name)
        for ending in chain([""], (f"_{number}" for number in count(2))):
            files = ScanFiles(folder / f"{name}_loss{ending}.tif", folder / f"{name}_scan{ending}.gpkg")
            if _is_ours(files):
                break
        return files

    def _take(self, result: Any) -> None:
        if isinstance(result, ScanNews):
            if result.earlier is not None:
                self._tell(result.earlier)
            self._note(result.notices, _NOTES_IN_BAR)
            self.news = result
        elif isinstance(result, ScanDone):
            self._note(result.notices)
            self._show(result)
        self.changed.emit()

    def _ended(self, _key: object, outcome: Outcome) -> None:
        self.news = None
        if outcome.is_cancelled:
            self._tell(messages.STOPPED() if self._mosaic else SCAN_WITHOUT_MOSAIC())
        self.changed.emit()

    def _forget(self) -> None:
        """The project is closed: its scan goes on when it is open again, and asked for."""
        self._background.abandon()
        self.news = None
        self.changed.emit()

    def _leave_layers(self, ids: list[str]) -> None:
        if len(ids) == self._project.count():  # the project closes, or there is nothing left to tell of
            self._forget()
        elif self._mosaic in ids:
            self._mosaic = ""
            self.stop()

    # What was found

    def _show(self, done: ScanDone) -> None:
        """A group on top of all layers, the windows of the worst places the topmost, and in it the picture the lowest.

        QGIS takes some 20 ms for each.
        """
        root = self._project.layerTreeRoot()
        before = self.worst_layer()  # of the scan that gives way: two pictures, and labels, would lie on each other
        older = None if before is None else root.findLayer(before)
        if older is not None and older.parent() != root:
            older.parent().setItemVisibilityChecked(False)
        group = root.insertGroup(0, self._title)
        group.setExpanded(True)
        file = done.files.layers
        worst, seams, cells = (
            _table(file, scan_layers.WORST, tr("Worst places")), _table(file, scan_layers.SEAMS, tr("Seams")),
            _table(file, scan_layers.CELLS, tr("Source cells")),
        )  # fmt: skip
        worst.setCustomProperty(_SCANNED, QDateTime.currentDateTime().toString(Qt.DateFormat.ISODateWithMs))
        picture = _picture(done.files.picture, tr("Picture of losses"))
        for layer in (worst, seams, cells, picture):
            if layer.isValid():
                keep_system(layer)
                layer.setCustomProperty(window_home.MADE_FOR, self._mosaic)
                self._project.addMapLayer(layer, False)
                node = group.addLayer(layer)
                node.setExpanded(layer in (seams, picture))
                node.setItemVisibilityChecked(layer is not worst)  # fifty windows would hide what they are of
        window_home.show_layers_of(self._project, self._session.inputs.mosaic)
        self.scanned.emit(done)

    def _note(self, notices: Sequence[Message], most_in_bar: int = 0) -> None:
        """Put them in the log, since there may be one for each block; those that matter behind *More*, but for what the
        scan's finding says, and the first ``most_in_bar`` of all in the bar, too."""
        write_log(notices)
        graver = [
            notice for notice in notices
            if notice.level is not INFO and notice.template != messages.SEAMS_WITHOUT_VERDICT.template
        ]  # fmt: skip
        for notice in graver[: max(most_in_bar - len(self.warnings), 0)]:
            self._tell(notice)
        self.warnings += graver

    def _tell(self, message: Message) -> None:
        self.notified.emit(sentence(message), bar_level(message))


def output_stem(name: str) -> str:
    """What the names of files about a mosaic begin with."""
    return re.sub(r"[^\w.-]+", "_", Path(name).stem).lstrip("-.")[:_LONGEST_NAME]  # a table begins with neither


def _is_ours(files: ScanFiles) -> bool:
    """Whether nobody asked has to lose anything by them: none is there, or those of a scan that is not complete."""
    if os.path.lexists(files.layers) or os.path.islink(files.picture):
        return False
    journal = files.picture.with_name(files.picture.name + JOURNAL_ENDING)
    return journal.is_dir() or not files.picture.exists()


_SCANNED = "seam_inspector/scanned"  # custom property of the layer of worst windows: when they were found


def uncover(project: QgsProject, mosaic: str) -> None:
    """Take the pictures of a mosaic's scans off the map where its windows are looked at: they hide what is judged."""
    for node in project.layerTreeRoot().findLayers():
        layer = node.layer()
        if isinstance(layer, QgsRasterLayer) and layer.customProperty(window_home.MADE_FOR) == mosaic:
            node.setItemVisibilityChecked(False)


def worst_layer(project: QgsProject, mosaic: str) -> QgsVectorLayer | None:
    """The worst windows of the last scan of a mosaic layer, while the project has them."""
    layers = [
        layer for layer in project.mapLayers().values()
        if isinstance(layer, QgsVectorLayer) and layer.isValid() and layer.customProperty(_SCANNED)
        and layer.customProperty(window_home.MADE_FOR) == mosaic
    ]
    return max(layers, key=lambda layer: str(layer.customProperty(_SCANNED)), default=None) if mosaic else None


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


def scan_message(
    bar: QgsMessageBar, done: ScanDone, warnings: Sequence[Message], judge: Callable[[], None]
) -> QgsMessageBarItem:
    """Say how much was lost or could not be measured, with what was told of the scan behind a button, and offer the
    worst places until they are taken, or the project closes."""
    item = bar.createMessage(escape(sentence(done.finding), quote=False))
    limit = filled(tr("A piece fails that keeps {percent} % or less."), percent=percent(STANDARD_LEAST_KEPT))
    notes = rich_tip(limit, *map(sentence, warnings))
    _add_button(item, tr("More"), notes, lambda: QWhatsThis.showText(QCursor.pos(), notes, bar))
    if done.worst_count:  # a longer word would leave no room for the sentence
        tip = tr("Inspects the windows of the worst places, and goes to the worst that is not judged yet.")
        _add_button(item, tr("Judge"), tip, judge).clicked.connect(item.dismiss)
    QgsProject.instance().cleared.connect(item.dismiss)
    bar.pushWidget(item, Qgis.MessageLevel.Success if done.finding.level is INFO else Qgis.MessageLevel.Warning, 0)
    return item


def _add_button(item: QgsMessageBarItem, text: str, tip: str, press: Callable[[], None]) -> QPushButton:
    button = QPushButton(text, item)
    button.setToolTip(tip)
    button.clicked.connect(lambda *_: press())
    item.layout().addWidget(button)
    return button
