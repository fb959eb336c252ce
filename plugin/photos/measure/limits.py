"""Limits and defaults that several files here share, each with its source, and the words that are chosen from."""
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

OPERATIONS = ("negative", "grey", "mean", "gaussian", "laplace", "sobel")  # on a photo that is enhanced
NEGATIVE, GREY, MEAN, GAUSSIAN, LAPLACE, SOBEL = OPERATIONS
MODELS = ("affine", "similarity", "projective")  # of the transformation from pixels to millimetres
AFFINE, SIMILARITY, PROJECTIVE = MODELS
KINDS = ("cross", "dot", "ring with dot", "ring with cross", "wedge")  # figures of marks
CROSS, DOT, RING_WITH_DOT, RING_WITH_CROSS, WEDGE = KINDS
SURFACES = ("correlation", "brightness")  # what the second-degree surface is laid through
CORRELATION, BRIGHTNESS = SURFACES
STATES = ("measured", "given", "failed")  # of a mark, by the origin of its place
MEASURED, GIVEN, FAILED = STATES
EVIDENCE = ("positions", "dots", "data strip", "residuals", "marks", "assumed")  # what decided how a photo lies
POSITIONS, DOTS, DATA_STRIP, RESIDUALS, MARKS, ASSUMED = EVIDENCE
"""``marks``: their own arrangement allows one way only; ``assumed``: nothing tells, so it is taken to lie upright."""
