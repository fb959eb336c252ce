"""The view of the windows' table: its columns as they fit, keys, a hint when it is empty."""
from __future__ import annotations

from collections.abc import Sequence

from qgis.PyQt.QtCore import QEvent, QItemSelection, QModelIndex, QPoint, QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QFontMetrics, QKeyEvent, QKeySequence, QPaintEvent, QPalette, QResizeEvent
from qgis.PyQt.QtWidgets import QAbstractItemView, QHeaderView, QMenu, QTableView, QWidget

from ....toolkit.desk.theme import ReadableItems, readable_palette
from ....toolkit.painting import painting
from .column_room import ColumnMeter, columns_menu, fitted_columns, load_choice, save_choice
from .window_columns import TableColumn
from .windows_model import WindowsModel


class WindowsTable(QTableView):
    """Whole rows are selected. Delete and Enter are the table's own while it has the focus."""

    removeRequested = pyqtSignal()
    copyRequested = pyqtSignal()
    zoomRequested = pyqtSignal()

    def __init__(self, windows: WindowsModel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.hint = ""  # what is said in the middle of an empty table
        self._windows = windows
        self._fitted: tuple[object, ...] = ()  # the words that columns have room for
        self._choice = load_choice()
        self._blind: frozenset[str] | None = None  # columns that tell nothing; None: all may be seen
        self.setModel(windows)
        self.setItemDelegate(ReadableItems(self))
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setTabKeyNavigation(False)
        self.setSortingEnabled(True)
        self.sortByColumn(0, Qt.SortOrder.AscendingOrder)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.verticalHeader().hide()
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        header = self.horizontalHeader()
        header.setStretchLastSection(True)
        header.setHighlightSections(False)
        header.setTextElideMode(Qt.TextElideMode.ElideRight)
        header.setMinimumSectionSize(1)
        header.sortIndicatorChanged.connect(self.fit)  # the arrow needs room in its column
        header.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        header.customContextMenuRequested.connect(self._show_columns_menu)
        windows.modelReset.connect(self.show_sorting)
        windows.layoutChanged.connect(self._fit_words)
        self.fit()

    def selected_rows(self) -> list[int]:
        """In ascending order."""
        ranges = self.selectionModel().selection()
        return sorted({row for each in ranges for row in range(each.top(), each.bottom() + 1)})

    def selected_fids(self) -> list[int]:
        """From top to bottom."""
        fids = self._windows.fids()
        return [fids[row] for row in self.selected_rows()]

    def rows_selection(self, rows: list[int]) -> QItemSelection:
        """Rows, in ascending order, as a selection."""
        selection = QItemSelection()
        first = 0
        for place, row in enumerate(rows):
            if place + 1 == len(rows) or rows[place + 1] != row + 1:
                selection.select(self._windows.index(rows[first], 0), self._windows.index(row, 0))
                first = place + 1
        return selection

    def is_in_sight(self, row: int) -> bool:
        """Whether the row is in the visible part of the table."""
        rect = self.visualRect(self._windows.index(row, 0))
        return rect.top() >= 0 and rect.bottom() < max(self.viewport().height(), rect.height())

    def visible_columns(self) -> list[TableColumn]:
        """Columns that are seen, from left to right."""
        columns = enumerate(self._windows.columns)
        return [column for section, column in columns if not self.isColumnHidden(section)]

    def set_fewest_rows(self, rows: int) -> None:
        """Show at least so many; 0: as few as there is room for."""
        around = self.horizontalHeader().sizeHint().height() + 2 * self.frameWidth()
        self.setMinimumHeight(around + rows * self.verticalHeader().defaultSectionSize() if rows else 0)

    def set_blind(self, allowed: frozenset[str] | None) -> None:
        """Show no other columns than these, by their fields, whatever was chosen; None: all that were chosen."""
        if allowed != self._blind:
            self._blind = allowed
            self._windows.is_blind = allowed is not None
            self.fit()

    def fit(self) -> None:
        """Widths and heights for this font, these columns and this much room."""
        metrics = QFontMetrics(self.font())
        side = metrics.ascent()
        self.setIconSize(QSize(side, side))
        self.verticalHeader().setDefaultSectionSize(metrics.height() + metrics.height() // 3)
        self._fitted = self._words()
        room, columns, wanted = self.viewport().width(), self._windows.columns, self._chosen()
        meter = ColumnMeter(self, self._windows)
        if wanted is not None:
            sizes = {place: meter.width(column) for place, column in enumerate(columns) if column.field in wanted}
        else:
            sizes = fitted_columns(columns, meter, room)
        for section in range(len(columns)):
            self.setColumnHidden(section, section not in sizes)
        for section, size in sizes.items():
            self.setColumnWidth(section, size)

    def _fit_words(self, *_: object) -> None:
        """A verdict's words, or a loss, may be longer than they were."""
        if self._fitted != self._words():
            self.fit()

    def _words(self) -> tuple[object, ...]:
        return self._windows.has_stale, self._windows.most_lost, self._windows.verdicts

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.oldSize().width() != event.size().width():
            self.fit()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self.fit()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and _is_table_key(event):
            event.accept()  # else QGIS's own action on this key would compete for it
            return True
        return bool(super().event(event))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if not _is_table_key(event):
            super().keyPressEvent(event)
        elif event.matches(QKeySequence.StandardKey.Copy):
            self.copyRequested.emit()
        elif event.matches(QKeySequence.StandardKey.Delete):
            self.removeRequested.emit()
        else:
            self.zoomRequested.emit()

    def dataChanged(self, first: QModelIndex, last: QModelIndex, roles: Sequence[int] = ()) -> None:
        """Paint the rows that changed, and no others as Qt 5 does."""
        self._fit_words()
        top = self.rowViewportPosition(first.row())
        bottom = self.rowViewportPosition(last.row()) + self.rowHeight(last.row())
        self.viewport().update(0, top, self.viewport().width(), bottom - top)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.hint and self._windows.rowCount() == 0:
            with painting(self.viewport()) as painter:
                painter.setPen(readable_palette(self).color(QPalette.ColorRole.PlaceholderText))
                margin = self.fontMetrics().height()
                room = self.viewport().rect().adjusted(margin, 0, -margin, 0)
                painter.drawText(room, int(Qt.AlignmentFlag.AlignCenter) | int(Qt.TextFlag.TextWordWrap), self.hint)

    def show_sorting(self) -> None:
        """The arrow may stand on another column after the columns changed."""
        header = self.horizontalHeader()
        blocked = header.blockSignals(True)
        header.setSortIndicator(self._windows.columns.index(self._windows.sorted_by), self._windows.sort_order)
        header.blockSignals(blocked)
        self.fit()

    # Columns that the operator chose

    def _chosen(self) -> frozenset[str] | None:
        """The fields of the columns to be seen; None where they are those there is room for."""
        if self._blind is not None:
            return self._blind
        known = {column.field for column in self._windows.columns}.intersection(self._choice)
        return frozenset(known) or None

    def _choose(self, fields: tuple[str, ...]) -> None:
        self._choice = fields
        save_choice(fields)
        self.fit()

    def _show_columns_menu(self, place: QPoint) -> None:
        if self._blind is None:
            self.columns_menu().popup(self.horizontalHeader().mapToGlobal(place))

    def columns_menu(self) -> QMenu:
        """The columns that are seen."""
        visible = [column.field for column in self.visible_columns()]
        menu = columns_menu(self._windows.columns, visible, self._choose, self)
        menu.aboutToHide.connect(menu.deleteLater)
        return menu


def _is_table_key(event: QKeyEvent) -> bool:
    enter = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
    keys = (QKeySequence.StandardKey.Delete, QKeySequence.StandardKey.Copy)
    return any(map(event.matches, keys)) or (
        enter and event.modifiers() in (Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.KeypadModifier)
    )
