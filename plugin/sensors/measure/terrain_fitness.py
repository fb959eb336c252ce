"""Whether a terrain model serves an image: what of the image it leaves without heights, and the size of its meshes."""
from __future__ import annotations

import numpy as np
from osgeo import gdal

from ...imagery.gdal_calls import gdal_silenced
from ...imagery.message import Message
from ...imagery.open_raster import OpenRaster
from . import messages
from .models.rational import Rational
from .terrain import Terrain

COVER_GRID = 256  # places a side that terrain heights are looked for at
FINEST_MESH_M, COARSEST_MESH_M = 9.0, 32.0  # 10 to 30 m (Kurczynski and Wolniewicz, conclusion 7); SRTM has 31


def uncovered_share(image: OpenRaster, rpc: Rational, terrain: Terrain, footprint: np.ndarray) -> float:
    """Share of the image's own pixels, those that hold something, that have no terrain heights."""
    sides = (np.linspace(footprint[:, axis].min(), footprint[:, axis].max(), COVER_GRID) for axis in (0, 1))
    places = np.stack(np.meshgrid(*sides), axis=-1).reshape(-1, 2)
    heights = terrain.at(places)
    missing = ~np.isfinite(heights)
    if not missing.any():
        return 0.0
    ground = np.column_stack([places, np.where(missing, footprint[:, 2].mean(), heights)])
    column, row = rpc.project(ground).T
    inside = (column >= 0) & (row >= 0) & (column < image.columns) & (row < image.rows)
    held = _held(image)
    down, across = held.shape
    inside[inside] = held[
        (row[inside] * down / image.rows).astype(int), (column[inside] * across / image.columns).astype(int)
    ]
    return float(np.count_nonzero(missing & inside) / max(np.count_nonzero(inside), 1))


def _held(image: OpenRaster) -> np.ndarray:
    """(rows, columns) bool, at most ``COVER_GRID`` a side: where the image holds something."""
    band = image.dataset.GetRasterBand(1)
    if band.GetMaskFlags() & gdal.GMF_ALL_VALID:
        return np.ones((1, 1), bool)
    size = min(image.columns, COVER_GRID), min(image.rows, COVER_GRID)
    with gdal_silenced():
        mask = band.GetMaskBand().ReadAsArray(buf_xsize=size[0], buf_ysize=size[1])
    return np.ones((1, 1), bool) if mask is None else mask != 0


def mesh_warnings(terrain: Terrain, of_photo: bool) -> list[Message]:
    """What is to be said of meshes beyond those that the paper found to serve; aerial photos may need finer ones."""
    if not terrain.name:
        return []  # one constant height
    shorter, longer = terrain.mesh_m()
    if longer > COARSEST_MESH_M:
        return [messages.MESH_COARSE(name=terrain.name, mesh=longer)]
    if shorter < FINEST_MESH_M and not of_photo:
        return [messages.MESH_FINE(name=terrain.name, mesh=shorter)]
    return []
