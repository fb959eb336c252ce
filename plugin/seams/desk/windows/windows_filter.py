"""Which windows the table shows."""
from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QModelIndex, QObject, QSortFilterProxyModel, Qt

from ....imagery.errors import Message, SettingsError
from ....imagery.statistics import DECIDED, FIRST, UNSURE
from ...words import cause_word, observer_word, verdict_word
from .number_filter import hidden_message, is_expression, window_test
from .windows_model import WindowsModel

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord


class WindowsFilter(QSortFilterProxyModel):
    """The windows that the operator wants to see. Sorting is the model's own: it is faster there."""

    def __init__(self, model: WindowsModel, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._model = model
        self._words: list[str] = []
        self._test: Callable[[WindowRecord], bool] | None = None  # of an expression
        self._passes: dict[int, tuple[WindowRecord, bool]] = {}  # by feature id
        self._accepts: Callable[[WindowRecord], bool] | None = None
        self._own: frozenset[str] | None = None  # the fields that are not hidden; None: all
        self._told: dict[tuple[str, str, str], list[str]] = {}
        self._fids: list[int] | None = None
        self._shown: list[WindowRecord] = []
        self._rows: dict[int, int] = {}
        self._numbers: dict[int, int] = {}  # the row of each
        for signal in (model.rowsInserted, model.rowsRemoved, model.layoutChanged, model.modelReset):
            signal.connect(self._forget)
        model.dataChanged.connect(self._follow_changes)
        self.setSourceModel(model)

    @property
    def is_on(self) -> bool:
        """Whether some windows may be left out."""
        return bool(self._words) or self._test is not None or self._accepts is not None

    def fids(self) -> list[int]:
        """The windows shown, from top to bottom; not to be changed, and the same list while they are the same.

        Row by row through Qt takes ten times as long.
        """
        if self._fids is None:
            rows = self._model.windows()
            self._shown = [row for row in rows if self._shows(row)] if self.is_on else list(rows)
            self._fids = [row.fid for row in self._shown]
            self._rows = {fid: row for row, fid in enumerate(self._fids)}
            self._numbers = {one.window_id: row for row, one in enumerate(self._shown)}
        return self._fids

    def number_at(self, row: int) -> int:
        """The number of a window shown, which stays the same when saving gives it another feature id."""
        self.fids()
        return self._shown[row].window_id

    def row_numbered(self, number: int) -> int:
        """The row that the window with a number is shown in; -1 when it is not."""
        self.fids()
        return self._numbers.get(number, -1)

    def row_of(self, fid: int) -> int:
        """The row a window is shown in; -1 when it is not."""
        self.fids()
        return self._rows.get(fid, -1)

    def set_filter(
        self, text: str, accepts: Callable[[WindowRecord], bool] | None, own: frozenset[str] | None = None
    ) -> Message | None:
        """Show the windows that match an expression, or all words of a text, and only those a test accepts.

        ``own``: the only fields that a text may ask for, while others are hidden; one that asks for more is lifted.
        Returns what is wrong with an expression, which leaves no window out then.
        """
        problem, rows = None, self._model.windows()
        if own != self._own:
            self._own, self._words, self._test = own, [], None
        try:
            if is_expression(text):
                test = window_test(text, max((len(row.ratios) for row in rows), default=3), own)
                if rows:
                    test(rows[0])  # what is wrong with its values shows only there
                self._words, self._test = [], test
            else:
                self._words, self._test = self._allowed_words(text), None
        except SettingsError as error:
            problem, self._words, self._test = error.message, [], None
        self._accepts = accepts
        self._passes = {}
        self._forget()
        self.invalidateFilter()
        return problem

    def sort(self, column: int, order: Qt.SortOrder = Qt.SortOrder.AscendingOrder) -> None:
        self._model.sort(column, order)

    def filterAcceptsRow(self, place: int, parent: QModelIndex) -> bool:
        return not self.is_on or self._shows(self._model.windows()[place])

    def _shows(self, row: WindowRecord) -> bool:
        if self._accepts is not None and not self._accepts(row):
            return False
        if self._test is not None:
            return self._passes_test(row)
        return all(self._matches(row, word) for word in self._words)

    def _passes_test(self, row: WindowRecord) -> bool:
        """Kept, as Qt asks for every row again whenever one changes."""
        assert self._test is not None
        known = self._passes.get(row.fid)
        if known is None or known[0] is not row:
            try:
                known = row, self._test(row)
            except SettingsError:  # it can't be said of this window
                known = row, False
            self._passes[row.fid] = known
        return known[1]

    def _allowed_words(self, text: str) -> list[str]:
        """Raises SettingsError for one that can be found only in what is hidden."""
        words = text.casefold().split()
        if self._own is not None:
            spoken = " ".join(map(observer_word, (*DECIDED, UNSURE))).casefold().split()
            for word in words:
                if not word.isdigit() and not any(one.startswith(word) for one in spoken):
                    raise SettingsError(hidden_message(word, self._own))
        return words

    def _matches(self, row: WindowRecord, word: str) -> bool:
        """Whether a word begins the number, a word of verdict, cause or observer ("visible" is not "invisible"), or is
        anywhere in the reason, which names files. A number is a window's."""
        if word.isdigit():
            return str(row.window_id).startswith(word)
        if self._own is not None:
            said = row.observer if FIRST.observer in self._own else row.observer_2
            return any(told.startswith(word) for told in observer_word(said).casefold().split())
        key = row.verdict, row.cause, row.observer
        if key not in self._told:
            words = verdict_word(row.verdict), cause_word(row.cause), observer_word(row.observer)
            self._told[key] = " ".join(words).casefold().split()
        return any(told.startswith(word) for told in self._told[key]) or word in row.reason.casefold()

    def _follow_changes(self, first: QModelIndex, last: QModelIndex) -> None:
        """What is shown stays as it is where a change lets no window come or go, as most judgements."""
        if self._fids is None:
            return
        for one in self._model.windows()[first.row() : last.row() + 1]:
            row = self._rows.get(one.fid, -1)
            was_shown = row >= 0
            if was_shown != self._shows(one) or (was_shown and self._shown[row].window_id != one.window_id):
                self._forget()
                return
            if was_shown:
                self._shown[row] = one

    def _forget(self, *_: object) -> None:
        self._fids = None
