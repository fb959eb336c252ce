"""A window's result as bytes that are kept beside the window layer, and back."""
from __future__ import annotations

from functools import cache
from typing import Any

from ....imagery import messages as imagery_messages
from ....imagery.errors import Message
from ....imagery.records import NotUnderstoodError, record_of, value_of
from .. import messages
from .window_result import WindowResult


def result_record(result: WindowResult) -> bytes:
    """All that was measured; the picture of the loss to a two-thousandth."""
    return record_of(result)


def result_of(record: bytes) -> WindowResult | None:
    """None for what can't be read, or is of another version."""
    try:
        found: Any = value_of(WindowResult, record, _sentences())
    except NotUnderstoodError:
        return None
    return found if isinstance(found, WindowResult) else None


@cache
def _sentences() -> dict[str, Message]:
    """Those that a result may hold."""
    every = (*vars(imagery_messages).values(), *vars(messages).values())
    return {one.template: one for one in every if isinstance(one, Message)}
