"""Ratios and verdicts, held against the table of the paper and against every edge of the rules."""
from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.errors import Message
from seam_inspector.plugin.imagery.wavelets import Curve
from seam_inspector.plugin.seams.measure import messages as seams_messages
from seam_inspector.plugin.seams.measure.judgement.verdicts import (
    Judgement,
    Verdict,
    curve_ratios,
    judge_curves,
)


def curve(*detail: float, variance: float = 900.0) -> Curve:
    return Curve(detail, 1 - sum(detail), variance)


CONSTANT = Curve((math.nan,) * 3, math.nan, 0.0)
SOURCE = curve(0.04, 0.09, 0.1)

PYKA_2010_TABLE_1 = {
    "row 1": (curve(0.038, 0.090, 0.091), [curve(0.048, 0.095, 0.103), curve(0.046, 0.098, 0.105)], Verdict.REDUCED),
    "row 2": (curve(0.031, 0.068, 0.083), [curve(0.037, 0.070, 0.085), curve(0.036, 0.071, 0.084)], Verdict.REDUCED),
    "row 3": (
        curve(0.008, 0.035, 0.058),
        [curve(0.029, 0.069, 0.074), curve(0.027, 0.070, 0.073)],
        Verdict.SIGNIFICANT,
    ),
}


@pytest.mark.parametrize("row", PYKA_2010_TABLE_1)
def test_table_1_of_the_paper(row: str) -> None:
    mosaic, sources, verdict = PYKA_2010_TABLE_1[row]
    judgement = judge_curves(mosaic, sources)
    assert judgement.verdict is verdict
    assert judgement.reason is None


@pytest.mark.parametrize(
    ("share", "verdict"),
    [
        (0.0, Verdict.SIGNIFICANT),
        (0.25, Verdict.SIGNIFICANT),
        (0.5, Verdict.SIGNIFICANT),
        (math.nextafter(0.5, 1), Verdict.REDUCED),
        (1 - 1e-15, Verdict.REDUCED),
        (1.0, Verdict.PRESERVED),
        (1.7, Verdict.PRESERVED),
    ],
)
def test_edges_of_the_verdicts(share: float, verdict: Verdict) -> None:
    source = Curve((0.25, 0.25), 0.5, 1.0)
    assert judge_curves(Curve((0.25 * share, 0.25), 0.5, 1.0), [source]).verdict is verdict


@given(st.lists(st.tuples(*[st.floats(0.001, 0.3)] * 3), min_size=1, max_size=6))
def test_a_flag_means_against_every_source(details: list[tuple[float, float, float]]) -> None:
    mosaic, sources = curve(0.05, 0.07, 0.09), [curve(*detail) for detail in details]
    judgement = judge_curves(mosaic, sources)
    against_each = [judge_curves(mosaic, [source]).verdict for source in sources]
    for verdict in (Verdict.PRESERVED, Verdict.REDUCED, Verdict.SIGNIFICANT):  # the mildest one counts
        if verdict in against_each:
            assert judgement.verdict is verdict
            break
    least = [min(detail[level] for detail in details) for level in range(3)]
    assert judgement.ratios.detail == pytest.approx([0.05 / least[0], 0.07 / least[1], 0.09 / least[2]])
    assert judge_curves(mosaic, sources[::-1]) == judgement


def assert_not_comparable(judgement: Judgement, reason: Message) -> None:
    assert judgement.verdict is Verdict.NOT_COMPARABLE
    assert judgement.reason.template == reason.template


def test_without_sources() -> None:
    judgement = judge_curves(SOURCE, [])
    assert_not_comparable(judgement, seams_messages.NO_SOURCES)
    assert judgement.ratios.detail == (None, None, None)
    assert judgement.ratios.background is None


def test_a_constant_mosaic() -> None:
    assert_not_comparable(judge_curves(CONSTANT, [SOURCE]), seams_messages.MOSAIC_CONSTANT)
    assert_not_comparable(judge_curves(CONSTANT, []), seams_messages.MOSAIC_CONSTANT())  # sources may be as constant


def test_a_source_without_detail_does_not_count() -> None:
    flat = Curve((0.0, 0.1, 0.1), 0.8, 50.0)
    assert_not_comparable(judge_curves(SOURCE, [flat]), seams_messages.SOURCES_WITHOUT_DETAIL)
    assert_not_comparable(judge_curves(SOURCE, [CONSTANT]), seams_messages.SOURCES_WITHOUT_DETAIL)
    judgement = judge_curves(curve(0.01, 0.05, 0.1), [flat, SOURCE, CONSTANT])
    assert judgement.verdict is Verdict.SIGNIFICANT
    assert judgement.ratios.detail == pytest.approx((0.25, 5 / 9, 1.0))


def test_ratios_to_nothing_are_left_empty() -> None:
    ratios = curve_ratios(SOURCE, Curve((0.5, 0.0, 0.5), 0.0, 10.0))
    assert ratios.detail == pytest.approx((0.08, None, 0.2))
    assert ratios.background is None
    assert curve_ratios(SOURCE, CONSTANT).detail == (None, None, None)
