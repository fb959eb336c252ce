"""Every module of the plugin loads where Qt is 6, so that QGIS 4 finds all it imports of ``qgis.PyQt``."""
from __future__ import annotations

import importlib
import sys
from pathlib import Path

from tools.qt6.check_names import CHECKOUT


def modules() -> list[str]:
    paths = (path.relative_to(CHECKOUT).with_suffix("") for path in sorted((CHECKOUT / "plugin").rglob("*.py")))
    return [".".join(("seam_inspector", *path.parts)).removesuffix(".__init__") for path in paths]


def test_every_module_loads() -> None:
    failed = {}
    names = modules()
    for name in names:
        try:
            importlib.import_module(name)
        except Exception as error:
            failed[name] = f"{type(error).__name__}: {error}"
    assert not failed, "\n".join(f"{name}: {why}" for name, why in failed.items())
    assert len(names) > 300
    assert "PyQt5" not in sys.modules
    assert Path(sys.modules["qgis.PyQt"].__file__ or "").is_relative_to(CHECKOUT / "tests" / "qt6")
