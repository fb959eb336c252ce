"""Every sentence that a user can be shown by the core, in one place.

A message keeps its template and its values apart, so that the adapters can translate the template
before the values are put in. ``str(message)`` is the English sentence. Each sentence says what is
wrong and what to do about it.
"""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Callable


@dataclass(frozen=True)
class Message:
    """One sentence for the user."""

    template: str
    """English text with ``{name}`` where a value goes."""
    values: Mapping[str, object] = field(default_factory=dict)
    """What goes into the template: numbers, texts, other messages or a tuple of those."""

    def __call__(self, **values: object) -> Message:
        """The same sentence with its values."""
        return Message(self.template, values)

    def __str__(self) -> str:
        return self.worded(lambda template: template)

    def worded(self, translate: Callable[[str], str]) -> str:
        """The sentence, its template and those of the messages in it sent through ``translate``."""
        values = {name: _worded(value, translate) for name, value in self.values.items()}
        return translate(self.template).format(**values)


def _worded(value: object, translate: Callable[[str], str]) -> object:
    if isinstance(value, Message):
        return value.worded(translate)
    if isinstance(value, tuple):
        return " ".join(str(_worded(part, translate)) for part in value)
    return value


SIDE_NOT_POSITIVE = Message("The window side is {side} m; give a positive number of metres.")
WINDOW_OUTSIDE = Message("The window lies outside the mosaic; draw it on the mosaic.")
WINDOW_TOO_SMALL = Message(
    "The window covers {width} x {height} px of the mosaic; a side needs at least {fewest} px, so draw it larger."
)
TOO_MANY_LEVELS = Message(
    "{levels} levels need a window of at least {fewest} px a side and this one has {width} x {height} px; "
    "use fewer levels or draw it larger."
)
# decomposition
WAVELET_UNKNOWN = Message("PyWavelets has no discrete wavelet '{wavelet}'; use an orthogonal one such as coif3.")
WAVELET_NOT_ORTHOGONAL = Message(
    "The wavelet '{wavelet}' is not orthogonal, so the shares of its components do not add up to the clip's "
    "variance; use an orthogonal one such as coif3, db4 or sym8."
)
LEVELS_OUT_OF_RANGE = Message("{levels} levels asked for; the decomposition has {least} to {most}.")
# seamlines
SEAMLINES_EMPTY = Message("The seamline layer is empty; choose a layer with lines or polygons of the mosaic's seams.")
SEAMLINES_NO_LINES = Message(
    "The seamline layer holds no line and no polygon; choose the layer of the mosaic's seamlines or of its source "
    "polygons."
)
SEAMLINES_APART = Message(
    "No two polygons of the seamline layer share a border; snap them to each other (gaps and overlaps up to half a "
    "pixel are bridged), or give the seams as lines."
)
SEAMLINES_TOO_SHORT = Message(
    "The lines of the seamline layer are shorter than a pixel of the mosaic; check the reference systems of both."
)
SEAMLINES_TOO_WIDE = Message(
    "The seamline layer spans {width} x {height} px of the mosaic; check the reference systems of both."
)
SEAMLINES_BROKEN = Message(
    "The geometry of feature {feature} in the seamline layer can't be read; repair the layer with 'Fix geometries'."
)
SEAMLINES_NOT_FINITE = Message(
    "The seamline layer holds coordinates that are no numbers; repair it with 'Fix geometries'."
)
SPACING_NOT_POSITIVE = Message("The spacing is {spacing} m; give a positive number of metres.")
SIDE_TOO_SHORT = Message(
    "A window of {side} m has {pixels} px a side on this mosaic and {levels} levels need at least {fewest} px; "
    "give a side of {metres} m or more."
)
MOSAIC_TOO_SMALL = Message(
    "The mosaic is {width:.1f} x {height:.1f} m, too small for a window of {side:.1f} m; give a shorter side."
)
STATION_WITHOUT_WINDOW = Message(
    "Seam {seam} has no window at {station:.1f} m: it would stick out of the mosaic or hold too few valid "
    "pixels, and there is no room beside."
)
STRETCH_WITHOUT_WINDOW = Message(
    "Seam {seam} has no windows from {start:.1f} to {end:.1f} m: they would stick out of the mosaic or hold too few "
    "valid pixels, and there is no room beside."
)
WINDOWS_CROWDED = Message(
    "Left out because they would share more than half of their pixels with another window of the same seam: {count}."
)
SEAMS_COVERED = Message("Seams that lie within windows of longer ones and got none of their own: {count}.")
SEAMS_TINY = Message("Seams shorter than {shortest:.2f} m, too short to matter in a window: {count}.")
SEAMS_OUTSIDE = Message("Seams outside the mosaic: {count}.")
# rasters
NOT_FOUND = Message("{path} does not exist; check the path.")
NOT_A_RASTER = Message("{name} is not a raster that GDAL can read; check that the file is complete.")
NOT_READABLE = Message("The pixels of {name} can't be read; the file may be truncated or damaged, so copy it anew.")
NO_BANDS = Message("{name} has no bands of its own; choose one of its subdatasets.")
COMPLEX_VALUES = Message("{name} holds complex values; convert them to magnitudes first.")
NOT_GEOREFERENCED = Message("{name} has no position on the map; georeference or orthorectify it first.")
NO_REFERENCE_SYSTEM = Message(
    "{name} has no coordinate reference system; set it in the layer's properties or write it into the file."
)
NOT_NORTH_UP = Message("{name} is rotated, mirrored or south-up; warp it to a north-up grid first.")
NOT_COVERED = Message("{name} does not cover the whole window.")
TOO_MANY_INVALID = Message(
    "{share:.2%} of the pixels of {name} are invalid in the window and {most:.1%} are allowed; move the window."
)
EXTENT_NOT_TRANSFORMED = Message(
    "An extent can't be transformed to the mosaic's coordinate reference system; check the layers' systems."
)
# windows and sources
MAX_RATIO_OUT_OF_RANGE = Message("The largest ratio of a significant loss is {ratio}; give a number between 0 and 1.")
NO_SOURCES_GIVEN = Message(
    "No sources are given; choose the orthoimages the mosaic was made from, or their index layer."
)
MOSAIC_AMONG_SOURCES = Message("{name} is the mosaic itself and is left out of the sources.")
SOURCE_LEFT_OUT = Message("{name} is left out: {why}")
NO_SOURCES = Message("No source covers the window; add the orthoimages that overlap it or move the window.")
NO_SOURCE_COMPARABLE = Message("No source can be compared here: {why}")
MOSAIC_CONSTANT = Message("The mosaic has no variance in the window; move the window to where there is content.")
SOURCE_CONSTANT = Message("{name} has no variance in the window; move the window to where there is content.")
SOURCES_WITHOUT_DETAIL = Message(
    "No source has detail at level 1 in the window; move the window to where there is some."
)
BANDS_DIFFER = Message("{name} has no {band} (its bands: {bands}); choose sources with the mosaic's bands.")
WINDOW_TOO_LARGE = Message(
    "The window covers {width} x {height} px of the mosaic and {most} million px are the most; draw it smaller."
)
WINDOW_FAILED = Message("The window could not be measured ({error}); please report this.")
# layers and outputs
NOT_A_RASTER_LAYER = Message("{name} is not a raster layer; choose a raster.")
NOT_A_FILE = Message("{name} is not a file that GDAL reads but comes from a service; choose the raster file itself.")
WINDOW_EMPTY = Message("The window has no outline; draw it anew.")
WINDOW_NOT_POLYGON = Message("The window is not a polygon; draw it as a rectangle.")
WINDOW_MULTIPART = Message("The window has several parts; split it into one window each.")
WINDOW_SELF_CROSSING = Message("The outline of the window crosses itself; draw it anew as a rectangle.")
NO_WINDOWS = Message("The window layer is empty; draw windows or place them along the seamlines first.")
INDEX_WITHOUT_LOCATION = Message("The index layer has no field '{field}'; make it with gdaltindex.")
WINDOWS_RENUMBERED = Message("{count} windows had no number of their own and were given the next free ones.")
REFERENCE_UNKNOWN = Message("A verdict can't be taken against '{reference}'; choose one of {known}.")
COMPOSITE_UNCLEAR = Message(
    "No source explains the mosaic's fine detail here, so their composite is no reference; add the orthoimages it was "
    "made from, or take the verdict against the sources."
)
CELLS_WITHOUT_SOURCE = Message(
    "The layer of seam cells has no field 'source'; add one with the file names of the orthoimages."
)
DASK_MISSING = Message(
    "A Dask scheduler was given but Dask is not installed; install 'dask[distributed]' or leave the scheduler empty."
)
SCHEDULER_SILENT = Message(
    "The Dask scheduler at {address} does not answer ({error}); check the address or leave it empty."
)
SCHEDULER_WITHOUT_WORKERS = Message("The Dask scheduler at {address} has no workers; start some or leave it empty.")
WINDOW_LAYER_NOT_CREATED = Message(
    "No window layer can be written to {folder}; save the project in a folder that you may write to."
)
WINDOW_LAYER_READ_ONLY = Message(
    "The window layer {name} can't be edited; choose another one, or let a new one be made."
)
WINDOWS_NOT_SAVED = Message(
    "The windows in {name} could not be saved with the project ({error}); they stay open for editing, so save that "
    "layer elsewhere."
)
WINDOWS_PLACED = Message("Windows placed along the seams: {count}. Inspect them when you are ready.")
WINDOWS_PLACED_IN_PART = Message(
    "Windows placed along the seams: {count}; places left without one: {notes}, told in the log messages."
)
NO_WINDOW_PLACED = Message("No window could be placed along the seams; the log messages say why.")
NO_MOSAIC = Message("No mosaic is chosen; choose the mosaic in the inputs.")
MOSAIC_OPENING = Message("The mosaic is still being opened; try again in a moment.")
MOSAIC_NOT_OPENED = Message(
    "The mosaic was not opened, as the task was cancelled; choose another mosaic in the inputs, then this one again."
)
NO_SEAMLINES = Message("No seamlines are chosen; choose a layer of seamlines in the inputs.")
TASK_FAILED = Message("{task} failed ({error}); please report this.")
# forecasts
ONE_SOURCE = Message("Only one source covers the window, so nothing will be feathered there.")
ONE_SOURCE_COMPARABLE = Message("Only one source can be compared here: {why}")
# files
CHART_FORMAT_UNKNOWN = Message("{name} is no PNG, SVG or PDF file; give the chart a name with one of these endings.")
FILE_NOT_WRITTEN = Message("{path} can't be written ({error}); choose another folder.")
# judging the judge
WINDOWS_WITHOUT_FIELD = Message(
    "The window layer has no field '{field}'; choose a layer of inspected windows, as 'Inspect windows' leaves it."
)
PAIRS_WITHOUT_FIELD = Message(
    "The table of pairs has no field '{field}'; choose the table that 'Inspect windows' left with these windows."
)
CURVES_WITHOUT_FIELD = Message(
    "The table of curves has no field '{field}'; choose the table that 'Inspect windows' left with these windows."
)
PAIRS_WITHOUT_CONTRAST = Message(
    "The table of pairs has no field 'contrast_1', so the absolute contrast is not judged; inspect the windows anew to "
    "have it."
)
TOO_FEW_VERDICTS = Message(
    "{measure}: {visible} visible and {invisible} invisible verdicts; a threshold needs at least {fewest} of either, "
    "so judge more windows."
)
NO_BETTER_THAN_CHANCE = Message(
    "{measure} does not tell visible losses from others for sure: the area under its curve lies between {low:.2f} and "
    "{high:.2f}, and 0.5 is a guess. Judge more windows before you rely on a threshold."
)
VERDICTS_FULLY_APART = Message(
    "{measure} is lower in every window with a visible loss than in any other, so resampling has no error to show; "
    "the interval is the score interval."
)
NO_THRESHOLD = Message(
    "{measure}: no threshold that can be set is better than a guess; look at the verdicts again, or use another "
    "measure."
)
THRESHOLD_TOO_HIGH = Message(
    "{measure}: the verdicts support a threshold of {threshold:.3f}, and one that can be set lies below {most:g}; the "
    "best below it is given."
)
VERDICTS_UNKNOWN = Message(
    "Left out because the observer's word is neither 'visible' nor 'invisible': {count} windows."
)
VERDICTS_WITHOUT_VALUE = Message("{measure}: left out because nothing was measured there: {count} judged windows.")
# the report
CLIP_NOT_SHOWN = Message("Window {window}: {why}")
DETAILS_LIMITED = Message(
    "{count} windows are flagged and the report shows curves and clips of the {most} with the lowest ratios; the "
    "others stand in the table. Report a part of the windows to see them."
)
NO_REPORT_FILE = Message("No file is given for the report; choose where it is to be written.")

