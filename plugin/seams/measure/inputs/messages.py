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
# by its pixels
BEING_LOOKED_AT = Message("Covers the whole mosaic: being compared with it ...", INFO)
MOSAIC_AGAIN = Message("A copy of the mosaic: alike wherever they were compared. It would hide every loss.", INFO)
MOSAIC_OR_ITS_SOURCE = Message(
    "Like the mosaic wherever they were compared: a copy of it, or the one orthoimage that it was made from; tick it "
    "in that case.", INFO
)
MOSAIC_PART_AGAIN = Message(
    "A copy of a part of the mosaic: alike wherever they were compared, though other sources lie there.", INFO
)
MOSAIC_ALTERED = Message(
    "Another state of the mosaic: where they are alike, it goes with the mosaic from one orthoimage to the next.", INFO
)
MADE_OF_MOSAIC = Message("A VRT of the mosaic. It would hide every loss.", INFO)
ANOTHER_MOSAIC = Message("Another mosaic: partly {first}, partly {second}.", INFO)
SAME_IMAGE = Message("The same image as {name}.", INFO)
NOT_FOLLOWED = Message("Covers the whole mosaic and resembles it nowhere.", INFO)
HOLDS_LABELS = Message("Holds labels, not an image: {count} different values.", INFO)
OTHER_CONTENT = Message("Shows something other than the mosaic: a map, or another time.", INFO)
MAY_BE_MOSAIC = Message(
    "Covers the whole mosaic, as another mosaic would; tick it if it is one of the orthoimages.", INFO
)
PIXELS_NOT_READ = Message("Could not be compared with the mosaic: {why}", INFO)
# after windows were inspected
SOURCE_NOT_FOLLOWED = Message(
    "The mosaic follows {name} in none of the {count} windows that it took part in: is it one of its orthoimages?",
    WARNING,
)
SOURCES_NOT_FOLLOWED = Message(
    "The mosaic follows {count} of its {all} sources in no window that they took part in, such as {name}: are they its "
    "orthoimages?", WARNING
)
SOURCES_RESAMPLED = Message(
    "In windows with sources on the mosaic's own pixels {count} others took no part, such as {name}: their pixels have "
    "another size or direction, or they are in another reference system, so they would have to be resampled.", WARNING
)
# sources that were made from the mosaic, and are given
COPY_AMONG_SOURCES = Message(
    "{name} is like the mosaic everywhere, so it is a copy of it, or the mosaic that this one was cut from. It would "
    "hide every loss and is left out of the sources.", WARNING
)
ONE_IMAGE_IN_PARTS = Message(
    "{name} and {count} more show the same pixels where they overlap: they are parts of one image and are treated "
    "as one.", INFO
)
OVERVIEW_AMONG_SOURCES = Message(
    "{name} is the mosaic with larger pixels, an overview of it, and left out of the sources.", WARNING
)
ONLY_SOURCE_IS_EQUAL = Message(
    "{name} is like the mosaic everywhere and there is no other source; if it is a copy of the mosaic, nothing can be "
    "told of its seams, so give the orthoimages that it was made from.", WARNING
)
