"""The step of tone at the seams of a mosaic (French order of 16 September 2003, section 8.4)."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...imagery.grids import Grid, PixelWindow
from ...imagery.lines import Seam, points_at, vertex_stations
from ...imagery.open_raster import OpenRaster
from . import limits
from .image_statistics import figure_bands

_RUN = 512  # px of seam read at a time


@dataclass(frozen=True)
class SeamStep:
    seam_id: int  # number of the seam, as in ``Seam``
    stations: int  # pieces of 16 px along the seam that have valid pixels on both sides
    steps: tuple[float, ...]  # by band, DN: means on the left less those on the right, median over the stations
    contrasts: tuple[float, ...]  # by band, DN: standard deviation beside the seam, root mean square over the stations
    places: tuple[tuple[float, float], ...]
    """Place for each band: the middle of the station whose difference is nearest to the seam's step, on the map."""
    features: tuple[str, ...] = ()  # of the seamline layer, as its user knows them; empty where nobody asked
    layer: str = ""  # the name of that layer


def seam_steps(
    source: OpenRaster, window: PixelWindow, seams: Sequence[Seam], names: tuple[str, ...]
) -> list[SeamStep]:
    """The steps at all seams with at least four stations on valid pixels of a window of a north-up raster.

    Left and right are what lies 2 to 10 px from the seam: nearer, a straightened pixel staircase and a feather would
    be in it. Each station of 16 px has the difference of its two means. The median of a seam's stations is its step:
    an edge of the ground that runs along the seam for a while (a lineament, which the order leaves out) does not
    count. A step goes the same way all along a seam, so signs are kept until then.

    ``seams`` in the raster's reference system; ``names`` of the bands to be measured, which may have luminosity among
    them. Raises RasterError when the raster can't be read.
    """
    steps_found = []
    for seam in seams:
        grid = source.raster.grid
        stations = [part for run in _runs(seam, grid) for part in _stations(source, window, names, *run)]
        if len(stations) >= limits.MIN_SEAM_STATIONS:
            differences, variances, middles = (np.array(figures) for figures in zip(*stations))
            steps, contrasts = np.median(differences, axis=0), np.sqrt(variances.mean(axis=0))
            typical = np.abs(differences - steps).argmin(axis=0)
            places = tuple(grid.to_map(*middles[station]) for station in typical)
            steps, contrasts = tuple(steps.tolist()), tuple(contrasts.tolist())
            steps_found.append(SeamStep(seam.seam_id, len(stations), steps, contrasts, places))
    return steps_found


def _runs(seam: Seam, grid: Grid) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Points one pixel apart along a seam, (n, 2) column and row, and the unit normals to the left, run by run."""
    vertices = grid.to_pixels(seam.vertices)
    vertices = vertices[np.concatenate([[True], np.hypot(*np.diff(vertices, axis=0).T) > 0])]  # repeated ones go
    lengths = np.hypot(*np.diff(vertices, axis=0).T)
    ends = vertex_stations(vertices)
    for first in range(0, int(ends[-1]), _RUN):
        along = np.arange(first, min(first + _RUN, int(ends[-1]))) + 0.5
        piece = np.clip(np.searchsorted(ends, along, side="right") - 1, 0, len(lengths) - 1)
        directions = np.diff(vertices, axis=0)[piece] / lengths[piece, np.newaxis]
        normals = np.column_stack([directions[:, 1], -directions[:, 0]])  # rows run down, so this is left
        yield points_at(vertices, ends, along), normals


def _stations(
    source: OpenRaster, window: PixelWindow, names: tuple[str, ...], points: np.ndarray, normals: np.ndarray
) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """The stations of a run with valid pixels on both sides: (bands,) the left mean less the right one, (bands,) the
    mean of the variances of both sides, and (2,) column and row of the middle of each."""
    reach = limits.SEAM_FAR_PX + 1
    first, last = (window.column, window.row), (window.column + window.width, window.row + window.height)
    left, top = np.maximum(np.floor(points.min(axis=0)) - reach, first).astype(int).tolist()
    right, bottom = np.minimum(np.ceil(points.max(axis=0)) + reach, last).astype(int).tolist()
    if left >= right or top >= bottom:
        return
    bands, invalid = source.read(PixelWindow(left, top, right - left, bottom - top))
    offsets = np.arange(limits.SEAM_NEAR_PX, limits.SEAM_FAR_PX) + 0.5
    sides = []
    for sign in (1, -1):
        places = points[:, np.newaxis] + sign * offsets[:, np.newaxis] * normals[:, np.newaxis]
        columns, rows = np.floor(places).astype(int).transpose(2, 0, 1)
        inside = (columns >= left) & (columns < right) & (rows >= top) & (rows < bottom)
        columns, rows = np.where(inside, columns - left, 0), np.where(inside, rows - top, 0)
        valid = inside if invalid is None else inside & ~invalid[rows, columns]
        sides.append((figure_bands(source.raster, bands[:, rows, columns], names), valid))
    for start in range(0, len(points) - limits.SEAM_STATION_PX + 1, limits.SEAM_STATION_PX):
        station = slice(start, start + limits.SEAM_STATION_PX)
        counts = [int(np.count_nonzero(valid[station])) for _, valid in sides]
        if min(counts) * 2 >= limits.SEAM_STATION_PX * len(offsets):
            left_values, right_values = (
                values[:, station][:, valid[station]].astype(np.float64) for values, valid in sides
            )
            difference = left_values.mean(axis=1) - right_values.mean(axis=1)
            variance = (left_values.var(axis=1) + right_values.var(axis=1)) / 2
            yield difference, variance, points[station].mean(axis=0)
