"""Write what the guide says of the Python interface: its reference, and its notebook.

    python -m tools.python_pages

docs/python/reference.md is made of `__init__.pyi` and the docstrings, docs/python/first_steps.ipynb of first_steps.md.
A test fails where they differ.
"""
from __future__ import annotations

import ast
import inspect
import json
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from itertools import groupby
from pathlib import Path
from textwrap import dedent

import seam_inspector

REPOSITORY = Path(__file__).parents[1]
STUB = REPOSITORY / "__init__.pyi"
PAGES = REPOSITORY / "docs" / "python"
REFERENCE, FIRST_STEPS, NOTEBOOK = PAGES / "reference.md", PAGES / "first_steps.md", PAGES / "first_steps.ipynb"
RECIPES, COMMANDS = PAGES / "recipes.md", PAGES / "command_line.md"

_IMPORT = re.compile(r"from \.(\S+) import (\w+) as \2$")
_MEMBERS = "#: "
_FENCE = re.compile(r"^```(python|text|shell)\n(.*?)^```\n", re.MULTILINE | re.DOTALL)
_HEADING = re.compile(r"^#+ (.+)$", re.MULTILINE)
_SECTION = re.compile(r"^(Parameters)\n-+\n((?:.+(?:\n|$))+)", re.MULTILINE)
_PARAMETER = re.compile(r"^(\S.*) : (.+)((?:\n {4}.*)*)", re.MULTILINE)
_PICTURE = re.compile(r"^!\[[^]]*\]\([^)]*\)\n", re.MULTILINE)
_ALIAS = re.compile(r"(?<![\w.])[A-Z]\w*")
_HEAD = """\
# Reference of the Python interface

Made of the docstrings. Whatever is listed here is imported from `seam_inspector` itself; `help(name)` says the same.
What `help` shows beside it serves the package alone, and may change.
Arrays have their shape in brackets, names of lengths end in `_m` (metres on the ground) or `_px`, grey values are those
of the file (DN).
"""


@dataclass(frozen=True)
class Entry:
    """A name of the interface."""

    name: str
    chapter: str
    module: str
    node: ast.FunctionDef | ast.ClassDef
    members: tuple[str, ...] = ()
    """Those that are told of; all where it is empty."""

    @property
    def line(self) -> str:
        """The first sentence of its docstring."""
        text = " ".join((ast.get_docstring(self.node) or "").split("\n\n")[0].split())
        return _cell(re.split(r"(?<=[.]) (?=[A-Z`])", text)[0])


def entries() -> list[Entry]:
    """All names in the stub's order, each under the comment above it."""
    found, chapter = [], ""
    for line in STUB.read_text("utf-8").splitlines():
        if line.startswith("# "):
            chapter = line[2:]
        elif match := _IMPORT.match(line):
            found.append(Entry(match[2], chapter, match[1], _definition(match[1], match[2])))
        elif line.startswith(_MEMBERS):
            found[-1] = replace(found[-1], members=tuple(line.removeprefix(_MEMBERS).split()))
    return found


@cache
def unnamed_types() -> frozenset[str]:
    """Names of the package's classes that the interface does not have, so that no page names them."""
    files = [path for room in ("plugin", "python") for path in (REPOSITORY / room).rglob("*.py")]
    classes = {name for path in files for name in re.findall(r"^class (\w+)", path.read_text("utf-8"), re.MULTILINE)}
    return frozenset(classes - {entry.name for entry in entries()})


def blocks(page: Path, language: str = "python") -> list[tuple[str, str]]:
    """The code of a page in a language, each block with the heading above it."""
    text = page.read_text("utf-8")
    fences = (fence for fence in _FENCE.finditer(text) if fence[1] == language)
    return [(_HEADING.findall(text[: fence.start()])[-1], fence[2]) for fence in fences]


def example(name: str) -> str:
    """A link to the first place of the pages whose code has a name; empty where none has it."""
    for page in (FIRST_STEPS, RECIPES):
        for heading, code in blocks(page):
            if re.search(rf"\b{name}\b", code):
                anchor = re.sub(r"[^\w\s-]", "", heading).strip().lower().replace(" ", "-")
                return f"[{heading}]({page.name}#{anchor})"
    return ""


