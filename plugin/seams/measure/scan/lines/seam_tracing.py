"""Seams from labels: where a mosaic passes from one source to another, as lines without staircase and confetti."""
from __future__ import annotations

import struct
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from osgeo import ogr
from scipy import ndimage

from .....imagery.grids import Grid
from .label_borders import LabelBorder, label_borders
from .label_cleaning import NONE, cleaned

_SIGMA = 2.0  # samples along a border, 8 px: a stair's length and more; a corner of 90 degrees is cut by 6 px
_STRAIGHT = 0.5  # samples, 2 px, that a vertex may be off the straight line before it is kept
_STAIR = 1.0  # the same on outlines, whose corners are kept as they are


@dataclass(frozen=True, eq=False)
class TracedSeam:
    """A seam from one junction of three sources to the next, or a ring."""

    vertices: np.ndarray
    """(n, 2) float64 map units, n >= 2; first and last are equal when it is a ring."""
    left: int
    """Number of the source on the left hand of who walks along the vertices."""
    right: int
    """Number of the source on the right hand."""


@dataclass(frozen=True, eq=False)
class SourceBorder:
    """A border of what follows one source; seams are those that have a source on either side."""

    vertices: np.ndarray
    """(n, 2) float64 map units."""
    left: int
    """Number of the source on the left hand; ``NONE`` where the border is an outline."""
    right: int
    """Number of the source on the right hand."""
    keys: tuple[int, int]
    """What its ends are known by: borders with an end of the same key meet there."""


def seams_of(borders: Iterable[SourceBorder]) -> list[TracedSeam]:
    """The borders that have a source on either side, longest first."""
    seams = [TracedSeam(one.vertices, one.left, one.right) for one in borders if one.left != NONE]
    # Rounded, so that equal lengths stay equal; then from the north to the south.
    return sorted(seams, key=lambda one: (-round(_length(one.vertices), 6), -one.vertices[0, 1], one.vertices[0, 0]))


def trace_borders(strips: Iterable[np.ndarray], grid: Grid, label_px: int = 4) -> Iterator[SourceBorder]:
    """The seams and outlines that labels show, in no order to rely on.

    ``strips``: (rows, columns) int16 of the label raster from top to bottom, of any heights; a label stands for the
    middle of ``label_px`` x ``label_px`` pixels of ``grid`` and is the number of a source or -1 for none. Ends that
    meet in a junction are equal to the last digit. Memory grows with the length of the seams.
    """
    corner = np.array([grid.left, grid.top])
    pixel = np.array([grid.pixel_width, -grid.pixel_height])
    for border in label_borders(cleaned(strips, label_px)):
        places = np.minimum(_regularised(border) * label_px, (grid.columns, grid.rows))
        yield SourceBorder(corner + places * pixel, border.left, border.right, border.keys)


def _regularised(border: LabelBorder) -> np.ndarray:
    """A border without its stairs: (n, 2) columns and rows in samples; its ends stay."""
    path = border.nodes[:, ::-1].astype(float)
    if border.left == NONE:
        return _straightened(path, _STAIR)
    middles = (path[:-1] + path[1:]) / 2
    if (path[0] == path[-1]).all():
        smooth = ndimage.gaussian_filter1d(middles, _SIGMA, axis=0, mode="wrap")
        return _straightened(np.concatenate([smooth, smooth[:1]]), _STRAIGHT)
    # Continued beyond its ends by its own mirror image, turned upside down: the ends then stay where they are.
    whole = np.concatenate([path[:1], middles, path[-1:]])
    reach = int(4 * _SIGMA + 0.5)
    long = np.pad(whole, ((reach, reach), (0, 0)), mode="reflect", reflect_type="odd")
    smooth = ndimage.gaussian_filter1d(long, _SIGMA, axis=0)[reach:-reach]
    smooth[0], smooth[-1] = path[0], path[-1]
    return _straightened(smooth, _STRAIGHT)


def _straightened(path: np.ndarray, tolerance: float) -> np.ndarray:
    """A path without the vertices within ``tolerance`` of it (Douglas-Peucker)."""
    header = struct.pack("<BII", 1, ogr.wkbLineString, len(path))
    line = ogr.CreateGeometryFromWkb(header + path.astype("<f8").tobytes()).Simplify(tolerance)
    return np.frombuffer(line.ExportToWkb(ogr.wkbNDR), dtype="<f8", offset=9).reshape(-1, 2)


def _length(vertices: np.ndarray) -> float:
    return float(np.hypot(*np.diff(vertices, axis=0).T).sum())
