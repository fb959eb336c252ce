"""The decision: what counts when something is beyond its limit, not measurable, or was not looked at."""
from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from seam_inspector.plugin.imagery.messages import SOURCE_LEFT_OUT
from seam_inspector.plugin.radiometry.measure.assessment import Assessment, decide, decide_image
from seam_inspector.plugin.radiometry.measure.rules import ACCEPTED, REJECTED, UNDECIDED, Rule, RuleSet

from tests.numbers.radiometry.judging import checked
from tests.numbers.synthetic import texture

MakeRaster = Callable[..., str]
GOOD = Rule("clipped_low", None, 0.9, "s")
BAD = Rule("contrast", 0.9, None, "s")
UNKNOWN = Rule("signal_to_noise", 5, None, "s")
UNKNOWN_AND_OPTIONAL = Rule("signal_to_noise", 5, None, "s", required=False)
NO_LIMIT = Rule("peak", None, None, "s")


@pytest.fixture
def busy(make_raster: MakeRaster) -> str:
    """An image without a uniform area."""
    pixels = np.rint(128 + 30 * texture((256, 256), 3.0, 1)).clip(0, 255).astype(np.uint8)
    return make_raster("busy.tif", pixels)


def result_of(path: str, *rules: Rule) -> Assessment:
    return checked(path, rules=RuleSet("own", rules))


@pytest.mark.parametrize(
    ("rules", "outcome"),
    [
        ((GOOD,), ACCEPTED),
        ((GOOD, NO_LIMIT), ACCEPTED),
        ((GOOD, UNKNOWN_AND_OPTIONAL), ACCEPTED),
        ((GOOD, UNKNOWN), UNDECIDED),
        ((GOOD, BAD), REJECTED),
        ((UNKNOWN, BAD), REJECTED),
        ((NO_LIMIT,), UNDECIDED),
        ((UNKNOWN_AND_OPTIONAL,), UNDECIDED),
    ],
)
def test_one_image(busy: str, rules: tuple[Rule, ...], outcome: str) -> None:
    decision = decide_image(result_of(busy, *rules))
    assert decision.outcome == outcome
    assert {checked.rule for checked in decision.failed} == ({BAD} & set(rules))
    assert {checked.rule for checked in decision.missed} == ({UNKNOWN} & set(rules))
    assert {checked.rule for checked in decision.unmeasured} == ({UNKNOWN_AND_OPTIONAL} & set(rules))


def test_all_images(busy: str) -> None:
    good, bad, unknown = (result_of(busy, GOOD, *more) for more in ((), (BAD,), (UNKNOWN,)))
    left_out = [SOURCE_LEFT_OUT(name="a.tif", why="gone")]
    assert decide([good, good]).outcome == ACCEPTED
    assert decide([good, unknown]).outcome == UNDECIDED
    assert decide([good, unknown, bad]).outcome == REJECTED
    assert decide([good], left_out).outcome == UNDECIDED
    assert decide([bad], left_out).outcome == REJECTED
    assert decide([]).outcome == UNDECIDED
    assert [image.result for image in decide([good, bad]).those(REJECTED)] == [bad]
