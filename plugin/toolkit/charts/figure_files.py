"""matplotlib figures for files and reports, on white paper. ``Figure`` only: no pyplot, no Qt."""
from __future__ import annotations

import io
from pathlib import Path

from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import ScalarFormatter

from ...imagery.atomic_files import whole_file
from ..translation import local_digits


def set_local_ticks(figure: Figure) -> None:
    """Write the numbers of axes in the user's digits, where they are matplotlib's, not words or formats of ours."""
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            if type(axis.get_major_formatter()) is ScalarFormatter:
                axis.set_major_formatter(_LocalFormatter())


class _LocalFormatter(ScalarFormatter):
    def __call__(self, value: float, position: int | None = None) -> str:
        return local_digits(super().__call__(value, position))


_DPI = 200
_SVG = {"svg.fonttype": "none", "svg.hashsalt": "seam_inspector"}  # text stays text, and the same figure the same file


def new_figure(width: float, height: float, layout: str | None = "constrained") -> Figure:
    """An empty figure, its size in inches, whose parts find their places by themselves, unless ``layout`` is None."""
    figure = Figure(figsize=(width, height), layout=layout)
    FigureCanvasAgg(figure)
    return figure


def save_figure(figure: Figure, path: Path) -> None:
    """Write PNG, SVG or PDF, by the path's ending. Raises SettingsError where no file can be."""
    set_local_ticks(figure)
    with whole_file(path) as unfinished, rc_context(_SVG):
        figure.savefig(unfinished, dpi=_DPI)


def svg_text(figure: Figure) -> str:
    buffer = io.StringIO()
    set_local_ticks(figure)
    with rc_context(_SVG):
        figure.savefig(buffer, format="svg")
    return buffer.getvalue()