def reference() -> str:
    """The page: what each chapter holds, then each name by itself."""
    made = [_HEAD]
    for chapter, of_chapter in groupby(entries(), lambda entry: entry.chapter):
        listed = list(of_chapter)
        rows = "".join(f"| [`{one.name}`](#{one.name.lower()}) | {one.line} |\n" for one in listed)
        made.append(f"## {chapter}\n\n| name | what it is |\n|---|---|\n{rows}")
        made += ["\n".join(_section(one)) for one in listed]
    return "\n".join(made)


def cells() -> list[tuple[str, str]]:
    """The notebook's cells as kind and text: ``code`` of what is Python on the page, ``markdown`` of all else."""
    page, found, start = FIRST_STEPS.read_text("utf-8"), [], 0
    for fence in _FENCE.finditer(page):
        found.append(("markdown", page[start : fence.start()]))
        start = fence.end()
        if fence[1] == "python":
            found.append(("code", fence[2]))
    found.append(("markdown", page[start:]))
    stripped = ((kind, _PICTURE.sub("", text).strip("\n")) for kind, text in found)
    return [(kind, text) for kind, text in stripped if text]


def printed() -> list[str]:
    """For each cell of code what the page says that it prints; empty where it says nothing."""
    found: list[str] = []
    for fence in _FENCE.finditer(FIRST_STEPS.read_text("utf-8")):
        if fence[1] == "python":
            found.append("")
        else:
            found[-1] = fence[2]
    return found


def notebook() -> str:
    """The file, clean of outputs."""
    made = [
        {"cell_type": kind, "id": f"cell-{number}", "metadata": {}, "source": text.splitlines(keepends=True),
         **({"execution_count": None, "outputs": []} if kind == "code" else {})}
        for number, (kind, text) in enumerate(cells(), 1)
    ]  # fmt: skip
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    whole = {"cells": made, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}
    return json.dumps(whole, indent=1, ensure_ascii=False) + "\n"


def _section(entry: Entry) -> Iterator[str]:
    yield f"### {entry.name}\n"
    if isinstance(entry.node, ast.FunctionDef):
        yield f"```python\n{_signature(entry)}\n```\n"
    yield _docstring(entry.node)
    yield f"Example: {example(entry.name)}.\n"
    if isinstance(entry.node, ast.ClassDef):
        rows = [_row(*member) for member in members(entry)]
        if rows:
            yield "\n".join(["| name | type | what it is |", "|---|---|---|", *rows]) + "\n"


def members(entry: Entry) -> Iterator[tuple[str, str, str]]:
    """Fields with their defaults and words, then properties and methods: how each is called, its type, and what its
    docstring or the comment beside it says. Without those that are of a type that has no name here."""
    for name, called, kind, words in _all_members(entry):
        if (not entry.members or name in entry.members) and not unnamed_types() & {*re.findall(r"\w+", kind)}:
            yield called, kind, words


def _all_members(entry: Entry) -> Iterator[tuple[str, str, str, str]]:
    loaded, body = getattr(seam_inspector, entry.name), entry.node.body
    for one, after in zip(body, [*body[1:], None]):
        words = after.value.value if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant) else ""
        words = words or _comment(entry.module, one)
        if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name):
            default = getattr(loaded, one.target.id, None)
            shown = f" = {default!r}" if type(default) in (int, float, str, bool) and default != "" else ""
            yield one.target.id, one.target.id, _unfolded(ast.unparse(one.annotation), entry.module) + shown, words
        elif isinstance(one, ast.Assign) and isinstance(one.targets[0], ast.Name):
            name = one.targets[0].id
            yield name, name, repr(getattr(loaded, name).value), words
    for one in body:
        if isinstance(one, ast.FunctionDef) and not one.name.startswith("_"):
            is_property = any("property" in ast.unparse(decorator) for decorator in one.decorator_list)
            names = [argument.arg for argument in (*one.args.args, *one.args.kwonlyargs) if argument.arg != "self"]
            called = one.name if is_property else f"{one.name}({', '.join(names)})"
            kind = _unfolded(ast.unparse(one.returns), entry.module) if one.returns else ""
            yield one.name, called, kind, ast.get_docstring(one) or ""


