"""The range of values that an image could have used."""
from __future__ import annotations

import numpy as np

from .rasters import Raster

BIT_DEPTHS = (8, 10, 11, 12, 14, 16)  # of cameras and scanners; the smallest that holds an image's largest value

ValueRange = tuple[float, float]
"""The lowest and the highest value that a pixel can hold."""


def is_range_known(image: Raster) -> bool:
    """Whether the data type or the file says the range, so that no pixel has to be asked."""
    return image.bits is not None or image.data_type in ("uint8", "int8")


def value_range(image: Raster, largest: float) -> ValueRange | None:
    """The range of an image whose largest value is given; None for values without a range of their own.

    8 bit: all of it. 16 bit: from the bits a pixel where the file says them, else the smallest usual depth of
    cameras and scanners that holds the largest value (12 bit in 16: 0 to 4095). Signed values start at their
    type's lowest value. 32 and 64 bit values have no range that an image would fill.
    """
    if image.data_type not in ("uint8", "int8", "uint16", "int16"):
        return None
    information = np.iinfo(image.data_type)
    if information.min < 0 or image.data_type == "uint8":
        return float(information.min), float(information.max)
    bits = image.bits or next((bits for bits in BIT_DEPTHS if largest < 2**bits), 16)
    return 0.0, float(2**bits - 1)
