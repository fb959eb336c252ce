"""Which columns of the windows' table are seen: those the operator chose, or those there is room for, and how wide."""
from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from typing import NamedTuple

from qgis.core import QgsSettings
from qgis.PyQt.QtCore import QSize, Qt
from qgis.PyQt.QtGui import QFontMetrics
from qgis.PyQt.QtWidgets import QMenu, QStyle, QStyleOptionHeader, QTableView, QWidget

from ....imagery.documents import json_document
from ....toolkit.translation import filled, tr
from ...measure.judgement.causes import Cause
from ...window_summary import shown_area
from ...words import CLAIMS, VERDICTS, cause_word, observer_word, verdict_word
from .window_columns import CAUSE, OBSERVERS, PAPER, TableColumn
from .windows_model import WindowsModel

_KEY = "SeamInspector/window_columns"


@dataclass(frozen=True)
class ColumnChoice:
    """Columns by their fields."""

    shown: tuple[str, ...] = ()
    """Empty: those that there is room for."""
    order: tuple[str, ...] = ()
    """From left to right; empty: as they come."""


def load_choice() -> ColumnChoice:
    """What was chosen last; nothing where that can't be understood."""
    try:
        stored = json_document(QgsSettings().value(_KEY, "") or "{}")
        return ColumnChoice(*(tuple(map(str, stored.get(name, ()))) for name in ("shown", "order")))
    except (ValueError, TypeError, AttributeError):
        return ColumnChoice()


def save_choice(choice: ColumnChoice) -> None:
    """For the next time."""
    QgsSettings().setValue(_KEY, json.dumps(asdict(choice)))


def columns_menu(
    columns: Sequence[TableColumn],
    visible: Sequence[str],
    choose: Callable[[tuple[str, ...]], None],
    reset: Callable[[], None],
    parent: QWidget,
) -> QMenu:
    """A menu with a tick at each visible column; ``choose`` is told the fields that shall be seen."""

    def toggle(field: str, shown: bool) -> None:
        wanted = {*visible, field} if shown else {*visible} - {field}
        choose(tuple(column.field for column in columns if column.field in wanted))

    menu = QMenu(parent)
    menu.setToolTipsVisible(True)
    for column in columns:
        action = menu.addAction(_menu_title(column))
        action.setToolTip(column.title_tip())
        action.setCheckable(True)
        action.setChecked(column.field in visible)
        action.setEnabled(list(visible) != [column.field])  # one has to stay
        action.triggered.connect(partial(toggle, column.field))
    menu.addSeparator()
    action = menu.addAction(tr("As there is room"))
    action.setToolTip(tr("The usual columns in their usual order, as many as there is room for."))
    action.triggered.connect(lambda *_: reset())
    return menu


def _menu_title(column: TableColumn) -> str:
    return filled(tr("ratio {level}"), level=column.level) if column.level > 1 else column.title()


_GIVING_WAY = ("sources", "remark_2", "remark", "confidence_2", "confidence", "ratio")
"""After reasons, the ratios beyond level 1 and the paper's flag; verdict, loss, observer and cause stay longest."""


class ColumnChoosing(NamedTuple):
    """What a room is used for."""

    hidden: set[int]
    """Sections."""
    short: bool
    """Whether headings are."""
    widths: list[int]
    """Widths of all sections, px, with all of their words."""


