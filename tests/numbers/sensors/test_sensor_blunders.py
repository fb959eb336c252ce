"""Blunders, how points lie, and the comparison of models with its recommendation."""
from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy import stats
from seam_inspector.plugin.imagery.errors import SensorModelError
from seam_inspector.plugin.sensors.measure import registry
from seam_inspector.plugin.sensors.measure.adjustment import (
    CHECK_POINTS,
    LEAVE_ONE_OUT,
    Accuracy,
    JudgedModel,
    adjust,
    all_requests,
    compare,
    recommend,
)
from seam_inspector.plugin.sensors.measure.heights import is_flat
from seam_inspector.plugin.sensors.measure.points import choose_check_points, control_coverage
from seam_inspector.plugin.sensors.measure.pushbroom import geocentric, unit
from seam_inspector.plugin.sensors.measure.registry import ModelRequest

from tests.numbers.sensors.sensor_scenes import COLUMNS, MIDDLE, ROWS, made_pushbroom, made_rational, places, points

SIGMA = 0.4


@pytest.mark.parametrize(("asked", "count"), [
    (registry.POLYNOMIAL_3D.request("1"), 40), (registry.RATIONAL.request("1"), 60), (registry.DLT.request(), 60),
    (registry.RPC_BIAS.request("affine", rpc=made_rational(1, 7, 0.002)), 30),
])  # fmt: skip
@pytest.mark.parametrize("seed", range(3))
def test_thirty_per_cent_blunders_of_five_sigma_are_found(asked: ModelRequest, count: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    ground = places(count, seed)
    truth = made_rational(1, 7, 0.0 if asked.kind == registry.POLYNOMIAL_3D else 0.002)
    if asked.kind == registry.DLT:
        truth = replace(truth, denominators=np.repeat(truth.denominators[:, :1], 2, axis=1))
    image = truth.project(ground) + random.normal(0, SIGMA, (count, 2))
    wrong = np.arange(count) < round(0.3 * count)
    image[wrong] += 5 * SIGMA * random.choice([-1, 1], (count, 2))[wrong]
    done = adjust(asked, points(image, ground), robust=True)
    assert done.blunder[wrong].mean() >= 0.85
    assert done.blunder[~wrong].mean() <= 0.1
    image[wrong] += 50 * SIGMA  # gross ones, all of them to one side
    done = adjust(asked, points(image, ground), robust=True)
    assert done.blunder[wrong].all()
    assert done.blunder[~wrong].mean() <= 0.1
    assert np.abs(done.residuals_px[~wrong]).max() < 5 * SIGMA
    assert done.control.count == count - done.blunder.sum()


def test_a_good_set_loses_hardly_a_point_and_exact_points_none() -> None:
    ground, random = places(80, 1), np.random.default_rng(1)
    exact = made_rational(1, 2).project(ground)
    assert not adjust(registry.RATIONAL.request(), points(exact, ground), robust=True).blunder.any()
    noisy = exact + random.normal(0, SIGMA, exact.shape)
    assert adjust(registry.RATIONAL.request(), points(noisy, ground), robust=True).blunder.sum() <= 3


def test_a_blunder_among_the_check_points_is_flagged_and_not_counted() -> None:
    ground, random = places(60, 1), np.random.default_rng(1)
    image = made_rational(1, 2).project(ground) + random.normal(0, SIGMA, (60, 2))
    image[50, 0] += 30
    done = adjust(registry.RATIONAL.request(), points(image, ground, np.arange(60) >= 30), robust=True)
    assert np.flatnonzero(done.blunder).tolist() == [50]
    assert done.check.count == 29
    plain = adjust(registry.RATIONAL.request(), points(image, ground, np.arange(60) >= 30))
    assert plain.check.count == 30
    assert plain.check.max_x > 5 * done.check.max_x


@pytest.mark.parametrize(("sigmas", "flagged"), [(4.5, False), (5.5, True)])
def test_a_check_point_is_a_blunder_beyond_five_standard_deviations_of_the_check_points(
    sigmas: float, flagged: bool
) -> None:
    ground = places(100, 1)
    image = made_rational(1, 2).project(ground)  # the control points fit exactly, so they say nothing of the others
    check = np.arange(100) >= 20
    normal = SIGMA * stats.norm.ppf((np.arange(80) + 0.5) / 80)  # quantiles: the standard deviation is no estimate
    random = np.random.default_rng(1)
    image[check] += np.column_stack([random.permutation(normal), random.permutation(normal)])
    image[50, 0] += sigmas * SIGMA - (image[50, 0] - made_rational(1, 2).project(ground)[50, 0])
    done = adjust(registry.RATIONAL.request(), points(image, ground, check), robust=True)
    assert np.flatnonzero(done.blunder).tolist() == ([50] if flagged else [])


@pytest.mark.slow
def test_the_pushbroom_finds_a_blunder_in_a_dozen_points() -> None:
    ground = places(14, 4)
    image = made_pushbroom(1).project(ground) + np.random.default_rng(4).normal(0, SIGMA, (14, 2))
    image[3] += [8.0, -6.0]
    done = adjust(registry.PUSHBROOM.request(size=(COLUMNS, ROWS)), points(image, ground), robust=True)
    assert done.blunder[3]
    assert done.blunder.sum() <= 3


def test_sigma_is_that_of_the_measurements_whatever_the_redundancy() -> None:
    for count, sets in ((400, 1), (10, 60)):  # 800 coordinates less 14 unknowns, and 20 less 14
        squares = []
        for seed in range(sets):
            ground = places(count, seed)
            image = made_rational(1, 2).project(ground)
            image += np.random.default_rng(seed).normal(0, SIGMA, (count, 2))
            squares.append(adjust(registry.RATIONAL.request(), points(image, ground)).sigma_px ** 2)
        assert np.sqrt(np.mean(squares)) == pytest.approx(SIGMA, rel=0.15)


@pytest.mark.parametrize(("asked", "unknowns", "fewest"), [
    *((registry.POLYNOMIAL_2D.request(str(order)), 2 * few, few) for order, few in ((1, 3), (2, 6), (3, 10))),
    *((registry.POLYNOMIAL_3D.request(str(order)), 2 * few, few) for order, few in ((1, 4), (2, 10), (3, 20))),
    *((registry.RATIONAL.request(str(order)), 2 * few, few) for order, few in ((1, 7), (2, 19), (3, 39))),
    (registry.DLT.request(), 11, 6), (registry.DLT.request("xy"), 12, 6), (registry.PUSHBROOM.request(), None, 4),
    *((registry.RPC_BIAS.request(form, rpc=made_rational(1, 2)), unknowns, fewest)
      for form, unknowns, fewest in (("shift", 2, 1), ("shift_drift", 3, 2), ("affine", 6, 3))),
])  # fmt: skip
def test_the_fewest_points_fit_and_one_less_is_refused_with_the_number(
    asked: ModelRequest, unknowns: int | None, fewest: int
) -> None:
    ground = places(fewest, 11)
    image = made_rational(1, 2, 0.001).project(ground)
    assert unknowns is None or asked.variant.unknowns == unknowns
    done = adjust(asked, points(image, ground))
    assert done.control.count == fewest
    with pytest.raises(SensorModelError, match=rf"There are {fewest - 1} control points .* at least {fewest};"):
        adjust(asked, points(image[1:], ground[1:]))


def test_points_on_a_line_or_a_plane_are_refused() -> None:
    ground = places(30, 1)
    along = np.linspace(-0.1, 0.1, 30)
    line = np.column_stack([MIDDLE[0] + along, MIDDLE[1] + along, ground[:, 2]])
    flat = np.column_stack([ground[:, :2], np.full(30, 700.0)])
    slope = np.column_stack([ground[:, :2], 700 + 1000 * (ground[:, 0] - MIDDLE[0])])
    for wrong, words in ((line, "on one line"), (flat, "on one plane"), (slope, "on one plane")):
        image = made_rational(1, 2).project(wrong)
        for kind in (registry.RATIONAL, registry.POLYNOMIAL_3D, registry.DLT, registry.PUSHBROOM):
            asked = kind.request()
            with pytest.raises(SensorModelError, match=words):
                adjust(asked, points(image, wrong))
    assert adjust(registry.POLYNOMIAL_2D.request(), points(made_rational(1, 2).project(flat), flat)).control.count == 30


def test_points_on_a_plane_in_space_are_refused_by_name() -> None:
    """Their heights fall off with the square of the distance as the Earth does, so that only X, Y and Z tell."""
    ground = places(30, 1)
    origin, up = geocentric(MIDDLE[np.newaxis])[0], unit(geocentric(MIDDLE[np.newaxis])[0])
    for _ in range(5):
        ground[:, 2] -= (geocentric(ground) - origin) @ up
    image = made_rational(1, 2).project(ground)
    with pytest.raises(SensorModelError, match="lie on one plane, so the terms in Z of the model pushbroom can't"):
        adjust(registry.PUSHBROOM.request(), points(image, ground))
    assert adjust(registry.DLT.request(), points(image, ground)).control.count == 30


def test_layout_says_what_is_extrapolated() -> None:
    square = np.array([[0, 0], [100, 0], [100, 50], [0, 50], [50, 25.0]])
    line = np.column_stack([np.linspace(0, 100, 9), np.linspace(0, 50, 9) + np.tile([0.1, -0.1, 0], 3)])
    for control, share in ((square, ""), (square / 4, "94%"), (line, "100%")):
        said = control_coverage(control, (0.0, 0.0, 100.0, 50.0)).notices
        assert [share in str(warning) for warning in said] == [True] * bool(share)
    assert len(control_coverage(square, (0.0, 0.0, 100.0, 50.0)).outline) == 5


def test_the_split_is_even_and_repeats() -> None:
    ground = places(40, 1)
    given = points(made_rational(1, 2).project(ground), ground)
    parted = choose_check_points(given, 0.25)
    assert parted.check.sum() == 10
    assert np.array_equal(parted.check, choose_check_points(given, 0.25).check)
    assert control_coverage(given.image[~parted.check], (0, 0, COLUMNS, ROWS)).extrapolated < 0.4
    checks = given.image[parted.check]
    assert all((checks[:, axis] < half).sum() in range(3, 8) for axis, half in ((0, COLUMNS / 2), (1, ROWS / 2)))
    assert not choose_check_points(given, 0).check.any()


@pytest.mark.slow
def test_comparison_recommends_the_parametric_model() -> None:
    ground = places(14, 3)
    few = points(made_pushbroom(0).project(ground) + np.random.default_rng(3).normal(0, SIGMA, (14, 2)), ground)
    models = all_requests(None, 694e3, (COLUMNS, ROWS))
    result = compare(few, models, robust=False, flat=is_flat(few))
    assert result.method == LEAVE_ONE_OUT
    assert result.recommended.request.kind == registry.PUSHBROOM
    assert result.recommended.errors.count == 14
    refused = {row.request.name: str(row.reason) for row in result.rows if row.errors is None}
    assert "needs at least 39" in refused["rational 3"]


def test_plane_models_are_recommended_on_flat_terrain_only() -> None:
    random = np.random.default_rng(2)
    ground = places(40, 2)
    for height, flat in ((0.05, True), (1500.0, False)):
        ground[:, 2] = height * random.uniform(0, 1, 40)
        given = points(made_rational(1, 3, 0).project(ground), ground, np.arange(40) >= 20)
        assert is_flat(given) == flat
        result = compare(given, [registry.POLYNOMIAL_2D.request("1"), registry.POLYNOMIAL_3D.request("1")], False, flat)
        assert (result.recommended.request.kind == registry.POLYNOMIAL_3D) >= (not flat)
    nothing = compare(given, [registry.RATIONAL.request("3")], False, False)
    assert nothing.recommended is None
    assert "No model could be fitted" in str(nothing.reason)


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
