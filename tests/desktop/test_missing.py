"""The real QGIS desktop where a package is missing."""
from __future__ import annotations

from pathlib import Path

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check


def test_without_pywavelets(tmp_path: Path) -> None:
    """One message says what to do; after a restart with the package the desk opens."""
    run = play(SCENARIOS / "missing.py", tmp_path)
    check(run)
    (message,) = run.report["messages"]
    assert "PyWavelets" in message
    assert "restart QGIS" in message
    assert run.report["is_warning"]
    assert run.report["messages_after"] == []
