"""The side of a window on a mosaic: the one that was asked for, and one that fits."""
from __future__ import annotations

import math

from ....imagery import limits as imagery_limits
from ....imagery import messages as imagery_messages
from ....imagery.errors import SettingsError
from ....imagery.grids import Grid, standard_side_px
from .. import messages

SIDES_ACROSS = 4  # of a mosaic that is too small for the window that was asked for
LONGEST_SIDE_PX = 2 ** int(math.log2(math.sqrt(imagery_limits.MAX_WINDOW_PIXELS)))


def window_side_px(grid: Grid, side_m: float, spacing_m: float, levels: int) -> int:
    """The side of a window in pixels. Raises SettingsError, see ``place_windows``."""
    side_px = standard_side_px(grid, side_m)
    if not (math.isfinite(spacing_m) and spacing_m > 0):
        raise SettingsError(messages.SPACING_NOT_POSITIVE(spacing=spacing_m))
    if not imagery_limits.MIN_LEVELS <= levels <= imagery_limits.MAX_LEVELS:
        least, most = imagery_limits.MIN_LEVELS, imagery_limits.MAX_LEVELS
        raise SettingsError(imagery_messages.LEVELS_OUT_OF_RANGE(levels=levels, least=least, most=most))
    fewest = max(imagery_limits.MIN_SIDE_PX, 2**levels)
    if side_px < fewest:  # both are powers of two, so any longer side is a multiple of 2 ** levels
        metres = math.ceil(fewest * grid.ground_sample_distance * 100) / 100
        raise SettingsError(
            messages.SIDE_TOO_SHORT(side=side_m, pixels=side_px, levels=levels, fewest=fewest, metres=metres)
        )
    return side_px


def fitting_side_m(grid: Grid, side_m: float, spacing_m: float, levels: int) -> float:
    """The side itself where mosaic and levels allow it; else one that they do, in centimetres.

    Of a mosaic that no window fits on, the side itself.
    """
    shorter, fewest = min(grid.columns, grid.rows), max(imagery_limits.MIN_SIDE_PX, 2**levels)
    try:
        wanted = window_side_px(grid, side_m, spacing_m, levels)
    except SettingsError:
        wanted = fewest
    else:
        if wanted <= min(shorter, LONGEST_SIDE_PX):
            return side_m
        wanted = min(max(2 ** int(math.log2(max(shorter / SIDES_ACROSS, 1))), fewest), LONGEST_SIDE_PX)
    if wanted > shorter:
        return side_m
    return max(math.floor(100 * wanted * grid.ground_sample_distance + 1e-6) / 100, 0.1)
