"""The step of tone across a cut: the means of 2 to 10 px on either side, as the French order of 2003 has it."""
from __future__ import annotations

import numpy as np
from scipy import ndimage

from ....imagery.lines import points_at, vertex_stations

_NEAR_PX, _FAR_PX = 2, 10
_STATION_PX = 16
_FEWEST_STATIONS = 4


def tone_step(plane: np.ndarray, points: np.ndarray, valid: np.ndarray) -> float | None:
    """Along a line, ``points`` (n, 2) columns and rows in a plane (rows, columns), DN; None where it is too short.

    The median over stations of 16 px of the left mean less the right one. ``plane`` is less what images without a cut
    show there, so that what changes on the ground is no step. ``valid``: (rows, columns) bool.
    """
    along = vertex_stations(points)
    places = np.arange(0.5, along[-1] // _STATION_PX * _STATION_PX)
    middles, after, before = (points_at(points, along, places + by) for by in (0, 4, -4))
    ahead = (after - before) / np.maximum(np.hypot(*(after - before).T), 1e-9)[:, np.newaxis]
    normals = np.column_stack([ahead[:, 1], -ahead[:, 0]])
    offsets = np.arange(_NEAR_PX, _FAR_PX) + 0.5
    across = np.stack([middles[:, np.newaxis] + side * offsets[:, np.newaxis] * normals[:, np.newaxis]
                       for side in (1, -1)])  # fmt: skip
    rows_columns = across[..., ::-1].transpose(3, 0, 1, 2) - 0.5
    found = ndimage.map_coordinates(np.where(valid, plane, np.nan), rows_columns, order=0, cval=np.nan)
    sides = found.reshape(2, -1, _STATION_PX * len(offsets))
    known = np.isfinite(sides)
    told = (2 * known.sum(axis=2) >= sides.shape[2]).all(axis=0)
    if np.count_nonzero(told) < _FEWEST_STATIONS:
        return None
    left, right = np.nanmean(sides[:, told], axis=2)
    return abs(float(np.median(left - right)))
