"""The texts of reports' templates, layers' styles, rules and models, for the tool that collects them.

Templates mark them by ``tr("...")``, styles by ``/*tr*/'...'``; the labels of a style are texts too, and of rules
and models what people read of them.
"""
from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from xml.etree.ElementTree import Element, fromstring

from jinja2 import Environment, nodes

_LABELLED = ("category", "range", "rule", "item", "paletteEntry")
_MODEL_TEXTS = ("description", "component_description", "model_group", "help")
_MODEL_FACTS = ("ALG_CREATOR", "ALG_VERSION")
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
    for path in sorted(folder.rglob("rules/**/*.json")):
        content = json.loads(path.read_text(encoding="utf-8"))
        yield from (content["name"], *(rule["source"] for rule in content["rules"]))
    for path in sorted(folder.rglob("*.model3")):
        yield from _of_model(fromstring(path.read_text(encoding="utf-8")), is_help=False)
        yield path.stem.replace("_", " ").capitalize()


def _of_model(option: Element, is_help: bool) -> Iterator[str]:
    """Titles and help of a model and of its parts; who made it is a name."""
    for one in option:
        name, value = one.get("name", ""), one.get("value", "")
        if value and (is_help or name in _MODEL_TEXTS) and name not in _MODEL_FACTS and one.get("type") == "QString":
            yield value
        yield from _of_model(one, is_help or name == "help")