# random noise
NOTHING_MEASURED = Message("No window could be measured: {why}")
NO_RASTERS = Message("No rasters are given; choose at least one.")
NO_RASTER_USABLE = Message("None of the rasters can be used: {why}")
NOISE_LEVELS_TOO_FEW = Message("{levels} levels asked for; the noise rule compares levels, so use at least {least}.")
NOISE_CONSTANT = Message("{name} has no variance in {band} here; move the window to where there is content.")
NOISE_HUMP = Message(
    "The detail does not fall from level 1 to 2 but later: noise coarser than a pixel (grain, resampling, "
    "compression) or a texture of that size; look at the window."
)
WINDOW_ON_NO_RASTER = Message("Window {window} lies on none of the rasters; draw it on one of them.")
WINDOW_LEFT_OUT = Message("Window {window} is left out on {name}: {why}")
WINDOW_IMAGE_ROTATED = Message("{name} is rotated, mirrored or south-up, so no windows can be laid on it by the map.")
RASTER_WITHOUT_WINDOW = Message(
    "{name} has no valid part of {fewest} x {fewest} px; draw windows, or choose a larger raster."
)
WINDOWS_SMALLER = Message("{name} has no valid part of {wanted} x {wanted} px; its windows have {side} px.")
MASKED_TOO_MUCH = Message(
    "{share:.1%} of the window is invalid in one raster or another and {most:.0%} are allowed; move the window."
)
GROUPS_APART = Message(
    "The two groups show no common ground, so each raster has windows of its own and nothing is compared pairwise."
)
PIXEL_SIZES_DIFFER = Message(
    "Pixel sizes differ ({first} and {second}), so a level does not mean the same size on the ground in both groups."
)
# radiometric acceptance
RULES_NOT_READABLE = Message("The rules in {name} can't be read ({error}); give a JSON file with rules.")
RULES_NOT_JSON = Message("The rules in {name} are no JSON (line {line}: {error}); mend the file.")
RULES_NO_OBJECT = Message('{name} holds no rules; it has to be an object {{"name": ..., "rules": [...]}}.')
RULES_KEY_UNKNOWN = Message("{place} in {name} has the unknown key '{key}'; known are {known}.")
RULES_CHECK_UNKNOWN = Message("{place} in {name} names the unknown check '{check}'; known are {known}.")
RULES_CHECK_TWICE = Message("{name} has two rules for '{check}'; leave one.")
RULES_LIMIT_BAD = Message("{place} in {name}: '{key}' has to be a number of 0 or more.")
RULES_LIMITS_CROSSED = Message("{place} in {name}: 'least' is larger than 'most'.")
RULES_VALUES_BAD = Message("{place} in {name}: 'values' has to be a whole number of 1 or more.")
RULES_VALUES_UNUSED = Message("{place} in {name}: 'values' belongs to clipped_low and clipped_high only.")
RULES_SOURCE_MISSING = Message("{place} in {name} has no 'source'; say in words where the limit comes from.")
RULES_RANGE_BAD = Message("'value_range' in {name} has to be two numbers, the smaller one first.")
RULE_PLACE = Message("Rule {number}")
RULES_PLACE = Message("The object")
NOT_MEASURABLE = Message("not measurable: {why}")
TOO_FEW_VALID_PIXELS = Message("{count} pixels are valid and at least {least} are needed; choose a larger part.")
NO_VALUE_RANGE = Message(
    "values of type {data_type} have no range of their own; give 'value_range' in the rules file."
)
NO_UNIFORM_AREA = Message(
    "fewer than {least} uniform mid-tone areas of {side} x {side} px were found; draw windows on such areas."
)
NO_NOISE_AT_ALL = Message("the uniform areas do not vary at all; a photograph would, so check how the image was made.")
NO_NEUTRAL_AREA = Message(
    "fewer than {least} uniform areas whose bands differ by less than {most:.0%} of the range were found; draw windows "
    "on grey surfaces."
)
NO_COLOURS = Message("it has no red, green and blue.")
NO_SEAM_HERE = Message("no seam runs across valid pixels of it for {pixels} px or more.")
NO_LIMIT = Message("The rules set no limit; give one in the rules file.")
RANGE_ASSUMED = Message(
    "{name}: the largest value is {largest}, so the range is taken as {low:g} to {high:g}; if it is another, give "
    "'value_range' in the rules file."
)


