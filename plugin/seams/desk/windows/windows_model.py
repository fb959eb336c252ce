"""The windows as a sorted table, kept in step with the session row by row."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from enum import Enum
from itertools import groupby
from typing import TYPE_CHECKING, Any, NamedTuple

from qgis.PyQt.QtCore import QAbstractTableModel, QLocale, QModelIndex, QObject, Qt
from qgis.PyQt.QtGui import QFont, QIcon

from ....toolkit.desk.tooltips import rich_tip
from ....toolkit.translation import tr
from ...cause_words import cause_sentence, cause_word
from ...verdict_words import VERDICTS, observer_word, verdict_word
from ...window_summary import cause_numbers, explanation_of
from .verdict_chips import verdict_chip, window_tip

if TYPE_CHECKING:
    from ...measure.inspection import WindowResult
    from ...measure.window_records import WindowRecord

_ALIGNED_RIGHT = int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
_CENTRED = int(Qt.AlignmentFlag.AlignCenter)
_ALIGNED_LEFT = int(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
_DISPLAY = Qt.ItemDataRole.DisplayRole  # found faster than by way of Qt: each cell asks for seven roles
_ALIGNMENT = Qt.ItemDataRole.TextAlignmentRole
_DECORATION = Qt.ItemDataRole.DecorationRole
_FONT = Qt.ItemDataRole.FontRole
_TOOL_TIP = Qt.ItemDataRole.ToolTipRole
_MAX_RUNS = 64  # changes in more places than that are told to the views as one
_OBSERVERS = ("visible", "invisible")
_SEVERITY = {verdict: place for place, verdict in enumerate(VERDICTS) if verdict}
_ASCENDING = Qt.SortOrder.AscendingOrder


class ColumnKind(Enum):
    """What a column shows."""

    ID = "id"
    VERDICT = "verdict"
    RATIO = "ratio"
    CAUSE = "cause"
    SOURCES = "sources"
    OBSERVER = "observer"
    REASON = "reason"


class Column(NamedTuple):
    """A column of the table."""

    kind: ColumnKind
    level: int = 0
    """Of a ratio: 1..R."""

    def key(self, row: WindowRecord) -> Any:
        """What the column is sorted by; None where the row has nothing there."""
        if self.kind is ColumnKind.ID:
            return row.window_id
        if self.kind is ColumnKind.VERDICT:  # the worst first
            return _SEVERITY.get(row.verdict)
        if self.kind is ColumnKind.RATIO:
            return self.ratio(row)
        if self.kind is ColumnKind.CAUSE:
            return cause_word(row.cause).casefold() or None
        if self.kind is ColumnKind.SOURCES:
            return row.sources
        if self.kind is ColumnKind.OBSERVER:
            return _OBSERVERS.index(row.observer) if row.observer in _OBSERVERS else None
        return row.reason.casefold() or None

    def text(self, row: WindowRecord) -> str:
        """What the cell says."""
        if self.kind is ColumnKind.ID:
            return str(row.window_id)
        if self.kind is ColumnKind.VERDICT:
            word = verdict_word(row.verdict)
            return tr("{verdict}, changed").format(verdict=word) if row.stale else word
        if self.kind is ColumnKind.RATIO:
            ratio = self.ratio(row)
            return "" if ratio is None else QLocale().toString(ratio, "f", 2)
        if self.kind is ColumnKind.CAUSE:
            return cause_word(row.cause)
        if self.kind is ColumnKind.SOURCES:
            return "" if row.sources is None else str(row.sources)
        if self.kind is ColumnKind.OBSERVER:
            return observer_word(row.observer)
        return row.reason

    def ratio(self, row: WindowRecord) -> float | None:
        """The row's ratio at this column's level."""
        return row.ratios[self.level - 1] if self.level <= len(row.ratios) else None

    def tip(self, row: WindowRecord, result: WindowResult | None = None) -> str:
        """The tooltip of the cell; ``result``: what was measured in the row's window."""
        ratio = self.ratio(row) if self.kind is ColumnKind.RATIO else None
        if self.kind is ColumnKind.CAUSE and row.cause and not row.stale:
            found = explanation_of(row, result)
            return rich_tip(cause_sentence(row.cause), *(cause_numbers(found) if found is not None else ()))
        if ratio is None or row.stale:
            return window_tip(row, result)
        value = QLocale().toString(ratio, "f", 4)
        return rich_tip(tr("Ratio at level {level}: {ratio}").format(level=self.level, ratio=value))

    def title(self, short: bool = False) -> str:
        """The heading."""
        if self.kind is ColumnKind.RATIO:
            return tr("ratio 1") if self.level == 1 else str(self.level)
        return {
            ColumnKind.ID: tr("id"),
            ColumnKind.VERDICT: tr("verdict"),
            ColumnKind.CAUSE: tr("cause"),
            ColumnKind.SOURCES: tr("src.") if short else tr("sources"),
            ColumnKind.OBSERVER: tr("observer"),
            ColumnKind.REASON: tr("reason"),
        }[self.kind]

    def title_tip(self) -> str:
        """The tooltip of the heading."""
        if self.kind is ColumnKind.RATIO:
            tip = tr("Detail at level {level} in the mosaic as a multiple of the least sharp source's.")
            return rich_tip(tip.format(level=self.level))
        return rich_tip({
            ColumnKind.ID: tr("Number of the window."),
            ColumnKind.VERDICT: tr(
                "What the ratio at level 1 says about the mosaic. Sorted by it, the worst comes first."
            ),
            ColumnKind.CAUSE: tr("The step of production that explains what happened to the contrast."),
            ColumnKind.SOURCES: tr("How many sources the mosaic was compared with."),
            ColumnKind.OBSERVER: tr("Whether the operator saw the loss of detail at 2x magnification."),
            ColumnKind.REASON: tr("Why the mosaic could not be compared with a source."),
        }[self.kind])


