"""Heights of points: brought to the ellipsoid, or taken from a terrain model."""
from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...imagery.message import Message
from ...imagery.rasters import RasterRef
from . import messages
from .ground_system import GroundSystem
from .height_datums import Datum, above_ellipsoid, heights_converted, vertical_system
from .models.least_squares import Scaling, least_squares
from .points import Points
from .terrain import load_terrain

FLAT_SHARE = 0.5  # of a pixel: heights that move the image by less make flat terrain


def with_heights(
    points: Points, datum: Datum, dem: RasterRef | None, dem_datum: Datum, name: str
) -> tuple[Points, list[Message]]:
    """Points with heights above the ellipsoid, and what to say about them.

    Heights that points have refer to ``datum``; points without get the terrain
    model's. Those that lie off the terrain model are left out, and without one those that have none where others do.
    Raises RasterError for a terrain model that can't be
    used and for heights that PROJ has no grid for.
    """
    notices: list[Message] = []
    heights = points.ground[:, 2].copy()
    given = np.isfinite(heights)
    geographic = GroundSystem(points.wkt).to_geographic(np.nan_to_num(points.ground))
    if given.any():
        system = points.heights_wkt or points.wkt
        vertical, assumed = vertical_system(system, datum, name)
        notices += assumed
        if vertical:
            moved = above_ellipsoid(geographic[given], vertical)
            notices.append(heights_converted(moved - heights[given], system, datum, name))
            heights[given] = moved
    if dem is not None and not given.all():
        low, high = geographic[:, :2].min(axis=0), geographic[:, :2].max(axis=0)
        extent = (float(low[0]), float(low[1]), float(high[0]), float(high[1]))
        terrain = load_terrain(dem, extent, dem_datum)
        notices += terrain.notices
        heights[~given] = terrain.at(geographic[~given])
    without = ~np.isfinite(heights)
    if without.any() and (dem is not None or given.any()):  # where no point has one, only models in space are lost
        why = messages.POINT_WITHOUT_HEIGHT() if dem is None else messages.POINT_OFF_DEM()
        notices += [messages.POINT_LEFT_OUT(name=point, why=why) for point, gone in zip(points.ids, without) if gone]
        points, heights = points.only(~without), heights[~without]
    return replace(points, ground=np.column_stack([points.ground[:, :2], heights])), notices


def is_flat(points: Points) -> bool:
    """Whether the points' heights move their images by less than half a pixel, by an affine camera through them."""
    heights = points.ground[:, 2]
    if not np.isfinite(heights).all() or np.ptp(heights) == 0:
        return True  # where heights are not known, nothing but a plane model can be fitted
    scaled = Scaling.of(points.ground).to(points.ground)
    affine = least_squares(np.column_stack([np.ones(len(scaled)), scaled]), points.image)
    return bool(2 * np.linalg.norm(affine.values[3]) < FLAT_SHARE)
