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
MAX_STRONGLY_BLURRED_SHARPNESS = 0.75  # a Gaussian blur of 0.5 px: nothing else takes as much
MAX_BLURRED_SHARPNESS = 0.93  # a hard cut has 0.99 to 1.01, a Gaussian blur of 0.5 px 0.7
MIN_MIXED_SHARE = 0.005  # of the pixels: a hard cut has 0.0001, a feather of 7 px some 0.02

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

# Random noise
NOISE_WINDOW_PX = 1024  # side of a window; Pyka 2009, section 3
NOISE_WINDOWS = 25  # at most, chosen on an image; Pyka 2009, section 3: 25 fragments
MIN_NOISE_LEVELS = 2  # the rule compares level 1 with level 2
GAUSSIAN_QUARTILE = 0.6745  # median of the absolute value of a standard normal variable
MAX_NOISE_PLACES = 10  # places along an image's side that are looked at: 100 reduced reads at most
NOISE_SHRINK = 8  # every 8th pixel shows where an image is saturated or invalid
SATURATION_STEP = 0.005  # windows whose saturated shares differ by less are alike and are chosen by their spread
MAX_MASKED_SHARE = 0.05  # filled alike in both groups; a hole of 5 % moves a share by 0.5 % of itself
MIN_PAIRED_SHARE = 0.5  # of a window: a raster that shows less of it takes no part there

# Values and areas of an image
BIT_DEPTHS = (8, 10, 11, 12, 14, 16)  # of cameras and scanners; the smallest that holds an image's largest value
MAX_BLOCK_PIXELS = 1024 * 1024  # read at a time: 3 MB of 8 bit RGB, so memory is flat
AREA_PX = 16  # side of an area that is looked at: 256 pixels give the standard deviation to 4 %
MAX_AREAS = 8192  # looked at, spread over the raster: memory is flat and the time a small part of the read's
MAX_QUADRANT_RATIO = 3.86  # variance between the four quadrants over that within: 99 % of F(3, 252), white noise
MID_TONES = (0.25, 0.75)  # of the available range: the middle half
UNIFORM_SHARE = 0.25  # the quarter of the uniform areas with the least noise: the others may be fine texture
MIN_AREAS = 8  # 2048 pixels: fewer areas say nothing about an image
MAX_NEUTRAL_SPREAD = 0.10  # of the range, between the bands: five times the JRC limit, so that a cast is still seen
MIN_STATISTICS_PIXELS = 4096  # 64 x 64: a histogram of fewer is no picture of an image

# The step at a seam; French order of 16 September 2003, section 8.4
SEAM_NEAR_PX = 2  # from the seam
SEAM_FAR_PX = 10
SEAM_STATION_PX = 16  # along the seam: one difference of means each
MIN_SEAM_STATIONS = 4  # 64 px of seam

# Rules of acceptance
_JRC = "JRC, Orthoimage technical specifications for the purpose of LPIS"
_FRENCH_ORDER = "Arrêté du 16 septembre 2003, section 8.4 (France)"
_TRADED = "Pyka 2010: tonal unity at the seams is bought with contrast"
DEFAULT_RULES = {
    "name": "JRC orthoimage specification for LPIS",
    "rules": [
        {"check": "clipped_low", "most": 0.005, "values": 5, "source": f"{_JRC}: overall clipping"},
        {"check": "clipped_high", "most": 0.005, "values": 5, "source": f"{_JRC}: overall clipping"},
        {"check": "peak", "most": 0.15, "source": f"{_JRC}: histogram peak"},
        {"check": "contrast", "least": 0.10, "most": 0.20, "source": f"{_JRC}: contrast"},
        {"check": "signal_to_noise", "least": 5, "source": f"{_JRC}: noise"},
        {"check": "colour_balance", "most": 0.02, "source": f"{_JRC}: colour balance"},
        {"check": "seam_step", "source": _FRENCH_ORDER},  # which leaves the limit to the contract
        {"check": "seam_contrast", "source": _TRADED},  # a figure to stand beside the step; it has no limit of its own
    ],
}

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

