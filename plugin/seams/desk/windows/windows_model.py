"""The windows as a sorted table, kept in step with the session row by row."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import compress, groupby
from operator import is_not, itemgetter
from typing import TYPE_CHECKING, Any

from qgis.PyQt.QtCore import QAbstractTableModel, QModelIndex, QObject, Qt
from qgis.PyQt.QtGui import QFont, QIcon

from .window_columns import ALIGNED_LEFT, WINDOW_ID, TableColumn, all_columns, columns_of, used_columns, verdict_chip

if TYPE_CHECKING:
    from ...measure.window.window_result import WindowResult
    from ...measure.window_records import WindowRecord

_DISPLAY = Qt.ItemDataRole.DisplayRole  # found faster than by way of Qt: each cell asks for seven roles
_ALIGNMENT = Qt.ItemDataRole.TextAlignmentRole
_DECORATION = Qt.ItemDataRole.DecorationRole
_FONT = Qt.ItemDataRole.FontRole
_TOOL_TIP = Qt.ItemDataRole.ToolTipRole
_MAX_RUNS = 64  # changes in more places than that are told to the views as one
_ASCENDING = Qt.SortOrder.AscendingOrder


class WindowsModel(QAbstractTableModel):
    """The session's windows, in the order of one column. Views hear only of the rows that changed."""

    def __init__(
        self, parent: QObject | None = None, result: Callable[[int], WindowResult | None] = lambda fid: None
    ) -> None:
        super().__init__(parent)
        self._result = result  # of a window, by its feature id: the numbers in tooltips
        self._levels, self._used = 3, frozenset[str]()
        self.columns = all_columns(columns_of(self._levels), self._used)
        self.is_blind = False
        """Whether tooltips keep to themselves what was found."""
        self._short_titles = False
        self.sorted_by: TableColumn | None = WINDOW_ID
        """None in an order that is no column's."""
        self._key: Callable[[WindowRecord], Any] = WINDOW_ID.key
        self.sort_order = _ASCENDING
        self._rows: list[WindowRecord] = []
        self._taken: Sequence[WindowRecord] = ()  # the windows as they were given, in their own order
        self._stale = 0
        self._places: dict[int, int] = {}
        self._chips: dict[tuple[str, bool], QIcon] = {}
        self._italic = QFont()
        self._italic.setItalic(True)

    def windows(self) -> list[WindowRecord]:
        """From top to bottom; not to be changed."""
        return self._rows

    @property
    def has_stale(self) -> bool:
        """Whether a window is to be inspected again."""
        return self._stale > 0

    def set_short_titles(self, short: bool) -> None:
        """Whether headings have to be short."""
        if short != self._short_titles:
            self._short_titles = short
            self.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, len(self.columns) - 1)

    def set_windows(self, windows: Iterable[WindowRecord]) -> None:
        """Show these, with as little stir as can be: selection and persistent indexes stay with their windows."""
        windows = list(windows)
        if self._took_in_place(windows):
            return
        rows = self._in_order(windows)
        levels, used = max((len(row.ratios) for row in rows), default=0) or self._levels, used_columns(rows)
        if (levels, used) != (self._levels, self._used):
            self._levels, self._used = levels, used
            self._reset(rows, all_columns(columns_of(levels), used))
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
        self._tell_changes(
            place for place, row in enumerate(rows) if (old := before.get(row.fid, row)) is not row and old != row
        )

    def _took_in_place(self, windows: Sequence[WindowRecord]) -> bool:
        """Whether the windows shown are the same, in the same places, and only what is said of some of them changed.

        So it is while windows are judged: among thousands of others one costs hardly more than among a few.
        """
        taken, self._taken = self._taken, windows
        if len(windows) != len(taken):
            return False
        changed = {}
        for row in compress(windows, [*map(is_not, windows, taken)]):
            place = self._places.get(row.fid)
            if place is None or not self._stays(self._rows[place], row):
                return False
            changed[place] = row
        told = sorted(place for place, row in changed.items() if row != self._rows[place])
        for place, row in changed.items():
            self._stale += row.stale - self._rows[place].stale
            self._rows[place] = row
        self._tell_changes(told)
        return True

    def _stays(self, old: WindowRecord, new: WindowRecord) -> bool:
        """Whether a window needs no other place and no other columns."""
        is_in_order = old.window_id == new.window_id and self._key(old) == self._key(new)
        return is_in_order and len(old.ratios) == len(new.ratios) and used_columns([old]) == used_columns([new])

    def sort(self, column: int, order: Qt.SortOrder = _ASCENDING) -> None:
        """By numbers and ranks; windows with nothing in the column come last in either order."""
        self.sort_order = order
        if 0 <= column < len(self.columns):
            self.sorted_by = self.columns[column]
            self._key = self.sorted_by.key
        self._rearrange(self._in_order(self._rows))

    def sort_by(self, key: Callable[[WindowRecord], Any]) -> None:
        """In an order that is no column's."""
        self.sorted_by, self.sort_order, self._key = None, _ASCENDING, key
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
            return column.alignment
        if role == _DECORATION and column.name == "verdict":
            return self._chip(row.verdict, row.stale)
        if role == _FONT and row.stale:
            return self._italic
        if role == _TOOL_TIP:
            return None if self.is_blind else column.tip(row, self._result(row.fid))
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
            return ALIGNED_LEFT if column == self.sorted_by else column.alignment
        return None

    def _in_order(self, windows: Iterable[WindowRecord]) -> list[WindowRecord]:
        keyed = [(self._key(row), row) for row in sorted(windows, key=WINDOW_ID.key)]
        present = [pair for pair in keyed if pair[0] is not None]
        present.sort(key=itemgetter(0), reverse=self.sort_order != _ASCENDING)
        return [row for _, row in present] + [row for value, row in keyed if value is None]

    def _rearrange(self, rows: list[WindowRecord]) -> None:
        """The same windows in another order."""
        self.layoutAboutToBeChanged.emit([], QAbstractTableModel.LayoutChangeHint.VerticalSortHint)
        before = self.persistentIndexList()
        fids = [self._rows[index.row()].fid for index in before]
        self._set_rows(rows)
        after = [self.index(self._places[fid], index.column()) for fid, index in zip(fids, before)]
        self.changePersistentIndexList(before, after)
        self.layoutChanged.emit([], QAbstractTableModel.LayoutChangeHint.VerticalSortHint)

    def _reset(self, rows: list[WindowRecord], columns: tuple[TableColumn, ...] = ()) -> None:
        self.beginResetModel()
        if columns:
            self.columns = columns
            if self.sorted_by is not None and self.sorted_by not in columns:
                self.sorted_by, self.sort_order, self._key = WINDOW_ID, _ASCENDING, WINDOW_ID.key
                rows = self._in_order(rows)
        self._set_rows(rows)
        self.endResetModel()

    def _set_rows(self, rows: list[WindowRecord]) -> None:
        self._rows, self._stale = rows, sum(row.stale for row in rows)
        self._places = {row.fid: place for place, row in enumerate(rows)}

    def _tell_changes(self, changed: Iterable[int]) -> None:
        runs = _runs(changed)
        if len(runs) > _MAX_RUNS:
            runs = [(runs[0][0], runs[-1][1])]
        for first, last in runs:
            self.dataChanged.emit(self.index(first, 0), self.index(last, len(self.columns) - 1))

    def _chip(self, verdict: str, stale: bool) -> QIcon:
        if (verdict, stale) not in self._chips:
            self._chips[verdict, stale] = verdict_chip(verdict, stale)
        return self._chips[verdict, stale]


def _runs(places: Iterable[int]) -> list[tuple[int, int]]:
    """First and last of each run of consecutive numbers."""
    groups = groupby(enumerate(places), key=lambda pair: pair[1] - pair[0])
    runs = ([place for _, place in group] for _, group in groups)
    return [(run[0], run[-1]) for run in runs]
