"""The boxes beside the search: which kinds of windows are shown, and in which order."""
from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from operator import attrgetter
from typing import TYPE_CHECKING, Callable

from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QComboBox, QSizePolicy, QWidget

from ....imagery.statistics import FIRST, UNSURE
from ....toolkit.translation import tr
from ...verdict_words import VERDICTS, verdict_word
from ..judging.window_orders import ORDERS, TABLE, WindowOrder, operators_disagree, tool_and_observer_disagree
from .verdict_chips import verdict_chip

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord

_LETTERS = 8  # of a box


class _Box(QComboBox):
    """Some of its entries tell what was found."""

    def __init__(self, tip: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.setToolTip(tip)
        self._telling: list[int] = []

    def _offer(self, text: str, data: object, tip: str) -> None:
        self.addItem(text, data)
        self.setItemData(self.count() - 1, tip, Qt.ItemDataRole.ToolTipRole)

    def _fit(self) -> None:
        """The longest of its words would leave little room for the search."""
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(_LETTERS)
        self.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        self.view().setMinimumWidth(self.view().sizeHintForColumn(0) + 2 * self.fontMetrics().height())

    def _allow_telling(self, allowed: bool) -> None:
        for place in self._telling:
            self.model().item(place).setEnabled(allowed)


class KindBox(_Box):
    """All windows, or those of one kind: its data is the test that they pass."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(tr("Which windows are shown."), parent)
        self.operator = FIRST
        """Whose verdicts are asked for."""
        self._is_blind = False
        self._lifted = ""  # the kind that is shown again when nothing is hidden
        self.addItem(tr("all"), None)
        for verdict in VERDICTS:
            self.addItem(verdict_chip(verdict), verdict_word(verdict), partial(_has_verdict, verdict))
        self._offer(tr("not judged"), self._is_not_judged, tr("Windows without the observer's word."))
        self._offer(tr("not sure"), self._is_unsure, tr("Windows where the observer was not sure."))
        self._offer(tr("changed"), attrgetter("stale"), tr("Windows to be inspected again."))
        self._offer(
            tr("tool differs"), tool_and_observer_disagree,
            tr("Windows where the tool's verdict and an observer's word disagree."),
        )  # fmt: skip
        self._offer(tr("operators differ"), operators_disagree, tr("Windows where the two operators disagree."))
        self._kinds = ["", *(verdict or "not_inspected" for verdict in VERDICTS)]
        self._kinds += ["not_judged", "unsure", "stale", "tool_differs", "operators_differ"]
        self._telling = self._places([*VERDICTS, "tool_differs", "operators_differ"])
        self._fit()
        self.setMaxVisibleItems(self.count())

    def kind(self) -> str:
        """The name of the kind that is shown, or will be once nothing is hidden; empty for all."""
        place = self.currentIndex()
        return self._kinds[place] if place > 0 else self._lifted

    def test(self) -> Callable[[WindowRecord], bool] | None:
        """What the windows shown pass; None for all."""
        found: Callable[[WindowRecord], bool] | None = self.currentData()
        return found

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
        self._allow_telling(not is_blind)
        self.show_kind(kind)

    def _places(self, kinds: Iterable[str]) -> list[int]:
        return [place for place, kind in enumerate(self._kinds) if kind and kind in kinds]

    def _is_not_judged(self, row: WindowRecord) -> bool:
        return not getattr(row, self.operator.observer)

    def _is_unsure(self, row: WindowRecord) -> bool:
        return bool(getattr(row, self.operator.observer) == UNSURE)


class OrderBox(_Box):
    """The order of a column, or one that is no column's: its data is the order's name."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(tr("In which order windows are shown and judged."), parent)
        for order in ORDERS:
            self._offer(tr(order.title), order.name, tr(order.tooltip))
        self._telling = [place for place, order in enumerate(ORDERS) if order.tells_verdict]
        self.show_order(TABLE)
        self._fit()

    def show_order(self, order: WindowOrder) -> None:
        """As one that was chosen."""
        self.setCurrentIndex(self.findData(order.name))

    def set_blind(self, is_blind: bool) -> None:
        """Whether what was found is hidden."""
        self._allow_telling(not is_blind)


def _has_verdict(verdict: str, row: WindowRecord) -> bool:
    return row.verdict == verdict
