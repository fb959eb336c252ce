"""Why a raster of the project is not suggested as a source of the mosaic."""
from __future__ import annotations

from ....imagery.message import INFO, Message

# by its header
IS_THE_MOSAIC = Message("It is the mosaic itself.", INFO)
APART_FROM_MOSAIC = Message("It does not overlap the mosaic.", INFO)
OTHER_BANDS = Message("It has {bands} bands and the mosaic {mosaic}: an elevation model, a mask or a map.", INFO)
LARGER_PIXELS = Message("Its pixels are {factor:.1f} times as large as the mosaic's: an overview or a map.", INFO)
SMALLER_PIXELS = Message("The mosaic's pixels are {factor:.1f} times as large as its own: another flight.", INFO)
OTHER_SYSTEM = Message(
    "It is in another reference system than the mosaic, and there are rasters in the mosaic's own: a reprojected copy.",
    INFO,
)
OTHER_TYPE = Message(
    "Its pixels are {own} and the mosaic's {mosaic}, as those of other rasters here are: a converted copy.", INFO
)
# by its pixels
BEING_LOOKED_AT = Message("It covers the whole mosaic, as a copy of it would: its pixels are being looked at ...", INFO)
MOSAIC_AGAIN = Message("It is the mosaic again: every place looked at is like it. It would hide every loss.", INFO)
MOSAIC_PART_AGAIN = Message(
    "It is a part of the mosaic again: every place looked at is like it, though other sources lie there.", INFO
)
MADE_OF_MOSAIC = Message("It is a VRT made of the mosaic. It would hide every loss.", INFO)
ANOTHER_MOSAIC = Message("It is another mosaic: one part of it is {first}, another is {second}.", INFO)
SAME_IMAGE = Message("It is the same image as {name}.", INFO)
NOT_FOLLOWED = Message("It covers the whole mosaic, and the mosaic is like it nowhere.", INFO)
OTHER_CONTENT = Message("It shows something else than the mosaic: a map, or another time.", INFO)
MAY_BE_MOSAIC = Message(
    "It covers the whole mosaic, as another mosaic would; tick it if it is one of the orthoimages.", INFO
)
PIXELS_NOT_READ = Message("Its pixels could not be compared with the mosaic's: {why}", INFO)
