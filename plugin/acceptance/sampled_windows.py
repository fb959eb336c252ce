"""Windows around pieces of seam, on the pixels of a mosaic."""
from __future__ import annotations

import numpy as np

from ..imagery import limits as limits
from ..imagery.errors import RasterError, SettingsError
from ..imagery.grids import PixelWindow, standard_side_px, standard_window
from ..imagery.rasters import Raster
from ..imagery.reference_systems import transform_points
from .measure import messages
from .measure.delivery import DeliveredPiece


def middle_on(mosaic: Raster, piece: DeliveredPiece, wkt: str) -> tuple[float, float] | None:
    """The point half-way along a piece, in the mosaic's reference system; None where the mosaic does not show it."""
    try:
        x, y = transform_points(np.array([piece.middle]), wkt, mosaic.wkt)[0].tolist() if wkt else piece.middle
    except RasterError:
        return None
    xmin, ymin, xmax, ymax = mosaic.grid.extent
    return (x, y) if xmin <= x <= xmax and ymin <= y <= ymax else None


def sampled_window(mosaic: Raster, piece: DeliveredPiece, wkt: str, side_m: float) -> PixelWindow | None:
    """A standard window around the middle of a piece, moved inside the mosaic; None where that does not show it.

    Raises SettingsError for a side that can't be, or is longer than the mosaic.
    """
    grid = mosaic.grid
    side = standard_side_px(grid, side_m)
    if side > min(grid.columns, grid.rows):
        raise SettingsError(messages.MOSAIC_SMALLER_THAN_WINDOW(pixels=side, side=side_m))
    if side < limits.MIN_SIDE_PX:
        raise SettingsError(messages.WINDOW_SIDE_TOO_SHORT(side=side_m, pixels=side, least=limits.MIN_SIDE_PX))
    place = middle_on(mosaic, piece, wkt)
    if place is None:
        return None
    return standard_window(grid, *place, side).moved_into(grid.columns, grid.rows)
