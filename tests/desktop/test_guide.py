"""The guide's first inspection, step by step as its page says, in the real QGIS."""
from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from demo.desktop import play
from tests.desktop.conftest import SCENARIOS, check, say

pytestmark = pytest.mark.slow


def test_the_first_inspection_goes_as_the_page_says(
    repository: Path, small_block: Path, tmp_path: Path, screenshots: Path
) -> None:
    """Open the block, place, inspect, read, judge, report."""
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    command = [sys.executable, "-m", "demo.project", str(small_block)]
    subprocess.run(command, cwd=repository, env=environment, check=True, timeout=120)
    parameters = {"project": str(small_block / "block.qgz"), "screenshots": str(screenshots)}
    run = play(SCENARIOS / "first_inspection.py", tmp_path, parameters, screen="1300x920")
    check(run)
    assert run.report["windows"] == len(run.report["verdicts"]) > 0
    assert run.report["sentence"]
    say("the first inspection", run.seconds, {})
