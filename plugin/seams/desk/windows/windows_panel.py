"""The windows as a sortable table whose selection is the window layer's, filtered by kind and words."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import partial
from operator import attrgetter
from typing import TYPE_CHECKING

from qgis.gui import QgsFilterLineEdit
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtWidgets import QAbstractItemView, QComboBox, QHBoxLayout, QSizePolicy, QVBoxLayout, QWidget

from ....imagery.statistics import FIRST, UNSURE, Operator
from ....toolkit.desk.widgets import is_confirmed
from ....toolkit.translation import filled, tr
from ...measure.window_records import WindowRecord
from ...words import VERDICTS, cause_word, observer_word, verdict_word
from .window_columns import WINDOW_ID, verdict_chip
from .windows_table import WindowsModel, WindowsTable

if TYPE_CHECKING:
    from ..session import Session


Test = Callable[[WindowRecord], bool]


def window_filter(text: str, allowed: frozenset[str] | None) -> Test | None:
    """Whether a window matches all words of a text; None where the text asks for nothing.

    ``allowed``: the only fields that a text is about, while others are hidden.
    """
    words = text.casefold().split()
    return (lambda row: all(_matches(row, word, allowed) for word in words)) if words else None


def _matches(row: WindowRecord, word: str, allowed: frozenset[str] | None) -> bool:
    """Whether a word begins the number, a word of verdict, cause or observer ("visible" is not "invisible") or the
    origin (``scan``), or is anywhere in the reason, which names files. A number is a window's."""
    if word.isdigit():
        return str(row.window_id).startswith(word)
    if allowed is not None:
        said = row.observer if FIRST.observer in allowed else row.observer_2
        return any(part.startswith(word) for part in observer_word(said).casefold().split())
    words = verdict_word(row.verdict), cause_word(row.cause), observer_word(row.observer), row.read("origin")
    said = " ".join(map(str, filter(None, words)))
    return any(part.startswith(word) for part in said.casefold().split()) or word in row.reason.casefold()


_LETTERS = 8  # of the box


