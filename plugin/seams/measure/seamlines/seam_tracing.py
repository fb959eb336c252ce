"""Labels as an estimate leaves them -> cleaned ones -> the borders between them, tile by tile; and from these seams as
lines without staircase and confetti, and the polygons between them with the same borders.

Cleaning: what is done to a label depends on labels less than ``REACH`` samples away only, so a tile with such a margin
gives what the whole mosaic would.

Borders: chains of sample sides from one junction of three labels to the next. A node is a corner of samples, an edge a
side between two samples with different labels. An edge is directed so that the lower label is on its left: at a node
that two edges meet, one therefore comes in and the other goes out, and they part the same two labels. Where four edges
meet and two labels face each other across, the node is taken for two that lie in one place, so that borders pass each
other there and don't end. Each tile tells its own edges, and all of them are joined in the end.
"""
from __future__ import annotations

import struct
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import chain
from operator import itemgetter

import numpy as np
from osgeo import ogr
from scipy import ndimage

from ....imagery.gdal_calls import gdal_silenced
from ....imagery.grids import Grid, PixelWindow
from ....imagery.lines import as_xy, is_polygon, simple_parts, straightened
from ..seam_cells import NONE
from .seam_pieces import SidedSeam

REACH = 96
"""Samples: twice the filters' own, once the largest island removed and once the way to what fills it."""
MARGIN = REACH + 1
"""Samples around a tile that its edges are traced by."""

_GAP = 3  # samples: a strip up to twice as wide without labels (12 to 24 px) is crossed by those around it
_SIGMA = 1.5  # samples, 6 px: of the neighbourhood whose majority counts; errors at borders are a cell or two wide
_ISLAND_PX2 = 600  # px squared: what is smaller says nothing of a seam, and is an error as often as not
_BORDER_SIGMA = 2.0  # samples along a border, 8 px: a stair's length and more; a corner of 90 degrees is cut by 6 px
_STRAIGHT = 0.5  # samples, 2 px, that a vertex may be off the straight line before it is kept
_STAIR = 1.0  # the same on outlines, whose corners are kept as they are

_DISK = sorted(
    ((down, across) for down in range(-_GAP, _GAP + 1) for across in range(-_GAP, _GAP + 1)
     if down**2 + across**2 <= _GAP**2),
    key=lambda offset: (offset[0] ** 2 + offset[1] ** 2, offset),
)


def _gaps_closed(labels: np.ndarray) -> np.ndarray:
    """Narrow strips without labels filled by the nearest one; the outline of what has labels stays as it is."""
    empty = labels == NONE
    far = ndimage.distance_transform_edt(empty) > _GAP
    if far.any():  # what a disk finds room in stays
        empty &= ndimage.distance_transform_edt(~far) > _GAP
    narrow, out, around = np.argwhere(empty), labels.copy(), np.pad(labels, _GAP, constant_values=NONE)
    for down, across in _DISK:
        row, column = narrow.T
        around_label = around[row + down + _GAP, column + across + _GAP]
        out[row, column] = around_label
        narrow = narrow[around_label == NONE]
    return out


def _outvoted(labels: np.ndarray) -> np.ndarray:
    """Each label the one that most of a small neighbourhood has, those nearer counting more; NONE has no vote."""
    best, winner = np.zeros(labels.shape, np.float32), np.full(labels.shape, NONE, labels.dtype)
    for label in np.flatnonzero(np.bincount(labels.ravel() - NONE)[1:]) + NONE + 1:
        # In float64: two labels with as many votes stay so, to the digits that are compared.
        mine = (labels == label).astype(np.float64)
        votes = ndimage.gaussian_filter(mine, _SIGMA, mode="constant", truncate=3.0).astype(np.float32)
        np.copyto(winner, label, where=votes > best)
        np.maximum(best, votes, out=best)
    return np.where(labels == NONE, NONE, winner)


def _islands_filled(labels: np.ndarray, island: int) -> np.ndarray:
    """Areas of less than ``island`` samples filled by what lies nearest, no farther off than an island may be large;
    empty ones too."""
    small = np.zeros(labels.shape, bool)
    for label in np.flatnonzero(np.bincount(labels.ravel() - NONE)) + NONE:
        area, _ = ndimage.label(labels == label)
        few = np.bincount(area.ravel()) < island
        few[0] = False
        small |= few[area]
    if not small.any() or small.all():
        return np.where(small, NONE, labels)
    away, nearest = ndimage.distance_transform_edt(small, return_indices=True)
    return np.where(away <= island, labels[tuple(nearest)], NONE)


