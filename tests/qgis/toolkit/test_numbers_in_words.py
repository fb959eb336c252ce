"""Numbers are written as the user writes them, and so precisely that they say on which side of a limit they lie."""
from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QLocale
from seam_inspector.plugin.imagery.errors import Message
from seam_inspector.plugin.toolkit.charts.figure_files import new_figure, svg_text
from seam_inspector.plugin.toolkit.translation import (
    decimals_beside,
    filled,
    formatted,
    language,
    percent,
    sentence,
)

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
    assert sentence(INNER(why=why, metres=1.5)) == "A share of 1,2\u00a0% in a.1.tif, 3 of 2,5. Take 1,50 m."
    assert filled("{low:.2f} to {high:.2f}", low=0.5, high=1) == "0,50 to 1,00"
    assert percent(0.0123) == "1,2"


def test_long_numbers_are_grouped_by_spaces_that_do_not_break(polish: None) -> None:
    text = "{metres:.1f} m, {all:.0f} m, {year:.0f}, {dn:g}"
    assert filled(text, metres=12345.67, all=1234567, year=2026, dn=-65535) == (
        "12\u00a0345,7 m, 1\u00a0234\u00a0567 m, 2026, -65\u00a0535"
    )
    assert formatted(0.125, ".1%") == "12,5\u00a0%"


def test_an_english_interface_follows_the_locale_of_its_numbers(
    polish: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(QgsApplication, "locale", staticmethod(lambda: "en_US"))
    assert language() == "en"
    assert filled("{value:.2f}", value=0.5) == "0,50"


@pytest.mark.parametrize(
    ("count", "word"),
    [(0, "okien"), (1, "okno"), (2, "okna"), (4, "okna"), (5, "okien"), (12, "okien"), (21, "okien"), (22, "okna"),
     (np.int64(103), "okna"), (112, "okien")],
)  # fmt: skip
def test_a_word_has_the_form_of_its_count(qgis_app: QgsApplication, count: int, word: str) -> None:
    assert filled("{count} {count:okno|okna|okien}", count=count) == f"{count} {word}"


def test_two_forms_are_for_one_and_for_many(qgis_app: QgsApplication) -> None:
    assert [filled("{n:window|windows}", n=n) for n in (0, 1, 2, 5)] == ["windows", "window", "windows", "windows"]


def test_nothing_that_is_translated_is_filled_by_another_way(repository: Path) -> None:
    """str.format knows neither decimal commas nor a word's forms."""
    items = [
        f"{path.name}:{node.lineno}"
        for path in sorted((repository / "plugin").rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Attribute) and node.attr == "format" and isinstance(node.value, ast.Call)
        and isinstance(node.value.func, ast.Name) and node.value.func.id == "tr"
    ]  # fmt: skip
    templates = (repository / "resources").rglob("*.j2")
    items += [path.name for path in templates if ").format(" in path.read_text(encoding="utf-8")]
    assert items == [], "use filled(tr(...), ...)"


def test_a_charts_axes_are_numbered_as_the_user_writes(polish: None) -> None:
    figure = new_figure(4, 3)
    axes = figure.add_subplot()
    axes.plot([0, 0.5], [-0.25, 0.25])
    words = svg_text(figure)
    assert ">0,2<" in words
    assert ">\u22120,2<" in words
    assert ">0.2<" not in words


@pytest.mark.parametrize(
    ("value", "limit", "decimals"),
    [(0.503, 0.5, 3), (0.5, 0.5, 2), (0.56, 0.5, 2), (0.0004, 0.05, 2), (0.054, 0.05, 3), (0.05004, 0.05, 5)],
)
def test_as_precise_as_its_limit_needs(value: float, limit: float, decimals: int) -> None:
    assert decimals_beside(value, [limit], 2) == decimals
    assert decimals_beside(np.float64(value), [np.float64(limit)], 2) == decimals
