"""The ground resolved distance of rendered targets is the theoretical one, and aliasing never counts."""
from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe_north_up
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.resolution.measure.bars import BarLine, measure_line
from seam_inspector.plugin.resolution.measure.profiles import Segment
from seam_inspector.plugin.resolution.measure.target import Target

from tests.numbers.resolution.bar_targets import STEP, Bars, coverage, image, row_of_groups, theoretical_cycle
from tests.numbers.resolution.measuring_bars import measured, resolution

MakeRaster = Callable[..., str]
PIXEL_CM = 10.0


@pytest.mark.release
def test_grd_is_that_of_the_finest_group_that_theory_resolves(make_raster: MakeRaster) -> None:
    """Sixty targets of four groups: blur, noise, rotation, phase and roughly drawn lines at random."""
    random = np.random.default_rng(20)
    sigmas = np.linspace(0.44, 1.42, 12)
    theory = [theoretical_cycle(sigma) for sigma in sigmas]
    steps = []
    for _ in range(60):
        sigma, noise, angle = random.uniform(0.45, 1.4), random.uniform(0.5, 4), math.radians(random.uniform(-8, 8))
        expected = float(np.interp(sigma, sigmas, theory))
        coarsest = expected * STEP ** (1 + random.uniform(0, 1))
        shape, groups = row_of_groups([coarsest / STEP**step for step in range(4)], angle, random)
        path = make_raster("target.tif", image(shape, groups, sigma, noise, int(random.integers(1 << 30))), gsd=0.1)
        lines = {
            group: bars.line(random.uniform(1.4, 1.9), math.radians(random.uniform(-8, 8)), random.uniform(-0.5, 0.5))
            for group, bars in enumerate(groups)
        }
        grd_cm = resolution(path, lines, Target(reference_group=0, reference_grd_cm=coarsest * PIXEL_CM)).worst("along")
        steps.append(math.inf if grd_cm is None else math.log(grd_cm / PIXEL_CM / expected) / math.log(STEP))
    away = np.floor(steps)  # groups from the finest one
    assert abs(float(np.mean(away))) < 0.2
    assert np.mean(np.abs(away) <= 1) >= 0.98
    assert np.mean(away == 0) >= 0.75


@pytest.mark.slow
@pytest.mark.parametrize("angle", [0.0, 7.0, 20.0, 45.0])
def test_aliased_bars_are_never_resolved(make_raster: MakeRaster, angle: float) -> None:
    """No blur but the pixels' own, finer than two pixels: bars stand out now and then, but are not the group's."""
    random = np.random.default_rng(3)
    seemed = 0
    for cycle in np.linspace(1.1, 1.98, 30):
        shape, (bars,) = row_of_groups([float(cycle)], math.radians(angle), random)
        path = make_raster("aliased.tif", image(shape, [bars], 0.0, 0.5), gsd=0.1)
        ends = bars.line(2.0)
        target = Target(reference_group=1, reference_grd_cm=float(cycle) * PIXEL_CM)
        for result in resolution(path, {1: ends}, target).results:
            assert not result.resolved
            seemed += result.spurious
    assert seemed or angle  # else the test shows nothing: on the pixel grid some of them look perfect


def test_aliased_bars_are_not_resolved_without_a_scale_either(make_raster: MakeRaster) -> None:
    random = np.random.default_rng(4)
    for cycle in np.linspace(1.5, 1.98, 20):
        shape, (bars,) = row_of_groups([float(cycle)], 0.0, random)
        path = make_raster("aliased.tif", image(shape, [bars], 0.0, 0.5), gsd=1, origin=(0, 0), system=None)
        assert not any(result.resolved for result in resolution(path, {1: bars.line(2.0)}, Target()).results)


def test_a_group_that_is_finer_than_an_unresolved_one_is_spurious(make_raster: MakeRaster) -> None:
    """Figure 9 of the paper: group 10 seems resolved, group 9 is not."""
    cycles = [12.0, 6.0, 5.35, 4.77]
    shape, groups = row_of_groups(cycles, 0.0, np.random.default_rng(1))
    pixels = image(shape, groups, 0.6)
    third = slice(int(groups[1].x) - 12, int(groups[1].x) + 12)
    pixels[:, third] = image(shape, groups, 3.0)[:, third]  # the second group is blurred away
    target = Target(reference_group=8, reference_grd_cm=12.0 * PIXEL_CM, step=2.0)
    lines = {8: groups[0].line(), 9: groups[1].line(), 10: groups[2].line()}
    target = replace(target, reference_grd_cm=PIXEL_CM * 12.0)
    measured = resolution(make_raster("t.tif", pixels, gsd=0.1), lines, replace(target, step=1.5))
    verdicts = [(result.resolved, result.spurious) for result in measured.results]
    assert verdicts == [(True, False), (False, False), (False, True)]
    assert "coarser group, 9, is not resolved" in str(measured.results[2].reason)
    assert measured.worst("along") == pytest.approx(120.0)


