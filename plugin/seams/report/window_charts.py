"""The charts of a window for a report, as SVG: its curves and its seam profile."""
from __future__ import annotations

import math
import re
from collections.abc import Sequence, Set
from dataclasses import dataclass

from markupsafe import Markup
from qgis.PyQt.QtCore import QRectF

from ...toolkit.charts.chart_painter import chart_svg, paper_font
from ...toolkit.charts.chart_style import PAPER
from ...toolkit.translation import filled, tr
from ..charts.chart_curves import Chart, ChartCurve, numbered
from ..charts.curves_painter import CurvesPainter, curve_look
from ..charts.profile_painter import ProfilePainter, ShownProfile, level_colour
from ..measure.profile.cell_table import EDGES_PX
from ..measure.profile.seam_profile import ProfileBin, SeamProfile
from ..measure.window_records import COMPOSITE, CurveRecord, ProfileRecord, WindowRecord

CURVES_PX = 320, 260
"""Width and height of a chart of curves: as wide as a clip."""
PROFILE_PX = 470, 250
_CURVES_LETTERS_PX = 10.7  # 8 points
_PROFILE_LETTERS_PX = 11
_SAME_PLACE = 0.05  # relative: a distance that is so near to a bin's middle is that bin's


def curves_svg(curves: Sequence[CurveRecord], max_ratio: float) -> str:
    """The curves, the composite dashed; all of the same number of levels."""
    shown = Chart(_chart_curves(curves), max_ratio)
    chart = CurvesPainter(shown, QRectF(0, 0, *CURVES_PX), PAPER, paper_font(_CURVES_LETTERS_PX))
    return chart_svg(chart.paint, *CURVES_PX)


def curve_legend(curves: Sequence[CurveRecord]) -> list[tuple[str, str]]:
    """Colours and names of the curves as ``curves_svg`` paints them."""
    entries = []
    for number, curve in numbered(_chart_curves(curves)):
        name = filled(tr("{name} (mosaic, bold)"), name=curve.label) if curve.is_mosaic else curve.label
        name = tr("hard-cut composite (dashed)") if curve.is_composite else name
        entries.append((curve_look(curve, number, PAPER)[0], name))
    return [*entries, (PAPER.limit, tr("significant by the paper's rule below"))]


def _chart_curves(curves: Sequence[CurveRecord]) -> tuple[ChartCurve, ...]:
    return tuple(
        ChartCurve(
            curve.raster, curve.role == "mosaic", curve.detail, curve.background, is_composite=curve.role == COMPOSITE
        )
        for curve in curves
    )


@dataclass(frozen=True)
class ProfilePicture:
    """The chart, and what its lines are."""

    svg: Markup  # part of the page, so that its words can be found; it has no ids
    legend: Sequence[tuple[str, str]]  # colours and names of the levels


def profile_picture(
    record: WindowRecord, rows: Sequence[ProfileRecord], pixel_m: float | None, min_kept: float
) -> ProfilePicture | None:
    """The chart of a window's profile, all levels; None where nothing was measured."""
    shown = shown_profile(record, rows, pixel_m, min_kept)
    if shown is None:
        return None
    svg = profile_svg(shown)
    as_wide_as_its_room = re.sub(r' (width|height)="[\d.]+mm"', "", svg[svg.index("<svg") :])
    return ProfilePicture(Markup(as_wide_as_its_room), level_legend(shown.levels))


def profile_svg(shown: ShownProfile, size: tuple[int, int] = PROFILE_PX) -> str:
    """The chart as a file of so many px across and down."""
    chart = ProfilePainter(shown, QRectF(0, 0, *size), PAPER, paper_font(_PROFILE_LETTERS_PX))
    return chart_svg(chart.paint, *size)


def level_legend(levels: Set[int]) -> list[tuple[str, str]]:
    """Colours and names of levels."""
    return [(level_colour(level, PAPER), filled(tr("level {number}"), number=level)) for level in sorted(levels)]


def shown_profile(
    record: WindowRecord, rows: Sequence[ProfileRecord], pixel_m: float | None, min_kept: float
) -> ShownProfile | None:
    """The profile of a window from its rows; None where they tell nothing.

    ``pixel_m``: the mosaic's pixel size; where it is not known, the first distance is the middle of the first bin.
    """
    known = [row for row in rows if math.isfinite(row.kept) and math.isfinite(row.distance) and row.distance > 0]
    known.sort(key=lambda row: (row.level, row.distance))
    if not known:
        return None
    pixel_m = pixel_m or known[0].distance / _middles()[0][0]
    bins = [bin_ for row in known if (bin_ := _bin_of(row, pixel_m)) is not None]
    if not bins:
        return None
    width_px = (record.band_width or 0.0) / pixel_m
    low, high = (math.nan if end is None else end for end in (record.kept_low, record.kept_high))
    profile = SeamProfile(record.kept, low, high, width_px, 0.0, tuple(bins))
    return ShownProfile(profile, pixel_m, min_kept, frozenset(bin_.level for bin_ in bins))


def _middles() -> list[tuple[float, float, float]]:
    """Middle and ends of each bin, px; the last one has no end and stands where it begins."""
    ends = [*zip(EDGES_PX[:-1], EDGES_PX[1:])]
    return [((near + far) / 2, near, far) for near, far in ends] + [(EDGES_PX[-1], EDGES_PX[-1], math.inf)]


def _bin_of(row: ProfileRecord, pixel_m: float) -> ProfileBin | None:
    """The bin whose middle a row of the table names; None for one of another table."""
    away = row.distance / pixel_m
    middle, near, far = min(_middles(), key=lambda edges: abs(edges[0] - away))
    if abs(middle - away) > _SAME_PLACE * middle:
        return None
    return ProfileBin(row.level, near, far, row.kept, row.low, row.high, math.nan, math.nan, row.mixture)
