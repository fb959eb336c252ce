"""What a scan found, in QGIS's message bar, with the button that goes on from there."""
from __future__ import annotations

from collections.abc import Callable

from qgis.core import Qgis, QgsProject
from qgis.gui import QgsMessageBar, QgsMessageBarItem
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtWidgets import QPushButton

from ....toolkit.translation import tr
from ...scan_job import ScanDone
from .mosaic_scans import scan_sentence


class ScanMessage(QObject):
    """One at a time; it stays until it is answered or dismissed, or the project is closed."""

    def __init__(self, bar: QgsMessageBar, judge: Callable[[], None], parent: QObject) -> None:
        super().__init__(parent)
        self._bar, self._judge = bar, judge
        self._item: QgsMessageBarItem | None = None
        QgsProject.instance().cleared.connect(self.dismiss)

    def show(self, done: ScanDone, notes: int) -> None:
        """Say it, and how many warnings are in the log."""
        self.dismiss()
        item = self._bar.createMessage(tr("Seam Inspector"), scan_sentence(done, notes))
        if done.worst_count:
            words = tr("Judge the {count} worst") if done.worst_count > 1 else tr("Judge the worst")
            button = QPushButton(words.format(count=done.worst_count), item)
            button.setToolTip(tr("Inspects the windows of the worst places; Next (N) leads through them, worst first."))
            button.clicked.connect(self._answer)
            item.layout().addWidget(button)
        level = Qgis.MessageLevel.Warning if done.failed_metres else Qgis.MessageLevel.Success
        self._item = item
        self._bar.pushWidget(item, level, 0)

    def close(self) -> None:
        """Leave nothing behind."""
        QgsProject.instance().cleared.disconnect(self.dismiss)
        self.dismiss()

    def dismiss(self) -> None:
        """Leave nothing in the bar."""
        item, self._item = self._item, None
        if item is not None and not sip.isdeleted(item):
            self._bar.popWidget(item)

    def _answer(self) -> None:
        self.dismiss()
        self._judge()
