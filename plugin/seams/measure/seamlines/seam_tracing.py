"""Seams from labels, as lines without staircase and confetti, and the polygons between them with the same borders."""
from __future__ import annotations

import struct
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from osgeo import ogr
from scipy import ndimage

from ....imagery.gdal_calls import gdal_silenced
from ....imagery.grids import Grid
from ....imagery.lines import as_xy, is_polygon, simple_parts, straightened
from .label_borders import NONE, SourceBorder, joined_borders
from .seam_pieces import SidedSeam

_SIGMA = 2.0  # samples along a border, 8 px: a stair's length and more; a corner of 90 degrees is cut by 6 px
_STRAIGHT = 0.5  # samples, 2 px, that a vertex may be off the straight line before it is kept
_STAIR = 1.0  # the same on outlines, whose corners are kept as they are


def seams_of(borders: Iterable[SourceBorder]) -> list[SidedSeam]:
    """The borders that have a source on either side, longest first."""
    seams = [SidedSeam(border.vertices, border.left, border.right) for border in borders if border.left != NONE]
    # Rounded, so that equal lengths stay equal; then from the north to the south.
    return sorted(seams, key=lambda seam: (-round(seam.length, 6), -seam.vertices[0, 1], seam.vertices[0, 0]))


def trace_borders(edges: np.ndarray, grid: Grid, columns: int, label_px: int = 4) -> list[SourceBorder]:
    """The seams and outlines that the edges of all tiles of labels, (4, n), make.

    A label stands for the middle of ``label_px`` x ``label_px`` pixels of ``grid``, ``columns`` of them lie side by
    side; it is the number of a source or -1 for none. Ends that meet in a junction are equal to the last digit.
    """
    corner = np.array([grid.left, grid.top])
    pixel = np.array([grid.pixel_width, -grid.pixel_height])
    borders = []
    for border in joined_borders(edges, columns):
        places = np.minimum(_regularised(border) * label_px, (grid.columns, grid.rows))
        borders.append(replace(border, vertices=corner + places * pixel))
    return borders


def _regularised(border: SourceBorder) -> np.ndarray:
    """A border without its stairs: (n, 2) columns and rows in samples; its ends stay."""
    path = border.vertices
    if border.left == NONE:
        return as_xy(straightened(path @ (1, 1j), _STAIR))
    middles = (path[:-1] + path[1:]) / 2
    if (path[0] == path[-1]).all():
        smooth = ndimage.gaussian_filter1d(middles, _SIGMA, axis=0, mode="wrap")
        smooth = np.concatenate([smooth, smooth[:1]])
        return as_xy(straightened(smooth @ (1, 1j), _STRAIGHT))
    # Continued beyond its ends by its own mirror image, turned upside down: the ends then stay where they are.
    whole = np.concatenate([path[:1], middles, path[-1:]])
    reach = int(4 * _SIGMA + 0.5)
    long = np.pad(whole, ((reach, reach), (0, 0)), mode="reflect", reflect_type="odd")
    smooth = ndimage.gaussian_filter1d(long, _SIGMA, axis=0)[reach:-reach]
    smooth[0], smooth[-1] = path[0], path[-1]
    return as_xy(straightened(smooth @ (1, 1j), _STRAIGHT))


@dataclass(frozen=True)
class SourcePolygon:
    """All parts of a mosaic that follow one source."""

    source: int
    """Its number."""
    wkb: bytes
    """Multipolygon in map units."""


def polygons_of(borders: Iterable[SourceBorder]) -> list[SourcePolygon]:
    """The polygons between borders, by number of source. Neighbours share their border, vertex by vertex."""
    # Each border once in the direction that has the source on its left.
    sides: defaultdict[int, dict[int, tuple[int, np.ndarray]]] = defaultdict(dict)
    rings: defaultdict[int, list[np.ndarray]] = defaultdict(list)
    for border in borders:
        for source, backward in ((border.left, False), (border.right, True)):
            if source == NONE:
                continue
            vertices = border.vertices[::-1] if backward else border.vertices
            start, stop = border.keys[::-1] if backward else border.keys
            if start == stop:
                rings[source].append(vertices)
            else:
                sides[source][start] = stop, vertices
    for source, leaving in sides.items():
        rings[source] += _joined(leaving)
    return [SourcePolygon(source, _multipolygon(rings[source])) for source in sorted(rings)]


def _joined(leaving: dict[int, tuple[int, np.ndarray]]) -> list[np.ndarray]:
    """Borders end to end as rings. ``leaving``: by the node where it starts, the node where each stops and its path.

    At a node a source has one border that comes in and one that goes out: nodes where it has two are two nodes.
    """
    rings = []
    while leaving:
        first, (node, path) = leaving.popitem()
        paths = [path]
        while node != first:
            node, path = leaving.pop(node)
            paths.append(path)
        rings.append(np.concatenate([paths[0][:1], *(path[1:] for path in paths)]))
    return rings


def _multipolygon(rings: Sequence[np.ndarray]) -> bytes:
    """What lies inside an odd number of rings: outlines and holes; as it is valid where smoothing made them cross."""
    held = [struct.pack("<I", len(ring)) + ring.astype("<f8").tobytes() for ring in rings]
    polygon = ogr.CreateGeometryFromWkb(struct.pack("<BII", 1, ogr.wkbPolygon, len(rings)) + b"".join(held))
    with gdal_silenced():
        valid = polygon if polygon.IsValid() else polygon.MakeValid()
    whole = ogr.Geometry(ogr.wkbMultiPolygon)
    for part in parts_with_area(valid):
        whole.AddGeometry(part)
    return bytes(whole.ExportToWkb(ogr.wkbNDR))


def parts_with_area(geometry: ogr.Geometry) -> Iterator[ogr.Geometry]:
    """The polygons in a geometry."""
    return filter(is_polygon, simple_parts(geometry))
