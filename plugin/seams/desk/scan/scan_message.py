"""What a scan found, in QGIS's message bar, with the button that goes on from there."""
from __future__ import annotations

from collections.abc import Callable

from qgis.core import Qgis
from qgis.gui import QgsMessageBar
from qgis.PyQt.QtCore import QObject

from ....toolkit.desk.message_bar import BarQuestion
from ....toolkit.translation import filled, tr
from ...scan_job import ScanDone
from .mosaic_scans import scan_sentence


class ScanMessage(BarQuestion):
    """Says how much was lost, and offers the worst places."""

    def __init__(self, bar: QgsMessageBar, judge: Callable[[], None], parent: QObject) -> None:
        super().__init__(bar, parent)
        self._judge = judge

    def show(self, done: ScanDone, notes: int) -> None:
        """Say it, and how many warnings are in the log."""
        level = Qgis.MessageLevel.Warning if done.failed_metres else Qgis.MessageLevel.Success
        words = tr("Judge the {count} worst") if done.worst_count > 1 else tr("Judge the worst")
        self.ask(
            scan_sentence(done, notes), level, filled(words, count=done.worst_count),
            tr("Inspects the windows of the worst places; Next (N) leads through them, worst first."),
            self._judge if done.worst_count else None,
        )  # fmt: skip
