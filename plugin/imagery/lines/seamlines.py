"""Seamlines: any lines or polygons that describe a mosaic's seams -> long, straightened, numbered seams.

Lines come as mosaicking and raster-to-vector tools leave them: up to hundreds of thousands of pieces one
pixel long, doubled, in any order and direction. Polygons (seam cells, source polygons) share their borders
without sharing vertices. Both are turned into a network of nodes and pieces, and its pieces into seams:

- A seam goes on where exactly two pieces meet. Where more meet, the two that go on straightest are one
  seam, then the next two unless they would turn back; a single one ends there. So neither a patch of a third
  source beside a seam nor two raster cells that touch at a corner chop it.
- A seam is straightened by 1.5 px (Douglas-Peucker), so that its length is the one on the ground: along a
  raster staircase it would be up to sqrt(2) times longer.
- Seams are numbered longest first. Each runs from its western end to its eastern one (from south to north
  when that decides nothing); a ring starts at its westernmost vertex and runs counter-clockwise. The order and
  direction of the input therefore change nothing.

Inside this file points are complex numbers x + iy, see ``networks``.
"""
from __future__ import annotations

import struct
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from osgeo import gdal, ogr

from .. import messages
from ..errors import SeamlineError
from . import line_networks

END_SNAP_PX = 0.1  # ends of lines nearer than this meet: far below a raster step, far above rounding
STRAIGHTEN_PX = 1.5  # a staircase leaves its line by up to 1 px, with a noisy step by 1.5 px
MAX_EXTENT_PX = 1e8  # 5000 km at 5 cm: a wider layer has another reference system than the mosaic


@dataclass(frozen=True, eq=False)
class Seam:
    """One seam of a mosaic."""

    seam_id: int
    """1..n, longest first."""
    vertices: np.ndarray
    """(n, 2) float64, n >= 2: x and y in map units; first and last are equal when the seam is a ring."""

    @property
    def length(self) -> float:
        """Length in map units."""
        return float(np.hypot(*np.diff(self.vertices, axis=0).T).sum())


def find_seams(geometries: Iterable[bytes | None], pixel_size: float) -> list[Seam]:
    """The seams that a layer's lines and polygons describe.

    ``geometries``: WKB of each feature in the mosaic's CRS; any line or polygon type, curves, Z and M allowed,
    points ignored, None and empty ones skipped. Lines are seams themselves, pieces with the same ends counted
    once. Polygons yield the borders between different features, each once; borders between the parts of one
    feature and the outside of the block are no seams. ``pixel_size``: the mosaic's, in map units; borders up
    to half a pixel apart or over each other are taken as one.

    Raises SeamlineError when the layer is empty, holds neither lines nor polygons, can't be read, is of another
    size than the mosaic by far, or holds polygons that share no border.
    """
    lines, rings, owners = _read(geometries)
    if not lines and not rings:
        raise SeamlineError(messages.SEAMLINES_NO_LINES())
    points = np.concatenate(lines + rings)
    if not np.isfinite(points).all():
        raise SeamlineError(messages.SEAMLINES_NOT_FINITE())
    origin = complex(points.real.min(), points.imag.min())
    width, height = np.ptp(points.real) / pixel_size, np.ptp(points.imag) / pixel_size
    if max(width, height) > MAX_EXTENT_PX:
        raise SeamlineError(messages.SEAMLINES_TOO_WIDE(width=round(width), height=round(height)))
    nodes, edges = np.empty(0, dtype=complex), np.empty((0, 2), dtype=int)
    if rings:
        pieces, ring = line_pieces(rings)
        nodes, edges = line_networks.borders((pieces - origin) / pixel_size, np.array(owners)[ring])
    if lines:
        pieces = (line_pieces(lines)[0] - origin) / pixel_size
        nodes, edges, _ = line_networks.network(np.concatenate([pieces, nodes[edges]]), END_SNAP_PX)
    seams = [straightened(directed(path)) for path in line_networks.joined(nodes, edges)]
    seams = [seam for seam in seams if abs(np.diff(seam)).any()]  # a loop of one pixel straightens to a point
    if not seams:
        raise SeamlineError(messages.SEAMLINES_APART() if rings else messages.SEAMLINES_TOO_SHORT())
    # Rounded, so that equal lengths stay equal whichever way the input was summed up.
    seams.sort(key=lambda seam: (-round(abs(np.diff(seam)).sum(), 3), seam[0].real, seam[0].imag))
    return [Seam(number, as_xy(seam * pixel_size + origin)) for number, seam in enumerate(seams, start=1)]


# --- reading ---------------------------------------------------------------------------------------------------


