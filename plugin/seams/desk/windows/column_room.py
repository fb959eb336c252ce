"""The columns of the windows' table that are seen: those the operator chose, or those there is room for, and how
wide."""
from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from functools import partial

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


def load_choice() -> tuple[str, ...]:
    """Fields of the columns that were chosen last; none where that can't be understood, or those there is room for."""
    try:
        return tuple(map(str, json_document(QgsSettings().value(_KEY, "") or "[]")))
    except (ValueError, TypeError):
        return ()


def save_choice(fields: tuple[str, ...]) -> None:
    """For the next time."""
    QgsSettings().setValue(_KEY, json.dumps(fields))


def columns_menu(
    columns: Sequence[TableColumn], visible: Sequence[str], choose: Callable[[tuple[str, ...]], None], parent: QWidget
) -> QMenu:
    """A menu with a tick at each visible column; ``choose`` is told the fields that shall be seen, none for those
    there is room for."""

    def toggle(field: str, shown: bool) -> None:
        wanted = {*visible, field} if shown else {*visible} - {field}
        choose(tuple(column.field for column in columns if column.field in wanted))

    menu = QMenu(parent)
    menu.setToolTipsVisible(True)
    for column in columns:
        title = filled(tr("ratio {level}"), level=column.level) if column.level > 1 else column.title()
        action = menu.addAction(title)
        action.setToolTip(column.title_tip())
        action.setCheckable(True)
        action.setChecked(column.field in visible)
        action.setEnabled(list(visible) != [column.field])  # one has to stay
        action.triggered.connect(partial(toggle, column.field))
    menu.addSeparator()
    action = menu.addAction(tr("As there is room"))
    action.setToolTip(tr("The usual columns, as many as there is room for."))
    action.triggered.connect(lambda *_: choose(()))
    return menu


_GIVING_WAY = ("sources", "remark_2", "remark", "confidence_2", "confidence", "ratio", "observer_2", "cause")
"""After reasons, the ratios beyond level 1 and the paper's flag; verdict, loss and observer always stay."""


class ColumnMeter:
    """Measures columns in the font and style of a table as they are now."""

    def __init__(self, table: QTableView, windows: WindowsModel) -> None:
        self._table, self._sorted_by, self._has_stale = table, windows.sorted_by, windows.has_stale
        self._verdicts = windows.verdicts or frozenset(VERDICTS)
        self._most_lost = shown_area(windows.most_lost)  # a number that is never cut
        self._metrics = QFontMetrics(table.font())

    def width(self, column: TableColumn) -> int:
        """With all of its words."""
        samples = {
            "reason": ["m" * 20], "causes": ["m" * 20], "remark": ["m" * 10], "remark_2": ["m" * 10],
            "verdict": [*map(verdict_word, self._verdicts), *self._claims()],
            "cause": [cause_word(cause.value) for cause in Cause], "paper_verdict": [*map(verdict_word, VERDICTS)],
            "observer": [*map(observer_word, OBSERVERS)], "observer_2": [*map(observer_word, OBSERVERS)],
            "window_id": ["000"], "sources": ["00"], "loss": ["888 m²", self._most_lost],
        }  # fmt: skip
        return max(self._of_words(column, *samples.get(column.name, ["0.00"])), self._heading(column))

    def least(self, column: TableColumn) -> int:
        """Causes are cut short, as their first letters tell, and so are words that are no verdict."""
        if column == CAUSE:
            return self._heading(column)
        if column.name == "verdict" and (claims := self._claims()):
            return max(self._of_words(column, *claims), self._heading(column))
        return self.width(column)

    def _claims(self) -> list[str]:
        """Words of the windows' verdicts that say whether detail was lost."""
        claims = [verdict_word(claim) for claim in CLAIMS if claim in self._verdicts]
        return [*claims, *(filled(tr("{verdict}, changed"), verdict=claim) for claim in claims if self._has_stale)]

    def _of_words(self, column: TableColumn, *texts: str) -> int:
        margin = self._table.style().pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin, None, self._table)
        widest, em = max(map(self._metrics.horizontalAdvance, texts)), self._metrics.horizontalAdvance("m")
        chip = self._table.iconSize().width() + em // 2 if column.name == "verdict" else 0
        return int(widest + 2 * (margin + 1) + em // 2 + chip)

    def _heading(self, column: TableColumn) -> int:
        """That shows all of a heading, with what the style or a theme's style sheet puts around it."""
        header, is_sorted = self._table.horizontalHeader(), column == self._sorted_by
        option = QStyleOptionHeader()
        option.initFrom(header)
        option.orientation = Qt.Orientation.Horizontal
        option.text = column.title()
        if is_sorted:
            option.sortIndicator = QStyleOptionHeader.SortIndicator.SortDown
        style, metrics = header.style(), header.fontMetrics()
        least = style.sizeFromContents(QStyle.ContentsType.CT_HeaderSection, option, QSize(), header).width()
        margins = 2 * style.pixelMetric(QStyle.PixelMetric.PM_HeaderMargin)
        needed = metrics.horizontalAdvance(column.title() + "m") + margins
        if is_sorted:
            needed += 2 * style.pixelMetric(QStyle.PixelMetric.PM_HeaderMarkSize)
        return max(int(least), int(needed))  # the style's own word is too little in Fusion


def fitted_columns(columns: Sequence[TableColumn], meter: ColumnMeter, room: int) -> dict[int, int]:
    """Widths of the columns that there is room for, by their place: as many as fit, with all words if there are
    reasons."""
    full, least = [*map(meter.width, columns)], [*map(meter.least, columns)]
    names = [column.name for column in columns]
    reason, verdict = names.index("reason"), names.index("verdict")
    coarser = {place for place, column in enumerate(columns) if column.level > 1 or column == PAPER}
    giving_way = ({place for place, name in enumerate(names) if name == wide} for wide in _GIVING_WAY)
    shown = set(range(reason + 1))  # the others are for the operator to choose
    for group in (set[int](), {reason}, coarser, *giving_way):
        shown -= group
        if sum((full if reason in shown else least)[place] for place in shown) <= room:
            break
    sizes = {place: least[place] for place in sorted(shown)}
    for place in (verdict, columns.index(CAUSE), *sorted(shown)):
        if place in shown:
            sizes[place] += max(min(full[place] - sizes[place], room - sum(sizes.values())), 0)
    spare = room - sum(sizes.values())
    if spare < 0:
        sizes[verdict] += spare  # whose chip is seen yet
    elif reason in shown:
        sizes[reason] += spare
    else:
        sizes = {place: size + spare // len(sizes) for place, size in sizes.items()}
    return sizes
