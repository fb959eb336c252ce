"""What a loss of detail means to an eye: just noticeable differences of contrast (JND) at the desk's magnification.

The detail of level r stands as the contrast c of luminance, rms over mean, at one frequency f on the screen. An eye
sees it from c_T = 1 / S(f) on (S: Mannos and Sakrison 1974), and tells it from more or less of it by

    delta_c(c) = c_T max(1, (c / c_T)^0.6)        (Legge and Foley 1980)

so between what the sources have, c, and what the mosaic kept of its variance, c sqrt(kept), there lie

    the integral of dc / delta_c(c)               from c sqrt(kept) to c

differences that an eye just notices. Those of all levels together are their Minkowski sum (Quick 1974).

- J. L. Mannos, D. J. Sakrison: The effects of a visual fidelity criterion on the encoding of images, IEEE Transactions
  on Information Theory 20 (4), 1974, 525-536.
- G. E. Legge, J. M. Foley: Contrast masking in human vision, Journal of the Optical Society of America 70 (12), 1980,
  1458-1471.
- R. F. Quick: A vector-magnitude model of contrast detection, Kybernetik 16, 1974, 65-67.
- A. B. Watson, A. J. Ahumada: A standard model for foveal detection of spatial contrast, Journal of Vision 5 (9), 2005,
  717-740.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy import ndimage

from ....imagery.rasters import Raster, value_range
from ..limits import JUDGED_MAGNIFICATION
from ..profile.cell_table import CELL_PX, CellTable
from ..profile.seam_profile import SeamProfile, strip_bins
from ..profile.window_detail import SAMPLE_PX, LossPicture
from ..tone import coarse_means

SHOWN_PX = 160  # a side of the part of a window that is shown at 2x
_MOST_PLACES = 6  # of a window
_WORTH_A_LOOK = 0.25  # of what the worst place lost
_EVEN = 0.02  # of a place's detail: less is lost nowhere, and the seam itself is looked at
_LITTLE_MORE = 0.5  # of what is lost all over: no place is worse by more, and the seam itself is looked at


def worst_places(loss: LossPicture, is_along: bool = False, is_hidden: bool = False) -> list[tuple[float, float]]:
    """Column and row, px from the window's upper left, of the middles of the squares of ``SHOWN_PX`` that lost most,
    which do not overlap, the worst first; of those on the seam where its loss ``is_along`` it. Where nothing is lost,
    or about as much all over, or that is to be hidden, squares along the seam, from its middle on.
    """
    side = max(SHOWN_PX // loss.cell_px, 1)
    lost = ndimage.uniform_filter(1 - np.clip(np.nan_to_num(loss.kept, nan=1.0), 0, 1), side, mode="constant")
    most, even = float(lost.max(initial=0)), float(np.median(lost))
    is_even = len(loss.seam) > 0 and most - even < _LITTLE_MORE * even
    points = loss.seam * SAMPLE_PX + SAMPLE_PX / 2
    if is_hidden or most < _EVEN or is_even:
        order = np.hypot(*(points - points.mean(axis=0)).T) if len(points) else np.empty(0)
    else:
        if not (is_along and len(points)):
            points = (np.argwhere(lost > 0) + 0.5) * loss.cell_px
        order = -lost[tuple((points // loss.cell_px).astype(int).T)]
        points, order = (values[order <= _WORTH_A_LOOK * order.min()] for values in (points, order))
    points = points[np.argsort(order, kind="stable")]
    places: list[tuple[float, float]] = []
    while len(points) and len(places) < _MOST_PLACES:
        row, column = points[0]
        places.append((float(column), float(row)))
        points = points[np.abs(points - points[0]).max(axis=1) >= SHOWN_PX]
    return places


PEAK_SENSITIVITY = 200.0  # 1 / contrast: of the order that all measurements of gratings on a bright screen have
_PEAK = 0.9809  # of Mannos and Sakrison's formula, at 7.9 cycles a degree
DISCRIMINATION_EXPONENT = 0.6  # Legge and Foley 1980: 0.62 in the mean of their masks
POOLING_EXPONENT = 3.0  # between some 2.6 (Watson and Ahumada 2005) and the 4 of early summation over channels
CENTRE_FREQUENCY = 3 / 8  # cycles a pixel: the middle of the octave from 1/4 to 1/2 that level 1 holds
_CELL_STEPS = CELL_PX.bit_length() - 1  # halvings that lead from pixels to cells


SCREEN_DPI, DISTANCE_CM = 96.0, 60.0  # of the screen, and from it to the eye
GAMMA = 2.2  # luminance of the screen over grey values, both as shares of white: sRGB's (IEC 61966-2-1) as one power
FLARE = 0.01  # light that the room adds to all of the screen, as a share of white: sRGB's encoding viewing flare
_PIXELS_PER_DEGREE = 2 * DISTANCE_CM * math.tan(math.radians(0.5)) * SCREEN_DPI / 2.54


def visibility(
    kept: Sequence[float | None], detail_variance: Sequence[float], grey: float, white: float,
    magnification: float = JUDGED_MAGNIFICATION,
) -> float | None:
    """The loss of detail beside a seam in JND, 1 being what an eye just sees side by side.

    By level, from level 1: what is ``kept`` of the variance, and the variance that the sources' detail has there, DN
    squared. ``grey``: the mosaic's mean there, ``white``: the brightest value it can have, DN above black; what is
    brighter is shown as white. A level of which nothing is known adds nothing, and more detail than there was is no
    loss. None where level 1 is not known or nothing says how bright the screen is.
    """
    if not kept or kept[0] is None or not (grey > 0 and white > 0):
        return None
    brightness, total = min(grey / white, 1.0), 0.0
    # Contrast of luminance, by the tangent of the screen's curve at the mean.
    slope = GAMMA * brightness ** (GAMMA - 1) / white / (FLARE + brightness**GAMMA)
    for level, (share, variance) in enumerate(zip(kept, detail_variance), 1):
        if share is not None:
            reach = 0.114 * CENTRE_FREQUENCY / 2 ** (level - 1) / magnification * _PIXELS_PER_DEGREE
            sensitivity = PEAK_SENSITIVITY / _PEAK * 2.6 * (0.0192 + reach) * math.exp(-(reach**1.1))
            contrast = slope * math.sqrt(variance) * sensitivity
            lost = _steps_from_nothing(contrast) - _steps_from_nothing(contrast * math.sqrt(max(share, 0.0)))
            total += max(lost, 0.0) ** POOLING_EXPONENT
    return float(total ** (1 / POOLING_EXPONENT))


def _steps_from_nothing(times_threshold: float) -> float:
    """The integral from 0 of dc / delta_c, contrasts as multiples of the threshold."""
    if times_threshold <= 1:
        return times_threshold
    return 1 + (times_threshold ** (1 - DISCRIMINATION_EXPONENT) - 1) / (1 - DISCRIMINATION_EXPONENT)


MOST_REFLECTANCE = 2.0
"""Reflectance of the brightest ground, glints with it; grey values are more."""


def white_grey(raster: Raster, largest: float) -> float:
    """The grey value that a screen shows as white, DN above black; ``largest``: of means of its cells.

    Black is 0. Values without a range of their own are shown as those of the smallest usual depth that holds them, and
    reflectances up to the largest.
    """
    if raster.data_type.startswith("float") and largest <= MOST_REFLECTANCE:
        return max(largest, MOST_REFLECTANCE * 1e-6)
    known = raster if raster.data_type in ("uint8", "uint16") else replace(raster, data_type="uint16", bits=None)
    grey = value_range(known, largest)
    assert grey is not None
    return grey[1]


def window_visibility(
    profile: SeamProfile | None, cells: CellTable, plane: np.ndarray, inside: tuple[slice, slice], raster: Raster
) -> float | None:
    """Visibility of a window's loss by its profile and cells; ``plane``: (rows, columns), the mosaic's pixels in the
    band that is judged, ``inside`` their place in what was read around them, in which cells have theirs."""
    if profile is None:
        return None
    rows, columns = (length // CELL_PX for length in plane.shape)
    means = coarse_means(plane[: rows * CELL_PX, : columns * CELL_PX], _CELL_STEPS)
    strip = cells.chosen(cells.bin < strip_bins(0).stop)
    row, column = strip.row - inside[0].start // CELL_PX, strip.column - inside[1].start // CELL_PX
    known = (row < rows) & (column < columns)
    weights = strip.area[0][known]
    if not weights.sum():
        return None
    grey = float(np.average(means[row[known], column[known]], weights=weights))
    return visibility(profile.kept, profile.energy, grey, white_grey(raster, float(means.max())))
