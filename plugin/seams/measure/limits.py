"""Limits and defaults that several files here share, each with its source."""
from __future__ import annotations

JUDGED_MAGNIFICATION = 2.0  # Pyka 2010: detail is best judged at two-fold magnification
JUST_VISIBLE = 1.0  # just noticeable differences of contrast: what an eye just sees
STANDARD_SPACING_M = 200.0  # along the seam: every second window length
MIN_MISREGISTRATION_PX = 0.7  # from one image to another: those that fit to half a pixel are well oriented
LINEAR, COSINE, GAUSSIAN = "linear", "cosine", "gaussian"
RAMPS = (LINEAR, COSINE, GAUSSIAN)
"""How a feather leads from one source to the other."""
MAX_SIGNIFICANT_KEPT = 0.7  # of the finest detail's variance beside a seam; reasons: docs/method/default_limits.md
MAX_SIGNIFICANT_SHARPNESS_SQUARED = 0.15  # of the whole window; bilinear resampling at half a pixel leaves 0.19
SEAMS, FULL = "seams", "full"
DENSITIES = (SEAMS, FULL)
"""Of a scan. ``seams``: everything along the seams, samples elsewhere. ``full``: everything everywhere."""
STANDARD_PIECE_M = 25.0  # of a seam: some 500 px at 5 cm, 100 px at 25 cm
WORST_COUNT = 50  # windows that one operator judges within half an hour
