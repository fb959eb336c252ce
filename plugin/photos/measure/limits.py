"""Limits and defaults that several files here share, each with its source."""
from __future__ import annotations

MOST_SCANNED_PX = 100_000  # along a side: 300 mm of film at 3 um, finer than any photogrammetric scanner
DEFAULT_SEARCH_MM = 8.0  # the sheet of film lies on the scanner by hand
DEFAULT_MIN_CORRELATION = 0.5  # usual in image matching: half of the standard deviation explained
PIXEL_SOFTNESS = 0.35  # px, standard deviation: a pixel averages over its square (0.29) and no scanner is perfect
MIN_TEMPLATE_PX = 5  # below that a surface over 5 x 5 px has no room
FILM_DEFORMATION = 0.001  # of the frame: film and scanner against a similarity, twice what is usual
MAX_ROTATION_DEG = 6.0  # of a photo in the scanner
ONE_PLACE_PX = 3.0  # two marks nearer than that are one that was found twice
MIN_SUPPORT = 3  # marks that have to agree where no position is given: two lie right for any scale and rotation
