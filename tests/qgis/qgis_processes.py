"""The real ``qgis_process``, with settings of its own."""
from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

# Debian 12's qgis_process is a script that can't start; the program itself is beside it.
PROGRAM = shutil.which("qgis_process.bin") or shutil.which("qgis_process")
NEEDED = pytest.mark.skipif(PROGRAM is None, reason="neither qgis_process.bin nor qgis_process is on the path")


def environment(repository: Path, settings: Path) -> dict[str, str]:
    """In which it finds the plugin, and keeps its ``settings``."""
    return {
        **os.environ,
        "QT_QPA_PLATFORM": "offscreen",
        "QGIS_PLUGINPATH": str(repository / "build" / "plugins"),
        "QGIS_CUSTOM_CONFIG_PATH": str(settings),
    }