class ColumnMeter:
    """Measures columns in the font and style of a table as they are now."""

    def __init__(self, table: QTableView, windows: WindowsModel) -> None:
        self._table, self._sorted_by, self._has_stale = table, windows.sorted_by, windows.has_stale
        self._verdicts = windows.verdicts or frozenset(VERDICTS)
        self._most_lost = shown_area(windows.most_lost)  # a number that is never cut
        self._metrics = QFontMetrics(table.font())

    def widths(self, columns: Sequence[TableColumn], short: bool) -> list[int]:
        """With short headings or whole ones."""
        return [self._width(column, short) for column in columns]

    @property
    def least_cause(self) -> int:
        """With causes cut short, of which the first letters tell."""
        return self._heading(CAUSE.title(), self._sorted_by == CAUSE)

    def _width(self, column: TableColumn, short: bool) -> int:
        em = self._metrics.horizontalAdvance("m")
        title = self._heading(column.title(short), column == self._sorted_by)
        if column.short_heading and not short:
            title += em  # themes cut it before others, as its cells are narrow; the short one takes its place then
        shown = [one for one in self._verdicts if one in CLAIMS or not short] or self._verdicts
        words = [verdict_word(verdict) for verdict in shown]  # in short, what there is no verdict by is cut
        claims = [verdict_word(one) for one in CLAIMS if one in self._verdicts]
        changed = [filled(tr("{verdict}, changed"), verdict=word) for word in claims]
        observers = [observer_word(word) for word in OBSERVERS]
        samples = {
            "reason": ["m" * 20], "causes": ["m" * 20], "remark": ["m" * 10], "remark_2": ["m" * 10],
            "verdict": [*words, *(changed if self._has_stale else [])],
            "cause": [cause_word(cause.value) for cause in Cause], "paper_verdict": [*map(verdict_word, VERDICTS)],
            "observer": observers, "observer_2": observers,
            "window_id": ["000"], "sources": ["00"], "loss": ["888 m²", self._most_lost],
        }  # fmt: skip
        width = self._with_margins(*samples.get(column.name, ["0.00"]))
        if column.name == "verdict":
            width += self._table.iconSize().width() + em // 2
        return max(width, title)

    def _with_margins(self, *texts: str) -> int:
        margin = self._table.style().pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin, None, self._table)
        widest = max(map(self._metrics.horizontalAdvance, texts))
        return int(widest + 2 * (margin + 1) + self._metrics.horizontalAdvance("m") // 2)

    def _heading(self, title: str, is_sorted: bool) -> int:
        """That shows all of a heading, with what the style or a theme's style sheet puts around it."""
        header = self._table.horizontalHeader()
        option = QStyleOptionHeader()
        option.initFrom(header)
        option.orientation = Qt.Orientation.Horizontal
        option.text = title
        if is_sorted:
            option.sortIndicator = QStyleOptionHeader.SortIndicator.SortDown
        style, metrics = header.style(), header.fontMetrics()
        least = style.sizeFromContents(QStyle.ContentsType.CT_HeaderSection, option, QSize(), header).width()
        needed = metrics.horizontalAdvance(title + "m") + 2 * style.pixelMetric(QStyle.PixelMetric.PM_HeaderMargin)
        if is_sorted:
            needed += 2 * style.pixelMetric(QStyle.PixelMetric.PM_HeaderMarkSize)
        return max(int(least), int(needed))  # the style's own word is too little in Fusion


def choose_columns(columns: Sequence[TableColumn], meter: ColumnMeter, room: int) -> ColumnChoosing:
    """Those there is room for. Causes are cut short, and go last, so that a verdict's word is never cut."""
    reason, cause = next(place for place, one in enumerate(columns) if one.name == "reason"), columns.index(CAUSE)
    off = set(range(reason + 1, len(columns)))  # for the operator to choose
    coarser = {section for section, column in enumerate(columns) if column.level > 1 or column == PAPER}
    long, brief = meter.widths(columns, short=False), meter.widths(columns, short=True)

    def needed(widths: list[int], without: set[int]) -> int:
        return sum(one for section, one in enumerate(widths) if section not in without)

    hidden = set(off)
    named = ({place for place, one in enumerate(columns) if one.name == name} for name in _GIVING_WAY)
    for group in (set[int](), {reason}, coarser, *named):
        hidden |= group
        for widths, short, size in (
            (long, False, long[cause]), (brief, True, brief[cause]), (brief, True, meter.least_cause)
        )[: 3 if reason in hidden else 1]:
            if room >= needed(widths, {*hidden, cause}) + size:
                return ColumnChoosing(hidden, short, widths)
    hidden.add(cause)
    short = room < needed(long, hidden)
    return ColumnChoosing(hidden, short, brief if short else long)


def shared_room(columns: Sequence[TableColumn], chosen: ColumnChoosing, room: int) -> dict[int, int]:
    """The width of each section that is shown: the cause, or else the verdict, whose chip is seen yet, takes what is
    lacking; reasons, or all, what is left."""
    found = {section: width for section, width in enumerate(chosen.widths) if section not in chosen.hidden}
    names = {columns[section].name: section for section in found}
    spare = room - sum(found.values())
    if spare < 0:
        found[names.get("cause", names["verdict"])] += spare
    elif "reason" in names:
        found[names["reason"]] += spare
    else:
        for section in found:
            found[section] += spare // len(found)
    return found
