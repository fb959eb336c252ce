"""Pictures of the desk's charts on white paper, and the button that saves one."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from qgis.core import Qgis, QgsApplication
from qgis.PyQt.QtCore import QRectF, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QPainter
from qgis.PyQt.QtWidgets import QFileDialog, QToolButton, QWidget

from ....imagery.atomic_files import replacing
from ....imagery.errors import SettingsError
from ....toolkit.charts.chart_painter import chart_image, chart_svg, paper_font
from ....toolkit.charts.chart_style import PAPER
from ....toolkit.desk.widgets import check_chosen_file
from ....toolkit.translation import filled, sentence, tr
from ...charts.chart_curves import Chart
from ...charts.curves_painter import LegendedCurves
from ...charts.profile_painter import ProfilePainter, ShownProfile

_CURVES_SIZE, _PROFILE_SIZE = (700, 420), (560, 340)  # px of a picture
_DOTS = 3  # a side of each pixel
_LETTERS_PX = 13.9  # 10 points


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
    """Curves as they are shown, with their title, on white paper."""
    room = QRectF(0, 0, *_CURVES_SIZE)
    curves = LegendedCurves(chart, room.adjusted(0, 1.8 * _LETTERS_PX, 0, 0), PAPER, paper_font(_LETTERS_PX))

    def paint(painter: QPainter) -> None:
        curves.paint(painter)
        painter.setPen(QColor(PAPER.text))
        painter.setFont(curves.font)
        painter.drawText(QRectF(0, 0, room.width(), 2 * _LETTERS_PX), Qt.AlignmentFlag.AlignCenter, title)

    return ChartPicture(name, paint, _CURVES_SIZE)


def profile_picture(name: str, shown: ShownProfile) -> ChartPicture:
    """A seam profile as it is shown."""
    painter = ProfilePainter(shown, QRectF(0, 0, *_PROFILE_SIZE), PAPER, paper_font(12))
    return ChartPicture(name, painter.paint, _PROFILE_SIZE)
