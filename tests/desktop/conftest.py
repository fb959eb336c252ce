"""What the tests of the real application share."""
from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

from demo import desktop
from demo.block import make_block
from demo.desktop import Run

SCENARIOS = Path(__file__).parent / "scenarios"


@pytest.fixture(scope="session", autouse=True)
def _can_start() -> None:
    reason = desktop.why_not()
    if reason:
        pytest.skip(f"the real QGIS can't be started: {reason}")


@pytest.fixture(scope="session")
def whole_block(repository: Path) -> Path | None:
    """The block that `make demo` made, 500 x 400 m, when it is there."""
    folder = repository / "output" / "demo" / "block"
    return folder if (folder / "done").exists() else None


@pytest.fixture(scope="session")
def small_block(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A block that is made in seconds, 120 x 100 m."""
    folder = tmp_path_factory.mktemp("block")
    make_block(folder, extent_m=(120.0, 100.0))
    return folder


@pytest.fixture
def screenshots(tmp_path: Path) -> Path:
    """The folder of the pictures: SCREENSHOTS, or the test's own."""
    folder = os.environ.get("SCREENSHOTS")
    return Path(folder).resolve() if folder else tmp_path / "screenshots"


def check(run: Run) -> None:
    """The scenario passed, nothing raised, and QGIS ended by itself and soundly."""
    raised = "\n".join(run.raised)
    assert run.status == "passed", f"{run.status}\n{raised}\n{run.output[-4000:]}"
    assert run.raised == []
    assert "Traceback" not in run.output, run.output[-4000:]
    assert run.code == 0, f"exit code {run.code}\n{run.output[-4000:]}"


def say(what: str, seconds: float, report: dict[str, Any]) -> None:
    """What was measured."""
    print(f"\n{what}: {seconds:.0f} s")  # noqa: T201
    for name, value in report.items():
        if name != "screenshots":
            print(f"    {name}: {value:.3f}" if isinstance(value, float) else f"    {name}: {value}")  # noqa: T201
