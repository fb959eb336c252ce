"""The calibration as QGIS runs it: from judged windows to a table, a chart and the number to set."""
from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsVectorLayer
from scipy import stats

from tests.qgis.runs import Run, run
from tests.qgis.scenes import layer, outline

pytestmark = pytest.mark.usefixtures("provider")

VISIBLE = (0.2, 0.31, 0.35, 0.44, 0.52, 0.71)
INVISIBLE = (0.49, 0.66, 0.7, 0.78, 0.82, 0.9, 0.95, 1.05, 1.3)
NUMBERS = {"MAX_RATIO", "AUC", "AUC_LOW", "AUC_HIGH", "WANTED_COUNT"}
SIGNATURES = {".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF"}


def judged(visible: Sequence[Any] = VISIBLE, invisible: Sequence[Any] = INVISIBLE, **more: Any) -> QgsVectorLayer:
    """A layer of windows with these values of ratio_1."""
    values = [*visible, *invisible]
    words = ["visible"] * len(visible) + ["invisible"] * len(invisible)
    shapes = [outline((10 * i, 0, 10, 10)) for i in range(len(values))]
    fields = {
        "window_id": ("integer", list(range(1, len(values) + 1))),
        "ratio_1": ("double", values),
        "observer": ("string", words),
        **more,
    }
    return layer("Polygon", shapes, **fields)


def pairs(rows: Sequence[tuple[int, str, str, float | None]]) -> QgsVectorLayer:
    """A table of pairs: window, source, band, contrast_1."""
    columns = list(zip(*rows))
    fields = dict(zip(("window_id", "source", "band", "contrast_1"), columns))
    kinds = ("integer", "string", "string", "double")
    return layer("None", [None] * len(rows), **{name: (kind, list(fields[name])) for name, kind in zip(fields, kinds)})


def summary(outcome: Run, measure: str = "ratio_1") -> dict[str, Any]:
    (items,) = (row for row in outcome.rows() if row["measure"] == measure and row["row"] == "summary")
    return items


def test_the_number_to_set_and_what_stands_behind_it(tmp_path: Path) -> None:
    chart = tmp_path / "roc.png"
    outcome = run("calibratethreshold", WINDOWS=judged(), CHART=str(chart))
    assert outcome.complaint is None
    results = outcome.results
    statistic = stats.mannwhitneyu(INVISIBLE, VISIBLE).statistic
    assert results["AUC"] == pytest.approx(statistic / (len(VISIBLE) * len(INVISIBLE)))
    assert results["AUC_LOW"] < results["AUC"] < results["AUC_HIGH"] <= 1
    assert 0.52 <= results["MAX_RATIO"] < 0.66  # flags five of six, and one of nine in vain
    assert (results["VISIBLE_COUNT"], results["INVISIBLE_COUNT"]) == (6, 9)
    assert results["WANTED_COUNT"] > 15
    assert chart.read_bytes().startswith(SIGNATURES[".png"])

    row = summary(outcome)
    assert row["threshold"] == results["MAX_RATIO"]
    assert row["threshold_low"] <= row["threshold"] <= row["threshold_high"]
    assert (row["flagged_visible"], row["flagged_invisible"]) == (5, 1)
    assert (row["sensitivity"], row["specificity"]) == pytest.approx((5 / 6, 8 / 9))
    assert row["youden"] == pytest.approx(5 / 6 + 8 / 9 - 1)
    assert [row[name.lower()] for name in ("AUC", "AUC_LOW", "AUC_HIGH")] == [
        results[name] for name in ("AUC", "AUC_LOW", "AUC_HIGH")
    ]
    assert row["wanted_visible"] + row["wanted_invisible"] == results["WANTED_COUNT"]
    (standard,) = (row for row in outcome.rows() if row["row"] == "standard")
    assert (standard["threshold"], standard["flagged_visible"], standard["flagged_invisible"]) == (0.5, 4, 1)
    steps = [row for row in outcome.rows() if row["row"] == "step"]
    assert [row["threshold"] for row in steps] == sorted({*VISIBLE, *INVISIBLE})
    for row in steps:
        assert row["flagged_visible"] == sum(value <= row["threshold"] for value in VISIBLE)
        assert row["flagged_invisible"] == sum(value <= row["threshold"] for value in INVISIBLE)


