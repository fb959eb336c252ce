"""In which order windows are judged."""
from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ....imagery.statistics import FIRST, SECOND, VISIBLE
from ...judged_value import judged_value
from ...measure.window_records import WindowRecord

_CLAIMS = ("significant", "reduced", "preserved")
_WORST = (*_CLAIMS, "not_comparable")


class WindowOrder(NamedTuple):
    """An order of windows. Title and tooltip are marked for translation, not translated."""

    name: str
    """As the project keeps it."""
    title: str
    tooltip: str
    key: Callable[[WindowRecord], Any] | None
    """What windows are sorted by, None where one has no place in the order; without a key as the table's columns are.
    """
    tells_verdict: bool = False
    """Whether the order gives away what the tool found, or what the other operator said."""


def along_the_seam(row: WindowRecord) -> tuple[float, float, int]:
    """By seam and station where windows have them, else by number, as they were placed."""
    seam = math.inf if row.seam_id is None else row.seam_id
    return seam, row.station or 0.0, row.window_id


def worst_first(row: WindowRecord) -> tuple[int, float] | None:
    """By the verdict, then by what it was taken by: numbers of another verdict may be smaller, but mean less."""
    if row.verdict not in _WORST:
        return None
    value = judged_value(row)
    return _WORST.index(row.verdict), math.inf if value is None else value


def tool_and_observer_disagree(row: WindowRecord) -> bool:
    """Whether the tool flags what an observer does not see, or the other way round."""
    flagged = row.verdict == "significant"
    words = [word for word in (row.observer, row.observer_2) if word in ("visible", "invisible")]
    return row.verdict in _CLAIMS and any((word == VISIBLE) != flagged for word in words)


def operators_disagree(row: WindowRecord) -> bool:
    """Whether both looked and did not say the same."""
    words = [getattr(row, one.observer) for one in (FIRST, SECOND)]
    return all(words) and words[0] != words[1]


TABLE = WindowOrder(
    "table", QT_TRANSLATE_NOOP("@default", "as sorted"),
    QT_TRANSLATE_NOOP("@default", "As the table is sorted by one of its columns."), None,
)  # fmt: skip
ORDERS = (
    WindowOrder(
        "seam", QT_TRANSLATE_NOOP("@default", "along the seam"),
        QT_TRANSLATE_NOOP("@default", "Seam by seam and along each, as the windows were placed."), along_the_seam,
    ),
    WindowOrder(
        "worst", QT_TRANSLATE_NOOP("@default", "worst first"),
        QT_TRANSLATE_NOOP("@default", "Significant losses first; within a verdict the greatest loss."),
        worst_first, tells_verdict=True,
    ),
    WindowOrder(
        "tool", QT_TRANSLATE_NOOP("@default", "tool differs"),
        QT_TRANSLATE_NOOP("@default", "First the windows where the tool's verdict and an observer's word disagree."),
        lambda row: along_the_seam(row) if tool_and_observer_disagree(row) else None, tells_verdict=True,
    ),
    WindowOrder(
        "operators", QT_TRANSLATE_NOOP("@default", "operators differ"),
        QT_TRANSLATE_NOOP("@default", "First the windows where the two operators disagree."),
        lambda row: along_the_seam(row) if operators_disagree(row) else None, tells_verdict=True,
    ),
    TABLE,
)  # fmt: skip


def order_named(name: str) -> WindowOrder:
    """The order of that name; as the table is sorted where there is none."""
    return next((order for order in ORDERS if order.name == name), TABLE)
