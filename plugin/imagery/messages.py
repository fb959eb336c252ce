"""What a user can be told of rasters, windows, seamlines and files, whatever is measured on them."""
from __future__ import annotations

from .errors import INFO, WARNING, Message

# rasters
NOT_FOUND = Message("{path} does not exist; check the path.")
NOT_A_RASTER = Message("{name} is not a raster that GDAL can read; check that it is complete, or save it as GeoTIFF.")
NOT_PERMITTED = Message("No permission to read {name}; ask its owner for it, or for a copy.")
NOT_READABLE = Message("The pixels of {name} can't be read; the file may be truncated or damaged, so copy it again.")
PART_NOT_FOUND = Message("{name} refers to {part}, which does not exist; restore that file, or make {name} again.")
MASK_NOT_READABLE = Message("The mask of {name}, inside it or in the file .msk beside it, is damaged; copy both again.")
DAMAGED = Message(
    "{name} is damaged in columns {left} to {right}, rows {top} to {bottom} (GDAL: {why}); copy it again.")
NO_FILE = Message("{name} is a device, a pipe or memory, not a file; copy its data to a file.")
DRIVER_NOT_USED = Message(
    "{name} is read by GDAL's driver {driver}, which may open other files, a service or a database; save the part that "
    "is needed as GeoTIFF.")
TOO_LARGE = Message(
    "{name} claims {columns} x {rows} px in blocks of {width} x {height} px, which no memory holds; save it again in "
    "tiles, or copy it again if it is damaged.")
TOO_MUCH_AT_ONCE = Message(
    "{width} x {height} px of {name} are too many to be read at once; cut out the part that is needed.")
NO_BANDS = Message("{name} has no bands of its own; choose one of its subdatasets.")
COMPLEX_VALUES = Message("{name} holds complex values; convert them to magnitudes first.")
BAND_NOT_THERE = Message("{name} has no band {band} to measure; give 1 to {count}, or 0 for every band.")
NOT_GEOREFERENCED = Message("{name} has no position on the map; georeference or orthorectify it first.")
NO_REFERENCE_SYSTEM = Message(
    "{name} has no coordinate reference system (CRS); set it where the raster is opened, or write it into the file.")
NOT_NORTH_UP = Message("{name} is rotated, mirrored or south-up; warp it to a north-up grid first.")
OTHER_SYSTEM_TAKEN = Message(
    "{name} is read in the reference system that was chosen for it, {system}, not in that of its file, {own}.", INFO)
NO_SYSTEM = Message(
    "'{text}' is not a projected or geographic coordinate reference system; write it as WKT, or as a code such as "
    "EPSG:2180.")
NOT_ON_GROUND = Message(
    "{name} lies outside the area of its coordinate reference system; assign it the system of its coordinates.")
MUCH_FINER = Message(
    "{name} has pixels {times:.0f} times finer than the mosaic's, too many to average; resample it to them first.")
SOURCE_LEFT_OUT = Message("{name} is left out: {why}", WARNING)
TABLE_WITHOUT_LINES = Message("The table has no lines; make a frame of it by to_dataframe().")
# reference systems
EXTENT_NOT_TRANSFORMED = Message(
    "Some places can't be transformed to another coordinate reference system; check the systems of the layers.")
NO_GEOID_GRID = Message(
    "PROJ has no grid to convert heights of {vertical} to the ellipsoid; install it (projsync) or give heights above "
    "the ellipsoid.")
# windows
SIDE_NOT_POSITIVE = Message("The window side is {side} m; give a positive number of metres.")
NOT_OF_TYPE = Message("{name} is {value}; give {expected}.")
WINDOW_NO_RECTANGLE = Message(
    "The window runs from {xmin:.8g} to {xmax:.8g} and from {ymin:.8g} to {ymax:.8g}; give xmin, ymin, xmax and ymax "
    "as numbers, the smaller ones first.")
WINDOW_OUTSIDE = Message("The window lies outside the mosaic; choose a place on it.")
WINDOW_TOO_SMALL = Message(
    "The window covers {width} x {height} px of the mosaic; a side needs at least {fewest} px, so take a larger one, "
    "or use fewer levels where these ask for more than 64 px.")
WINDOW_TOO_LARGE = Message(
    "The window covers {width} x {height} px of the mosaic, but {most} million px are the most; take a smaller one.")
