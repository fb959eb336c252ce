"""What the tests of the real application share."""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

from demo import desktop
from demo.block import make_block
from demo.desktop import Run
from tests.patience import MOST_GAP_S, MOST_WORK_S

SCENARIOS = Path(__file__).parent / "scenarios"


@pytest.fixture(scope="session", autouse=True)
def _can_start() -> None:
    reason = desktop.why_not()
    if reason:
        pytest.skip(f"the real QGIS can't be started: {reason}")


@pytest.fixture(scope="session")
def small_block(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A block that is made in seconds, 120 x 100 m."""
    folder = tmp_path_factory.mktemp("block")
    make_block(folder, extent_m=(120.0, 100.0))
    return folder


@pytest.fixture
def brighton(data_folder: Path) -> Path:
    """Eight real orthoimages, their mosaics and seamlines."""
    folder = data_folder / "seams" / "brighton"
    if not folder.is_dir():
        pytest.skip(f"no real data at {folder}")
    return folder


@pytest.fixture
def screenshots(tmp_path: Path) -> Path:
    """The folder of the pictures: SCREENSHOTS, or the test's own."""
    folder = os.environ.get("SCREENSHOTS")
    return Path(folder).resolve() if folder else tmp_path / "screenshots"


def played(name: str, folder: Path, parameters: dict[str, Any], **options: Any) -> Run:
    """A scenario that passed: nothing raised, and QGIS ended by itself and soundly. Its figures are printed."""
    settings = {key: str(value) if isinstance(value, Path) else value for key, value in parameters.items()}
    run = desktop.play(SCENARIOS / f"{name}.py", folder, settings, **options)
    print(f"\n{name}: {run.seconds:.0f} s")  # noqa: T201
    for figure, value in run.report.items():
        if figure != "screenshots":
            print(f"    {figure}: {value:.3f}" if isinstance(value, float) else f"    {figure}: {value}")  # noqa: T201
    raised = "\n".join(run.raised)
    assert run.status == "passed", f"{run.status}\n{raised}\n{run.output[-4000:]}"
    assert run.raised == []
    assert "Traceback" not in run.output, run.output[-4000:]
    assert "mbiguous" not in run.output, run.output[-4000:]
    assert run.code == 0, f"exit code {run.code}\n{run.output[-4000:]}"
    return run


def assert_no_stall(report: dict[str, Any], steps: tuple[str, ...]) -> None:
    """The interface stood still for no longer than an operator bears, in any of the steps."""
    for step in steps:
        assert report[f"{step}_work_ms"] <= 1000 * MOST_WORK_S, step
        assert report[f"{step}_gap_ms"] <= 1000 * MOST_GAP_S, step
