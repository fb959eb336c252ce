"""Write the types of QGIS 4's Python into a folder: qgis-stubs, which stand on PyQt5, turned to PyQt6.

The stubs are made of QGIS 3.44. What its Python adds to the classes when it is imported is not in them: names of enums
that moved to ``Qgis`` (``QgsProcessing.SourceType.TypeRaster``), exceptions, the version. They are added here.
"""
from __future__ import annotations

import ast
import re
import sys
from collections import defaultdict
from importlib.metadata import distribution
from pathlib import Path

STAND_IN = Path(__file__).parents[2] / "tests" / "qt6" / "stand_in" / "qgis" / "PyQt"
_CORE = """
import types
from qgis._core import *
from qgis.PyQt.QtCore import NULL

class edit:
    def __init__(self, layer: QgsVectorLayer) -> None: ...
    def __enter__(self) -> QgsVectorLayer: ...
    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, trace: types.TracebackType | None
    ) -> bool: ...

class QgsCsException(Exception): ...
class QgsProcessingException(Exception): ...
"""
_UTILS = """
import typing
from qgis.gui import QgisInterface

iface: QgisInterface
plugins: dict[str, typing.Any]
active_plugins: list[str]
def loadPlugin(packageName: str) -> bool: ...
def startPlugin(packageName: str) -> bool: ...
def unloadPlugin(packageName: str) -> bool: ...
def updateAvailablePlugins(sort_by_dependencies: bool = ...) -> None: ...
"""
_VERSION = ("QGIS_VERSION: str", "QGIS_VERSION_INT: int")


def dotted(node: ast.expr) -> str:
    """``a.b.c`` of an expression that is nothing else, or an empty text."""
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute) and (before := dotted(node.value)):
        return f"{before}.{node.attr}"
    return ""


def added_members(additions: str) -> dict[str, dict[str, None]]:
    """Old names by enum (``Qgis.GeometryType``) that QGIS's own ``__init__.py`` gives to its members."""
    found: dict[str, dict[str, None]] = defaultdict(dict)
    for node in ast.parse(additions).body:
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            old, new = dotted(node.targets[0]), dotted(node.value)
            if old.count(".") == 2 and new.startswith("Qgis.") and new.count(".") == 2:
                found[new.rpartition(".")[0]][old.rpartition(".")[2]] = None
    return found


def with_static_methods(stub: str) -> str:
    """The stub of QtTest: all methods of QTest are static, and PyQt6's says so of none."""
    return re.sub(r"^    def (\w+)\(self(?:, )?", r"    @staticmethod\n    def \1(", stub, flags=re.MULTILINE)


def with_additions(stub: str, members: dict[str, dict[str, None]]) -> str:
    """The stub of a module with the members that its enums get later, and with the types of types as such."""
    lines, outer = [], ""
    for line in stub.splitlines():
        # `Type: typing.Type[Qgis.WkbType]` is a variable to mypy, so that no annotation can use it
        lines.append(re.sub(r"^(    \w+): typing\.Type\[([\w.]+)\]\s*$", r"\1: typing.TypeAlias = \2", line))
        if match := re.match(r"class (\w+)\(", line):
            outer = match[1]
            lines += [f"    {name}" for name in _VERSION if outer == "Qgis"]
        elif match := re.match(r"    class (\w+)\(", line):
            full = f"{outer}.{match[1]}"
            lines += [f"        {name} = ...  # type: {full}" for name in members.get(full, ())]
            if line.endswith("(int):"):  # an enum; of flags it would be int otherwise
                lines.append(f"        def __or__(self, other: {full}) -> {full}: ...  # type: ignore")
    return "\n".join(lines) + "\n"


def write(folder: Path) -> None:
    stubs = Path(str(distribution("qgis-stubs").locate_file("qgis-stubs")))
    members = added_members((stubs / "core" / "__init__.py").read_text(encoding="utf-8"))
    package = folder / "qgis"
    (package / "PyQt").mkdir(parents=True, exist_ok=True)
    for path in STAND_IN.glob("*.py"):
        (package / "PyQt" / f"{path.stem}.pyi").write_text(path.read_text(encoding="utf-8"), encoding="utf-8")
    test = Path(str(distribution("PyQt6").locate_file("PyQt6/QtTest.pyi"))).read_text(encoding="utf-8")
    (package / "PyQt" / "QtTest.pyi").write_text(with_static_methods(test), encoding="utf-8")
    for name in ("_core", "_gui"):
        stub = (stubs / f"{name}.pyi").read_text(encoding="utf-8").replace("PyQt5", "PyQt6")
        stub = stub.replace("from warnings import deprecated", "from typing_extensions import deprecated")
        (package / f"{name}.pyi").write_text(with_additions(stub, members), encoding="utf-8")
    for name, text in {
        "__init__": "", "core": _CORE, "gui": "from qgis._gui import *\n", "utils": _UTILS,
    }.items():  # fmt: skip
        (package / f"{name}.pyi").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    write(Path(sys.argv[1]))