def _comment(module: str, node: ast.stmt) -> str:
    """What stands beside a field, with a capital letter and a full stop."""
    words = _source(module).splitlines()[node.lineno - 1].partition("  # ")[2]
    return f"{words[0].upper()}{words[1:].removesuffix('.')}." if words else ""


def _row(called: str, kind: str, words: str) -> str:
    return f"| `{called}` | `{_cell(kind)}` | {_cell(dedent(words).split(chr(10) * 2)[0])} |"


def _cell(text: str) -> str:
    """On one line, as a table of Markdown takes it."""
    return _markdown(" ".join(text.split())).replace("|", "\\|")


def _signature(entry: Entry) -> str:
    """One argument a line where they are many; defaults that have a name as their values."""
    node = entry.node
    arguments = ast.unparse(node.args)
    for name, parameter in inspect.signature(getattr(seam_inspector, node.name)).parameters.items():
        value = f"={parameter.default!r}"
        arguments = re.sub(rf"\b({name}: [^,=]+)=[\w.]*[A-Z]{{2}}\w*", rf"\g<1>{value}", arguments)
    arguments = _unfolded(arguments, entry.module)
    returned = _unfolded(ast.unparse(node.returns), entry.module) if node.returns else "None"
    whole = f"{node.name}({arguments}) -> {returned}"
    if len(whole) <= 100:
        return whole
    parts = "".join(f"    {part},\n" for part in _split(arguments))
    return f"{node.name}(\n{parts}) -> {returned}"


def _unfolded(annotation: str, module: str) -> str:
    """An annotation with what its names stand for, where they stand for several types or are names of tuples."""
    return re.sub(r"None \| None\b", "None", _ALIAS.sub(lambda name: _meaning(name[0], module), annotation))


def _meaning(name: str, module: str) -> str:
    """What a name is in a module, if it is no class: as ``X | Y`` where it is a union."""
    for node in _module(module).body:
        if (
            isinstance(node, ast.Assign) and isinstance(node.value, ast.Subscript)
            and ast.unparse(node.targets[0]) == name
        ):
            meant = node.value.slice if ast.unparse(node.value.value) == "Union" else None
            parts = meant.elts if isinstance(meant, ast.Tuple) else [node.value]
            return " | ".join(_unfolded(ast.unparse(part).strip("'"), module) for part in parts)
        if isinstance(node, ast.ImportFrom) and node.level and name in [alias.name for alias in node.names]:
            return _meaning(name, ".".join([*module.split(".")[: -node.level], node.module or ""]))
    return name


def _split(arguments: str) -> Iterable[str]:
    """At the commas outside of brackets."""
    depth, part = 0, ""
    for letter in arguments:
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "," and not depth:
            yield part.strip()
            part = ""
        else:
            part += letter
    yield part.strip()


def _docstring(node: ast.FunctionDef | ast.ClassDef) -> str:
    return _SECTION.sub(_listed, _markdown(ast.get_docstring(node) or "")) + "\n"


def _listed(section: re.Match[str]) -> str:
    """A section of numpydoc as a list."""
    items = (f"- `{name}`, {kind}: {' '.join(text.split())}" for name, kind, text in _PARAMETER.findall(section[2]))
    return f"{section[1]}:\n\n" + "\n".join(items) + "\n"


def _markdown(text: str) -> str:
    return text.replace("``", "`")


@cache
def _source(module: str) -> str:
    return (REPOSITORY / module.replace(".", "/")).with_suffix(".py").read_text("utf-8")


@cache
def _module(name: str) -> ast.Module:
    return ast.parse(_source(name))


def _definition(module: str, name: str) -> ast.FunctionDef | ast.ClassDef:
    return next(
        node for node in _module(module).body
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and node.name == name
    )


def main() -> None:
    """Command line."""
    REFERENCE.write_text(reference(), encoding="utf-8")
    NOTEBOOK.write_text(notebook(), encoding="utf-8")


if __name__ == "__main__":
    main()
