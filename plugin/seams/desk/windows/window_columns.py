"""The columns of the windows' table, one entry each, by the names of the window layer's fields."""
from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from functools import cache, partial
from operator import attrgetter
from typing import TYPE_CHECKING, Any, NamedTuple

from qgis.PyQt.QtCore import QT_TR_NOOP, QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QIcon, QPainter, QPen, QPixmap, QPolygonF

from ....toolkit.desk.theme import plain_icon
from ....toolkit.desk.widgets import rich_tip
from ....toolkit.painting import painting
from ....toolkit.translation import filled, percent, shown_number, tr
from ...measure.window.window_tables import MEASURED, PLACED, SAID, WindowField, in_filter
from ...measure.window_records import SEAM
from ...window_summary import (
    cause_numbers,
    explanation_of,
    judged_kept,
    named_causes,
    shown_area,
    window_sentence,
    window_why,
)
from ...words import VERDICTS, cause_sentence, cause_word, causes_words, observer_word, verdict_colour, verdict_word

if TYPE_CHECKING:
    from ...measure.window.window_result import WindowResult
    from ...measure.window_records import WindowRecord

_CHIP_SIDES = (12, 16, 20, 24, 32, 48)  # px; an icon takes the next larger one and scales it down


def verdict_chip(verdict: str, stale: bool = False) -> QIcon:
    """A square in the verdict's colour; only half of it is filled when the verdict is out of date."""
    return plain_icon(*(_chip(verdict, stale, side) for side in _CHIP_SIDES))


def windows_sentence(rows: Sequence[WindowRecord]) -> str:
    """What was found in several windows, in plain words."""
    counts = Counter(row.verdict for row in rows)
    words = dict.fromkeys([*VERDICTS, *counts])  # the unknown ones last
    parts = [f"{counts[verdict]} {verdict_word(verdict)}" for verdict in words if counts[verdict]]
    changed = sum(row.stale for row in rows)
    if changed:
        parts.append(filled(tr("{count} changed since"), count=changed))
    return filled(tr("{count} windows selected: {verdicts}."), count=len(rows), verdicts=", ".join(parts))


def window_tip(row: WindowRecord, result: WindowResult | None = None) -> str:
    """The sentence about a window, and all that stands behind it, as rich text that wraps, for a tooltip."""
    return rich_tip(window_sentence(row, result), *window_why(row, result))


def _chip(verdict: str, stale: bool, side: int) -> QPixmap:
    colour = QColor(verdict_colour(verdict))
    pixmap = QPixmap(side, side)
    pixmap.fill(Qt.GlobalColor.transparent)
    with painting(pixmap) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        margin, width = side / 12, max(side / 10, 1.0)
        square = QRectF(margin, margin, side - 2 * margin, side - 2 * margin)
        edge = colour.darker(130)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        if stale:
            painter.drawPolygon(QPolygonF([square.topLeft(), square.topRight(), square.bottomLeft()]))
            edge = colour
        elif verdict:
            painter.drawRoundedRect(square, side / 6, side / 6)
        else:  # nothing known: an empty box, to be seen on light and on dark rows
            edge = QColor(verdict_colour("not_comparable"))
            painter.setBrush(QColor(232, 232, 232, 90))
            painter.drawRect(square)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        pen = QPen(edge, width)
        if not verdict:
            pen.setStyle(Qt.PenStyle.DotLine)
        painter.setPen(pen)
        inner = square.adjusted(width / 2, width / 2, -width / 2, -width / 2)
        painter.drawRoundedRect(inner, side / 6, side / 6)
        if stale:
            painter.drawLine(QPointF(inner.left(), inner.bottom()), QPointF(inner.right(), inner.top()))
    return pixmap


