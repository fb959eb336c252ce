"""Points that can't be what they are said to be get a sentence before anything is fitted to them."""
from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import ConvexHull, HalfspaceIntersection
from seam_inspector.plugin.imagery.errors import WARNING, SensorModelError
from seam_inspector.plugin.sensors.measure.adjustment import adjust, suspects
from seam_inspector.plugin.sensors.measure.points import (
    Points,
    check_against_rpc,
    check_inside,
    check_plausible,
    control_coverage,
)
from seam_inspector.plugin.sensors.measure.registry import POLYNOMIAL_2D

from tests.numbers.sensors import sensor_scenes

SIZE = (4000, 3000)


def points(count: int = 20) -> Points:
    """Points of an image of 0.5 m in UTM, near the ground."""
    image = np.random.default_rng(1).uniform([0, 0], SIZE, (count, 2))
    ground = np.column_stack([500_000 + image[:, 0] / 2, 4_000_000 - image[:, 1] / 2, 100 + image[:, 0] / 100])
    names = tuple(map(str, range(count)))
    return Points(names, image, ground, "EPSG:32633", np.full(count, np.nan), np.zeros(count, bool))


def test_ordinary_points_pass_with_and_without_heights_and_a_little_beyond_the_image() -> None:
    given = points()
    check_plausible(given)
    check_plausible(replace(given, ground=given.ground * [1, 1, np.nan]))
    assert not check_inside(replace(given, image=given.image + [0.04 * SIZE[0], 0]), SIZE, None)


@pytest.mark.parametrize(("changed", "complaint"), [
    ({"wkt": "EPSG:4326"}, "the points are in degrees"),
    ({"ground": points().ground * [1e-7, 1e-7, 1]}, "pixel measures"),
    ({"ground": points().ground * [1, 1, 3000]}, "are impossible on Earth"),
    ({"image": points().image * [1, -1]}, "rows are negative"),
    ({"image": points().image[:, ::-1]}, "columns and rows are swapped"),
    ({"image": points().image + [9000, 0]}, "20 points lie outside the image of 4000 x 3000 pixels"),
])  # fmt: skip
def test_what_can_t_be_is_said(changed: dict[str, object], complaint: str) -> None:
    given = replace(points(), **changed)  # type: ignore[arg-type]
    with pytest.raises(SensorModelError, match=complaint):
        check_plausible(given) or check_inside(given, SIZE, None)  # type: ignore[func-returns-value]


def test_points_beyond_a_part_of_the_image_are_believed_where_its_rpc_sees_them() -> None:
    """A crop of whose points two lie outside, where columns and rows read the other way would lie inside."""
    given = seen_points()
    size = (int(np.median(given.image[:, 0])), sensor_scenes.ROWS)
    for shift in (0, [900, -1300]):  # as of a part that was cut out without a care for its RPC
        (notice,) = check_inside(replace(given, image=given.image - shift), size, RPC)
        assert "where its RPC places them" in str(notice)
    image = given.image.copy()
    image[given.image[:, 0].argmax()] += [0, 2000]
    with pytest.raises(SensorModelError, match="outside the image"):
        check_inside(replace(given, image=image), size, RPC)


def seen_points(**changed: np.ndarray) -> Points:
    """Points on an RPC's own places, 7 columns and -4 rows off, as a vendor's is."""
    ground = sensor_scenes.places(25, 4)
    image = RPC.project(ground) + [7, -4]
    return replace(sensor_scenes.points(image, ground), **changed)


RPC = sensor_scenes.made_rational(3, 5, 0.001)


def test_points_that_an_rpc_sees_with_a_shift_and_a_blunder_pass() -> None:
    given = seen_points()
    assert not check_against_rpc(given, RPC)
    check_against_rpc(given.only(np.arange(25) < 1), RPC)
    image = given.image.copy()
    image[3] += [3000, -2000]
    check_against_rpc(seen_points(image=image), RPC)
    check_against_rpc(seen_points(ground=given.ground * [1, 1, np.nan]), RPC)
    turned = np.deg2rad(2)
    middle = given.image.mean(axis=0)
    spin = np.array([[np.cos(turned), np.sin(turned)], [-np.sin(turned), np.cos(turned)]])
    check_against_rpc(seen_points(image=(given.image - middle) @ spin + middle), RPC)


