"""Messages on layers, lists of rasters, background tasks, Dask and charts."""
from __future__ import annotations

from ..imagery.errors import INFO, WARNING, Message

# layers
NOT_A_RASTER_LAYER = Message("{name} is not a raster layer; choose a raster.")
NOT_A_FILE = Message("{name} is not a file that GDAL reads but comes from a service; choose the raster file itself.")
WINDOW_LAYER_READ_ONLY = Message(
    "The window layer {name} can't be edited; choose another one, or let a new one be made.")
SYSTEM_NOT_WRITTEN = Message(
    "{name} can't be saved in the mosaic's reference system, as a GeoPackage can't store it; give the mosaic another "
    "one, such as one with an EPSG code.")
NO_WINDOWS = Message("The window layer is empty; draw windows or place them along the seamlines first.")
# the outline of a window
WINDOW_EMPTY = Message("The window has no outline; draw it again.")
WINDOW_NO_POLYGON = Message("The window is not a single polygon whose outline crosses nowhere; draw it as a rectangle.")
WINDOWS_RENUMBERED = Message(
    "Windows without a number of their own: {count}; they were given the next free ones.", WARNING)
WINDOWS_RESHAPED = Message(
    "The rectangle around the outline is measured where a window is not a rectangle along the mosaic's axes: {count}.",
    WARNING)
# numbers
NOT_A_SYSTEM = Message("'{parameter}' is {value}, which is not a coordinate reference system; choose one.")
NO_NUMBER = Message("'{parameter}' is '{value}', which is not a number; write it with a point, such as 0.7.")
NUMBER_TOO_SMALL = Message("'{parameter}' is {value:g}; give {least:g} or more.")
NUMBER_BEYOND = Message("'{parameter}' is {value:g}; give a number from {least:g} to {most:g}.")
WORD_UNKNOWN = Message("'{parameter}' is '{value}'; give one of {known}.")
# lists of rasters
NO_RASTERS = Message("No rasters are given; choose at least one.")
NO_RASTER_USABLE = Message("None of the rasters can be used: {why}")
# where the work is done
TASK_FAILED = Message("{task} failed ({error}); please report this.")
UNLOADED = Message("Seam Inspector was updated or turned off while this ran; start it again.")
DASK_MISSING = Message(
    "A Dask scheduler was given but Dask is not installed; install 'dask[distributed]', or give no scheduler.")
SCHEDULER_SILENT = Message(
    "No Dask scheduler answers at {address} ({error}); check the address (the usual port is 8786), or give none.")
DASK_VERSIONS = Message(
    "Dask {versions} answers at {address}, and this is Dask {own}; install the same version of dask and distributed on "
    "the scheduler, the workers and here.")
NO_EXECUTOR = Message(
    "{given} is not an executor; give one of concurrent.futures, a Dask client, or the address of a Dask scheduler.")
EXECUTOR_LOST = Message(
    "The executor was shut down or lost its workers; open a new one, then run this again. A script whose processes are "
    "spawned needs the line if __name__ == '__main__': above its work.")
SCHEDULER_WITHOUT_WORKERS = Message(
    "The Dask scheduler at {address} is gone, or has no workers that answer; start some, or give no scheduler.")
WORKERS_WITHOUT_PACKAGES = Message(
    "The workers of the Dask scheduler at {address} lack {packages} in their Python; install it there (osgeo is GDAL's "
    "python3-gdal), or give no scheduler.")
# one or many windows
OF_A_WINDOW = Message("Window {window}: {what}", INFO)
OF_WINDOWS = Message("In {count} windows ({windows}), such as {window}: {what}", INFO)
# outputs and charts
NAME_MISREAD = Message(
    "'{output}' can't be {path}: '{found}' means something else there to QGIS or GDAL; choose another name.")
FIELD_NAMES_CUT = Message(
    "In {path} field names are cut to ten letters ({names}), so they can't be found, or are mistaken for others; write "
    "a GeoPackage to keep them.", WARNING)
LAYER_IN_PART = Message(
    "{path} holds {held} of {count} features, as the rest can't be written; make room on the disk, and run this again.")
LAYER_BESIDE = Message(
    "{path} is unchanged, as the run did not finish or another program has the file open; the new layer is {part}.",
    WARNING)
FILE_FORMAT_OTHER = Message("{name} has the wrong ending; the file is written as {filters}, so give it that ending.")
