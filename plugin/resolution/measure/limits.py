"""Limits and defaults that several files here share, each with its source."""
from __future__ import annotations

# Ground resolved distance
DEFAULT_BARS = 3  # Walczykowski et al. 2009, figures 4 to 10; USAF-1951
MIN_BARS = 2  # one bar has no gap to its neighbour
DEFAULT_REFERENCE_GROUP = 9  # Walczykowski et al. 2009, section 4: group 9 is 30 cm
DEFAULT_REFERENCE_GRD_CM = 30.0  # the same, and the Open Skies limit
DEFAULT_GROUP_STEP = 2 ** (1 / 6)  # tables 3A and 3B: 30.00, 33.67, 42.42, 60.00, 67.35, 75.60 cm
MAX_GROUP_RATIO = 1e9  # of widths to the reference group's: no target has more; far beyond it numbers overflow
DEFAULT_CRITERION = 0.5  # Walczykowski et al. 2009, section 4: at least half of the group's DN amplitude
FULL_AMPLITUDES = ("group", "coarsest")  # the paper's; a reference that does not change from group to group
DISTANCES = ("cycle", "bar")  # what a distance is the width of: the paper's definition; what its figures are of
DEFAULT_BAR_WIDTH_PX = 3.0  # either side: seven pixels lower the noise 2.6 times
MIN_NOISE_RATIO = 3.0  # amplitude over the noise of the ground: three standard deviations
MAX_BAR_LINE_PX = 2000  # some 130 MB of pixels of three bands around it
BAYER_PATTERNS = ("RGGB", "BGGR", "GRBG", "GBRG")  # colours row by row: the filter of the paper and its three turns
DEMOSAICS = ("bilinear", "malvar", "edge_aware")  # the paper's; Malvar, He, Cutler 2004; OpenCV's, if installed
