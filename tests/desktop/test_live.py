"""The real QGIS desktop: the curve at the click, and under the mouse. Figures are printed: `pytest -s`."""
from __future__ import annotations

from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say
from tests.patience import MOST_GAP_S, MOST_WORK_S

pytestmark = pytest.mark.stalls


def test_curves_at_the_click_and_under_the_mouse(
    whole_block: Path | None, tmp_path: Path, screenshots: Path
) -> None:
    """Clicks with and without a rest before, a window moved along a seam, one dragged, two hundred places."""
    if whole_block is None:
        pytest.skip("no block: run `make demo`")
    parameters = {"block": str(whole_block), "screenshots": str(screenshots)}
    run = play(SCENARIOS / "live.py", tmp_path, parameters, seconds=400)  # a machine shared with others
    say("live", run.seconds, run.report)
    check(run)
    report = run.report
    for name in ("clicked", "rested"):
        assert report[f"{name}_sizes"] == [[1024, 1024, 2]]
    assert report["live_profiles"]
    assert report["files_let_go"] > 0
    assert report["files_after_200"] <= report["files_after_20"] + 4
    for name in ("first", "clicked", "rested", "moved", "dragged"):
        assert report[f"{name}_work_ms"] <= 1000 * MOST_WORK_S, name
        assert report[f"{name}_gap_ms"] <= 1000 * MOST_GAP_S, name
