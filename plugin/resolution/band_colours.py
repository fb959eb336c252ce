"""Colours of bands whose profiles are drawn together."""
from __future__ import annotations

from ..toolkit.charts.chart_style import PAPER, ChartStyle

BAND_COLOURS = {"red": "#d55e00", "green": "#009e73", "blue": "#0072b2", "nir": "#cc79a7"}
_OTHERS = ("#0072b2", "#e69f00", "#56b4e9", "#d55e00", "#009e73", "#cc79a7")


def band_colour(band: str, place: int, count: int, style: ChartStyle = PAPER) -> str:
    """Colour of a band's profile among those of ``count`` bands."""
    return BAND_COLOURS.get(band, style.text if count == 1 else _OTHERS[place % len(_OTHERS)])
