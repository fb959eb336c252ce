"""What a user can be told of how windows and what was measured in them are kept."""
from __future__ import annotations

from ...imagery.errors import INFO, WARNING, Message

WINDOWS_KEPT_MEANWHILE = Message(
    "Windows are stored in your profile until the project is saved, then beside it. Now they are in {path}.", INFO
)
WINDOWS_MISSING = Message(
    "The windows of this mosaic can't be opened: {path}. Put the file back and open the project again, or remove the "
    "layer to begin anew."
)
WINDOWS_MOVED = Message("The windows moved beside the project, to {path}.", INFO)
NOT_MOVED = Message(
    "The layer {name} stays in {old}, as it can't be moved to {folder} ({error}); export it from there."
)
NO_PIXELS_THERE = Message("No window there: pixels are missing. Draw a smaller one beside the edge.", WARNING)
PLACES_TAKEN = Message("Windows at the worst places: {count}, {sides} m wide; there already: {there}.", INFO)
WINDOWS_BACK = Message("Windows of this mosaic were restored. The project lacked them; they are in {path}.", INFO)
DECISION_THERE_ALREADY = Message("{path} exists already: choose another folder, so that no document is replaced.")
DECISION_NOT_SAVED = Message("The decision could not be saved in {folder} ({error}); choose another folder.")
WINDOWS_TO_COPY = Message(
    "The windows in {name} are not in a windows file, so results and verdicts can't be saved with them. Copy them into "
    "one?"
)
WINDOWS_OF_ANOTHER_MOSAIC = Message("The layer {name} has windows of {older}, and the mosaic is {newer} now.", WARNING)
SCAN_WITHOUT_MOSAIC = Message("The scan was stopped: its mosaic is not in the project any more.", WARNING)
MOSAIC_IS_ANOTHER_NOW = Message(
    "{mosaic} has changed since the windows in {name} were measured and judged.", WARNING
)
