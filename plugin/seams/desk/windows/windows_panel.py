"""The windows as a sortable, filterable table whose selection is the window layer's."""
from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from operator import attrgetter
from typing import TYPE_CHECKING

from qgis.core import QgsApplication
from qgis.gui import QgsFilterLineEdit
from qgis.PyQt.QtCore import QItemSelectionModel, QModelIndex, QPoint, Qt, pyqtSignal
from qgis.PyQt.QtGui import QKeySequence
from qgis.PyQt.QtWidgets import (
    QAbstractItemView,
    QAction,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QMenu,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from ....toolkit.translation import tr
from ...verdict_words import VERDICTS, verdict_word
from .verdict_chips import verdict_chip
from .windows_filter import WindowsFilter
from .windows_model import WindowsModel
from .windows_table import WindowsTable

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord
    from ..session import Session

_SELECT_ROWS = QItemSelectionModel.SelectionFlag.ClearAndSelect | QItemSelectionModel.SelectionFlag.Rows


class WindowsPanel(QWidget):
    """The table of windows with its filter."""

    zoomRequested = pyqtSignal(int)
    """Feature id of the window to be looked at."""
    orderChanged = pyqtSignal()
    """Other windows are shown, or in another order."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._is_following = False
        self._windows = WindowsModel(self, session.result)
        self._shown = WindowsFilter(self._windows, self)
        self._search = QgsFilterLineEdit(self)  # before the table, for Tab
        self._verdicts = QComboBox(self)
        self._count = QLabel(self)
        self.table = WindowsTable(self._windows, self._shown, self)
        self.table.setToolTip(tr("Double click zooms to a window; Del removes the selected ones."))
        self.table.setAccessibleName(tr("Windows"))
        self._set_up_filter()
        self._menu = self._make_menu()
        self._lay_out()

        self._search.textChanged.connect(self._filter)
        self._verdicts.currentIndexChanged.connect(self._filter)
        self.table.selectionModel().selectionChanged.connect(self._lead)
        self.table.doubleClicked.connect(self._zoom_to)
        self.table.zoomRequested.connect(self._zoom)
        self.table.removeRequested.connect(self._remove)
        self.table.customContextMenuRequested.connect(self._show_menu)
        self._shown.layoutChanged.connect(self._tell_order)
        session.windowsChanged.connect(self._take_windows)
        session.selectionChanged.connect(self._take_selection)
        self._take_windows()

    def sort_by_number(self) -> None:
        """As it was before the operator sorted otherwise."""
        self.table.sortByColumn(0, Qt.SortOrder.AscendingOrder)

    def ordered_fids(self) -> list[int]:
        """The windows as they are shown, from top to bottom."""
        return list(self._shown.fids())

    # Following the session

    def _take_windows(self) -> None:
        with self._following():
            self._windows.set_windows(self._session.windows())

    def _filter(self, *_: object) -> None:
        with self._following():
            self._shown.set_filter(self._search.text(), self._verdicts.currentData())

    @contextmanager
    def _following(self) -> Iterator[None]:
        """While rows come and go the table's selection changes by itself; the session's is what counts."""
        numbers, top = self._shown.numbers(), self.table.rowAt(0)
        anchor = numbers[top] if self.table.verticalScrollBar().value() > 0 and top >= 0 else None
        selected = self._selected_numbers()
        with self._unmoved():
            yield
        numbers = self._shown.numbers()
        if anchor in numbers and numbers.index(anchor) != self.table.rowAt(0):
            top_index = self._shown.index(numbers.index(anchor), 0)
            self.table.scrollTo(top_index, QAbstractItemView.ScrollHint.PositionAtTop)
        self._show_selection(selected)
        self._describe()
        self.orderChanged.emit()

    def _take_selection(self) -> None:
        self._show_selection(self._selected_numbers())

    def _selected_numbers(self) -> set[int]:
        numbers = self._shown.numbers()
        return {numbers[row] for row in self.table.selected_rows()}

    def _show_selection(self, before: set[int]) -> None:
        """Select what the session has selected, and bring it into sight where it was not selected ``before``."""
        rows = sorted(row for row in map(self._shown.row_of, self._session.selected()) if row >= 0)
        selection = self.table.selectionModel()
        with self._unmoved():
            if rows != self.table.selected_rows():
                selection.select(self.table.rows_selection(rows), _SELECT_ROWS)
            if rows and selection.currentIndex().row() not in rows:
                selection.setCurrentIndex(self._shown.index(rows[0], 0), QItemSelectionModel.SelectionFlag.NoUpdate)
        numbers = self._shown.numbers()
        fresh = [row for row in rows if numbers[row] not in before]
        if fresh and not any(map(self.table.is_in_sight, rows)):
            self.table.scrollTo(self._shown.index(fresh[0], 0), QAbstractItemView.ScrollHint.PositionAtCenter)

    @contextmanager
    def _unmoved(self) -> Iterator[None]:
        """While selection and current row follow the session they neither lead it nor scroll."""
        before, self._is_following = self._is_following, True
        self.table.setAutoScroll(False)
        try:
            yield
        finally:
            self._is_following = before
            self.table.setAutoScroll(True)

    def _lead(self, *_: object) -> None:
        """The operator selected rows."""
        if not self._is_following:
            fids = self.table.selected_fids()
            if set(fids) != set(self._session.selected()):
                self._session.select(fids)

    def _tell_order(self, *_: object) -> None:
        if not self._is_following:
            self.orderChanged.emit()

    def _describe(self) -> None:
        """How many windows are left by the filter, and what an empty table says."""
        shown, count = self._shown.rowCount(), self._windows.rowCount()
        self._count.setVisible(self._shown.is_on and count > 0)
        self._count.setText(tr("{shown} of {count}").format(shown=shown, count=count))
        hint = tr("Draw a window on the map, or place windows along the seamlines.")
        if count:
            hint = tr("No window matches the filter.")
        if hint != self.table.hint:
            self.table.hint = hint
            self.table.viewport().update()

    # What the operator asks for

    def _zoom_to(self, index: QModelIndex) -> None:
        self.zoomRequested.emit(self._shown.fids()[index.row()])

    def _zoom(self) -> None:
        current = self.table.currentIndex()
        if current.isValid():
            self._zoom_to(current)

    def _inspect(self) -> None:
        self._session.inspect(self.table.selected_fids())

    def _judge_visible(self) -> None:
        self._session.judge(self.table.selected_fids(), "visible")

    def _judge_invisible(self) -> None:
        self._session.judge(self.table.selected_fids(), "invisible")

    def _judge_none(self) -> None:
        self._session.judge(self.table.selected_fids(), "")

    def _remove(self) -> None:
        fids = self.table.selected_fids()
        if fids:
            self._session.remove(fids)

    def _show_menu(self, place: QPoint) -> None:
        if self.table.selected_fids():
            self._menu.popup(self.table.viewport().mapToGlobal(place))

    # Widgets

    def _set_up_filter(self) -> None:
        self._search.setShowSearchIcon(True)
        self._search.setShowClearButton(True)
        self._search.setPlaceholderText(tr("Filter windows"))
        self._search.setToolTip(tr("Shows the windows whose number, verdict, cause, observer or reason matches."))
        self._verdicts.addItem(tr("all"), None)
        for verdict in VERDICTS:
            self._verdicts.addItem(verdict_chip(verdict), verdict_word(verdict), partial(_has_verdict, verdict))
        for text, tip, accepts in (
            (tr("not judged"), tr("Windows without the observer's word."), _is_not_judged),
            (tr("changed"), tr("Windows to be inspected again."), attrgetter("stale")),
        ):
            self._verdicts.addItem(text, accepts)
            self._verdicts.setItemData(self._verdicts.count() - 1, tip, Qt.ItemDataRole.ToolTipRole)
        self._verdicts.setMaxVisibleItems(self._verdicts.count())
        self._verdicts.setToolTip(tr("Which windows are shown."))
        self._verdicts.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        self._count.setToolTip(tr("How many windows are shown."))

    def _lay_out(self) -> None:
        line = QHBoxLayout()
        line.addWidget(self._search, 1)
        line.addWidget(self._verdicts)
        line.addWidget(self._count)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(line)
        layout.addWidget(self.table, 1)
        self.setFocusProxy(self.table)

    def _make_menu(self) -> QMenu:
        """The menu of the selected rows. Its shortcuts are only told there: the table takes the keys itself."""
        menu = QMenu(self)
        menu.setToolTipsVisible(True)
        for entry in (
            (tr("Zoom to window"), "mActionZoomToSelected", self._zoom,
             tr("Shows the window with one image pixel on 2 x 2 pixels of the screen."), Qt.Key.Key_Return),
            (tr("Inspect again"), "mActionRefresh", self._inspect, tr("Measures the selected windows anew."), None),
            None,
            (tr("Judge visible"), "mActionShowAllLayers", self._judge_visible,
             tr("The loss of detail can be seen at 2x magnification."), None),
            (tr("Judge invisible"), "mActionHideAllLayers", self._judge_invisible,
             tr("The loss of detail can't be seen at 2x magnification."), None),
            (tr("Take judgement back"), "mActionUndo", self._judge_none,
             tr("The selected windows are not judged yet."), None),
            None,
            (tr("Remove"), "mActionDeleteSelected", self._remove,
             tr("Removes the selected windows; undo brings them back."), Qt.Key.Key_Delete),
        ):
            if entry is None:
                menu.addSeparator()
                continue
            text, icon, slot, tip, key = entry
            action = QAction(QgsApplication.getThemeIcon(f"/{icon}.svg"), text, menu)
            action.setToolTip(tip)
            if key is not None:
                action.setShortcut(QKeySequence(key))
                action.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
            action.triggered.connect(slot)
            menu.addAction(action)
        return menu


def _has_verdict(verdict: str, row: WindowRecord) -> bool:
    return row.verdict == verdict


def _is_not_judged(row: WindowRecord) -> bool:
    return not row.observer
