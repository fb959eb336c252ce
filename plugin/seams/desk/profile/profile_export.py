"""The button that saves and copies a seam profile."""
from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from math import isinf
from pathlib import Path
from typing import TYPE_CHECKING, Callable

from qgis.PyQt.QtCore import QRectF, Qt
from qgis.PyQt.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter
from qgis.PyQt.QtWidgets import QApplication, QWidget

from ....imagery.atomic_files import replacing
from ....toolkit.charts.chart_style import PAPER
from ....toolkit.translation import tr
from ...charts.profile_scale import ShownProfile
from ..export_button import ExportButton
from .profile_painter import ProfilePainter

if TYPE_CHECKING:
    from ...measure.window.window_result import WindowResult

COLUMNS = ("window_id", "level", "from", "to", "kept", "low", "high", "area", "mixture")
"""Distances in m, area in m2; the mixture is the share of the image beyond the seam."""
_WIDTH, _HEIGHT, _SCALE = 560, 340, 3  # px of a picture, and how many dots each is


class ProfileExport(ExportButton):
    """Offers pictures of the chart and a table of its bins."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Save or copy the seam profile: as a picture, or as a table of all levels"), parent)
        self._result: WindowResult | None = None
        self._shown: ShownProfile | None = None
        self._offer_formats((
            ("mActionSaveMapAsImage", tr("Save as PNG..."), tr("The picture, for documents"), self.save_png),
            ("mActionOpenTable", tr("Save as CSV..."), tr("All levels and distances"), self.save_csv),
            ("mActionEditCopy", tr("Copy picture"), tr("To the clipboard"), self.copy_picture),
            ("mActionEditCopy", tr("Copy values"), tr("To the clipboard, for a spreadsheet"), self.copy_values),
        ))

    def offer(self, result: WindowResult | None, shown: ShownProfile | None) -> None:
        """What there is to export from now on; without a result nothing."""
        self._result, self._shown = result, shown
        self.setEnabled(result is not None and shown is not None)

    def save_png(self) -> None:
        """Ask where and save the picture."""
        shown = self._shown
        if shown is not None:
            self._save("png", tr("PNG picture"), lambda path: _save_image(picture(shown), path))

    def save_csv(self) -> None:
        """Ask where and save the values."""
        result = self._result
        if result is not None:
            self._save("csv", tr("Table with commas"), lambda path: _save_table(table_text(result, ","), path))

    def copy_picture(self) -> None:
        """The picture to the clipboard."""
        if self._shown is not None:
            QApplication.clipboard().setImage(picture(self._shown))

    def copy_values(self) -> None:
        """The values to the clipboard."""
        if self._result is not None:
            QApplication.clipboard().setText(table_text(self._result, "\t"))

    def _save(self, ending: str, kind: str, write: Callable[[Path], None]) -> None:
        number = self._result.window_id if self._result is not None else 0
        path = self._ask(tr("Save seam profile"), f"window_{number}_profile", ending, kind)
        if path is not None:
            self._write(
                write, path, tr("The seam profile was saved to {path}."),
                tr("The seam profile was not saved to {path}: {error}. Choose another folder."),
            )  # fmt: skip


def picture(shown: ShownProfile) -> QImage:
    """The chart on white paper, for a report."""
    image = QImage(_WIDTH * _SCALE, _HEIGHT * _SCALE, QImage.Format.Format_ARGB32)
    image.fill(QColor(Qt.GlobalColor.white))
    painter = QPainter(image)
    painter.scale(_SCALE, _SCALE)
    font = QFont(QApplication.font())
    font.setPixelSize(12)
    painter.setFont(font)
    ProfilePainter(shown, QRectF(0, 0, _WIDTH, _HEIGHT), PAPER, QFontMetricsF(font)).paint(painter)
    painter.end()
    return image


def table_text(result: WindowResult, delimiter: str) -> str:
    """One row per bin; the last one of a level has no end."""
    buffer = io.StringIO()
    writer = csv.writer(buffer, delimiter=delimiter, lineterminator="\n")
    writer.writerow(COLUMNS)
    writer.writerows(_rows(result))
    return buffer.getvalue()


def _rows(result: WindowResult) -> Iterator[tuple[object, ...]]:
    metres = result.ground_sample_distance
    for one in result.profile.bins if result.profile is not None else ():
        far = "" if isinf(one.far_px) else f"{one.far_px * metres:.6g}"
        numbers = (f"{value:.6g}" for value in (one.kept, one.low, one.high, one.area_px * metres**2))
        mixture = "" if one.mixture is None else f"{one.mixture:.6g}"
        yield (result.window_id, one.level, f"{one.near_px * metres:.6g}", far, *numbers, mixture)


def _save_image(image: QImage, path: Path) -> None:
    with replacing(path) as unfinished:
        if not image.save(str(unfinished), "PNG"):
            raise OSError(tr("the picture could not be written"))


def _save_table(text: str, path: Path) -> None:
    with replacing(path) as unfinished:
        unfinished.write_text(text, encoding="utf-8")
