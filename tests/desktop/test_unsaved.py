"""Windows in a project without a file, in the real QGIS desktop."""
from __future__ import annotations

from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check


def test_windows_of_a_project_without_a_file_move_beside_it(
    data_folder: Path, tmp_path: Path, screenshots: Path
) -> None:
    brighton = data_folder / "seams" / "brighton"
    if not brighton.is_dir():
        pytest.skip(f"no real data at {brighton}")
    parameters = {"brighton": str(brighton), "home": str(tmp_path), "screenshots": str(screenshots)}
    check(play(SCENARIOS / "unsaved.py", tmp_path / "unsaved", parameters, seconds=300))
