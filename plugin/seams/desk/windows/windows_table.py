"""The table of windows: its rows, sorted and filtered, and its view with the columns that there is room for."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any

from qgis.PyQt.QtCore import (
    QAbstractTableModel,
    QEvent,
    QItemSelection,
    QItemSelectionModel,
    QModelIndex,
    QObject,
    QSize,
    Qt,
    pyqtSignal,
)
from qgis.PyQt.QtGui import QFont, QIcon, QKeyEvent, QKeySequence, QResizeEvent
from qgis.PyQt.QtWidgets import QAbstractItemView, QHeaderView, QStyle, QStyleOptionHeader, QTableView, QWidget

from ....toolkit.desk.theme import ReadableItems
from ....toolkit.desk.widgets import rich_tip, single_shot
from ....toolkit.translation import tr
from .window_columns import ALIGNED_LEFT, COLUMNS, WINDOW_ID, TableColumn, used_columns, verdict_chip

if TYPE_CHECKING:
    from ...measure.window.window_result import WindowResult
    from ...measure.window_records import WindowRecord

_DISPLAY = Qt.ItemDataRole.DisplayRole
_ASCENDING, _DESCENDING = Qt.SortOrder.AscendingOrder, Qt.SortOrder.DescendingOrder


class WindowsModel(QAbstractTableModel):
    """The session's windows, in the order of one column. Where only values change, views hear of their rows alone."""

    def __init__(
        self, parent: QObject | None = None, result: Callable[[int], WindowResult | None] = lambda fid: None
    ) -> None:
        super().__init__(parent)
        self._result = result  # of a window, by its feature id: the numbers in tooltips
        self.is_blind = False  # whether tooltips keep to themselves what was found
        self.sorted_by, self.sort_order = WINDOW_ID, _ASCENDING
        self._tests: Sequence[Callable[[WindowRecord], bool]] = ()
        self.all_windows: Sequence[WindowRecord] = ()  # in their own order, those included that are left out
        self._rows: list[WindowRecord] = []
        self._fids: list[int] = []
        self._places: dict[int, int] = {}
        self._chips: dict[str, QIcon] = {}
        self._italic = QFont()
        self._italic.setItalic(True)

    def windows(self) -> list[WindowRecord]:
        """From top to bottom; not to be changed."""
        return self._rows

    def fids(self) -> list[int]:
        """Feature ids of the shown windows, from top to bottom; not to be changed, one list while they are the same."""
        return self._fids

    def row_of(self, fid: int) -> int:
        """The row a window is shown in; -1 when it is not."""
        return self._places.get(fid, -1)

    def set_windows(self, windows: Sequence[WindowRecord]) -> None:
        """Take these; only those that changed are asked whether they pass."""
        known, self.all_windows = {row.fid: row for row in self.all_windows}, windows
        places = self._places
        self._show([row for row in windows if (row.fid in places if known.get(row.fid) is row else self._passes(row))])

    def set_filter(self, tests: Iterable[Callable[[WindowRecord], bool]]) -> None:
        """Show the windows that pass all of these."""
        self._tests = tuple(tests)
        self._show(list(filter(self._passes, self.all_windows)))

    def sort(self, column: int, order: Qt.SortOrder = _ASCENDING) -> None:
        """Sort by numbers and ranks; windows with nothing in the column come last in either order."""
        self.sorted_by, self.sort_order = COLUMNS[max(column, 0)], order
        self._show(self._rows)

    def _passes(self, row: WindowRecord) -> bool:
        return all(test(row) for test in self._tests)

    def _show(self, windows: list[WindowRecord]) -> None:
        rows = self._in_order(windows)
        fids = [row.fid for row in rows]
        if fids != self._fids:
            self.beginResetModel()
            self._rows, self._fids = rows, fids
            self._places = {fid: place for place, fid in enumerate(fids)}
            self.endResetModel()
            return
        before, self._rows = self._rows, rows
        changed = [place for place, (old, new) in enumerate(zip(before, rows)) if old is not new and old != new]
        if changed:
            self.dataChanged.emit(self.index(changed[0], 0), self.index(changed[-1], len(COLUMNS) - 1))

    def _in_order(self, windows: list[WindowRecord]) -> list[WindowRecord]:
        key, by_number = self.sorted_by.key, sorted(windows, key=lambda row: row.window_id)
        present = [row for row in by_number if key(row) is not None]
        absent = [row for row in by_number if key(row) is None] if len(present) < len(by_number) else []
        return sorted(present, key=key, reverse=self.sort_order != _ASCENDING) + absent

    # What views ask

    def rowCount(self, parent: QModelIndex = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: QModelIndex = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(COLUMNS)

    def data(self, index: QModelIndex, role: int = _DISPLAY) -> Any:
        if not index.isValid():
            return None
        row, column = self._rows[index.row()], COLUMNS[index.column()]
        if role == _DISPLAY:
            return column.text(row)
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return column.alignment
        if role == Qt.ItemDataRole.DecorationRole and column.name == "verdict":
            return self._chip(row.verdict)
        if role == Qt.ItemDataRole.FontRole and row.stale:
            return self._italic
        if role == Qt.ItemDataRole.ToolTipRole:
            return None if self.is_blind else column.tip(row, self._result(row.fid))
        return None

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = _DISPLAY) -> Any:
        if orientation != Qt.Orientation.Horizontal or not 0 <= section < len(COLUMNS):
            return None
        column = COLUMNS[section]
        if role == _DISPLAY:
            return column.title()
        if role == Qt.ItemDataRole.ToolTipRole:
            return rich_tip(tr(column.explanation))
        if role == Qt.ItemDataRole.InitialSortOrderRole:  # by the first click on it
            return _DESCENDING if column.name == "loss" else _ASCENDING
        if role == Qt.ItemDataRole.TextAlignmentRole:  # the arrow is on the right, and may be drawn over the words
            return ALIGNED_LEFT if column == self.sorted_by else column.alignment
        return None

    def _chip(self, verdict: str) -> QIcon:
        if verdict not in self._chips:
            self._chips[verdict] = verdict_chip(verdict)
        return self._chips[verdict]


