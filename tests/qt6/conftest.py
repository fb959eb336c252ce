"""Tests under PyQt6: `make test-qt6`, in .venv-qt6. QGIS 4 refuses PyQt5's modules, and so do these tests."""
from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib.abc import MetaPathFinder
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
sys.path.insert(0, str(Path(__file__).parent / "stand_in"))


class _NoPyQt5(MetaPathFinder):
    def find_spec(self, name: str, path: Sequence[str] | None, target: object = None) -> None:
        if name.partition(".")[0] == "PyQt5":
            raise ImportError(f"{name} must not meet PyQt6")


sys.meta_path.insert(0, _NoPyQt5())


@pytest.fixture(scope="session")
def app() -> object:
    """The application that widgets need."""
    from qgis.PyQt.QtWidgets import QApplication

    return QApplication.instance() or QApplication(["qgis"])
