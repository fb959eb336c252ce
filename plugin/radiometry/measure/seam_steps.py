"""The step of tone at the seams of a mosaic (French order of 16 September 2003, section 8.4)."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...imagery.grids import Grid, PixelWindow
from ...imagery.lines.paths import vertex_stations
from ...imagery.lines.seamlines import Seam
from ...imagery.open_raster import OpenRaster
from . import limits

_RUN = 512  # px of seam read at a time


@dataclass(frozen=True)
class SeamStep:
    """The step at one seam."""

    seam_id: int
    """As in ``Seam``."""
    stations: int
    """Pieces of 16 px along the seam that have valid pixels on both sides."""
    steps: tuple[float, ...]
    """Of each band, DN: the means to the left less those to the right, the median over the stations."""
    contrasts: tuple[float, ...]
    """Of each band, DN: the standard deviation on either side of a station, root mean square over the stations."""


def seam_steps(source: OpenRaster, window: PixelWindow, seams: Sequence[Seam]) -> list[SeamStep]:
    """The steps at all seams with at least four stations on valid pixels of a window of a north-up raster.

    Left and right are what lies 2 to 10 px from the seam: nearer, a straightened pixel staircase and a feather would
    be in it. Each station of 16 px has the difference of its two means. The median of a seam's stations is its step:
    an edge of the ground that runs along the seam for a while (a lineament, which the order leaves out) does not
    count. A step goes the same way all along a seam, so signs are kept until then.

    ``seams`` in the raster's reference system. Raises RasterError when the raster can't be read.
    """
    found = []
    for seam in seams:
        stations = [part for run in _runs(seam, source.raster.grid) for part in _stations(source, window, *run)]
        if len(stations) >= limits.MIN_SEAM_STATIONS:
            differences, variances = (np.array(figures) for figures in zip(*stations))
            steps, contrasts = np.median(differences, axis=0), np.sqrt(variances.mean(axis=0))
            found.append(SeamStep(seam.seam_id, len(stations), tuple(steps.tolist()), tuple(contrasts.tolist())))
    return found


def _runs(seam: Seam, grid: Grid) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Points one pixel apart along a seam, (n, 2) column and row, and the unit normals to the left, run by run."""
    vertices = _on_grid(seam.vertices, grid)
    lengths = np.hypot(*np.diff(vertices, axis=0).T)
    ends = vertex_stations(vertices)
    for first in range(0, int(ends[-1]), _RUN):
        along = np.arange(first, min(first + _RUN, int(ends[-1]))) + 0.5
        piece = np.clip(np.searchsorted(ends, along, side="right") - 1, 0, len(lengths) - 1)
        directions = np.diff(vertices, axis=0)[piece] / lengths[piece, np.newaxis]
        points = vertices[piece] + directions * (along - ends[piece])[:, np.newaxis]
        normals = np.column_stack([directions[:, 1], -directions[:, 0]])  # rows run down, so this is left
        yield points, normals


def _stations(
    source: OpenRaster, window: PixelWindow, points: np.ndarray, normals: np.ndarray
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """For every station of a run that has valid pixels on both sides, each (bands,): the left mean less the right one,
    and the mean of the variances of both sides."""
    reach = limits.SEAM_FAR_PX + 1
    first, last = (window.column, window.row), (window.column + window.width, window.row + window.height)
    left, top = np.maximum(np.floor(points.min(axis=0)) - reach, first).astype(int)
    right, bottom = np.minimum(np.ceil(points.max(axis=0)) + reach, last).astype(int)
    if left >= right or top >= bottom:
        return
    bands, invalid = source.read(PixelWindow(int(left), int(top), int(right - left), int(bottom - top)))
    offsets = np.arange(limits.SEAM_NEAR_PX, limits.SEAM_FAR_PX) + 0.5
    sides = []
    for sign in (1, -1):
        places = points[:, np.newaxis] + sign * offsets[:, np.newaxis] * normals[:, np.newaxis]
        columns, rows = np.floor(places).astype(int).transpose(2, 0, 1)
        inside = (columns >= left) & (columns < right) & (rows >= top) & (rows < bottom)
        columns, rows = np.where(inside, columns - left, 0), np.where(inside, rows - top, 0)
        valid = inside if invalid is None else inside & ~invalid[rows, columns]
        sides.append((bands[:, rows, columns], valid))
    for start in range(0, len(points) - limits.SEAM_STATION_PX + 1, limits.SEAM_STATION_PX):
        station = slice(start, start + limits.SEAM_STATION_PX)
        counts = [np.count_nonzero(valid[station]) for _, valid in sides]
        if min(counts) * 2 >= limits.SEAM_STATION_PX * len(offsets):
            left_values, right_values = (
                values[:, station][:, valid[station]].astype(np.float64) for values, valid in sides
            )
            difference = left_values.mean(axis=1) - right_values.mean(axis=1)
            yield difference, (left_values.var(axis=1) + right_values.var(axis=1)) / 2


def _on_grid(vertices: np.ndarray, grid: Grid) -> np.ndarray:
    """Map coordinates (n, 2) as columns and rows; repeated points are dropped."""
    places = grid.to_pixels(vertices)
    kept = np.concatenate([[True], np.hypot(*np.diff(places, axis=0).T) > 0])
    return np.asarray(places[kept])
