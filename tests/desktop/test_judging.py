"""Judging by keys in the real QGIS desktop. Figures are printed: `pytest -s`."""
from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say


def test_windows_are_judged_by_one_key_each(data_folder: Path, tmp_path: Path, screenshots: Path) -> None:
    """Worst first, the map following; a second operator judges blind; all is there when the project is opened again."""
    brighton = data_folder / "seams" / "brighton"
    if not brighton.is_dir():
        pytest.skip(f"no real data at {brighton}")
    parameters = {"brighton": str(brighton), "screenshots": str(screenshots)}
    run = play(SCENARIOS / "judging.py", tmp_path, parameters, seconds=400)  # a machine shared with others
    say("Judging", run.seconds, run.report)
    check(run)
    report = run.report
    assert "mbiguous" not in run.output, run.output[-2000:]
    assert report["wrong"] == []
    assert report["keys_per_window"] == 1
    assert report["worst_first"]
    assert report["second"] == 20
    assert report["blind_columns"] == ["id", "observer 2"]
    assert report["disagreements"] > 0
    assert "'sharp'" in report["wrong_filter"]
    assert report["reopened"]


def test_judging_has_the_screen_and_gives_it_back(small_block: Path, tmp_path: Path, screenshots: Path) -> None:
    """On a low screen the image has more than half of it; all windows by keys; then all is as it was."""
    parameters = {"block": str(small_block), "side_m": 51.2, "screenshots": str(screenshots), "name": "layout"}
    run = play(SCENARIOS / "judging_layout.py", tmp_path, parameters, seconds=400, screen="1366x768")
    say("Judging alone on the screen", run.seconds, run.report)
    check(run)
    report = run.report
    assert report["share"] >= 0.5
    assert report["focus"]
    assert report["focus_after_tab"]
    assert report["judge_whole"]
    assert "seamlines" not in report["on_map"]
    assert "Windows" not in report["on_map"]
    assert "over" not in report["on_map"]
    assert "mosaic" in report["on_map"]
    assert report["places"] > 1
    assert report["hard_cut"] == [True, False, True, False, False]
    assert report["judged"] > 3
    assert report["left"] == 0
    assert report["summary"].startswith("All windows are judged: ")
    assert report["steps"] == ["Second operator", "Report", "Accept"]
    assert report["shown"][0] == report["shown"][1]
    before, after = report["widths"]
    assert before.keys() == after.keys()
    assert all(abs(before[name] - after[name]) <= 2 for name in before)
    assert report["left_by_project"]


@pytest.mark.skipif(shutil.which("xdotool") is None, reason="xdotool, which presses keys, is not installed")
def test_a_held_key_does_not_flicker_and_letters_elsewhere_judge_nothing(
    small_block: Path, tmp_path: Path, screenshots: Path
) -> None:
    """Keys are repeated as the X server does."""
    parameters = {"block": str(small_block), "screenshots": str(screenshots), "holds": 20}
    run = play(SCENARIOS / "held_keys.py", tmp_path, parameters, seconds=400)
    say("Held keys", run.seconds, run.report)
    check(run)
    report = run.report
    assert report["judged_elsewhere"] == []
    assert not report["on_elsewhere"]
    shown_and_hidden = [True, True, False]  # by the key, still so at the end of the hold, and by letting go
    assert report["holds_table"] == report["holds_map"] == [shown_and_hidden] * 20
    assert report["judged_by_v"] == 1
    assert not report["after_judging"]
    assert not report["in_new_project"]
