"""Numbers are written as the user writes them, and so precisely that they say on which side of a limit they lie."""
from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QLocale
from seam_inspector.plugin.imagery.message import Message
from seam_inspector.plugin.radiometry.measure.rules import Rule
from seam_inspector.plugin.radiometry.words import figure_words
from seam_inspector.plugin.toolkit.translation import decimals_beside, filled, percent, sentence

SHARE = Message("A share of {share:.1%} in {name}, {count} of {most:.1f}.")
INNER = Message("{why} Take {metres:.2f} m.")


@pytest.fixture
def polish(qgis_app: QgsApplication) -> Iterator[None]:
    before = QLocale()
    QLocale.setDefault(QLocale("pl_PL"))
    yield
    QLocale.setDefault(before)


def test_numbers_in_sentences_have_decimal_commas_and_names_keep_their_points(polish: None) -> None:
    why = SHARE(share=0.0123, name="a.1.tif", count=3, most=np.float32(2.5))
    assert sentence(INNER(why=why, metres=1.5)) == "A share of 1,2% in a.1.tif, 3 of 2,5. Take 1,50 m."
    assert filled("{low:.2f} to {high:.2f}", low=0.5, high=1) == "0,50 to 1,00"
    assert percent(0.0123) == "1,2"


def test_messages_of_errors_stay_english() -> None:
    assert str(SHARE(share=0.5, name="a.tif", count=1, most=2.0)) == "A share of 50.0% in a.tif, 1 of 2.0."


@pytest.mark.parametrize(
    ("value", "limit", "decimals"),
    [(0.503, 0.5, 3), (0.5, 0.5, 2), (0.56, 0.5, 2), (0.0004, 0.05, 2), (0.054, 0.05, 3), (0.05004, 0.05, 5)],
)
def test_as_precise_as_its_limit_needs(value: float, limit: float, decimals: int) -> None:
    assert decimals_beside(value, [limit], 2) == decimals


def test_a_figure_that_fails_is_not_written_as_its_limit(qgis_app: QgsApplication) -> None:
    rule = Rule("clipped_low", None, 0.0005, "a contract")
    assert figure_words(rule, 0.000503) == "0.0503\u00a0%"
    assert figure_words(rule, 0.0005) == "0.05\u00a0%"
    assert figure_words(rule, 0.000514) == "0.051\u00a0%"
