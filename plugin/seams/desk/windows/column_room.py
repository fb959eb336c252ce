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


class Widths(NamedTuple):
    """Widths of a column, px."""

    least: int
    """With words cut short."""
    natural: int
    """With all of them."""
    airy: int


class ColumnChoosing(NamedTuple):
    """What a room is used for."""

    hidden: set[int]
    """Sections."""
    short: bool
    """Whether headings are."""
    widths: list[Widths]
    """Widths of all sections."""


class ColumnMeter:
    """Measures columns in the font and style of a table as they are now."""

    def __init__(self, table: QTableView, windows: WindowsModel) -> None:
        self._table, self._sorted_by, self._has_stale = table, windows.sorted_by, windows.has_stale
        self._verdicts = windows.verdicts or frozenset(VERDICTS)
        self._most_lost = shown_area(windows.most_lost)  # a number that is never cut
        self._metrics = QFontMetrics(table.font())

    def widths(self, columns: Sequence[TableColumn], short: bool) -> list[Widths]:
        """With short headings or whole ones."""
        return [self._widths(column, short) for column in columns]

    def _widths(self, column: TableColumn, short: bool) -> Widths:
        table, metrics = self._table, self._metrics
        style, em = table.style(), metrics.horizontalAdvance("m")
        margins = 2 * (style.pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin, None, table) + 1) + em // 2
        title = self._heading(column.title(short), column == self._sorted_by)
        if column.short_heading and not short:
            title += em  # themes cut it before others, as its cells are narrow; the short one takes its place then
        chip = table.iconSize().width() + em // 2

        def width(*texts: str) -> int:
            return max(map(metrics.horizontalAdvance, texts)) + margins

        if column.name in ("reason", "causes"):
            return Widths(20 * em, 20 * em, 20 * em)
        if column.name in ("remark", "remark_2"):
            return Widths(8 * em, 10 * em, 12 * em)
        if column.name == "verdict":
            words = {verdict: verdict_word(verdict) for verdict in self._verdicts}
            changed = [filled(tr("{verdict}, changed"), verdict=words[one]) for one in CLAIMS if one in words]
            natural, airy = chip + width(*words.values()), chip + width(*words.values(), *changed)
            least = natural = airy if self._has_stale else natural
        else:
            verdicts, observers = map(verdict_word, VERDICTS), [observer_word(word) for word in OBSERVERS]
            samples = {
                "cause": [cause_word(cause.value) for cause in Cause], "paper_verdict": list(verdicts),
                "observer": observers, "observer_2": observers,
                "window_id": ["000"], "sources": ["00"], "loss": ["888 m²", self._most_lost],
            }  # fmt: skip
            natural = width(*samples.get(column.name, ["0.00"]))
            least, airy = natural, natural + em
        if column.name == "cause":
            least = width(cause_word(Cause.FEATHERING.value))
        if column.name == "loss":
            airy = max(natural, width("88,888 m²"))
        return Widths(max(least, title), max(natural, title), max(airy, title) + em)

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

    def needed(widths: list[Widths], without: set[int]) -> int:
        return sum(one.natural for section, one in enumerate(widths) if section not in without)

    if room >= sum(one.airy for section, one in enumerate(long) if section not in off):
        return ColumnChoosing(off, False, long)
    hidden = {reason, *off}
    named = ({place for place, one in enumerate(columns) if one.name == name} for name in _GIVING_WAY)
    for group in (set[int](), coarser, *named):
        hidden |= group
        for widths, short, size in (
            (long, False, long[cause].natural), (brief, True, brief[cause].natural), (brief, True, brief[cause].least)
        ):
            if room >= needed(widths, {*hidden, cause}) + size:
                return ColumnChoosing(hidden, short, widths)
    hidden.add(cause)
    short = room < needed(long, hidden)
    return ColumnChoosing(hidden, short, brief if short else long)


def shared_room(columns: Sequence[TableColumn], chosen: ColumnChoosing, room: int) -> dict[int, int]:
    """The width of each section that is shown; reasons take what is left."""
    shown = [
        section for section, column in enumerate(columns) if section not in chosen.hidden and column.name != "reason"
    ]
    cause = columns.index(CAUSE)
    least, natural, airy = (sum(sizes) for sizes in zip(*(chosen.widths[section] for section in shown)))
    found = {}
    for section in shown:
        one = chosen.widths[section]
        size: float
        if room < natural and cause in shown:  # that alone gives way
            size = one.natural if section != cause else room - natural + one.natural
        elif room < least:  # the verdict's word ends in an ellipsis; its chip is still seen
            size = one.least - (least - room) * (columns[section].name == "verdict")
        elif room < natural:
            size = one.least + (room - least) / (natural - least) * (one.natural - one.least)
        else:
            share = min(1.0, (room - natural) / max(airy - natural, 1))
            size = one.natural + share * (one.airy - one.natural)
        found[section] = int(size)
    return found
