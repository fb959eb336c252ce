"""What is told to whoever calls the Python interface; in English, as Python's own errors are."""
from __future__ import annotations

from ..plugin.imagery.errors import Message

NO_IMAGE = Message("{name} is an array of {kind}, shape {shape}; give real numbers as (rows, columns[, bands]).")
BANDS_FIRST = Message("{name}, {shape}, has bands first; give (rows, columns, bands): np.moveaxis({name}, 0, -1).")
OTHER_DIMENSIONS = Message("{name} has the dimensions {dimensions}; rename them to y and x.")
NO_SOURCES = Message("sources is empty; give the images that the mosaic was made from.")
NO_PIXEL_SIZE = Message("pixel_size_m is {value:g}; give the metres on the ground that a pixel spans, more than 0.")
OTHER_SHAPE = Message("{name} has the shape {shape}; give the mosaic's rows and columns, ({rows}, {columns}).")
OTHER_COORDINATES = Message(
    "{name} has other coordinates {side} than the mosaic; give all on one pixel grid, or arrays without coordinates."
)
LABELS_OF_OTHERS = Message("labels names source {number:.0f}, of {count}; give 0 to {most}, and -1 where unknown.")
LABELS_NOT_WHOLE = Message("labels are not whole numbers ({kind}); give the place of each pixel's source, or -1.")
NOT_MULTIPLE = Message("image has {columns} x {rows} pixels; cut both sides to a multiple of {step} ({levels} levels).")
NOT_FINITE = Message("image holds NaN, infinite or masked pixels; cut a part without them, or fill them first.")
NAMES_TWICE = Message("names has {name} twice; give each band a name of its own.")
NAMES_COUNT = Message("names has {given} names for {count} bands; give one for each.")
NOT_IN_ONE_SYSTEM = Message("{name} lies in another reference system than {first}; decide on each by itself.")
NO_SEAM_TO_DECIDE_ON = Message("There is no seam to decide on: no sheet has any.")
SCAN_OF_ANOTHER = Message("The scan is of another mosaic than {name}; give the block that was scanned.")
LOT_WITHOUT_PLAN = Message("A lot size or seed is for a plan of sampling, and '{rules}' has none; leave both out.")
NO_LAYER_OF_SEAMS = Message("{path} does not exist or has no seams of a scan; give the GeoPackage of a scan.")
OTHER_ENDING = Message("'{output}' is written as {ending}; give {path} that ending.")
HOLDS_OTHER_DATA = Message(
    "'{output}' would be written over {path}, which holds other data than such a run writes; choose another file."
)
NO_FUNCTION = Message("{name} is {value}, which can't be called; give a function, or for cancelled a threading.Event.")
WITHOUT_SYSTEM = Message("The windows name no reference system, so they are taken in the mosaic's.")
RECTANGLES_WITHOUT_BLOCK = Message("Rectangles lie on a mosaic; give its block: inspect_windows(rectangles, block).")
