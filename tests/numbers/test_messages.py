"""Every message is used with its sentence's values and at its level, and no text is shown that bypasses ``tr``."""
from __future__ import annotations

import ast
import importlib
import re
import string
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from seam_inspector.plugin.imagery.errors import Level, Message, placeholders
from seam_inspector.plugin.photos.measure import limits
from seam_inspector.plugin.photos.measure import messages as photos_messages

CODE = ("plugin", "tests", "demo", "benchmarks")
FAMILIES = (
    "RECOMMEND_", "ACCEPTED", "REJECTED", "UNDECIDED", "DOUBT_", "LIMIT_OF_", "WINDOWS_RENUMBERED",
    "WINDOWS_RESHAPED",
)  # fmt: skip
"""Messages that stand in a table without their values, one of which is taken and called: all take the same values."""
NO_ERROR = ("CancelledError",)  # exceptions by which the user's own wish is told
NUMERIC = "eEfFgGnd%"  # the formats that only numbers have


@dataclass(frozen=True)
class Use:
    """A place in the code that names a message."""

    place: str
    module: Path  # the file of the message, without its ending
    name: str
    call: ast.Call | None  # the call that gives it its values, if there is one
    is_compared: bool  # whether only its text is asked for, or it is held against another one
    exception: str  # the exception that it goes into as it is raised


def imported(tree: ast.Module, path: Path) -> tuple[dict[str, Path], dict[str, tuple[Path, str]]]:
    """Modules of messages by their name in a file, and messages imported by name."""
    modules: dict[str, Path] = {}
    names: dict[str, tuple[Path, str]] = {}
    for node in ast.walk(tree):
        if not isinstance(node, ast.ImportFrom):
            continue
        folder = path.parents[node.level - 1] if node.level else Path()
        target = folder.joinpath(*(node.module or "").removeprefix("seam_inspector.").split("."))
        for alias in node.names:
            if alias.name == "messages":
                modules[alias.asname or alias.name] = target / "messages"
            elif target.name == "messages":
                names[alias.asname or alias.name] = target, alias.name
    return modules, names


def uses(code: str, path: Path) -> Iterator[Use]:
    """Every use of a message in a file."""
    if "messages" not in code:
        return
    tree = ast.parse(code)
    parents = {child: node for node in ast.walk(tree) for child in ast.iter_child_nodes(node)}
    modules, names = imported(tree, path)
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in modules:
            module, name = modules[node.value.id], node.attr
        elif isinstance(node, ast.Name) and node.id in names:
            module, name = names[node.id]
        else:
            continue
        if not name.isupper() or name == "WORDS":
            continue
        parent = parents[node]
        call = parent if isinstance(parent, ast.Call) and parent.func is node else None
        is_compared = isinstance(parent, ast.Attribute) and parent.attr == "template"
        yield Use(
            f"{path}:{node.lineno}", module, name, call, is_compared or (path.parts[0] == "tests" and call is None),
            raised_by(call or node, parents),
        )


def raised_by(node: ast.expr, parents: dict[ast.AST, ast.AST]) -> str:
    """The name of the exception that is raised with this as its message; empty where none is."""
    while isinstance(parents[node], ast.IfExp):
        node = parents[node]  # type: ignore[assignment]
    maker = parents[node]
    if isinstance(maker, ast.Call) and isinstance(maker.func, ast.Name) and isinstance(parents[maker], ast.Raise):
        return maker.func.id
    return ""


@pytest.fixture(scope="module")
def all_uses(repository: Path) -> list[Use]:
    return [
        use
        for folder in CODE
        for path in sorted((repository / folder).rglob("*.py"))
        for use in uses(path.read_text(encoding="utf-8"), path.relative_to(repository))
    ]


def message(use: Use) -> Message | None:
    """The message of that name, if it is one."""
    module = importlib.import_module(".".join(["seam_inspector", *use.module.parts]))
    value = getattr(module, use.name, None)
    return value if isinstance(value, Message) else None


def fault(use: Use) -> str:
    """What is wrong with how a message is given its values; empty when nothing is."""
    shown = message(use)
    if shown is None:
        return "no such message"
    wanted = placeholders(shown.template)
    if use.call is None:
        is_free = use.is_compared or use.name.startswith(FAMILIES) or not wanted
        return "" if is_free else f"lacks {sorted(wanted)}"
    given = [keyword.arg for keyword in use.call.keywords]
    if use.call.args or None in given:
        return "values have to be named one by one"
    if set(given) != wanted:
        return f"takes {sorted(wanted)}, is given {sorted(map(str, given))}"
    words = [keyword.arg for keyword in use.call.keywords if is_text(keyword.value)]
    numbers = {name for _, name, form, _ in string.Formatter().parse(shown.template) if form and form[-1] in NUMERIC}
    return f"numbers wanted for {sorted(numbers & set(words))}" if numbers & set(words) else ""  # type: ignore[arg-type]


