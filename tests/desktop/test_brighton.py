"""The real QGIS desktop on eight real orthoimages, their mosaic and its seams. Figures are printed: `pytest -s`."""
from __future__ import annotations

from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say
from tests.patience import MOST_GAP_S

pytestmark = pytest.mark.stalls


def test_hundred_windows_along_real_seams(data_folder: Path, tmp_path: Path, screenshots: Path) -> None:
    """Place, inspect, look, judge, save, reopen. Nothing is said over the map after a run, for the desk says it."""
    brighton = data_folder / "seams" / "brighton"
    if not brighton.is_dir():
        pytest.skip(f"no real data at {brighton}")
    parameters = {"brighton": str(brighton), "screenshots": str(screenshots)}
    run = play(SCENARIOS / "brighton.py", tmp_path, parameters, seconds=400)  # a machine shared with others
    say("Brighton", run.seconds, run.report)
    check(run)
    report = run.report
    assert report["sources"] == 8
    assert report["placed"] >= 100
    assert report["results"] == report["reopened"] == report["placed"]
    assert report["compared"] > 0.9 * report["placed"]
    assert set(report["verdicts"]) <= {"significant", "reduced", "preserved", "not_comparable"}
    assert report["said_over_the_map"] == 0
    assert report["judged"] == ["visible"]
    assert report["stale"] == 0
    assert report["gap_ms"] <= 1000 * MOST_GAP_S
