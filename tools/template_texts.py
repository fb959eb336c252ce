"""Print the texts that the reports' templates mark by ``tr("...")`` as Python, for the tool that collects them."""
from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

from jinja2 import Environment, nodes


def texts(folder: Path) -> Iterator[str]:
    """Every text of every template; ValueError for one that is not written out, which nobody could collect."""
    environment = Environment()
    for path in sorted(folder.rglob("*.j2")):
        for call in environment.parse(path.read_text(encoding="utf-8")).find_all(nodes.Call):
            if isinstance(call.node, nodes.Name) and call.node.name == "tr":
                argument = call.args[0]
                if not isinstance(argument, nodes.Const):
                    raise ValueError(f"{path.name}, line {call.lineno}: tr() needs a text, written out")
                yield argument.value


if __name__ == "__main__":
    for text in dict.fromkeys(texts(Path(sys.argv[1]))):
        print(f"tr({text!r})")
