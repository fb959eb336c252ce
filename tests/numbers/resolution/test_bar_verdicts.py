"""What is said of bars that were measured and of the target; the ground beside the bars has no part in it."""
from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
import pytest
from seam_inspector.plugin.imagery.open_raster import describe_north_up
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.resolution.measure.bar_groups import GroupResult, TargetResolution, judge_lines
from seam_inspector.plugin.resolution.measure.bars import BarLine, BarReading, Extreme, MeasuredLine
from seam_inspector.plugin.resolution.measure.profiles import Profile, Segment
from seam_inspector.plugin.resolution.measure.target import Target

from tests.numbers.resolution.bar_targets import (
    STEP,
    Bars,
    Ends,
    coverage,
    image,
    row_of_groups,
    theoretical_cycle,
    theoretical_share,
)
from tests.numbers.resolution.measuring_bars import measured, resolution

DARK, BRIGHT = 40.0, 170.0  # DN of a target's gaps and of its bars; the other way round for dark bars


@dataclass(frozen=True)
class Ground:
    """What lies beside the bars of each group."""

    margin: float  # how far the panel reaches beyond the outer bars on either side, bars
    value: float  # DN of what begins there, for bright bars; that of dark ones mirrors it
    gap: float = DARK  # DN of the target's gaps
    bar: float = BRIGHT  # DN of its bars


PANEL = Ground(2.0, 60.0)
GROUNDS = {
    "panel": PANEL, "60 DN": Ground(0.0, 60.0), "100 DN": Ground(0.0, 100.0), "130 DN": Ground(0.0, 130.0),
    "a dark panel one bar wide": Ground(1.0, 130.0),
}


@dataclass(frozen=True)
class Scene:
    """A rendered target: groups one step apart, the coarsest first, at random phases."""

    pixels: np.ndarray  # (rows, columns) uint8
    cycles: tuple[float, ...]  # px of a bar and a gap, by group
    lines: dict[int, Ends]  # a line across each group, roughly drawn
    sigma: float  # sigma of the blur, px
    bars: int

    @property
    def expected(self) -> int:
        """The finest group whose amplitude keeps half of the full one in theory, on the panel's own ground."""
        kept = [self.bars_share(cycle) >= 0.5 for cycle in self.cycles]
        return kept.index(False) - 1 if False in kept else len(kept) - 1

    def bars_share(self, cycle: float) -> float:
        """In theory, without noise and at every phase."""
        return theoretical_share(cycle, self.sigma)


def ground_scene(
    random: np.random.Generator, ground: Ground, dark_bars: bool = False, bars: int = 3, groups: int = 12,
    sigma: float | None = None, noise: float | None = None, angle: float | None = None, length: float = 5.0,
    limit: int = 7, roughly: bool = True, finest: float | None = None,
) -> Scene:
    """A target whose group ``limit``, of ``finest`` px, is about the finest one that its blur leaves resolved."""
    sigma = random.uniform(0.45, 1.4) if sigma is None else sigma
    noise = random.uniform(0.5, 4) if noise is None else noise
    angle = math.radians(random.uniform(-8, 8)) if angle is None else angle
    finest = finest or 4.0 * math.hypot(sigma, math.sqrt(1 / 12)) * STEP ** random.uniform(-0.5, 0.5)
    cycles = [finest * STEP ** (limit - group) for group in range(groups)]
    x, placed = 24.0, []
    for cycle in cycles:
        reach = (bars - 0.5) * cycle / 2 + 1.2 * cycle + 8
        x += reach
        placed.append(Bars(x + random.uniform(-0.5, 0.5), 0, cycle, length * cycle / 2, angle, bars))
        x += reach
    height = int(2 * (length * cycles[0] / 4 + 16) + 0.15 * bars * cycles[0])
    shape = height, int(x) + 24
    placed = [Bars(bar.x, height / 2 + random.uniform(-0.5, 0.5), bar.cycle, bar.length, angle, bars) for bar in placed]
    panels = [
        # one box as wide as the bars and the margins: ``coverage`` makes a bar half a cycle wide
        Bars(bar.x, bar.y, 2 * ((bars - 0.5) * bar.cycle + ground.margin * bar.cycle), bar.length + 2 * ground.margin
             * bar.cycle / 2, angle, 1)
        for bar in placed
    ]
    seen = ground.value + (ground.gap - ground.value) * coverage(shape, panels, sigma)
    seen += (ground.bar - ground.gap) * coverage(shape, placed, sigma)
    if dark_bars:
        seen = ground.gap + ground.bar - seen
    seen += random.normal(0, noise, shape)
    error = 8 if roughly else 0
    lines = {
        group: shown.line(random.uniform(1.5, 1.8) if roughly else 1.6, math.radians(random.uniform(-error, error)))
        for group, shown in enumerate(placed)
    }
    return Scene(np.clip(np.rint(seen), 0, 255).astype(np.uint8), tuple(cycles), lines, sigma, bars)


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


KINDS = tuple(product((False, True), (3, 5)))  # kinds of targets: bright bars or dark ones, three or five of them


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
