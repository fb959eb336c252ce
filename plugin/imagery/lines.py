"""Seamlines: any lines or polygons that describe a mosaic's seams -> long, straightened, numbered seams.

Lines come as mosaicking and raster-to-vector tools leave them: up to hundreds of thousands of pieces one pixel long,
doubled, in any order and direction; polygons share their borders without sharing vertices. Both are turned into a
network of nodes and pieces, and its pieces into seams:

- A seam goes on where exactly two pieces meet. Where more meet, the two that go on straightest are one seam, then the
  next two unless they would turn back: neither a patch of a third source nor cells that touch at a corner chop it.
- A seam is straightened by 1.5 px (Douglas-Peucker): along a raster staircase it would be up to sqrt(2) times longer.
- Seams are numbered longest first, each from west to east (else from south to north); a ring starts at its westernmost
  vertex and runs counter-clockwise. So the order and direction of the input change nothing.

Inside this file points are complex numbers x + iy, in networks in pixels of the mosaic, none of them negative: shifts,
lengths, directions and projections are then one operation each.
"""
from __future__ import annotations

import math
import struct
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import chain, combinations

import numpy as np
from osgeo import gdal, ogr
from scipy.spatial import cKDTree

from . import messages
from .errors import SeamlineError
from .gdal_calls import gdal_silenced
from .grids import Grid, PixelWindow


def vertex_stations(path: np.ndarray) -> np.ndarray:
    """Length of a path, (n, 2), up to each of its vertices, (n,)."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))])


def points_at(path: np.ndarray, along: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Points of a path, (m, 2), at some stations, (m,). ``along``: those of its vertices."""
    return np.column_stack([np.interp(wanted, along, axis) for axis in path.T])


def points_along(path: np.ndarray, step: float) -> np.ndarray:
    """Points of a path, (m, 2), from end to end and less than ``step`` apart."""
    along = vertex_stations(path)
    return points_at(path, along, np.linspace(0, along[-1], int(along[-1] / step) + 2))