# ground resolved distance
TOO_FEW_BARS = Message("A group of {bars} bars can't be measured; a target has at least {least} bars in a group.")
GRD_NOT_POSITIVE = Message("The ground resolved distance is {grd} cm; give a positive number of centimetres.")
STEP_TOO_SMALL = Message("The step from group to group is {step}; give a factor above 1, such as 1.1225.")
CRITERION_OUT_OF_RANGE = Message("The criterion is {criterion}; give a share of the full amplitude between 0 and 1.")
BAR_WIDTH_OUT_OF_RANGE = Message("The profile is averaged over {width} px either side; give 0 to {most}.")
BAND_NOT_THERE = Message("{name} has no band {band} to measure; give 1 to {count}, or 0 for every band.")
FIELD_MISSING = Message("The layer has no field '{field}'; add it and fill it in.")
NO_BAR_LINES = Message("The layer has no lines; draw one across the bars of each group.")
BAR_LINE_EMPTY = Message("The line has no geometry; draw it anew across the bars of the group.")
BAR_LINE_MULTIPART = Message("The line has several parts; draw one line across the bars of the group.")
BAR_LINE_BENT = Message("The line is not straight; draw it with two points across the bars of the group.")
BAR_LINE_OUTSIDE = Message("The line leaves {name}; draw it on the image, across the bars of the group.")
BAR_LINE_ON_NODATA = Message("The line crosses pixels of {name} without data; draw it where the image is.")
BAR_LINE_TOO_SHORT = Message(
    "The line is {length:.1f} px long, and {bars} bars with their gaps need {least} px at least; draw it from the "
    "ground on one side of the bars to that on the other."
)
BAR_LINE_TOO_LONG = Message(
    "The line is {length:.0f} px long and {most} px are the most; draw it across the bars of one group only."
)
GROUP_NOT_GIVEN = Message("The line has no whole number in its field 'group'; fill in the group's number.")
DIRECTION_UNKNOWN = Message("The line's direction is '{direction}'; fill in 'along' or 'across'.")
GROUP_TWICE = Message(
    "Group {group} {direction} is drawn twice; the first line counts, so delete this one or correct its number."
)
NO_BARS = Message("No bars stand out on the line; draw it across the bars of one group.")
BARS_MERGED = Message("The bars can't be told apart: {found} of {bars} stand out.")
TOO_MANY_BARS = Message("{found} bars stand out and a group has {bars}; draw the line across one group only.")
BARS_TOO_WEAK = Message("The amplitude is {share:.0%} of the full one and the criterion is {criterion:.0%}.")
BARS_IN_NOISE = Message("The amplitude of {amplitude:.1f} DN does not exceed three times the noise of {noise:.1f} DN.")
BARS_BEYOND_NYQUIST = Message(
    "A bar and a gap cover {cycle:.2f} px, fewer than two: what is seen there is aliasing and is not counted."
)
BARS_MAYBE_ALIASED = Message(
    "The bars seem {spacing:.1f} px apart, which can't be told from aliasing in an image without scale; draw lines "
    "across coarser groups too."
)
BARS_MISPLACED = Message(
    "The bars seem {spacing:.1f} px apart and the group's are {cycle:.1f} px: what is seen is aliasing or another "
    "group, and is not counted."
)
BARS_SPURIOUS = Message("A coarser group, {group}, is not resolved, so this one is aliasing and is not counted.")
BARS_SATURATED = Message(
    "The bars are saturated at {value:g} DN, so the full amplitude is larger than measured; use an image with a "
    "shorter exposure."
)
TARGET_SCALE_DIFFERS = Message(
    "The bars are {ratio:.2f} times as far apart as their group numbers and the pixel size say; the bars themselves "
    "are taken, so check REFERENCE_GROUP, REFERENCE_GRD and the raster's pixel size."
)
TARGET_REVERSED = Message(
    "The bars get wider where the group numbers say that they get finer; set REVERSED for this target, or clear it."
)
NO_GRD = Message("No group {direction} the flight is resolved in {band}, so there is no ground resolved distance.")
# minimum height
OBSERVATION_NOT_POSITIVE = Message(
    "Height {height} m and distance {grd} cm make no minimum height; give positive numbers of metres and centimetres."
)
REFERENCE_HEIGHT_NOT_POSITIVE = Message("The reference height is {height} m; give a positive number or leave it empty.")
FEW_OBSERVATIONS = Message("{count} passes over the target; the Open Skies treaty asks for {least} at least.")
NO_OBSERVATIONS = Message("No row has a height and a distance to compute with; fill in 'height' and 'grd'.")
OBSERVATIONS_LEFT_OUT = Message("Row {row} is left out: {why}")
OBSERVATION_EMPTY = Message("'height' or 'grd' holds no number; fill in both.")
# Bayer filter
BAYER_PATTERN_UNKNOWN = Message("There is no Bayer pattern '{pattern}'; choose one of {known}.")
DEMOSAIC_UNKNOWN = Message("There is no interpolation '{demosaic}'; choose one of {known}.")
OPENCV_MISSING = Message(
    "The interpolation edge_aware needs OpenCV (python3-opencv on Debian and Ubuntu, 'python -m pip install "
    "opencv-python-headless' elsewhere); install it, or choose bilinear."
)
EDGE_AWARE_WANTS_INTEGERS = Message(
    "The interpolation edge_aware works on images of 8 or 16 bit and this one holds {kind}; choose bilinear."
)
BANDS_NOT_COLOURS = Message(
    "{name} has {count} bands and no red, green and blue; choose a colour image, or one of a single band."
)
BAR_LAYER_NOT_CREATED = Message(
    "No layer of bar groups can be written to {folder}; save the project in a folder that you may write to."
)
NO_BAR_IMAGE = Message("No image of a bar target is chosen; choose one above, then draw a line across its bars.")

