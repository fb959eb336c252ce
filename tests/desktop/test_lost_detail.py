"""Lost detail in the real QGIS desktop: over the map by one key, where the seams are; the profile beside the curve."""
from __future__ import annotations

from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say


@pytest.mark.parametrize("mosaic", ["mosaic_feather0p4m", "mosaic_hardseam"])
def test_where_detail_was_lost_is_seen_on_a_small_screen(
    data_folder: Path, tmp_path: Path, screenshots: Path, mosaic: str
) -> None:
    """A feather is a line along the seam, a sound cut is nothing."""
    brighton = data_folder / "seams" / "brighton"
    if not brighton.is_dir():
        pytest.skip(f"no real data at {brighton}")
    parameters = {"brighton": str(brighton), "mosaic": mosaic, "screenshots": str(screenshots)}
    run = play(SCENARIOS / "lost_detail.py", tmp_path, parameters, seconds=300, screen="1366x768")
    say(mosaic, run.seconds, run.report)
    check(run)
    report, is_feathered = run.report, "feather" in mosaic
    assert report["shown_by_button"]
    assert report["hidden_by_button"]
    for turned in ("north up", "turned", "in degrees"):
        on_seam, beside = report[turned]
        # At the corner of a third source its few pixels may be followed wrong.
        assert (on_seam > 0.8) if is_feathered else (on_seam < 0.2), turned
        assert beside < 0.1, turned
    assert min(report["curve_px"][1], report["profile_px"][1]) >= 150
    assert report["judge_bar_in_sight"]
    assert report["pointed"]
