"""Who judges, whether blind, and how well both agree: a button with a menu."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial

from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtWidgets import QAction, QActionGroup, QMenu, QToolButton, QWidget

from ....toolkit.desk.widgets import rich_tip
from ....toolkit.translation import filled, tr
from .judging import Judging


class OperatorButton(QToolButton):
    """Says who judges."""

    agreementAsked = pyqtSignal()

    def __init__(self, judging: Judging, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._judging = judging
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setAutoRaise(True)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        menu = QMenu(self)
        menu.setToolTipsVisible(True)
        group = QActionGroup(menu)
        self.operators = tuple(
            self._checkable(menu, text, tip, partial(self._choose, number))
            for number, text, tip in (
                (1, tr("First operator"), tr("What is said goes to the field 'observer'.")),
                (2, tr("Second operator"), tr("What is said goes to the field 'observer_2', beside the first one's.")),
            )
        )
        for action in self.operators:
            group.addAction(action)
        menu.addSeparator()
        self.blind = self._checkable(
            menu, tr("Blind"),
            tr("Hides what the tool found, and what the other operator said: in the table, in words, charts and on the "
               "map."),
            self._set_blind,
        )  # fmt: skip
        self.agreement = QAction(tr("Agreement of both ..."), menu)
        self.agreement.setToolTip(tr("How often both operators say the same, and how much of that is not chance."))
        self.agreement.triggered.connect(self.agreementAsked)
        menu.addAction(self.agreement)
        self.setMenu(menu)
        judging.changed.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Show who judges, and how."""
        settings = self._judging.settings
        number = 2 if settings.operator == 2 else 1
        self.operators[number - 1].setChecked(True)
        self.blind.setChecked(settings.is_blind)
        self.agreement.setEnabled(not settings.is_blind)
        words = tr("2nd") if number == 2 else tr("1st")
        self.setText(filled(tr("{operator}, blind"), operator=words) if settings.is_blind else words)
        tip = tr("Who judges: the first or the second operator; blind or not; how well both agree.")
        self.setToolTip(rich_tip(tip))

    def _choose(self, number: int, _checked: bool = True) -> None:
        self._judging.change(operator=number)

    def _set_blind(self, blind: bool) -> None:
        self._judging.change(is_blind=blind)

    @staticmethod
    def _checkable(menu: QMenu, text: str, tip: str, slot: Callable[..., None]) -> QAction:
        action = QAction(text, menu)
        action.setCheckable(True)
        action.setToolTip(tip)
        action.triggered.connect(slot)
        menu.addAction(action)
        return action
