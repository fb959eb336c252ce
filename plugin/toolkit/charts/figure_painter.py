"""A figure as pixels that fit into a widget, in its font. matplotlib takes 20 to 150 ms for one, so threads draw."""
from __future__ import annotations

from typing import Any, Callable, NamedTuple

import numpy as np

from ..background_tasks import interface_first

from matplotlib.backends.backend_agg import FigureCanvasAgg  # isort: skip
from matplotlib.figure import Figure  # isort: skip
from matplotlib.font_manager import FontProperties, fontManager  # isort: skip
from .figure_files import set_local_ticks  # isort: skip


ROOMY_LINES = 12  # a lower chart does without the axes' titles
_FALLBACK_FAMILY = "DejaVu Sans"  # matplotlib brings it along


class Room(NamedTuple):
    """What a chart has to fit into, in the interface's pixels."""

    width: int
    height: int
    ratio: float
    """Pixels of the screen on one of the interface."""
    family: str
    font: int
    """Height of the font."""
    line: int
    digit: int
    word: int
    """Width of the longest label below the axis."""


class FigurePicture(NamedTuple):
    """A whole figure that was drawn."""

    request: Any
    pixels: bytes
    """RGBA, row by row."""
    width: int
    height: int


def draw_figure(figure: Callable[[Any], Figure], request: Any) -> FigurePicture:
    """What ``figure`` makes of a request, as pixels. Has no part in Qt."""
    with interface_first():
        made = figure(request)
        set_local_ticks(made)
        canvas = FigureCanvasAgg(made)
        canvas.draw()
        pixels = np.asarray(canvas.buffer_rgba())
        return FigurePicture(request, pixels.tobytes(), pixels.shape[1], pixels.shape[0])


def fit_figure(figure: Figure, room: Room) -> None:
    """As many pixels as there is room for; points grow with the screen's."""
    dpi = 100 * room.ratio
    figure.set_dpi(dpi)
    figure.set_size_inches(room.width * room.ratio / dpi, room.height * room.ratio / dpi)


def set_font(axes: Any, room: Room) -> FontProperties:
    """The interface's font for the words around axes."""
    family = room.family if room.family in _families() else _FALLBACK_FAMILY
    size = round(room.font * 0.72, 2)  # points of 1/72 inch, at 100 pixels per inch
    font = FontProperties(family=family, size=size)
    labels = [*axes.get_xticklabels(), *axes.get_yticklabels()]  # later ones are made from these
    for text in (*labels, axes.xaxis.label, axes.yaxis.label):
        text.set_fontproperties(font)
    axes.tick_params(labelsize=size)
    return font


def _families() -> set[str]:
    return {font.name for font in fontManager.ttflist}