class WindowsModel(QAbstractTableModel):
    """The session's windows, in the order of one column. Views hear only of the rows that changed."""

    def __init__(
        self, parent: QObject | None = None, result: Callable[[int], WindowResult | None] = lambda fid: None
    ) -> None:
        super().__init__(parent)
        self._result = result  # of a window, by its feature id: the numbers in tooltips
        self.columns = _columns(3)
        self._short_titles = False
        self.sorted_by: Column = Column(ColumnKind.ID)
        self.sort_order = _ASCENDING
        self._rows: list[WindowRecord] = []
        self._places: dict[int, int] = {}
        self._chips: dict[tuple[str, bool], QIcon] = {}
        self._italic = QFont()
        self._italic.setItalic(True)

    def windows(self) -> list[WindowRecord]:
        """From top to bottom; not to be changed."""
        return self._rows

    def set_short_titles(self, short: bool) -> None:
        """Whether headings have to be short."""
        if short != self._short_titles:
            self._short_titles = short
            self.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, len(self.columns) - 1)

    def set_windows(self, windows: Iterable[WindowRecord]) -> None:
        """Show these, with as little stir as can be: selection and persistent indexes stay with their windows."""
        rows = self._in_order(windows)
        levels = max((len(row.ratios) for row in rows), default=0)
        if levels and levels != sum(column.kind is ColumnKind.RATIO for column in self.columns):
            self._reset(rows, levels)
            return
        wanted = {row.fid: row for row in rows}
        gone = _runs(place for place, row in enumerate(self._rows) if row.fid not in wanted)
        added = _runs(place for place, row in enumerate(rows) if row.fid not in self._places)
        if len(gone) + len(added) > _MAX_RUNS:
            self._reset(rows)
            return
        for first, last in reversed(gone):
            self.beginRemoveRows(QModelIndex(), first, last)
            self._set_rows(self._rows[:first] + self._rows[last + 1 :])
            self.endRemoveRows()
        kept = [row for row in rows if row.fid in self._places]
        before = {row.fid: row for row in self._rows}
        if [row.fid for row in kept] != [row.fid for row in self._rows]:
            self._rearrange(kept)
        else:
            self._set_rows(kept)
        for first, last in added:
            self.beginInsertRows(QModelIndex(), first, last)
            self._set_rows(self._rows[:first] + rows[first : last + 1] + self._rows[first:])
            self.endInsertRows()
        self._tell_changes([row != before.get(row.fid, row) for row in rows])

    def sort(self, column: int, order: Qt.SortOrder = _ASCENDING) -> None:
        """By numbers and ranks; windows with nothing in the column come last in either order."""
        self.sort_order = order
        if 0 <= column < len(self.columns):
            self.sorted_by = self.columns[column]
        self._rearrange(self._in_order(self._rows))

    def rowCount(self, parent: QModelIndex = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: QModelIndex = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self.columns)

    def data(self, index: QModelIndex, role: int = _DISPLAY) -> Any:
        if not index.isValid():
            return None
        row, column = self._rows[index.row()], self.columns[index.column()]
        if role == _DISPLAY:
            return column.text(row)
        if role == _ALIGNMENT:
            return _alignment(column)
        if role == _DECORATION and column.kind is ColumnKind.VERDICT:
            return self._chip(row.verdict, row.stale)
        if role == _FONT and row.stale:
            return self._italic
        if role == _TOOL_TIP:
            return column.tip(row, self._result(row.fid))
        return None

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if orientation != Qt.Orientation.Horizontal or not 0 <= section < len(self.columns):
            return None
        column = self.columns[section]
        if role == Qt.ItemDataRole.DisplayRole:
            return column.title(self._short_titles)
        if role == Qt.ItemDataRole.ToolTipRole:
            return column.title_tip()
        if role == Qt.ItemDataRole.TextAlignmentRole:  # the arrow is on the right, and may be drawn over the words
            return _ALIGNED_LEFT if column == self.sorted_by else _alignment(column)
        return None

    def _in_order(self, windows: Iterable[WindowRecord]) -> list[WindowRecord]:
        rows, key = sorted(windows, key=Column(ColumnKind.ID).key), self.sorted_by.key
        present = sorted(
            (row for row in rows if key(row) is not None), key=key, reverse=self.sort_order != _ASCENDING
        )
        return present + [row for row in rows if key(row) is None]

    def _rearrange(self, rows: list[WindowRecord]) -> None:
        """The same windows in another order."""
        self.layoutAboutToBeChanged.emit([], QAbstractTableModel.LayoutChangeHint.VerticalSortHint)
        before = self.persistentIndexList()
        fids = [self._rows[index.row()].fid for index in before]
        self._set_rows(rows)
        after = [self.index(self._places[fid], index.column()) for fid, index in zip(fids, before)]
        self.changePersistentIndexList(before, after)
        self.layoutChanged.emit([], QAbstractTableModel.LayoutChangeHint.VerticalSortHint)

    def _reset(self, rows: list[WindowRecord], levels: int = 0) -> None:
        self.beginResetModel()
        if levels:
            self.columns = _columns(levels)
            if self.sorted_by not in self.columns:
                self.sorted_by, self.sort_order = Column(ColumnKind.ID), _ASCENDING
                rows = self._in_order(rows)
        self._set_rows(rows)
        self.endResetModel()

    def _set_rows(self, rows: list[WindowRecord]) -> None:
        self._rows = rows
        self._places = {row.fid: place for place, row in enumerate(rows)}

    def _tell_changes(self, changed: Sequence[bool]) -> None:
        runs = _runs(place for place, differs in enumerate(changed) if differs)
        if len(runs) > _MAX_RUNS:
            runs = [(runs[0][0], runs[-1][1])]
        for first, last in runs:
            self.dataChanged.emit(self.index(first, 0), self.index(last, len(self.columns) - 1))

    def _chip(self, verdict: str, stale: bool) -> QIcon:
        if (verdict, stale) not in self._chips:
            self._chips[verdict, stale] = verdict_chip(verdict, stale)
        return self._chips[verdict, stale]


def _columns(levels: int) -> tuple[Column, ...]:
    ratios = (Column(ColumnKind.RATIO, level) for level in range(1, levels + 1))
    others = (ColumnKind.CAUSE, ColumnKind.SOURCES, ColumnKind.OBSERVER, ColumnKind.REASON)
    return (Column(ColumnKind.ID), Column(ColumnKind.VERDICT), *ratios, *map(Column, others))


def _alignment(column: Column) -> int:
    if column.kind is ColumnKind.SOURCES:
        return _CENTRED
    return _ALIGNED_RIGHT if column.kind in (ColumnKind.ID, ColumnKind.RATIO) else _ALIGNED_LEFT


def _runs(places: Iterable[int]) -> list[tuple[int, int]]:
    """First and last of each run of consecutive numbers."""
    runs = []
    for _, group in groupby(enumerate(places), key=lambda pair: pair[1] - pair[0]):
        run = [place for _, place in group]
        runs.append((run[0], run[-1]))
    return runs
