"""The columns of the windows' table; all other fields of a window are in QGIS's attribute table."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import attrgetter
from typing import TYPE_CHECKING, Any, NamedTuple

from qgis.PyQt.QtCore import QT_TR_NOOP, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QIcon, QPainter, QPen, QPixmap

from ....imagery.limits import MAX_SIGNIFICANT_RATIO
from ....toolkit.desk.theme import plain_icon
from ....toolkit.desk.widgets import rich_tip
from ....toolkit.painting import painting
from ....toolkit.translation import filled, tr
from ...measure.window_records import SEAM
from ...window_summary import shown_area, two_digits, window_sentence, window_why
from ...words import VERDICTS, cause_sentence, cause_word, observer_word, verdict_colour, verdict_word

if TYPE_CHECKING:
    from ...measure.window.window_result import WindowResult
    from ...measure.window_records import WindowRecord

_CHIP_SIDES = (12, 16, 20, 24, 32, 48)  # px; an icon takes the next larger one and scales it down


def verdict_chip(verdict: str) -> QIcon:
    """A square in the verdict's colour."""
    return plain_icon(*(_chip(verdict, side) for side in _CHIP_SIDES))


def window_tip(row: WindowRecord, result: WindowResult | None = None) -> str:
    """The sentence about a window, and all that stands behind it, as rich text that wraps, for a tooltip."""
    return rich_tip(window_sentence(row, result), *window_why(row, result))


def _chip(verdict: str, side: int) -> QPixmap:
    colour = QColor(verdict_colour(verdict))
    pixmap = QPixmap(side, side)
    pixmap.fill(Qt.GlobalColor.transparent)
    with painting(pixmap) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        width = max(side / 10, 1.0)
        square = QRectF(width, width, side - 2 * width, side - 2 * width)
        painter.setPen(QPen(colour.darker(130), width, Qt.PenStyle.SolidLine if verdict else Qt.PenStyle.DotLine))
        if verdict:
            painter.setBrush(colour)
        painter.drawRoundedRect(square, side / 6, side / 6)
    return pixmap


_ALIGNED_RIGHT = int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
ALIGNED_LEFT = int(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
_SEVERITY = {verdict: place for place, verdict in enumerate(VERDICTS) if verdict}
_OBSERVERS = {"visible": 0, "invisible": 1, "unsure": 2}  # in the order of the table


class TableColumn(NamedTuple):
    """A column of the table."""

    name: str  # the field of the window layer
    heading: str
    explanation: str
    text: Callable[[WindowRecord], str]  # what the cell says
    key: Callable[[WindowRecord], Any]  # what the column is sorted by; None where the row has nothing there
    alignment: int = ALIGNED_LEFT

    def title(self) -> str:
        """The heading."""
        return tr(self.heading)

    def tip(self, row: WindowRecord, result: WindowResult | None = None) -> str:
        """The tooltip of the cell; ``result``: what was measured in the row's window."""
        if self.name == "cause" and row.cause and not row.stale:
            return rich_tip(cause_sentence(row.cause))
        return window_tip(row, result)


def _verdict_text(row: WindowRecord) -> str:
    word = verdict_word(row.verdict)
    return filled(tr("{verdict}, changed"), verdict=word) if row.stale else word


def _plain(name: str, heading: str, explanation: str, alignment: int = ALIGNED_LEFT) -> TableColumn:
    """A column that says what the record holds."""

    def text(row: WindowRecord) -> str:
        return "" if (value := getattr(row, name)) is None else str(value)

    def key(row: WindowRecord) -> Any:
        value = getattr(row, name)
        return value.casefold() or None if isinstance(value, str) else value

    return TableColumn(name, heading, explanation, text, key, alignment)


def _observed(name: str, heading: str, explanation: str) -> TableColumn:
    return TableColumn(
        name, heading, explanation, lambda row: observer_word(getattr(row, name)),
        lambda row: _OBSERVERS.get(getattr(row, name)),
    )  # fmt: skip


WINDOW_ID = _plain("window_id", QT_TR_NOOP("id"), QT_TR_NOOP("Number of the window."), _ALIGNED_RIGHT)
COLUMNS = (
    WINDOW_ID,
    TableColumn(
        "verdict", QT_TR_NOOP("verdict"),
        QT_TR_NOOP("The verdict, by the seam or by the inputs. Sorted by this column, the worst comes first."),
        _verdict_text, lambda row: (_SEVERITY[row.verdict], -(row.loss or 0.0)) if row.verdict in _SEVERITY else None,
    ),
    TableColumn(
        "loss", QT_TR_NOOP("loss"),
        QT_TR_NOOP("The finest detail that is missing, along the seam or in the whole window, given as the square "
                   "metres of the window that hold as much; empty where no loss is certain."),
        lambda row: shown_area(row.loss) if row.loss else "", lambda row: row.loss,
        _ALIGNED_RIGHT,
    ),
    TableColumn(
        "ratio", QT_TR_NOOP("ratio 1"),
        QT_TR_NOOP("Detail at level 1 in the mosaic as a multiple of the least sharp source's."),
        lambda row: two_digits(row.ratio, MAX_SIGNIFICANT_RATIO), lambda row: row.ratio,
        _ALIGNED_RIGHT,
    ),
    TableColumn(
        "paper_verdict", QT_TR_NOOP("paper"),
        QT_TR_NOOP("The paper's own flag, by ratio 1 against whole sources, whatever the verdict is based on."),
        lambda row: verdict_word(row.paper_verdict) if row.paper_verdict else "",
        lambda row: _SEVERITY.get(row.paper_verdict),
    ),
    TableColumn(
        "cause", QT_TR_NOOP("cause"),
        QT_TR_NOOP("The step of production that explains what happened to the contrast."),
        lambda row: cause_word(row.cause), lambda row: cause_word(row.cause).casefold() or None,
    ),
    _plain("sources", QT_TR_NOOP("sources"), QT_TR_NOOP("How many sources the mosaic was compared with."),
           _ALIGNED_RIGHT),
    _observed("observer", QT_TR_NOOP("observer"),
              QT_TR_NOOP("Whether the operator saw the loss of detail at 2x magnification.")),
    _observed("observer_2", QT_TR_NOOP("observer 2"), QT_TR_NOOP("What the second operator saw at 2x magnification.")),
    _plain("confidence", QT_TR_NOOP("sure (%)"), QT_TR_NOOP("How sure the observer is."), _ALIGNED_RIGHT),
    _plain("remark", QT_TR_NOOP("remark"), QT_TR_NOOP("The observer's remark.")),
)  # fmt: skip
"""From left to right; those that stand empty, or there is no room for, are left out."""
_SAID = ("observer_2", "confidence", "remark")


def used_columns(rows: Sequence[WindowRecord]) -> frozenset[str]:
    """The names of columns that are of use: what operators said once they did, the ratio where a verdict goes by it."""
    said = set(map(attrgetter(*_SAID), rows))
    empty = {name for place, name in enumerate(_SAID) if all(values[place] in (None, "") for values in said)}
    if not any(row.verdict and row.reference != SEAM for row in rows):
        empty.add("ratio")
    return frozenset(column.name for column in COLUMNS) - empty
