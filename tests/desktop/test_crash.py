"""The real QGIS desktop, killed while windows are judged by keys, and opened again. Figures are printed."""
from __future__ import annotations

from pathlib import Path

import pytest

from demo.desktop import Run, play
from tests.desktop.conftest import SCENARIOS, check, say


def test_what_was_judged_outlives_the_desktop(data_folder: Path, tmp_path: Path, screenshots: Path) -> None:
    """Placed, inspected, judged by keys in a project that was saved before; curves are there again too."""
    run = part("judge", data_folder, tmp_path, screenshots)
    assert run.code not in (0, None), run.status
    assert (tmp_path / "told.json").exists(), f"{run.status}\n{run.output[-3000:]}"
    run = part("reopen", data_folder, tmp_path, screenshots)
    say("Crash", run.seconds, run.report)
    check(run)
    assert run.report["judged"] == 30
    assert run.report["with curves"] == run.report["windows"]


def test_windows_of_a_project_without_a_file_move_beside_it(
    data_folder: Path, tmp_path: Path, screenshots: Path
) -> None:
    check(part("unsaved", data_folder, tmp_path, screenshots))


def part(name: str, data_folder: Path, home: Path, screenshots: Path) -> Run:
    """One start of QGIS."""
    brighton = data_folder / "seams" / "brighton"
    if not brighton.is_dir():
        pytest.skip(f"no real data at {brighton}")
    parameters = {"brighton": str(brighton), "home": str(home), "screenshots": str(screenshots), "part": name}
    return play(SCENARIOS / "crash.py", home / name, parameters, seconds=300)
