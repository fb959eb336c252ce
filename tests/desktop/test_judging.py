"""Judging by keys in the real QGIS desktop. Figures are printed: `pytest -s`."""
from __future__ import annotations

from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say


def test_windows_are_judged_by_one_key_each(data_folder: Path, tmp_path: Path, screenshots: Path) -> None:
    """Worst first, the map following; a second operator judges blind; all is there when the project is opened again."""
    brighton = data_folder / "seams" / "brighton"
    if not brighton.is_dir():
        pytest.skip(f"no real data at {brighton}")
    parameters = {"brighton": str(brighton), "screenshots": str(screenshots)}
    run = play(SCENARIOS / "judging.py", tmp_path, parameters, seconds=400)  # a machine shared with others
    say("Judging", run.seconds, run.report)
    check(run)
    report = run.report
    assert "mbiguous" not in run.output, run.output[-2000:]
    assert report["wrong"] == []
    assert report["keys_per_window"] == 1
    assert report["worst_first"]
    assert report["second"] == 20
    assert report["blind_columns"] == ["id", "observer 2"]
    assert report["disagreements"] > 0
    assert "'sharp'" in report["wrong_filter"]
    assert report["csv_lines"] == report["placed"] + 1
    assert report["reopened"]
