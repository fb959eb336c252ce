"""What a user can be told of how windows and what was measured in them are kept."""
from __future__ import annotations

from ...imagery.errors import INFO, WARNING, Message

WINDOWS_NOT_SAVED = Message(
    "The windows in {name} could not be saved with the project ({error}); they stay open for editing, so save that "
    "layer elsewhere."
)
WINDOWS_KEPT_MEANWHILE = Message(
    "Until the project is saved its windows are in {path}; they move beside the project then.", INFO
)
WINDOWS_MOVED = Message("The windows moved beside the project, to {path}.", INFO)
WINDOWS_NOT_MOVED = Message(
    "The windows stay in {old}, as they can't be moved to {folder} ({error}); export them from there."
)
WINDOWS_IN_BOXES = Message(
    "Windows that are no rectangles along the mosaic's axes are measured in the boxes around them: {count}.", INFO
)
WINDOWS_FOUND = Message(
    "QGIS ended before a project with windows was saved; they are in {path}. Open its rasters, then the windows.",
    WARNING,
)
WINDOWS_BESIDE = Message(
    "{name} beside this project holds {count} windows that the project does not know.", WARNING
)
WINDOWS_RESTORED = Message(
    "QGIS ended without saving; the changes of {count} windows in {name} are back. Save the layer.", WARNING
)
WINDOWS_NOT_KEPT = Message(
    "Your verdicts are safe only once you save the layer: it can't be kept in {path} meanwhile ({error}).", WARNING
)
RESULTS_NOT_KEPT = Message(
    "Curves and pictures of the windows can't be kept in {path} ({error}); without them windows have to be measured "
    "again once the project was closed.",
    WARNING,
)
WINDOWS_OF_ANOTHER_MOSAIC = Message(
    "The windows in {name} were measured and judged in {older}, and the mosaic is {newer} now.", WARNING
)
MOSAIC_IS_ANOTHER_NOW = Message(
    "{mosaic} has changed since the windows in {name} were measured and judged.", WARNING
)
WINDOWS_WITHOUT_FILE = Message(
    "The windows in {name} are in no file: they and their verdicts are lost when QGIS ends. Export the layer to a "
    "GeoPackage to keep them.",
    WARNING,
)
