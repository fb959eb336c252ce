"""The real QGIS desktop does not stand still while windows are drawn, inspected and judged. Figures are printed."""
from __future__ import annotations

from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say
from tests.large import BOXES, make_large_rasters
from tests.patience import MOST_GAP_S, MOST_WORK_S

pytestmark = [pytest.mark.slow, pytest.mark.stalls]

COUNT = 24


def test_two_dozen_windows_of_1024_px(tmp_path: Path, screenshots: Path) -> None:
    rasters = [str(path) for path in make_large_rasters(tmp_path)]
    parameters = {"rasters": rasters, "boxes": BOXES[:COUNT], "screenshots": str(screenshots)}
    run = play(SCENARIOS / "stalls.py", tmp_path, parameters, seconds=900)
    say("windows of 1024 px", run.seconds, run.report)
    check(run)
    report = run.report
    assert report["windows"] == report["inspected"] == COUNT
    assert report["placed"] > 200
    for step in ("first", "drawing", "inspecting", "judging", "placing"):
        assert report[f"{step}_work_ms"] <= 1000 * MOST_WORK_S, step
        assert report[f"{step}_gap_ms"] <= 1000 * MOST_GAP_S, step
