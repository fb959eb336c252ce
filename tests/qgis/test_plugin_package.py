"""The package as QGIS loads it."""
from __future__ import annotations

import importlib
import subprocess
import sys
from pathlib import Path

HEAVY = ("scipy", "pywt", "matplotlib", "jinja2", "dask")


def test_start_up_imports_nothing_heavy(repository: Path) -> None:
    """QGIS imports every plugin while its splash screen is shown."""
    code = f"import seam_inspector, sys; print([name for name in {HEAVY!r} + ('qgis',) if name in sys.modules])"
    finished = subprocess.run(
        [sys.executable, "-c", code], cwd=repository / "build" / "plugins", capture_output=True, text=True, check=True
    )
    assert finished.stdout.strip() == "[]"


def test_package_offers_its_factory() -> None:
    assert callable(importlib.import_module("seam_inspector").classFactory)
