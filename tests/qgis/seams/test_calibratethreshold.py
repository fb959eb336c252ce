"""The calibration as QGIS runs it: from judged windows to a table, a chart and the number to set."""
from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from qgis.core import QgsCoordinateTransformContext, QgsVectorFileWriter, QgsVectorLayer
from scipy import stats

from tests.qgis.runs import Run, assert_refused, run
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
    (found,) = (row for row in outcome.rows() if row["measure"] == measure and row["row"] == "summary")
    return found


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


def test_numbers_that_no_measurement_gives_are_left_out_and_told() -> None:
    spoilt = [1e308, -3.5, float("nan"), float("inf"), -1.0]
    visible, invisible = (*VISIBLE, 0.3, 0.4), (*INVISIBLE, 0.8, 0.9, 1.0)
    words = ["visible"] * len(visible) + ["invisible"] * len(invisible)
    kept = [*[value * 0.9 for value in VISIBLE], *spoilt[:2], *[value * 0.8 for value in INVISIBLE], *spoilt[2:]]
    seen = [2.0] * len(words)
    seen[0], seen[1] = -0.5, 1e30
    windows = judged(visible, invisible, kept_1=("double", kept), visibility=("double", seen))
    table = pairs([(1, "a.tif", "red", 1e308), (2, "a.tif", "red", 1)])
    outcome = run("calibratethreshold", WINDOWS=windows, PAIRS=table)
    assert outcome.complaint is None
    gaps = [None if value in spoilt or value != value else value for value in kept]
    sound = run("calibratethreshold", WINDOWS=judged(visible, invisible, kept_1=("double", gaps)))
    assert {name: outcome.results[name] for name in NUMBERS} == {name: sound.results[name] for name in NUMBERS}
    assert (outcome.results["VISIBLE_COUNT"], outcome.results["INVISIBLE_COUNT"]) == (6, 9)
    told = outcome.log.warnings
    assert "kept_1 of 3 windows is a number that no measurement gives; it is left out." in told
    assert "visibility of 2 windows is a number that no measurement gives; it is left out." in told
    assert "kept_1: left out because nothing was measured there: 5 judged windows." in told
    assert "contrast_1: left out because nothing was measured there: 19 judged windows." in told


def test_what_an_eye_sees_of_a_loss_is_a_measure_too(tmp_path: Path) -> None:
    """It is high where a loss was seen, so windows at or above its threshold are flagged."""
    seen = [2.5 - 2 * value for value in KEPT]
    chart = tmp_path / "roc.svg"
    outcome = run(
        "calibratethreshold", WINDOWS=judged(kept_1=("double", KEPT), visibility=("double", seen)),
        MEASURE="visibility", CHART=str(chart),
    )  # fmt: skip
    assert outcome.complaint is None
    assert outcome.results["AUC"] == pytest.approx(summary(outcome, "kept_1")["auc"])
    threshold = outcome.results["MAX_RATIO"]
    assert threshold == pytest.approx(2.5 - 2 * summary(outcome, "kept_1")["threshold"], abs=0.15)
    row = summary(outcome, "visibility")
    assert row["flagged_visible"] == sum(value >= threshold for value in seen[: len(VISIBLE)])
    (standard,) = (row for row in outcome.rows() if (row["measure"], row["row"]) == ("visibility", "standard"))
    assert standard["threshold"] == 1
    assert "visibility" in chart.read_text(encoding="utf-8")


def test_where_no_seam_was_measured_the_numbers_are_of_the_ratio() -> None:
    nothing = ("double", [None] * len(KEPT))
    outcome = run("calibratethreshold", WINDOWS=judged(kept_1=nothing))
    assert outcome.results["MAX_RATIO"] == summary(outcome, "ratio_1")["threshold"]
    assert any("kept_1: left out" in warning for warning in outcome.log.warnings)


def test_a_layer_with_one_measure_alone_will_do() -> None:
    windows = judged(kept_1=("double", KEPT))
    windows.dataProvider().deleteAttributes([windows.fields().indexOf("ratio_1")])
    windows.updateFields()
    outcome = run("calibratethreshold", WINDOWS=windows)
    assert {row["measure"] for row in outcome.rows()} == {"kept_1"}
    assert_refused("calibratethreshold", "no field 'ratio_1'", WINDOWS=windows, MEASURE="ratio_1")
    assert_refused("calibratethreshold", "no field 'contrast_1'", WINDOWS=judged(), MEASURE="contrast_1")


