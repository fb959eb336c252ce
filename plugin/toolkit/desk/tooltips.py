"""Tooltips that wrap."""
from __future__ import annotations

from html import escape


def rich_tip(text: str, *lines: str) -> str:
    """Qt breaks the lines of a tooltip only when it is rich text; ``lines`` stand below it."""
    below = f"<p>{'<br>'.join(map(escape, lines))}</p>" if lines else ""
    return f"<p>{escape(text)}</p>{below}"


def plain_tip(text: str) -> str:
    """A tooltip of names that others gave: its lines as they are, whatever markup Qt would see in them."""
    first, *lines = text.splitlines() or [""]
    return rich_tip(first, *lines) if "<" in text or "&" in text else text
