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

# Sensor models
WGS84_WKT_CODE = "EPSG:4326"
WGS84_SEMI_MAJOR_M = 6378137.0
WGS84_FLATTENING = 1 / 298.257223563
EGM96, EGM2008 = "EPSG:5773", "EPSG:3855"
MAX_NEWTON_ITERATIONS = 30  # the inverse of a smooth model takes four or five
MAX_RATIONAL_ITERATIONS = 100  # real scenes take three to ten, noise in few points more
MAX_RATIONAL_STEP_PX = 1e-7  # below a tenth of the accuracy that exact points have to be recovered with
MIN_DENOMINATOR = 1e-6  # a quotient is kept away from its poles while it is iterated
MIN_CHECK_POINTS = 5  # fewer say little about an error: leave-one-out instead
DEFAULT_CHECK_SHARE = 0.25  # Kurczynski and Wolniewicz: 7 to 10 control and 10 to 46 check points
MAX_LEFT_OUT = 40  # fits of leave-one-out; with more points they are left out in groups
# blunders
BLUNDER_PROBABILITY = 0.001  # Baarda: one good point in a thousand is suspected
RAYLEIGH_MEDIAN = 1.1774  # of the length of a vector of two normal coordinates of standard deviation 1
MAX_BLUNDER_SIGMAS = 5.0  # of check points, which the fit has not seen
TUKEY_SIGMAS = 4.685  # biweight, 95 % efficient for normal errors
MIN_SIGMA_PX = 1e-7  # rounding: no measured coordinate is better
ROBUST_STEPS = 15  # of each stage; the weights have settled before
# how points lie
MIN_SPREAD = 0.05  # of their shorter extent to the longer one: narrower ones lie on a line
MAX_EXTRAPOLATED = 0.5  # share of the image outside the control points' outline
MAX_LINEAR_CONDITION = 1e6  # of the affine camera through the points, its columns scaled
MAX_CONDITION = 1e12  # float64 keeps four digits of the unknowns
# the parametric model: nominal orbit and priors (standard deviations)
DEFAULT_ORBIT_HEIGHT_KM = 694.0  # Pleiades; IKONOS 681, QuickBird 450, EROS-A1 480, WorldView-3 617
ORBIT_HEIGHTS_KM = {  # by the satellite's name in the image's metadata; the operators' data sheets
    "PHR": 694.0, "PLEIADES": 694.0, "SPOT": 694.0, "PNEO": 620.0, "IK": 681.0, "QB": 450.0, "WV01": 496.0,
    "WV02": 770.0, "WV03": 617.0, "WV04": 617.0, "GE01": 681.0, "GEOEYE": 681.0, "EROS": 480.0, "KOMPSAT": 685.0,
}  # fmt: skip
PUSHBROOM_POSITION_SIGMAS_M = (5e3, 5e3, 5e4)  # along, across, away: the affine camera's view, the orbit's height
PUSHBROOM_MOTION_SIGMAS_M = (1e3, 1e3, 300.0)  # over half the lines: the orbit is near circular
PUSHBROOM_ROTATION_SIGMAS = (  # rad about each axis: attitude, its rate, acceleration and jerk over half the lines
    (1e-2, 1e-2, 1e-2),
    (2e-3, 2e-3, 2e-3),  # agile satellites pitch while they scan
    (1e-5, 1e-5, 1e-5),  # 2": what star trackers resolve (Fraser 2000, cited by Kurczynski and Wolniewicz)
    (3e-6, 3e-6, 3e-6),
)
PUSHBROOM_SCALE_SIGMA = 5e-3
PRINCIPAL_SIGMA_PX = 50.0  # of the principal column around the image's middle
PRINCIPAL_SHARE = 0.1  # of the points' width where the image's is not known
PUSHBROOM_DIFFERENCE = 1e-2  # of a prior: derivatives good to 1e-7 px
MAX_PUSHBROOM_ITERATIONS = 25
MAX_PUSHBROOM_STEP_PX = 1e-6
MIN_REDUNDANCY = 1e-9  # where the points determine as much as they can
MAX_SIGMA_ROUNDS = 12
MAX_SIGMA_CHANGE = 0.1  # relative: the standard deviation of the points has settled
DEFAULT_SIGMA_PX = 0.5  # a point identified in an image
MAX_LINE_ITERATIONS = 30  # the line that sees a point: Newton's method, three steps suffice on real scenes
MAX_LINE_STEP_PX = 1e-7
# RPC
RPC_GRID = (21, 21, 7)  # columns, rows, heights of the terrain-independent fit: 39 unknowns an axis
MIN_RPC_HEIGHTS_M = 50.0  # half the range of heights at least, so that the quotient is sound around flat terrain
RPC_DOMAIN = 1.1  # how far beyond its own range, relative to it, an RPC is still taken at its word
# orthorectification
MAX_DEM_PIXELS = 100_000_000  # 400 MB; 10 to 30 m meshes suffice (Kurczynski and Wolniewicz, conclusion 7)
ORTHO_GRID = 21  # points a side on which an orthoimage's error is measured
UNDULATION_STEP_PX = 16  # of a terrain model: the geoid is smooth
# the recommendation
MAX_WORSE = 1.25  # a model that the paper prefers may be this much worse than the best, relative
FLAT_SHARE = 0.5  # of a pixel: heights that move the image by less make flat terrain
