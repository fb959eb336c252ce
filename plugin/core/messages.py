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
NO_MOSAIC = Message("No mosaic is chosen; choose the mosaic in the inputs.")
NO_SEAMLINES = Message("No seamlines are chosen; choose a layer of seamlines in the inputs.")
TASK_FAILED = Message("{task} failed ({error}); please report this.")
# files
CHART_FORMAT_UNKNOWN = Message("{name} is no PNG, SVG or PDF file; give the chart a name with one of these endings.")
FILE_NOT_WRITTEN = Message("{path} can't be written ({error}); choose another folder.")

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
RASTER_NOT_WRITTEN = Message("{path} can't be written; choose another folder or another format.")
BAR_LAYER_NOT_CREATED = Message(
    "No layer of bar groups can be written to {folder}; save the project in a folder that you may write to."
)
NO_BAR_IMAGE = Message("No image of a bar target is chosen; choose one above, then draw a line across its bars.")
