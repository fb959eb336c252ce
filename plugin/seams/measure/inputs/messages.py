"""Why a raster is not suggested as a source of the mosaic, what is odd about one that is, and which is a copy."""
from __future__ import annotations

from ....imagery.errors import INFO, WARNING, Message

# by its header
IS_THE_MOSAIC = Message("The mosaic itself.", INFO)
APART_FROM_MOSAIC = Message("Does not overlap the mosaic.", INFO)
OTHER_BANDS = Message("Other bands, {bands} and not {mosaic}: heights, a mask or a map.", INFO)
LARGER_PIXELS = Message("Pixels {factor:.1f} times as large as the mosaic's: an overview or a map.", INFO)
SMALLER_PIXELS = Message("Pixels {factor:.1f} times smaller than the mosaic's: another flight.", INFO)
OTHER_SYSTEM = Message("In another reference system than the mosaic and others here: a reprojected copy.", INFO)
OTHER_TYPE = Message("Pixels of {own}, the mosaic's and others' are {mosaic}: a converted copy.", INFO)
COVERS_MOSAIC = Message("Covers the whole mosaic, as few others do: a copy of it, another mosaic or a map.", INFO)
# sources that were made from the mosaic, and are given
COPY_AMONG_SOURCES = Message(
    "{name} matches the mosaic on both sides of its seams, so it is a copy or an overview of it, or the mosaic that "
    "this one was cut from. It would hide every loss and is left out of the sources.", WARNING
)
MAY_BE_COPY = Message(
    "{name} is the same as the mosaic wherever they were compared. It is used, as it may be one of the orthoimages; "
    "if it is a copy of the mosaic or a part of it, it hides every loss there, so remove it from the sources.", WARNING
)
MAY_BE_ALTERED_COPY = Message(
    "{name} is like the mosaic wherever they were compared, as orthoimages of one ground can be. If it was made from "
    "the mosaic, it hides losses, so remove it from the sources.", INFO
)
MADE_OF_OTHERS = Message(
    "{name} shows what other sources show, with less detail, as a blurred mosaic or a mean of orthoimages does. It "
    "hides losses, so remove it from the sources.", WARNING
)
ONE_IMAGE_IN_PARTS = Message(
    "{name} and {count} more show the same pixels where they overlap: they are parts of one image and are treated "
    "as one.", INFO
)