WINDOW_ON_NO_RASTER = Message("Window {window} lies on none of the rasters; draw it on one of them.", WARNING)
WINDOW_LEFT_OUT = Message("Window {window} is left out on {name}: {why}", WARNING)
# pixels in a window
NOT_COVERED = Message("{name} does not cover the whole window.")
TOO_MANY_INVALID = Message(
    "{share:.2%} of the pixels of {name} are invalid in the window and {most:.1%} are allowed; choose another place.")
NOTHING_MEASURED = Message("No window could be measured: {why}")
ABOUT = Message("{what}: {why}", INFO)  # one of many: a window, a mark, a group
# the decomposition
WAVELET_NOT_ORTHOGONAL = Message(
    "'{wavelet}' is not orthogonal, or no wavelet of PyWavelets; use one such as coif3, db4 or sym8.")
LEVELS_OUT_OF_RANGE = Message("{levels} levels were asked for; give {least} to {most}.")
# seamlines
SEAMLINES_NO_LINES = Message(
    "The seamline layer holds no line and no polygon; give that of the mosaic's seamlines or of its source polygons.")
SEAMLINES_APART = Message(
    "No two polygons of the seamline layer share a border; snap them to each other (gaps and overlaps up to half a "
    "pixel are bridged), or give the seams as lines.")
SEAMLINES_TOO_SHORT = Message(
    "The lines of the seamline layer are shorter than a pixel of the mosaic; check the reference systems of both.")
SEAMLINES_TOO_WIDE = Message(
    "The seamline layer spans {width} x {height} px of the mosaic; check the reference systems of both.")
SEAMLINES_BROKEN = Message(
    "The geometry of feature {feature} in the seamline layer can't be read; repair it ('Fix geometries' or ogr2ogr "
    "-makevalid).")
SEAMLINES_NOT_FINITE = Message(
    "The seamline layer has coordinates that are not numbers in the mosaic's reference system; check the reference "
    "systems of both and repair the layer ('Fix geometries' or ogr2ogr -makevalid).")
# files that are written
CANCELLED = Message("The work was cancelled; nothing was written.", WARNING)
RASTER_NOT_WRITTEN = Message("{path} can't be written; choose another folder, or make room on the disk.")
FILE_NOT_WRITTEN = Message("{path} can't be written ({error}); choose another folder.")
OUTPUT_IS_INPUT = Message("'{output}' would be written over {path}, which belongs to an input; choose another file.")
OUTPUTS_ARE_ONE = Message(
    "'{first}' and '{second}' would be written to the same file, {path}; give each a file of its own.")
OUTPUT_NAMES_NO_FILE = Message("'{output}' is to be written to {path}, which is not a file on a disk; choose a file.")
# files that are read over the network
REMOTE_NOT_READABLE = Message(
    "{name} can't be read over the network ({why}); check its address, the network, and GDAL's settings and "
    "credentials, or copy it to a local disk.")
# folders of records
RECORDS_IN_USE = Message("another QGIS has it open")
RECORDS_FOREIGN = Message("something else is there")
# a file with rules
RULES_NOT_READABLE = Message("The rules in {name} can't be read ({error}); give a JSON file with rules.")
RULES_NOT_JSON = Message("The rules in {name} are not valid JSON (see line {line}); correct the file.")
RULES_NO_OBJECT = Message('{name} holds no rules; it has to be an object {{"name": ..., "rules": [...]}}.')
RULES_KEY_TWICE = Message("{name} has '{key}' twice in one object; keep one.")
RULES_KEY_UNKNOWN = Message("{place} in {name} has the unknown key '{key}'; known are {known}.")
RULES_WORD_UNKNOWN = Message("{place} in {name} has the unknown {key} '{value}'; known are {known}.")
RULES_LIMIT_BAD = Message("{place} in {name}: '{key}' has to be a number of {least:g} or more.")
RULES_LIMITS_CROSSED = Message("{place} in {name}: 'least' is larger than 'most'.")
RULES_WHOLE_BAD = Message("{place} in {name}: '{key}' has to be a whole number of 1 or more.")
RULES_FLAG_BAD = Message("{place} in {name}: '{key}' has to be true or false.")
RULES_SOURCE_MISSING = Message("{place} in {name} has no 'source'; say in words where the limit comes from.")
RULE_PLACE = Message("Rule {number}", INFO)
RULES_PLACE = Message("The object", INFO)


def system_reason(error: OSError) -> str:
    """The system's words for why it refuses a file."""
    return error.strerror or str(error)