# Interior orientation
DEFAULT_SEARCH_MM = 8.0  # the sheet of film lies on the scanner by hand
DEFAULT_MIN_CORRELATION = 0.5  # usual in image matching: half of the standard deviation explained
STRIP_PIXELS = 4_000_000  # read at a time: 16 MB as float32
SEARCH_SIDE_PX = 3000  # the longer side of the photo for the first search: 80 um on a 23 cm photo
PIXEL_SOFTNESS = 0.35  # px, standard deviation: a pixel averages over its square (0.29) and no scanner is perfect
ARM_WIDTH = 0.6  # the arms of a ring with cross against its ring: UNBC's photo, Wild RC10
WEDGE_HALF_ANGLE_DEG = 30.0  # equilateral
MIN_TEMPLATE_PX = 5  # below that a surface over 5 x 5 px has no room
MIN_SYMMETRY = 0.8  # a cut-out that correlates so with itself turned by 180 degrees has a centre of its own
MIN_CURVATURE = 1e-4  # of a correlation: per px squared; true peaks have 0.005 and more
SURFACE_REACH_PX = 1  # 3 x 3 correlations for six coefficients; wider ones follow grain and scratches more
BRIGHTNESS_REACH_PX = 2  # 5 x 5 grey values: they hold the grain itself
MIN_LOCAL_CONTRAST = 0.002  # of the grey values' range: half a grey value of 8 bits is rounding
COARSE_SIZES_PX = (10.0, 12.0, 14.3, 17.0)  # of a mark at each level: an octave in steps of 1.19
COARSEST_SIDE_PX = 150  # of a photo: marks up to a tenth of it wide
CANDIDATES = 10  # a mark, a figure and a size: places that look alike in a search area
MIN_CANDIDATE_CORRELATION = 0.4  # of a coarse figure whose size may be off by 10 %
SURE_CORRELATION = 0.6  # mean of four marks in the right arrangement at one level
ARRANGEMENT_LEVEL_PX = 1.5  # a candidate's place at its level
ARRANGEMENT_PAIRS = 6  # all pairs of four marks, the widest of eight
FILM_DEFORMATION = 0.001  # of the frame: film and scanner against a similarity, twice what is usual
MAX_ROTATION_DEG = 6.0  # of a photo in the scanner
MIN_FRAME_SHARE = 0.7  # of the scan's shorter extent that the marks span at least
REFINING_SIZE_PX = 40.0  # of a mark while its figure is fitted: larger ones are reduced for it
GLANCING_SIZE_PX = 20.0  # the same while figures are compared
REFINING_SIZES = (0.87, 0.93, 1.0, 1.07, 1.15)  # against the coarse size, which is good to 10 %
REFINING_ROUNDS = 6
SETTLING_ROUNDS = 5  # two or three are enough to stay within 0.005 px
LOBE_SHARE = 0.7  # of a mark's size: a ring on its own edge, a cross on its own arm still correlates
MAX_SECOND_SHARE = 0.85  # of the best correlation: above it, which of the two is the mark is a guess
HALF_REACH_PX = 4  # how far a half may look for the mark
MAX_HALF_SHIFT_PX = 1.0  # of a half against the whole: UNBC's marks 0.3 px
MIN_FRAME_MM = 24.0  # the short side of 35 mm film, the smallest frame; 23 cm given in centimetres is below it
MAX_FRAME_MM = 1000.0  # no frame is that long; 23 cm given in micrometres is far above it
MIN_MARK_DISTANCE = 0.01  # of the frame: nearer ones are one mark with two names
SAME_PLACE = 0.02  # of the frame: marks of a square differ from it by far less
MIN_TELLING_MISFIT_MM = 0.03  # rms: twice what film and scanner leave on UNBC's photo
RESIDUALS_TELL = 0.5  # of the next best way to lie
STRIP_TELLS = 1.5  # the strip's margin against the next widest one
DOTS_TELL = 2.5  # the side with the dots against the next: UNBC 4 to 6
DOT_PROMINENCE = 0.25  # of the profile's range: UNBC's four dots 0.4
COARSEST_WINDOW_PX = 64  # of a search window: a coarse figure is 25 px wide with its ground
SEARCH_WINDOW_PX = 768  # of a search window at its finest: larger ones are reduced
OUTLIER_RATIO = 5.0  # of the others' standard deviation: with a redundancy of two, one in a thousand by chance
MIN_OUTLIER_MM = 0.05  # film and scanner leave up to that on good photos
MIN_PICTURE_PX = 20  # half a side of the picture of a mark
TELLING_PIXEL_MM = 0.2  # a ring of 2 mm is ten pixels wide
REFINED_ARRANGEMENTS = 5  # looked at closely, of one for each figure
WORTH_A_LOOK = 0.75  # of the best arrangement's sum of correlations
DISTINCT_SHARE = 1.5  # of a mark's size: so far around it nothing may look alike
DISTINCT_FRAME_SHARE = 0.03  # of the frame: 6 mm on 23 cm, so that an arm's end is told from its counterpart
SMOOTHING_PX = 0.5  # standard deviation of the blur against grain before a mark is measured: the lines are wider
NEARLY_AS_FIT = 0.15  # correlation below the best figure's: among these the one that explains most pixels is the mark
ONE_PLACE_PX = 3.0  # two marks nearer than that are one that was found twice
MIN_SUPPORT = 3  # marks that have to agree where no position is given: two lie right for any scale and rotation
PICTURE_MAGNIFICATION = 8  # of a mark in the report
PICTURE_SIDE_PX = 900  # of such a picture: a larger mark is reduced first
MAX_FILTER_PX = 101  # a wider one wants another tool
DEFAULT_FILTER_PX = 3.0  # the usual 3 x 3
MARK_ROOM = 0.05  # of the frame: around a search area, so that a mark at its edge is seen whole

# Sensor models
WGS84_WKT_CODE = "EPSG:4326"
WGS84_SEMI_MAJOR_M = 6378137.0
WGS84_FLATTENING = 1 / 298.257223563
EGM96, EGM2008 = "EPSG:5773", "EPSG:3855"
HEIGHT_DATUMS = ("auto", "ellipsoid", "egm96", "egm2008")  # auto: what the reference system says
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
RESAMPLINGS = ("nearest", "bilinear", "cubic", "cubicspline", "lanczos", "average")  # GDAL's warper
ORTHO_FORMATS = ("GTiff", "COG")  # GDAL's drivers
ORTHO_GRID = 21  # points a side on which an orthoimage's error is measured
UNDULATION_STEP_PX = 16  # of a terrain model: the geoid is smooth
# the recommendation
MAX_WORSE = 1.25  # a model that the paper prefers may be this much worse than the best, relative
FLAT_SHARE = 0.5  # of a pixel: heights that move the image by less make flat terrain
