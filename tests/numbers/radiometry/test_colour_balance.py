"""The colour balance on grey areas, and the range of values that shares are shares of."""
from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from osgeo import ogr
from seam_inspector.plugin.imagery.errors import Message
from seam_inspector.plugin.radiometry.measure.areas import GreyArea
from seam_inspector.plugin.radiometry.measure.assessment import Assessment, decide_image, judge
from seam_inspector.plugin.radiometry.measure.image_statistics import LargestValue, range_of_set
from seam_inspector.plugin.radiometry.measure.rules import REJECTED, UNDECIDED, Rule, RuleSet

from tests.numbers.radiometry.judging import (
    checked,
    checked_figure,
    checked_set,
    default_rules,
    figure,
    measured,
    reasons,
)
from tests.numbers.synthetic import ORIGIN

MakeRaster = Callable[..., str]
GRASS, SOIL, STRAW = (90, 120, 70), (141, 130, 118), (150, 143, 131)
ROAD, ROOF, CONCRETE = (96, 96, 96), (140, 140, 140), (178, 178, 178)
RULES = RuleSet("own", (Rule("colour_balance", None, 0.02, "s"),))


def fields(*colours: tuple[float, float, float], cast: tuple[float, float, float] = (0, 0, 0)) -> np.ndarray:
    """Stripes of 64 columns, each of one colour, noisy, under a cast given in shares of the range."""
    stripes = np.repeat(np.array(colours, float).T[:, np.newaxis], 64, axis=2).reshape(3, 1, -1)
    light = np.array(cast)[:, np.newaxis, np.newaxis] * 255
    noise = np.random.default_rng(0).normal(0, 4, (3, 256, stripes.shape[2]))
    return np.rint(stripes + light + noise).clip(0, 255).astype(np.uint8)


def area(number: int, left: float, top: float, right: float, bottom: float) -> GreyArea:
    """A rectangle given by columns and rows of 0.1 m pixels."""
    corners = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)]
    ring = ", ".join(f"{ORIGIN[0] + 0.1 * x} {ORIGIN[1] - 0.1 * y}" for x, y in corners)
    return GreyArea(number, bytes(ogr.CreateGeometryFromWkt(f"POLYGON (({ring}))").ExportToWkb()))


def outcome(result: Assessment) -> str:
    return decide_image(result).outcome


@pytest.mark.parametrize("share", [0.0, 0.015, 0.031, 0.040, 0.047, 0.12])
@pytest.mark.parametrize("band", [0, 1, 2])
def test_a_cast_is_what_it_is_on_grey_areas(make_raster: MakeRaster, share: float, band: int) -> None:
    """Also where something of another colour would hide it: nothing is chosen by its colour."""
    cast = [0.0, 0.0, 0.0]
    cast[band] = share
    path = make_raster("a.tif", fields(ROAD, GRASS, ROOF, SOIL, CONCRETE, STRAW, cast=tuple(cast)))
    areas = [area(1, 3, 10, 60, 200), area(2, 130, 10, 190, 90), area(3, 258, 100, 318, 200)]
    result = checked(path, rules=RULES, grey_areas=areas)
    balance = checked_figure(result, "colour_balance", "all")
    assert balance.value == pytest.approx(share, abs=0.003)
    assert balance.passed is (share < 0.02)
    assert [tone.number for tone in result.balance.tones] == [1, 2, 3]


@pytest.mark.parametrize("colours", [(SOIL, STRAW, GRASS), (SOIL,), (GRASS, GRASS)])
def test_soil_and_fields_without_any_cast_do_not_fail(make_raster: MakeRaster, colours: tuple[tuple]) -> None:
    result = checked(make_raster("a.tif", fields(*colours)), rules=RULES)
    balance = checked_figure(result, "colour_balance", "all")
    assert (balance.value, balance.passed) == (None, None)
    assert str(balance.reason).startswith("not measurable: no grey areas are given")
    assert outcome(result) == UNDECIDED


def test_what_may_be_grey_is_shown_with_its_share_and_place(make_raster: MakeRaster) -> None:
    result = checked(make_raster("a.tif", fields(GRASS, ROOF, GRASS, GRASS, cast=(0.04, 0, 0))), rules=RULES)
    said = str(checked_figure(result, "colour_balance", "all").reason)
    assert result.maybe_grey.share == pytest.approx(0.25, abs=0.03)
    assert 64 <= result.maybe_grey.middle[0] < 128
    assert "areas of 16 px that may be grey were found (2" in said
    assert f"near {ORIGIN[0] + 0.1 * result.maybe_grey.middle[0]:.1f}" in said
    assert result.maybe_grey.difference == pytest.approx(0.04, abs=0.005)
    assert (np.abs(result.maybe_grey.corners[:, 0] - 88) <= 24).all()


def test_the_area_with_most_colour_is_named_with_its_place(make_raster: MakeRaster) -> None:
    path = make_raster("a.tif", fields(ROOF, (148, 140, 140)))
    result = checked(path, rules=RULES, grey_areas=[area(7, 0, 0, 64, 64), area(9, 70, 100, 120, 140)])
    balance = checked_figure(result, "colour_balance", "all")
    assert balance.value == pytest.approx(4 / 255, abs=0.002)  # each area counts once, however large
    assert balance.spot.place == pytest.approx((ORIGIN[0] + 9.5, ORIGIN[1] - 12.0), abs=0.02)
    assert str(balance.spot.what).startswith("grey area 9 with 3.")


