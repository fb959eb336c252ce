"""Pictures of the desk's charts on white paper, and the button that saves one."""
from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from qgis.core import Qgis, QgsApplication
from qgis.PyQt.QtCore import QRectF, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QFontMetricsF, QPainter
from qgis.PyQt.QtWidgets import QFileDialog, QToolButton, QWidget

from ....imagery.atomic_files import replacing
from ....imagery.errors import SettingsError, printable
from ....toolkit.charts.chart_painter import chart_image, chart_svg, paper_font
from ....toolkit.charts.chart_style import PAPER
from ....toolkit.desk.widgets import check_chosen_file
from ....toolkit.translation import filled, sentence, tr
from ...charts.chart_curves import Chart, numbered, significance_limit
from ...charts.curves_painter import CurvesPainter, PenStyle, curve_look, paint_piece
from ...charts.profile_painter import ProfilePainter, ShownProfile

_CURVES_SIZE, _PROFILE_SIZE = (700, 420), (560, 340)  # px of a picture
_DOTS = 3  # a side of each pixel
_TITLE_PX = 15
_LETTERS_PX, _LEGEND_PX = 13.9, 11.1  # 10 and 8 points
_GAP_PX = 8
_PIECE_PX = 26, 16  # width and height of a line's piece in the legend of a picture


@dataclass(frozen=True)
class ChartPicture:
    """What is to be saved."""

    name: str  # of the file, without its ending
    paint: Callable[[QPainter], None]
    size: tuple[int, int]  # on how many px


class PictureButton(QToolButton):
    """Saves what was shown when it was clicked, whatever comes while the dialog is open."""

    notified = pyqtSignal(str, int)  # sentence, Qgis.MessageLevel as int

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._folder = Path.home()  # where the last one was saved
        self._picture: ChartPicture | None = None
        self.setIcon(QgsApplication.getThemeIcon("/mActionSaveMapAsImage.svg"))
        self.setToolTip(tr("Save the chart as a picture (PNG or SVG)"))
        self.setAutoRaise(True)
        self.setEnabled(False)
        self.clicked.connect(self.save)

    def offer(self, picture: ChartPicture | None) -> None:
        """What there is to save from now on."""
        self._picture = picture
        self.setEnabled(picture is not None)

    def save(self, *_: object) -> None:
        """Ask where, save, and tell it."""
        picture = self._picture
        assert picture is not None
        kinds = ";;".join((tr("PNG picture") + " (*.png)", tr("SVG picture") + " (*.svg)"))
        suggested = str(self._folder / f"{picture.name}.png")
        chosen, kind = QFileDialog.getSaveFileName(self, tr("Save picture"), suggested, kinds)
        if not chosen:
            return
        path = Path(chosen)
        if path.suffix.lower() not in (".png", ".svg"):
            path = Path(f"{chosen}.{'svg' if 'svg' in kind else 'png'}")
        self._folder = path.parent
        try:
            check_chosen_file(path)
            with replacing(path) as unfinished:
                if path.suffix.lower() == ".svg":
                    unfinished.write_text(chart_svg(picture.paint, *picture.size), encoding="utf-8")
                elif not chart_image(picture.paint, *picture.size, _DOTS).save(str(unfinished), "PNG"):
                    raise OSError(tr("it can't be written"))
        except SettingsError as error:
            said, level = sentence(error.message), Qgis.MessageLevel.Warning
        except OSError as error:
            text = tr("The picture was not saved to {path}: {error}. Choose another folder.")
            said, level = filled(text, path=path, error=error.strerror or error), Qgis.MessageLevel.Warning
        else:
            said, level = filled(tr("The picture was saved to {path}."), path=path), Qgis.MessageLevel.Success
        self.notified.emit(said, int(level))


def curves_picture(name: str, chart: Chart, title: str) -> ChartPicture:
    """Curves as they are shown."""
    return ChartPicture(name, CurvesPicture(chart, title).paint, _CURVES_SIZE)


def profile_picture(name: str, shown: ShownProfile) -> ChartPicture:
    """A seam profile as it is shown."""
    painter = ProfilePainter(shown, QRectF(0, 0, *_PROFILE_SIZE), PAPER, paper_font(12))
    return ChartPicture(name, painter.paint, _PROFILE_SIZE)


class CurvesPicture:
    """Curves as they are shown, hidden ones left out, with title and legend, on white paper."""

    def __init__(self, chart: Chart, title: str) -> None:
        self._title, self._title_font, self._font = title, paper_font(_TITLE_PX), paper_font(_LEGEND_PX)
        self._title_font.setBold(True)
        self.entries: list[tuple[str, str, PenStyle, tuple[float, float]]] = []
        """Entries of the legend: name, colour and dashes of the line, its width and the radius of its points."""
        for number, curve in numbered(chart.curves):
            if curve.key not in chart.hidden:
                size = (0.22, 0.26) if curve.is_mosaic else (0.1, 0.17)
                self.entries.append((printable(curve.label), *curve_look(curve, number, PAPER), size))
        if significance_limit(chart.curves, chart.max_ratio) is not None:
            self.entries.append((tr("significant loss below"), PAPER.limit, Qt.PenStyle.SolidLine, (0.17, 0.0)))
        widest = max((QFontMetricsF(self._font).horizontalAdvance(name) for name, *_ in self.entries), default=0.0)
        width, height = _CURVES_SIZE
        self._legend = QRectF(0, 0, min(widest + _PIECE_PX[0] + 2 * _GAP_PX, width / 2), 1.05 * _PIECE_PX[1])
        self._legend.moveRight(width)
        room = QRectF(0, 1.6 * _TITLE_PX, self._legend.left(), height - 1.6 * _TITLE_PX)
        self._chart = CurvesPainter(chart, room, PAPER, paper_font(_LETTERS_PX))

    def paint(self, painter: QPainter) -> None:
        """On ``_CURVES_SIZE`` px."""
        self._chart.paint(painter)
        axes = self._chart.axes
        painter.setPen(QColor(PAPER.text))
        painter.setFont(self._title_font)
        title = axes.adjusted(-axes.width(), 0, axes.width(), 0)  # whatever its length, above their middle
        title.setCoords(title.left(), 0, title.right(), 2 * _TITLE_PX)
        painter.drawText(title, Qt.AlignmentFlag.AlignCenter, self._title)
        painter.setFont(self._font)
        row = QRectF(self._legend)
        row.moveTop(axes.center().y() - len(self.entries) * row.height() / 2)
        for name, colour, dashes, size in self.entries:
            piece = QRectF(row.left(), row.top(), *_PIECE_PX)
            paint_piece(painter, piece, QColor(colour), dashes, *size)
            painter.setPen(QColor(PAPER.text))
            words = row.adjusted(_PIECE_PX[0] + _GAP_PX, 0, 0, 0)
            fitting = painter.fontMetrics().elidedText(name, Qt.TextElideMode.ElideMiddle, math.ceil(words.width()))
            painter.drawText(words, Qt.AlignmentFlag.AlignVCenter, fitting)
            row.translate(0, row.height())
