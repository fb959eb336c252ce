"""The accuracy to expect, held against theory and documented figures, and the angle an image was taken at."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.reference_systems import metres_per_unit
from seam_inspector.plugin.sensors.measure import registry
from seam_inspector.plugin.sensors.measure.fit_files import view_direction
from seam_inspector.plugin.sensors.measure.frames import BrownLens, FrameCamera, FrameInterior, camera_axes
from seam_inspector.plugin.sensors.measure.point_planning import (
    ExpectedAccuracy,
    PlannedScene,
    PointPlan,
    expected_accuracies,
    nominal_scene,
    scene_of_rpc,
)
from seam_inspector.plugin.sensors.measure.polynomials import Rational, fit_rational
from seam_inspector.plugin.sensors.measure.registry import ModelKind
from seam_inspector.plugin.sensors.measure.rpc import Domain, to_metadata

from tests.numbers.sensors.sensor_scenes import COLUMNS, MIDDLE, ROWS, WGS84, made_rational, pleiades_grid

PLAN = PointPlan("grid", 0.25, sigma_m=0.5, sigma_px=0.0)
NOMINAL = nominal_scene(694e3, 20, 0.5, 15e3, (0, 300))


def expected(
    kind: ModelKind, scene: PlannedScene, plan: PointPlan, *counts: int, form: str = "", seed: int = 1, draws: int = 50
) -> list[ExpectedAccuracy]:
    rpc = scene.model if isinstance(scene.model, Rational) else None
    return list(expected_accuracies(kind.request(form, size=scene.size, rpc=rpc), scene, plan, counts, seed, draws))


def leverages(count: int, draws: int) -> np.ndarray:
    """(draws,) mean leverage over an image of points anywhere in it, for a plane through them."""
    random, variances = np.random.default_rng(0), []
    everywhere = np.column_stack([np.ones(400), random.uniform(0, 1, (400, 2))])
    for _ in range(draws):
        design = np.column_stack([np.ones(count), random.uniform(0, 1, (count, 2))])
        variances.append(np.mean(np.sum(everywhere @ np.linalg.inv(design.T @ design) * everywhere, axis=1)))
    return np.array(variances)


@pytest.mark.slow
@pytest.mark.parametrize("count", [5, 12, 40])
def test_a_plane_is_what_theory_says(count: int) -> None:
    """Two coordinates, each sigma times the root of 1 + the mean leverage at check points, without the 1 in truth."""
    scene = scene_of_rpc(made_rational(1, 2, 0.0), (COLUMNS, ROWS), (600.0, 600.0))
    [row] = expected(registry.POLYNOMIAL_2D, scene, replace(PLAN, spread="random"), count, draws=120)
    leverage = float(np.median(leverages(count, 3000)))
    assert row.failed == 0
    assert row.check_usual == pytest.approx(np.sqrt(2) * 0.5 * np.sqrt(1 + leverage), rel=0.07)
    assert row.image_usual == pytest.approx(np.sqrt(2) * 0.5 * np.sqrt(leverage), rel=0.15)


@pytest.mark.slow
@pytest.mark.parametrize("count", [1, 4, 16])
def test_a_shift_is_as_good_as_the_mean_of_its_points(count: int) -> None:
    scene = scene_of_rpc(made_rational(3, 2), (COLUMNS, ROWS), (0.0, 1200.0))
    flat = replace(PLAN, sigma_m=0.0, sigma_px=0.5)
    [row] = expected(registry.RPC_BIAS, scene, flat, count, form="shift", draws=120)
    places = np.array([MIDDLE, MIDDLE + [1e-4, 0, 0], MIDDLE + [0, 1e-4, 0]])
    seen = scene.model.project(places)
    metres = 1e-4 * np.array([111319.5 * np.cos(np.radians(MIDDLE[1])), 111130.0])
    slopes = np.linalg.inv(((seen[1:] - seen[0]) / metres[:, None]).T)  # m per px
    # A chi-square of two degrees, about: its median, and its 90 % quantile.
    usual, most = (np.linalg.norm(slopes) * 0.5 / np.sqrt(count) * np.sqrt(part) for part in (np.log(2), np.log(10)))
    assert row.image_usual == pytest.approx(usual, rel=0.2)
    assert row.image_most == pytest.approx(most, rel=0.2)


def test_on_pleiades_the_medians_are_those_of_the_documentation(data_folder: Path) -> None:
    """There from nodes of the physical model, written in px of half a metre."""
    grid = pleiades_grid(data_folder).reshape(-1, 5)
    rpc = fit_rational(grid[::3, 2:], grid[::3, :2], np.ones(len(grid[::3])), 3).model
    assert isinstance(rpc, Rational)
    columns, rows = map(float, grid[:, :2].max(axis=0))
    scene = scene_of_rpc(rpc, (columns, rows), (float(grid[:, 4].min()), float(grid[:, 4].max())))
    documented = {"pushbroom": 3.0, "rational": 14, "dlt": 30, "polynomial_3d": 45, "polynomial_2d": 685}
    medians = []
    for name, px in documented.items():
        [row] = expected(registry.KINDS[name], scene, PLAN, 10, draws=20 if name == "pushbroom" else 50)
        assert 1 / 1.7 < row.image_usual / (0.5 * px) < 1.7, name
        medians.append(row.image_usual)
    assert medians == sorted(medians)


def test_the_nominal_scanner_is_tilted_and_covers_what_is_asked_for() -> None:
    columns, rows = NOMINAL.size
    assert columns == rows == 30000
    domain = Domain((0, columns), (0, rows), NOMINAL.heights, NOMINAL.middle)
    view = view_direction(NOMINAL.model, "EPSG:4326", domain, 1)
    assert view.angle == pytest.approx(20, abs=0.1)
    seen = NOMINAL.model.project(np.array([[0, 45, 150], [0.001, 45, 150], [0, 45.001, 150]]))
    assert seen[0] == pytest.approx([15000, 15000], abs=10)
    assert seen[1, 0] - seen[0, 0] == pytest.approx(78.85 / 0.5, rel=0.01)  # m of a thousandth of a degree at 45 N
    assert seen[0, 1] - seen[2, 1] == pytest.approx(111.13 / 0.5, rel=0.01)


def test_the_same_seed_gives_the_same_figures_whatever_else_is_asked_for() -> None:
    both, single = (expected(registry.DLT, NOMINAL, PLAN, *counts, draws=5) for counts in ((8, 12), (12,)))
    assert both[1] == single[0]
    assert expected(registry.DLT, NOMINAL, PLAN, 12, seed=2, draws=5) != single


def test_draws_that_fail_count_as_the_worst() -> None:
    """Exact points on a plane determine no model in space."""
    flat = replace(NOMINAL, heights=(100.0, 100.0))
    [row] = expected(registry.POLYNOMIAL_3D, flat, replace(PLAN, sigma_m=0.0), 10, draws=4)
    assert row.failed == 4
    assert row.image_usual is None
    assert row.check_most is None
    assert row.reason is not None


DOMAIN = Domain((0, COLUMNS), (0, ROWS), (0, 1200), (float(MIDDLE[0]), float(MIDDLE[1])))


def test_the_angle_is_that_of_gdals_lines_of_sight() -> None:
    """GDAL's RPC transformer puts the middle of the image at two heights; 45 degrees would move it by as much."""
    rpc = made_rational(3, 4)
    view = view_direction(rpc, WGS84, DOMAIN, -7)
    image = gdal.GetDriverByName("MEM").Create("", int(COLUMNS), int(ROWS), 1)
    image.SetMetadata(to_metadata(rpc), "RPC")
    transformer = gdal.Transformer(image, None, ["METHOD=RPC", "RPC_PIXEL_ERROR_THRESHOLD=1e-6"])
    low, high = (np.array(transformer.TransformPoint(0, COLUMNS / 2, ROWS / 2, z)[1][:2]) for z in (550, 650))
    east, north = (high - low) * metres_per_unit(WGS84, low)
    assert np.tan(np.radians(view.angle)) == pytest.approx(np.hypot(east, north) / 100, rel=1e-3)
    assert view.azimuth == pytest.approx(np.degrees(np.arctan2(east, north)) % 360, abs=0.1)
    assert view.shift == pytest.approx(7 * np.hypot(east, north) / 100, rel=1e-3)
    assert view.largest >= view.angle - 1e-9


def test_an_oblique_photo_has_a_view() -> None:
    """A drone's strong lens, tilted by 30 degrees: a search from below the photo loses its way to a corner."""
    principal = np.array([688.2, 453.0])
    interior = FrameInterior(np.full(2, 914.0), principal, BrownLens((-0.264, 0.112, -0.027), (9e-4, -5e-4)))
    camera = FrameCamera(interior, np.array([500_000.0, 5_550_000.0, 520.0]), camera_axes(30, 0, 0))
    domain = Domain((0, 1368), (0, 912), (230, 370), (500_000.0, 5_550_130.0))
    view = view_direction(camera, "EPSG:32651", domain, 1)
    assert view.angle == pytest.approx(30, abs=0.3)
    assert view.azimuth == pytest.approx(180, abs=1)
    assert 65 < view.largest < 75


def test_a_model_that_can_t_be_inverted_has_no_view() -> None:
    """So that an orthoimage which is made already does not fail for it."""
    bent = replace(made_rational(1, 2), numerators=np.zeros((4, 2)))
    assert view_direction(bent, WGS84, DOMAIN, 1) is None
