"""The charts of the desk, which show plain data, and pictures of them in files."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from qgis.core import Qgis, QgsApplication
from qgis.PyQt.QtCore import QEvent, QPointF, QRectF, QSize, pyqtSignal
from qgis.PyQt.QtGui import QMouseEvent, QPainter, QPaintEvent
from qgis.PyQt.QtWidgets import QFileDialog, QSizePolicy, QToolButton, QToolTip, QWidget

from ....imagery.atomic_files import replacing
from ....imagery.errors import SettingsError
from ....toolkit.algorithms.outputs import check_chosen_file
from ....toolkit.charts.chart_painter import ChartPainter, chart_image, paper_font
from ....toolkit.charts.chart_style import PAPER
from ....toolkit.desk.theme import chart_style
from ....toolkit.desk.widgets import plain_tip
from ....toolkit.painting import painting
from ....toolkit.translation import filled, formatted, sentence, tr
from ...charts.curves_painter import Chart, LegendedCurves
from ...charts.profile_painter import ProfilePainter, ShownProfile

if TYPE_CHECKING:
    from ...measure.profile.seam_profile import ProfileBin

_NEAR_PX = 12  # that a point is pointed at from
_LEAST_PX = 150  # of height: in less, neither curves nor the limit and the interval can be told apart
_DIMMED = 0.35  # how much is left of a chart that is disabled


class ChartWidget(QWidget):
    """What a ``ChartPainter`` paints, in the colours of the theme; faint while it is disabled."""

    def __init__(self) -> None:
        super().__init__()
        self.setMinimumSize(11 * self.fontMetrics().height(), _LEAST_PX)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def sizeHint(self) -> QSize:
        return 2 * self.minimumSize()

    def painter(self) -> ChartPainter | None:
        """In the widget as it is now; None for nothing to be seen."""
        raise NotImplementedError

    def paintEvent(self, _event: QPaintEvent) -> None:
        chart = self.painter()
        if chart is not None:
            with painting(self) as painter:
                painter.setOpacity(1.0 if self.isEnabled() else _DIMMED)
                chart.paint(painter)


class CurvesChart(ChartWidget):
    """Shows a ``Chart``; a tip says the value of the point under the mouse."""

    chart: Chart | None = None  # what is seen

    def event(self, event: QEvent) -> bool:
        painter, chart = self.painter(), self.chart
        if event.type() == QEvent.Type.ToolTip and painter is not None and chart is not None and painter.places:
            at = QPointF(event.pos())
            (index, component), place = min(painter.places.items(), key=lambda item: (item[1] - at).manhattanLength())
            if (place - at).manhattanLength() <= _NEAR_PX:
                curve = chart.curves[index]
                is_detail = component < len(curve.detail)
                level = filled(tr("level {number}"), number=component + 1) if is_detail else tr("background")
                words = f"{curve.label}, {level}: {formatted(curve.values[component], '.3g')}"
                QToolTip.showText(self.mapToGlobal(event.pos()), plain_tip(words), self)
                return True
        return super().event(event)

    def painter(self) -> LegendedCurves | None:
        if self.chart is None:
            return None
        return LegendedCurves(self.chart, QRectF(self.rect()), chart_style(self), self.font())

    def show_chart(self, chart: Chart) -> None:
        """Paint a chart."""
        self.chart = chart
        self.update()


class ProfileChart(ChartWidget):
    """Shows one profile; points at a ``ProfileBin``."""

    pointed = pyqtSignal(object)  # what the mouse points at; None when it is elsewhere

    def __init__(self) -> None:
        super().__init__()
        self.setMouseTracking(True)
        self.shown: ShownProfile | None = None  # what is seen
        self.pointed_bin: ProfileBin | None = None  # what the mouse points at

    def painter(self) -> ProfilePainter | None:
        if self.shown is None:
            return None
        return ProfilePainter(self.shown, QRectF(self.rect()), chart_style(self), self.font(), self.pointed_bin)

    def show_profile(self, shown: ShownProfile) -> None:
        """Paint a profile."""
        if shown != self.shown:
            self.shown = shown
            self._point(None)
            self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self.point_at(QPointF(event.pos()))

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.point_at(None)

    def point_at(self, place: QPointF | None) -> None:
        """The mouse is there; None: it is elsewhere."""
        painter = self.painter()
        if place is None or painter is None or self.shown is None:
            self._point(None)
            return
        is_inside = painter.axes.left() <= place.x() <= painter.axes.right()
        self._point(self.shown.bin_at(painter.distance_at(place.x())) if is_inside else None)

    def _point(self, bin_: ProfileBin | None) -> None:
        if bin_ != self.pointed_bin:
            self.pointed_bin = bin_
            self.update()
            self.pointed.emit(bin_)


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

    def __init__(self) -> None:
        super().__init__()
        self._folder = Path.home()  # where the last one was saved
        self._picture: ChartPicture | None = None
        self.setIcon(QgsApplication.getThemeIcon("/mActionSaveMapAsImage.svg"))
        self.setToolTip(tr("Save the chart as a picture"))
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
        suggested, kind = str(self._folder / f"{picture.name}.png"), tr("PNG picture") + " (*.png)"
        chosen, _ = QFileDialog.getSaveFileName(self, tr("Save picture"), suggested, kind)
        if not chosen:
            return
        path = Path(chosen)
        if path.suffix.lower() != ".png":
            path = Path(f"{chosen}.png")
        self._folder = path.parent
        try:
            check_chosen_file(path)
            with replacing(path) as unfinished:
                if not chart_image(picture.paint, *picture.size, _DOTS).save(str(unfinished), "PNG"):
                    raise OSError(tr("it can't be written"))
        except SettingsError as error:
            said, level = sentence(error.message), Qgis.MessageLevel.Warning
        except OSError as error:
            text = tr("The picture was not saved to {path}: {error}. Choose another folder.")
            said, level = filled(text, path=path, error=error.strerror or error), Qgis.MessageLevel.Warning
        else:
            said, level = filled(tr("The picture was saved to {path}."), path=path), Qgis.MessageLevel.Success
        self.notified.emit(said, int(level))


def curves_picture(name: str, chart: Chart) -> ChartPicture:
    """Curves as they are shown, on white paper."""
    curves = LegendedCurves(chart, QRectF(0, 0, *_CURVES_SIZE), PAPER, paper_font(_LETTERS_PX))
    return ChartPicture(name, curves.paint, _CURVES_SIZE)


def profile_picture(name: str, shown: ShownProfile) -> ChartPicture:
    """A seam profile as it is shown."""
    painter = ProfilePainter(shown, QRectF(0, 0, *_PROFILE_SIZE), PAPER, paper_font(12))
    return ChartPicture(name, painter.paint, _PROFILE_SIZE)
