"""The real QGIS desktop does not stand still while windows are drawn, inspected and judged. Figures are printed."""
from __future__ import annotations

from pathlib import Path

import pytest

from tests.desktop.conftest import assert_no_stall, played
from tests.desktop.test_desktop import assert_scanned
from tests.large import BOXES, make_large_rasters

pytestmark = [pytest.mark.slow, pytest.mark.stalls]

COUNT = 24


def test_two_dozen_windows_of_1024_px(tmp_path: Path, screenshots: Path) -> None:
    rasters = [str(path) for path in make_large_rasters(tmp_path)]
    parameters = {"rasters": rasters, "boxes": BOXES[:COUNT], "screenshots": screenshots}
    report = played("stalls", tmp_path, parameters, seconds=900).report
    assert report["windows"] == report["inspected"] == COUNT
    assert report["placed"] > 200
    assert report["files_after_200"] <= report["files_after_20"] + 4
    assert report["files_released"] > 0
    assert_no_stall(report, ("first", "drawing", "inspecting", "judging", "placing", "moving", "dragging"))


@pytest.mark.parametrize(("mosaic", "seamlines"), [("mosaic_feather0p4m", False), ("mosaic_hardseam", True)])
def test_scan_of_real_orthoimages(
    brighton: Path, tmp_path: Path, screenshots: Path, mosaic: str, seamlines: bool
) -> None:
    """The feathered mosaic has lost detail along half of its seams; the hard cut, along given seamlines, nowhere."""
    parameters = {
        "folder": brighton, "mosaic": mosaic, "side_m": 7.0, "piece_m": 5.0, "seamlines": seamlines,
        "screenshots": screenshots,
    }  # fmt: skip
    report = played("scan", tmp_path, parameters, seconds=300).report
    assert_scanned(report)
    if seamlines:
        assert report["failed"] == 0
    else:
        assert report["failed"] > 0.5 * report["metres"]
    assert_no_stall(report, ("scan", "judge"))