@pytest.mark.parametrize(("visible", "invisible"), [(4, 9), (6, 4), (0, 0)])
def test_too_few_verdicts_give_no_number(visible: int, invisible: int, tmp_path: Path) -> None:
    chart = tmp_path / "roc.svg"
    outcome = run("calibratethreshold", WINDOWS=judged(VISIBLE[:visible], INVISIBLE[:invisible]), CHART=str(chart))
    assert outcome.complaint is None
    assert NUMBERS.isdisjoint(outcome.results)
    assert (outcome.results["VISIBLE_COUNT"], outcome.results["INVISIBLE_COUNT"]) == (visible, invisible)
    (row,) = outcome.rows()
    assert row["row"] == "summary"
    assert row["threshold"] is row["auc"] is row["wanted_visible"] is None
    words = f"{visible} visible and {invisible} invisible verdicts"
    assert words in row["note"]
    assert any(words in warning for warning in outcome.log.warnings)
    assert words in " ".join(re.sub("<[^>]*>", " ", chart.read_text(encoding="utf-8")).split())


def test_every_measure_that_is_there_is_judged() -> None:
    count = len(VISIBLE) + len(INVISIBLE)
    composite = [value / 2 for value in (*VISIBLE, *INVISIBLE)]
    rows: list[tuple[int, str, str, float | None]] = []
    for number in range(1, count + 1):
        contrast = number / 100
        rows += [(number, "a.tif", "luminance", 0.3), (number, "b.tif", "luminance", contrast + 0.5)]
        rows += [(number, "a.tif", "red", 9.0)]
        if number <= 12:
            rows += [(number, "composite", "luminance", contrast), (number, "composite", "red", 8.0)]
    outcome = run(
        "calibratethreshold",
        WINDOWS=judged(composite_ratio_1=("double", composite)),
        PAIRS=pairs(rows),
    )
    assert outcome.complaint is None
    assert {row["measure"] for row in outcome.rows()} == {"ratio_1", "composite_ratio_1", "contrast_1"}
    assert summary(outcome, "composite_ratio_1")["auc"] == summary(outcome)["auc"]
    contrasts = [row["threshold"] for row in outcome.rows() if (row["measure"], row["row"]) == ("contrast_1", "step")]
    expected = [number / 100 if number <= 12 else number / 100 + 0.5 for number in range(1, count + 1)]
    assert contrasts == pytest.approx(expected)


KEPT = [*(value * 0.9 for value in VISIBLE), *(value * 0.8 for value in INVISIBLE)]


def test_the_numbers_are_of_what_the_seam_kept_where_that_is_known() -> None:
    windows = judged(kept_1=("double", KEPT), contrast_1=("double", [2 * value for value in KEPT]))
    outcome = run("calibratethreshold", WINDOWS=windows)
    assert outcome.complaint is None
    assert {row["measure"] for row in outcome.rows()} == {"kept_1", "contrast_1", "ratio_1"}
    for measure in ("kept_1", "contrast_1", "ratio_1"):
        asked = run("calibratethreshold", WINDOWS=windows, MEASURE=measure)
        assert asked.results["MAX_RATIO"] == summary(outcome, measure)["threshold"]
        assert asked.results["AUC"] == summary(outcome, measure)["auc"]
        assert len(asked.rows()) == len(outcome.rows())
    assert outcome.results["MAX_RATIO"] == summary(outcome, "kept_1")["threshold"]


def test_who_is_not_sure_did_not_judge() -> None:
    """No number changes, and nobody is warned of a word that the desk itself writes."""
    windows = judged((*VISIBLE, 0.9), INVISIBLE)
    index = windows.fields().names().index("observer")
    windows.dataProvider().changeAttributeValues({len(VISIBLE) + 1: {index: "unsure"}})
    outcome, without = (run("calibratethreshold", WINDOWS=row) for row in (windows, judged()))
    assert outcome.results["VISIBLE_COUNT"] == len(VISIBLE)
    assert outcome.results["MAX_RATIO"] == without.results["MAX_RATIO"]
    assert not any("neither" in warning for warning in outcome.log.warnings)


def test_how_well_two_operators_agree_is_told() -> None:
    second = ["visible"] * 5 + ["invisible"] * 9 + ["unsure"]
    notices = run("calibratethreshold", WINDOWS=judged(observer_2=("string", second))).log.infos
    agreed = "Both operators judged 14 windows and agreed on 13. Cohen's kappa 0.85"
    assert any(item.startswith(agreed) for item in notices)
    assert not any("operators" in info for info in run("calibratethreshold", WINDOWS=judged()).log.infos)
