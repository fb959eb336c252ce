"""The model that is recommended for given errors, and what it is judged on."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.sensors.measure import registry
from seam_inspector.plugin.sensors.measure.adjustment import (
    CHECK_POINTS,
    LEAVE_ONE_OUT,
    Accuracy,
    JudgedModel,
    all_requests,
    compare,
    recommend,
)
from seam_inspector.plugin.sensors.measure.registry import ModelRequest

from tests.numbers.sensors.sensor_scenes import COLUMNS, ROWS, made_rational, places, points

PUSHBROOM = registry.PUSHBROOM.request()
QUOTIENTS = [registry.RATIONAL.request(order) for order in "123"]
SPACE, PLANE = registry.POLYNOMIAL_3D.request("2"), registry.POLYNOMIAL_2D.request("2")
VENDORS = registry.RPC_BIAS.request("shift", rpc=made_rational(1, 2))


MISSES = np.abs(np.random.default_rng(6).normal(1, 0.3, 20))  # of points that no fit has seen, m


def judged(request: ModelRequest, misses: np.ndarray, unknowns: float) -> JudgedModel:
    each = float(np.sqrt(np.mean(misses**2) / 2))
    return JudgedModel(request, Accuracy(20, *[each] * 6), None, 20, 10.0, None, misses, unknowns)


@pytest.mark.parametrize(("rows", "flat", "chosen"), [
    ([(PUSHBROOM, MISSES, 20), (VENDORS, MISSES, 2)], False, VENDORS),
    ([(PUSHBROOM, 1.3 * MISSES, 2), (VENDORS, MISSES, 20)], False, VENDORS),  # surely worse at every point
    ([(QUOTIENTS[1], MISSES, 38), (QUOTIENTS[0], MISSES[::-1], 14)], False, QUOTIENTS[0]),
    ([(SPACE, MISSES, 20), (PUSHBROOM, MISSES, 20)], False, PUSHBROOM),  # the paper's preference
    ([(PLANE, MISSES, 6), (SPACE, 3 * MISSES, 8)], False, SPACE),
    ([(PLANE, MISSES, 6), (SPACE, 3 * MISSES, 8)], True, PLANE),
])  # fmt: skip
def test_of_models_about_as_good_the_one_of_fewest_unknowns_is_taken(
    rows: list[tuple[ModelRequest, np.ndarray, float]], flat: bool, chosen: ModelRequest
) -> None:
    recommended, _ = recommend([judged(*row) for row in rows], flat)
    assert recommended.request == chosen


@pytest.mark.release
@pytest.mark.parametrize(("turned", "truth"), [(0.0, "rpc_bias shift"), (6.0, "rpc_bias affine")])
def test_what_the_vendors_rpc_lacks_is_added_and_no_more(turned: float, truth: str) -> None:
    """Points of half a pixel on an RPC that is shifted, and on one that is turned as well."""
    chosen = []
    for seed in range(5):
        ground, rpc = places(40, seed), made_rational(3, seed, 0.002)
        seen = rpc.project(ground)
        image = seen + [12, -7] + (seen / [COLUMNS, ROWS] - 0.5) * turned
        image += np.random.default_rng(seed).normal(0, 0.5, image.shape)
        requests = all_requests(rpc, 694e3, (COLUMNS, ROWS))
        result = compare(points(image, ground, np.arange(40) >= 20), requests, robust=False, flat=False)
        chosen.append(result.recommended.request.name)
    assert chosen.count(truth) >= 4


@pytest.mark.parametrize(("checks", "method"), [(5, CHECK_POINTS), (4, LEAVE_ONE_OUT)])
def test_five_check_points_are_judged_on_and_with_fewer_each_point_in_turn(checks: int, method: str) -> None:
    ground = places(30, 2)
    given = points(made_rational(1, 3, 0).project(ground), ground, np.arange(30) < checks)
    result = compare(given, [SPACE], robust=False, flat=False)
    assert result.method == method
    assert result.rows[0].errors.count == (5 if method == CHECK_POINTS else 30)
