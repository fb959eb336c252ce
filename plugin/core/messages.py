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
