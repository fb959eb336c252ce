"""Paths by how far along them: where their vertices lie, and what lies at such stations."""
from __future__ import annotations

import numpy as np


def vertex_stations(path: np.ndarray) -> np.ndarray:
    """Length of a path, (n, 2), up to each of its vertices, (n,)."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))])


def points_at(path: np.ndarray, along: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Points of a path, (m, 2), at some stations, (m,). ``along``: those of its vertices."""
    return np.column_stack([np.interp(wanted, along, one) for one in path.T])
