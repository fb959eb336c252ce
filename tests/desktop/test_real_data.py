"""The real QGIS desktop on eight real orthoimages. Figures are printed: `pytest -s`."""
from __future__ import annotations

from pathlib import Path

import pytest

from tests.desktop.conftest import assert_no_stall, played

pytestmark = pytest.mark.release


def test_windows_are_judged_by_one_key_each(brighton: Path, tmp_path: Path, screenshots: Path) -> None:
    """Worst first, the map following; a second operator judges blind."""
    parameters = {"brighton": brighton, "screenshots": screenshots}
    report = played("real_judging", tmp_path, parameters, seconds=400).report
    assert report["placed"] > 30
    assert report["said_over_the_map"] == 0
    assert report["wrong"] == []
    assert report["worst_first"]
    assert report["second"] == 20
    assert report["blind_columns"] == ["id", "observer 2"]
    assert_no_stall(report, ("inspect", "judge"))
