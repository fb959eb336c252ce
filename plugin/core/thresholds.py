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

# Which source the mosaic follows, and why contrast was lost
MIN_SHIFT_PEAK = 0.15  # height of the phase correlation's peak that is no accident, in large tiles
MIN_SHIFT_PEAK_PX = 20.0  # over the tile's side, in small ones: unrelated tiles reach 15 / side
SAME_SHIFT_PX = 1.5  # tiles whose shifts, to the whole pixel, differ by less look at the same image
MIN_TILE_SHARE = 0.8  # of a tile's pixels have to come from the source whose shift is asked for
MIN_WINNER_LEAD = 0.1  # of the correlation over the next source's: below it a wider neighbourhood decides
MIN_MIXTURE_FIT = 0.9  # share of the mosaic's fine detail that a mixture of two explains; a hard cut stays below
MIN_MIXTURE_GAIN = 0.05  # by which the mixture has to explain more than the better source alone
MIN_MIXTURE_WEIGHT = 0.1  # of each of the two sources
MIN_FOLLOWED_SHARE = 0.005  # of a window's pixels: sources that win fewer do not count
MIN_TONE_RESIDUAL = 0.05  # grey values: a line that fits the coarse means this well is one
MIN_GAMMA, MAX_GAMMA = 0.2, 5.0  # that are looked for
MIN_GAMMA_GAIN = 0.1  # a power function has to leave residuals smaller by this share
MIN_SOURCE_FIT = 0.9  # share of the mosaic's fine detail that its sources explain; below it shifts are looked for
MIN_EXPLAINED = 0.5  # of the mosaic's fine detail within 36 px; a source 2 px off explains 0.1, a blur of 1.2 px 0.6
MIN_UNEXPLAINED_SHARE = 0.02  # of the pixels: a part of a window this large is looked at for a shift of its own
MIN_FIT_GAIN = 0.1  # by which shifted sources have to explain more to be believed
MIN_CAUSE_FIT = 0.05  # strangers explain 0.01 to 0.03; a Gaussian blur of 2 px leaves 0.1
MIN_CLIPPED_SHARE = 0.005  # of the pixels: the share that JRC's specification allows in one tail of the histogram
MIN_UNMIXED_SHARE = 0.05  # of the pixels: fine contrast of less is not taken for that of the window
MIN_UNMIXED_SQUARES = 64  # of 2^R px that follow one source, for the tone to be taken from them alone
MIN_MOSTLY_MIXED = 0.5  # of the pixels: beyond it gamma and gains of the colours are those between two sources
MIN_COLOUR_SHIFT = 1.05  # gains of the colours 5 % apart
MIN_GAMMA_CHANGE = 1.1  # as a factor, either way
MAX_NARROWED_GAIN = 0.9  # a tenth of the contrast
MAX_MIXED_NARROWED_GAIN = 0.75  # of windows that are mostly mixed: halves of two sources had 0.85 and more
MIN_MISREGISTRATION_PX = 0.4  # half a pixel less what a shift measured in a small part is off by
MAX_BLURRED_SHARPNESS = 0.93  # a hard cut has 0.99 to 1.01, a Gaussian blur of 0.5 px 0.7
MIN_MIXED_SHARE = 0.005  # of the pixels: a hard cut has 0.0001, a feather of 7 px some 0.02
