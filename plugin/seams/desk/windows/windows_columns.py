"""The columns of the windows' table, one entry each, by the names of the window layer's fields."""
from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP, Qt

from ....toolkit.desk.widgets import rich_tip
from ....toolkit.translation import filled, percent, shown_number, tr
from ...cause_words import cause_sentence, cause_word
from ...judged_value import judged_kept
from ...verdict_words import VERDICTS, observer_word, verdict_word
from ...window_summary import cause_numbers, explanation_of
from .verdict_chips import window_tip

if TYPE_CHECKING:
    from ...measure.window.window_result import WindowResult
    from ...measure.window_records import WindowRecord

_ALIGNED_RIGHT = int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
_CENTRED = int(Qt.AlignmentFlag.AlignCenter)
ALIGNED_LEFT = int(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
_SEVERITY = {verdict: place for place, verdict in enumerate(VERDICTS) if verdict}
OBSERVERS = {"visible": 0, "invisible": 1, "unsure": 2}
"""What an operator saw, in the order of the table."""
_RATIO_TIP = QT_TRANSLATE_NOOP(
    "@default", "Detail at level {level} in the mosaic as a multiple of the least sharp source's."
)


class TableColumn(NamedTuple):
    """A column of the table."""

    name: str
    """The field of the window layer, of ratios without their level."""
    heading: str
    explanation: str
    text: Callable[[WindowRecord], str]
    """What the cell says."""
    key: Callable[[WindowRecord], Any]
    """What the column is sorted by; None where the row has nothing there."""
    alignment: int = ALIGNED_LEFT
    short_heading: str = ""
    level: int = 0
    """Of a ratio: 1..R."""

    @property
    def field(self) -> str:
        """That tells it from all other columns."""
        return f"{self.name}_{self.level}" if self.level else self.name

    def title(self, short: bool = False) -> str:
        """The heading."""
        return tr(self.short_heading if short and self.short_heading else self.heading)

    def title_tip(self) -> str:
        """The tooltip of the heading."""
        return rich_tip(filled(tr(self.explanation), level=self.level))

    def tip(self, row: WindowRecord, result: WindowResult | None = None) -> str:
        """The tooltip of the cell; ``result``: what was measured in the row's window."""
        if self.name == "cause" and row.cause and not row.stale:
            found = explanation_of(row, result)
            return rich_tip(cause_sentence(row.cause), *(cause_numbers(found) if found is not None else ()))
        if not self.level or self.key(row) is None or row.stale:
            return window_tip(row, result)
        value = shown_number(self.key(row), 4)
        return rich_tip(filled(tr("Ratio at level {level}: {ratio}"), level=self.level, ratio=value))


def columns_of(levels: int) -> tuple[TableColumn, ...]:
    """From left to right, for ratios at levels 1..R."""
    return WINDOW_ID, _VERDICT, _KEPT, *map(_ratio_column, range(1, levels + 1)), PAPER, CAUSE, *_LAST


def _verdict_text(row: WindowRecord) -> str:
    word = verdict_word(row.verdict)
    return filled(tr("{verdict}, changed"), verdict=word) if row.stale else word


@cache
def _ratio_column(level: int) -> TableColumn:
    def ratio(row: WindowRecord) -> float | None:
        return row.ratios[level - 1] if level <= len(row.ratios) else None

    def text(row: WindowRecord) -> str:
        return "" if (found := ratio(row)) is None else shown_number(found)

    heading = QT_TRANSLATE_NOOP("@default", "ratio 1") if level == 1 else str(level)
    return TableColumn("ratio", heading, _RATIO_TIP, text, ratio, _ALIGNED_RIGHT, level=level)


WINDOW_ID = TableColumn(
    "window_id", QT_TRANSLATE_NOOP("@default", "id"), QT_TRANSLATE_NOOP("@default", "Number of the window."),
    lambda row: str(row.window_id), lambda row: row.window_id, _ALIGNED_RIGHT,
)  # fmt: skip
_VERDICT = TableColumn(
    "verdict", QT_TRANSLATE_NOOP("@default", "verdict"),
    QT_TRANSLATE_NOOP(
        "@default", "What was found, by the seam or by what the inputs say. Sorted by it, the worst comes first."
    ),
    _verdict_text, lambda row: _SEVERITY.get(row.verdict),
)  # fmt: skip
_KEPT = TableColumn(
    "kept", QT_TRANSLATE_NOOP("@default", "kept"),
    QT_TRANSLATE_NOOP(
        "@default",
        "Share of the finest detail that is kept along the seam, relative to the ground around it. Empty where the "
        "verdict was not taken by it."
    ),
    lambda row: "" if (kept := judged_kept(row)) is None else f"{percent(kept)} %", judged_kept, _ALIGNED_RIGHT,
)  # fmt: skip
PAPER = TableColumn(
    "paper_verdict", QT_TRANSLATE_NOOP("@default", "paper"),
    QT_TRANSLATE_NOOP(
        "@default", "The paper's own flag, by ratio 1 against whole sources, whatever the verdict was taken by."
    ),
    lambda row: verdict_word(row.paper_verdict) if row.paper_verdict else "",
    lambda row: _SEVERITY.get(row.paper_verdict),
)  # fmt: skip
CAUSE = TableColumn(
    "cause", QT_TRANSLATE_NOOP("@default", "cause"),
    QT_TRANSLATE_NOOP("@default", "The step of production that explains what happened to the contrast."),
    lambda row: cause_word(row.cause), lambda row: cause_word(row.cause).casefold() or None,
)  # fmt: skip
_LAST = (
    TableColumn(
        "sources", QT_TRANSLATE_NOOP("@default", "sources"),
        QT_TRANSLATE_NOOP("@default", "How many sources the mosaic was compared with."),
        lambda row: "" if row.sources is None else str(row.sources), lambda row: row.sources, _CENTRED,
        QT_TRANSLATE_NOOP("@default", "src."),
    ),
    TableColumn(
        "observer", QT_TRANSLATE_NOOP("@default", "observer"),
        QT_TRANSLATE_NOOP("@default", "Whether the operator saw the loss of detail at 2x magnification."),
        lambda row: observer_word(row.observer), lambda row: OBSERVERS.get(row.observer),
    ),
    TableColumn(
        "reason", QT_TRANSLATE_NOOP("@default", "reason"),
        QT_TRANSLATE_NOOP("@default", "Why the mosaic could not be compared with a source."),
        lambda row: row.reason, lambda row: row.reason.casefold() or None,
    ),
)  # fmt: skip
