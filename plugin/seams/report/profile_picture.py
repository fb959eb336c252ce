"""The seam profile of a window for a report: where everything of its chart is. The template draws it."""
from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ...toolkit.charts.chart_style import PAPER
from ...toolkit.translation import filled, percent, tr
from ..charts.profile_scale import ProfileScale, ShownProfile
from ..measure.profile.cell_table import EDGES_PX
from ..measure.profile.seam_profile import ProfileBin, SeamProfile
from ..measure.window_records import ProfileRecord, WindowRecord

WIDTH, HEIGHT = 470.0, 250.0
"""Of the chart, in its own units."""
_LEFT, _TOP, _RIGHT, _BOTTOM = 46.0, 8.0, 8.0, 40.0  # room around the axes
_STEP = 0.25  # between the lines of shares
_LETTER = 6.4  # about the width of one
_SAME_PLACE = 0.05  # relative: a distance that is so near to a bin's middle is that bin's

Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class ProfilePicture:
    """Lines and words of one chart; y runs downwards."""

    axes: Box
    """Left, top, right and bottom."""
    shares: Sequence[tuple[float, str, bool]]
    """y and words of the lines of shares, and whether all is kept there."""
    distances: Sequence[tuple[float, str]]
    """x and words below the axis."""
    limit: tuple[float, str]
    intervals: Sequence[Box]
    """Left, top, width and height of the 95 % intervals of the finest level."""
    lines: Sequence[tuple[str, str, float]]
    """Points, colour and width of each level, the finest last."""
    mixture: str
    """Points of the share of the image beyond the seam; empty for none."""
    legend: Sequence[tuple[str, str]]
    """Colours and names of the levels, and of the mixture."""


def profile_picture(
    record: WindowRecord, rows: Sequence[ProfileRecord], pixel_m: float | None, min_kept: float
) -> ProfilePicture | None:
    """The chart of a window's profile, all levels; None where nothing was measured.

    ``pixel_m``: the mosaic's pixel size; where it is not known, the first distance is the middle of the first bin.
    """
    known = [row for row in rows if math.isfinite(row.kept) and math.isfinite(row.distance) and row.distance > 0]
    known.sort(key=lambda row: (row.level, row.distance))
    if not known:
        return None
    pixel_m = pixel_m or known[0].distance / _middles()[0][0]
    bins = [found for row in known if (found := _bin_of(row, pixel_m)) is not None]
    if not bins:
        return None
    width_px = (record.band_width or 0.0) / pixel_m
    low, high = (math.nan if end is None else end for end in (record.kept_low, record.kept_high))
    profile = SeamProfile(record.kept, low, high, width_px, 0.0, tuple(bins))
    levels = frozenset(one.level for one in bins)
    return _picture(ShownProfile(profile, pixel_m, min_kept, levels))


def _middles() -> list[tuple[float, float, float]]:
    """Middle and ends of each bin, px; the last one has no end and stands where it begins."""
    ends = [*zip(EDGES_PX[:-1], EDGES_PX[1:])]
    return [((near + far) / 2, near, far) for near, far in ends] + [(EDGES_PX[-1], EDGES_PX[-1], math.inf)]


def _bin_of(row: ProfileRecord, pixel_m: float) -> ProfileBin | None:
    """The bin whose middle a row of the table names; None for one of another table."""
    away = row.distance / pixel_m
    middle, near, far = min(_middles(), key=lambda one: abs(one[0] - away))
    if abs(middle - away) > _SAME_PLACE * middle:
        return None
    return ProfileBin(row.level, near, far, row.kept, row.low, row.high, math.nan, math.nan, row.mixture)


def _picture(shown: ShownProfile) -> ProfilePicture:
    left, top, right, bottom = axes = _LEFT, _TOP, WIDTH - _RIGHT, HEIGHT - _BOTTOM
    scale = ProfileScale(shown, left, top, right - left, bottom - top)
    main = [one for one in shown.bins(shown.main_level) if math.isfinite(one.low) and math.isfinite(one.high)]
    intervals = []
    for one in main:
        (start, end), upper, lower = scale.ends(one), scale.y_of(one.high), scale.y_of(one.low)
        intervals.append((start, upper, end - start, lower - upper))
    levels = sorted(shown.levels, reverse=True)
    mixture = _points(scale.mixture_line())
    names = [(_colour(level), filled(tr("level {number}"), number=level)) for level in reversed(levels)]
    return ProfilePicture(
        axes,
        [(scale.y_of(share), f"{percent(share) if share else 0} %", share == 1) for share in scale.share_ticks(_STEP)],
        _with_room([(scale.x_of(metres), words) for metres, words in scale.distance_ticks()], right),
        (scale.y_of(shown.min_kept), filled(tr("limit {percent} %"), percent=percent(shown.min_kept))),
        intervals,
        [(_steps(shown, scale, level), _colour(level), 2.2 if level == shown.main_level else 1.3) for level in levels],
        mixture,
        [*names, (PAPER.quiet, tr("share of the other image"))] if mixture else names,
    )


def _steps(shown: ShownProfile, scale: ProfileScale, level: int) -> str:
    """The line of a level as the points of an SVG polyline."""
    return _points((x, scale.y_of(one.kept)) for one in shown.bins(level) for x in scale.ends(one))


def _points(points: Iterable[tuple[float, float]]) -> str:
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in points)


def _colour(level: int) -> str:
    return PAPER.sources[(level - 1) % len(PAPER.sources)]


def _with_room(ticks: Sequence[tuple[float, str]], right: float) -> list[tuple[float, str]]:
    """The ticks whose words do not run into those before them."""
    kept: list[tuple[float, str]] = []
    end = -math.inf
    for x, words in ticks:
        half = _LETTER * len(words) / 2
        if x - half > end + _LETTER and x <= right:
            kept.append((x, words))
            end = x + half
    return kept