# fiducial marks
TEMPLATE_TOO_SMALL = Message(
    "The template is {width} x {height} px and a side needs at least {fewest} px; cut it out with the whole mark in it."
)
TEMPLATE_EMPTY = Message("All pixels of the template are alike; cut it out where the mark is.")
SURFACE_FLAT = Message("the surface around the best place is flat, so it has no extremum")
SURFACE_SADDLE = Message("the surface around the best place is a saddle, so it has no extremum")
SURFACE_OUTSIDE = Message("the extremum of the surface lies outside the pixels it was computed from")
MARK_NO_ROOM = Message("the template is larger than the piece of the photo around the mark")
MARK_TOO_WEAK = Message("the best correlation is {value:.2f} and at least {least:.2f} is asked for")
MARK_AMBIGUOUS = Message("two places look nearly alike, with correlations of {best:.2f} and {second:.2f}")
MARK_AT_THE_EDGE = Message("the mark lies at the edge of the photo and is not all there")
MARK_HALVES_DIFFER = Message(
    "parts of the mark differ by {shift:.1f} px and at most {most:.1f} px is trusted: dirt, a scratch or no mark"
)
# calibration
CALIBRATION_NOT_READ = Message("The calibration {path} can't be read ({error}); check the path.")
CALIBRATION_UNKNOWN = Message(
    "{name} is neither a CSV with the columns mark, x_mm and y_mm nor a MeasuresCamera.xml of MicMac; choose one of "
    "these."
)
CALIBRATION_COLUMNS = Message("{name} lacks a column; a calibration has the columns mark, x_mm and y_mm.")
CALIBRATION_ROW = Message("Row {row} of {name} has no mark with two numbers; complete or remove it.")
CALIBRATION_TWICE = Message("{name} has the mark '{mark}' twice; give every mark a name of its own.")
CALIBRATION_EMPTY = Message("{name} holds no marks; a calibration has one row with mark, x_mm and y_mm for each.")
CALIBRATION_UNIT = Message(
    "The marks of the calibration are {span:g} mm apart and a photo has {least:g} to {most:g} mm; give millimetres."
)
TOO_FEW_CALIBRATED = Message(
    "The calibration has too few marks: {count}, and the {model} model needs {least}; complete it or use another model."
)
MARKS_AT_ONE_PLACE = Message(
    "The marks '{one}' and '{other}' of the calibration are at one place; correct their coordinates."
)
# transformation
TOO_FEW_MARKS = Message(
    "Marks measured or given: {count}, and the {model} model needs {least}; measure the others by hand and give them "
    "as positions with their measurement off."
)
MARKS_ON_A_LINE = Message(
    "The marks are at one place or on one line, so the {model} model can't be determined; give further marks."
)
# photos
PHOTO_EMPTY = Message("All pixels of {name} are alike, so it shows no marks; scan the photo anew.")
NO_MARK_FOUND = Message(
    "No mark was found in {name} ({why}); give positions, another kind of template, or a template cut out of the photo."
)
POSITION_UNKNOWN = Message(
    "The positions name a mark '{mark}' that the calibration does not have ({marks}); rename it."
)
POSITIONS_AT_ONE_PLACE = Message("The positions of '{one}' and '{other}' are at one place; move one of them.")
POSITIONS_OFF = Message(
    "The positions lie up to {worst:.0f} mm from where the calibration wants them; check their names and the "
    "calibration."
)
POSITION_OUTSIDE = Message(
    "The position of '{mark}' lies outside the photo; digitise it on the photo as QGIS shows it without a world "
    "file, or "
    "with the one that the photo has."
)
TEMPLATE_TOO_LARGE = Message(
    "The template is {side:.1f} mm wide and the search area {search:.1f} mm; cut it out smaller or search further."
)
ARRANGEMENT_NOT_AT_POSITIONS = Message(
    "Marks were found in the photo, but not where the positions say; each was looked for on its own there."
)
LYING_ASSUMED = Message(
    "Nothing tells how the photo lies in the scanner, so it is taken to lie upright and not mirrored; give the "
    "positions "
    "of three marks if that is wrong."
)
MARK_NOT_SEEN = Message("nothing around the position looks like a mark")
MARK_NOT_ARRANGED = Message("no places in the photo that look like marks lie as the calibration says")
MARK_OUTSIDE = Message("it would lie outside the photo")
MARK_TWICE = Message("it was found at the same place as '{other}'")
MARK_OFF = Message("it lies {worst:.2f} mm from where the other marks want it and {limit:.2f} mm is the most")
MARKS_DISAGREE = Message(
    "the marks lie up to {worst:.2f} mm from where the calibration wants them, {limit:.2f} mm is the most, and it "
    "can't be "
    "told which is wrong"
)
GIVEN_IS_OFF = Message(
    "The given mark '{mark}' lies {worst:.2f} mm from where the others want it; check its place and its name."
)
NO_REDUNDANCY = Message(
    "The {model} model takes all of its {count} marks, so the residuals are 0 and say nothing about its accuracy; "
    "measure "
    "more marks or use a simpler model."
)
MARK_WANDERS = Message("the surface's extremum leads away from where the mark was found")
MARK_UNSUPPORTED = Message(
    "only {count} places that look like marks lie as the calibration says, and without positions {least} are needed"
)
NO_TRANSFORMATION = Message("There is no transformation to write; give the positions of more marks.")
PHOTO_WITHOUT_TRANSFORMATION = Message(
    "{name} has no transformation ({why}); its marks are in the output, but no parameters and no world file were "
    "written."
)
POSITIONS_WITHOUT_MARK = Message(
    "The layer of positions has no field 'mark'; add one and write the names of the calibration's marks into it."
)
POSITION_TWICE = Message("The layer of positions has the mark '{mark}' twice; remove one of them.")
POSITIONS_EMPTY = Message("The layer of positions holds no point with a name in its field 'mark'; digitise some.")
COMPARED_WITHOUT_MARK = Message("The layer {layer} has no field 'mark'; choose layers of measured marks.")
COMPARED_TWICE = Message(
    "A layer has the mark '{mark}' twice; give both layers a field 'photo' that tells photos apart."
)
NOTHING_IN_COMMON = Message("The two layers have no mark in common; check their fields 'mark' and 'photo'.")
PIXEL_SIZE_UNKNOWN = Message(
    "The pixel size is not known, so the distances are given in pixels only; give the pixel size, or layers with the "
    "fields x_mm and y_mm."
)
NO_CALIBRATION = Message("No calibration is given; choose the file with the calibrated marks of the camera.")
# enhancement
FILTER_SIDE = Message("The side of the mean is {size:g} px; give an odd number from 3 to {most:g}.")
FILTER_DEVIATION = Message(
    "The standard deviation of the Gaussian is {size:g} px; give one above 0 and up to {most:g}."
)
RASTER_NOT_WRITTEN = Message("{path} can't be written; choose another folder, or make room on the disk.")