def test_windows_near_each_other_are_resampled_together() -> None:
    random = np.random.default_rng(7)
    shared = np.repeat(random.normal(0, 0.12, 10), 4)
    kinds = np.arange(40) % 2 == 0
    values = np.clip(np.where(kinds, 0.45, 0.75) + shared + random.normal(0, 0.04, 40), 0.05, 0.99)
    words = np.where(kinds, "visible", "invisible").tolist()
    widths, counts = [], []
    for apart in (30, 3000):  # metres between the windows of a place
        shapes = [outline((50_000 * (place // 4) + apart * (place % 4), 0, 100, 100)) for place in range(40)]
        windows = layer(
            "Polygon", shapes, window_id=("integer", list(range(1, 41))), ratio_1=("double", values.tolist()),
            observer=("string", words),
        )  # fmt: skip
        row = summary(run("calibratethreshold", WINDOWS=windows))
        widths.append(row["threshold_high"] - row["threshold_low"])
        counts.append(row["neighbourhoods"])
    assert counts == [10, 40]
    assert widths[0] > 1.3 * widths[1]


def test_only_judged_and_measured_windows_count() -> None:
    windows = judged((*VISIBLE, None), INVISIBLE)
    names = windows.fields().names()
    words = [feature["observer"] for feature in windows.getFeatures()]
    for place, word in ((1, "Visible "), (8, ""), (9, None), (10, "perhaps")):
        windows.dataProvider().changeAttributeValues({place: {names.index("observer"): word}})
        words[place - 1] = word
    outcome = run("calibratethreshold", WINDOWS=windows)
    assert (outcome.results["VISIBLE_COUNT"], outcome.results["INVISIBLE_COUNT"]) == (6, 6)
    assert any("neither 'visible' nor 'invisible': 1" in warning for warning in outcome.log.warnings)
    assert any("ratio_1: left out because nothing was measured there: 1" in warning for warning in outcome.log.warnings)


def test_who_is_not_sure_did_not_judge() -> None:
    """No number changes, and nobody is warned of a word that the desk itself writes."""
    windows = judged((*VISIBLE, 0.9), INVISIBLE)
    index = windows.fields().names().index("observer")
    windows.dataProvider().changeAttributeValues({len(VISIBLE) + 1: {index: "unsure"}})
    found, without = (run("calibratethreshold", WINDOWS=one) for one in (windows, judged()))
    assert found.results["VISIBLE_COUNT"] == len(VISIBLE)
    assert found.results["MAX_RATIO"] == without.results["MAX_RATIO"]
    assert not any("neither" in warning for warning in found.log.warnings)


def test_how_well_two_operators_agree_is_told() -> None:
    second = ["visible"] * 5 + ["invisible"] * 9 + ["unsure"]
    told = run("calibratethreshold", WINDOWS=judged(observer_2=("string", second))).log.infos
    assert any(one.startswith("Both operators judged 14 windows and agreed on 13. Cohen's kappa 0.85") for one in told)
    assert not any("operators" in info for info in run("calibratethreshold", WINDOWS=judged()).log.infos)


def test_a_csv_file_will_do(tmp_path: Path) -> None:
    path = str(tmp_path / "windows.csv")
    options = QgsVectorFileWriter.SaveVectorOptions()
    options.driverName = "CSV"
    QgsVectorFileWriter.writeAsVectorFormatV3(judged(), path, QgsCoordinateTransformContext(), options)
    (tmp_path / "windows.csvt").unlink(missing_ok=True)
    outcome = run("calibratethreshold", WINDOWS=path)
    assert outcome.results["AUC"] == run("calibratethreshold", WINDOWS=judged()).results["AUC"]
    assert any("without an outline: 15" in warning for warning in outcome.log.warnings)


@pytest.mark.parametrize("ending", sorted(SIGNATURES))
def test_the_charts_formats(ending: str, tmp_path: Path) -> None:
    chart = tmp_path / f"roc{ending}"
    run("calibratethreshold", WINDOWS=judged(), CHART=str(chart))
    assert chart.read_bytes().startswith(SIGNATURES[ending])


def test_bad_input_is_told(tmp_path: Path) -> None:
    bare = layer("Polygon", [outline((0, 0, 9, 9))], window_id=("integer", [1]))
    for words, parameters in {
        "no field 'observer'": {"WINDOWS": bare},
        "PNG, SVG or PDF": {"WINDOWS": judged(), "CHART": str(tmp_path / "roc.bmp")},
        "table PAIRS has no field": {"WINDOWS": judged(), "PAIRS": bare},
    }.items():
        assert_refused("calibratethreshold", words, **parameters)
