"""What observers say of a window at 2x magnification, and who says it."""
from __future__ import annotations

from typing import NamedTuple

VISIBLE, INVISIBLE, UNSURE = "visible", "invisible", "unsure"
DECIDED = (VISIBLE, INVISIBLE)
"""The words that are a verdict; whoever is not sure has looked and not judged."""


class Operator(NamedTuple):
    """One of two who judge the same windows: the fields of the window layer that are his, records' too."""

    observer: str
    """His word."""
    confidence: str
    """How sure he is of it, 0 to 100."""
    remark: str


FIRST = Operator("observer", "confidence", "remark")
SECOND = Operator("observer_2", "confidence_2", "remark_2")
OPERATORS = (FIRST, SECOND)
JUDGING_FIELDS = {
    field: kind
    for operator in OPERATORS
    for field, kind in zip(operator, ("text", "integer", "text"))
}
"""The fields of both and their kinds. A window layer has those that were used, the first one's word always."""
