"""Hold every name of Qt in the tree against PyQt6's own, whatever mypy knows of the values.

    python -m tools.qt6.check_names [FILES]

PyQt6 stands under ``qgis.PyQt`` as in QGIS 4 (tests/qt6/stand_in). What is told:
- a class, attribute or enum that is not there; a class of Qt that is not imported by ``qgis.PyQt``
- an enum without its scope, also through an instance (``self.NoFrame``)
- a method that Qt 6 took away, wherever it is called
- arithmetic and ``int()`` with enums that are no numbers, and with a number where a flag is wanted
- signals chosen by a type (``activated[str]``) that Qt 6 took away
"""
from __future__ import annotations

import ast
import enum
import importlib
import re
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

CHECKOUT = Path(__file__).parents[2]
STAND_IN = CHECKOUT / "tests" / "qt6" / "stand_in"
FOLDERS = ("plugin", "demo", "benchmarks", "tests", "tools")
MODULES = ("QtCore", "QtGui", "QtWidgets", "QtSvg", "QtTest", "QtXml")

REMOVED_METHODS = {
    "exec_": "exec", "print_": "print", "posF": "position", "localPos": "position", "globalPos": "globalPosition",
    "windowPos": "scenePosition", "screenPos": "globalPosition",
    "globalX": "globalPosition", "globalY": "globalPosition",
    "setMargin": "setContentsMargins", "desktop": "screen", "numColors": "colorCount",
    "setNumColors": "setColorCount", "setTabStopWidth": "setTabStopDistance", "tabStopWidth": "tabStopDistance",
    "toTime_t": "toSecsSinceEpoch", "fromTime_t": "fromSecsSinceEpoch", "setTime_t": "setSecsSinceEpoch",
    "setClickable": "setSectionsClickable",
    "setCodec": "setEncoding", "isCopyOf": "isSharedWith", "setFilterRegExp": "setFilterRegularExpression",
    "filterRegExp": "filterRegularExpression", "setUserData": "setProperty", "keyboardModifiers": "modifiers",
    "mouseButtons": "buttons", "viewOptions": "initViewItemOption", "queryKeyboardModifiers": "QGuiApplication's",
}  # fmt: skip
"""With what Qt 6 has instead. Some are still there on other classes: those in ``_STILL_THERE``."""
_STILL_THERE = {
    "globalPos": {"QHelpEvent", "QContextMenuEvent"},
    "setMargin": {"QLabel"},
    "screenPos": {"QGraphicsSceneMouseEvent"},
    "keyboardModifiers": {"QApplication", "QGuiApplication"},
    "mouseButtons": {"QApplication", "QGuiApplication"},
    "queryKeyboardModifiers": {"QApplication", "QGuiApplication"},
}
REMOVED_ON = {
    "QMouseEvent": ("x", "y"), "QHoverEvent": ("pos",), "QDropEvent": ("pos",), "QDragMoveEvent": ("pos",),
    "QDragEnterEvent": ("pos",), "QEnterEvent": ("pos",), "QWheelEvent": ("pos", "x", "y", "delta", "orientation"),
    "QHeaderView": ("setResizeMode", "setMovable"),
    "QFontMetrics": ("width",), "QFontMetricsF": ("width",),
}  # fmt: skip
"""Methods that other classes have too: told where the value's class is said."""
_FONT_METRICS = ("fontMetrics",)


class Names:
    """Names of Qt as QGIS 4 has them."""

    def __init__(self) -> None:
        if str(STAND_IN) not in sys.path:
            sys.path.insert(0, str(STAND_IN))
        self.modules: dict[str, ModuleType] = {
            f"qgis.PyQt.{name}": importlib.import_module(f"qgis.PyQt.{name}") for name in (*MODULES, "sip")
        }
        self.members = frozenset(self._members())

    def _members(self) -> Iterator[str]:
        """The members of all enums inside classes, which PyQt5 has in the class too."""
        for module in self.modules.values():
            for thing in vars(module).values():
                if isinstance(thing, type):
                    for inner in vars(thing).values():
                        if isinstance(inner, type) and issubclass(inner, enum.Enum):
                            yield from inner.__members__


