"""The buttons that save and copy the charts of the desk: as pictures on white paper, or as tables of all values."""
from __future__ import annotations

import csv
import io
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from qgis.core import Qgis, QgsApplication
from qgis.PyQt.QtCore import QBuffer, QByteArray, QRectF, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QFontMetricsF, QImage, QPainter
from qgis.PyQt.QtWidgets import QApplication, QFileDialog, QMenu, QToolButton, QWidget

from ....imagery.atomic_files import replacing
from ....imagery.errors import SettingsError, cell_text, printable
from ....toolkit.charts.chart_style import PAPER
from ....toolkit.desk.widgets import check_chosen_file
from ....toolkit.table_fields import is_known
from ....toolkit.translation import band_title, filled, sentence, tr
from ...charts.chart_curves import Chart, numbered, significance_limit
from ...charts.chart_painter import chart_image, chart_svg, paper_font
from ...charts.curves_painter import CurvesPainter, PenStyle, curve_look, paint_piece
from ...charts.profile_painter import ProfilePainter, ShownProfile

if TYPE_CHECKING:
    from ...measure.window.window_result import WindowResult

CURVE_COLUMNS = ("window_id", "raster", "role", "band", "component", "level", "relative_variance")
PROFILE_COLUMNS = ("window_id", "level", "from", "to", "kept", "low", "high", "area", "mixture")
"""Distances in m, area in m2; the mixture is the share of the image beyond the seam."""
_CURVES_SIZE = 700, 420  # px of a picture
_CURVES_DOTS = 2  # a side of each pixel
_PROFILE_SIZE = 560, 340
_PROFILE_DOTS = 3
_TITLE_PX = 15
_LETTERS_PX, _LEGEND_PX = 13.9, 11.1  # 10 and 8 points
_GAP_PX = 8
_PIECE_PX = 26, 16  # width and height of a line's piece in the legend of a picture


