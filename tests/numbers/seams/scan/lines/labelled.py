"""Label rasters as an estimate leaves them, and how far lines lie from each other."""
from __future__ import annotations

from collections.abc import Iterable
from itertools import product

import numpy as np
from scipy import ndimage
from scipy.spatial import cKDTree
from scipy.special import ndtri
from seam_inspector.plugin.imagery.grids import Grid, PixelWindow
from seam_inspector.plugin.seams.measure.blocks.block_grid import squares_met
from seam_inspector.plugin.seams.measure.seamlines.seam_tracing import MARGIN, cleaned_edges

LABEL_PX = 4


def edges_of(labels: np.ndarray, side: int = 512) -> np.ndarray:
    """Edges of all tiles that cover labels, (4, n), each traced by those around, too."""
    rows, columns = labels.shape
    size, edges = (columns, rows), []
    for row, column in product(range(0, rows, side), range(0, columns, side)):
        tile = PixelWindow(column, row, side, side).cut_to(*size)
        around = labels[squares_met(tile.with_margin(MARGIN).cut_to(*size), 1)]
        edges.append(cleaned_edges(around, tile, size, LABEL_PX))
    return np.concatenate(edges, axis=1)


def estimated(labels: np.ndarray, seed: int, right_near: float = 0.94, right_far: float = 0.995) -> np.ndarray:
    """Labels (rows, columns) with the errors of an estimate: blobs of a few samples."""
    rng = np.random.default_rng(seed)
    border = np.zeros(labels.shape, dtype=bool)
    border[:, 1:] |= labels[:, 1:] != labels[:, :-1]
    border[1:] |= labels[1:] != labels[:-1]
    near = ndimage.distance_transform_edt(~border) <= 4
    blobs = ndimage.gaussian_filter(rng.normal(size=labels.shape), 1.2)
    wrong = abs(blobs / blobs.std()) > -ndtri(np.where(near, 1 - right_near, 1 - right_far) / 2)
    off = ndimage.gaussian_filter(rng.normal(size=(2, *labels.shape)), (0, 3, 3)) * 60
    places = np.rint(np.indices(labels.shape) + off).astype(int)
    moved = labels[tuple(places.clip(0, np.array(labels.shape)[:, None, None] - 1))]
    any_source = np.repeat(np.repeat(rng.integers(0, labels.max() + 1, np.array(labels.shape) // 4 + 1), 4, 0), 4, 1)
    any_source = any_source[: labels.shape[0], : labels.shape[1]]
    return np.where(wrong & (labels >= 0), np.where(near & (moved >= 0), moved, any_source), labels).astype(np.int16)


def points_between(labels: np.ndarray) -> np.ndarray:
    """(n, 2) columns and rows in pixels, one per pixel side between two sources, islands below 600 px left out."""
    labels = labels.copy()
    small = np.zeros(labels.shape, dtype=bool)
    for label in np.unique(labels):
        area, _ = ndimage.label(labels == label)
        sizes = np.bincount(area.ravel())
        small |= ((sizes < 600) & (np.arange(len(sizes)) > 0))[area]
    nearest = ndimage.distance_transform_edt(small, return_distances=False, return_indices=True)
    labels = labels[tuple(nearest)]
    beside = (labels[:, 1:] != labels[:, :-1]) & (labels[:, 1:] >= 0) & (labels[:, :-1] >= 0)
    below = (labels[1:] != labels[:-1]) & (labels[1:] >= 0) & (labels[:-1] >= 0)
    return np.concatenate([np.argwhere(beside)[:, ::-1] + (1, 0.5), np.argwhere(below)[:, ::-1] + (0.5, 1)])


def points_along(lines: Iterable[np.ndarray], grid: Grid) -> np.ndarray:
    """(n, 2) columns and rows, every half pixel along lines in map units."""
    points = []
    for line in lines:
        path = np.column_stack(
            [(line[:, 0] - grid.left) / grid.pixel_width, (grid.top - line[:, 1]) / grid.pixel_height]
        )
        station = np.append(0, np.cumsum(np.hypot(*np.diff(path, axis=0).T)))
        at = np.arange(0, station[-1], 0.5)
        points.append(np.column_stack([np.interp(at, station, axis) for axis in path.T]))
    return np.concatenate(points)


def distances(points: np.ndarray, to: np.ndarray) -> np.ndarray:
    """From each point to the nearest one of others."""
    return cKDTree(to).query(points)[0]
