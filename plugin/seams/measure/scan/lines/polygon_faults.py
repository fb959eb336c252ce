"""Where polygons that ought to part a mosaic overlap or leave gaps between them."""
from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from osgeo import ogr

from .....imagery.errors import Message
from .....imagery.gdal_calls import gdal_silenced
from .....imagery.grids import Grid
from .. import messages

WIDTH_PX = 1.0  # on the mean: what is narrower is how borders drawn twice differ, and is bridged
_NAMED = 3  # overlaps that are told by name


def polygon_faults(polygons: Sequence[tuple[str, ogr.Geometry]], grid: Grid) -> list[Message]:
    """One notice of overlaps and one of gaps, where there are any.

    ``polygons``: what each is called (empty: nothing), and valid polygons or multipolygons in map units. Gaps are
    holes in what all cover together, inside the mosaic.
    """
    if not polygons:
        return []
    square_metres = grid.metres_x * grid.metres_y
    narrow = WIDTH_PX * grid.pixel_width
    notices = []
    with gdal_silenced():
        overlaps = []
        for one, other in _pairs_that_meet([geometry for _, geometry in polygons]):
            shared = polygons[one][1].Intersection(polygons[other][1])
            area = sum(part.GetArea() for part in _wide_parts(shared, narrow))
            if area:
                overlaps.append((area * square_metres, polygons[one][0], polygons[other][0]))
        if overlaps:
            overlaps.sort(key=lambda found: -found[0])
            named = [f"{one} / {other}" for _, one, other in overlaps if one and other][:_NAMED]
            total = sum(area for area, _, _ in overlaps)
            notices.append(
                messages.SEAM_POLYGONS_OVERLAP_NAMED(count=len(overlaps), area=total, names=", ".join(named))
                if named
                else messages.SEAM_POLYGONS_OVERLAP(count=len(overlaps), area=total)
            )
        gaps = [gap.GetArea() * square_metres for gap in _gaps([one for _, one in polygons], grid, narrow)]
    if gaps:
        notices.append(messages.SEAM_POLYGONS_GAPE(count=len(gaps), area=sum(gaps)))
    return notices


def _gaps(geometries: Sequence[ogr.Geometry], grid: Grid, narrow: float) -> Iterator[ogr.Geometry]:
    """Holes in what polygons cover together."""
    together = ogr.Geometry(ogr.wkbMultiPolygon)
    for geometry in geometries:
        for part in _polygons(geometry):
            together.AddGeometry(part)
    # Slits that are bridged are closed first: they are no gaps, and one that leads outside would hide a gap.
    whole = together.UnionCascaded().Buffer(narrow / 2, 1)
    xmin, ymin, xmax, ymax = grid.extent
    for part in _polygons(whole):
        for index in range(1, part.GetGeometryCount()):
            hole = ogr.Geometry(ogr.wkbPolygon)
            hole.AddGeometry(part.GetGeometryRef(index))
            left, right, bottom, top = hole.GetEnvelope()
            if left < xmax and right > xmin and bottom < ymax and top > ymin:
                yield hole


def _wide_parts(geometry: ogr.Geometry | None, narrow: float) -> Iterator[ogr.Geometry]:
    """Polygons whose mean width is more than that."""
    if geometry is None:
        return
    for part in _polygons(geometry):
        if 2 * part.GetArea() > narrow * part.Boundary().Length():
            yield part


def _polygons(geometry: ogr.Geometry) -> Iterator[ogr.Geometry]:
    """The polygons in a geometry."""
    if geometry.GetGeometryType() == ogr.wkbPolygon:
        yield geometry
    else:
        for index in range(geometry.GetGeometryCount()):
            yield from _polygons(geometry.GetGeometryRef(index))


def _pairs_that_meet(geometries: Sequence[ogr.Geometry]) -> Iterator[tuple[int, int]]:
    """Pairs whose bounding boxes overlap: from west to east, each with those that begin before it ends."""
    boxes = np.array([geometry.GetEnvelope() for geometry in geometries])
    order = np.argsort(boxes[:, 0], kind="stable")
    boxes = boxes[order]
    last = np.searchsorted(boxes[:, 0], boxes[:, 1], side="left")
    for place, stop in enumerate(last.tolist()):
        following = np.arange(place + 1, stop)
        meets = (boxes[following, 2] < boxes[place, 3]) & (boxes[following, 3] > boxes[place, 2])
        for other in following[meets].tolist():
            yield int(order[place]), int(order[other])