_GIVING_WAY = ("paper_verdict", "sources", "remark", "confidence", "ratio", "observer_2")
"""Columns without room, the first that go first; verdict, loss, cause and observer always stay."""
_CUT_SHORT = ("cause", "observer", "observer_2", "remark", "verdict")
"""Columns of words that are known by their first letters, in the order in which they are cut, and get room again; the
verdict only when no column is there to give way."""
_LETTERS = 8  # that words have at least beyond their heading before another column goes
_MEASURED_ROWS = 30  # from the first that is seen, of which a column has room for the longest
_FIT_MS = 100  # from a change on, so that many at once cost one look at all rows


class WindowsTable(QTableView):
    """Whole rows are selected. Delete and Enter are the table's own while it has the focus."""

    removeRequested = pyqtSignal()
    zoomRequested = pyqtSignal()

    def __init__(self, windows: WindowsModel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._windows = windows
        self.all_windowsowed: frozenset[str] | None = None  # those that tell nothing; None: all may be seen
        self._fit_soon = single_shot(self, self.fit, _FIT_MS)
        self.setModel(windows)
        self.setItemDelegate(ReadableItems(self))
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setTabKeyNavigation(False)
        self.setSortingEnabled(True)
        self.sortByColumn(0, _ASCENDING)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.verticalHeader().hide()
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        header = self.horizontalHeader()
        header.setStretchLastSection(True)
        header.setHighlightSections(False)
        header.setTextElideMode(Qt.TextElideMode.ElideRight)
        header.setMinimumSectionSize(1)
        header.setResizeContentsPrecision(_MEASURED_ROWS)
        header.sortIndicatorChanged.connect(self.fit)  # the arrow needs room in its column
        windows.modelReset.connect(self.fit)  # a column may be of use from now on, or a number longer
        self.fit()

    def selected_rows(self) -> list[int]:
        """In ascending order."""
        ranges = self.selectionModel().selection()
        return sorted({row for each in ranges for row in range(each.top(), each.bottom() + 1)})

    def selected_fids(self) -> list[int]:
        """From top to bottom."""
        fids = self._windows.fids()
        return [fids[row] for row in self.selected_rows()]

    def select_rows(self, rows: list[int]) -> None:
        """Select rows, in ascending order, and no others; one of them is the current one."""
        if rows != self.selected_rows():
            selection, first = QItemSelection(), 0
            for place, row in enumerate(rows):
                if place + 1 == len(rows) or rows[place + 1] != row + 1:
                    selection.select(self._windows.index(rows[first], 0), self._windows.index(row, 0))
                    first = place + 1
            flags = QItemSelectionModel.SelectionFlag
            self.selectionModel().select(selection, flags.ClearAndSelect | flags.Rows)
        if rows and self.currentIndex().row() not in rows:
            current = self._windows.index(rows[0], 0)
            self.selectionModel().setCurrentIndex(current, QItemSelectionModel.SelectionFlag.NoUpdate)

    def is_in_sight(self, row: int) -> bool:
        """Whether the row is in the visible part of the table."""
        rect = self.visualRect(self._windows.index(row, 0))
        return rect.top() >= 0 and rect.bottom() < max(self.viewport().height(), rect.height())

    def set_fewest_rows(self, rows: int) -> None:
        """Show at least so many; 0: as few as there is room for."""
        around = self.horizontalHeader().sizeHint().height() + 2 * self.frameWidth()
        self.setMinimumHeight(around + rows * self.verticalHeader().defaultSectionSize() if rows else 0)

    def set_blind(self, allowed: frozenset[str] | None) -> None:
        """Show no other columns than these; None: all that are of use."""
        self.all_windowsowed = allowed
        self._windows.is_blind = allowed is not None
        self.fit()

    # Columns and their widths

    def fit(self) -> None:
        """Columns, widths and heights for this font, these windows and this much room."""
        metrics = self.fontMetrics()
        self.setIconSize(QSize(metrics.ascent(), metrics.ascent()))
        self.verticalHeader().setDefaultSectionSize(metrics.height() + metrics.height() // 3)
        names = used_columns(self._windows.all_windows)
        widths = self._widths(names if self.all_windowsowed is None else names & self.all_windowsowed)
        for place, column in enumerate(COLUMNS):
            self.setColumnHidden(place, column.name not in widths)
            if column.name in widths:
                self.setColumnWidth(place, widths[column.name])

    def _widths(self, names: frozenset[str]) -> dict[str, int]:
        """Widths of those among some columns that there is room for."""
        room, letters = self.viewport().width(), _LETTERS * self.fontMetrics().averageCharWidth()
        places = {column.name: place for place, column in enumerate(COLUMNS) if column.name in names}
        headings = {name: self._heading(COLUMNS[place]) for name, place in places.items()}
        whole = {name: max(headings[name], self.sizeHintForColumn(place)) for name, place in places.items()}
        cut = (name for name in _CUT_SHORT[:-1] if name in names)
        short = {name: min(whole[name], headings[name] + letters) for name in cut}
        widths = {**whole, **short}
        for name in _GIVING_WAY:
            if sum(widths.values()) > room:
                widths.pop(name, None)
        spare = room - sum(widths.values())
        for name in filter(widths.get, _CUT_SHORT):
            limit = whole[name] if spare > 0 else headings[name]
            change = min(limit - widths[name], spare, key=abs)
            widths[name], spare = widths[name] + change, spare - change
        return widths

    def _heading(self, column: TableColumn) -> int:
        """That shows all of a heading, with what the style or a theme's style sheet puts around it."""
        header, is_sorted = self.horizontalHeader(), column == self._windows.sorted_by
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

    def dataChanged(self, first: QModelIndex, last: QModelIndex, roles: Sequence[int] = ()) -> None:
        """Paint the rows that changed, and no others as Qt 5 does."""
        if not self._fit_soon.isActive():  # a column may be of use, or words longer, as causes told after the verdict
            self._fit_soon.start()
        top = self.rowViewportPosition(first.row())
        bottom = self.rowViewportPosition(last.row()) + self.rowHeight(last.row())
        self.viewport().update(0, top, self.viewport().width(), bottom - top)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.oldSize().width() != event.size().width():
            self.fit()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self.fit()

    # Keys

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and _is_table_key(event):
            event.accept()  # else QGIS's own action on this key would compete for it
            return True
        return bool(super().event(event))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if not _is_table_key(event):
            super().keyPressEvent(event)
        elif event.matches(QKeySequence.StandardKey.Delete):
            self.removeRequested.emit()
        else:
            self.zoomRequested.emit()


def _is_table_key(event: QKeyEvent) -> bool:
    enter = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
    return event.matches(QKeySequence.StandardKey.Delete) or (
        enter and event.modifiers() in (Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.KeypadModifier)
    )
