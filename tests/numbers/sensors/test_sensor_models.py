"""Every sensor model: recovered from its own points, and on the geometry of real satellite images."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.sensors.measure import registry
from seam_inspector.plugin.sensors.measure.adjustment import Adjustment, adjust
from seam_inspector.plugin.sensors.measure.polynomials import (
    Dlt,
    Polynomial2D,
    Polynomial3D,
    Rational,
    fit_chosen_terms,
    fit_rational,
)
from seam_inspector.plugin.sensors.measure.pushbroom import fit_pushbroom
from seam_inspector.plugin.sensors.measure.registry import ModelRequest
from seam_inspector.plugin.sensors.measure.rpc import BiasedRpc
from seam_inspector.plugin.sensors.measure.sensor_model import Scaling

from tests.numbers.sensors.sensor_scenes import (
    COLUMNS,
    MIDDLE,
    REACH,
    ROWS,
    made_pushbroom,
    made_rational,
    places,
    pleiades_grid,
    points,
    ten_spread,
)

EXACT_PX = 1e-6
IMAGE = Scaling(np.array([COLUMNS / 2, ROWS / 2]), np.array([COLUMNS / 2, ROWS / 2]))


def judged(asked: ModelRequest, image: np.ndarray, ground: np.ndarray, control: int) -> Adjustment:
    """A fit to the first points, judged on the others."""
    return adjust(asked, points(image, ground, np.arange(len(image)) >= control))


def largest_px(done: Adjustment) -> float:
    return float(np.abs(done.residuals_px[done.points.check]).max())


@pytest.mark.parametrize("order", [1, 2, 3])
@given(seed=st.integers(0, 10_000))
def test_quotients_and_polynomials_of_space_recover_themselves(order: int, seed: int) -> None:
    ground, truth = places(120, seed), made_rational(order, seed)
    plain = Polynomial3D(order, Scaling(MIDDLE, REACH), IMAGE, truth.numerators)
    for kind, model in ((registry.RATIONAL, truth), (registry.POLYNOMIAL_3D, plain)):
        done = judged(kind.request(str(order)), model.project(ground), ground, 80)
        assert done.fitted.converged
        assert largest_px(done) < EXACT_PX


@pytest.mark.parametrize("to_ground", [False, True])
@pytest.mark.parametrize("order", [1, 2, 3])
@given(seed=st.integers(0, 10_000))
def test_polynomial_2d_recovers_itself_in_either_direction(order: int, to_ground: bool, seed: int) -> None:
    ground, random = places(60, seed), np.random.default_rng(seed)
    coefficients = random.uniform(-0.02, 0.02, ({1: 3, 2: 6, 3: 10}[order], 2))
    coefficients[1:3] += [[1, 0], [0, -1]]
    model = Polynomial2D(order, Scaling(MIDDLE[:2], REACH[:2]), IMAGE, coefficients, to_ground)
    assert largest_px(judged(registry.POLYNOMIAL_2D.request(str(order)), model.project(ground), ground, 30)) < EXACT_PX


@pytest.mark.parametrize("with_xy", [False, True])
@given(seed=st.integers(0, 10_000))
def test_dlt_recovers_itself(with_xy: bool, seed: int) -> None:
    ground, random = places(40, seed), np.random.default_rng(seed)
    a = np.array([0.01, 1.0, 0.05, 0.01, -0.01, 0.05, -1.0, 0.012, *random.uniform(-0.02, 0.02, 3), 0.0])
    a[11] = 0.01 if with_xy else 0.0
    image = Dlt(Scaling(MIDDLE, REACH), IMAGE, a).project(ground)
    x, y = IMAGE.to(image).T
    scaled = np.column_stack([np.ones(40), (ground - MIDDLE) / REACH])
    denominator = scaled @ [1, *a[8:11]]
    assert np.allclose(x, scaled @ a[:4] / denominator, atol=1e-12)
    assert np.allclose(y, scaled @ a[4:8] / denominator + a[11] * x * y, atol=1e-12)  # equation 4 as printed
    assert largest_px(judged(registry.DLT.request("xy" if with_xy else ""), image, ground, 20)) < EXACT_PX


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_pushbroom_recovers_itself(seed: int) -> None:
    ground = places(120, seed)
    done = judged(registry.PUSHBROOM.request(size=(COLUMNS, ROWS)), made_pushbroom(seed).project(ground), ground, 60)
    assert done.fitted.converged
    assert largest_px(done) < EXACT_PX


@pytest.mark.parametrize("height_km", [500, 600, 800])
def test_the_orbits_height_need_be_known_roughly_only(height_km: float) -> None:
    truth, ground = made_pushbroom(0), places(30, 1)  # from 694 km
    fitted = fit_pushbroom(ground, truth.project(ground), np.ones(30), 1000 * height_km, (COLUMNS, ROWS))
    others = places(60, 2)
    assert fitted.model.project(others) == pytest.approx(truth.project(others), abs=1e-5)


@pytest.mark.parametrize(
    ("kind", "count", "used"),
    [("shift", 1, [0]), ("shift_drift", 2, [0, 2]), ("affine", 3, [0, 1, 2]), ("affine", 30, [0, 1, 2])],
)
@pytest.mark.parametrize("drifting", [0, 1])
def test_rpc_bias_recovers_itself(kind: str, count: int, used: list[int], drifting: int) -> None:
    ground, correction = places(60, 3), np.zeros((3, 2))
    correction[0] = 12.5, -7.25
    correction[used[1:], drifting] = 3.0
    if kind == "affine":
        correction[1:, 1 - drifting] = -2.0, 1.5
    rpc = made_rational(3, 4, 0.002)
    image = BiasedRpc(rpc, correction).project(ground)
    assert largest_px(judged(registry.RPC_BIAS.request(kind, rpc=rpc), image, ground, count)) < EXACT_PX


def test_residuals_in_metres_are_those_on_the_ground() -> None:
    ground = places(40, 1)
    image = made_rational(1, 1, 0.001).project(ground)
    ground = ground.copy()
    moved = np.zeros((40, 3))
    moved[35, :2] = 3 / (111319.49 * np.cos(np.radians(ground[35, 1]))), -2 / 111132.95  # 3 m east, 2 m south
    done = judged(registry.RATIONAL.request(), image, ground + moved, 30)
    assert done.residuals_m[35] == pytest.approx([-3, 2], abs=0.02)  # model minus given
    assert np.abs(np.delete(done.residuals_m, 35, axis=0)).max() < 1e-5


@pytest.mark.parametrize(
    ("order", "column", "row"), [(1, 12.375, 5.875), (2, 0.0845, 0.000795), (3, 1.075e-4, 1.105e-4)]
)
def test_rpcfit_scene(data_folder: Path, order: int, column: float, row: float) -> None:
    folder = data_folder / "sensors" / "rpcfit"
    parts = {name: np.load(folder / f"s1_{name}.npy") for name in ("train2d", "train3d", "test2d", "test3d")}
    image = np.concatenate([parts["train2d"], parts["test2d"]])
    ground = np.concatenate([parts["train3d"], parts["test3d"]])
    done = judged(registry.RATIONAL.request(str(order)), image, ground, len(parts["train2d"]))
    assert done.fitted.converged
    rmse = done.check.rmse_column, done.check.rmse_row
    assert all(error is not None and error <= limit for error, limit in zip(rmse, (column, row)))


def test_pleiades_grid_as_quotients_of_order_3(data_folder: Path) -> None:
    grid = pleiades_grid(data_folder)
    held_out = np.zeros(grid.shape[:3], bool)
    held_out[:, 1::2, 1::2] = True
    nodes = grid.reshape(-1, 5)
    done = adjust(registry.RATIONAL.request("3"), points(nodes[:, :2], nodes[:, 2:], held_out.ravel()))
    assert largest_px(done) < 0.01


def errors_px(asked: ModelRequest, control: np.ndarray, grid: np.ndarray) -> float:
    """Root mean square distance over the whole grid of a fit to (n, 5) nodes."""
    nodes = grid[:, ::8, ::8].reshape(-1, 5)
    both = np.concatenate([control, nodes])
    done = judged(asked, both[:, :2], both[:, 2:], len(control))
    return float(np.sqrt(np.mean(np.sum(done.residuals_px[len(control) :] ** 2, axis=1))))


def test_pushbroom_from_ten_exact_points_of_three_heights(data_folder: Path) -> None:
    grid = pleiades_grid(data_folder)
    random = np.random.default_rng(0)
    errors = [errors_px(registry.PUSHBROOM.request(), ten_spread(grid, random), grid) for _ in range(12)]
    assert max(errors) < 0.5
    assert np.median(errors) < 0.02


def test_with_noise_the_parametric_model_is_better_and_the_others_come_in_the_papers_order(data_folder: Path) -> None:
    grid, random = pleiades_grid(data_folder), np.random.default_rng(1)
    models = ("pushbroom", "rational", "dlt", "polynomial_3d", "polynomial_2d")
    errors: dict[str, list[float]] = {name: [] for name in models}
    for _ in range(50):
        control = ten_spread(grid, random)
        east, north, up = random.normal(0, 0.5, (3, 10))
        control[:, 2] += east / (111319.49 * np.cos(np.radians(control[:, 3])))
        control[:, 3] += north / 111132.95
        control[:, 4] += up
        for name in models:
            errors[name].append(errors_px(registry.KINDS[name].request(), control, grid))
    medians = [float(np.median(errors[name])) for name in models]
    assert medians == sorted(medians)
    assert np.median(np.array(errors["pushbroom"]) / errors["rational"]) < 0.5


def sparse() -> Rational:
    """Quotients with three terms beyond the linear ones of the column and none of the row."""
    made = made_rational(2, 3)
    numerators, denominators = made.numerators.copy(), np.zeros((10, 2))
    numerators[4:] = 0
    numerators[5, 0], numerators[8, 0] = 0.02, -0.01
    denominators[0], denominators[2, 0] = 1, 0.015
    return replace(made, numerators=numerators, denominators=denominators)


def test_fifteen_points_see_a_scene_that_order_two_needs_nineteen_for() -> None:
    """Fifteen noisy points: the terms that are there, and an error over the scene far below that of order 1."""
    truth, ground, everywhere = sparse(), places(15, 8), places(400, 9)
    image = truth.project(ground) + np.random.default_rng(1).normal(0, 0.3, (15, 2))
    chosen = fit_chosen_terms(ground, image, np.ones(15))
    assert isinstance(chosen.model, Rational)
    plain = fit_rational(ground, image, np.ones(15), 1).model
    misses = [np.sqrt(np.mean((model.project(everywhere) - truth.project(everywhere)) ** 2))
              for model in (chosen.model, plain)]
    assert misses[0] < 2
    assert misses[0] < misses[1] / 20
    assert chosen.unknowns <= 12
    assert not chosen.model.numerators[4:, 1].any()
    assert not chosen.model.denominators[1:, 1].any()
