"""The curves of windows as small SVG pictures for a report."""
from __future__ import annotations

from collections.abc import Sequence

from qgis.PyQt.QtCore import QRectF

from ...toolkit.charts.chart_style import PAPER, source_look
from ...toolkit.translation import filled, tr
from ..charts.chart_curves import Chart, ChartCurve
from ..charts.chart_painter import chart_svg, paper_font
from ..charts.curves_painter import CurvesPainter
from ..measure.window_records import COMPOSITE, CurveRecord

SIZE_PX = 320, 260
"""As wide as a clip."""
_LETTERS_PX = 10.7  # 8 points


def curves_svg(curves: Sequence[CurveRecord], max_ratio: float) -> str:
    """The curves, the composite dashed; all of the same number of levels."""
    shown = tuple(
        ChartCurve(
            curve.raster, curve.role == "mosaic", curve.detail, curve.background, is_composite=curve.role == COMPOSITE
        )
        for curve in curves
    )
    chart = CurvesPainter(Chart(shown, max_ratio), QRectF(0, 0, *SIZE_PX), PAPER, paper_font(_LETTERS_PX))
    return chart_svg(chart.paint, *SIZE_PX)


def curve_legend(curves: Sequence[CurveRecord]) -> list[tuple[str, str]]:
    """Colours and names of the curves as ``curves_svg`` paints them."""
    places = iter(range(len(curves)))
    entries = []
    for curve in curves:
        if curve.role == "source":
            entries.append((source_look(next(places), PAPER)[0], curve.raster))
        elif curve.role == COMPOSITE:
            entries.append((PAPER.text, tr("hard-cut composite (dashed)")))
        else:
            entries.append((PAPER.text, filled(tr("{name} (mosaic, bold)"), name=curve.raster)))
    return [*entries, (PAPER.limit, tr("significant by the paper's rule below"))]