@pytest.mark.parametrize(("changed", "complaint"), [
    ({"ground": seen_points().ground[:, [1, 0, 2]]}, "px away from the image; check that x and y"),
    ({"ground": seen_points().ground + [5, 0, 0]}, "their reference system"),
    ({"image": seen_points().image[:, ::-1]}, "columns and rows are swapped"),
    ({"image": [0, sensor_scenes.ROWS] + seen_points().image * [1, -1]}, "mirrored or turned image"),
    ({"image": [sensor_scenes.COLUMNS, 0] + seen_points().image * [-1, 1]}, "mirrored or turned image"),
])  # fmt: skip
def test_what_the_image_s_own_rpc_rules_out_is_said(changed: dict[str, np.ndarray], complaint: str) -> None:
    with pytest.raises(SensorModelError, match=complaint):
        check_against_rpc(seen_points(**changed), RPC)


@pytest.mark.parametrize(("factors", "words"), [
    ([1, 1, 0], "25 points .* are -999 to -999 m high, and the image's RPC holds for 0 to 1200 m"),
    ([1, 1, 1.9], "they miss the RPC by .* px"),
])  # fmt: skip
def test_heights_that_an_rpc_is_not_made_for_are_said(factors: list[float], words: str) -> None:
    heights = seen_points().ground * factors - [0, 0, 999 if factors[2] == 0 else 0]
    (notice,) = check_against_rpc(seen_points(ground=heights), RPC)
    assert re.search(words, str(notice))
    assert notice.level == WARNING


def test_heights_in_feet_are_found_by_what_the_rpc_misses() -> None:
    given = seen_points()
    with pytest.raises(SensorModelError, match=r"heights are in feet: as metres .* px, as feet by"):
        check_against_rpc(replace(given, ground=given.ground / [1, 1, 0.3048]), RPC)
    ground = given.ground[:5] * [1, 1, 0] + [[0, 0, height] for height in (200, 205, 210, 300, 480)]
    few = sensor_scenes.points(RPC.project(ground) + [7, -4], ground / [1, 1, 0.3048])  # most of them in the valley
    with pytest.raises(SensorModelError, match="heights are in feet"):
        check_against_rpc(few, RPC)


def test_heights_in_feet_on_flat_ground_are_told_as_they_look_like_a_shift() -> None:
    ground = sensor_scenes.MIDDLE + (sensor_scenes.places(25, 4) - sensor_scenes.MIDDLE) * [0.001, 0.001, 0]
    image = RPC.project(ground) + [7, -4]
    assert not check_against_rpc(seen_points(image=image, ground=ground), RPC)
    notice, *_ = check_against_rpc(seen_points(image=image, ground=ground / [1, 1, 0.3048]), RPC)
    assert "heights are in feet" in str(notice)
    assert notice.level == WARNING


def test_interchanged_points_are_told_on_a_small_part_of_a_scene() -> None:
    """All of them inside it, and 500 px of a scene of 40,000."""
    ground = sensor_scenes.places(25, 4)
    ground[:, :2] = sensor_scenes.MIDDLE[:2] + (ground[:, :2] - sensor_scenes.MIDDLE[:2]) / 80
    image = RPC.project(ground) + [7, -4]
    corner = image.min(axis=0)
    assert not check_against_rpc(sensor_scenes.points(image, ground), RPC)
    with pytest.raises(SensorModelError, match="columns and rows are swapped"):
        check_against_rpc(sensor_scenes.points((image - corner)[:, ::-1] + corner, ground), RPC)


@given(st.lists(st.tuples(st.floats(-3, 7), st.floats(-3, 7)), min_size=3, max_size=12, unique=True))
def test_what_is_extrapolated_is_what_of_the_image_the_outline_leaves(corners: list[tuple[float, float]]) -> None:
    """Scipy's hulls and intersections of half-planes tell what is expected."""
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
