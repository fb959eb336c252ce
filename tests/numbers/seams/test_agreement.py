"""Cohen's kappa against published tables, against resampling, and where there is little to say."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.seams.measure.calibration.threshold_calibration import agreement, cohen_kappa

SKIN = np.array([[10, 4, 1, 0], [5, 10, 12, 2], [2, 4, 12, 5], [0, 2, 6, 13]])
"""Two dermatologists: SAS/STAT User's Guide, The FREQ Procedure, Example "Cohen's Kappa Coefficient"."""


def test_a_published_table() -> None:
    kappa = cohen_kappa(SKIN)
    assert (kappa.value, kappa.low, kappa.high) == pytest.approx((0.3449, 0.2030, 0.4868), abs=5e-5)


@pytest.mark.parametrize("table", [[[20, 5], [10, 15]], [[45, 15], [25, 15]], [[40, 6], [4, 50]]])
def test_kappa_and_its_spread_are_those_of_resampled_windows(table: list[list[int]]) -> None:
    """The spread of 20,000 bootstrap samples, and the definition for the value."""
    counts = np.array(table)
    kappa = cohen_kappa(counts)
    assert kappa.value == pytest.approx(_by_definition(counts / counts.sum()))
    drawn = np.random.default_rng(3).multinomial(counts.sum(), (counts / counts.sum()).ravel(), 20_000)
    values = [_by_definition(table.reshape(2, 2) / counts.sum()) for table in drawn]
    assert (kappa.high - kappa.low) / (2 * 1.96) == pytest.approx(np.std(values), rel=0.04)


def _by_definition(shares: np.ndarray) -> float:
    by_chance = sum(shares[i].sum() * shares[:, i].sum() for i in range(len(shares)))
    return float((np.trace(shares) - by_chance) / (1 - by_chance))


def test_full_agreement_of_few_windows_is_not_taken_for_certain() -> None:
    few, many = cohen_kappa(np.diag([3, 3])), cohen_kappa(np.diag([300, 300]))
    assert few.value == many.value == few.high == 1
    assert few.low < 0.3
    assert many.low > 0.98


def test_only_what_both_judged_counts() -> None:
    words = [("visible", "visible"), ("invisible", "invisible"), ("visible", "invisible"), ("invisible", "visible")]
    result = agreement([*words, ("unsure", "visible"), ("visible", ""), ("", ""), ("visible", "visible")])
    assert result[:2] == (5, 3)


@pytest.mark.parametrize("words", [[], [("visible", "unsure")], [("visible", "visible")] * 9])
def test_no_number_where_there_is_none(words: list[tuple[str, str]]) -> None:
    """Nobody can tell agreement from chance where one word was all that was said."""
    assert agreement(words)[2] is None


def test_one_word_alone_tells_nothing_about_agreement() -> None:
    for table in ([[1, 0], [1, 0]], [[0, 1], [0, 0]], [[99, 1], [0, 0]]):
        assert cohen_kappa(np.array(table)) is None


def test_no_agreement_at_all_is_not_certain_either() -> None:
    kappa = cohen_kappa(np.array([[0, 1], [1, 0]]))
    assert kappa.value == kappa.low == -1
    assert kappa.high > 0  # two windows say little
