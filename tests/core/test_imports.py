"""Imports run one way: core <- adapters <- processing and gui, which never import each other."""
from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

MAY_IMPORT = {
    "core": {"core"},
    "adapters": {"core", "adapters"},
    "processing": {"core", "adapters", "processing"},
    "gui": {"core", "adapters", "gui"},
}
FORBIDDEN_EVERYWHERE = (
    "PyQt5",  # qgis.PyQt is whichever there is
    "PyQt6",
    "matplotlib.pyplot",  # keeps figures alive and picks a window system of its own
    "pylab",
)
FORBIDDEN = {
    "core": ("qgis", "matplotlib"),
    "adapters": ("qgis.gui", "qgis.PyQt.QtWidgets"),
}
OWN_NAMES = ("plugin", "seam_inspector")


def imports(path: Path, package: Path) -> Iterator[tuple[int, bool, str]]:
    """Line, whether it is relative, and full name of all that a file imports; the package's own are ``plugin.*``."""
    home = ["plugin", *path.relative_to(package).parent.parts]
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield node.lineno, False, alias.name
        elif isinstance(node, ast.ImportFrom):
            module = home[: max(len(home) - node.level + 1, 0)] if node.level else []
            module += [node.module] if node.module else []
            for alias in node.names:
                yield node.lineno, node.level > 0, ".".join([*module, alias.name])


def is_within(name: str, modules: tuple[str, ...]) -> bool:
    """Whether a full name is one of the modules or lies in one."""
    return any(name == module or name.startswith(module + ".") for module in modules)


def fault(layer: str, relative: bool, name: str) -> str | None:
    """What is wrong with one import in a layer ("" for the files above the layers)."""
    if relative:
        if not name.startswith("plugin."):
            return "reaches outside the package"
        target = name.split(".")[1]
        if layer and target not in MAY_IMPORT.get(layer, ()):
            return f"{layer} must not import {target}"
    elif is_within(name, OWN_NAMES):
        return "must be relative"
    elif is_within(name, FORBIDDEN_EVERYWHERE) or is_within(name, FORBIDDEN.get(layer, ())):
        return f"is not allowed in {layer or 'the package'}"
    return None


def faults(package: Path) -> list[str]:
    """Every import in a package that breaks the rule, as ``file:line name: what is wrong``."""
    found = []
    for path in sorted(package.rglob("*.py")):
        inside = path.relative_to(package)
        layer = inside.parts[0] if len(inside.parts) > 1 else ""
        for line, relative, name in imports(path, package):
            wrong = fault(layer, relative, name)
            if wrong:
                found.append(f"{inside.as_posix()}:{line} {name}: {wrong}")
    return found


def test_imports_run_one_way(repository: Path) -> None:
    package = repository / "plugin"
    assert len(list(package.rglob("*.py"))) >= len(MAY_IMPORT)
    assert faults(package) == []


@pytest.mark.parametrize(
    ("file", "line"),
    [
        ("core/a.py", "import qgis.core"),
        ("core/a.py", "from qgis.PyQt.QtCore import QObject"),
        ("core/a.py", "from matplotlib.figure import Figure"),
        ("core/a.py", "def lazily():\n    from ..adapters import layers"),
        ("core/sensors/a.py", "from ...processing.provider import Provider"),
        ("core/a.py", "from .. import gui"),
        ("adapters/a.py", "from ..processing import provider"),
        ("adapters/a.py", "from qgis import gui"),
        ("adapters/a.py", "from qgis.PyQt import QtWidgets"),
        ("adapters/a.py", "from qgis.PyQt.QtWidgets import QDialog"),
        ("processing/a.py", "from ..gui.dock import Dock"),
        ("gui/a.py", "from ..processing.provider import Provider"),
        ("gui/a.py", "import matplotlib.pyplot as plt"),
        ("gui/a.py", "from matplotlib import pyplot"),
        ("gui/a.py", "from PyQt5.QtCore import Qt"),
        ("gui/a.py", "from ... import classFactory"),
        ("gui/a.py", "from seam_inspector.plugin.core import windows"),
        ("plugin.py", "from plugin.core import windows"),
    ],
)
def test_a_planted_violation_is_found(tmp_path: Path, file: str, line: str) -> None:
    path = tmp_path / file
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(line, encoding="utf-8")
    assert len(faults(tmp_path)) == 1


@pytest.mark.parametrize(
    ("file", "line"),
    [
        ("core/a.py", "import numpy\nfrom osgeo import gdal\nfrom . import errors\nfrom .errors import RasterError"),
        ("core/sensors/a.py", "from ..rasters import Raster"),
        ("adapters/a.py", "from qgis.core import QgsTask\nfrom qgis.PyQt.QtCore import Qt\nfrom ..core import windows"),
        ("processing/a.py", "from ..adapters.layers import paths\nfrom ..core.windows import Grid"),
        ("gui/a.py", "from qgis.gui import QgsMapTool\nfrom matplotlib.figure import Figure\nfrom . import dock"),
        ("plugin.py", "from .gui.dock import Dock\nfrom .processing.provider import Provider"),
    ],
)
def test_what_the_rule_allows_passes(tmp_path: Path, file: str, line: str) -> None:
    path = tmp_path / file
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(line, encoding="utf-8")
    assert faults(tmp_path) == []