class ChartExport(QToolButton):
    """Opens a menu of formats. What leaves it is what was shown when the user asked, whatever comes while a dialog is
    open. Its kinds say what is painted, what a table holds, and the words."""

    told = pyqtSignal(str, int)  # sentence, Qgis.MessageLevel as int

    def __init__(self, tip: str, table_tip: str, with_svg: bool, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._folder = Path.home()
        self.setIcon(QgsApplication.getThemeIcon("/mActionSharingExport.svg"))
        self.setToolTip(tip)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setAutoRaise(True)
        self.setEnabled(False)
        menu = QMenu(self)
        menu.setToolTipsVisible(True)
        copied = tr("To the clipboard, for a spreadsheet")
        for icon, text, action_tip, slot in (
            ("mActionSaveMapAsImage", tr("Save as PNG..."), tr("The picture, for documents"), self.save_png),
            ("mActionSaveAsSVG", tr("Save as SVG..."), tr("The picture, sharp at every size"), self.save_svg),
            ("mActionOpenTable", tr("Save as CSV..."), table_tip, self.save_csv),
            ("mActionEditCopy", tr("Copy picture"), tr("To the clipboard"), self.copy_picture),
            ("mActionEditCopy", tr("Copy values"), copied, self.copy_values),
        ):
            if with_svg or slot != self.save_svg:
                action = menu.addAction(QgsApplication.getThemeIcon(f"/{icon}.svg"), text)
                action.setToolTip(action_tip)
                action.triggered.connect(slot)
        self.setMenu(menu)

    def save_png(self) -> None:
        """Ask where and save the picture."""
        content = QByteArray()
        self._image().save(QBuffer(content), "PNG")
        self._save("png", tr("PNG picture"), bytes(content))

    def save_svg(self) -> None:
        """Ask where and save the picture."""
        paint, size, _ = self._picture()
        self._save("svg", tr("SVG picture"), chart_svg(paint, *size).encode())

    def save_csv(self) -> None:
        """Ask where and save the values."""
        self._save("csv", tr("Table with commas"), csv_text(self._table()).encode())

    def copy_picture(self) -> None:
        """The picture to the clipboard."""
        QApplication.clipboard().setImage(self._image())

    def copy_values(self) -> None:
        """The values to the clipboard, with tabs, as a spreadsheet takes them."""
        rows = ("\t".join(" ".join(str(cell).split()) for cell in row) for row in self._table())
        QApplication.clipboard().setText("\n".join(rows))

    def _save(self, ending: str, kind: str, content: bytes) -> None:
        """Ask where, save, and tell it. The folder is suggested again the next time."""
        title, saved, not_saved = self._words()
        suggested = self._folder / f"{self._name()}.{ending}"
        chosen, _ = QFileDialog.getSaveFileName(self, title, str(suggested), f"{kind} (*.{ending})")
        if not chosen:
            return
        path = Path(chosen) if chosen.lower().endswith(f".{ending}") else Path(f"{chosen}.{ending}")
        self._folder = path.parent
        try:
            check_chosen_file(path)
            with replacing(path) as unfinished:
                unfinished.write_bytes(content)
        except SettingsError as error:
            said, level = sentence(error.message), Qgis.MessageLevel.Warning
        except OSError as error:
            said, level = filled(not_saved, path=path, error=error.strerror or error), Qgis.MessageLevel.Warning
        else:
            said, level = filled(saved, path=path), Qgis.MessageLevel.Success
        self.told.emit(said, int(level))

    def _image(self) -> QImage:
        paint, size, dots = self._picture()
        return chart_image(paint, *size, dots)

    def _picture(self) -> tuple[Callable[[QPainter], None], tuple[int, int], int]:
        """What paints the chart, on how many px, and how many dots a side each of them has in an image."""
        raise NotImplementedError

    def _table(self) -> Iterable[Sequence[object]]:
        """Headings and rows."""
        raise NotImplementedError

    def _name(self) -> str:
        """Name of a file, without its ending."""
        raise NotImplementedError

    def _words(self) -> tuple[str, str, str]:
        """Title of the dialog that asks where to save; what is said when it was saved, with a place for the path, and
        when it was not, with one for the error, too."""
        raise NotImplementedError


class CurvesExport(ChartExport):
    """Pictures of the curves, and tables of all rasters and bands of their windows."""

    def __init__(self, parent: QWidget | None = None) -> None:
        tip = tr("Save or copy what is shown: as a picture, or as a table of all values")
        super().__init__(tip, tr("All rasters and bands of the windows"), True, parent)
        self._results: list[WindowResult] = []
        self._curves: CurvesPicture | None = None
        self._band = ""

    def offer(self, results: Sequence[WindowResult], chart: Chart | None, title: str, band: str) -> None:
        """What there is to export from now on; without results nothing."""
        self._results, self._band = list(results), band
        self._curves = None if chart is None else CurvesPicture(chart, f"{title} ({band_title(band)})")
        self.setEnabled(bool(results) and chart is not None)

    def _picture(self) -> tuple[Callable[[QPainter], None], tuple[int, int], int]:
        assert self._curves is not None
        return self._curves.paint, _CURVES_SIZE, _CURVES_DOTS

    def _table(self) -> Iterator[Sequence[object]]:
        return curves_table(self._results)

    def _name(self) -> str:
        results = self._results
        which = f"window_{results[0].window_id}" if len(results) == 1 else f"{len(results)}_windows"
        return f"{which}_{self._band}"

    def _words(self) -> tuple[str, str, str]:
        return (
            tr("Save curves"), tr("The curves were saved to {path}."),
            tr("The curves were not saved to {path}: {error}. Choose another folder."),
        )


class ProfileExport(ChartExport):
    """A picture of the seam profile, and a table of its bins."""

    def __init__(self, parent: QWidget | None = None) -> None:
        tip = tr("Save or copy the seam profile: as a picture, or as a table of all levels")
        super().__init__(tip, tr("All levels and distances"), False, parent)
        self._result: WindowResult | None = None
        self._shown: ShownProfile | None = None

    def offer(self, result: WindowResult | None, shown: ShownProfile | None) -> None:
        """What there is to export from now on; without a result nothing."""
        self._result, self._shown = result, shown
        self.setEnabled(result is not None and shown is not None)

    def _picture(self) -> tuple[Callable[[QPainter], None], tuple[int, int], int]:
        assert self._shown is not None
        chart = ProfilePainter(self._shown, QRectF(0, 0, *_PROFILE_SIZE), PAPER, paper_font(12))
        return chart.paint, _PROFILE_SIZE, _PROFILE_DOTS

    def _table(self) -> Iterator[Sequence[object]]:
        assert self._result is not None
        return profile_table(self._result)

    def _name(self) -> str:
        assert self._result is not None
        return f"window_{self._result.window_id}_profile"

    def _words(self) -> tuple[str, str, str]:
        return (
            tr("Save seam profile"), tr("The seam profile was saved to {path}."),
            tr("The seam profile was not saved to {path}: {error}. Choose another folder."),
        )


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


def csv_text(table: Iterable[Sequence[object]]) -> str:
    """Text of a table as a file of comma-separated values."""
    buffer = io.StringIO()
    csv.writer(buffer).writerows(table)
    return buffer.getvalue()


def curves_table(results: Iterable[WindowResult]) -> Iterator[Sequence[object]]:
    """All rasters and bands of the windows, one row per component; empty where a clip is constant."""
    from ...tables.result_tables import curve_features  # with numpy, which nobody needs before

    yield CURVE_COLUMNS
    for result in results:
        for feature in curve_features(result):
            values = (feature[name] for name in CURVE_COLUMNS)
            known = (value if is_known(value) else "" for value in values)
            yield [cell_text(value) if isinstance(value, str) else value for value in known]


def profile_table(result: WindowResult) -> Iterator[Sequence[object]]:
    """One row per bin; the last one of a level has no end."""
    yield PROFILE_COLUMNS
    metres = result.ground_sample_distance
    for one in result.profile.bins if result.profile is not None else ():
        far = "" if math.isinf(one.far_px) else f"{one.far_px * metres:.6g}"
        numbers = (f"{value:.6g}" for value in (one.kept, one.low, one.high, one.area_px * metres**2))
        mixture = "" if one.mixture is None else f"{one.mixture:.6g}"
        yield (result.window_id, one.level, f"{one.near_px * metres:.6g}", far, *numbers, mixture)
