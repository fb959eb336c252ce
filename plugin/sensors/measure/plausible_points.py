"""Whether points can be what they are said to be, before anything is fitted to them."""
from __future__ import annotations

import numpy as np

from ...imagery.errors import SensorModelError
from ...imagery.message import Message
from ...imagery.reference_systems import is_geographic
from . import messages
from .ground_system import GroundSystem
from .points import Points

LOWEST_M, HIGHEST_M = -12_000.0, 9000.0  # the Mariana Trench and Mount Everest, with what a geoid adds
FINEST_M, COARSEST_M = 1e-4, 1e5  # of a pixel on the ground: a scanned sample, a weather satellite's whole disk
MARGIN = 0.05  # of the image's sides: as far beyond its border a point may be measured
FEWEST_INSIDE = 0.5  # of the points, for a turned reading of them to be believed
_SHOWN = 5


def check_plausible(points: Points, size: tuple[int, int] | None) -> None:
    """Raise SensorModelError for the first thing that can't be; ``size``: the image's columns and rows, if known.

    Told are degrees and metres that were mistaken for each other, heights that are none on earth, and places outside
    the image: rows counted upwards as QGIS's georeferencer shows them, columns and rows interchanged.
    """
    x, y, z = points.ground.T
    if is_geographic(points.wkt) and not (np.abs(x).max() <= 360 and np.abs(y).max() <= 90):
        raise SensorModelError(messages.POINTS_NO_DEGREES(x=float(x[0]), y=float(y[0])))
    heights = z[np.isfinite(z)]
    if len(heights) and (heights.min() < LOWEST_M or heights.max() > HIGHEST_M):
        index = int(np.nanargmax(np.abs(z)))
        raise SensorModelError(messages.POINT_HEIGHT_IMPLAUSIBLE(name=points.ids[index], height=float(z[index])))
    across, metres = np.ptp(points.image, axis=0).max(), GroundSystem(points.wkt).metres(float(y.mean()))
    if across > 0 and len(points) > 1:
        pixel = float((np.ptp(points.ground[:, :2], axis=0) * metres).max() / across)
        if not FINEST_M <= pixel <= COARSEST_M:
            raise SensorModelError(messages.PIXEL_IMPLAUSIBLE(size=pixel))
    if size is not None:
        _check_inside(points, size)


def _check_inside(points: Points, size: tuple[int, int]) -> None:
    inside = _inside(points.image, size)
    if inside.all():
        return
    whys = (
        (points.image * [1, -1], messages.ROWS_NEGATIVE),
        (points.image[:, ::-1], messages.COLUMNS_AND_ROWS_INTERCHANGED),
    )
    for turned, why in whys:
        if _inside(turned, size).mean() > max(inside.mean(), FEWEST_INSIDE):
            raise SensorModelError(why())
    raise SensorModelError(_outside(points, inside, size))


def _inside(image: np.ndarray, size: tuple[int, int]) -> np.ndarray:
    margin = MARGIN * np.array(size)
    inside: np.ndarray = ((image >= -margin) & (image <= size + margin)).all(axis=1)
    return inside


def _outside(points: Points, inside: np.ndarray, size: tuple[int, int]) -> Message:
    names = [name for name, good in zip(points.ids, inside) if not good]
    return messages.POINTS_OUTSIDE_IMAGE(
        count=len(names), names=", ".join(names[:_SHOWN]), columns=size[0], rows=size[1]
    )