_ALIGNED_RIGHT = int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
_CENTRED = int(Qt.AlignmentFlag.AlignCenter)
ALIGNED_LEFT = int(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
_SEVERITY = {verdict: place for place, verdict in enumerate(VERDICTS) if verdict}
OBSERVERS = {"visible": 0, "invisible": 1, "unsure": 2}
"""What an operator saw, in the order of the table."""
_RATIO_TIP = QT_TR_NOOP("Detail at level {level} in the mosaic as a multiple of the least sharp source's.")


class TableColumn(NamedTuple):
    """A column of the table."""

    name: str  # the field of the window layer, of ratios without their level
    heading: str
    explanation: str
    text: Callable[[WindowRecord], str]  # what the cell says
    key: Callable[[WindowRecord], Any]  # what the column is sorted by; None where the row has nothing there
    alignment: int = ALIGNED_LEFT
    level: int = 0  # level of a ratio: 1..R

    @property
    def field(self) -> str:
        """That tells it from all other columns."""
        return f"{self.name}_{self.level}" if self.level else self.name

    def title(self) -> str:
        """The heading."""
        return tr(self.heading)

    def title_tip(self) -> str:
        """The tooltip of the heading."""
        return rich_tip(filled(tr(self.explanation), level=self.level))

    def tip(self, row: WindowRecord, result: WindowResult | None = None) -> str:
        """The tooltip of the cell; ``result``: what was measured in the row's window."""
        if self.name == "cause" and row.cause and not row.stale:
            explanation = explanation_of(row, result)
            return rich_tip(cause_sentence(row.cause), *(cause_numbers(explanation) if explanation is not None else ()))
        if not self.level or self.key(row) is None or row.stale:
            return window_tip(row, result)
        value = shown_number(self.key(row), 4)
        return rich_tip(filled(tr("Ratio at level {level}: {ratio}"), level=self.level, ratio=value))


def columns_of(levels: int, by_ratio: bool = True) -> tuple[TableColumn, ...]:
    """From left to right, for ratios at levels 1..R; without them where no verdict is taken ``by_ratio``."""
    return WINDOW_ID, _VERDICT, _LOSS, *ratio_columns(levels * by_ratio), PAPER, CAUSE, *_LAST


def ratio_columns(levels: int) -> tuple[TableColumn, ...]:
    """At levels 1..R."""
    return tuple(map(_ratio_column, range(1, levels + 1)))


def is_by_ratio(rows: Iterable[WindowRecord]) -> bool:
    """Whether a verdict was taken by a ratio and not by the seam."""
    return any(row.verdict and row.reference != SEAM for row in rows)


def _verdict_text(row: WindowRecord) -> str:
    word = verdict_word(row.verdict)
    return filled(tr("{verdict}, changed"), verdict=word) if row.stale else word


@cache
def _ratio_column(level: int) -> TableColumn:
    def ratio(row: WindowRecord) -> float | None:
        return row.ratios[level - 1] if level <= len(row.ratios) else None

    def text(row: WindowRecord) -> str:
        return "" if (value := ratio(row)) is None else shown_number(value)

    heading = QT_TR_NOOP("ratio 1") if level == 1 else str(level)
    return TableColumn("ratio", heading, _RATIO_TIP, text, ratio, _ALIGNED_RIGHT, level=level)


WINDOW_ID = TableColumn(
    "window_id", QT_TR_NOOP("id"), QT_TR_NOOP("Number of the window."),
    lambda row: str(row.window_id), lambda row: row.window_id, _ALIGNED_RIGHT,
)  # fmt: skip
_VERDICT = TableColumn(
    "verdict", QT_TR_NOOP("verdict"),
    QT_TR_NOOP("The verdict, by the seam or by the inputs. Sorted by this column, the worst comes first."),
    _verdict_text, lambda row: _SEVERITY.get(row.verdict),
)  # fmt: skip
_KEPT = TableColumn(
    "kept", QT_TR_NOOP("kept"),
    QT_TR_NOOP(
        "Share of the finest detail that is kept along the seam, relative to the ground around it. Empty where the "
        "verdict is not based on it."
    ),
    lambda row: "" if (kept := judged_kept(row)) is None else f"{percent(kept)} %", judged_kept, _ALIGNED_RIGHT,
)  # fmt: skip
PAPER = TableColumn(
    "paper_verdict", QT_TR_NOOP("paper"),
    QT_TR_NOOP("The paper's own flag, by ratio 1 against whole sources, whatever the verdict is based on."),
    lambda row: verdict_word(row.paper_verdict) if row.paper_verdict else "",
    lambda row: _SEVERITY.get(row.paper_verdict),
)  # fmt: skip


def _cause_words(row: WindowRecord) -> str:
    return ", ".join(map(cause_word, named_causes(row)))


CAUSE = TableColumn(
    "cause", QT_TR_NOOP("cause"),
    QT_TR_NOOP("The step of production that explains what happened to the contrast."),
    _cause_words, lambda row: _cause_words(row).casefold() or None,
)  # fmt: skip
_LAST = (
    TableColumn(
        "sources", QT_TR_NOOP("sources"),
        QT_TR_NOOP("How many sources the mosaic was compared with."),
        lambda row: "" if row.sources is None else str(row.sources), lambda row: row.sources, _CENTRED,
    ),
    TableColumn(
        "observer", QT_TR_NOOP("observer"),
        QT_TR_NOOP("Whether the operator saw the loss of detail at 2x magnification."),
        lambda row: observer_word(row.observer), lambda row: OBSERVERS.get(row.observer),
    ),
    TableColumn(
        "reason", QT_TR_NOOP("reason"),
        QT_TR_NOOP("Why the mosaic could not be compared with a source."),
        lambda row: row.reason, lambda row: row.reason.casefold() or None,
    ),
)  # fmt: skip


def _percent(value: float) -> str:
    return f"{percent(value)} %"


def _metres(value: float) -> str:
    return filled(tr("{metres} m"), metres=shown_number(value, 2 if value < 10 else 0))


_TEXTS: dict[str, Callable[[str], str]] = {"words": str, "causes": causes_words}
_NUMBERS: dict[str, Callable[[float], str]] = {
    "number": shown_number, "tenths": partial(shown_number, decimals=1), "percent": _percent, "metres": _metres,
    "square metres": shown_area, "of 100": lambda value: f"{value} %", "whole": str,
    "px": lambda value: filled(tr("{length} px"), length=shown_number(value, 1)),
}  # fmt: skip


def _column(field: WindowField) -> TableColumn:
    name = field.read_as

    def read(row: WindowRecord) -> Any:
        return row.read(name)

    if field.shown == "observer":
        return TableColumn(
            field.name, field.heading, field.help, lambda row: observer_word(read(row)),
            lambda row: OBSERVERS.get(read(row)),
        )  # fmt: skip
    if field.shown in _TEXTS:
        words = _TEXTS[field.shown]
        return TableColumn(
            field.name, field.heading, field.help, lambda row: words(read(row) or ""),
            lambda row: words(read(row) or "").casefold() or None, ALIGNED_LEFT,
        )  # fmt: skip
    shown = _NUMBERS[field.shown]
    return TableColumn(
        name, field.heading, field.help, lambda row: "" if read(row) is None else shown(read(row)), read,
        _ALIGNED_RIGHT,
    )


_LOSS = _column(in_filter()["loss"])
JUDGING_COLUMNS = tuple(_column(column) for column in SAID if column.heading)
"""Shown as soon as one window has something there."""

_CHOSEN = (*sorted(MEASURED, key=lambda column: column.shown in _TEXTS), *PLACED)  # numbers first
CHOSEN_COLUMNS = (_KEPT, *(_column(column) for column in _CHOSEN if column.heading and column.name != _LOSS.name))
"""Shown when the operator chooses them."""


def used_columns(rows: Iterable[WindowRecord]) -> frozenset[str]:
    """The judging columns that hold something."""
    names = [column.name for column in JUDGING_COLUMNS]
    said = set(map(attrgetter(*names), rows))
    return frozenset(name for values in said for name, value in zip(names, values) if value not in (None, ""))


def all_columns(levels: int, used: frozenset[str], by_ratio: bool = True) -> tuple[TableColumn, ...]:
    """The standard ones, before their last one, the reasons, what is used, and after it what can be chosen: ratios,
    too, where no verdict is taken ``by_ratio``."""
    standard = columns_of(levels, by_ratio)
    judging = (column for column in JUDGING_COLUMNS if column.name in used)
    return *standard[:-1], *judging, standard[-1], *CHOSEN_COLUMNS, *ratio_columns(levels * (not by_ratio))