def is_text(value: ast.expr) -> bool:
    """Whether an expression is no number for sure."""
    if isinstance(value, ast.Constant):
        return not isinstance(value.value, (int, float))
    if isinstance(value, ast.Call):
        name = value.func.attr if isinstance(value.func, ast.Attribute) else getattr(value.func, "id", "")
        return name in ("str", "repr", "join", "format", "tuple", "list", "sorted") or name.isupper()
    if isinstance(value, ast.Attribute):
        return value.attr in ("name", "path", "message", "ref")
    return isinstance(value, (ast.JoinedStr, ast.Tuple, ast.List, ast.Dict, ast.Set))


def test_every_message_gets_the_values_that_it_takes(all_uses: list[Use]) -> None:
    assert len({(use.module, use.name) for use in all_uses}) > 250
    assert {f"{use.place} {use.name}": why for use in all_uses if (why := fault(use))} == {}


def test_messages_of_a_family_take_the_same_values(all_uses: list[Use]) -> None:
    for family in FAMILIES:
        taken = {placeholders(shown.template) for use in all_uses if use.name.startswith(family)
                 and (shown := message(use)) is not None}
        assert len(taken) == 1, family


def test_every_message_is_used(all_uses: list[Use], repository: Path) -> None:
    used: defaultdict[Path, set[str]] = defaultdict(set)
    for use in all_uses:
        if not use.place.startswith("tests"):
            used[use.module].add(use.name)
    for path in sorted((repository / "plugin").rglob("messages.py")):
        module = path.relative_to(repository).with_suffix("")
        members = vars(importlib.import_module(".".join(["seam_inspector", *module.parts])))
        assert {name for name, value in members.items() if isinstance(value, Message)} - used[module] == set(), module


def test_what_an_exception_carries_is_an_error(all_uses: list[Use]) -> None:
    raised = [use for use in all_uses if use.exception and use.place.startswith("plugin")]
    assert len(raised) > 150
    levels = {f"{use.place} {use.name}": shown.level for use in raised if (shown := message(use)) is not None
              and use.exception not in NO_ERROR}
    assert {place: level for place, level in levels.items() if level is not Level.ERROR} == {}


@pytest.mark.parametrize("words", [limits.MODELS, limits.STATES, limits.EVIDENCE])
def test_every_word_of_a_photo_has_its_message(words: tuple[str, ...]) -> None:
    assert set(words) <= set(photos_messages.WORDS)


ALL_SHOWN = {
    "QAction", "QCheckBox", "QGroupBox", "QLabel", "QMenu", "QPushButton", "QRadioButton", "QgsCollapsibleGroupBox",
    "addAction", "addButton", "addItem", "addItems", "addMenu", "addRow", "addTab", "addToolBar", "insertItem",
    "insertMenu", "insertTab", "about", "critical", "information", "question", "warning", "getText", "getDouble",
    "getOpenFileName", "getSaveFileName", "getExistingDirectory", "createMessage", "pushCritical", "pushInfo",
    "pushMessage", "pushSuccess", "pushWarning", "reportError", "setProgressText", "showMessage", "showText",
    "setAccessibleDescription", "setAccessibleName", "setDetailedText", "setFormat", "setHeaderLabels",
    "setHorizontalHeaderLabels", "setInformativeText", "setItemText", "setLabelText", "setPlaceholderText",
    "setPrefix", "setSpecialValueText", "setStatusTip", "setSuffix", "setTabText", "setText", "setTitle", "setToolTip",
    "setWhatsThis", "setWindowTitle", "drawText", "fromFunction",
}  # fmt: skip
"""Calls of Qt and QGIS whose texts are all for people."""
FIRST_SHOWN = {"annotate", "set_title", "set_xlabel", "set_ylabel", "supxlabel", "supylabel", "suptitle", "QgsTask"}
"""Calls of matplotlib and QGIS that take words of their own after it."""
OF_NO_LANGUAGE = {"DN", "windows.csv"}
_WORD = re.compile(r"[^\W\d_]{2}")


def bare_texts(source: str) -> Iterator[tuple[int, str]]:
    """Lines and literals with letters that are shown; what a call returns, that of ``tr`` above all, is none."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call):
            called = node.func
            name = called.attr if isinstance(called, ast.Attribute) else getattr(called, "id", "")
            given = node.args if name in ALL_SHOWN else node.args[:1] if name in FIRST_SHOWN else []
            for argument in given:
                yield from ((node.lineno, text) for text in _literals(argument) if _WORD.search(text))


def _literals(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif not isinstance(node, (ast.Call, ast.Compare, ast.Subscript)):
        for part in ast.iter_child_nodes(node):
            yield from _literals(part)


def test_no_shown_text_bypasses_the_translation(repository: Path) -> None:
    bare = [
        f"{path.relative_to(repository)}, line {line}: {text}"
        for path in sorted((repository / "plugin").rglob("*.py"))
        for line, text in bare_texts(path.read_text(encoding="utf-8"))
        if text not in OF_NO_LANGUAGE
    ]
    assert bare == []
