"""Images and swipe in the real QGIS desktop, on real orthoimages. Figures are printed: `pytest -s`."""
from __future__ import annotations

from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say
from tests.patience import MOST_WORK_S

pytestmark = pytest.mark.stalls


@pytest.mark.parametrize("scale", [1, 2])
def test_where_detail_was_lost_is_seen(data_folder: Path, tmp_path: Path, screenshots: Path, scale: int) -> None:
    """At both scalings of the desktop; the swipe leaves nothing on the map."""
    brighton = data_folder / "seams" / "brighton"
    if not brighton.is_dir():
        pytest.skip(f"no real data at {brighton}")
    parameters = {"brighton": str(brighton), "screenshots": str(screenshots / f"{scale}x")}
    run = play(
        SCENARIOS / "see.py", tmp_path, parameters, scale=scale, screen="1600x1000" if scale == 1 else "2800x1800"
    )
    say(f"Seeing where, {scale}x", run.seconds, run.report)
    check(run)
    report = run.report
    assert report["flipped_to"] == "composite"
    assert report["flipped_back"]
    assert report["loss_shown"]
    first, second = report["swiped"]
    assert first.endswith("_ortho.tif")
    assert second == "composite"
    assert report["dragged_by"] == pytest.approx(-200, abs=2)
    assert report["ended"]
    assert report["left_items"] == 0
    assert report["swipe_work_ms"] <= 1000 * MOST_WORK_S
