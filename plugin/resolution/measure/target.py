"""The bar target: which group is how wide, and when it counts as resolved."""
from __future__ import annotations

import math
from dataclasses import dataclass

# Ground resolved distance
DEFAULT_BARS = 3  # Walczykowski et al. 2009, figures 4 to 10; USAF-1951
MIN_BARS = 2  # one bar has no gap to its neighbour
DEFAULT_REFERENCE_GROUP = 9  # Walczykowski et al. 2009, section 4: group 9 is 30 cm
DEFAULT_REFERENCE_GRD_CM = 30.0  # the same, and the Open Skies limit
MIN_REFERENCE_GRD_CM = 1e-3  # of a target under a microscope
DEFAULT_GROUP_STEP = 2 ** (1 / 6)  # tables 3A and 3B: 30.00, 33.67, 42.42, 60.00, 67.35, 75.60 cm
MIN_GROUP_STEP = 1.0001  # groups that are alike are none
MAX_GROUP_RATIO = 1e9  # of widths to the reference group's: no target has more; far beyond it numbers overflow
DEFAULT_CRITERION = 0.5  # Walczykowski et al. 2009, section 4: at least half of the group's DN amplitude
FULL_AMPLITUDES = ("group", "coarsest")  # the paper's; a reference that does not change from group to group
DISTANCES = ("cycle", "bar")  # what a distance is the width of: the paper's definition; what its figures are of
DEFAULT_BAR_WIDTH_PX = 3.0  # either side: seven pixels lower the noise 2.6 times
MIN_NOISE_RATIO = 3.0  # amplitude over the noise of the ground: three standard deviations
MAX_BAR_LINE_PX = 2000  # some 130 MB of pixels of three bands around it
BAYER_PATTERNS = ("RGGB", "BGGR", "GRBG", "GBRG")  # colours row by row: the filter of the paper and its three turns
DEMOSAICS = ("bilinear", "malvar", "edge_aware")  # the paper's; Malvar, He, Cutler 2004; OpenCV's, if installed

DIRECTIONS = ("along", "across")  # to the flight: the direction in which a line crosses the bars
GROUP, COARSEST = FULL_AMPLITUDES
CYCLE, BAR = DISTANCES


@dataclass(frozen=True)
class Target:
    """A calibration target and the criterion that its groups are judged by (Walczykowski et al. 2009, section 4)."""

    bars: int = DEFAULT_BARS  # bars in each group
    reference_group: int = DEFAULT_REFERENCE_GROUP  # number of the group whose width is known
    reference_grd_cm: float = DEFAULT_REFERENCE_GRD_CM  # cm on the ground, of what ``grd_of`` says
    step: float = DEFAULT_GROUP_STEP  # how many times as wide the next coarser group is
    criterion: float = DEFAULT_CRITERION  # share of the full amplitude that the bars of a resolved group keep
    reversed: bool = False  # whether higher numbers are coarser
    full_amplitude: str = GROUP  # the criterion's: the ``group``'s bars against plain gaps, or the ``coarsest``'s
    grd_of: str = CYCLE  # what a distance is the width of: ``cycle``, a bar and a gap together; ``bar``, one of them

    def grd_cm(self, group: int) -> float:
        """Ground resolved distance of a group, cm: of a bar and a gap together, or of one bar (``grd_of``)."""
        finer = group - self.reference_group
        return self.reference_grd_cm * self.step ** (finer if self.reversed else -finer)

    def has_group(self, group: int) -> bool:
        """Whether a target can have bars of that number: so near the reference group that they have a width."""
        return abs(group - self.reference_group) * math.log(self.step) <= math.log(MAX_GROUP_RATIO)

    def cycle_cm(self, group: int) -> float:
        """Width of a bar and a gap of a group together, cm."""
        return self.grd_cm(group) * (2 if self.grd_of == BAR else 1)
