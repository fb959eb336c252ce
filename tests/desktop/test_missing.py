"""The real QGIS desktop where a package is missing."""
from __future__ import annotations

from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check

pytestmark = pytest.mark.slow


def test_without_pywavelets_then_quitting_at_work(tmp_path: Path) -> None:
    """One message says what to do; after a restart with the package the desk opens.

    What the desk does by itself is cancelled and not asked about, also when QGIS closes seconds after a start.
    """
    run = play(SCENARIOS / "missing.py", tmp_path, seconds=100)
    check(run)
    (message,) = run.report["messages"]
    assert "PyWavelets" in message
    assert "restart QGIS" in message
    assert run.report["is_warning"]
    assert run.report["messages_after"] == []
    assert run.report["busy_at_exit"]
    assert "A dialog keeps QGIS" not in run.output, run.output
