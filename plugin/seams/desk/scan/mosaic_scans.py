"""Scans the whole mosaic in the background: what is asked for, how far it is, and what it found."""
from __future__ import annotations

import os
import re
from collections.abc import Iterable
from itertools import chain, count
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsApplication, QgsProject, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.errors import INFO, Message, SeamInspectorError
from ....toolkit.background_tasks import BackgroundTasks, End, Outcome
from ....toolkit.desk.message_bar import bar_level, write_log
from ....toolkit.translation import filled, sentence, shown_number, tr
from ...measure.scan import messages
from ...measure.scan.whole_scan import JOURNAL_ENDING
from ...scan_job import ScanDone, ScanFiles, ScanNews, ScanOrder, scan_job
from ...scan_words import time_left
from .scan_group import ScanGroup, worst_layer

if TYPE_CHECKING:
    from ..session import Session

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
        self.notes = 0
        """Warnings about the scan, all of which are in the log."""
        self.news: ScanNews | None = None
        """How far the scan is; None while there is none."""
        self._project.cleared.connect(self._forget)

    @property
    def is_busy(self) -> bool:
        """Whether a scan is under way, and not being stopped."""
        return self.news is not None

    @property
    def can_start(self) -> bool:
        """Whether the inputs allow a scan, and none is under way."""
        return not self.why_not()

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
        self.news, self.notes = ScanNews(0.0, None), 0
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
        name = re.sub(r"[^\w.-]+", "_", Path(order.mosaic.ref.name).stem)[:_LONGEST_NAME]
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
                self.notes += 1
                if self.notes <= _NOTES_IN_BAR:
                    self._tell(notice)

    def _tell(self, message: Message) -> None:
        self.told.emit(sentence(message), bar_level(message))


def scan_sentence(done: ScanDone, notes: int = 0) -> str:
    """What a scan found, and how many warnings are in the log."""
    words = tr("Scanned: no seam was found.")
    if done.seam_metres:
        words = tr("Scanned {metres} m of seams: no significant loss")
        if done.failed_metres:
            words = tr("Scanned {metres} m of seams: significant loss on {failed} m")
        words = filled(words,
            metres=shown_number(done.seam_metres, 0), failed=shown_number(done.failed_metres, 0)
        ) + "."
    return f"{words} " + filled(tr("Notes in the log: {count}."), count=notes) if notes else words


def _is_ours(files: ScanFiles) -> bool:
    """Whether nobody asked has to lose anything by them: none is there, or those of a scan that is not complete."""
    if os.path.lexists(files.layers) or any(os.path.islink(one) for one in (files.picture, files.so_far)):
        return False
    journal = files.picture.with_name(files.picture.name + JOURNAL_ENDING)
    return journal.is_file() or not files.picture.exists()
