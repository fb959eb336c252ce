"""The verdicts' colours are told apart by all eyes, and the formula that says so is the published one."""
from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from seam_inspector.plugin.seams.words import VERDICTS

from tests.colour_sight import DICHROMATS, Lab, ciede2000, seen_colour

LEAST = 18.0  # as docs/desk/map.md says; from some 10 on colours are told apart at a glance


# Sharma, Wu, Dalal 2005, table 1: pairs that implementations get wrong
@pytest.mark.parametrize(
    ("one", "other", "difference"),
    [
        ((50.0, 2.6772, -79.7751), (50.0, 0.0, -82.7485), 2.0425),
        ((50.0, 3.1571, -77.2803), (50.0, 0.0, -82.7485), 2.8615),
        ((50.0, -1.0, 2.0), (50.0, 0.0, 0.0), 2.3669),
        ((50.0, 2.49, -0.001), (50.0, -2.49, 0.0009), 7.1792),
        ((50.0, 2.49, -0.001), (50.0, -2.49, 0.0011), 7.2195),
        ((50.0, -0.001, 2.49), (50.0, 0.0009, -2.49), 4.8045),
        ((50.0, -0.001, 2.49), (50.0, 0.0011, -2.49), 4.7461),
        ((50.0, 2.5, 0.0), (73.0, 25.0, -18.0), 27.1492),
        ((50.0, 2.5, 0.0), (56.0, -27.0, -3.0), 31.9030),
        ((60.2574, -34.0099, 36.2677), (60.4626, -34.1751, 39.4387), 1.2644),
        ((22.7233, 20.0904, -46.6940), (23.0331, 14.9730, -42.5619), 2.0373),
        ((2.0776, 0.0795, -1.1350), (0.9033, -0.0636, -0.5514), 0.9082),
    ],
)
def test_the_formula_is_the_published_one(one: Lab, other: Lab, difference: float) -> None:
    assert ciede2000(one, other) == pytest.approx(difference, abs=5e-5)
    assert ciede2000(other, one) == pytest.approx(difference, abs=5e-5)


@pytest.mark.parametrize("sight", ["", *DICHROMATS])
def test_verdicts_are_told_apart(sight: str) -> None:
    seen = {verdict: seen_colour(look.colour, sight) for verdict, look in VERDICTS.items()}
    found = {(one, other): ciede2000(seen[one], seen[other]) for one, other in combinations(seen, 2)}
    closest = min(found, key=lambda pair: found[pair])
    assert found[closest] > LEAST, f"{closest}: {found[closest]:.1f}"


def test_formula_and_colours_are_those_of_scikit_image() -> None:
    color = pytest.importorskip("skimage.color", reason="scikit-image compares, where it is installed")
    rng = np.random.default_rng(5)
    pairs = rng.uniform((0, -100, -100), (100, 100, 100), (2, 500, 3))
    ours = [ciede2000(tuple(one), tuple(other)) for one, other in zip(*pairs)]
    assert np.allclose(ours, color.deltaE_ciede2000(*pairs), atol=1e-6)
    for look in VERDICTS.values():
        values = np.array([int(look.colour[place : place + 2], 16) for place in (1, 3, 5)]) / 255
        assert seen_colour(look.colour) == pytest.approx(tuple(color.rgb2lab(values)), abs=0.01)