def cleaned_edges(labels: np.ndarray, tile: PixelWindow, size: tuple[int, int], label_px: int) -> np.ndarray:
    """A tile's own edges: those within it, on its upper and its left side, and on the mosaic's outline.

    ``labels``: (rows, columns) int of samples of ``label_px``, of the tile with ``MARGIN`` around as far as the mosaic
    goes, which has a ``size`` of so many columns and rows. First, narrow gaps are
    closed, single wrong labels outvoted by their neighbours, and islands of less than 600 px squared given to what lies
    around them. Returns (4, n) int64: first and last node, left and right label; a node is twice its number, plus 1
    for the second of two in one place.
    """
    if (labels != labels[:1, :1]).any():
        labels = _islands_filled(_outvoted(_gaps_closed(labels)), max(_ISLAND_PX2 // label_px**2, 1))
    outer, inner = (tile.with_margin(margin).cut_to(*size) for margin in (MARGIN, 1))
    (top, _), (left, _) = outer.margins_of(inner)
    # Of the last tile the sample beyond is its own: there is nothing, and the outline lies before it.
    beyond = tile.column + tile.width == size[0], tile.row + tile.height == size[1]
    wanted = PixelWindow(tile.column - 1, tile.row - 1, tile.width + 2 + beyond[0], tile.height + 2 + beyond[1])
    known = labels[top : top + inner.height, left : left + inner.width]
    return _edges(np.pad(known, wanted.margins_of(inner), constant_values=NONE)[:-1], tile, size[0])


def _edges(labels: np.ndarray, tile: PixelWindow, width: int) -> np.ndarray:
    """(4, n) edges along the tops and the left sides of samples; ``labels`` begins with the row above and is a column
    wider on either side. ``width`` of the whole mosaic."""
    upper, lower = labels[:-1], labels[1:]
    across = upper[:, 1:-1] != lower[:, 1:-1]  # between rows: (row, column)
    down = lower[:, :-1] != lower[:, 1:]  # between columns: (row, node column); the last one is the next tile's
    # Nodes at the tops of these rows: the four samples around each.
    top_left, top_right = upper[:, :-1], upper[:, 1:]
    bottom_left, bottom_right = lower[:, :-1], lower[:, 1:]
    crossing = (top_left != top_right) & down & (top_left != bottom_left) & (top_right != bottom_right)
    falling, rising = top_left == bottom_right, top_right == bottom_left
    double = crossing & (falling | rising)
    falling = double & falling & (~rising | (top_left < top_right))
    rising = double & ~falling

    row, column = np.nonzero(across)
    node = 2 * ((tile.row + row) * (width + 1) + tile.column + column)
    north, south = upper[row, column + 1], lower[row, column + 1]
    # The node is the left end of one side, where falling takes the right arm up, and the right end of another.
    west, east = node + rising[row, column], node + 2 + falling[row, column + 1]
    eastward = north < south
    start, stop = np.where(eastward, west, east), np.where(eastward, east, west)
    left, right = np.minimum(north, south), np.maximum(north, south)

    row, column = np.nonzero(down[:, :-1])
    node = 2 * ((tile.row + row) * (width + 1) + tile.column + column)
    upper_end, lower_end = node + double[row, column], node + 2 * (width + 1)
    west_label, east_label = lower[row, column], lower[row, column + 1]
    southward = east_label < west_label
    return np.concatenate([
        np.stack([start, stop, left, right]),
        np.stack([
            np.where(southward, upper_end, lower_end), np.where(southward, lower_end, upper_end),
            np.minimum(west_label, east_label), np.maximum(west_label, east_label),
        ]),
    ], axis=1).astype(np.int64)


def _chained(start: np.ndarray, stop: np.ndarray) -> list[list[int]]:
    """Numbers of the edges of each border, one after the other: from a node that other than two meet to the next; of a
    ring from its lowest node."""
    nodes, counts = np.unique(np.concatenate([start, stop]), return_counts=True)
    junctions = set(nodes[counts != 2].tolist())
    starts, stops = start.tolist(), stop.tolist()
    leaving = {node: edge for edge, node in enumerate(starts) if node not in junctions}

    def chain_from(edge: int | None) -> Iterator[int]:
        while edge is not None:
            yield edge
            edge = leaving.pop(stops[edge], None)

    chains = [[*chain_from(edge)] for edge, node in enumerate(starts) if node in junctions]
    rings = ([*chain_from(leaving.pop(node))] for node in sorted(leaving) if node in leaving)
    return [*chains, *rings]


def seams_of(borders: Iterable[SidedSeam]) -> list[SidedSeam]:
    """The borders that have a source on either side, longest first."""
    seams = [border for border in borders if border.left != NONE]
    # Rounded, so that equal lengths stay equal; then from the north to the south.
    return sorted(seams, key=lambda seam: (-round(seam.length, 6), -seam.vertices[0, 1], seam.vertices[0, 0]))


def trace_borders(edges: np.ndarray, grid: Grid, columns: int, label_px: int = 4) -> list[SidedSeam]:
    """The borders that the edges of all tiles of labels, (4, n), make, by the nodes where they begin: each from one
    junction to the next, or a ring. The lower number is on the left, ``NONE`` of an outline; seams are the others.

    A label stands for the middle of ``label_px`` x ``label_px`` pixels of ``grid``, ``columns`` of them lie side by
    side; it is the number of a source or -1 for none. Ends that meet in a junction are equal to the last digit.
    """
    start, stop, left, right = edges
    corner = np.array([grid.left, grid.top])
    pixel = np.array([grid.pixel_width, -grid.pixel_height])
    borders = []
    for group in _chained(start, stop):
        nodes = np.append(start[group], stop[group[-1]])
        row, column = np.divmod(nodes // 2, columns + 1)
        sides = int(left[group[0]]), int(right[group[0]])
        path = _regularised(np.column_stack([column, row]).astype(float), is_outline=sides[0] == NONE)
        places = np.minimum(path * label_px, (grid.columns, grid.rows))
        borders.append(((nodes[0], nodes[-1], *sides), SidedSeam(corner + places * pixel, *sides)))
    return [border for _, border in sorted(borders, key=itemgetter(0))]


def _regularised(path: np.ndarray, is_outline: bool) -> np.ndarray:
    """A border without its stairs: (n, 2) columns and rows in samples; its ends stay."""
    if is_outline:
        return as_xy(straightened(path @ (1, 1j), _STAIR))
    middles = (path[:-1] + path[1:]) / 2
    if (path[0] == path[-1]).all():
        smooth = ndimage.gaussian_filter1d(middles, _BORDER_SIGMA, axis=0, mode="wrap")
        smooth = np.concatenate([smooth, smooth[:1]])
        return as_xy(straightened(smooth @ (1, 1j), _STRAIGHT))
    # Continued beyond its ends by its own mirror image, turned upside down: the ends then stay where they are.
    whole = np.concatenate([path[:1], middles, path[-1:]])
    reach = int(4 * _BORDER_SIGMA + 0.5)
    long = np.pad(whole, ((reach, reach), (0, 0)), mode="reflect", reflect_type="odd")
    smooth = ndimage.gaussian_filter1d(long, _BORDER_SIGMA, axis=0)[reach:-reach]
    smooth[0], smooth[-1] = path[0], path[-1]
    return as_xy(straightened(smooth @ (1, 1j), _STRAIGHT))


@dataclass(frozen=True)
class SourcePolygon:
    """All parts of a mosaic that follow one source."""

    source: int
    """Its number."""
    wkb: bytes
    """Multipolygon in map units."""


def polygons_of(borders: Iterable[SidedSeam]) -> list[SourcePolygon]:
    """The polygons between borders, by number of source. Neighbours share their border, vertex by vertex."""
    lines: defaultdict[int, ogr.Geometry] = defaultdict(lambda: ogr.Geometry(ogr.wkbMultiLineString))
    for border in borders:
        head = struct.pack("<BII", 1, ogr.wkbLineString, len(border.vertices))
        line = ogr.CreateGeometryFromWkb(head + border.vertices.astype("<f8").tobytes())
        for source in (border.left, border.right):
            if isinstance(source, int) and source != NONE:
                lines[source].AddGeometry(line)
    polygons = []
    for source, around in sorted(lines.items()):
        with gdal_silenced():
            polygon = ogr.BuildPolygonFromEdges(around)
            # What lies inside an odd number of rings, as it is valid where smoothing made them cross.
            valid = polygon if polygon.IsValid() else polygon.MakeValid()
        polygons.append(SourcePolygon(source, bytes(multipolygon([valid]).ExportToWkb(ogr.wkbNDR))))
    return polygons


def rectangle(xmin: float, ymin: float, xmax: float, ymax: float) -> ogr.Geometry:
    """A rectangle as a polygon."""
    return ogr.CreateGeometryFromWkt(
        f"POLYGON (({xmin!r} {ymin!r},{xmax!r} {ymin!r},{xmax!r} {ymax!r},{xmin!r} {ymax!r},{xmin!r} {ymin!r}))"
    )


def multipolygon(geometries: Iterable[ogr.Geometry]) -> ogr.Geometry:
    """All polygons in some geometries."""
    whole = ogr.Geometry(ogr.wkbMultiPolygon)
    for part in filter(is_polygon, chain.from_iterable(map(simple_parts, geometries))):
        whole.AddGeometry(part)
    return whole
