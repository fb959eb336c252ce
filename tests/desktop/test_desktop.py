"""The real QGIS desktop on a virtual screen: a start for each of an operator's ways. Figures are printed: `pytest -s`.

The sixth way, installing the plugin's zip, is in test_installed.py.
"""
from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.desktop.conftest import played

pytestmark = pytest.mark.slow

SIDE_M = 25.6  # 256 px of the block
READABLE = 3.0  # contrast of words, by WCAG 2.1 what large ones need; themes of QGIS's own hardly give more


def test_operators_walk(repository: Path, small_block: Path, tmp_path: Path, screenshots: Path) -> None:
    """The guide's first inspection as its page says; then draw, inspect, judge, save and reopen."""
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    command = [sys.executable, "-m", "demo.project", str(small_block)]
    subprocess.run(command, cwd=repository, env=environment, check=True, timeout=120)
    parameters = {
        "project": small_block / "block.qgz", "block": small_block, "side_m": SIDE_M, "screenshots": screenshots
    }
    report = played("walk", tmp_path, parameters, screen="1300x920", seconds=400).report
    assert report["windows"] > 0
    assert report["first_sentence"]
    assert report["clicked_m"] == pytest.approx(SIDE_M, abs=0.01)
    assert report["clicked_on_seam"]
    assert len(report["verdicts"]) > 4
    assert set(report["verdicts"]) <= {"significant", "reduced", "preserved", "not_comparable"}
    assert {"significant", "reduced"} <= set(report["verdicts"])
    assert report["verdicts"][0] in ("significant", "reduced")  # on the field that was dodged too hard
    assert report["sentence"]
    assert report["why"]
    assert sorted(row[1] for row in report["table"]) == sorted(report["verdicts"])
    assert sum("visible" in row for row in report["table"]) == 1
    assert report["pictures"] > 1
    assert report["map_units_per_pixel"] == pytest.approx(0.05, rel=0.02)
    assert all(Path(path).exists() for path in report["screenshots"])


def test_judging(small_block: Path, tmp_path: Path, screenshots: Path) -> None:
    """Undo from everywhere, held keys; the image has the screen while windows are judged, then all is as before."""
    parameters = {"block": small_block, "side_m": 2 * SIDE_M, "screenshots": screenshots}
    report = played("judging", tmp_path, parameters, seconds=400, screen="1366x768").report
    assert len(report["undone_from"]) == 10
    if report["has_xdotool"]:
        assert report["judged_elsewhere"] == []
        assert not report["on_elsewhere"]
        assert report["holds"] == [[True, True, False]] * 5  # by the key, still so at the hold's end, and let go
        assert report["judged_by_v"] == 1
    assert report["share"] >= 0.5
    assert report["focus"]
    assert report["focus_after_tab"]
    assert report["judge_whole"]
    assert "mosaic" in report["on_map"]
    assert not {"seamlines", "Windows of mosaic", "over"} & set(report["on_map"])
    assert report["places"] > 1
    assert report["hard_cut"] == [True, False, True, False, False]
    assert report["judged"] > 3
    assert report["unjudged"] == 0
    before, after = report["before"], report["after"]
    assert before["shown"] == after["shown"]
    assert before["widths"].keys() == after["widths"].keys()
    assert all(abs(before["widths"][name] - after["widths"][name]) <= 2 for name in before["widths"])
    assert report["as_before_in_a_new_project"]


def test_scan_and_accept(small_block: Path, tmp_path: Path, screenshots: Path) -> None:
    """The scan is stopped and goes on; the worst places are judged, and the delivery is decided on."""
    parameters = {"folder": small_block, "mosaic": "mosaic", "side_m": SIDE_M, "screenshots": screenshots}
    report = played("scan", tmp_path, parameters, seconds=300).report
    assert_scanned(report)
    assert report["failed"] > 0
    assert report["decided"] == "Rejected"
    assert {path.rpartition(".")[2] for path in report["papers"]} >= {"html", "gpkg", "xml"}


def assert_scanned(report: dict[str, Any]) -> None:
    """Layers in their order, and the worst places judged from the first on, each in view."""
    assert report["layers"] == ["Worst places", "Seams", "Source cells", "Picture of losses"]
    assert report["worst_count"] > 0
    assert report["metres"] > 100
    assert report["first"] == [1]
    assert all(report["in_view"])
    assert report["walked"] == sorted(report["walked"])  # the worst first
    if "stop_enabled" in report:
        assert report["stop_enabled"]
        assert report["bar_hidden"]


def test_dangers(small_block: Path, tmp_path: Path) -> None:
    """A package is missing; enable and disable, close, remove and quit while a task is at work."""
    run = played("dangers", tmp_path, {"block": small_block, "side_m": SIDE_M}, seconds=300)
    (message,) = run.report["messages"]
    assert "PyWavelets" in message
    assert run.report["is_warning"]
    assert run.report["messages_after"] == []
    before, after = run.report["before"], run.report["after"]
    assert after.pop("our objects") < before.pop("our objects") + 5  # a leak would show five times
    assert after == before
    assert run.report["busy_at_exit"]
    assert run.seconds_to_exit < 60  # a few seconds on a machine of its own


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("dark_polish", {"theme": "Night Mapping", "screen": "1366x768", "locale": "pl"}),
        pytest.param("light", {}, marks=pytest.mark.release),
        pytest.param("scaled", {"scale": 2, "screen": "3200x2000"}, marks=pytest.mark.release),
    ],
)
def test_looks(name: str, options: dict[str, Any], small_block: Path, tmp_path: Path, screenshots: Path) -> None:
    """Right of the map nothing is cut off, all can be read, and the keyboard gets everywhere.

    QGIS's window needs no more than 1000 x 700, and all of the dock can be reached there.
    """
    parameters = {"block": small_block, "side_m": SIDE_M, "screenshots": screenshots, "name": name}
    report = played("looks", tmp_path, parameters, **options).report
    assert report["right_size"][0] <= 440
    assert report["inputs_cut"] == []
    for place in ("right", "right_images"):
        for defect in ("cut", "headings_cut", "no_tooltip", "steps_up", "no_focus_mark"):
            assert report[f"{place}_{defect}"] == [], f"{defect}, {place}"
        assert report[f"{place}_table_overflow"] == 0, place
        assert report[f"{place}_chart"] >= 150, place
        assert report[f"{place}_judge_whole"], place
        contrasts = report[f"{place}_contrasts"]
        kinds = {words.split()[0] for words in contrasts}
        assert kinds >= {"heading", "label", "button"}
        assert {words: ratio for words, ratio in contrasts.items() if ratio < READABLE} == {}, place
    if name != "scaled":
        assert report["low_window"][1] <= 700
        assert 2 * report["low_dock"][0] <= 1000  # the half is left to the map
        assert report["low_scrolls"]
        assert report["low_reached"]
