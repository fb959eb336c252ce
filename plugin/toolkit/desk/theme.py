"""Colours that can be read, for what draws itself and for charts, in whatever theme QGIS has, and the base of tabs with
a chart. Without matplotlib."""
from __future__ import annotations

from qgis.PyQt import QtWidgets
from qgis.PyQt.QtCore import QEvent, QModelIndex, Qt
from qgis.PyQt.QtGui import QColor, QFontInfo, QIcon, QPalette, QPixmap, QShowEvent

from ..charts.chart_style import DARK, PAPER, ChartStyle
from .widgets import single_shot

_LEAST_CONTRAST = 3.0  # WCAG 2.1, success criteria 1.4.3 and 1.4.11: large text, and graphics that mean something


def readable_palette(widget: QtWidgets.QWidget) -> QPalette:
    """The palette of a widget, or of the nearest one around it whose text can be read.

    Themes such as Night Mapping colour QGIS's own kinds of widgets by style sheet, and leave dark text on nothing in
    the palette of the others. Ask while painting: themes change, and a new widget has its theme only when it is shown.
    """
    around: QtWidgets.QWidget | None = widget
    while around is not None:
        around.ensurePolished()
        palette = around.palette()
        text, back = palette.color(QPalette.ColorRole.Text), palette.color(QPalette.ColorRole.Base)
        if back.alpha() == 255 and contrast(text, back) >= _LEAST_CONTRAST:
            return palette
        around = around.parentWidget()
    return widget.palette()


class ReadableItems(QtWidgets.QStyledItemDelegate):
    """Draws items without what themes do to them under the mouse: Night Mapping writes them dark on grey there."""

    def initStyleOption(self, option: QtWidgets.QStyleOptionViewItem, index: QModelIndex) -> None:
        super().initStyleOption(option, index)
        option.state &= ~QtWidgets.QStyle.StateFlag.State_MouseOver


def plain_icon(*pixmaps: QPixmap) -> QIcon:
    """Looks the same in selected rows; of the sizes given the one that fits is taken."""
    icon = QIcon()
    for pixmap in pixmaps:
        for mode in (QIcon.Mode.Normal, QIcon.Mode.Selected, QIcon.Mode.Active):
            icon.addPixmap(pixmap, mode)
    return icon


def contrast(colour: QColor, other: QColor) -> float:
    """Contrast of two colours, 1 to 21, as WCAG 2.1 defines it."""
    darker, lighter = sorted((_luminance(colour), _luminance(other)))
    return (lighter + 0.05) / (darker + 0.05)


def blended(colour: QColor, other: QColor, share: float) -> QColor:
    pairs = zip(colour.getRgb()[:3], other.getRgb()[:3])
    return QColor(*(round(share * a + (1 - share) * b) for a, b in pairs))


def _luminance(colour: QColor) -> float:
    """Relative luminance of sRGB, 0 to 1."""
    red, green, blue = (
        share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4 for share in colour.getRgbF()[:3]
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


_FONT_PX = 12  # of the interface on an ordinary screen
_DARKEST_LIGHT = 128  # of 255: a background darker than this is a dark theme


def chart_style(widget: QtWidgets.QWidget) -> ChartStyle:
    """The colours of a chart in a widget, its lines as heavy as the widget's font is large."""
    palette, scale = readable_palette(widget), QFontInfo(widget.font()).pixelSize() / _FONT_PX
    back, text = palette.color(QPalette.ColorRole.Base), palette.color(QPalette.ColorRole.Text)
    theme = DARK if back.lightness() < _DARKEST_LIGHT else PAPER
    grid = blended(text, back, 0.18)
    return ChartStyle(text.name(), back.name(), grid.name(), theme.limit, theme.quiet, theme.sources, scale)


_RESTYLING = (QEvent.Type.PaletteChange, QEvent.Type.StyleChange, QEvent.Type.FontChange)


class ChartPanel(QtWidgets.QWidget):
    """A chart or the words in its place; below it words, and a button. Looks anew once it comes into sight."""

    def __init__(self) -> None:
        super().__init__()
        self._timer = single_shot(self, self._refresh)
        self._text = QtWidgets.QLabel()
        self._text.setTextFormat(Qt.TextFormat.PlainText)
        self._text.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._text.setWordWrap(True)
        self._text.setAutoFillBackground(True)
        self._text.setBackgroundRole(QPalette.ColorRole.Base)
        self._text.setForegroundRole(QPalette.ColorRole.Text)
        self._text.setMargin(self.fontMetrics().height())
        self._text.setMinimumSize(1, 1)
        self._pages = QtWidgets.QStackedWidget()
        self._pages.addWidget(self._text)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._refresh_now()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in _RESTYLING:
            self._refresh_now()

    def _lay_out(self, words: QtWidgets.QWidget, button: QtWidgets.QWidget) -> None:
        layout, below = QtWidgets.QVBoxLayout(self), QtWidgets.QHBoxLayout()
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(self.fontMetrics().height() // 5)
        layout.addWidget(self._pages, 1)
        layout.addLayout(below)
        below.addWidget(words, 1)
        below.addWidget(button)

    def _refresh_now(self, *_: object) -> None:
        """Refresh as soon as the signals under way have been handled."""
        self._timer.start(0)

    def _refresh(self) -> None:
        """Show what is selected now; nothing while the panel is out of sight."""
        raise NotImplementedError
