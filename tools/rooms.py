"""Lines, names and docstrings of each room against what it may have: `make lint` fails where one has grown.

What a room has today is its bound until it is smaller; then the bound goes down. ``GOALS`` is where they are to get.
"""
from __future__ import annotations

import ast
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

NAMELESS = ("one", "found", "own", "its", "told", "took")
"""Names of variables and arguments that say nothing of what they hold."""
FIRST_WORDS = ("Of", "By", "As", "The same", "Where", "Those", "Which")
"""Words that begin no docstring, which says what a thing is or does."""
GOALS = {
    "plugin/imagery": 4300, "plugin/seams/measure": 15500, "plugin/seams": 13000, "plugin/acceptance": 5400,
    "plugin/toolkit": 4200, "plugin/noise": 2000, "plugin/radiometry": 2000, "plugin/resolution": 3000,
    "plugin/photos": 3400, "plugin/sensors": 5000, "tests": 48000,
}  # fmt: skip
"""Lines that each room is to have at most."""


@dataclass(frozen=True)
class Measures:
    """Size and language of a room."""

    lines: int
    nameless: int
    first_words: int


BOUNDS = {
    "plugin/imagery": Measures(4669, 0, 0),
    "plugin/seams/measure": Measures(16306, 1, 0),
    "plugin/seams": Measures(12998, 0, 0),
    "plugin/acceptance": Measures(5400, 1, 0),
    "plugin/toolkit": Measures(4286, 0, 0),
    "plugin/noise": Measures(1922, 0, 0),
    "plugin/radiometry": Measures(1988, 0, 0),
    "plugin/resolution": Measures(2986, 0, 0),
    "plugin/photos": Measures(3397, 0, 0),
    "plugin/sensors": Measures(5083, 0, 0),
    "plugin": Measures(340, 0, 0),
    "python": Measures(1061, 0, 0),
    "tests": Measures(47957, 0, 0),
}
"""What each room may have; the most particular one holds for a file."""


def measured(source: str) -> Measures:
    """Measures of a file."""
    tree = ast.parse(source)
    words = [word + " " for word in FIRST_WORDS]
    return Measures(
        source.count("\n"),
        sum(name in NAMELESS for name in _names(tree)),
        sum(text.startswith(tuple(words)) for text in _docstrings(tree)),
    )


def _names(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id
        elif isinstance(node, ast.arg):
            yield node.arg


def _docstrings(tree: ast.AST) -> Iterator[str]:
    """Those of modules, classes and functions, and the strings below fields and constants."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            yield node.value.value


def main() -> int:
    """Print each room with its goal where it is beyond its bounds, or all with ``--all``."""
    sums: dict[str, Counter[str]] = {room: Counter() for room in BOUNDS}
    root = Path(__file__).parent.parent
    for folder in ("plugin", "python", "tests"):
        for path in sorted((root / folder).rglob("*.py")):
            folders = [parent.as_posix() for parent in path.relative_to(root).parents]
            room = next(parent for parent in folders if parent in BOUNDS)
            sums[room].update(vars(measured(path.read_text(encoding="utf-8"))))
    grown = False
    for room, bounds in BOUNDS.items():
        beyond = [name for name, most in vars(bounds).items() if sums[room][name] > most]
        grown |= bool(beyond)
        if beyond or "--all" in sys.argv:
            values = ", ".join(f"{sums[room][name]} {name} of {most}" for name, most in vars(bounds).items())
            print(f"{room}: {values}; goal {GOALS.get(room, '-')} lines", file=sys.stderr if beyond else sys.stdout)
    return int(grown)


if __name__ == "__main__":
    raise SystemExit(main())
