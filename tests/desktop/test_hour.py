"""An hour at the real desk, killed in the middle of it. Figures are printed: `pytest -s`."""
from __future__ import annotations

import json
from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say
from tests.patience import MOST_GAP_S, MOST_WORK_S

pytestmark = pytest.mark.stalls


def test_a_hundred_windows_are_judged_though_qgis_is_killed(
    data_folder: Path, tmp_path: Path, screenshots: Path
) -> None:
    """Nothing that was judged or measured is lost; one key a window, the map following all the way."""
    brighton = data_folder / "seams" / "brighton"
    if not brighton.is_dir():
        pytest.skip(f"no real data at {brighton}")
    work = tmp_path / "work"
    work.mkdir()
    parameters = {"brighton": str(brighton), "work": str(work), "screenshots": str(screenshots)}
    killed = play(SCENARIOS / "hour.py", tmp_path / "first", {**parameters, "stage": "begin"}, seconds=400)
    assert (work / "begun.json").exists(), f"{killed.status}\n{killed.raised}\n{killed.output[-4000:]}"
    assert killed.code != 0
    begun = json.loads((work / "begun.json").read_text())
    run = play(SCENARIOS / "hour.py", tmp_path / "second", {**parameters, "stage": "finish"}, seconds=400)
    copied = run.report.pop("copied", [])
    say("an hour at the desk", killed.seconds + run.seconds, run.report)
    check(run)
    report = run.report
    assert begun["placed"] >= 100
    assert report["kept"] == len(begun["judged"]) == 30
    assert report["stale"] == 0
    assert report["judged"] >= report["to_judge"]
    assert report["keys_per_window"] == 1
    assert report["not_followed"] == 0
    assert len(copied) == begun["placed"] + 1
    assert report["work_ms"] <= 1000 * MOST_WORK_S
    assert report["gap_ms"] <= 1000 * MOST_GAP_S
