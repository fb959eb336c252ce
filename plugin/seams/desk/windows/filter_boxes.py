"""The boxes beside the search: which kinds of windows are shown, and in which order."""
from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from operator import attrgetter
from typing import Any, NamedTuple

from qgis.PyQt.QtCore import QT_TR_NOOP, Qt
from qgis.PyQt.QtWidgets import QComboBox, QSizePolicy, QWidget

from ....imagery.statistics import FIRST, SECOND, UNSURE, VISIBLE
from ....toolkit.translation import tr
from ...measure.window_records import WindowRecord
from ...words import CLAIMS, VERDICTS, verdict_word
from .window_columns import verdict_chip

_WORST = (*CLAIMS, "not_comparable")
_LEAST_HALF_WIDTH = 0.001  # of an interval: layers may keep a few digits only


class WindowOrder(NamedTuple):
    """An order of windows. Title and tooltip are marked for translation, not translated."""

    name: str
    """Name as the project keeps it."""
    title: str
    tooltip: str
    key: Callable[..., Any] | None
    """What windows are sorted by, None where one has no place in the order; without a key as the table's columns are.
    """
    tells_verdict: bool = False
    """Whether the order gives away what the tool found, or what the other operator said."""
    takes_limit: bool = False
    """Whether the key is of a window and of the share of detail that has to be kept."""


def along_the_seam(row: WindowRecord) -> tuple[float, float, int]:
    """Sort key: seam and station where windows have them, else number, as they were placed."""
    seam = math.inf if row.seam_id is None else row.seam_id
    return seam, row.station or 0.0, row.window_id


def worst_first(row: WindowRecord) -> tuple[float, int] | None:
    """Sort key: how much detail is missing, along the seam or all over, then the verdict."""
    return None if row.verdict not in _WORST else (-(row.loss or 0.0), _WORST.index(row.verdict))


def least_sure_first(row: WindowRecord, min_kept: float) -> float | None:
    """Sort key: how many half widths of its 95 % interval what is kept along the seam lies from the limit."""
    if row.verdict not in CLAIMS or row.kept_1 is None or row.kept_low is None or row.kept_high is None:
        return None
    return abs(row.kept_1 - min_kept) / max((row.kept_high - row.kept_low) / 2, _LEAST_HALF_WIDTH)


def tool_and_observer_disagree(row: WindowRecord) -> bool:
    """Whether the tool flags what an observer does not see, or the other way round."""
    flagged = row.verdict == "significant"
    words = [word for word in (row.observer, row.observer_2) if word in ("visible", "invisible")]
    return row.verdict in CLAIMS and any((word == VISIBLE) != flagged for word in words)


def operators_disagree(row: WindowRecord) -> bool:
    """Whether both looked and did not say the same."""
    words = [getattr(row, one.observer) for one in (FIRST, SECOND)]
    return all(words) and words[0] != words[1]


TABLE = WindowOrder(
    "table", QT_TR_NOOP("as sorted"),
    QT_TR_NOOP("As the table is sorted by one of its columns."), None,
)  # fmt: skip
ORDERS = (
    WindowOrder(
        "seam", QT_TR_NOOP("along the seam"),
        QT_TR_NOOP("Seam by seam, in the order in which the windows were placed."), along_the_seam,
    ),
    WindowOrder(
        "worst", QT_TR_NOOP("worst first"),
        QT_TR_NOOP("The greatest loss first, along the seam or all over the window."),
        worst_first, tells_verdict=True,
    ),
    WindowOrder(
        "sure", QT_TR_NOOP("least sure first"),
        QT_TR_NOOP("Starts where the limit lies deep within the interval of what is kept: there an eye tells most."),
        least_sure_first, tells_verdict=True, takes_limit=True,
    ),
    WindowOrder(
        "tool", QT_TR_NOOP("tool differs"),
        QT_TR_NOOP("Starts with the windows where the tool and an observer disagree."),
        lambda row: along_the_seam(row) if tool_and_observer_disagree(row) else None, tells_verdict=True,
    ),
    WindowOrder(
        "operators", QT_TR_NOOP("operators differ"),
        QT_TR_NOOP("Starts with the windows where the two operators disagree."),
        lambda row: along_the_seam(row) if operators_disagree(row) else None, tells_verdict=True,
    ),
    TABLE,
)  # fmt: skip


def order_named(name: str) -> WindowOrder:
    """The order of that name; as the table is sorted where there is none."""
    return next((order for order in ORDERS if order.name == name), TABLE)


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
            self._offer(text, test, tip)
        telling = {*VERDICTS, "tool_differs", "operators_differ"} - {""}
        self._telling = [place for place, kind in enumerate(self._kinds) if kind in telling]
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

    def _is_said(self, word: str, row: WindowRecord) -> bool:
        """Whether a word was said of a window by the one whose verdicts are asked for."""
        return bool(getattr(row, self.operator.observer) == word)


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
        """Show an order as one that was chosen."""
        self.setCurrentIndex(self.findData(order.name))

    def set_blind(self, is_blind: bool) -> None:
        """Whether what was found is hidden."""
        self._allow_telling(not is_blind)


def _has_verdict(verdict: str, row: WindowRecord) -> bool:
    return row.verdict == verdict