def test_amplitudes_are_those_of_the_scene(make_raster: MakeRaster) -> None:
    """Wide bars: 160 DN between bars and gaps; a linear change of tone scales them and leaves the verdict."""
    shape, groups = row_of_groups([14.0], math.radians(5), np.random.default_rng(2))
    scene = coverage(shape, groups, 0.8)
    for low, high in ((40.0, 200.0), (400.0, 3800.0)):
        path = make_raster("t.tif", (low + (high - low) * scene).astype(np.float32), gsd=0.1)
        (line,) = measured(path, {1: groups[0].line()})
        reading = line.readings["band_1"]
        assert reading.full_amplitude == pytest.approx(high - low, rel=0.02)
        assert reading.amplitude == pytest.approx(high - low, rel=0.03)
        assert reading.modulation == pytest.approx((high - low) / (high + low), rel=0.02)
        assert reading.spacing == pytest.approx(14.0, rel=0.01)


@pytest.mark.parametrize("error", [-9.0, -4.0, 0.0, 6.0, 10.0])
def test_a_line_is_turned_to_be_perpendicular(make_raster: MakeRaster, error: float) -> None:
    shape, groups = row_of_groups([6.0], 0.1, np.random.default_rng(6))
    path = make_raster("t.tif", image(shape, groups, 0.8, 1.0), gsd=0.1)
    (line,) = measured(path, {1: groups[0].line(1.6, math.radians(error))})
    u, v = line.segment.along
    assert math.degrees(math.atan2(v, u) - 0.1) == pytest.approx(0.0, abs=1.5)


@pytest.mark.parametrize("shift", [-0.7, 0.0, 0.35, 1.2])
def test_the_shift_of_a_band_against_green(make_raster: MakeRaster, shift: float) -> None:
    """Chromatic aberration: red lies further along the line by so many pixels, blue as far on the other side."""
    shape, (bars,) = row_of_groups([8.0], 0.0, np.random.default_rng(7))
    bands = [
        image(shape, [replace(bars, x=bars.x + sign * shift)], 0.8, 1.0, seed) for seed, sign in enumerate((1, 0, -1))
    ]
    path = make_raster("rgb.tif", np.stack(bands), gsd=0.1)
    (line,) = measured(path, {1: bars.line()})
    assert line.shifts["red"] == pytest.approx(shift, abs=0.05)
    assert line.shifts["green"] == 0
    assert line.shifts["blue"] == pytest.approx(-shift, abs=0.05)


def test_bars_that_do_not_exceed_the_noise_are_not_resolved(make_raster: MakeRaster) -> None:
    shape, groups = row_of_groups([12.0], 0.05, np.random.default_rng(8))
    scene = 100 + 20 * coverage(shape, groups, 0.8)
    verdicts = []
    for noise in (2.0, 9.0):
        pixels = scene + np.random.default_rng(9).normal(0, noise, shape)
        path = make_raster("t.tif", pixels.astype(np.float32), gsd=0.1)
        target = Target(reference_group=1, reference_grd_cm=120)
        (result,) = resolution(path, {1: groups[0].line()}, target).results
        verdicts.append(result.resolved)
    assert verdicts == [True, False]
    assert "does not exceed three times the noise" in str(result.reason)


def test_five_bars(make_raster: MakeRaster) -> None:
    bars = Bars(60.0, 40.0, 7.0, 18.0, 0.05, count=5)
    path = make_raster("t.tif", image((80, 120), [bars], 0.8, 1.0), gsd=0.1)
    lines = {1: bars.line()}
    five, three = (
        resolution(path, lines, Target(bars=count, reference_group=1, reference_grd_cm=70)).results[0]
        for count in (5, 3)
    )
    assert five.resolved
    assert not three.resolved
    assert "5 bars stand out and a group has 3" in str(three.reason)


@given(group=st.integers(-40, 40), reference=st.integers(-20, 20), grd=st.floats(0.1, 1000))
def test_distances_of_groups(group: int, reference: int, grd: float) -> None:
    """A group finer by six steps has half the distance, whichever way the target is numbered."""
    target = Target(reference_group=reference, reference_grd_cm=grd)
    assert target.grd_cm(reference) == pytest.approx(grd)
    assert target.grd_cm(group) / target.grd_cm(group + 6) == pytest.approx(2)
    assert replace(target, reversed=True).grd_cm(reference + group) == pytest.approx(target.grd_cm(reference - group))


def test_the_papers_distances() -> None:
    """Tables 3A and 3B: every value is a group of a target whose ninth has 30 cm."""
    groups = [9, 8, 6, 3, 2, 1]
    assert [f"{Target().grd_cm(group):.2f}" for group in groups] == "30.00 33.67 42.43 60.00 67.35 75.60".split()


def test_one_band_of_three(make_raster: MakeRaster) -> None:
    shape, groups = row_of_groups([8.0], 0.0, np.random.default_rng(7))
    path = make_raster("rgb.tif", np.stack([image(shape, groups, 0.8)] * 3), gsd=0.1)
    raster, ends = describe_north_up(RasterRef(path)), groups[0].line()
    third = OpenRaster(raster.ref).band_index(3)
    line = measure_line(raster, BarLine(1, "along", Segment(ends[:2], ends[2:])), 3, 3.0, third)
    assert list(line.readings) == ["blue"]
    assert line.shifts["blue"] == pytest.approx(0, abs=0.01)  # green is looked at all the same
