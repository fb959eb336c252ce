"""The verdicts' colours are told apart by all eyes, and the formula that says so is the published one."""
from __future__ import annotations

from itertools import combinations
from xml.etree import ElementTree

import pytest
from seam_inspector.plugin.acceptance.paper.decision_map import STATE_COLOURS
from seam_inspector.plugin.imagery.seam_totals import PieceState
from seam_inspector.plugin.seams.words import VERDICTS
from seam_inspector.plugin.toolkit.resources import style_path

from tests.colour_sight import DICHROMATS, Lab, ciede2000, seen_colour

LEAST = 18.0  # as docs/desk/map.md says; from some 10 on colours are told apart at a glance


# Sharma, Wu, Dalal 2005, table 1: pairs that implementations get wrong
@pytest.mark.parametrize(
    ("colour", "other", "difference"),
    [
        ((50.0, 2.6772, -79.7751), (50.0, 0.0, -82.7485), 2.0425),
        ((50.0, -1.0, 2.0), (50.0, 0.0, 0.0), 2.3669),
        ((50.0, 2.49, -0.001), (50.0, -2.49, 0.0011), 7.2195),
        ((50.0, 2.5, 0.0), (73.0, 25.0, -18.0), 27.1492),
        ((22.7233, 20.0904, -46.6940), (23.0331, 14.9730, -42.5619), 2.0373),
        ((2.0776, 0.0795, -1.1350), (0.9033, -0.0636, -0.5514), 0.9082),
    ],
)
def test_the_formula_is_the_published_one(colour: Lab, other: Lab, difference: float) -> None:
    assert ciede2000(colour, other) == pytest.approx(difference, abs=5e-5)
    assert ciede2000(other, colour) == pytest.approx(difference, abs=5e-5)


@pytest.mark.parametrize("sight", ["", *DICHROMATS])
def test_verdicts_are_told_apart_and_failures_from_them(sight: str) -> None:
    line = ElementTree.parse(style_path("defects")).findall(".//symbol/layer")[1].find("prop[@k='line_color']")
    failure = "#{:02x}{:02x}{:02x}".format(*map(int, line.get("v").split(",")[:3]))  # type: ignore[union-attr]
    assert failure == STATE_COLOURS[PieceState.FAILED]
    looks = {**{verdict: look.colour for verdict, look in VERDICTS.items()}, "failure": failure}
    seen = {name: seen_colour(colour, sight) for name, colour in looks.items()}
    apart = {pair: ciede2000(*(seen[verdict] for verdict in pair)) for pair in combinations(seen, 2)}
    closest = min(apart, key=lambda pair: apart[pair])
    assert apart[closest] > LEAST, f"{closest}: {apart[closest]:.1f}"
