"""The windows as a sorted table, those left out that nobody wants to see, kept in step with the session row by row."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from qgis.PyQt.QtCore import QAbstractTableModel, QModelIndex, QObject, Qt
from qgis.PyQt.QtGui import QFont, QIcon

from .window_columns import ALIGNED_LEFT, WINDOW_ID, TableColumn, all_columns, is_by_ratio, used_columns, verdict_chip

if TYPE_CHECKING:
    from ...measure.window.window_result import WindowResult
    from ...measure.window_records import WindowRecord

_DISPLAY = Qt.ItemDataRole.DisplayRole  # found faster than by way of Qt: each cell asks for seven roles
_ALIGNMENT = Qt.ItemDataRole.TextAlignmentRole
_DECORATION = Qt.ItemDataRole.DecorationRole
_FONT = Qt.ItemDataRole.FontRole
_TOOL_TIP = Qt.ItemDataRole.ToolTipRole
_FIRST_ORDER = Qt.ItemDataRole.InitialSortOrderRole
_ASCENDING, _DESCENDING = Qt.SortOrder.AscendingOrder, Qt.SortOrder.DescendingOrder


class WindowsModel(QAbstractTableModel):
    """The session's windows, in the order of one column. Where only values change, views hear of their rows alone."""

    def __init__(
        self, parent: QObject | None = None, result: Callable[[int], WindowResult | None] = lambda fid: None
    ) -> None:
        super().__init__(parent)
        self._result = result  # of a window, by its feature id: the numbers in tooltips
        self._levels, self._used, self._by_ratio = 3, frozenset[str](), False
        self.columns = all_columns(self._levels, self._used, self._by_ratio)
        self.is_blind = False  # whether tooltips keep to themselves what was found
        self.sorted_by = WINDOW_ID
        self.sort_order = _ASCENDING
        self._tests: Sequence[Callable[[WindowRecord], bool]] = ()
        self._taken: Sequence[WindowRecord] = ()  # all windows as they were given, in their own order
        self._chips: dict[tuple[str, bool], QIcon] = {}
        self._italic = QFont()
        self._italic.setItalic(True)
        self.has_stale = False  # whether a window is to be inspected again
        self.verdicts: frozenset[str] = frozenset()  # those that windows have
        self.most_lost = 0.0  # the largest loss of a window, m²
        self._fids: list[int] = []
        self._set_rows([])

    # The windows shown

    def windows(self) -> list[WindowRecord]:
        """From top to bottom; not to be changed."""
        return self._rows

    def fids(self) -> list[int]:
        """Feature ids of the shown windows, from top to bottom; not to be changed, one list while they are the same."""
        return self._fids

    def row_of(self, fid: int) -> int:
        """The row a window is shown in; -1 when it is not."""
        return self._places.get(fid, -1)

    def row_numbered(self, number: int) -> int:
        """The row of the window with a number, which stays the same when saving gives it another feature id."""
        fid = self._numbers.get(number)
        return -1 if fid is None else self._places[fid]

    @property
    def count(self) -> int:
        """Number of all windows, those included that are left out."""
        return len(self._taken)

    @property
    def levels(self) -> int:
        """Levels of the ratios that there are columns for."""
        return self._levels

    @property
    def is_filtered(self) -> bool:
        """Whether some windows may be left out."""
        return bool(self._tests)

    def set_windows(self, windows: Iterable[WindowRecord]) -> None:
        """Take these, with as little stir as can be while no window comes or goes."""
        windows, taken = list(windows), self._taken
        self._taken, self.has_stale = windows, True in [row.stale for row in windows]
        self.verdicts = frozenset({row.verdict for row in windows})
        self.most_lost = max([row.loss for row in windows if row.loss is not None], default=0.0)
        if self._updated_in_place(taken, windows):
            return
        known = {row.fid: row for row in taken}
        wanted = [
            row for row in windows
            if (row.fid in self._places if known.get(row.fid) is row else self._passes(row))
        ]
        rows = self._in_order(wanted)
        levels, used = max((len(row.ratios) for row in windows), default=0) or self._levels, used_columns(windows)
        by_ratio = is_by_ratio(windows)
        if (levels, used, by_ratio) != (self._levels, self._used, self._by_ratio):
            self._levels, self._used, self._by_ratio = levels, used, by_ratio
            self._reset(rows, all_columns(levels, used, by_ratio))
        else:
            self._show(rows)

    def set_filter(self, tests: Iterable[Callable[[WindowRecord], bool]]) -> None:
        """Show the windows that pass all of these."""
        self._tests = tuple(tests)
        self._show(self._in_order(row for row in self._taken if self._passes(row)))

    def sort(self, column: int, order: Qt.SortOrder = _ASCENDING) -> None:
        """Sort by numbers and ranks; windows with nothing in the column come last in either order."""
        self.sort_order = order
        if 0 <= column < len(self.columns):
            self.sorted_by = self.columns[column]
        self._rearrange(self._in_order(self._rows))

    # What views ask

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

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = _DISPLAY) -> Any:
        if orientation != Qt.Orientation.Horizontal or not 0 <= section < len(self.columns):
            return None
        column = self.columns[section]
        if role == _DISPLAY:
            return column.title()
        if role == _TOOL_TIP:
            return column.title_tip()
        if role == _FIRST_ORDER:  # by the first click on it
            return _DESCENDING if column.name == "loss" else _ASCENDING
        if role == _ALIGNMENT:  # the arrow is on the right, and may be drawn over the words
            return ALIGNED_LEFT if column == self.sorted_by else column.alignment
        return None

    # From one state of the rows to the next

    def _updated_in_place(self, taken: Sequence[WindowRecord], windows: Sequence[WindowRecord]) -> bool:
        """Whether the same windows are shown in the same places, and only what is said of some of them changed.

        So it is while windows are judged: among thousands of others one costs hardly more than among a few.
        """
        if len(windows) != len(taken):
            return False
        changed = [(old, new) for old, new in zip(taken, windows) if old is not new]
        if not all(self._stays(old, new) for old, new in changed):
            return False
        changed = [(old, new) for old, new in changed if old.fid in self._places]
        for old, new in changed:
            self._rows[self._places[old.fid]] = new
        places = [self._places[old.fid] for old, new in changed if old != new]
        if places:
            self.dataChanged.emit(self.index(min(places), 0), self.index(max(places), len(self.columns) - 1))
        return True

    def _stays(self, old: WindowRecord, new: WindowRecord) -> bool:
        """Whether a window needs no other place and no other columns."""
        return (
            (old.fid, old.window_id) == (new.fid, new.window_id)
            and self.sorted_by.key(old) == self.sorted_by.key(new)
            and len(old.ratios) == len(new.ratios)
            and used_columns([old]) == used_columns([new])
            and is_by_ratio([old]) == is_by_ratio([new])
            and (old.fid in self._places) == self._passes(new)
        )

    def _passes(self, row: WindowRecord) -> bool:
        return all(test(row) for test in self._tests)

    def _in_order(self, windows: Iterable[WindowRecord]) -> list[WindowRecord]:
        keyed = [(self.sorted_by.key(row), row) for row in sorted(windows, key=WINDOW_ID.key)]
        present = [pair for pair in keyed if pair[0] is not None]
        present.sort(key=itemgetter(0), reverse=self.sort_order != _ASCENDING)
        return [row for _, row in present] + [row for value, row in keyed if value is None]

    def _show(self, rows: list[WindowRecord]) -> None:
        """Other rows instead of those shown."""
        if self._places.keys() == {row.fid for row in rows}:
            self._rearrange(rows)
        else:
            self._reset(rows)

    def _rearrange(self, rows: list[WindowRecord]) -> None:
        """Show the same windows in another order."""
        self.layoutAboutToBeChanged.emit([], QAbstractTableModel.LayoutChangeHint.VerticalSortHint)
        before = self.persistentIndexList()
        fids = [self._fids[index.row()] for index in before]
        self._set_rows(rows)
        after = [self.index(self._places[fid], index.column()) for fid, index in zip(fids, before)]
        self.changePersistentIndexList(before, after)
        self.layoutChanged.emit([], QAbstractTableModel.LayoutChangeHint.VerticalSortHint)

    def _reset(self, rows: list[WindowRecord], columns: tuple[TableColumn, ...] = ()) -> None:
        self.beginResetModel()
        if columns:
            self.columns = columns
            if self.sorted_by not in columns:
                self.sorted_by, self.sort_order = WINDOW_ID, _ASCENDING
                rows = self._in_order(rows)
        self._set_rows(rows)
        self.endResetModel()

    def _set_rows(self, rows: list[WindowRecord]) -> None:
        fids = [row.fid for row in rows]
        self._rows, self._fids = rows, self._fids if fids == self._fids else fids
        self._places = {fid: place for place, fid in enumerate(self._fids)}
        self._numbers = {row.window_id: row.fid for row in rows}

    def _chip(self, verdict: str, stale: bool) -> QIcon:
        if (verdict, stale) not in self._chips:
            self._chips[verdict, stale] = verdict_chip(verdict, stale)
        return self._chips[verdict, stale]
