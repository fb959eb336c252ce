"""How the benchmark of the detection counts: right causes, pixels that nobody spoke of, areas under curves."""
from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from seam_inspector.plugin.imagery.shifts import Shift
from seam_inspector.plugin.seams.measure.compared_image import Change
from seam_inspector.plugin.seams.measure.tone import Tone

from benchmarks.campaign import outcomes, spread
from benchmarks.figures import area
from benchmarks.known_windows import KnownWindow, WindowFacts
from benchmarks.operations import NOTHING, OPERATIONS
from benchmarks.outcomes import Finding, Outcome
from benchmarks.production import Made, Operation
from benchmarks.readings import Reading
from tests.numbers.seams.made_up_window import made_up_window

SOUND = Reading("preserved", ("none",), 1.0, 0.9, 1.1, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2)
CHANGE = Change(Tone(1.0, 0.0), (1.0, 1.0, 1.0), 0.0, None, None)
SIDE = 64


@pytest.fixture(scope="module")
def window() -> KnownWindow:
    return made_up_window(SIDE)


def named(name: str) -> Operation:
    return next(one for one in OPERATIONS if one.name == name)


def outcome_of(
    window: KnownWindow, operation: Operation, reading: Reading, truth: float = 1.0, foreign: float = 0.0,
    made: Made | None = None, misfit: tuple[float, float] = (0.0, 0.0),
) -> Outcome:
    """Outcome of images that lie a misfit (px) off each other."""
    facts = replace(WindowFacts.of(window), misfit=misfit)
    mains, allowed = (made.mains, made.allowed) if made else (frozenset(), frozenset())
    return Outcome(operation, facts, Finding(reading, None, truth, foreign, mains, allowed))


def judged(
    window: KnownWindow, operation: Operation, *causes: str, truth: float = 0.6,
    misfit: tuple[float, float] = (0.0, 0.0),
) -> tuple[bool, bool, bool]:
    """Whether the main cause is right, whether it is true, whether all are named."""
    made = operation.make(window)
    one = outcome_of(window, operation, replace(SOUND, causes=causes), truth, made=made, misfit=misfit)
    return one.is_main_right, one.is_true, one.are_all_named


def test_a_cause_is_right_where_it_is_the_main_one_and_true_where_it_took_part(window: KnownWindow) -> None:
    both = named("feather 33 px cosine, JPEG 95")
    assert judged(window, both, "feathering", "compressed") == (True, True, True)
    assert judged(window, both, "compressed", "feathering") == (False, True, True)
    assert judged(window, both, "feathering") == (True, True, False)
    assert judged(window, both, "none") == (False, False, False)
    assert judged(window, named("hard cut"), "none") == (True, True, True)
    assert judged(window, named("hard cut"), "feathering") == (False, False, False)
    assert judged(window, named("pyramid blend"), "feathering") == (True, True, False)


def test_a_feather_that_took_nothing_need_not_be_named(window: KnownWindow) -> None:
    both = named("feather 33 px cosine, JPEG 95")
    assert judged(window, both, "compressed", truth=0.97) == (True, True, True)
    assert judged(window, both, "feathering", "compressed", truth=0.97) == (True, True, True)
    assert judged(window, both, "none", truth=0.97) == (False, False, False)
    assert judged(window, named("feather 33 px cosine"), "none", truth=0.97) == (True, True, True)
    assert judged(window, named("feather 33 px cosine"), "none", truth=0.9) == (False, False, False)


def test_what_took_more_of_the_window_than_the_feather_may_be_the_main_cause(window: KnownWindow) -> None:
    assert judged(window, named("feather 13 px cosine, blur 0.8 px"), "blur", "feathering") == (True, True, True)
    assert judged(window, named("feather 13 px cosine, JPEG 95"), "compressed", "feathering") == (False, True, True)


def test_a_misfit_is_as_right_as_what_was_made_of_it_and_wrong_where_images_fit(window: KnownWindow) -> None:
    feather, moved = named("feather 33 px cosine"), named("one source 2 px off, feather 33 px")
    assert judged(window, feather, "misregistration", misfit=(0.0, 0.2)) == (False, False, False)
    assert judged(window, feather, "misregistration", "feathering", misfit=(0.0, 1.2)) == (True, True, True)
    assert judged(window, moved, "misregistration", "feathering") == (True, True, True)
    assert judged(window, moved, "misregistration", misfit=(-2.0, 0.0)) == (False, False, False)
    assert judged(window, named("hard cut"), "misregistration", misfit=(2.0, 0.0))[:2] == (True, True)
    assert judged(window, named("hard cut"), "misregistration", misfit=(0.2, 0.0)) == (False, False, False)


def test_pixels_are_unsaid_where_neither_cause_nor_share_tells_of_them(window: KnownWindow) -> None:
    def unsaid(**said: object) -> bool:
        reading = replace(SOUND, **said)
        return outcome_of(window, named("hard cut"), reading, foreign=0.3).is_unsaid

    assert unsaid()
    assert unsaid(explained=float("nan"))
    assert not unsaid(explained=0.75)
    assert not unsaid(causes=("gamma", "missing source"))
    assert not unsaid(verdict="not_comparable")


def test_each_operation_gets_its_windows_and_other_ones_than_its_neighbour(window: KnownWindow) -> None:
    windows = [replace(window, number=number) for number in range(4)]
    plain = [one for one in OPERATIONS if one.aftermath is NOTHING and not one.making.three][:3]
    found = [(one.operation.name, one.window.number) for one in outcomes(spread(plain, windows, 2))]
    assert len(set(found)) == len(found) == 6
    assert {number for name, number in found if name == plain[0].name} == {0, 1}
    assert {number for name, number in found if name == plain[1].name} == {2, 3}


def test_tones_and_places_are_compared_source_by_source(window: KnownWindow) -> None:
    def errors(name: str, **change: object) -> dict[str, float]:
        one = replace(CHANGE, **change)
        reading = replace(SOUND, tones={window.main[0]: CHANGE, window.main[1]: one})
        return dict(outcome_of(window, named(name), reading).tone_errors())  # of the second source, which comes last

    assert errors("hard cut") == {"A, %": 0, "B, DN": 0, "gamma": 0}
    assert errors("gains 0.9 and 1.1", tone=Tone(1.1, 2.0)) == {"A, %": 0, "B, DN": 2, "gamma": 0}
    assert errors("hard cut, gain 0.6", tone=Tone(0.66, 20.0))["A, %"] == pytest.approx(10)
    assert errors("hard cut, gamma 1.3", tone=Tone(1.0, 0.0, 1.2)) == {"gamma": pytest.approx(-0.1)}
    assert errors("hard cut, of 12 bit") == {}
    assert errors("one source 2 px off, feather 33 px", shift=Shift(0.1, 2.0, 1.0))["shift, px"] == pytest.approx(0.1)


def test_the_area_is_the_share_of_pairs_in_order() -> None:
    assert area([2, 3], [0, 1]) == 1
    assert area([0, 3], [1, 2]) == 0.5
    assert area([1], [1]) == 0.5
    assert np.isnan(area([], [1]))
