"""The nearest point of a seam, against OGR's distances."""
from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from osgeo import ogr
from seam_inspector.plugin.imagery.lines import Seam
from seam_inspector.plugin.seams.measure.planning.window_placing import SeamIndex

from tests.work import calls_of

EAST, NORTH = 500_000.0, 5_000_000.0

places = st.tuples(st.integers(-200, 200), st.integers(-200, 200))
lines = st.lists(places, min_size=2, max_size=6).filter(lambda line: len(set(line)) > 1)


def seam(*vertices: tuple[float, float]) -> Seam:
    """A seam through these places, with the large coordinates that maps have."""
    return Seam(1, np.array(vertices, dtype=float) + (EAST, NORTH))


def drawn(*vertices: tuple[float, float]) -> ogr.Geometry:
    line = ogr.Geometry(ogr.wkbLineString)
    for x, y in vertices:
        line.AddPoint_2D(EAST + x, NORTH + y)
    return line


def point(x: float, y: float) -> ogr.Geometry:
    made = ogr.Geometry(ogr.wkbPoint)
    made.AddPoint_2D(x, y)
    return made


@given(st.lists(lines, min_size=1, max_size=4), places)
def test_distance_is_that_of_ogr(several: list[list[tuple[int, int]]], place: tuple[int, int]) -> None:
    x, y = EAST + place[0], NORTH + place[1]
    expected = min(drawn(*line).Distance(point(x, y)) for line in several)
    index = SeamIndex([seam(*line) for line in several])
    nearest = index.nearest(x, y, expected + 1e-6)
    assert nearest is not None
    assert math.dist(nearest, (x, y)) == pytest.approx(expected, abs=1e-7)
    assert min(drawn(*line).Distance(point(*nearest)) for line in several) == pytest.approx(0, abs=1e-7)
    if expected > 1e-3:
        assert index.nearest(x, y, expected - 1e-6) is None


def test_a_hundred_thousand_pieces_do_not_hold_up_the_mouse() -> None:
    angle = np.linspace(0, 60, 100_000)
    spiral = np.column_stack([EAST + angle * np.cos(angle), NORTH + angle * np.sin(angle)])
    index = SeamIndex([Seam(1, spiral)])
    assert index.nearest(EAST + 20, NORTH + 20, 10.0) is not None
    assert calls_of(lambda: index.nearest(EAST + 20, NORTH + 20, 10.0)) < 200  # of numpy, for all pieces together
