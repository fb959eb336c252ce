"""Curves leave the desk: a picture on white paper, or a table of all that was measured."""
from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from ....imagery.atomic_files import replacing
from ....imagery.errors import cell_text, printable
from ....toolkit.charts.chart_style import PAPER
from ....toolkit.table_fields import is_known
from ...charts.curve_chart import draw_curves
from ...tables.result_tables import curve_features

if TYPE_CHECKING:
    from ...measure.window.window_result import WindowResult
    from .curves_painter import Chart

from matplotlib.backends.backend_agg import FigureCanvasAgg  # isort: skip
from matplotlib.figure import Figure  # isort: skip

COLUMNS = ("window_id", "raster", "role", "band", "component", "level", "relative_variance")
_SIZE_INCHES = (7.0, 4.2)
_DPI = 200


def picture(chart: Chart, title: str) -> Figure:
    """The chart as it is shown, hidden curves left out, with title and legend, for a report."""
    figure = Figure(figsize=_SIZE_INCHES, layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    draw_curves(axes, chart.curves, chart.max_ratio, PAPER, chart.logarithmic, chart.hidden)
    places = {curve.label: place for place, curve in enumerate(chart.curves)}
    axes.set_title(title, fontsize=11, fontweight="bold")
    labelled = ((line, str(line.get_label())) for line in axes.get_lines())
    shown = [one for one in labelled if one[1] in places or not one[1].startswith("_")]  # a file may begin with one
    lines, names = zip(*sorted(shown, key=lambda one: places.get(one[1], len(places))))
    plain = [name.lstrip("_") for name in names]
    legend = axes.legend(lines, plain, fontsize=8, frameon=False, loc="center left", bbox_to_anchor=(1.0, 0.5))
    for text, name in zip(legend.get_texts(), names):
        text.set_parse_math(False)  # names of files are no formulas
        text.set_text(printable(name))
    return figure


def save_picture(chart: Chart, title: str, path: Path) -> None:
    """Write PNG or SVG, by the path's ending."""
    with replacing(path) as unfinished:
        picture(chart, title).savefig(unfinished, dpi=_DPI)


def png_bytes(chart: Chart, title: str) -> bytes:
    """The picture for the clipboard."""
    buffer = io.BytesIO()
    picture(chart, title).savefig(buffer, format="png", dpi=_DPI)
    return buffer.getvalue()


def write_csv(results: Iterable[WindowResult], path: Path) -> None:
    """All rasters and bands of the windows, one row per component; empty where a clip is constant."""
    with replacing(path) as unfinished, unfinished.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        writer.writerows(_rows(results))


def table_text(results: Iterable[WindowResult]) -> str:
    """The same with tabs, as a spreadsheet takes it from the clipboard."""
    return "\n".join("\t".join(" ".join(str(cell).split()) for cell in row) for row in (COLUMNS, *_rows(results)))


def _rows(results: Iterable[WindowResult]) -> Iterable[list[object]]:
    for result in results:
        for feature in curve_features(result):
            values = (feature[name] for name in COLUMNS)
            known = (value if is_known(value) else "" for value in values)
            yield [cell_text(value) if isinstance(value, str) else value for value in known]
