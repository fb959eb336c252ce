"""Reports from templates: plain data in, one HTML page out.

The templates lie in ``resources/reports``. Whatever they are given is escaped, so that no name becomes markup.
"""
from __future__ import annotations

import base64
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path

import numpy as np
from jinja2 import Environment, FileSystemLoader, StrictUndefined

from ...imagery.atomic_files import whole_file
from ...imagery.message import Message
from ..resources import reports_path
from ..translation import language, sentence, tr


def save_page(path: Path, template: str, **view: object) -> None:
    """Write what a template makes of a view, piece by piece: what an iterator in it gives is never all in memory.

    An exception from such an iterator leaves no page, or the older one. Raises SettingsError where no file can be.
    """
    pieces = environment().get_template(f"{template}.html.j2").generate(view)
    with whole_file(path) as unfinished, unfinished.open("w", encoding="utf-8") as file:
        file.writelines(pieces)


def sentences_once(notices: Iterable[Message]) -> list[str]:
    """Messages in the user's language, each once."""
    return list(dict.fromkeys(map(sentence, notices)))


@cache
def environment() -> Environment:
    """Where templates are found, and what they know besides what they are given."""
    made = Environment(
        loader=FileSystemLoader(reports_path()), autoescape=True, undefined=StrictUndefined,
        trim_blocks=True, lstrip_blocks=True,
    )
    made.globals.update(tr=tr, language=language)
    made.filters.update(data_address=_data_address, number_columns=_number_columns)
    return made


def _data_address(data: bytes | str, media: str) -> str:
    """A picture file as the address of a picture."""
    content = data.encode() if isinstance(data, str) else data
    return f"data:image/{media};base64,{base64.b64encode(content).decode()}"


def _number_columns(headings: Sequence[str], rows: Sequence[Sequence[object]]) -> list[bool]:
    """Whether all of a column's values are numbers or empty."""
    return [bool(rows) and all(_is_number(row[place]) for row in rows) for place in range(len(headings))]


def _is_number(value: object) -> bool:
    """Whether it is a number, words that begin with one, or nothing."""
    if value is None or value == "" or isinstance(value, (int, float, np.number)):
        return True
    try:
        float(str(value).split()[0].rstrip("%"))
    except (ValueError, IndexError):
        return False
    return True
