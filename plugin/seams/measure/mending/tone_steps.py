"""The step of tone across a cut: the means of 2 to 10 px on either side, as the French order of 2003 has it."""
from __future__ import annotations

import numpy as np

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
    places = np.arange(0.5, along[-1])
    middles = points_at(points, along, places)
    ahead = points_at(points, along, places + 4) - points_at(points, along, places - 4)
    normals = np.column_stack([ahead[:, 1], -ahead[:, 0]]) / np.maximum(np.hypot(*ahead.T), 1e-9)[:, np.newaxis]
    offsets = np.arange(_NEAR_PX, _FAR_PX) + 0.5
    means, counts = [], []
    for side in (1, -1):
        across = middles[:, np.newaxis] + side * offsets[:, np.newaxis] * normals[:, np.newaxis]
        columns, rows = np.floor(across).astype(int).transpose(2, 0, 1)
        inside = (columns >= 0) & (rows >= 0) & (columns < plane.shape[1]) & (rows < plane.shape[0])
        columns, rows = np.where(inside, columns, 0), np.where(inside, rows, 0)
        known = inside & valid[rows, columns]
        station = np.arange(len(places)) // _STATION_PX
        count = np.bincount(station, known.sum(axis=1))
        means.append(np.bincount(station, np.where(known, plane[rows, columns], 0).sum(axis=1)) / np.maximum(count, 1))
        counts.append(count)
    told = np.minimum(*counts) * 2 >= _STATION_PX * len(offsets)
    if np.count_nonzero(told) < _FEWEST_STATIONS:
        return None
    return abs(float(np.median((means[0] - means[1])[told])))
