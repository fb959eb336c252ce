"""What the benchmark of the detection knows of its mosaics: they are the sum of the parts that it says they are."""
from __future__ import annotations

import numpy as np
import pytest

from benchmarks.campaign import outcomes, spread
from benchmarks.detail import luminance_of
from benchmarks.known_windows import KnownWindow, misfit_of
from benchmarks.misfit_cases import CASES, twin
from benchmarks.operations import KINDS, NOTHING, OPERATIONS, OTHERS, STRANGE_MAKINGS
from benchmarks.production import Making
from tests.numbers.seams.made_up_window import made_up_window

SIDE = 192
MAKINGS = [one for one in (*KINDS, *OTHERS, *STRANGE_MAKINGS) if not one.three]


@pytest.fixture(scope="module")
def window() -> KnownWindow:
    return made_up_window(SIDE)


@pytest.mark.release
@pytest.mark.parametrize("making", MAKINGS, ids=lambda one: one.name)
def test_a_mosaic_is_the_sum_of_its_parts(making: Making, window: KnownWindow) -> None:
    made = making.mix(window, np.random.default_rng(5))
    total = sum(part.weight * part.plane for part in made.parts)
    off = np.abs(total - luminance_of(made.bands))
    assert np.median(off) < 0.5  # as bands are rounded
    if len(made.parts) == len(made.planes):
        assert sum(part.weight for part in made.parts) == pytest.approx(np.ones((SIDE, SIDE)), abs=1e-5)


@pytest.mark.release
def test_processes_find_what_one_finds(window: KnownWindow) -> None:
    plain = [one for one in OPERATIONS if one.aftermath is NOTHING and one.making in KINDS[:3]]
    tasks = spread(plain, [window], 1)
    once, again = ([(one.operation.name, one.window, one.truth, one.reading.causes) for one in outcomes(tasks, jobs)]
                   for jobs in (1, 2))
    assert once == again
    assert len(once) == 3


def test_a_twin_lies_where_its_image_lies_and_moved_where_the_case_says(window: KnownWindow) -> None:
    bands = window.sources[0]
    other = twin(bands, np.random.default_rng(1))
    assert misfit_of(luminance_of(bands), luminance_of(other)) == pytest.approx((0, 0), abs=0.1)
    for case in CASES:
        first, second = window.main
        planes = case.making("cut hard", 0.0).mix(case.window(window), np.random.default_rng(0)).planes
        assert np.hypot(*misfit_of(planes[first], planes[second])) == pytest.approx(case.misfit, abs=0.15)
