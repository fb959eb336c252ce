"""Colours and lines of all charts, on paper and in dark themes; round numbers of axes and scale bars."""
from __future__ import annotations

import math
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


_BARELY = 1e-9  # relative: of a number that is round but for its last digits


def round_below(value: float) -> float:
    """The largest of 1, 2 and 5 times a power of ten that is not above a value."""
    decade = 10.0 ** math.floor(math.log10(value))
    return max(digit * decade for digit in (1, 2, 5) if digit * decade <= value * (1 + _BARELY))


def even_ticks(low: float, high: float, most: float) -> list[float]:
    """Ticks of a linear axis: round numbers in even steps, about as many as ``most``."""
    least = (high - low) / most
    decade = 10.0 ** math.floor(math.log10(least))
    step = next(digit * decade for digit in (1, 2, 5, 10) if digit * decade >= least * (1 - _BARELY))
    return [step * number for number in range(math.ceil(low / step), math.floor(high / step) + 1)]


def decade_ticks(low: float, high: float, most: float) -> list[float]:
    """Ticks of a logarithmic axis: 1, 2, 5, 10, or fewer, until there are no more than ``most``."""
    first, last = math.floor(math.log10(low)), math.ceil(math.log10(high))
    ticks: list[float] = []
    for digits, step in (((1, 2, 5), 1), ((1, 3), 1), ((1,), 1), ((1,), 2), ((1,), 3)):
        numbers = (digit * 10.0**decade for decade in range(last, first - 1, -step) for digit in digits)
        ticks = sorted(number for number in numbers if low * (1 - _BARELY) <= number <= high)
        if len(ticks) <= most:
            break
    return ticks
