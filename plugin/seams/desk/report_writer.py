"""Asks where the report of the inspected windows goes, and writes it in the background."""
from __future__ import annotations

from functools import partial
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import Qgis, QgsProject
from qgis.PyQt.QtCore import QObject, QUrl, pyqtSignal
from qgis.PyQt.QtWidgets import QFileDialog, QWidget

from ...imagery.errors import Message, SeamInspectorError
from ...toolkit.algorithms.outputs import check_chosen_file
from ...toolkit.background_tasks import BackgroundTasks
from ...toolkit.desk.tool_dock import bar_level
from ...toolkit.packages import missing_packages_sentence
from ...toolkit.translation import filled, sentence, tr

if TYPE_CHECKING:
    from .session import Session

_KEY = "report"


class ReportWriter(QObject):
    """One report at a time."""

    notified = pyqtSignal(str, int)  # a sentence, which may hold a link, and its Qgis.MessageLevel as int

    def __init__(self, session: Session, parent: QWidget) -> None:
        super().__init__(parent)
        self._session = session
        self._window = parent
        self._folder = Path()
        self._background = BackgroundTasks(self)
        self._background.failed.connect(self._failed)

    def ask(self) -> None:
        """Ask for the file, then write it; say so where what reports need is missing."""
        missing = missing_packages_sentence(pages=True)
        if missing:
            self.notified.emit(escape(missing, quote=False), int(Qgis.MessageLevel.Warning))
            return
        home = self._folder if self._folder.parts else Path(QgsProject.instance().homePath() or Path.home())
        kind = tr("HTML files (*.html)")
        chosen, _ = QFileDialog.getSaveFileName(
            self._window, tr("Save report"), str(home / tr("seam_inspection.html")), kind
        )
        if chosen:
            path = Path(chosen)
            self.write(path if path.suffix.lower() in (".html", ".htm") else path.with_name(path.name + ".html"))

    def write(self, path: Path) -> None:
        """Write the report of the windows as they are now."""
        from ..report.inspection_report import report_job
        from ..report.report_request import report_request

        session, project = self._session, QgsProject.instance()
        layer = session.window_layer()
        if layer is None or self._background.is_under_way(_KEY):
            return
        self._folder = path.parent
        try:
            check_chosen_file(path)
            request = report_request(
                session.windows(), session.result, layer.crs(), session.block(), session.inputs.max_ratio,
                session.inputs.min_kept, project,
            )
        except SeamInspectorError as error:
            self._failed(error.message)
            return
        compared = {record.window_id for record in request.records if record.is_compared}
        take = partial(self._take, path, len(request.records), len(compared - request.curves.keys()))
        self._background.start(tr("Write the report"), report_job(path, request), take, _KEY, steps=1)

    def close(self) -> None:
        """Cancel what is under way."""
        self._background.close()

    def _take(self, path: Path, windows: int, without: int, notices: Any) -> None:
        link = f'<a href="{escape(QUrl.fromLocalFile(str(path)).toString())}">{escape(path.name)}</a>'
        words = [filled(tr("Report of {count} windows: {link}."), count=windows, link=link)]
        if without:
            words.append(filled(tr("{count} have no curves in it: inspect them again."), count=without))
        words += [escape(sentence(notice), quote=False) for notice in notices]
        level = Qgis.MessageLevel.Warning if len(words) > 1 else Qgis.MessageLevel.Success
        self.notified.emit(" ".join(words), int(level))

    def _failed(self, message: Message) -> None:
        self.notified.emit(escape(sentence(message), quote=False), bar_level(message))