def test_areas_too_small_too_bright_or_beside_the_image_are_no_measure(make_raster: MakeRaster) -> None:
    path = make_raster("a.tif", fields((254, 254, 254), ROOF))
    for drawn in ([], [area(1, 0, 0, 60, 200)], [area(1, 70, 0, 80, 20)], [area(1, 9000, 0, 9100, 50)]):
        said = str(checked_figure(checked(path, rules=RULES, grey_areas=drawn), "colour_balance", "all").reason)
        assert said.startswith("not measurable: the grey areas show fewer than 256 valid pixels"), drawn
    mixed = checked(path, rules=RULES, grey_areas=[area(1, 0, 0, 60, 200), area(2, 70, 0, 120, 60)])
    assert figure(mixed, "colour_balance", "all") < 0.01
    assert [tone.number for tone in mixed.balance.tones] == [2]


RANGE_CHECKS = {"clipped_high", "peak", "contrast", "signal_to_noise"}


def sheet(level: float, sigma: float, most: float, seed: int = 0) -> np.ndarray:
    values = np.random.default_rng(seed).normal(level, sigma, (128, 128))
    return np.rint(values.clip(20, most)).astype(np.uint16)


def given(low: float, high: float) -> RuleSet:
    rules = default_rules()
    return RuleSet(rules.name, rules.rules, (low, high))


def test_a_dark_sheet_of_12_bits_does_not_pass_as_one_of_10(make_raster: MakeRaster) -> None:
    """Taken for 10 bits its peak lies 12 % from the middle and passes; of 12 bits it is 41 %."""
    path = make_raster("dark.tif", sheet(380, 150, 1000))
    alone = checked(path)
    assert alone.available is None
    assert set(reasons(alone)) == RANGE_CHECKS | {"colour_balance"}
    assert "10, 11, 12, 14, 16 bits are possible" in reasons(alone)["peak"]
    assert "Give the range of values" in reasons(alone)["peak"]
    assert decide_image(alone).outcome == UNDECIDED
    assert "what depends on the range of values is not judged" in str(alone.notices[0])
    result = checked(path, rules=given(0, 4095))
    assert figure(result, "peak") == pytest.approx(0.41, abs=0.03)
    assert decide_image(result).outcome == REJECTED


def test_what_needs_no_range_is_measured_without(make_raster: MakeRaster) -> None:
    pixels = sheet(380, 150, 1000)
    pixels[:3] = 2
    result = checked(make_raster("a.tif", pixels))
    assert figure(result, "clipped_low") == pytest.approx((pixels <= 4).mean())
    assert checked_figure(result, "clipped_low").passed is False
    assert decide_image(result).outcome == REJECTED


def test_the_file_says_its_bits(make_raster: MakeRaster) -> None:
    pixels = sheet(2000, 500, 3800)
    result = checked(make_raster("a.tif", pixels, options=["NBITS=12"]))
    assert result.available == (0, 4095)
    assert result.notices == ()
    assert figure(result, "contrast") == pytest.approx(pixels.std() / 4095)


def test_the_set_says_it_where_its_values_end_at_a_depth(make_raster: MakeRaster) -> None:
    dark = make_raster("dark.tif", sheet(380, 150, 1000))
    bright = sheet(2500, 900, 4095)
    assert (bright == 4095).sum() > 100
    alone, beside = checked_set([dark]), checked_set([dark, make_raster("bright.tif", bright)])
    assert alone[0].available is None
    assert [result.available for result in beside] == [(0, 4095)] * 2
    assert checked_figure(beside[0], "peak").passed is False


@pytest.mark.parametrize(
    ("images", "high"),
    [
        ([LargestValue(4095, True)], 4095),
        ([LargestValue(4095, False)], None),  # may be chance
        ([LargestValue(1023, True), LargestValue(3000, False)], None),
        ([LargestValue(1023, True), LargestValue(4095, True)], 4095),
        ([LargestValue(4000, True)], None),
        ([LargestValue(10_000, True)], None),
        ([LargestValue(17_000, False), LargestValue(4095, True)], 65535),
        ([LargestValue(0, True)], None),
    ],
)
def test_the_range_of_a_set(images: list[LargestValue], high: float | None) -> None:
    available = range_of_set(images)
    assert isinstance(available, Message) if high is None else available == (0, high)


def test_16_bits_with_a_sign_have_no_range_of_their_own(make_raster: MakeRaster) -> None:
    """Any small positive values lie near the middle of -32768 to 32767."""
    result = checked(make_raster("a.tif", sheet(2000, 500, 3000).astype(np.int16)))
    assert "values of type int16 have no fixed range" in reasons(result)["peak"]
    assert decide_image(result).outcome == UNDECIDED
    assert checked(make_raster("b.tif", sheet(2000, 500, 3000).astype(np.int16)), rules=given(0, 4095)).available


def test_a_range_that_was_given_and_is_too_small_is_doubted(make_raster: MakeRaster) -> None:
    result = checked(make_raster("a.tif", sheet(2000, 500, 3800)), rules=given(0, 1023))
    assert checked_figure(result, "clipped_high").passed is False
    assert "lie beyond the range of 0 to 1023 that was given" in str(result.notices[0])


def test_bands_that_end_at_different_values(make_raster: MakeRaster) -> None:
    colours = np.stack([sheet(380, 150, 1000), sheet(2500, 900, 4095, 1), sheet(800, 150, 1500, 2)])
    measurement = measured(make_raster("a.tif", colours), default_rules())
    assert measurement.trimmed().largest_value == measurement.largest_value == LargestValue(4095, True)
    kept, whole = (judge(image, default_rules(), (0, 4095)) for image in (measurement.trimmed(), measurement))
    assert kept.checked_figures == whole.checked_figures
