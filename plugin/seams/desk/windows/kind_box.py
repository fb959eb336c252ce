"""The box beside the search: which kinds of windows are shown."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial
from operator import attrgetter

from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QComboBox, QSizePolicy, QWidget

from ....imagery.statistics import FIRST, UNSURE, VISIBLE
from ....toolkit.translation import tr
from ...measure.window_records import WindowRecord
from ...words import CLAIMS, VERDICTS, verdict_word
from .window_columns import verdict_chip

_LETTERS = 8  # of the box


def tool_and_observer_disagree(row: WindowRecord) -> bool:
    """Whether the tool flags what an observer does not see, or the other way round."""
    flagged = row.verdict == "significant"
    words = [word for word in (row.observer, row.observer_2) if word in ("visible", "invisible")]
    return row.verdict in CLAIMS and any((word == VISIBLE) != flagged for word in words)


def operators_disagree(row: WindowRecord) -> bool:
    """Whether both looked and did not say the same."""
    return bool(row.observer and row.observer_2) and row.observer != row.observer_2


class KindBox(QComboBox):
    """All windows, or those of one kind: its data is the test that they pass."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setToolTip(tr("Which windows are shown."))
        self.operator = FIRST  # whose verdicts are asked for
        self._is_blind = False
        self._lifted = ""  # the kind that is shown again when nothing is hidden
        self.addItem(tr("all"), None)
        for verdict in VERDICTS:
            self.addItem(verdict_chip(verdict), verdict_word(verdict), partial(_has_verdict, verdict))
        self._kinds = ["", *(verdict or "not_inspected" for verdict in VERDICTS)]
        for kind, text, test, tip in (
            ("not_judged", tr("not judged"), partial(self._is_said, ""), tr("Windows that no observer has judged.")),
            ("unsure", tr("not sure"), partial(self._is_said, UNSURE), tr("Windows where the observer was not sure.")),
            ("stale", tr("changed"), attrgetter("stale"), tr("Windows to be inspected again.")),
            ("tool_differs", tr("tool differs"), tool_and_observer_disagree,
             tr("Windows where the tool and an observer disagree.")),
            ("operators_differ", tr("operators differ"), operators_disagree,
             tr("Windows where the two operators disagree.")),
        ):
            self._kinds.append(kind)
            self.addItem(text, test)
            self.setItemData(self.count() - 1, tip, Qt.ItemDataRole.ToolTipRole)
        telling = {*VERDICTS, "tool_differs", "operators_differ"} - {""}
        self._telling = [place for place, kind in enumerate(self._kinds) if kind in telling]
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(_LETTERS)  # the longest of its words would leave little room for the search
        self.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        self.view().setMinimumWidth(self.view().sizeHintForColumn(0) + 2 * self.fontMetrics().height())
        self.setMaxVisibleItems(self.count())

    def kind(self) -> str:
        """The name of the kind that is shown, or will be once nothing is hidden; empty for all."""
        place = self.currentIndex()
        return self._kinds[place] if place > 0 else self._lifted

    def test(self) -> Callable[[WindowRecord], bool] | None:
        """What the windows shown pass; None for all."""
        test: Callable[[WindowRecord], bool] | None = self.currentData()
        return test

    def show_kind(self, kind: str) -> None:
        """A kind that tells what is hidden is lifted until that is seen again."""
        place = self._kinds.index(kind) if kind in self._kinds else 0
        is_lifted = self._is_blind and place in self._telling
        self._lifted = kind if is_lifted else ""
        self.setCurrentIndex(0 if is_lifted else place)

    def set_blind(self, is_blind: bool) -> None:
        """Whether what was found is hidden."""
        kind = self.kind()
        self._is_blind = is_blind
        for place in self._telling:
            self.model().item(place).setEnabled(not is_blind)
        self.show_kind(kind)

    def _is_said(self, word: str, row: WindowRecord) -> bool:
        """Whether a word was said of a window by the one whose verdicts are asked for."""
        return bool(getattr(row, self.operator.observer) == word)


def _has_verdict(verdict: str, row: WindowRecord) -> bool:
    return row.verdict == verdict
