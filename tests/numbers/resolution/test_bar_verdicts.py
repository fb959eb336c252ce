"""What is said of bars that were measured: resolved or not, saturated, and whether the target is the one described."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from seam_inspector.plugin.imagery.open_raster import describe_north_up
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.resolution.measure.bar_groups import GroupResult, TargetResolution, judge_lines
from seam_inspector.plugin.resolution.measure.bars import BarLine, BarReading, Extreme, MeasuredLine
from seam_inspector.plugin.resolution.measure.profiles import Profile, Segment
from seam_inspector.plugin.resolution.measure.target import Target

from tests.numbers.resolution.bar_targets import coverage, image, row_of_groups, theoretical_cycle
from tests.numbers.resolution.measuring_bars import measured, resolution

MakeRaster = Callable[..., str]


@pytest.mark.parametrize(("amplitude", "resolved"), [(50.0, True), (49.9, False)])
def test_half_of_the_full_amplitude_is_enough(make_raster: MakeRaster, amplitude: float, resolved: bool) -> None:
    bars = tuple(Extreme(place, 150.0) for place in (5.0, 10.0, 15.0))
    gaps = tuple(Extreme(place, 150.0 - amplitude) for place in (7.5, 12.5))
    profile = Profile(np.arange(20.0), np.full(20, 100.0), 20.0, noise=1.0)
    reading = BarReading(profile, True, bars, gaps, (50.0,), 100.0, 1.0, amplitude, 1.0, None)
    line = MeasuredLine(BarLine(0, "along", Segment((0, 0), (20, 0))), None, {"grey": reading})
    raster = describe_north_up(RasterRef(make_raster("any.tif", np.zeros((8, 8), np.uint8), gsd=0.1)))
    assert judge_lines(raster, [line], Target(reference_group=0, reference_grd_cm=50)).results[0].resolved is resolved


@pytest.mark.parametrize(("clipped", "value"), [((), None), ((1,), None), ((0, 2), 255.0), ((0, 1, 2), 255.0)])
def test_bars_are_saturated_when_two_of_them_are(
    make_raster: MakeRaster, clipped: tuple[int, ...], value: float | None
) -> None:
    shape, (bars,) = row_of_groups([12.0], 0.0, np.random.default_rng(1))
    seen = 40 + 140 * coverage(shape, [bars], 0.5)
    single = [replace(bars, x=bars.x + (bar - 1) * bars.cycle, count=1) for bar in clipped]
    seen += 200 * coverage(shape, single, 0.5) + np.random.default_rng(2).normal(0, 2, shape)
    path = make_raster("target.tif", np.clip(np.rint(seen), 0, 255).astype(np.uint8), gsd=0.1)
    (line,) = measured(path, {0: bars.line()})
    assert line.saturated.get("band_1") == value


@pytest.mark.parametrize(("cycles", "backwards"), [((12, 9, 6), False), ((6, 9, 12), True), ((8, 8, 8), False)])
def test_bars_that_get_wider_where_they_should_get_finer_are_told(
    make_raster: MakeRaster, cycles: tuple[float, ...], backwards: bool
) -> None:
    shape, groups = row_of_groups(list(cycles), 0.0, np.random.default_rng(1))
    path = make_raster("target.tif", image(shape, groups, 0.5, 1.0), gsd=0.1)
    lines = {group: bars.line() for group, bars in enumerate(groups)}
    notice = resolution(path, lines, Target(reference_group=0, reference_grd_cm=120, step=4 / 3)).scale_notice
    assert ("get wider" in str(notice)) is backwards


def test_bars_too_weak_to_be_resolved_are_seen_and_their_share_is_told(make_raster: MakeRaster) -> None:
    cycle = theoretical_cycle(1.0, criterion=0.35)
    shape, (bars,) = row_of_groups([cycle], 0.1, np.random.default_rng(1))
    path = make_raster("target.tif", image(shape, [bars], 1.0, 0.5), gsd=0.1)
    (result,) = resolution(path, {0: bars.line()}, Target(reference_group=0, reference_grd_cm=cycle * 10)).results
    assert len(result.reading.bars) == 3
    assert result.reading.share == pytest.approx(0.35, abs=0.04)
    assert not result.resolved


def test_a_directions_distance_is_its_worst_bands_and_the_targets_the_geometric_mean() -> None:
    line = MeasuredLine(BarLine(0, "along", None), None)
    finest = {("along", "red"): 30.0, ("along", "green"): 40.0, ("across", "red"): 90.0, ("across", "green"): 85.0}
    groups = {key: GroupResult(line, key[1], grd, grd_error_cm=0.04 * grd) for key, grd in finest.items()}
    result = TargetResolution((), groups, {}, ())
    assert (result.worst("along"), result.worst("across"), result.mean) == (40, 90, 60)
    assert (result.worst_error("along"), result.worst_error("across")) == pytest.approx((1.6, 3.6))
    assert result.mean_error == pytest.approx(60 * 0.04 / np.sqrt(2))
    lost = TargetResolution((), {**groups, ("along", "red"): None}, {}, ())
    assert (lost.worst_error("along"), lost.mean_error) == (None, None)
    assert (lost.worst("along"), lost.worst("across"), lost.mean) == (None, 90, None)


@pytest.mark.parametrize(("true_cm", "said"), [(60.0, None), (90.0, "0.67"), (40.0, "1.5")])
def test_bars_that_lie_as_the_pixel_size_says_need_no_notice(
    make_raster: MakeRaster, true_cm: float, said: str | None
) -> None:
    shape, (bars,) = row_of_groups([6.0], 0.0, np.random.default_rng(1))
    path = make_raster("target.tif", image(shape, [bars], 0.5, 1.0), gsd=0.1)
    notice = resolution(path, {0: bars.line()}, Target(reference_group=0, reference_grd_cm=true_cm)).scale_notice
    assert (notice is None) == (said is None)
    assert said is None or said in str(notice)


@pytest.mark.parametrize("turned", [False, True])
def test_a_whole_target_numbered_against_its_widths_is_told(make_raster: MakeRaster, turned: bool) -> None:
    """Even where the amplitudes, held against those of the wrong groups, let hardly one seem resolved."""
    cycles = [36 / 2 ** (number / 6) for number in range(12)]
    shape, groups = row_of_groups(cycles, 0.0, np.random.default_rng(1))
    path = make_raster("target.tif", image(shape, groups, 2.5, 1.0), gsd=0.1)
    lines = {group: bars.line() for group, bars in enumerate(groups)}
    result = resolution(path, lines, Target(reference_group=0, reference_grd_cm=360, reversed=turned))
    assert ("get wider" in str(result.scale_notice)) is turned
    assert bool(result.contrasts) is not turned  # which group is the coarsest one is not known


@pytest.mark.parametrize(("group", "reference"), [(10_000, 0), (0, 10_000), (-10_000, 0), (10**12, 0)])
@pytest.mark.parametrize("turned", [False, True])
def test_groups_too_far_from_the_reference_group_have_a_reason(
    make_raster: MakeRaster, group: int, reference: int, turned: bool
) -> None:
    shape, (bars,) = row_of_groups([12.0], 0.0, np.random.default_rng(1))
    path = make_raster("target.tif", image(shape, [bars], 0.5, 1.0), gsd=0.1)
    (result,) = resolution(path, {group: bars.line()}, Target(reference_group=reference, reversed=turned)).results
    assert f"Group {group} is too far from the reference group {reference}" in str(result.reason)
    assert (result.resolved, result.grd_cm) == (False, None)


def test_a_band_without_any_bars_leaves_no_worst_of_the_bands(make_raster: MakeRaster) -> None:
    shape, groups = row_of_groups([14.0, 12.0, 10.0], 0.0, np.random.default_rng(1))
    seen = image(shape, groups, 0.5, 1.0)
    path = make_raster("target.tif", np.stack([seen, seen, np.full_like(seen, 3)]), gsd=0.1)
    lines = {group: bars.line() for group, bars in enumerate(groups)}
    result = resolution(path, lines, Target(reference_group=0, reference_grd_cm=140, step=7 / 6))
    assert result.finest["along", "red"] is not None
    assert result.worst("along") is None
    (words,) = [str(notice) for notice in result.notices if "is resolved in" in str(notice)]
    assert "blue" in words
