"""Hold the tree's calls of Qt and QGIS against the types of PyQt6 and QGIS 4, by mypy.

What is told is a name that is not there, an argument that does not fit, and what is deprecated. Types of our own are
lint's part; of the rest, what mypy can't know is left out by the rules here, each with its reason.
"""
from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from importlib.metadata import distribution
from pathlib import Path

CHECKOUT = Path(__file__).parents[2]
TYPINGS = CHECKOUT / ".venv-qt6" / "typings"
PACKAGES = ("seam_inspector.plugin", "demo", "benchmarks", "tests", "tools")
_OF_QT = re.compile(r"\b(Q[A-Z]\w+|Qgs\w+|Qgis|qgis\._\w+|Qt|pyqt\w+)\b")
_MISSING = re.compile(r'(?:of ")?"?(?:type\[)?(\w+)\]?"? has no attribute "(\w+)"')
_UNFIT = re.compile(
    r'(?:has incompatible type|expression has type|got) "(?P<given>[^"]+)"[;,] '
    r'(?:variable has type|expected) "(?P<wanted>[^"]+)"'
)

_ACCEPTED = {
    r'No overload variant of "bytes" matches argument type "QByteArray"': "PyQt6's types lack its __bytes__",
    r'Signature of "prepare" incompatible with supertype "qgis._core.QgsProcessingAlgorithm"':
        "ours is called by processAlgorithm; QGIS's own is not virtual, so that nothing of QGIS finds ours",
    r'Argument 3 of "dataChanged" is incompatible': "it is handed on as it came",
    r"QgsProject.setAutoTransaction is deprecated": "its successor came with QGIS 3.26",
    r'"(Qgs\w+|Q\w+)" has no attribute "__iter__"': "has __getitem__ and __len__, by which Python iterates",
    r'incompatible type "\*\*dict': "which argument a dict of arguments fills is in its keys",
    r'"(get|pop)" of "dict" matches argument types? "QObject"': "sender() is declared as QObject",
    r'No overload variant of "list" matches argument type "QgsFields"': "as above",
}  # fmt: skip


@dataclass
class Known:
    """Classes of Qt, of QGIS and of ours: what they stand on, and what is in them."""

    bases: dict[str, set[str]] = field(default_factory=dict)
    names: dict[str, set[str]] = field(default_factory=dict)

    def add(self, source: str) -> None:
        for node in ast.walk(ast.parse(source)):
            if isinstance(node, ast.ClassDef):
                self.bases.setdefault(node.name, set()).update(_last(base) for base in node.bases)
                self.names.setdefault(node.name, set()).update(_members(node))

    @cached_property
    def children(self) -> dict[str, set[str]]:
        found: dict[str, set[str]] = {}
        for name, bases in self.bases.items():
            for base in bases:
                found.setdefault(base, set()).add(name)
        return found

    def below(self, name: str) -> set[str]:
        """All classes that stand on this one, itself left out."""
        found: set[str] = set()
        waiting = [name]
        while waiting:
            new = self.children.get(waiting.pop(), set()) - found
            found |= new
            waiting += new
        return found

    def may_have(self, name: str, attribute: str) -> bool:
        """Whether a class that stands on this one has it: the value is one of those, only declared as its base."""
        return any(attribute in self.names.get(above, ()) for child in self.below(name) for above in self.above(child))

    def above(self, name: str) -> set[str]:
        """The class and all that it stands on."""
        found, waiting = {name}, [name]
        while waiting:
            new = self.bases.get(waiting.pop(), set()) - found
            found |= new
            waiting += new
        return found


def _last(node: ast.expr) -> str:
    if isinstance(node, ast.Subscript):
        return _last(node.value)
    return node.attr if isinstance(node, ast.Attribute) else getattr(node, "id", "")


def _members(node: ast.ClassDef) -> Iterator[str]:
    for inner in ast.walk(node):
        if isinstance(inner, (ast.FunctionDef, ast.ClassDef)):
            yield inner.name
        elif isinstance(inner, ast.Attribute) and isinstance(inner.value, ast.Name) and inner.value.id == "self":
            yield inner.attr
        elif isinstance(inner, ast.Name) and isinstance(inner.ctx, ast.Store):
            yield inner.id


def known_classes(checkout: Path) -> Known:
    known = Known()
    qt = Path(str(distribution("PyQt6").locate_file("PyQt6")))
    stubs = [qt / f"{name}.pyi" for name in ("QtCore", "QtGui", "QtWidgets")]
    stubs += [TYPINGS / "qgis" / f"{name}.pyi" for name in ("_core", "_gui")]
    ours = [path for folder in ("plugin", "demo", "tests") for path in (checkout / folder).rglob("*.py")]
    for path in (*stubs, *ours):
        known.add(path.read_text(encoding="utf-8"))
    return known


def is_accepted(message: str, known: Known) -> bool:
    """Whether a message of mypy is none of this check, or one that mypy can't know better."""
    if any(re.search(pattern, message) for pattern in _ACCEPTED):
        return True
    if match := _MISSING.search(message):  # of Qt's class or of ours that stands on one
        is_of_qt = any(_OF_QT.fullmatch(name) for name in known.above(match[1]) | {match[1]})
        return known.may_have(match[1], match[2]) if is_of_qt else not _OF_QT.search(message)
    if not _OF_QT.search(message):
        return True
    if match := _UNFIT.search(message):
        given, wanted = (_classes(match[name]) for name in ("given", "wanted"))
        return "object" in given or any(one in known.below(other) for one in wanted for other in given)
    return False


def _classes(text: str) -> set[str]:
    """``QWidget | None``, ``type[QWidget]``, ``qgis._core.QgsProject``: the names of classes alone."""
    return {part.rpartition(".")[2] for part in re.findall(r"[\w.]+", text)} - {"None", "type"}


def complaints(lines: Iterable[str], known: Known) -> list[str]:
    """mypy's errors about Qt and QGIS that no rule accepts, with paths from the checkout."""
    found = []
    for line in lines:
        match = re.match(r"(?P<place>[^:]+:\d+): error: (?P<message>.*)$", line)
        if match and not is_accepted(match["message"], known):
            found.append(f"{match['place'].replace('build/plugins/seam_inspector/', '')}: {match['message']}")
    return found


def main() -> int:
    packages = [word for name in PACKAGES for word in ("-p", name)]
    run = subprocess.run(
        [sys.executable, "-m", "mypy", "--config-file", "tools/qt6/mypy.ini", *packages],
        cwd=CHECKOUT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    if run.returncode > 1 or "prevented further checking" in run.stdout:  # 1 is for errors found
        print(run.stdout, run.stderr, sep="\n", file=sys.stderr)
        return 2
    found = complaints(run.stdout.splitlines(), known_classes(CHECKOUT))
    print(*found, f"{len(found)} uses of Qt and QGIS that QGIS 4 has not", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
