"""Polygons of what each part of a mosaic follows, with the same borders as its seams."""
from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from osgeo import ogr

from .....imagery.gdal_calls import gdal_silenced
from .label_cleaning import NONE
from .seam_tracing import SourceBorder


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


def _multipolygon(rings: list[np.ndarray]) -> bytes:
    """Rings with the inside on their left: those that run counter-clockwise are outlines, the others holes."""
    areas = [_signed_area(ring) for ring in rings]
    outlines = sorted((i for i, area in enumerate(areas) if area > 0), key=lambda i: areas[i])
    holes: defaultdict[int, list[int]] = defaultdict(list)
    boxes = {i: (*rings[i].min(axis=0), *rings[i].max(axis=0)) for i in outlines}
    for hole in (i for i, area in enumerate(areas) if area < 0):
        # On its middle, since a hole may touch the outline in a vertex.
        x, y = (rings[hole][0] + rings[hole][1]) / 2
        for outline in outlines:  # the smallest one that holds it
            left, bottom, right, top = boxes[outline]
            if left <= x <= right and bottom <= y <= top and _holds(rings[outline], x, y):
                holes[outline].append(hole)
                break
    whole = ogr.Geometry(ogr.wkbMultiPolygon)
    for outline in outlines[::-1]:
        polygon = ogr.Geometry(ogr.wkbPolygon)
        for ring in (rings[outline], *(rings[hole] for hole in holes[outline])):
            polygon.AddGeometry(_ring(ring))
        for part in _valid_parts(polygon):
            whole.AddGeometry(part)
    return bytes(whole.ExportToWkb(ogr.wkbNDR))


def _valid_parts(polygon: ogr.Geometry) -> list[ogr.Geometry]:
    """The polygon, or the polygons that remain where smoothing made its borders cross."""
    with gdal_silenced():
        valid = polygon if polygon.IsValid() else polygon.MakeValid()
    if valid.GetGeometryType() == ogr.wkbPolygon:
        return [valid]
    parts = (valid.GetGeometryRef(i) for i in range(valid.GetGeometryCount()))
    return [part.Clone() for part in parts if part.GetGeometryType() == ogr.wkbPolygon]


def _ring(vertices: np.ndarray) -> ogr.Geometry:
    ring = ogr.Geometry(ogr.wkbLinearRing)
    for x, y in vertices.tolist():
        ring.AddPoint_2D(x, y)
    return ring


def _signed_area(ring: np.ndarray) -> float:
    """Positive when it runs counter-clockwise."""
    x, y = (ring - ring[0]).T
    return float((x[:-1] * y[1:] - x[1:] * y[:-1]).sum()) / 2


def _holds(ring: np.ndarray, x: float, y: float) -> bool:
    """Whether a point lies inside, by how often a ray from it to the right meets the ring."""
    (x0, y0), (x1, y1) = ring[:-1].T, ring[1:].T
    crossed = (y0 > y) != (y1 > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        at = x0 + (y - y0) * (x1 - x0) / (y1 - y0)
    return bool(np.count_nonzero(crossed & (at > x)) % 2)
