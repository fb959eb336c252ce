"""The range of values is what somebody says, or what a whole set shows; never a guess."""
from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from seam_inspector.plugin.imagery.errors import Message
from seam_inspector.plugin.radiometry.measure.assessment import RadiometricOutcome, decide_image, judge
from seam_inspector.plugin.radiometry.measure.image_statistics import LargestValue, range_of_set
from seam_inspector.plugin.radiometry.measure.rules import RuleSet

from tests.numbers.radiometry.jrc import default_rules
from tests.numbers.radiometry.judging import checked, checked_figure, checked_set, figure, measured, reasons

MakeRaster = Callable[..., str]
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
    assert decide_image(alone).outcome is RadiometricOutcome.UNDECIDED
    assert "what depends on the range of values is not judged" in str(alone.notices[0])
    result = checked(path, rules=given(0, 4095))
    assert figure(result, "peak") == pytest.approx(0.41, abs=0.03)
    assert decide_image(result).outcome is RadiometricOutcome.REJECTED


def test_what_needs_no_range_is_measured_without(make_raster: MakeRaster) -> None:
    pixels = sheet(380, 150, 1000)
    pixels[:3] = 2
    result = checked(make_raster("a.tif", pixels))
    assert figure(result, "clipped_low") == pytest.approx((pixels <= 4).mean())
    assert checked_figure(result, "clipped_low").passed is False
    assert decide_image(result).outcome is RadiometricOutcome.REJECTED


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
    assert decide_image(result).outcome is RadiometricOutcome.UNDECIDED
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
