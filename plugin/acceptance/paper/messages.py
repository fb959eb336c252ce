"""What a user can be told of what a decision leaves on paper."""
from __future__ import annotations

from ...imagery.errors import INFO, WARNING, Message

DEFECTS_NOT_WRITTEN = Message(
    "The layer of failures can't be written; choose another folder, and close the file where it is open."
)
PICTURES_NOT_WRITTEN = Message(
    "The folder {folder} can't be written ({error}), so the layer of failures has no pictures."
)
PICTURES_MISSING = Message(
    "Failures without a picture: {count}; the mosaic does not show them, or can't be read there.", WARNING
)
PICTURES_LIMITED = Message("There are pictures of the longest {shown} of {count} failures.", INFO)
LOSS_NOT_OF_SCAN = Message(
    "{name} was not written by a scan as its picture of losses and is left out; choose the scan's LOSS.", WARNING
)
SCAN_UNEXPLAINED = Message(
    "{name}: the scan found no orthoimage behind {share:.0%} of the mosaic. Seams there are in no figure unless "
    "seamlines were given; scan again with the orthoimages that are missing.", WARNING
)
SEAMS_FOUND = Message(
    "{name}: the scan found the seams in the pixels, not all of which show theirs where a feather is wide. With the "
    "producer's SEAMLINES metres and lengths are those of all seams.", WARNING
)
MOSAIC_IS_LOSS = Message("{name} is a scan's picture of losses, no mosaic; no picture is cut from it.", WARNING)
PAPER_STOPPED = Message(
    "The run was stopped: the failures have no pictures, and there is neither report nor XML.", WARNING
)
