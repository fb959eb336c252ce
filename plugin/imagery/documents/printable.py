"""Names that others gave, as words that can be shown: what is invisible or turns words around is made plain."""
from __future__ import annotations

import re

_UNPRINTABLE = re.compile(
    "[\0-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f"  # control characters
    "\u200b\u2060\ufeff"  # without width
    "\u202a-\u202e\u2066-\u2069"  # which turn the direction of what follows
    "\ud800-\udfff\ufffe\uffff]"  # no characters: bytes of a file's name that are no text
)
_FORMULA = re.compile(r"[=+@\t\r-](?![\s\d.,%]*$)")
_LONGEST = 300  # letters of a name in a sentence


def printable(text: str) -> str:
    """A text with a question mark in a box for each character that shows nothing or does something."""
    return _UNPRINTABLE.sub("\ufffd", text)


def in_sentence(text: str) -> str:
    """A text on one line, its middle left out where it is very long."""
    line = " ".join(printable(text).splitlines())
    return line if len(line) <= _LONGEST else f"{line[: _LONGEST // 2]} … {line[-_LONGEST // 2 :]}"


def cell_text(text: str) -> str:
    """A text for a cell of a spreadsheet, which would else calculate what begins as a formula does."""
    return f"'{text}" if _FORMULA.match(text) else text


def of_cell(text: str) -> str:
    """The text that was made such a cell."""
    return text[1:] if text.startswith("'") and _FORMULA.match(text, 1) else text
