"""Limits and defaults that several files here share, each with its source."""
from __future__ import annotations

JUDGED_MAGNIFICATION = 2.0  # Pyka 2010: detail is best judged at two-fold magnification
JUST_VISIBLE = 1.0  # just noticeable differences of contrast: what an eye just sees
MEASURABLE_SIDE_PX = 256  # of a window: of 90 with 64 px 89 could not be compared
STANDARD_SPACING_M = 200.0  # along the seam: every second window length
MIN_MISREGISTRATION_PX = 0.7  # from one image to another: those that fit to half a pixel are well oriented
LINEAR, COSINE, GAUSSIAN = "linear", "cosine", "gaussian"
RAMPS = (LINEAR, COSINE, GAUSSIAN)
"""How a feather leads from one source to the other."""
MAX_SIGNIFICANT_KEPT = 0.7  # of the finest detail's variance beside a seam; reasons: docs/method/default_limits.md
MAX_SIGNIFICANT_SHARPNESS_SQUARED = 0.15  # of the whole window; bilinear resampling at half a pixel leaves 0.19
SHARPNESS_TOLERANCE = 0.02  # what a sound hard cut may miss: 0.998 to 1.004 were found on real imagery
MOST_LEVELS = 4  # of a scan: its cells of 16 px hold whole coefficients of so many
SEAMS, FULL = "seams", "full"
DENSITIES = (SEAMS, FULL)
"""Densities of a scan. ``seams``: everything along the seams, samples elsewhere. ``full``: everything everywhere."""
STANDARD_PIECE_M = 25.0  # of a seam: some 500 px at 5 cm, 100 px at 25 cm
WORST_COUNT = 50  # windows that one operator judges within half an hour
FAILED, REDUCED, ALL = "failed", "reduced", "all"
MENDED_SEAMS = (FAILED, REDUCED, ALL)
"""Pieces that keep less than 70 %; those too that measurably lost something; every piece."""
MEND_WIDTH_M = 20.0  # on either side of a seam, that a new cut may move: around a house
MEND_BLEND_PX = 3  # at the cut: what a pixel's edge is smoothed over
MOST_BLEND_PX = 31
