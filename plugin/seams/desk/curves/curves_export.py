"""The button that saves and copies the curves."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from qgis.PyQt.QtGui import QImage
from qgis.PyQt.QtWidgets import QApplication, QWidget

from ....toolkit.translation import band_title, tr
from ..export_button import ExportButton

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...measure.window.window_result import WindowResult
    from .curves_painter import Chart


class CurvesExport(ExportButton):
    """Offers pictures of the chart and tables of its windows."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Save or copy what is shown: as a picture, or as a table of all values"), parent)
        self._results: list[WindowResult] = []
        self._chart: Chart | None = None
        self._title = self._band = ""
        self._offer_formats((
            ("mActionSaveMapAsImage", tr("Save as PNG..."), tr("The picture, for documents"), self.save_png),
            ("mActionSaveAsSVG", tr("Save as SVG..."), tr("The picture, sharp at every size"), self.save_svg),
            ("mActionOpenTable", tr("Save as CSV..."), tr("All rasters and bands of the windows"), self.save_csv),
            ("mActionEditCopy", tr("Copy picture"), tr("To the clipboard"), self.copy_picture),
            ("mActionEditCopy", tr("Copy values"), tr("To the clipboard, for a spreadsheet"), self.copy_values),
        ))

    def offer(self, results: Sequence[WindowResult], chart: Chart | None, title: str, band: str) -> None:
        """What there is to export from now on; without results nothing."""
        self._results, self._chart, self._title, self._band = list(results), chart, title, band
        self.setEnabled(bool(results))

    def save_png(self) -> None:
        """Ask where and save the picture."""
        self._save("png", tr("PNG picture"))

    def save_svg(self) -> None:
        """Ask where and save the picture."""
        self._save("svg", tr("SVG picture"))

    def save_csv(self) -> None:
        """Ask where and save the values."""
        self._save("csv", tr("Table with commas"))

    def copy_picture(self) -> None:
        """The picture to the clipboard."""
        from . import chart_export

        if self._chart is not None:
            png = chart_export.png_bytes(self._chart, self._full_title())
            QApplication.clipboard().setImage(QImage.fromData(png))

    def copy_values(self) -> None:
        """The values to the clipboard."""
        from . import chart_export

        QApplication.clipboard().setText(chart_export.table_text(self._results))

    def _save(self, ending: str, kind: str) -> None:
        """Ask where, and write what was shown when the user asked: results may come while the dialog is open."""
        from . import chart_export

        results, chart, title = self._results, self._chart, self._full_title()
        if chart is None:
            return
        which = f"window_{results[0].window_id}" if len(results) == 1 else f"{len(results)}_windows"
        path = self._ask(tr("Save curves"), f"{which}_{self._band}", ending, kind)
        if path is None:
            return

        def write(path: Path) -> None:
            if ending == "csv":
                chart_export.write_csv(results, path)
            else:
                chart_export.save_picture(chart, title, path)

        self._write(
            write, path, tr("The curves were saved to {path}."),
            tr("The curves were not saved to {path}: {error}. Choose another folder."),
        )  # fmt: skip

    def _full_title(self) -> str:
        return f"{self._title} ({band_title(self._band)})"
