"""The windows as a sortable, filterable table whose selection is the window layer's."""
from __future__ import annotations

import csv
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qgis.core import QgsApplication
from qgis.gui import QgsFilterLineEdit
from qgis.PyQt.QtCore import QItemSelectionModel, QLocale, QModelIndex, QPoint, Qt, pyqtSignal
from qgis.PyQt.QtGui import QKeySequence
from qgis.PyQt.QtWidgets import (
    QAbstractItemView,
    QAction,
    QApplication,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QMenu,
    QVBoxLayout,
    QWidget,
)

from ....imagery.atomic_files import replacing
from ....imagery.errors import SettingsError, cell_text
from ....imagery.messages import system_reason
from ....imagery.statistics import INVISIBLE, UNSURE, VISIBLE, Operator
from ....toolkit.desk.message_bar import bar_level
from ....toolkit.desk.widgets import check_chosen_file, is_confirmed, single_shot
from ....toolkit.translation import filled, sentence, tr
from ...measure import messages
from .filter_boxes import TABLE, KindBox, OrderBox, WindowOrder
from .window_columns import TableColumn
from .windows_filter import window_filter
from .windows_model import WindowsModel
from .windows_table import WindowsTable

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord
    from ..session import Session

_WIDE_LETTERS = 60  # the count of windows has room beside the search
_TYPED_MS = 500  # without a letter: what is searched for stands
_SELECT_ROWS = QItemSelectionModel.SelectionFlag.ClearAndSelect | QItemSelectionModel.SelectionFlag.Rows