class Checked(ast.NodeVisitor):
    """What one file says wrongly of Qt: ``found``, by line."""

    def __init__(self, names: Names) -> None:
        self._names = names
        self.found: list[tuple[int, str]] = []
        self._imported: dict[str, Any] = {}  # name here -> PyQt6's thing
        self._declared: dict[str, str] = {}  # argument or variable -> its class, by annotation or call
        self._others: set[str] = set()  # imports that are none of Qt's, and what is called by a class of theirs
        self._told: set[ast.AST] = set()
        self._knows_qt = False
        self._called: set[ast.AST] = set()

    def _tell(self, node: ast.AST, text: str) -> None:
        self.found.append((getattr(node, "lineno", 0), text))

    # Imports

    def visit_Import(self, node: ast.Import) -> None:
        for alias in node.names:
            if re.match(r"(PyQt[456]|sip|PySide\d)\b", alias.name):
                self._tell(node, f"{alias.name}: import qgis.PyQt's")
            self._others.add((alias.asname or alias.name).partition(".")[0])

    def visit_ImportFrom(self, node: ast.ImportFrom) -> None:
        module = node.module or ""
        self._knows_qt |= module.startswith("qgis.")
        if re.match(r"(PyQt[456]|sip|PySide\d)\b", module) and not node.level:
            self._tell(node, f"{module}: import from qgis.PyQt")
        for alias in node.names:
            here = alias.asname or alias.name
            if module == "qgis.PyQt":
                known = self._names.modules.get(f"{module}.{alias.name}")
                if known is None:
                    self._tell(node, f"{module}.{alias.name} is not there")
                else:
                    self._imported[here] = known
            elif module in self._names.modules:
                if hasattr(self._names.modules[module], alias.name):
                    self._imported[here] = getattr(self._names.modules[module], alias.name)
                else:
                    self._tell(node, f"{module}.{alias.name} is not there")
            else:
                self._others.add(here)

    # What values are

    def visit_arg(self, node: ast.arg) -> None:
        if node.annotation is not None:
            self._declare(node.arg, node.annotation)
        self.generic_visit(node)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        self._declare(ast.unparse(node.target), node.annotation)
        self.generic_visit(node)

    def visit_Assign(self, node: ast.Assign) -> None:
        for target in node.targets:
            if isinstance(target, ast.Tuple) and isinstance(node.value, ast.Tuple):
                for inner, value in zip(target.elts, node.value.elts):
                    self._assign(ast.unparse(inner), value)
            else:
                self._assign(ast.unparse(target), node.value)
        self.generic_visit(node)

    def _assign(self, name: str, value: ast.expr) -> None:
        if isinstance(value, ast.Call):
            self._declare(name, value.func)
        elif isinstance(value, (ast.Attribute, ast.Name)):
            root, thing = self._named(value)
            if isinstance(thing, type):
                self._imported[name] = thing
            elif root in self._others:
                self._others.add(name.rpartition(".")[2])

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        outside = dict(self._declared)
        self.generic_visit(node)
        kept = {name: known for name, known in self._declared.items() if "." in name}  # self.x, for later methods
        self._declared = {**outside, **kept}

    def _declare(self, name: str, kind: ast.expr) -> None:
        parts = (part.rpartition(".")[2] for part in re.findall(r"[\w.]+", ast.unparse(kind)))
        classes = [part for part in parts if part not in ("None", "Optional")]
        self._declared.pop(name, None)
        if len(classes) == 1:
            self._declared[name] = classes[0]

    # Uses

    def visit_Attribute(self, node: ast.Attribute) -> None:
        if node not in self._told and not self._resolves(node):
            self._through_instance(node)
            self._overloaded(node)
        self.generic_visit(node)

    def _resolves(self, node: ast.Attribute) -> bool:
        """Whether it is a name below an import of Qt, in which case it is judged here."""
        chain = [node]
        while isinstance(chain[-1].value, ast.Attribute):
            chain.append(chain[-1].value)
        root = chain[-1].value
        if not isinstance(root, ast.Name) or root.id not in self._imported:
            return False
        self._told.update(chain)
        thing, path = self._imported[root.id], root.id
        for part in reversed(chain):
            if isinstance(thing, enum.Enum) or not isinstance(thing, (ModuleType, type)):
                return True  # beyond names: a value's own attributes
            if not hasattr(thing, part.attr):
                scope = _scope(thing, part.attr)
                hint = f": {path}.{scope}.{part.attr}" if scope else ""
                self._tell(node, f"{path}.{part.attr} is not there{hint}")
                return True
            thing, path = getattr(thing, part.attr), f"{path}.{part.attr}"
        return True

    def _through_instance(self, node: ast.Attribute) -> None:
        before = node.value
        name = before.attr if isinstance(before, ast.Attribute) else before.id if isinstance(before, ast.Name) else ""
        is_instance = name and not name[0].isupper() and name not in self._others
        is_member = node.attr[0].isupper() and node.attr in self._names.members and node not in self._called
        if self._knows_qt and is_instance and is_member:
            self._tell(node, f"{ast.unparse(node)}: an enum through an instance; scope it by its class")

    def _removed(self, node: ast.Attribute) -> None:
        kind = self._declared.get(ast.unparse(node.value), "")
        if isinstance(node.value, ast.Call):
            kind = ast.unparse(node.value.func).rpartition(".")[2]
        if node.attr in REMOVED_ON.get("QFontMetrics" if kind in _FONT_METRICS else kind, ()):
            self._tell(node, f"{ast.unparse(node)}: Qt 6's {kind} has no {node.attr}()")
        elif node.attr in REMOVED_METHODS and kind not in _STILL_THERE.get(node.attr, ()):
            self._tell(node, f"{ast.unparse(node)}: Qt 6 has {REMOVED_METHODS[node.attr]}()")

    def _overloaded(self, node: ast.Attribute) -> None:
        if node.attr in ("connect", "disconnect", "emit") and isinstance(node.value, ast.Subscript):
            signal = ast.unparse(node.value)
            self._tell(node, f"{signal}: Qt 6's signals are told apart by name (textActivated, idClicked)")

    # Numbers

    def visit_Call(self, node: ast.Call) -> None:
        if isinstance(node.func, ast.Attribute):
            self._called.add(node.func)
            self._removed(node.func)
        if ast.unparse(node.func) == "isinstance" and len(node.args) == 2:
            self._declare(ast.unparse(node.args[0]), node.args[1])  # from here on
        if isinstance(node.func, ast.Name) and node.func.id in ("int", "float") and len(node.args) == 1:
            value = self._enum(node.args[0])
            if value is not None and not isinstance(value, int):
                self._tell(node, f"{ast.unparse(node)}: no number in PyQt6")
        self.generic_visit(node)

    def visit_BinOp(self, node: ast.BinOp) -> None:
        for one, other in ((node.left, node.right), (node.right, node.left)):
            value = self._enum(one)
            if value is None:
                continue
            if isinstance(node.op, (ast.BitOr, ast.BitAnd, ast.BitXor)):
                if not isinstance(value, (enum.Flag, int)):
                    self._tell(node, f"{ast.unparse(node)}: {type(value).__name__} is no flag")
                elif isinstance(other, ast.Constant) and not isinstance(value, int):
                    self._tell(node, f"{ast.unparse(node)}: a flag and a number")
            elif not isinstance(value, int):
                self._tell(node, f"{ast.unparse(node)}: arithmetic with an enum; keys are joined by |")
            break
        self.generic_visit(node)

    def visit_Compare(self, node: ast.Compare) -> None:
        sides = [node.left, *node.comparators]
        for side, other in zip(sides, sides[1:]):
            for value, against in ((self._enum(side), other), (self._enum(other), side)):
                is_number = isinstance(against, ast.Constant) and type(against.value) is int
                if value is not None and not isinstance(value, int) and is_number:
                    self._tell(node, f"{ast.unparse(node)}: an enum of PyQt6 is never equal to a number")
        self.generic_visit(node)

    def _enum(self, node: ast.expr) -> enum.Enum | None:
        """The member of an enum that an expression names."""
        _, thing = self._named(node)
        return thing if isinstance(thing, enum.Enum) else None

    def _named(self, node: ast.expr) -> tuple[str, Any]:
        """The first name of an expression ``a.b.c``, and what of PyQt6 it names altogether."""
        parts: list[str] = []
        while isinstance(node, ast.Attribute):
            parts.append(node.attr)
            node = node.value
        if not isinstance(node, ast.Name):
            return "", None
        thing = self._imported.get(node.id)
        for part in reversed(parts):
            thing = getattr(thing, part, None)
        return node.id, thing


def _scope(thing: object, member: str) -> str:
    """The enum of a class that has the member."""
    return next(
        (name for name, inner in vars(thing).items()
         if isinstance(inner, type) and issubclass(inner, enum.Enum) and member in inner.__members__),
        "",
    )  # fmt: skip


def complaints(source: str, names: Names) -> list[tuple[int, str]]:
    """Lines and what is wrong in them."""
    checked = Checked(names)
    checked.visit(ast.parse(source))
    return sorted(set(checked.found))


def files(checkout: Path) -> Iterator[Path]:
    yield checkout / "__init__.py"
    for folder in FOLDERS:
        yield from (path for path in sorted((checkout / folder).rglob("*.py")) if STAND_IN not in path.parents)


def main(paths: Iterable[str]) -> int:
    names = Names()
    number = 0
    for path in [Path(path) for path in paths] or files(CHECKOUT):
        for line, text in complaints(path.read_text(encoding="utf-8"), names):
            number += 1
            print(f"{path.relative_to(CHECKOUT) if CHECKOUT in path.parents else path}:{line}: {text}")
    print(f"{number} names that PyQt6 has not")
    return 1 if number else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
