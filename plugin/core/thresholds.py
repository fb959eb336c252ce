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

# Judging the judge
MIN_VERDICTS = 5  # of either kind: below it one verdict moves the sensitivity by more than 20 %
RESAMPLES = 2000  # of the verdicts; Efron and Tibshirani 1993, section 12.5: 1000 and more for an interval's ends
PERCENTILES_95 = (2.5, 97.5)
NORMAL_95 = 1.959964  # standard errors either side of a normal value that hold 95 %
WANTED_AREA_ERROR = 0.05  # half of the 95 % interval of an area under the ROC curve that is known well enough

# The report
REPORT_CLIP_PX = 160  # a side of the part that is shown at 2x: two of them fit beside each other on A4
MIN_REPORT_CLIP_PX = 64  # smaller ones show too little
REPORT_CLIPS_BYTES = 14_000_000  # of all JPEG clips together: with charts and base64 a report stays below 30 MB
MAX_REPORT_SOURCES = 2  # shown of a window, the least sharp ones; with chart and mosaic they fill a page
MAX_REPORT_DETAILS = 300  # flagged windows with curves and clips; the others stand in the table
MAX_SEARCHED_SIDE_PX = 512  # of a window, around its centre (on the seam), where the part that lost most is looked for
MAX_OVERVIEW_PIXELS = 64_000_000  # that may have to be decoded for the sketch's background: about a second
OVERVIEW_SIDE_PX = 900  # of the sketch's background, 170 mm wide
