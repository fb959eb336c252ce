"""The real QGIS desktop on a virtual screen. Numbers that were measured are printed: `pytest -s`."""
from __future__ import annotations

from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say

pytestmark = pytest.mark.slow

SIDE_M = 100.0  # 1024 px of the whole block
SMALL_SIDE_M = 25.0  # 256 px of the small one


def test_operators_walk(
    whole_block: Path | None, request: pytest.FixtureRequest, tmp_path: Path, screenshots: Path
) -> None:
    """Draw, inspect, judge, save and reopen."""
    block, side_m = (whole_block, SIDE_M) if whole_block else (request.getfixturevalue("small_block"), SMALL_SIDE_M)
    parameters = {"block": str(block), "side_m": side_m, "screenshots": str(screenshots)}
    run = play(SCENARIOS / "demo.py", tmp_path, parameters, screen="1500x950")
    check(run)
    report = run.report
    assert report["clicked_m"] == pytest.approx(102.4 if whole_block else 25.6, abs=0.01)
    assert report["clicked_on_seam"]
    size, pixels, sources = report["label"].split(", ")
    assert size.endswith(" m")
    assert pixels.endswith(" px")
    assert sources.endswith(("source", "sources"))
    assert len(report["verdicts"]) > 4
    assert set(report["verdicts"]) <= {"significant", "reduced", "preserved", "not_comparable"}
    assert {"significant", "reduced"} <= set(report["verdicts"])
    assert report["verdicts"][0] in ("significant", "reduced")  # on the field that was dodged too hard
    assert report["sentence"].startswith(("Significant loss.", "Reduced."))
    assert "detail lost" in report["sentence"]
    assert "along the seam" in report["why"]
    assert len(report["table"]) == len(report["verdicts"])
    assert report["table"][0][1] == report["verdicts"][0]
    assert "visible" in report["table"][0]
    assert report["pictures"][0] == "hard cut of the sources"
    assert len(report["pictures"]) > 1
    assert report["map_units_per_pixel"] == pytest.approx(0.05, rel=0.02)
    assert all(Path(path).exists() for path in report["screenshots"])
    say("operator's walk", run.seconds, {})


def test_dangers(small_block: Path, tmp_path: Path) -> None:
    """Enable and disable, close, remove and quit while a task is at work."""
    run = play(SCENARIOS / "dangers.py", tmp_path, {"block": str(small_block), "side_m": SMALL_SIDE_M})
    say("dangers", run.seconds, run.report)
    check(run)
    before, after = run.report["before"], run.report["after"]
    assert after.pop("our objects") < before.pop("our objects") + 5  # a leak would show five times
    assert after == before
    assert run.report["busy_at_exit"]
    assert run.seconds_to_exit < 60  # a few seconds on a machine of its own


def test_low_screen(small_block: Path, tmp_path: Path, screenshots: Path) -> None:
    """QGIS's window is no higher than a screen of 1000 x 700, and all of the dock can be reached there."""
    parameters = {"block": str(small_block), "side_m": SMALL_SIDE_M, "screenshots": str(screenshots)}
    run = play(SCENARIOS / "low.py", tmp_path, parameters, screen="1000x700")
    say("low screen", run.seconds, run.report)
    check(run)
    assert run.report["window"][1] <= run.report["screen"][1]
    assert 2 * run.report["dock"][0] <= run.report["screen"][0]  # the map keeps the half at least
    assert run.report["scrolls"]
    assert run.report["reached"]