def _read(geometries: Iterable[bytes | None]) -> tuple[list[np.ndarray], list[np.ndarray], list[int]]:
    """Lines, polygon rings with the interior on their left, and the feature each ring belongs to (map units)."""
    lines: list[np.ndarray] = []
    rings: list[np.ndarray] = []
    owners: list[int] = []
    empty = True
    for number, wkb in enumerate(geometries, start=1):
        if not wkb:
            continue
        geometry = read_geometry(wkb, number)
        if geometry.IsEmpty():
            continue
        empty = False
        for part in simple_parts(geometry):
            if is_line(part):
                lines += [line_points(part)] if part.GetPointCount() > 1 else []
            else:
                found = list(polygon_rings(part, number))
                rings += found
                owners += [number] * len(found)
    if empty:
        raise SeamlineError(messages.SEAMLINES_EMPTY())
    return lines, rings, owners


def read_geometry(wkb: bytes, number: int) -> ogr.Geometry:
    """A geometry without curves, Z and M. Raises SeamlineError when the bytes are none."""
    try:
        geometry = ogr.CreateGeometryFromWkb(bytes(wkb))
    except RuntimeError as error:  # only where the process has GDAL's exceptions switched on
        raise SeamlineError(messages.SEAMLINES_BROKEN(feature=number)) from error
    if geometry is None:
        raise SeamlineError(messages.SEAMLINES_BROKEN(feature=number))
    if geometry.HasCurveGeometry():
        geometry = geometry.GetLinearGeometry()
    geometry.FlattenTo2D()
    return geometry


def simple_parts(geometry: ogr.Geometry) -> Iterator[ogr.Geometry]:
    """Every line string and polygon in a geometry, however deep in collections."""
    if is_line(geometry) or is_polygon(geometry):
        if not geometry.IsEmpty():
            yield geometry
    else:
        for index in range(geometry.GetGeometryCount()):
            yield from simple_parts(geometry.GetGeometryRef(index))


def is_line(geometry: ogr.Geometry) -> bool:
    return geometry.GetGeometryType() == ogr.wkbLineString


def is_polygon(geometry: ogr.Geometry) -> bool:
    return geometry.GetGeometryType() in (ogr.wkbPolygon, ogr.wkbTriangle)


def polygon_rings(polygon: ogr.Geometry, number: int) -> Iterator[np.ndarray]:
    """The rings of a polygon, its interior on their left: outer ones counter-clockwise, inner ones clockwise.

    Raises SeamlineError when the polygon is invalid beyond repair.
    """
    gdal.PushErrorHandler("CPLQuietErrorHandler")  # IsValid warns on stderr about what is repaired here
    try:
        valid = polygon if polygon.IsValid() else polygon.MakeValid()
    except RuntimeError as error:
        raise SeamlineError(messages.SEAMLINES_BROKEN(feature=number)) from error
    finally:
        gdal.PopErrorHandler()
    if valid is None:
        raise SeamlineError(messages.SEAMLINES_BROKEN(feature=number))
    for part in filter(is_polygon, simple_parts(valid)):
        wkb, offset = part.ExportToWkb(ogr.wkbNDR), 9  # byte order, type, number of rings
        for index in range(part.GetGeometryCount()):
            count = int.from_bytes(wkb[offset : offset + 4], "little")
            ring = np.frombuffer(wkb, dtype="<c16", count=count, offset=offset + 4)
            offset += 4 + ring.nbytes
            yield ring if (_signed_area(ring) > 0) == (index == 0) else ring[::-1]


def line_points(line: ogr.Geometry) -> np.ndarray:
    """The vertices of a 2D line string, complex."""
    return np.frombuffer(line.ExportToWkb(ogr.wkbNDR), dtype="<c16", offset=9)  # byte order, type, number of points


# --- lines -----------------------------------------------------------------------------------------------------


def directed(path: np.ndarray) -> np.ndarray:
    """A path in its standard direction: west to east, or a ring counter-clockwise from its westernmost vertex."""
    if path[0] != path[-1]:
        return path if (path[0].real, path[0].imag) < (path[-1].real, path[-1].imag) else path[::-1]
    ring = path[:-1]
    ring = np.roll(ring, -int(np.lexsort((ring.imag, ring.real))[0]))
    ring = np.append(ring, ring[0])
    return ring if _signed_area(ring) > 0 else ring[::-1]


def straightened(path: np.ndarray) -> np.ndarray:
    """A path without the vertices that lie within 1.5 px of it."""
    header = struct.pack("<BII", 1, ogr.wkbLineString, len(path))
    line = ogr.CreateGeometryFromWkb(header + path.astype("<c16").tobytes())
    return line_points(line.Simplify(STRAIGHTEN_PX))


def _signed_area(ring: np.ndarray) -> float:
    """Area of a closed ring, positive when it runs counter-clockwise."""
    ring = ring - ring[0]
    return float((ring[:-1].conj() * ring[1:]).imag.sum()) / 2


def line_pieces(paths: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """The pieces of all paths, (n, 2) start and end, and the number of the path each one is from, (n,)."""
    points = np.concatenate(paths)
    path = np.repeat(np.arange(len(paths)), [len(one) for one in paths])
    within = path[1:] == path[:-1]
    return np.column_stack([points[:-1], points[1:]])[within], path[1:][within]


def as_xy(points: np.ndarray) -> np.ndarray:
    """(n, 2) float64 of (n,) complex."""
    return np.column_stack([points.real, points.imag])
