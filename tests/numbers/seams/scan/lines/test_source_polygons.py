"""Polygons of what each part of a mosaic follows: no gaps, no overlaps, borders that are the seams."""
from __future__ import annotations

import numpy as np
import pytest
from osgeo import ogr
from scipy import ndimage
from seam_inspector.plugin.imagery.grids import Grid
from seam_inspector.plugin.seams.measure.seamlines.seam_pieces import SidedSeam
from seam_inspector.plugin.seams.measure.seamlines.seam_tracing import polygons_of, seams_of, trace_borders

from tests.numbers.seams.scan.lines.labelled import LABEL_PX, edges_of, estimated

SIDE = 200


def grid_of(labels: np.ndarray) -> Grid:
    rows, columns = labels.shape
    return Grid(576000.0, 5188000.0, 0.5, 0.5, columns * LABEL_PX, rows * LABEL_PX)


def borders_of(labels: np.ndarray, side: int = 64) -> list[SidedSeam]:
    edges = edges_of(labels.astype(np.int16), side)
    return trace_borders(edges, grid_of(labels), labels.shape[1], LABEL_PX)


def polygons(labels: np.ndarray) -> dict[int, ogr.Geometry]:
    outlines = polygons_of(borders_of(labels))
    return {outline.source: ogr.CreateGeometryFromWkb(outline.wkb) for outline in outlines}


def points(geometry: ogr.Geometry) -> list[tuple[float, ...]]:
    """All vertices, however deep."""
    deeper = [point for i in range(geometry.GetGeometryCount()) for point in points(geometry.GetGeometryRef(i))]
    return deeper or [point[:2] for point in geometry.GetPoints()]


def quarters() -> np.ndarray:
    """Four sources, an island of a fifth that holds one of the first, and a hole."""
    labels = np.repeat(np.repeat(np.array([[0, 1], [2, 3]]), 100, 0), 100, 1)
    row, column = np.mgrid[:SIDE, :SIDE]
    away = np.hypot(row - 50, column - 50)
    labels[away < 30] = 4
    labels[away < 15] = 1
    labels[130:160, 130:170] = -1
    return labels.astype(np.int16)


def patches(seed: int) -> np.ndarray:
    """Squares of 24 px of six sources or none, at random: junctions everywhere."""
    squares = np.random.default_rng(seed).integers(-1, 6, (30, 30))
    return np.asarray(ndimage.zoom(squares, 6, order=0), dtype=np.int16)


def test_a_hole_is_in_the_part_around_it() -> None:
    """The hole stands within an angular one of the same source that is open to the left: a ray to the right meets that
    one twice."""
    labels = np.zeros((120, 160), np.int16)
    labels[10:110, 20:140] = 1
    labels[18:102, 20:132] = 0
    labels[26:94, 30:120] = 1
    labels[50:70, 60:80] = 2
    geometry = polygons(labels)[1]
    assert geometry.IsValid()
    assert geometry.Area() == pytest.approx((labels == 1).sum() * (0.5 * LABEL_PX) ** 2, rel=0.02)
    assert sorted(geometry.GetGeometryRef(i).GetGeometryCount() for i in range(2)) == [1, 2]


@pytest.mark.parametrize("labels", [quarters(), estimated(quarters(), 1), patches(1), patches(2)])
def test_polygons_part_the_mosaic_without_gaps_and_overlaps(labels: np.ndarray) -> None:
    shapes = polygons(labels)
    together = ogr.Geometry(ogr.wkbMultiPolygon)
    for geometry in shapes.values():
        assert geometry.IsValid()
        for i in range(geometry.GetGeometryCount()):
            together.AddGeometry(geometry.GetGeometryRef(i))
    whole = together.UnionCascaded()
    total = sum(geometry.GetArea() for geometry in shapes.values())
    assert whole.GetArea() == pytest.approx(total, rel=1e-9)  # no overlap
    parts = [whole.GetGeometryRef(i) for i in range(whole.GetGeometryCount())]
    parts = parts if whole.GetGeometryType() == ogr.wkbMultiPolygon else [whole]
    empty = [part.GetGeometryRef(i).Area() for part in parts for i in range(1, part.GetGeometryCount())]
    # A gap between neighbours would be a hole more: what has no labels is larger than the islands that are filled.
    assert all(area >= 600 * 0.5**2 * 0.5 for area in empty)
    assert len(empty) <= ndimage.label(np.pad(labels < 0, 1, constant_values=True))[1] - 1


def test_areas_islands_and_holes_are_those_of_the_labels() -> None:
    labels = quarters()
    shapes = polygons(labels)
    assert sorted(shapes) == [0, 1, 2, 3, 4]
    for source, geometry in shapes.items():
        assert geometry.GetArea() == pytest.approx((labels == source).sum() * 4, rel=0.03)
        assert geometry.GetGeometryName() == "MULTIPOLYGON"
    assert shapes[1].GetGeometryCount() == 2  # its quarter and what it has inside the island
    assert [shapes[4].GetGeometryRef(0).GetGeometryCount(), shapes[0].GetGeometryRef(0).GetGeometryCount()] == [2, 2]
    assert shapes[3].GetGeometryRef(0).GetGeometryCount() == 2


def test_borders_are_the_seams() -> None:
    labels = estimated(quarters(), 3)
    borders = borders_of(labels)
    seams = seams_of(borders_of(labels, 512))
    assert [seam.vertices.tolist() for seam in seams_of(borders)] == [seam.vertices.tolist() for seam in seams]
    corners = {outline.source: set(points(ogr.CreateGeometryFromWkb(outline.wkb))) for outline in polygons_of(borders)}
    for seam in seams:
        for side in (seam.left, seam.right):
            assert {tuple(vertex) for vertex in seam.vertices.tolist()} <= corners[side]