# sensor models: points
POINTS_NOT_TRANSFORMED = Message(
    "Some points have no place in another reference system; check the reference system of the points."
)
NO_POINTS_FILE = Message(
    "{name} is no points file of QGIS's georeferencer (its header names no mapX, mapY and sourceX or pixelX); choose "
    "one, or a point layer with the fields column and row."
)
POINTS_LINE_UNREADABLE = Message("Line {line} of {name} can't be read; correct or remove it.")
POINTS_WITHOUT_SYSTEM = Message(
    "{name} names no coordinate reference system, as files from before QGIS 3.26 do; set the points' reference "
    "system."
)
POINTS_WITHOUT_FIELD = Message(
    "The point layer has no field '{field}'; it needs column and row, the place of each point in the image in pixels."
)
NO_POINTS = Message("There are no points to fit a model to; measure some, or choose another layer.")
POINT_LEFT_OUT = Message("Point {name} is left out: {why}")
POINT_WITHOUT_PLACE = Message("its place in the image or on the ground is missing.")
POINT_ROLE_UNKNOWN = Message("its role '{role}' is neither control nor check.")
POINT_OFF_DEM = Message("it has no height and the terrain model has none there.")
POINTS_DISABLED = Message("Points that are switched off in the georeferencer and left out: {count}.")
NO_HEIGHTS = Message(
    "Some points have no height, which the model {model} needs; add a field z or choose a terrain model, or take "
    "polynomial_2d."
)
TOO_FEW_POINTS = Message(
    "There are {count} control points and the model {model} needs at least {fewest}; measure more or choose a model "
    "with fewer unknowns."
)
TOO_FEW_AFTER_SPLIT = Message(
    "Of {total} points {count} are left as control points and the model {model} needs at least {fewest}; lower the "
    "share of check points or measure more."
)
POINTS_ON_A_LINE = Message(
    "The control points lie on one line, so the model {model} can't be fitted; add points to both sides of it."
)
POINTS_ON_A_PLANE = Message(
    "The control points lie on one plane, so the terms in Z of the model {model} can't be determined; add points of "
    "other heights, or take polynomial_2d or rpc_bias."
)
TOO_MANY_BLUNDERS = Message(
    "{count} control points contradict the others, and too few are left to fit the model {model}; check the points, "
    "above all that columns and rows are not interchanged."
)
BLUNDERS_FOUND = Message(
    "Blunders found and left out of the errors: {count} ({names}); check those points and measure them again."
)
CONTROL_ON_A_LINE = Message(
    "The control points lie nearly on a line: {share:.0%} of the image is outside their outline and extrapolated; add"
    " points to both sides."
)
CONTROL_IN_A_CORNER = Message(
    "The control points leave {share:.0%} of the image outside their outline; what lies there is extrapolated, so add"
    " points towards the image's corners."
)
CHECK_POINTS_MISSING = Message(
    "There are no check points, so the errors given are those of the fit on its own points; set roles or a share of "
    "check points."
)
# sensor models: the fit
NOT_CONVERGED = Message(
    "The fit did not settle within {iterations} iterations, so the points are too few or too noisy for it; add points"
    " or choose a model with fewer unknowns."
)
ILL_CONDITIONED = Message(
    "The points hardly determine the model (condition {condition:.0e}): between them it may swing, so trust the check"
    " points only or choose a lower order."
)
LINE_NOT_FOUND = Message(
    "No line of the image sees one of the points; check the points' places, heights and reference system."
)
PUSHBROOM_DIVERGED = Message(
    "The parametric model can't be fitted to these points; check for interchanged coordinates or wrong heights, or "
    "let blunders be looked for."
)
NOT_INVERTED = Message(
    "The model can't be inverted over the image, so it is unsound away from its points; choose a lower order or add "
    "points."
)
PLANE_MODEL_HAS_NO_RPC = Message(
    "The model polynomial_2d knows no heights and can't be written as RPC or used for orthorectification; fit a model"
    " in space."
)
NO_RPC = Message("The image has no RPC of its own; give the file that came with it, or choose a model that needs none.")
RPC_INCOMPLETE = Message("{name} holds no complete RPC; get the file anew from the image's vendor.")
RPC_NOT_WRITTEN = Message("No RPC is written: {why}")
RPC_FITTED = Message(
    "The RPC follows the model to {rms:.2g} px (root mean square) and {largest:.2g} px at most, over the whole image "
    "and heights of {low:.0f} to {high:.0f} m."
)
RPC_EXACT = Message("The RPC is the model itself.")
RPC_OF_WHOLE_SCENE = Message(
    "The image is taken as a part of the scene that the RPC describes, from column {column:.0f} and row {row:.0f} on."
)
NO_MODEL_FILE = Message("{name} is no sensor model file; choose one that fitsensormodel has written.")
MODEL_FILE_VERSION = Message(
    "{name} is of version {version}, which this version of Seam Inspector does not read; fit the model anew."
)
# sensor models: heights
NO_GEOID_GRID = Message(
    "PROJ has no grid to convert heights of {vertical} to the ellipsoid; install it (projsync) or give heights above "
    "the ellipsoid."
)
HEIGHTS_ASSUMED = Message(
    "{name} does not say what its heights refer to; they are taken as above the ellipsoid. Heights above sea level "
    "differ by up to 100 m: choose egm96 or egm2008 if they are such."
)
HEIGHTS_CONVERTED = Message(
    "The heights of {name} ({vertical}) are converted to the ellipsoid: {least:.1f} to {most:.1f} m are added."
)
DEM_NOT_COVERING = Message(
    "The terrain model {name} does not cover the image, which lies at {west:.4f} to {east:.4f} degrees east, "
    "{south:.4f} to {north:.4f} degrees north; choose one that does."
)
DEM_PARTLY_COVERING = Message(
    "The terrain model {name} has no heights under {share:.1%} of the image (holes, or it ends there); the orthoimage"
    " is empty there, so fill or extend the terrain model."
)
DEM_TOO_LARGE = Message(
    "The terrain model {name} has {count} million pixels under the image and {most} million are the most; resample "
    "it, meshes of 10 to 30 m serve best."
)
NO_DEM = Message(
    "No terrain model is given; choose one, or give a constant height on purpose where the terrain is flat."
)
DEM_AND_HEIGHT = Message("Both a terrain model and a constant height are given; choose one of them.")
# orthorectification
MODEL_AND_RPC = Message("Both a model file and an RPC file are given; choose one of them.")
PIXEL_SIZE_NOT_POSITIVE = Message("The pixel size is {size}; give a positive number of map units.")
EXTENT_WITHOUT_SYSTEM = Message("An extent is given but no reference system; choose the orthoimage's reference system.")
EXTENT_OUTSIDE = Message("The extent lies outside the image; choose one that overlaps it.")
ORTHO_TOO_LARGE = Message("The orthoimage would have {width} x {height} px; choose larger pixels or a smaller extent.")
WARP_FAILED = Message("The orthoimage could not be written ({error}); check the folder and the free space.")
CANCELLED = Message("The orthorectification was cancelled; nothing is left of it.")
# the recommendation
RECOMMEND_PUSHBROOM = Message(
    "Take {model}: {rmse:.2f} m on points it has not seen (the best has {best:.2f} m). A parametric model needs few "
    "points and does not swing between them."
)
RECOMMEND_RPC_BIAS = Message(
    "Take {model}: {rmse:.2f} m on points it has not seen (the best has {best:.2f} m). The vendor's RPC holds the "
    "image's geometry and a few points remove its offset."
)
RECOMMEND_RATIONAL = Message(
    "Take {model}: {rmse:.2f} m on points it has not seen (the best has {best:.2f} m). Of the models without a "
    "parametric base quotients are the soundest, but they need many, well spread points."
)
RECOMMEND_DLT = Message(
    "Take {model}: {rmse:.2f} m on points it has not seen (the best has {best:.2f} m). It is the quotient of lowest "
    "order with one denominator and needs the fewest points."
)
RECOMMEND_POLYNOMIAL_3D = Message(
    "Take {model}: {rmse:.2f} m on points it has not seen (the best has {best:.2f} m), but polynomials suit small "
    "areas only and swing between the points, so watch the check points."
)
RECOMMEND_POLYNOMIAL_2D = Message(
    "Take {model}: {rmse:.2f} m on points it has not seen (the best has {best:.2f} m). The terrain is flat enough for"
    " a plane model, which serves for small areas only."
)
NOTHING_TO_RECOMMEND = Message(
    "No model could be fitted and judged; the table says why for each, so measure more points or correct them."
)
