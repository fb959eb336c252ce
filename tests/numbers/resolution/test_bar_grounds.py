"""The ground beside the bars has no part in the distance, and its error is as small as it says."""
from __future__ import annotations

import math
from collections.abc import Callable
from itertools import product

import numpy as np
import pytest
from seam_inspector.plugin.resolution.measure.bar_groups import TargetResolution
from seam_inspector.plugin.resolution.measure.target import Target

from tests.numbers.resolution.bar_grounds import GROUNDS, Ground, Scene, ground_scene
from tests.numbers.resolution.bar_targets import STEP, theoretical_cycle
from tests.numbers.resolution.measuring_bars import resolution

MakeRaster = Callable[..., str]
KINDS = tuple(product((False, True), (3, 5)))
"""Kinds of targets: bright bars or dark ones, three or five of them."""


def measured_scene(make_raster: MakeRaster, scene: Scene) -> tuple[TargetResolution, int | None]:
    """What a target says, and by how many steps its distance is coarser than theory's; None where there is none."""
    path = make_raster("target.tif", scene.pixels, gsd=0.1)
    target = Target(scene.bars, reference_group=0, reference_grd_cm=10 * scene.cycles[0])
    measured = resolution(path, scene.lines, target)
    grd = measured.worst("along")
    return measured, None if grd is None else scene.expected - round(math.log(target.reference_grd_cm / grd, STEP))


@pytest.mark.release
@pytest.mark.parametrize(("dark_bars", "bars"), KINDS)
def test_the_mean_signed_error_is_small_on_any_ground(make_raster: MakeRaster, dark_bars: bool, bars: int) -> None:
    """Other ground right beside the bars, random phases, blurs of 0.45 to 1.4 px, noise of 0.5 to 4 DN, rough lines."""
    random, errors, widths, holds = np.random.default_rng(5), [], [], 0
    for place in range(20):
        ground = list(GROUNDS.values())[place % len(GROUNDS)]
        scene = ground_scene(random, ground, dark_bars, bars, 9, limit=5)
        measured, error = measured_scene(make_raster, scene)
        errors.append(error)
        low, high = measured.interval("along") or (math.inf, 0.0)
        widths.append(math.log(high / low, STEP))
        holds += low <= 10 * scene.cycles[scene.expected] * 1.001 and 10 * scene.cycles[scene.expected] <= high * 1.001
    assert holds >= 19
    assert np.mean(widths) < 3
    assert None not in errors
    assert abs(np.mean(errors)) < 0.2
    assert np.mean(np.equal(errors, 0)) >= 0.7


@pytest.mark.slow
@pytest.mark.parametrize("sigma", [0.6, 1.0, 1.3])
@pytest.mark.parametrize("dark_bars", [False, True])
def test_the_distance_is_the_same_on_every_ground(make_raster: MakeRaster, sigma: float, dark_bars: bool) -> None:
    """Bars and noise are the same; the issue's four grounds gave 37.80, 33.67, 33.67 and 42.43 cm."""
    finest = theoretical_cycle(sigma) * STEP**0.5  # half a step either side of where theory crosses the criterion
    readings = {
        name: measured_scene(make_raster, ground_scene(
            np.random.default_rng(3), ground, dark_bars, groups=9, sigma=sigma, noise=1.0, limit=5, finest=finest
        ))
        for name, ground in GROUNDS.items()
    }
    assert {name: error for name, (_, error) in readings.items()} == dict.fromkeys(GROUNDS, 0)


def test_ground_as_bright_as_the_bars_hides_none_of_them(make_raster: MakeRaster) -> None:
    """Outer bars that merge with it are known by their gaps."""
    for value in (150.0, 170.0):
        finest = theoretical_cycle(1.0) * STEP**0.5
        ground = Ground(0.0, value)
        scene = ground_scene(np.random.default_rng(4), ground, groups=9, sigma=1.0, limit=5, finest=finest)
        assert measured_scene(make_raster, scene)[1] == 0


@pytest.mark.release
def test_the_error_of_a_distance_is_what_repeating_it_shows(make_raster: MakeRaster) -> None:
    """The share's deviation from theory over its standard deviation, of the groups about the limit."""
    random, away = np.random.default_rng(11), []
    for place in range(20):
        ground = list(GROUNDS.values())[place % len(GROUNDS)]
        scene = ground_scene(random, ground, groups=8, limit=4)
        measured, _ = measured_scene(make_raster, scene)
        for group in (3, 4, 5):
            reading = measured.results[group].reading
            if reading is not None and reading.share is not None and reading.share_error:
                away.append((reading.share - scene.bars_share(scene.cycles[group])) / reading.share_error)
        error, grd = measured.worst_error("along"), measured.worst("along")
        assert 0 < error / grd < STEP - 1
    assert len(away) >= 50
    assert 0.5 < float(np.sqrt(np.mean(np.square(away)))) < 1.5


def test_a_lone_group_is_judged_by_the_plain_ground_beside_it(make_raster: MakeRaster) -> None:
    scene = ground_scene(np.random.default_rng(6), Ground(3.0, 60.0), groups=1, limit=-1, sigma=0.8, noise=1.0)
    path = make_raster("target.tif", scene.pixels, gsd=0.1)
    measured = resolution(path, scene.lines, Target(reference_group=0, reference_grd_cm=10 * scene.cycles[0]))
    (result,) = measured.results
    assert any("taken from the ground beside" in str(notice) for notice in measured.notices)
    assert result.reading.share == pytest.approx(scene.bars_share(scene.cycles[0]), abs=0.05)


def test_the_two_pixel_limit_stays_on_bar_and_gap_together(make_raster: MakeRaster) -> None:
    """The paper's DMC: bars of 1.2 px are 2.4 px with their gaps, and are no aliasing."""
    random = np.random.default_rng(2)
    scene = ground_scene(random, GROUNDS["panel"], groups=6, limit=3, sigma=0.3, noise=0.5, finest=2.2)
    path = make_raster("target.tif", scene.pixels, gsd=0.1)
    words = []
    for grd_of, share in (("cycle", 1.0), ("bar", 0.5)):
        target = Target(reference_group=0, reference_grd_cm=10 * share * scene.cycles[0], grd_of=grd_of)
        measured = resolution(path, scene.lines, target)
        assert measured.scale_notice is None
        words.append([(result.resolved, str(result.reason)) for result in measured.results])
    assert words[0] == words[1]
    assert words[0][0] == (True, "None")
    assert any("fewer than two" in reason for _, reason in words[0])
