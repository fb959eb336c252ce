"""Limits and defaults that several files here share, each with its source."""
from __future__ import annotations

MAX_BLOCK_PIXELS = 1024 * 1024  # read at a time: 3 MB of 8 bit RGB, so memory is flat
AREA_PX = 16  # side of an area that is looked at: 256 pixels give the standard deviation to 4 %
MIN_AREAS = 8  # 2048 pixels: fewer areas say nothing about an image

# Colour balance
MAX_GREY_SPREAD = 0.10  # of the range, between the bands: five times the JRC limit, so that a cast is still seen
MIN_GREY_PIXELS = 256  # in all grey areas together: their means are then known to a sixteenth of the noise
GREY_TONES = (0.04, 0.96)  # of the range: beyond it a band may be cut off, and what is cut off has no colour

# The step at a seam; French order of 16 September 2003, section 8.4
SEAM_NEAR_PX = 2  # from the seam
SEAM_FAR_PX = 10
SEAM_STATION_PX = 16  # along the seam: one difference of means each
MIN_SEAM_STATIONS = 4  # 64 px of seam
