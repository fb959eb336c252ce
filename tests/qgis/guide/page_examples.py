"""The examples on the pages of the algorithms, and the commands on all others, as a reader would copy them."""
from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import Any

DOCS = Path(__file__).parents[3] / "docs"
PAGES = DOCS / "algorithms"
NAMES = sorted(path.stem for path in PAGES.glob("*.md") if path.stem != "index")
Call = tuple[str, dict[str, Any]]
_BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_COMMAND = re.compile(r"^ {4,}((?:qgis_process run|gdaltindex|mkdir|\(judge) (?:.*\\\n)*.*)$", re.MULTILINE)


def page(name: str) -> str:
    """The page of an algorithm."""
    return (PAGES / f"{name}.md").read_text("utf-8")


def blocks(name: str, language: str) -> list[str]:
    """What stands in a page's blocks of a language."""
    return [code for result, code in _BLOCK.findall(page(name)) if result == language]


def shell_call(block: str) -> Call:
    """What a block asks qgis_process for: a parameter that comes more than once is a list."""
    program, run, algorithm, *options = shlex.split(block.replace("\\\n", " "))
    assert (program, run) == ("qgis_process", "run")
    parameters: dict[str, Any] = {}
    for option in options:
        name, equals, value = option.partition("=")
        assert name.startswith("--")
        assert equals
        before = parameters.get(name[2:])
        parameters[name[2:]] = value if before is None else [*(before if isinstance(before, list) else [before]), value]
    return algorithm, parameters


def same_call(call: Call) -> tuple[str, dict[str, list[str]]]:
    """A call in words, to compare those of two ways."""
    algorithm, parameters = call
    lists = ((name, value if isinstance(value, list) else [value]) for name, value in parameters.items())
    return algorithm, {name: [str(value) for value in values] for name, values in lists}


def commands(path: Path) -> list[str]:
    """Commands of a page in its order, and where windows are to be judged in between."""
    return [str(command) for command in _COMMAND.findall(path.read_text("utf-8"))]
