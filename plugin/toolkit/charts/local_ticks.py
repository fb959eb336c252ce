"""The numbers along a chart's axes, as the user writes them."""
from __future__ import annotations

from matplotlib.figure import Figure
from matplotlib.ticker import ScalarFormatter

from ..translation import local_digits


def set_local_ticks(figure: Figure) -> None:
    """For all axes of a figure that have matplotlib's own numbers, not words or formats of ours."""
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            if type(axis.get_major_formatter()) is ScalarFormatter:
                axis.set_major_formatter(_LocalFormatter())


class _LocalFormatter(ScalarFormatter):
    def __call__(self, value: float, position: int | None = None) -> str:
        return local_digits(super().__call__(value, position))
