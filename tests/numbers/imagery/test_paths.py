"""Paths by how far along them."""
from __future__ import annotations

import numpy as np
from osgeo import ogr
from seam_inspector.plugin.imagery.lines import points_at, vertex_stations

PATH = np.array([[0.0, 0.0], [3.0, 4.0], [3.0, 4.0], [3.0, 10.0], [-1.0, 7.0]])


def test_vertices_lie_where_the_length_up_to_them_says() -> None:
    np.testing.assert_allclose(vertex_stations(PATH), [0, 5, 5, 11, 16])


def test_points_are_those_that_ogr_finds() -> None:
    line = ogr.Geometry(ogr.wkbLineString)
    for x, y in PATH.tolist():
        line.AddPoint_2D(x, y)
    wanted = np.linspace(0, 16, 33)
    expected = [line.Value(station).GetPoint_2D() for station in wanted.tolist()]
    np.testing.assert_allclose(points_at(PATH, vertex_stations(PATH), wanted), expected, atol=1e-12)
