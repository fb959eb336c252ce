"""Ground control points that an image holds itself."""
from __future__ import annotations

import numpy as np

from ...imagery.errors import SensorModelError
from ...imagery.open_raster import OpenRaster
from . import messages
from .points import Points


def image_points(image: OpenRaster) -> Points:
    """The points of an image, all for control. Raises SensorModelError where it has none, or they have no system.

    GDAL writes 0 where a height is not known, so heights that are all 0 are none.
    """
    found = image.dataset.GetGCPs() or ()
    if not found:
        raise SensorModelError(messages.NO_POINTS_IN_IMAGE(name=image.ref.name))
    wkt = image.dataset.GetGCPProjection() or image.ref.wkt
    if not wkt:
        raise SensorModelError(messages.POINTS_WITHOUT_SYSTEM(name=image.ref.name))
    numbers = np.array([(one.GCPPixel, one.GCPLine, one.GCPX, one.GCPY, one.GCPZ) for one in found], float)
    if not np.isfinite(numbers).all():
        raise SensorModelError(messages.IMAGE_POINTS_BROKEN(name=image.ref.name))
    if not numbers[:, 4].any():
        numbers[:, 4] = np.nan
    count = len(found)
    names = tuple(one.Id or str(number) for number, one in enumerate(found, 1))
    return Points(names, numbers[:, :2], numbers[:, 2:], wkt, np.full(count, np.nan), np.zeros(count, bool))
