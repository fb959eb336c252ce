"""Undo and redo in the real QGIS desktop, where QGIS's own actions have the same keys."""
from __future__ import annotations

from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say


def test_keys_of_undo_work_wherever_the_focus_is(data_folder: Path, tmp_path: Path, screenshots: Path) -> None:
    brighton = data_folder / "seams" / "brighton"
    if not brighton.is_dir():
        pytest.skip(f"no real data at {brighton}")
    run = play(SCENARIOS / "undo.py", tmp_path, {"brighton": str(brighton), "screenshots": str(screenshots)})
    say("Undo", run.seconds, run.report)
    check(run)
    assert "mbiguous" not in run.output, run.output[-2000:]
    assert len(run.report["works in"]) == 15
