"""How the benchmark of the detection counts: right causes, pixels that nobody spoke of, areas under curves."""
from __future__ import annotations

from dataclasses import replace

import pytest

from benchmarks.known_windows import KnownWindow, WindowFacts
from benchmarks.operations import OPERATIONS
from benchmarks.outcomes import Finding, Outcome
from benchmarks.production import Made, Operation
from benchmarks.readings import Reading
from tests.numbers.seams.made_up_window import made_up_window

SOUND = Reading("preserved", ("none",), 1.0, 0.9, 1.1, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2)
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
