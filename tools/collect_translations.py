"""Bring a translation up to date with the texts of the code, templates and styles: `make translate`.

    python -m tools.collect_translations i18n/seam_inspector_pl.ts

New texts are added as unfinished, those that are gone leave, what is translated stays as it is. The tools of Qt 5 and
Qt 6 collect differently (PyQt6's leaves out `tr()` outside of classes and knows no function by another name), so the
file does not depend on which of them there is; both read it.
"""
from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree
from xml.sax.saxutils import escape

from tools import template_texts

CHECKOUT = Path(__file__).parents[1]
CONTEXT = "@default"
"""Where the plugin looks for all translations."""
_ARGUMENT = {"tr": 0, "Message": 0, "QT_TRANSLATE_NOOP": 1, "QT_TR_NOOP": 0}
"""Which argument of a call is a text to translate."""


class Translated(NamedTuple):
    """One entry: its state as Linguist writes it ("" for finished)."""

    text: str
    state: str


def found_texts(checkout: Path) -> dict[str, tuple[str, int] | None]:
    """Every text with its first place in the code; None for what stands in a template or style."""
    found: dict[str, tuple[str, int] | None] = {}
    for path in sorted((checkout / "plugin").rglob("*.py")):
        for text, line in texts_of(path.read_text(encoding="utf-8")):
            found.setdefault(text, (path.relative_to(checkout).as_posix(), line))
    for text in template_texts.texts(checkout / "resources"):
        found.setdefault(text, None)
    return found


def texts_of(source: str) -> Iterator[tuple[str, int]]:
    """Texts that a file marks for translation, with their lines."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in _ARGUMENT:
            place = _ARGUMENT[node.func.id]
            argument = node.args[place] if len(node.args) > place else None
            if isinstance(argument, ast.Constant) and isinstance(argument.value, str) and argument.value:
                yield argument.value, argument.lineno


def known_translations(path: Path) -> dict[str, Translated]:
    """What a translation file holds, by the English text, in the file's order."""
    if not path.exists():
        return {}
    entries = ElementTree.parse(path).getroot().iter("message")
    return {
        entry.findtext("source", ""): Translated(entry.findtext("translation", ""), node.get("type", ""))
        for entry in entries
        if (node := entry.find("translation")) is not None
    }


def written(found: dict[str, tuple[str, int] | None], known: dict[str, Translated]) -> str:
    """The file's text, as pylupdate5 writes it: entries in the order they had, new ones after them."""
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>", '<TS version="2.1">', "<context>"]
    lines.append(f"    <name>{CONTEXT}</name>")
    for text in [*(text for text in known if text in found), *(text for text in found if text not in known)]:
        translation, state = known.get(text, Translated("", "unfinished"))
        lines.append("    <message>")
        if place := found[text]:
            lines.append(f'        <location filename="../{place[0]}" line="{place[1]}"/>')
        kind = f' type="{state}"' if state else ""
        lines += [
            f"        <source>{_escaped(text)}</source>",
            f"        <translation{kind}>{_escaped(translation)}</translation>",
            "    </message>",
        ]
    return "\n".join([*lines, "</context>", "</TS>", ""])


def _escaped(text: str) -> str:
    return escape(text, {"'": "&apos;", '"': "&quot;"})


def main(path: Path) -> None:
    found, known = found_texts(CHECKOUT), known_translations(path)
    path.write_text(written(found, known), encoding="utf-8")
    new, gone = len(found.keys() - known.keys()), len(known.keys() - found.keys())
    print(f"{path.name}: {len(found)} texts, {new} new, {gone} gone")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
