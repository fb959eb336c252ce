"""The colours of a chart inside a widget, in whatever theme QGIS has. Without matplotlib."""
from __future__ import annotations

from qgis.PyQt.QtGui import QFontInfo, QPalette
from qgis.PyQt.QtWidgets import QWidget

from ..charts.chart_style import DARK, PAPER, ChartStyle
from .theme import blended, readable_palette

_FONT_PX = 12  # of the interface on an ordinary screen
_DARKEST_LIGHT = 128  # of 255: a background darker than this is a dark theme


def chart_style(widget: QWidget) -> ChartStyle:
    """The colours of a chart in a widget, its lines as heavy as the widget's font is large."""
    palette, scale = readable_palette(widget), QFontInfo(widget.font()).pixelSize() / _FONT_PX
    back, text = palette.color(QPalette.ColorRole.Base), palette.color(QPalette.ColorRole.Text)
    theme = DARK if back.lightness() < _DARKEST_LIGHT else PAPER
    grid = blended(text, back, 0.18)
    return ChartStyle(text.name(), back.name(), grid.name(), theme.limit, theme.quiet, theme.sources, scale)
