"""In what floating point values are measured: limits of energy are meant for values as those of 8 or 16 bit are."""
from __future__ import annotations

import numpy as np

from .....imagery.errors import RasterError
from .....imagery.grids import PixelWindow
from .....imagery.raster_pool import open_raster
from .....imagery.rasters import Raster

USUAL_RANGE = (32.0, 70_000.0)
"""Between the outermost percentiles: values of less or more are brought to 8 bit."""
_SAMPLES, _SIDE_PX = 6, 128


def grey_factor(raster: Raster) -> float:
    """What the values of a raster are multiplied by; 1 for whole numbers and for values of a usual range."""
    if not raster.data_type.startswith("float"):
        return 1.0
    try:
        opened = open_raster(raster.ref)
        found = []
        width, height = min(_SIDE_PX, raster.columns), min(_SIDE_PX, raster.rows)
        for row in np.linspace(0, raster.rows - height, _SAMPLES).astype(int).tolist():
            for column in np.linspace(0, raster.columns - width, _SAMPLES).astype(int).tolist():
                block = opened.read(PixelWindow(column, row, width, height))
                found.append(block.bands[:3, block.valid].ravel())
    except RasterError:
        return 1.0  # the scan says so where it needs it
    return factor_of(np.concatenate(found))


def factor_of(values: np.ndarray) -> float:
    """The same for some of the values themselves, in any shape."""
    if values.dtype.kind != "f" or not values.size:
        return 1.0
    low, high = np.percentile(values, (1, 99))
    least, most = USUAL_RANGE
    return 1.0 if least <= high - low <= most or high <= low else float(255 / (high - low))
