"""The mark that a user's template was cut out of: it fits there as nothing else does, so it is used there first."""
from __future__ import annotations

import math

import numpy as np

from ....imagery.grids import PixelWindow
from .. import limits
from ..correlation import correlate, peak_pixel, peaks
from ..mark_templates import CutOut
from ..photo import Photo
from ..photo_views import Place, block_means

COARSE_TEMPLATE_PX = 10  # of the shorter side while the photo is searched
LOOKED_AT = 12  # places that look alike there
MIN_LOOK = 0.5  # of them: reduced on other pixel bounds than the photo, a cut-out still fits itself so well
SAME_PIXELS = 0.98  # correlation of a piece of the photo with itself, stored anew with loss


def own_place(photo: Photo, template: CutOut, coarsest: int) -> Place | None:
    """Column and row of the mark that a template was cut out of; None where it is from another photo.

    The photo is searched reduced by ``coarsest`` at least.
    """
    rows, columns = template.pixels.shape
    step = max(min(rows, columns) // COARSE_TEMPLATE_PX, coarsest)
    reduced = block_means(template.pixels, step)
    if min(reduced.shape) < limits.MIN_TEMPLATE_PX or np.ptp(reduced) == 0:
        return None
    field = correlate(photo.reduced(step), reduced)
    best: tuple[float, Place] | None = None
    for peak in peaks(np.maximum(field, 0), 2, MIN_LOOK, LOOKED_AT):
        left, top = round(peak.column * step) - step, round(peak.row * step) - step
        around = photo.grey(PixelWindow(left, top, columns + 2 * step, rows + 2 * step))
        fine = correlate(around, template.pixels)
        row, column = peak_pixel(fine)
        if fine[row, column] >= SAME_PIXELS and (best is None or fine[row, column] > best[0]):
            best = float(fine[row, column]), (left + column + template.centre[0], top + row + template.centre[1])
    return None if best is None else best[1]


def near(place: Place | None, other: Place, reach: float) -> bool:
    """Whether a place is known and within reach (px) of another."""
    return place is not None and math.dist(place, other) <= reach
