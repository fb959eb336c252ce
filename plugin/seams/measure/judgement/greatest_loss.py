"""The place of a window where the mosaic lost most detail: the part that is worth to be shown."""
from __future__ import annotations

import numpy as np
from scipy import ndimage

from ..profile.window_detail import SAMPLE_PX, LossPicture

SHOWN_PX = 160  # a side of the part of a window that is shown at 2x
_MOST_PLACES = 6  # of a window
_WORTH_A_LOOK = 0.25  # of what the worst place lost
_EVEN = 0.02  # of a place's detail: less is lost nowhere, and the seam itself is looked at
_LITTLE_MORE = 0.5  # of what is lost all over: no place is worse by more, and the seam itself is looked at


def worst_places(loss: LossPicture, is_hidden: bool = False) -> list[tuple[float, float]]:
    """Column and row, px from the window's upper left, of the middles of the squares of ``SHOWN_PX`` that lost most,
    which do not overlap, the worst first. Where nothing is lost, or about as much all over, or that is to be hidden,
    squares along the seam, from its middle on.
    """
    side = max(SHOWN_PX // loss.cell_px, 1)
    lost = ndimage.uniform_filter(1 - np.clip(np.nan_to_num(loss.kept, nan=1.0), 0, 1), side, mode="constant")
    most, even = float(lost.max(initial=0)), float(np.median(lost))
    is_even = len(loss.seam) > 0 and most - even < _LITTLE_MORE * even
    if is_hidden or most < _EVEN or is_even:
        points = loss.seam * SAMPLE_PX + SAMPLE_PX / 2
        order = np.hypot(*(points - points.mean(axis=0)).T) if len(points) else np.empty(0)
    else:
        cells = np.argwhere(lost >= _WORTH_A_LOOK * most)
        points, order = (cells + 0.5) * loss.cell_px, -lost[tuple(cells.T)]
    points = points[np.argsort(order, kind="stable")]
    places: list[tuple[float, float]] = []
    while len(points) and len(places) < _MOST_PLACES:
        row, column = points[0]
        places.append((float(column), float(row)))
        points = points[np.abs(points - points[0]).max(axis=1) >= SHOWN_PX]
    return places
