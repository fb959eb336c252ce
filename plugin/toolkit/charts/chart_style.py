"""Colours and lines of all charts, on paper and in dark themes."""
from __future__ import annotations

from dataclasses import dataclass

BAND_COLOURS = {"red": "#d55e00", "green": "#009e73", "blue": "#0072b2", "nir": "#cc79a7"}
"""Colours of bands that are drawn together."""
MOST_NAMED = 12  # curves in the legend of a chart; more would leave no room for the curves
UNNAMED = "_"  # the label of a curve that no legend names
_LINE_STYLES = ("-", "--", ":", "-.")  # the next one when the colours are used up


@dataclass(frozen=True)
class ChartStyle:
    """Colours of a chart, and how heavy its lines are."""

    text: str  # colour of words, axes and the mosaic's curve
    background: str
    grid: str
    limit: str
    quiet: str  # colour of what stands beside the curves
    sources: tuple[str, ...]
    scale: float = 1.0  # factor on the widths of lines and the sizes of points


PAPER = ChartStyle(
    text="#111111",
    background="#ffffff",
    grid="#dddddd",
    limit="#b00020",
    quiet="#57606a",
    sources=("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00"),  # Okabe and Ito, for all eyes
)
DARK = ChartStyle(
    text="#eeeeee",
    background="#232629",
    grid="#454a4f",
    limit="#ff6b6b",
    quiet="#7f8893",
    sources=("#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442", "#d55e00"),  # theirs that show on black
)


def band_colour(band: str, place: int, is_alone: bool, style: ChartStyle = PAPER) -> str:
    """The colour of a band by its name, else that of words where it stands out, else by its place among those drawn."""
    return BAND_COLOURS.get(band) or (style.text if is_alone else style.sources[place % len(style.sources)])


def source_look(number: int, style: ChartStyle) -> tuple[str, str]:
    count = len(style.sources)
    return style.sources[number % count], _LINE_STYLES[number // count % len(_LINE_STYLES)]