def stretches_inside(path: np.ndarray, along: np.ndarray, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """(k, 2): stations between which a path, (n, 2), lies in a rectangle (Liang and Barsky). ``along``: stations of its
    vertices; ``low``, ``high``: the rectangle's corners, (2,)."""
    start, step = path[:-1], np.diff(path, axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        bounds = np.stack([(low - start) / step, (high - start) / step])
    reach = np.where((start >= low) & (start <= high), np.inf, -np.inf)  # of what runs parallel: wholly in or out
    enter = np.where(step == 0, -reach, bounds.min(axis=0)).max(axis=1).clip(0)
    leave = np.where(step == 0, reach, bounds.max(axis=0)).min(axis=1).clip(max=1)
    crosses = enter <= leave
    station, length = along[:-1][crosses], np.diff(along)[crosses]
    first, last = station + enter[crosses] * length, station + leave[crosses] * length
    apart = first[1:] > last[:-1] + 1e-9 * along[-1]  # else it goes on at a vertex
    return np.column_stack([first[np.append(True, apart)[: len(first)]], last[np.append(apart, True)[: len(last)]]])


def burnt(
    shapes: Iterable[tuple[ogr.Geometry, int]], grid: Grid, window: PixelWindow, background: int = 0,
    touched: bool = False,
) -> np.ndarray:
    """Values, 0 to 255, of the geometries that the pixels of a window lie in, the last one's of several; uint8.

    ``touched``: whether it is enough that a geometry touches a pixel; else it has to hold its middle.
    """
    xmin, _, _, ymax = grid.window_extent(window)
    with gdal_silenced():
        target = gdal.GetDriverByName("MEM").Create("", window.width, window.height, 1, gdal.GDT_Byte)
        target.SetGeoTransform((xmin, grid.pixel_width, 0, ymax, 0, -grid.pixel_height))
        target.GetRasterBand(1).Fill(background)
        vector = ogr.GetDriverByName("Memory").CreateDataSource("")
        layer = vector.CreateLayer("shapes")
        layer.CreateField(ogr.FieldDefn("value", ogr.OFTInteger))
        for geometry, value in shapes:
            feature = ogr.Feature(layer.GetLayerDefn())
            feature.SetGeometry(geometry)
            feature.SetField("value", value)
            layer.CreateFeature(feature)
        gdal.RasterizeLayer(target, [1], layer, options=["ATTRIBUTE=value", f"ALL_TOUCHED={touched}"])
        return np.asarray(target.ReadAsArray())


SNAP_PX = 0.5  # borders of polygons, and lines, nearer than this are one: half a raster step
BRANCH_REACH_PX = 10  # how far a branch's direction is looked at: beyond it a raster step turns it by < 6 degrees
BRANCH_TURN_DEG = 75.0  # the straightest two of three branches turn by 60 at most, so one seam always goes on


def network(pieces: np.ndarray, tolerance: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Nodes (k,) in which pieces, (n, 2) start and end, meet; edges (m, 2) as node numbers, in the direction of their
    piece; and the piece (m,) that each edge is a part of.

    Ends within ``tolerance`` of each other become one node, and a piece that passes a node within it is split there. No
    new crossing points are made: pieces that cross elsewhere do overlap and share no border.
    """
    nodes, ends = _clustered(pieces, tolerance)
    piece, passed = _passed_nodes(nodes, ends, tolerance)
    count = np.arange(len(ends))
    piece = np.concatenate([count, piece, count])
    node = np.concatenate([ends[:, 0], passed, ends[:, 1]])
    start, stop = nodes[ends[piece]].T
    along = ((nodes[node] - start) * (stop - start).conj()).real
    order = np.lexsort((node, along, piece))
    piece, node = piece[order], node[order]
    follows = (piece[1:] == piece[:-1]) & (node[1:] != node[:-1])
    return nodes, np.column_stack([node[:-1], node[1:]])[follows], piece[1:][follows]


def _clustered(points: np.ndarray, tolerance: float) -> tuple[np.ndarray, np.ndarray]:
    """Points no two of which lie within ``tolerance``, and for each input point the number of its one.

    From west to east each point is kept unless a kept one is near: chains of near points don't collapse.
    """
    unique, member = np.unique(points, return_inverse=True)
    pairs = cKDTree(as_xy(unique)).query_pairs(tolerance, output_type="ndarray")
    kept = list(range(len(unique)))
    for earlier, later in pairs[np.lexsort(pairs.T)].tolist():
        if kept[earlier] == earlier and kept[later] == later:
            kept[later] = earlier
    used, cluster = np.unique(kept, return_inverse=True)
    return unique[used], cluster[member].reshape(points.shape)


def _passed_nodes(nodes: np.ndarray, ends: np.ndarray, tolerance: float) -> tuple[np.ndarray, np.ndarray]:
    """Pairs (piece, node) where a piece passes a node within ``tolerance`` between its ends; pairs may repeat."""
    start, stop = nodes[ends].T
    length = abs(stop - start)
    # Long pieces are searched in steps of the mean length, each in the circle around it.
    steps = np.maximum(np.ceil(length / max(length.mean(), tolerance)), 1).astype(int)
    piece = np.repeat(np.arange(len(ends)), steps)
    step = np.arange(len(piece)) - np.repeat(np.cumsum(steps) - steps, steps)
    middle = start[piece] + (stop - start)[piece] * (step + 0.5) / steps[piece]
    near = cKDTree(as_xy(nodes)).query_ball_point(as_xy(middle), (length / steps / 2)[piece] + tolerance)
    passing = np.repeat(piece, list(map(len, near)))
    node = np.fromiter(chain.from_iterable(near), int, len(passing))
    offset = (nodes[node] - start[passing]) * (stop - start)[passing].conj()
    span = length[passing]
    inside = (offset.real > 0) & (offset.real < span**2) & (abs(offset.imag) <= tolerance * span)
    inside &= (node != ends[passing, 0]) & (node != ends[passing, 1])
    return passing[inside], node[inside]


def borders(pieces: np.ndarray, owner: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Nodes; pairs of them (m, 2) that are joined and have polygons on both sides; and the lowest and the highest owner
    on the left and on the right of each, (2, m).

    ``pieces``: (n, 2) of all rings, the interior on their left; ``owner``: (n,) number of the owner of each.
    """
    nodes, edges, piece = network(pieces, SNAP_PX)
    owner = owner[piece]
    forward = edges[:, 0] < edges[:, 1]
    pairs, pair = undirected(edges, len(nodes))
    low, high = np.full((2, len(pairs)), owner.max() + 1), np.full((2, len(pairs)), -1)
    for side, chosen in enumerate((forward, ~forward)):
        np.minimum.at(low[side], pair[chosen], owner[chosen])
        np.maximum.at(high[side], pair[chosen], owner[chosen])
    both = (high >= 0).all(axis=0)
    return nodes, pairs[both], low[:, both], high[:, both]


def undirected(edges: np.ndarray, node_count: int) -> tuple[np.ndarray, np.ndarray]:
    """Each pair of nodes that edges join, once, (k, 2); and for each edge the number of its pair, (m,)."""
    key, pair = np.unique(edges.min(axis=1) * node_count + edges.max(axis=1), return_inverse=True)
    return np.column_stack(np.divmod(key, node_count)), pair


def seam_paths(nodes: np.ndarray, edges: np.ndarray) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Edges (m, 2) end to end, the longest possible paths under the rules above, each straightened and as the numbers
    of its nodes, which are numbered from west to east, then from south to north.

    An end of edge e is numbered 2e (its start) or 2e + 1 (its stop), so ``end ^ 1`` is the other end.
    """
    edges, _ = undirected(edges, len(nodes))
    ends = edges.ravel()
    order = np.argsort(ends, kind="stable")
    degree = np.bincount(ends, minlength=len(nodes))
    simple = order[(degree == 2)[ends[order]]].reshape(-1, 2)
    next_end = np.full(len(ends), -1)
    next_end[simple] = simple[:, ::-1]
    chains = [np.append(ends[run], ends[run[-1] ^ 1]) for run in _runs(next_end)]

    # The same once more with chains for edges, now through the branches.
    outward: dict[int, list[tuple[int, complex]]] = {}
    for number, nodes_of_chain in enumerate(chains):
        for end, path in ((2 * number, nodes_of_chain), (2 * number + 1, nodes_of_chain[::-1])):
            if degree[path[0]] > 2:
                outward.setdefault(path[0], []).append((end, _direction(nodes[path])))
    next_end = np.full(2 * len(chains), -1)
    for ends_here in outward.values():
        for end, other in _straightest(ends_here):
            next_end[[end, other]] = other, end
    for run in _runs(next_end):
        parts = [chains[end >> 1][:: -1 if end & 1 else 1] for end in run]
        walk = np.concatenate([part[:-1] for part in parts] + [parts[-1][-1:]])
        if is_ring := walk[0] == walk[-1]:
            walk = np.roll(walk[:-1], -int(walk[:-1].argmin()))
            walk = np.append(walk, walk[0])
        if signed_area(nodes[walk]) <= 0 if is_ring else walk[0] > walk[-1]:
            walk = walk[::-1]
        seam = straightened(nodes[walk])
        if abs(np.diff(seam)).any():  # a loop of one pixel straightens to a point
            yield seam, walk


def _runs(next_end: np.ndarray) -> Iterator[list[int]]:
    """Edges in a row, each given by the end it is entered at. ``next_end``: the end that goes on from each, or -1."""
    following = next_end.tolist()
    done = bytearray(len(following) // 2)
    # Open ends first; what is left after them are rings.
    for start in chain(np.flatnonzero(next_end < 0).tolist(), range(len(following))):
        run = []
        while start >= 0 and not done[start >> 1]:
            done[start >> 1] = True
            run.append(start)
            start = following[start ^ 1]
        if run:
            yield run


def _direction(path: np.ndarray) -> complex:
    """Unit vector from the first vertex to the point some pixels along the path, beyond the raster's steps."""
    head = path[: 4 * BRANCH_REACH_PX]
    station = np.append(0, np.cumsum(abs(np.diff(head))))
    reach = min(BRANCH_REACH_PX, station[-1] / 2)  # half: the far end of a loop is its start
    step = np.interp(reach, station, head.real) + 1j * np.interp(reach, station, head.imag) - path[0]
    return step / abs(step) if step else 0j


def _straightest(branches: Sequence[tuple[int, complex]]) -> Iterator[tuple[int, int]]:
    """Pairs of ends at one node that go on into each other, straightest first.

    ``branches``: number of each end and the direction it goes from the node.
    """
    limit = -math.cos(math.radians(BRANCH_TURN_DEG))
    pairs = [((a * b.conjugate()).real, end, other) for (end, a), (other, b) in combinations(branches, 2)]
    free = {end for end, _ in branches}
    for cosine, end, other in sorted(pairs):
        if cosine <= limit and end in free and other in free:
            free -= {end, other}
            yield end, other


STRAIGHTEN_PX = 1.5  # a staircase leaves its line by up to 1 px, with a noisy step by 1.5 px
MAX_EXTENT_PX = 1e8  # 5000 km at 5 cm: a wider layer has another reference system than the mosaic


@dataclass(frozen=True, eq=False)
class Seam:
    """One seam of a mosaic."""

    seam_id: int
    """1..n, longest first."""
    vertices: np.ndarray
    """(n, 2) float64, n >= 2: x and y in map units; first and last are equal when the seam is a ring."""


def find_seams(geometries: Iterable[bytes | None], pixel_size: float) -> list[Seam]:
    """The seams that a layer's lines and polygons describe: lines themselves, the borders between polygons once.

    ``geometries``: WKB of each feature in the mosaic's CRS; points, None and empty ones are skipped. ``pixel_size``:
    the mosaic's, in map units; borders and lines up to half a pixel apart or over each other are taken as one.

    Raises SeamlineError when the layer holds no seam, can't be read, or is of another size than the mosaic.
    """
    lines, rings = _read(geometries)
    if not lines and not rings:
        raise SeamlineError(messages.SEAMLINES_NO_LINES())
    points = np.concatenate([*lines, *(ring for _, ring in rings)])
    if not np.isfinite(points).all():
        raise SeamlineError(messages.SEAMLINES_NOT_FINITE())
    origin = complex(points.real.min(), points.imag.min())
    check_extent(points / pixel_size)
    nodes, edges = np.empty(0, dtype=complex), np.empty((0, 2), dtype=int)
    if rings:
        owners, outlines = zip(*rings)
        pieces, ring = line_pieces(outlines)
        nodes, edges, low, high = borders((pieces - origin) / pixel_size, np.array(owners)[ring])
        edges = edges[low.min(axis=0) < high.max(axis=0)]
    if lines:
        pieces = (line_pieces(lines)[0] - origin) / pixel_size
        nodes, edges, _ = network(np.concatenate([pieces, nodes[edges]]), SNAP_PX)
    seams = [seam for seam, _ in seam_paths(nodes, edges)]
    if not seams:
        raise SeamlineError(messages.SEAMLINES_APART() if rings else messages.SEAMLINES_TOO_SHORT())
    # Rounded, so that equal lengths stay equal whichever way the input was summed up.
    seams.sort(key=lambda seam: (-round(abs(np.diff(seam)).sum(), 3), seam[0].real, seam[0].imag))
    return [Seam(number, as_xy(seam * pixel_size + origin)) for number, seam in enumerate(seams, start=1)]


def check_extent(places: np.ndarray) -> None:
    """Raise SeamlineError for places (..., complex), px, that are farther apart than any mosaic is wide."""
    width, height = np.ptp(places.real), np.ptp(places.imag)
    if max(width, height) > MAX_EXTENT_PX:
        raise SeamlineError(messages.SEAMLINES_TOO_WIDE(width=round(width), height=round(height)))


# --- reading ---------------------------------------------------------------------------------------------------


def _read(geometries: Iterable[bytes | None]) -> tuple[list[np.ndarray], list[tuple[int, np.ndarray]]]:
    """Lines, and polygon rings with the interior on their left and the feature that each belongs to (map units)."""
    lines: list[np.ndarray] = []
    rings: list[tuple[int, np.ndarray]] = []
    for number, wkb in enumerate(geometries, start=1):
        for part in simple_parts(read_geometry(wkb, number)) if wkb else ():
            if is_polygon(part):
                rings += [(number, ring) for ring in polygon_rings(part, number)]
            elif part.GetPointCount() > 1:
                lines.append(line_points(part))
    return lines, rings


def read_geometry(wkb: bytes, number: int) -> ogr.Geometry:
    """A geometry without curves, Z and M. Raises SeamlineError when the bytes are none."""
    geometry = None
    with suppress(RuntimeError):  # only where the process has GDAL's exceptions switched on
        geometry = ogr.CreateGeometryFromWkb(bytes(wkb))
    if geometry is None:
        raise SeamlineError(messages.SEAMLINES_BROKEN(feature=number))
    if geometry.HasCurveGeometry():
        geometry = geometry.GetLinearGeometry()
    geometry.FlattenTo2D()
    return geometry


def simple_parts(geometry: ogr.Geometry) -> Iterator[ogr.Geometry]:
    """Every line string and polygon in a geometry, however deep in collections; each outlives what it was a part of."""
    if is_line(geometry) or is_polygon(geometry):
        if not geometry.IsEmpty():
            yield geometry
    else:
        for index in range(geometry.GetGeometryCount()):
            yield from simple_parts(geometry.GetGeometryRef(index).Clone())


def is_line(geometry: ogr.Geometry) -> bool:
    return geometry.GetGeometryType() == ogr.wkbLineString


def is_polygon(geometry: ogr.Geometry) -> bool:
    return geometry.GetGeometryType() in (ogr.wkbPolygon, ogr.wkbTriangle)


def polygon_rings(polygon: ogr.Geometry, number: int) -> Iterator[np.ndarray]:
    """The rings of a polygon, its interior on their left: outer ones counter-clockwise, inner ones clockwise.

    Raises SeamlineError when the polygon is invalid beyond repair.
    """
    valid = None
    if all(np.isfinite(ring).all() for ring in _rings(polygon)):  # GEOS dies of others
        with gdal_silenced(), suppress(RuntimeError):  # IsValid warns on stderr about what is repaired here
            valid = polygon if polygon.IsValid() else polygon.MakeValid()
    if valid is None:
        raise SeamlineError(messages.SEAMLINES_BROKEN(feature=number))
    for part in filter(is_polygon, simple_parts(valid)):
        for index, ring in enumerate(_rings(part)):
            yield ring if (signed_area(ring) > 0) == (index == 0) else ring[::-1]


def _rings(polygon: ogr.Geometry) -> Iterator[np.ndarray]:
    """The vertices of a 2D polygon's rings, complex, the outer one first."""
    for number in range(polygon.GetGeometryCount()):
        yield np.array(polygon.GetGeometryRef(number).GetPoints(), float).reshape(-1, 2) @ (1, 1j)


def line_points(line: ogr.Geometry) -> np.ndarray:
    """The vertices of a 2D line string, complex."""
    return np.frombuffer(line.ExportToWkb(ogr.wkbNDR), dtype="<c16", offset=9)  # byte order, type, number of points


# --- lines -----------------------------------------------------------------------------------------------------


def straightened(path: np.ndarray, tolerance: float = STRAIGHTEN_PX) -> np.ndarray:
    """A path without the vertices that lie within ``tolerance`` of it (Douglas-Peucker)."""
    header = struct.pack("<BII", 1, ogr.wkbLineString, len(path))
    return line_points(ogr.CreateGeometryFromWkb(header + path.astype("<c16").tobytes()).Simplify(tolerance))


def signed_area(ring: np.ndarray) -> float:
    """Area of a closed ring, positive when it runs counter-clockwise."""
    ring = ring - ring[0]
    return float((ring[:-1].conj() * ring[1:]).imag.sum()) / 2


def line_pieces(paths: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """The pieces of all paths, (n, 2) start and end, and the number of the path each one is from, (n,)."""
    points = np.concatenate(paths)
    path = np.repeat(np.arange(len(paths)), [len(vertices) for vertices in paths])
    within = path[1:] == path[:-1]
    return np.column_stack([points[:-1], points[1:]])[within], path[1:][within]


def line_wkt(vertices: np.ndarray) -> str:
    """A line of (n, 2) vertices as WKT, to the last digit."""
    return f"LINESTRING ({', '.join(f'{x!r} {y!r}' for x, y in vertices.tolist())})"


def as_xy(points: np.ndarray) -> np.ndarray:
    """(n, 2) float64 of (n,) complex."""
    return np.column_stack([points.real, points.imag])
