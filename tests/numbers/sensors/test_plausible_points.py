"""Points that can't be what they are said to be get a sentence before anything is fitted to them."""
from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import ConvexHull, HalfspaceIntersection
from seam_inspector.plugin.imagery.errors import SensorModelError
from seam_inspector.plugin.sensors.measure.adjustment import adjust, suspects
from seam_inspector.plugin.sensors.measure.control_coverage import control_coverage
from seam_inspector.plugin.sensors.measure.models.registry import POLYNOMIAL_2D
from seam_inspector.plugin.sensors.measure.plausible_points import check_plausible
from seam_inspector.plugin.sensors.measure.points import Points

SIZE = (4000, 3000)


def points(count: int = 20) -> Points:
    """Of an image of 0.5 m in UTM, near the ground."""
    image = np.random.default_rng(1).uniform([0, 0], SIZE, (count, 2))
    ground = np.column_stack([500_000 + image[:, 0] / 2, 4_000_000 - image[:, 1] / 2, 100 + image[:, 0] / 100])
    names = tuple(map(str, range(count)))
    return Points(names, image, ground, "EPSG:32633", np.full(count, np.nan), np.zeros(count, bool))


def test_ordinary_points_pass_with_and_without_heights_and_a_little_beyond_the_image() -> None:
    given = points()
    check_plausible(given, SIZE)
    check_plausible(replace(given, ground=given.ground * [1, 1, np.nan]), None)
    check_plausible(replace(given, image=given.image + [0.04 * SIZE[0], 0]), SIZE)


@pytest.mark.parametrize(("changed", "complaint"), [
    ({"wkt": "EPSG:4326"}, "said to be in degrees"),
    ({"ground": points().ground * [1e-7, 1e-7, 1]}, "pixel measures"),
    ({"ground": points().ground * [1, 1, 3000]}, "as no place on earth is"),
    ({"image": points().image * [1, -1]}, "rows are negative"),
    ({"image": points().image[:, ::-1]}, "columns and rows interchanged"),
    ({"image": points().image + [9000, 0]}, "20 points lie outside the image of 4000 x 3000 pixels"),
])  # fmt: skip
def test_what_can_t_be_is_said(changed: dict[str, object], complaint: str) -> None:
    with pytest.raises(SensorModelError, match=complaint):
        check_plausible(replace(points(), **changed), SIZE)  # type: ignore[arg-type]


def test_a_single_point_outside_is_named() -> None:
    image = points().image.copy()
    image[7] = 4500, 10
    with pytest.raises(SensorModelError, match=r"1 points lie outside .* \(7\)"):
        check_plausible(replace(points(), image=image), SIZE)


@given(st.lists(st.tuples(st.floats(-3, 7), st.floats(-3, 7)), min_size=3, max_size=12, unique=True))
def test_what_is_extrapolated_is_what_of_the_image_the_outline_leaves(corners: list[tuple[float, float]]) -> None:
    """By scipy's hulls and intersections of half-planes."""
    control = np.round(np.array(corners), 3)
    if np.linalg.matrix_rank(control - control.mean(axis=0), tol=0.05) < 2:
        return
    hull = ConvexHull(control, qhull_options="QJ")
    planes = np.vstack([hull.equations, [[-1, 0, 0], [0, -1, 0], [1, 0, -4], [0, 1, -4]]])
    grid = np.stack(np.meshgrid(np.linspace(0, 4, 81), np.linspace(0, 4, 81)), axis=-1).reshape(-1, 2)
    depth = (grid @ planes[:, :2].T + planes[:, 2]).max(axis=1)
    if depth.min() > -0.02:
        return  # they hardly meet
    inner = HalfspaceIntersection(planes, grid[depth.argmin()])
    expected = 1 - ConvexHull(inner.intersections).volume / 16
    assert control_coverage(control, (0, 0, 4, 4)).extrapolated == pytest.approx(expected, abs=2e-3)


def test_two_blunders_are_doubted_where_nobody_looks_for_them() -> None:
    image = points(30).image + np.random.default_rng(2).normal(0, 0.3, (30, 2))
    request = POLYNOMIAL_2D.request("1")
    assert not suspects(adjust(request, replace(points(30), image=image))).any()
    image[[4, 11]] += [[25, 0], [0, -30]]
    assert set(np.flatnonzero(suspects(adjust(request, replace(points(30), image=image))))) == {4, 11}