class WindowsPanel(QWidget):
    """The table of windows with its filter."""

    zoomRequested = pyqtSignal(int)
    """Feature id of the window to be looked at."""
    orderChanged = pyqtSignal()
    """Other windows are shown, or in another order."""
    judged = pyqtSignal(str)
    """The operator's word on the selected windows; empty takes it back."""
    orderChosen = pyqtSignal(str)
    """Name of the order in which the operator wants the windows."""
    filterChosen = pyqtSignal()
    told = pyqtSignal(str, int)
    """A sentence for the message bar, and its level."""

    def __init__(
        self, session: Session, parent: QWidget | None = None, confirm: Callable[[QWidget, str], bool] = is_confirmed
    ) -> None:
        """``confirm`` asks the operator before judged windows are removed."""
        super().__init__(parent)
        self._session = session
        self._confirm = confirm
        self._is_following = False
        self._own: frozenset[str] | None = None  # the fields that are seen while others are hidden
        self._windows = WindowsModel(self, session.result)
        self._search = QgsFilterLineEdit(self)  # before the table, for Tab
        self._verdicts = KindBox(self)
        self._orders = OrderBox(self)
        self._problem = QLabel(self)
        self._problem.setTextFormat(Qt.TextFormat.PlainText)
        self._filter_time = single_shot(self, self.filterChosen, _TYPED_MS)
        self._count = QLabel(self)
        self.table = WindowsTable(self._windows, self)
        self.table.setToolTip(
            tr("A click goes to a window on the map; Del removes the selected ones, Ctrl+C copies them. A right click "
               "on the headings chooses columns, a drag moves them.")
        )
        self.table.setAccessibleName(tr("Windows"))
        self._search.setShowSearchIcon(True)
        self._search.setShowClearButton(True)
        self._search.setPlaceholderText(tr("Filter windows"))
        self._search.setToolTip(tr("Shows the windows whose number, verdict, cause, observer or reason matches."))
        self._count.setToolTip(tr("How many windows are shown."))
        self._menu = self._rows_menu()
        self._lay_out()

        self._search.textChanged.connect(self._filter)
        self._verdicts.currentIndexChanged.connect(self._filter)
        self._orders.activated.connect(self._choose_order)
        self.table.horizontalHeader().sectionClicked.connect(lambda *_: self.orderChosen.emit(TABLE.name))
        self.table.copyRequested.connect(self.copy)
        self.table.selectionModel().selectionChanged.connect(self._lead)
        self.table.doubleClicked.connect(self._zoom_to)
        self.table.zoomRequested.connect(self._zoom)
        self.table.removeRequested.connect(self._remove)
        self.table.customContextMenuRequested.connect(self._show_menu)
        self._windows.layoutChanged.connect(self._tell_order)
        session.windowsChanged.connect(self._take_windows)
        session.selectionChanged.connect(self._take_selection)
        self._take_windows()

    def sort_by_number(self) -> None:
        """Sort by number, as it was before the operator sorted otherwise."""
        self.table.sortByColumn(0, Qt.SortOrder.AscendingOrder)

    def show_order(self, order: WindowOrder) -> None:
        """Show the windows in an order that is no column's, or go on in a column's."""
        self._orders.show_order(order)
        if (key := order.key) is not None:
            if order.takes_limit:
                key = partial(self._by_limit, key)
            with self._following():
                self._windows.sort_by(key)
            self.table.show_sorting()
        elif self._windows.sorted_by is None:
            self.table.sortByColumn(0, Qt.SortOrder.AscendingOrder)

    def _by_limit(self, key: Callable[[WindowRecord, float], Any], row: WindowRecord) -> Any:
        """With the limit as it is then."""
        return key(row, self._session.inputs.min_kept)

    def set_blind(self, own: frozenset[str] | None) -> None:
        """Show these columns and no others, and offer nothing that tells what was found; None: show all."""
        self.table.set_blind(own)
        self._own = own
        for box in (self._verdicts, self._orders):
            box.set_blind(own is not None)
        self._filter()

    def filter(self) -> tuple[str, str]:
        """What is searched for, and the name of the kind of windows that is shown."""
        return self._search.text(), self._verdicts.kind()

    def set_filter(self, search: str, kind: str) -> None:
        """Filter as it was before."""
        if (search, kind) != self.filter():
            self._search.setText(search)
            self._verdicts.show_kind(kind)

    @property
    def operator(self) -> Operator:
        """Whose verdicts the filter asks for."""
        return self._verdicts.operator

    @operator.setter
    def operator(self, operator: Operator) -> None:
        self._verdicts.operator = operator

    def copy(self, *_: object) -> None:
        """The selected rows to the clipboard."""
        rows = [row for row in map(self._session.row, self.table.selected_fids()) if row is not None]
        if rows:
            QApplication.clipboard().setText(copied_rows(self.table.visible_columns(), rows))

    def save_csv(self, path: Path) -> None:
        """The windows that are shown, with all of their numbers; raises OSError."""
        rows = [row for row in map(self._session.row, self._windows.fids()) if row is not None]
        write_csv(path, self._windows.columns if not self._windows.is_blind else self.table.visible_columns(), rows)

    def ordered_fids(self) -> list[int]:
        """The windows shown, from top to bottom: the same list while they are the same; not to be changed."""
        return self._windows.fids()

    # Following the session

    def _take_windows(self) -> None:
        with self._following():
            self._windows.set_windows(self._session.windows())

    def _filter(self, *_: object) -> None:
        with self._following():
            problem, found = "", None
            try:
                found = window_filter(self._search.text(), self._windows.levels, self._own, self._session.windows())
            except SettingsError as error:  # which leaves no window out
                problem = sentence(error.message)
            self._windows.set_filter(test for test in (found, self._verdicts.test()) if test is not None)
        self._problem.setText(problem)
        self._problem.setVisible(bool(problem))
        self._filter_time.start()

    @contextmanager
    def _following(self) -> Iterator[None]:
        """While rows come and go the table's selection changes by itself; the session's is what counts."""
        top = self.table.rowAt(0)
        is_scrolled = self.table.verticalScrollBar().value() > 0 and top >= 0
        anchor = self._windows.windows()[top].window_id if is_scrolled else None
        selected = self._selected_numbers()
        with self._unmoved():
            yield
        top = -1 if anchor is None else self._windows.row_numbered(anchor)
        if top >= 0 and top != self.table.rowAt(0):
            self.table.scrollTo(self._windows.index(top, 0), QAbstractItemView.ScrollHint.PositionAtTop)
        self._show_selection(selected)
        self._describe()
        self.orderChanged.emit()

    def _take_selection(self) -> None:
        self._show_selection(self._selected_numbers())

    def _selected_numbers(self) -> set[int]:
        return {self._windows.windows()[row].window_id for row in self.table.selected_rows()}

    def _show_selection(self, before: set[int]) -> None:
        """Select what the session has selected, and bring it into sight where it was not selected ``before``."""
        rows = sorted(row for row in map(self._windows.row_of, self._session.selected()) if row >= 0)
        selection = self.table.selectionModel()
        with self._unmoved():
            if rows != self.table.selected_rows():
                selection.select(self.table.rows_selection(rows), _SELECT_ROWS)
            if rows and selection.currentIndex().row() not in rows:
                selection.setCurrentIndex(self._windows.index(rows[0], 0), QItemSelectionModel.SelectionFlag.NoUpdate)
        fresh = [row for row in rows if self._windows.windows()[row].window_id not in before]
        if fresh and not any(map(self.table.is_in_sight, rows)):
            self.table.scrollTo(self._windows.index(fresh[0], 0), QAbstractItemView.ScrollHint.PositionAtCenter)

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
        """The operator selected rows; the map goes to a single one."""
        if not self._is_following:
            fids = self.table.selected_fids()
            if set(fids) != set(self._session.selected()):
                self._session.select(fids)
                if len(fids) == 1:
                    self.zoomRequested.emit(fids[0])

    def _tell_order(self, *_: object) -> None:
        if not self._is_following:
            self.orderChanged.emit()

    def _describe(self) -> None:
        """How many windows are left by the filter, and what an empty table says."""
        shown, count = self._windows.rowCount(), self._windows.count
        has_room = self.width() > _WIDE_LETTERS * self.fontMetrics().averageCharWidth()  # the judge bar says it, too
        self._count.setVisible(self._windows.is_filtered and count > 0 and has_room)
        self._count.setText(filled(tr("{shown} of {count}"), shown=shown, count=count))
        hint = tr("Draw a window on the map, or place windows along the seamlines.")
        if count:
            hint = tr("No window matches the filter.")
        if hint != self.table.hint:
            self.table.hint = hint
            self.table.viewport().update()

    # What the operator asks for

    def _zoom_to(self, index: QModelIndex) -> None:
        self.zoomRequested.emit(self._windows.fids()[index.row()])

    def _zoom(self, *_: object) -> None:
        current = self.table.currentIndex()
        if current.isValid():
            self._zoom_to(current)

    def _inspect(self, *_: object) -> None:
        self._session.inspect(self.table.selected_fids())

    def _judge(self, word: str, *_: object) -> None:
        if set(self.table.selected_fids()) != set(self._session.selected()):  # the filter hides some
            self._session.select(self.table.selected_fids())
        self.judged.emit(word)

    def _choose_order(self, place: int) -> None:
        self.orderChosen.emit(self._orders.itemData(place))

    def _ask_for_csv(self, *_: object) -> None:
        path, _ = QFileDialog.getSaveFileName(self, tr("Save the windows"), "windows.csv", tr("CSV files (*.csv)"))
        if not path:
            return
        try:
            check_chosen_file(Path(path))
            self.save_csv(Path(path))
        except SettingsError as error:
            self.told.emit(sentence(error.message), bar_level(error.message))
        except OSError as error:
            problem = messages.TABLE_NOT_SAVED(path=path, error=system_reason(error))
            self.told.emit(sentence(problem), bar_level(problem))

    def _remove(self, *_: object) -> None:
        fids = self.table.selected_fids()
        rows = [row for row in map(self._session.row, fids) if row is not None]
        judged = sum(bool(row.observer or row.observer_2) for row in rows)
        question = filled(tr("Remove {count} windows, {judged} of them judged?"), count=len(fids), judged=judged)
        if fids and (judged < 2 or self._confirm(self, question)):
            self._session.remove(fids)

    def _show_menu(self, place: QPoint) -> None:
        if self.table.selected_fids():
            self._menu.popup(self.table.viewport().mapToGlobal(place))

    # Widgets

    def _rows_menu(self) -> QMenu:
        """The menu of the selected rows. Its shortcuts are only told there: the table takes the keys itself."""
        menu = QMenu(self)
        menu.setToolTipsVisible(True)
        for entry in (
            (tr("Zoom to window"), "mActionZoomToSelected", self._zoom,
             tr("Shows the window with one image pixel on 2 x 2 pixels of the screen."), Qt.Key.Key_Return),
            (tr("Inspect again"), "mActionRefresh", self._inspect, tr("Measures the selected windows anew."), None),
            None,
            (tr("Judge visible"), "mActionShowAllLayers", partial(self._judge, VISIBLE),
             tr("The loss of detail can be seen at 2x magnification."), None),
            (tr("Judge invisible"), "mActionHideAllLayers", partial(self._judge, INVISIBLE),
             tr("The loss of detail can't be seen at 2x magnification."), None),
            (tr("Judge not sure"), "mActionHelpContents", partial(self._judge, UNSURE),
             tr("You can't tell. The window counts as not judged in all results."), None),
            (tr("Take judgement back"), "mActionUndo", partial(self._judge, ""),
             tr("Marks the selected windows as not judged."), None),
            None,
            (tr("Copy rows"), "mActionEditCopy", self.copy,
             tr("The selected rows with their headings, for a spreadsheet."), QKeySequence.StandardKey.Copy),
            (tr("Save as CSV ..."), "mActionFileSaveAs", self._ask_for_csv,
             tr("All windows that are shown, with all of their numbers."), None),
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

    def _lay_out(self) -> None:
        line = QHBoxLayout()
        line.addWidget(self._search, 1)
        line.addWidget(self._verdicts)
        line.addWidget(self._orders)
        line.addWidget(self._count)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self._problem.setWordWrap(True)
        self._problem.setVisible(False)
        layout.addLayout(line)
        layout.addWidget(self._problem)
        layout.addWidget(self.table, 1)
        self.setFocusProxy(self.table)


def copied_rows(columns: Sequence[TableColumn], rows: Iterable[WindowRecord]) -> str:
    """Rows as they are read in the table, tab separated, headings first."""
    lines = [[column.title() for column in columns], *([column.text(row) for column in columns] for row in rows)]
    return "\n".join("\t".join(cell_text(" ".join(cell.split())) for cell in line) for line in lines)


def write_csv(path: Path, columns: Sequence[TableColumn], rows: Iterable[WindowRecord]) -> None:
    """All digits of the numbers, as the operator's spreadsheet reads them; fields for headings.

    Where the decimal point is a comma, columns are separated by semicolons. Raises OSError.
    """
    comma = QLocale().decimalPoint() == ","
    encoding = "utf-8-sig"  # by its mark a spreadsheet knows it
    with replacing(path) as unfinished, unfinished.open("w", encoding=encoding, newline="") as file:
        writer = csv.writer(file, delimiter=";" if comma else ",")
        writer.writerow(column.field for column in columns)
        for row in rows:
            writer.writerow(_cell(column, row, comma) for column in columns)


def _cell(column: TableColumn, row: WindowRecord, comma: bool) -> str:
    value = getattr(row, column.field, None)
    if value is None or isinstance(value, (tuple, str)):
        value = column.key(row) if not isinstance(value, str) else value
        if not isinstance(value, (int, float, str)):
            return ""
    if isinstance(value, str):
        return cell_text(value)
    return str(value).replace(".", ",") if comma and isinstance(value, float) else str(value)
