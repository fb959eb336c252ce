"""Imports run one way: imagery <- toolkit <- subjects <- wiring. Subjects don't know each other; no file leads back to
itself."""
from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components

SUBJECTS = ("seams", "acceptance", "noise", "radiometry", "resolution", "photos", "sensors")
FLOORS = ("imagery", "toolkit")
FORBIDDEN_EVERYWHERE = (
    "PyQt5",  # qgis.PyQt is whichever there is
    "PyQt6",
    "matplotlib.pyplot",  # keeps figures alive and picks a window system of its own
    "pylab",
)
NO_QGIS = ("qgis", "PyQt5", "PyQt6", "matplotlib")
NO_WIDGETS = ("qgis.gui", "qgis.PyQt.QtWidgets")
DESK = "plugin.seams.desk"
OWN_NAMES = ("plugin", "seam_inspector")


@cache
def imports(path: Path, package: Path) -> list[tuple[int, bool, str]]:
    """Line, whether it is relative, and full name of all that a file imports; the package's own are ``plugin.*``."""
    return list(_imports(path, package))


def _imports(path: Path, package: Path) -> Iterator[tuple[int, bool, str]]:
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


def allowed(folders: tuple[str, ...]) -> tuple[str, ...]:
    """What of the package a file in these folders may import."""
    if not folders:
        return ("plugin",)  # the wiring
    room = folders[0]
    if room == "imagery":
        return ("plugin.imagery",)
    if room == "toolkit":
        return ("plugin.imagery", "plugin.toolkit")
    if folders[1:2] == ("measure",):
        return ("plugin.imagery", f"plugin.{room}.measure")
    return ("plugin.imagery", "plugin.toolkit", f"plugin.{room}")


def forbidden(folders: tuple[str, ...]) -> tuple[str, ...]:
    """What a file in these folders may not import from elsewhere."""
    if folders[:1] == ("imagery",) or folders[1:2] == ("measure",):
        return NO_QGIS
    return () if not folders or "desk" in folders else NO_WIDGETS


def fault(folders: tuple[str, ...], relative: bool, name: str) -> str | None:
    """What is wrong with one import of a file in these folders."""
    place = "/".join(folders) or "the package"
    if relative:
        if not name.startswith("plugin."):
            return "reaches outside the package"
        return None if is_within(name, allowed(folders)) else f"{place} must not import it"
    if is_within(name, OWN_NAMES):
        return "must be relative"
    if is_within(name, FORBIDDEN_EVERYWHERE) or is_within(name, forbidden(folders)):
        return f"is not allowed in {place}"
    return None


def faults(package: Path) -> list[str]:
    """Every import in a package that breaks the rule, as ``file:line name: what is wrong``."""
    wrong_imports = []
    for path in sorted(package.rglob("*.py")):
        inside = path.relative_to(package)
        for line, relative, name in imports(path, package):
            wrong = fault(inside.parent.parts, relative, name)
            if wrong:
                wrong_imports.append(f"{inside.as_posix()}:{line} {name}: {wrong}")
    return wrong_imports


def test_imports_run_one_way(repository: Path) -> None:
    assert faults(repository / "plugin") == []


def arrows(package: Path) -> set[tuple[str, str]]:
    """Imports among files, also for types alone or within functions; a folder's own ``__init__`` takes no part."""
    files = {".".join(("plugin", *path.relative_to(package).with_suffix("").parts)): path
             for path in package.rglob("*.py") if path.name != "__init__.py"}  # fmt: skip
    return {(name, target) for name, path in files.items()
            for _, _, taken in imports(path, package)
            for target in (taken, taken.rpartition(".")[0]) if target in files}  # fmt: skip


def circles(package: Path) -> list[set[str]]:
    """Files that import each other by way of others."""
    pairs = arrows(package)
    names = sorted({name for pair in pairs for name in pair})
    rows, columns = zip(*((names.index(first), names.index(second)) for first, second in pairs)) if pairs else ((), ())
    matrix = csr_array((np.ones(len(rows)), (rows, columns)), shape=(len(names),) * 2)
    count, labels = connected_components(matrix, directed=True, connection="strong")
    components = [{names[number] for number in np.flatnonzero(labels == label)} for label in range(count)]
    return [circle for circle in components if len(circle) > 1]


def folders_both_ways(package: Path) -> set[tuple[str, str]]:
    """Folders of which each imports from the other, but for those within the desk, whose dock puts them together."""
    pairs = {(first.rpartition(".")[0], second.rpartition(".")[0]) for first, second in arrows(package)}
    return {
        (first, second) for first, second in pairs
        if first < second and (second, first) in pairs and first != DESK
    }


def test_files_import_each_other_in_no_circle(repository: Path) -> None:
    assert circles(repository / "plugin") == []


def test_folders_import_one_way(repository: Path) -> None:
    assert folders_both_ways(repository / "plugin") == set()


def test_every_folder_is_a_subject_or_a_shared_floor(repository: Path) -> None:
    folders = {path.parent.name for path in (repository / "plugin").glob("*/__init__.py")}
    assert folders == {*SUBJECTS, *FLOORS}
    assert all((repository / "plugin" / subject / "measure").is_dir() for subject in SUBJECTS)


@pytest.mark.parametrize(
    ("file", "line"),
    [
        ("imagery/a.py", "import qgis.core"),
        ("imagery/a.py", "from qgis.PyQt.QtCore import QObject"),
        ("imagery/a.py", "from matplotlib.figure import Figure"),
        ("imagery/a.py", "def lazily():\n    from ..toolkit import layers"),
        ("imagery/a.py", "from ..seams.measure import tone"),
        ("toolkit/a.py", "from ..seams import jobs"),
        ("toolkit/a.py", "from .. import provider"),
        ("toolkit/a.py", "from qgis import gui"),
        ("toolkit/charts/a.py", "from qgis.PyQt.QtWidgets import QDialog"),
        ("seams/measure/a.py", "from qgis.core import QgsTask"),
        ("seams/measure/a.py", "from matplotlib.figure import Figure"),
        ("seams/measure/a.py", "from ...toolkit import layers"),
        ("seams/measure/a.py", "from .. import jobs"),
        ("sensors/measure/models/a.py", "from ....provider import Provider"),
        ("noise/report.py", "from ..seams.measure import tone"),
        ("noise/desk/a.py", "from ...seams.desk.session import Session"),
        ("noise/a.py", "from .. import seams"),
        ("seams/algorithms/a.py", "from qgis.PyQt import QtWidgets"),
        ("seams/desk/a.py", "import matplotlib.pyplot as plt"),
        ("seams/desk/a.py", "from PyQt5.QtCore import Qt"),
        ("seams/desk/a.py", "from .... import classFactory"),
        ("seams/desk/a.py", "from seam_inspector.plugin.imagery import grids"),
        ("plugin.py", "from plugin.imagery import grids"),
    ],
)
def test_a_planted_violation_is_found(tmp_path: Path, file: str, line: str) -> None:
    path = tmp_path / file
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(line, encoding="utf-8")
    assert len(faults(tmp_path)) == 1
