"""Every limit and default, each with its source. Change one here and it changes everywhere."""
from __future__ import annotations

# The decomposition
DEFAULT_WAVELET = "coif3"  # Pyka 2009: Coiflet of order 3
DEFAULT_LEVELS = 3  # Pyka 2010, section 5: three levels, 1024 px down to 128 px
MIN_LEVELS = 1
WAVELETS = (  # the orthogonal ones of PyWavelets; kept here so that the toolbox can list them without loading it
    "haar",
    *(f"db{n}" for n in range(1, 39)),
    *(f"sym{n}" for n in range(2, 21)),
    *(f"coif{n}" for n in range(1, 18)),
    "dmey",
)
MAX_LEVELS = 8  # 256 px a coarse pixel: beyond it no window of about 100 m is left

# The windows
STANDARD_SIDE_M = 100.0  # Pyka 2010, section 5: rectangles with sides a little over 100 m
STANDARD_SPACING_M = 200.0  # along the seam: every second window length
MIN_SIDE_PX = 64  # below it a level-3 component has fewer than 8 x 8 coefficients
MAX_SHARED_SHARE = 0.5  # two windows on one seam share at most half of their pixels

# The pixels
MAX_INVALID_SHARE = 0.001  # filled with the mean up to here; 0.1 % moves a share by less than 0.001 of itself
MAX_PIXEL_SIZE_DIFFERENCE = 0.01  # relative; 10 px over a window of 1024 px
MAX_SYSTEM_SHIFT_PX = 0.01  # two reference systems whose coordinates agree this closely are one
MAX_SKEW = 1e-6  # of a pixel per pixel: 0.05 px across 50 000 px
MAX_WINDOW_PIXELS = 8192 * 8192  # 67 million: some 2 GB while it is measured

# Precision of the measurement: shares to 1e-7 of the total variance, components to a relative 1e-4
MIN_CHAIN_SHARE = 1e-3  # a component smaller than 1e-7 / 1e-4 is computed for itself, not as a difference
MIN_FLOAT32_PIXELS = 1024 * 1024  # smaller clips are fast in float64 too, and average less rounding out
FLOAT32_WAVELETS = (  # those whose float32 shares stayed within 1e-7 on textures and orthoimages of 1024 x 1024 px
    *("coif1", "coif2", "coif3", "db2", "db3", "db4", "db5", "db6"),
    *("sym2", "sym3", "sym4", "sym5", "sym6", "sym7", "sym8", "sym9"),
)
MAX_FILTER_ERROR = 1e-9  # orthonormality of PyWavelets' coefficients: 1e-11 at worst (sym20), dmey 2e-3


# Seamlines
END_SNAP_PX = 0.1  # ends of lines nearer than this meet: far below a raster step, far above rounding
BORDER_SNAP_PX = 0.5  # borders of polygons nearer than this are one: half a raster step
STRAIGHTEN_PX = 1.5  # a staircase leaves its line by up to 1 px, with a noisy step by 1.5 px
BRANCH_REACH_PX = 10  # how far a branch's direction is looked at: beyond it a raster step turns it by < 6 degrees
BRANCH_TURN_DEG = 75.0  # the straightest two of three branches turn by 60 at most, so one seam always goes on
MIN_SEAM_PX = 8  # around two or three pixels: noise of labels
MIN_SEAM_SHARE = 1 / 16  # of a window's side: a seam shorter and narrower than that is 0.4 % of the window
MAX_EXTENT_PX = 1e8  # 5000 km at 5 cm: a wider layer has another reference system than the mosaic

# The verdict
MIN_SHARE = 1e-20  # of the variance: smaller ones are rounding of float64, and ratios to them mean nothing
MAX_SIGNIFICANT_RATIO = 0.5  # Pyka 2010, section 5: detail at level 1 at least halved in the visible cases
LUMINANCE_WEIGHTS = (0.299, 0.587, 0.114)  # red, green, blue; ITU-R BT.601, Pyka 2009
MAX_REASONS = 3  # sources named in the reason of a window; more would not be read

# Ground resolved distance
DEFAULT_BARS = 3  # Walczykowski et al. 2009, figures 4 to 10; USAF-1951
MIN_BARS = 2  # one bar has no gap to its neighbour
DEFAULT_REFERENCE_GROUP = 9  # Walczykowski et al. 2009, section 4: group 9 is 30 cm
DEFAULT_REFERENCE_GRD_CM = 30.0  # the same, and the Open Skies limit
DEFAULT_GROUP_STEP = 2 ** (1 / 6)  # tables 3A and 3B: 30.00, 33.67, 42.42, 60.00, 67.35, 75.60 cm
DEFAULT_CRITERION = 0.5  # Walczykowski et al. 2009, section 4: at least half of the group's DN amplitude
DEFAULT_BAR_WIDTH_PX = 3.0  # either side: seven pixels lower the noise 2.6 times and fit into bars of five widths
MAX_BAR_TURN_DEG = 10.0  # how roughly a line may be drawn: a hand does better
MIN_NYQUIST_PX = 2.0  # a bar and a gap narrower than two pixels are aliased: Shannon
MIN_ALIAS_FREE_PX = 2.5  # three bars that are finer than two pixels can't seem so far apart in the 5 px they cover
MAX_BAR_SPACING_DIFFERENCE = 0.25  # relative, two steps of 2^(1/6): bars further off are not the group's
MAX_TARGET_SCALE_DIFFERENCE = 0.2  # relative: more is no error of drawing or of the pixel size
MIN_BAR_PROMINENCE = 0.25  # of the full amplitude: half the criterion, so that bars below it are still counted
MIN_NOISE_RATIO = 3.0  # amplitude over the noise of the ground: three standard deviations
MAX_SATURATED_SHARE = 0.25  # of the middle of a bar: more is not noise that touches the limit
BAR_MARGIN = 0.2  # of a line's length: half a cycle of three bars, when the line ends with the outer ones
GROUND_REACH_PX = 12  # how much further than its length a line's surroundings go: two squares of ground at least
GROUND_SQUARE_PX = 6  # side of a square of ground: 36 values, its noise to 12 %
PLAIN_GROUND_PERCENTILE = 10  # of the squares: as many are plain beside the most crowded target, USAF-1951
MAX_BAR_LINE_PX = 2000  # some 130 MB of pixels of three bands around it
MAX_LINE_BEND = 0.05  # of its length that a line across the bars may leave its chord
MIN_OBSERVATIONS = 5  # of the minimum height: the Open Skies treaty asks for five passes
DEFAULT_REQUIRED_GRD_CM = 30.0  # Open Skies: optical cameras
BAYER_PATTERNS = ("RGGB", "BGGR", "GRBG", "GBRG")  # colours row by row: the filter of the paper and its three turns
DEMOSAICS = ("bilinear", "edge_aware")  # the paper's; OpenCV's, which needs that package
