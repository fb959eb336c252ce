"""Print the texts of reports' templates and of layers' styles as Python, for the tool that collects them.

Templates mark them by ``tr("...")``, styles by ``/*tr*/'...'``; the labels of a style are texts too.
"""
from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from xml.etree.ElementTree import fromstring

from jinja2 import Environment, nodes

_LABELLED = ("category", "range", "rule", "item", "paletteEntry")
_MARKED = re.compile(r"/\*tr\*/'([^']+)'")


def texts(folder: Path) -> Iterator[str]:
    """Every text of every template and style; ValueError for one that is not written out, which none could collect."""
    environment = Environment()
    for path in sorted(folder.rglob("*.j2")):
        for call in environment.parse(path.read_text(encoding="utf-8")).find_all(nodes.Call):
            if isinstance(call.node, nodes.Name) and call.node.name == "tr":
                argument = call.args[0]
                if not isinstance(argument, nodes.Const):
                    raise ValueError(f"{path.name}, line {call.lineno}: tr() needs a text, written out")
                yield argument.value
    for path in sorted(folder.rglob("*.qml")):
        style = path.read_text(encoding="utf-8")
        yield from (label for one in fromstring(style).iter() if one.tag in _LABELLED and (label := one.get("label")))
        yield from _MARKED.findall(style)


if __name__ == "__main__":
    for text in dict.fromkeys(texts(Path(sys.argv[1]))):
        print(f"tr({text!r})")