class KindBox(QComboBox):
    """All windows, or those of one kind, beside the search: its data is the test that they pass."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setToolTip(tr("Which windows are shown."))
        self.operator = FIRST  # whose verdicts are asked for
        self.addItem(tr("all"), None)
        for verdict in VERDICTS:
            test = lambda row, verdict=verdict: row.verdict == verdict  # noqa: E731
            self.addItem(verdict_chip(verdict), verdict_word(verdict), test)
        self._add(tr("not judged"), partial(self._is_said, ""), tr("Windows that no observer has judged."))
        self._add(tr("not sure"), partial(self._is_said, UNSURE), tr("Windows where the observer was not sure."))
        self._add(tr("changed"), attrgetter("stale"), tr("Windows to be inspected again."))
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(_LETTERS)  # the longest of its words would leave little room for the search
        self.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        self.view().setMinimumWidth(self.view().sizeHintForColumn(0) + 2 * self.fontMetrics().height())
        self.setMaxVisibleItems(self.count())

    def test(self) -> Test | None:
        """What the windows shown pass; None for all."""
        test: Test | None = self.currentData()
        return test

    def set_blind(self, is_blind: bool) -> None:
        """Whether what was found is hidden, and with it the kinds that tell it."""
        telling = range(1, len(VERDICTS))
        for place in telling:
            self.model().item(place).setEnabled(not is_blind)
        if is_blind and self.currentIndex() in telling:
            self.setCurrentIndex(0)

    def _add(self, text: str, test: Test, tip: str) -> None:
        self.addItem(text, test)
        self.setItemData(self.count() - 1, tip, Qt.ItemDataRole.ToolTipRole)

    def _is_said(self, word: str, row: WindowRecord) -> bool:
        """Whether a word was said of a window by the one whose verdicts are asked for."""
        return bool(getattr(row, self.operator.observer) == word)


class WindowsPanel(QWidget):
    """The table of windows with its filter."""

    zoomRequested = pyqtSignal(int)  # feature id of the window to be looked at
    orderChanged = pyqtSignal()  # other windows are shown, or in another order

    def __init__(self, session: Session, confirm: Callable[[QWidget, str], bool] = is_confirmed) -> None:
        """``confirm`` asks the operator before judged windows are removed."""
        super().__init__()
        self._session = session
        self._confirm = confirm
        self._is_following = False
        self._allowed: frozenset[str] | None = None  # the fields that are seen while others are hidden
        self._windows = WindowsModel(self, session.result)
        self._search = QgsFilterLineEdit(self)  # before the table, for Tab
        self._verdicts = KindBox(self)
        self.table = WindowsTable(self._windows, self)
        self.table.setToolTip(
            tr("A click goes to a window on the map, Enter once more; Del removes the selected ones.")
        )
        self.table.setAccessibleName(tr("Windows"))
        self._search.setShowSearchIcon(True)
        self._search.setShowClearButton(True)
        self._search.setPlaceholderText(tr("Filter windows"))
        self._search.setToolTip(
            tr("Shows the windows whose number, verdict, cause, observer, origin (scan) or reason matches.")
        )
        self._lay_out()

        self._search.textChanged.connect(self._filter)
        self._verdicts.currentIndexChanged.connect(self._filter)
        self.table.selectionModel().selectionChanged.connect(self._lead)
        self.table.doubleClicked.connect(self._zoom)
        self.table.zoomRequested.connect(self._zoom)
        self.table.removeRequested.connect(self._remove)
        self._windows.modelReset.connect(self._take_order)
        session.windowsChanged.connect(self._take_windows)
        session.selectionChanged.connect(self._take_selection)
        self._take_windows()

    def show_for(self, operator: Operator, is_blind: bool) -> None:
        """Filter by this operator's verdicts; while he is blind, show and offer nothing that tells what was found."""
        self._verdicts.operator = operator
        self._allowed = allowed = frozenset((WINDOW_ID.name, *operator)) if is_blind else None
        self.table.set_blind(allowed)
        if allowed is not None and self._windows.sorted_by.name not in allowed:
            self.table.sortByColumn(0, Qt.SortOrder.AscendingOrder)  # another order would tell
        self._verdicts.set_blind(is_blind)
        self._filter()

    def ordered_fids(self) -> list[int]:
        """The windows shown, from top to bottom: the same list while they are the same; not to be changed."""
        return self._windows.fids()

    def uncover(self, fids: Iterable[int]) -> None:
        """Show all windows where the filter hides one of these."""
        if not set(fids) <= set(self.ordered_fids()):
            self._search.clear()
            self._verdicts.setCurrentIndex(0)

    def show_selected(self, *_: object) -> None:
        """Bring the selected windows into sight."""
        self._show_selection(set())

    # Following the session

    def _take_windows(self) -> None:
        with self._following():
            self._windows.set_windows(self._session.windows())

    def _filter(self, *_: object) -> None:
        with self._following():
            tests = window_filter(self._search.text(), self._allowed), self._verdicts.test()
            self._windows.set_filter(test for test in tests if test is not None)

    @contextmanager
    def _following(self) -> Iterator[None]:
        """While rows come and go the table's selection changes by itself; the session's is what counts, and what was
        in sight of it stays so, where its row goes elsewhere with a verdict."""
        is_seen = any(map(self.table.is_in_sight, self.table.selected_rows()))
        top = self.table.rowAt(0)
        is_scrolled = self.table.verticalScrollBar().value() > 0 and top >= 0
        anchor = self._windows.windows()[top].window_id if is_scrolled else None
        selected = self._selected_numbers()
        with self._unmoved():
            yield
        rows = [] if anchor is None else [row.window_id for row in self._windows.windows()]
        if anchor in rows and rows.index(anchor) != self.table.rowAt(0):
            self.table.scrollTo(
                self._windows.index(rows.index(anchor), 0), QAbstractItemView.ScrollHint.PositionAtTop
            )
        self._show_selection(set() if is_seen else selected)
        self.orderChanged.emit()

    def _take_selection(self) -> None:
        self._show_selection(self._selected_numbers())

    def _selected_numbers(self) -> set[int]:
        return {self._windows.windows()[row].window_id for row in self.table.selected_rows()}

    def _show_selection(self, before: set[int]) -> None:
        """Select what the session has selected, and bring it into sight where it was not selected ``before``."""
        rows = sorted(row for row in map(self._windows.row_of, self._session.selected()) if row >= 0)
        with self._unmoved():
            self.table.select_rows(rows)
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

    def _take_order(self) -> None:
        """The operator sorted the windows."""
        if not self._is_following:
            self._show_selection(set())
            self.orderChanged.emit()

    # What the operator asks for

    def _zoom(self, *_: object) -> None:
        current = self.table.currentIndex()
        if current.isValid():
            self.zoomRequested.emit(self._windows.fids()[current.row()])

    def _remove(self, *_: object) -> None:
        fids = self.table.selected_fids()
        rows = [row for row in map(self._session.row, fids) if row is not None]
        judged = sum(bool(row.observer or row.observer_2) for row in rows)
        question = filled(tr("Remove {count} windows, {judged} of them judged?"), count=len(fids), judged=judged)
        if fids and (judged < 2 or self._confirm(self, question)):
            self._session.remove(fids)

    # Widgets

    def _lay_out(self) -> None:
        line = QHBoxLayout()
        line.addWidget(self._search, 1)
        line.addWidget(self._verdicts)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(line)
        layout.addWidget(self.table, 1)
        self.setFocusProxy(self.table)
