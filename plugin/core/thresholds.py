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
MIN_SUPPORT = 3  # marks that have to agree where no position is given: two lie right for any scale and rotation
PICTURE_MAGNIFICATION = 8  # of a mark in the report
PICTURE_SIDE_PX = 900  # of such a picture: a larger mark is reduced first
MAX_FILTER_PX = 101  # a wider one wants another tool
DEFAULT_FILTER_PX = 3.0  # the usual 3 x 3
MARK_ROOM = 0.05  # of the frame: around a search area, so that a mark at its edge is seen whole
