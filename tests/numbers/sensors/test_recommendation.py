"""Which model is recommended for given errors (the paper's conclusions), and what it is judged on."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.sensors.measure import registry
from seam_inspector.plugin.sensors.measure.adjustment import (
    CHECK_POINTS,
    LEAVE_ONE_OUT,
    Accuracy,
    JudgedModel,
    compare,
    recommend,
)
from seam_inspector.plugin.sensors.measure.registry import ModelRequest

from tests.numbers.sensors.sensor_scenes import made_rational, places, points

PUSHBROOM, DLT = registry.PUSHBROOM.request(), registry.DLT.request()
QUOTIENTS = [registry.RATIONAL.request(order) for order in "123"]
SPACE, PLANE = registry.POLYNOMIAL_3D.request("2"), registry.POLYNOMIAL_2D.request("2")
VENDORS = registry.RPC_BIAS.request("shift", rpc=made_rational(1, 2))


@pytest.mark.parametrize(
    ("errors", "flat", "chosen"),
    [
        ([(PUSHBROOM, 1.24), (VENDORS, 1.0)], False, PUSHBROOM),  # at most a quarter worse than the best
        ([(PUSHBROOM, 1.26), (VENDORS, 1.0)], False, VENDORS),
        ([(QUOTIENTS[0], 1.0), (VENDORS, 1.2)], False, VENDORS),
        ([(QUOTIENTS[2], 1.0), (QUOTIENTS[1], 1.1), (QUOTIENTS[0], 1.2)], False, QUOTIENTS[0]),
        ([(QUOTIENTS[0], 1.0), (DLT, 1.0)], False, DLT),  # of one order, the one with fewer unknowns
        ([(SPACE, 1.0), (QUOTIENTS[2], 1.1)], False, QUOTIENTS[2]),
        ([(PLANE, 1.0), (SPACE, 3.0)], False, SPACE),
        ([(PLANE, 1.0), (SPACE, 3.0)], True, PLANE),
    ],
)
def test_of_models_about_as_good_the_papers_preference_is_taken(
    errors: list[tuple[ModelRequest, float]], flat: bool, chosen: ModelRequest
) -> None:
    rows = [JudgedModel(one, Accuracy(20, 0.6 * e, 0.8 * e, e, e, e, e), None, 20, 10.0) for one, e in errors]
    found, _ = recommend(rows, flat)
    assert found is not None
    assert found.request == chosen


@pytest.mark.parametrize(("checks", "method"), [(5, CHECK_POINTS), (4, LEAVE_ONE_OUT)])
def test_five_check_points_are_judged_on_and_with_fewer_each_point_in_turn(checks: int, method: str) -> None:
    ground = places(30, 2)
    given = points(made_rational(1, 3, 0).project(ground), ground, np.arange(30) < checks)
    result = compare(given, [SPACE], robust=False, flat=False)
    assert result.method == method
    assert result.rows[0].errors is not None
    assert result.rows[0].errors.count == (5 if method == CHECK_POINTS else 30)


def test_of_a_model_that_could_not_be_fitted_the_points_that_it_was_given_are_told() -> None:
    ground = places(16, 2)
    given = points(made_rational(1, 3, 0).project(ground), ground, np.arange(16) < 6)
    (row,) = compare(given, [registry.RATIONAL.request("3")], robust=False, flat=False).rows
    assert row.errors is None
    assert row.control_count == 10
