"""In what floating point values are measured: limits of energy are meant for values as those of 8 or 16 bit are."""
from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np

from ....imagery.clips import Clip, read_clip
from ....imagery.errors import RasterError
from ....imagery.grids import PixelWindow
from ....imagery.open_raster import OpenRaster
from ....imagery.raster_pool import open_raster
from ....imagery.rasters import Raster
from ..source_images import even_places

USUAL_RANGE = (32.0, 70_000.0)
"""Between the outermost percentiles: values of less or more are brought to 8 bit, by a factor that is the same for
all that is delivered from 0 to 1."""
_SAMPLES, _SIDE_PX = 6, 128  # along each side of a raster, and of a sample: 600,000 pixels that span its values
_WIDEST = 1.5  # what goes for 0 to 1, as reflectance of snow and of glints is more
_ALIKE = 10.5  # times: factors that differ no more are of one scale, near to where the next one begins


def grey_factor(raster: Raster) -> float:
    """What the values of a raster are multiplied by; 1 for whole numbers and for values of a usual range."""
    if not raster.data_type.startswith("float"):
        return 1.0
    changed = 0.0
    with suppress(OSError):  # one in the net
        changed = Path(raster.ref.path).stat().st_mtime
    return _sampled_factor(raster, changed)


def read_grey_clip(
    source: OpenRaster, mosaic: Raster, window: PixelWindow, partly: bool = False
) -> tuple[Clip, float]:
    """A clip as ``read_clip`` has it, in values as those of 8 or 16 bit are, and by what they were multiplied.

    Raises RasterError.
    """
    clip = read_clip(source, mosaic, window, partly)
    factor = clip_factor(clip, mosaic)
    return (clip if factor == 1 else replace(clip, bands=clip.bands * clip.bands.dtype.type(factor))), factor


def clip_factor(clip: Clip, mosaic: Raster) -> float:
    """What the values of a clip are multiplied by: those of a source of the mosaic's scale as the mosaic's."""
    if clip.bands.dtype.kind != "f":
        return 1.0
    mosaic_factor, factor = grey_factor(mosaic), grey_factor(clip.raster)
    return mosaic_factor if mosaic_factor / _ALIKE < factor < mosaic_factor * _ALIKE else factor


@lru_cache(1024)
def _sampled_factor(raster: Raster, changed: float) -> float:
    """``changed``: when the file was, as another one may be there under its name."""
    try:
        opened, whole = open_raster(raster.ref), PixelWindow(0, 0, raster.columns, raster.rows)
        blocks = map(opened.read, even_places(whole, _SIDE_PX, (_SAMPLES, _SAMPLES)))
        samples = [block.bands[:3, block.valid].ravel() for block in blocks]
    except RasterError:
        return 1.0  # the scan says so where it needs it
    return factor_of(np.concatenate(samples))


def factor_of(values: np.ndarray) -> float:
    """Factor as ``grey_factor`` has it, of some of the values themselves, in any shape."""
    if values.dtype.kind != "f" or not values.size:
        return 1.0
    low, high = np.percentile(values, (1, 99))
    least, most = USUAL_RANGE
    if least <= high - low <= most or high <= low:
        return 1.0
    return float(255 * 10.0 ** -math.ceil(math.log10((high - low) / _WIDEST)))
