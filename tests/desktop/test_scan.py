"""The real QGIS desktop scans a whole mosaic: eight real orthoimages, feathered and cut hard. Figures are printed."""
from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say
from tests.patience import MOST_GAP_S, MOST_WORK_S

pytestmark = pytest.mark.stalls


def scanned(data_folder: Path, tmp_path: Path, screenshots: Path, **parameters: Any) -> dict[str, Any]:
    """What a scan of one of the mosaics reports."""
    brighton = data_folder / "seams" / "brighton"
    if not brighton.is_dir():
        pytest.skip(f"no real data at {brighton}")
    given = {"brighton": str(brighton), "screenshots": str(screenshots), "piece_m": 5.0, "seamlines": False}
    run = play(SCENARIOS / "scan.py", tmp_path, {**given, **parameters}, seconds=300)
    say(f"scan of {parameters['mosaic']}", run.seconds, run.report)
    check(run)
    report = run.report
    assert report["layers"] == ["Worst places", "Seams", "Source cells", "Picture of losses"]
    assert report["worst_count"] > 10
    assert report["first"] == [1]
    assert all(report["in_view"])
    assert report["walked"] == sorted(report["walked"])  # the worst first
    assert report["gap_ms"] <= 1000 * MOST_GAP_S
    assert report["work_ms"] <= 1000 * MOST_WORK_S
    return report


def test_feathered_mosaic(data_folder: Path, tmp_path: Path, screenshots: Path) -> None:
    """Its seams have lost detail; the scan is stopped once, and goes on."""
    report = scanned(data_folder, tmp_path, screenshots, mosaic="mosaic_feather0p4m")
    assert report["failed"] > 0.5 * report["metres"] > 100
    if "stop_enabled" in report:
        assert report["stop_enabled"]
        assert report["bar_hidden"]


def test_hard_mosaic_along_given_seamlines(data_folder: Path, tmp_path: Path, screenshots: Path) -> None:
    """Nothing of it is a significant loss."""
    report = scanned(data_folder, tmp_path, screenshots, mosaic="mosaic_hardseam", seamlines=True)
    assert report["failed"] == 0
    assert report["metres"] > 100
