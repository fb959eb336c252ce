"""Images in the real QGIS desktop, on real orthoimages. Figures are printed: `pytest -s`."""
from __future__ import annotations

from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say

pytestmark = pytest.mark.stalls


@pytest.mark.parametrize("scale", [1, 2])
def test_where_detail_was_lost_is_seen(data_folder: Path, tmp_path: Path, screenshots: Path, scale: int) -> None:
    """At both scalings of the desktop."""
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
    assert report["units"] == pytest.approx([0.5, 0.5], rel=1e-6)
    assert report["loss_shown"] == [True, True]
