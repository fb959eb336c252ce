"""Where failures begin and end inside pieces of 25 m, against simulated ones."""
from __future__ import annotations

from itertools import groupby

import numpy as np
import pytest
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.decision import Decision

from tests.numbers.acceptance.deliveries import delivery, rules, seam

PIECE = 25.0


def spoilt(start: float, stop: float, inside: float, noise: np.ndarray) -> Decision:
    """A seam of 41 pieces, spoilt from one station to another."""
    borders = PIECE * np.arange(42)
    shares = np.clip(np.minimum(stop, borders[1:]) - np.maximum(start, borders[:-1]), 0, None) / PIECE
    kept = 1 - shares * (1 - inside) + noise
    return decide(delivery(seam(kept.tolist(), PIECE)), rules())


@pytest.fixture(scope="module")
def errors() -> np.ndarray:
    """Of failed metres: by whole pieces, by the estimate, and what is said of the latter; a row for each failure."""
    random = np.random.default_rng(16)
    rows = []
    for _ in range(400):
        length, inside, noise = random.uniform(10, 200), random.uniform(0.2, 0.65), random.uniform(0.03, 0.08)
        start = random.uniform(100, 125)
        found = spoilt(start, start + length, inside, random.normal(0, noise, 41))
        within = sum(run.within_m**2 for run in found.runs) ** 0.5
        rows.append((PIECE * found.whole.failed_count - length, found.whole.failed_m - length, within, len(found.runs)))
    return np.array(rows)


@pytest.mark.slow
def test_the_estimate_halves_the_error_of_whole_pieces_without_a_bias(errors: np.ndarray) -> None:
    one = errors[errors[:, 3] == 1]
    whole, estimated = (np.sqrt(np.mean(one[:, column] ** 2)) for column in (0, 1))
    assert estimated < 0.5 * whole
    assert abs(one[:, 1].mean()) < 1


def test_what_is_said_of_the_error_is_so(errors: np.ndarray) -> None:
    one = errors[errors[:, 3] == 1]
    assert np.mean(np.abs(one[:, 1]) <= one[:, 2]) >= 0.93


def test_a_failure_of_64_m_is_not_one_of_two_pieces() -> None:
    found = spoilt(115, 179, 0.4, np.zeros(41))
    assert found.whole.failed_count == 2
    assert found.longest_failure_m == pytest.approx(64, rel=0.05)
    assert not found.accepted
    assert [run.pieces for run in found.runs] == [(5, 6)]
    assert [part.piece for part in found.runs[0].parts] == [4, 5, 6, 7]


def test_a_failure_beside_the_limit_is_said_to_be_so() -> None:
    said = [str(one) for one in spoilt(115, 167, 0.4, np.zeros(41)).sentences]
    assert any("can't be told apart from the limit of 50.0 m" in one for one in said)
    assert any("the longest is known to some" in one for one in said)


def test_a_seam_that_is_spoilt_from_end_to_end_is_as_long_as_it_is() -> None:
    found = decide(delivery(seam([0.4] * 4, PIECE)), rules())
    assert found.longest_failure_m == pytest.approx(100, rel=0.05)


def test_evenly_reduced_seams_are_not_spoilt_beyond_a_failure() -> None:
    found = decide(delivery(seam([*[0.85] * 8, *[0.4] * 4, *[0.85] * 8], PIECE)), rules())
    assert found.longest_failure_m == pytest.approx(100, rel=0.04)


def test_a_piece_between_two_failures_is_no_part_of_both() -> None:
    found = decide(delivery(seam([*[1.0] * 8, 0.4, 0.4, 0.75, 0.4, 0.4, *[1.0] * 8], PIECE)), rules())
    shares = [part.share for run in found.runs for part in run.parts if part.piece == 10]
    assert sum(shares) <= 1
    assert len(list(groupby(found.runs, lambda run: run.number))) == 2
