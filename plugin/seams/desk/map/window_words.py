"""What the label at the mouse says of a window that is being placed."""
from __future__ import annotations

import math

from ....imagery.grids import Grid, PixelWindow
from ....toolkit.translation import filled, shown_metres, tr
from ...measure.inputs.valid_cells import is_mosaic_enough
from .window_coverage import Coverage


def described(grid: Grid, window: PixelWindow, coverage: Coverage) -> str:
    """``102.4 x 102.4 m, 1024 x 1024 px, 3 sources``; less while less is known."""
    width, height = window.width * grid.pixel_width * grid.metres_x, window.height * grid.pixel_height * grid.metres_y
    size = tr("{width} x {height} m, {columns} x {rows} px")
    spans = {"width": shown_metres(width), "height": shown_metres(height)}
    parts = [filled(size, **spans, columns=window.width, rows=window.height)]
    few = {0: tr("no source has pixels there"), 1: tr("1 source")}
    counted = few.get(coverage.sources) or filled(tr("{count} sources"), count=coverage.sources)
    if not coverage.unread:
        parts.append(counted)
    elif coverage.sources:
        parts.append(filled(tr("{counted} or more"), counted=counted))
    if coverage.missing is not None and not is_mosaic_enough(1 - coverage.missing):
        share = tr("{share:.0f} % of the mosaic is empty there") if coverage.missing >= 0.01 else tr(
            "{share:.1f} % of the mosaic is empty there")
        parts.append(filled(share, share=100 * coverage.missing))
    return ", ".join(parts)


def metres_apart(grid: Grid, one: PixelWindow, other: PixelWindow) -> float:
    """Between two windows of one size."""
    across = (other.column - one.column) * grid.pixel_width * grid.metres_x
    return math.hypot(across, (other.row - one.row) * grid.pixel_height * grid.metres_y)


def is_near(one: PixelWindow, other: PixelWindow) -> bool:
    """Whether two windows of one size overlap or touch."""
    return abs(other.column - one.column) <= one.width and abs(other.row - one.row) <= one.height


def direction(one: PixelWindow, other: PixelWindow) -> str:
    """Where another window lies, in words."""
    words = (
        tr("east"), tr("north-east"), tr("north"), tr("north-west"), tr("west"), tr("south-west"), tr("south"),
        tr("south-east"),
    )
    turn = math.atan2(one.row - other.row, other.column - one.column)
    return words[round(turn / (math.pi / 4)) % 8]


def middle(grid: Grid, window: PixelWindow) -> tuple[float, float]:
    """The point of the map in the middle of a window."""
    xmin, ymin, xmax, ymax = grid.window_extent(window)
    return (xmin + xmax) / 2, (ymin + ymax) / 2
