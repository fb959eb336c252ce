"""Attribute values mean the same in every table, whatever the type of their field and the locale."""
from __future__ import annotations

import math
from typing import Any

import pytest
from qgis.core import NULL
from qgis.PyQt.QtCore import QLocale
from seam_inspector.plugin.toolkit.table_fields import attributes, is_known, is_true, number, text, whole_number

from tests.qgis.scenes import SHARP, layer, outline

HUGE = 10**18 + 1  # a real number can't hold it


@pytest.mark.parametrize(
    ("value", "is_there", "as_text", "as_number", "as_whole"),
    [
        (NULL, False, "", None, None),
        (None, False, "", None, None),
        ("", True, "", None, None),
        ("NULL", True, "NULL", None, None),
        (" west ", True, "west", None, None),
        (" 1.5 ", True, "1.5", 1.5, None),
        (" 1,5 ", True, "1,5", None, None),
        ("2e3", True, "2e3", 2000.0, 2000),
        ("-7.0", True, "-7.0", -7.0, -7),
        (1, True, "1", 1.0, 1),
        (1.0, True, "1", 1.0, 1),
        (0.1 + 0.2, True, "0.3", 0.1 + 0.2, None),
        (12345678.25, True, "12345678.25", 12345678.25, None),
        (math.nan, True, "nan", None, None),
        (-math.inf, True, "-inf", None, None),
        ("nan", True, "nan", None, None),
        (True, True, "True", None, None),
        (HUGE, True, str(HUGE), float(HUGE), HUGE),
        (1e300, True, "1e+300", 1e300, int(1e300)),
    ],
)
def test_values(qgis_app: object, value: Any, is_there: bool, as_text: str, as_number: Any, as_whole: Any) -> None:
    assert (is_known(value), text(value), number(value), whole_number(value)) == (
        is_there, as_text, as_number, as_whole
    )


def test_the_locale_does_not_count(qgis_app: object) -> None:
    before = QLocale()
    QLocale.setDefault(QLocale("pl_PL"))
    try:
        assert (number("1.5"), number("1,5"), text(1.5)) == (1.5, None, "1.5")
    finally:
        QLocale.setDefault(before)


def test_a_whole_number_may_have_a_limit(qgis_app: object) -> None:
    assert [whole_number(value, 100) for value in (100, "-100", 101, "-101.0", HUGE)] == [100, -100, None, None, None]


def test_what_says_yes_and_what_no(qgis_app: object) -> None:
    assert all(map(is_true, [1, 2.5, "yes", "t", "anything", True]))
    assert not any(map(is_true, [0, 0.0, "0", "0.0", "False", " no ", "OFF", "f", "n", "", NULL, None, False]))


def test_fields_of_a_layer_may_be_missing_or_of_any_type(qgis_app: object) -> None:
    made = layer(
        "Polygon", [outline(SHARP), None], name=("double", [2019.0, None]), ratio=("string", ["0.25", None]),
        count=("string", ["3.0", ""]), large=("int8", [HUGE, None]),
    )  # fmt: skip
    first, second = attributes(made.getFeatures(), made.fields().names())
    assert (text(first["name"]), number(first["ratio"]), whole_number(first["count"])) == ("2019", 0.25, 3)
    assert whole_number(first["large"]) == HUGE
    assert not first.feature.geometry().isNull()
    assert (text(second["name"]), number(second["ratio"]), whole_number(second["count"])) == ("", None, None)
    assert (text(first["other"]), number(first["other"]), whole_number(first["other"])) == ("", None, None)
