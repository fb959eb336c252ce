"""Undo and redo of the windows, beside QGIS's own for the active layer, which have the same keys."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtGui import QKeySequence
from qgis.PyQt.QtWidgets import QAction, QMainWindow

from ....toolkit.translation import filled, tr
from ..keys import keys_for

if TYPE_CHECKING:
    from ..session import Session


class UndoActions(QObject):
    """``undo`` and ``redo`` are for buttons."""

    def __init__(self, session: Session, window: QMainWindow, parent: QObject) -> None:
        super().__init__(parent)
        self._stack = session.steps
        self._kept: int | None = None  # of the steps, those that are not undone; None: all may be
        self.undo = QAction(QgsApplication.getThemeIcon("/mActionUndo.svg"), tr("Undo"), self)
        self.redo = QAction(QgsApplication.getThemeIcon("/mActionRedo.svg"), tr("Redo"), self)
        self.undo.triggered.connect(self._undo)
        self.redo.triggered.connect(self._stack.redo)
        self.actions = {"undo": self.undo, "redo": self.redo}  # actions by the names of their keys
        self._of_qgis = {name: window.findChild(QAction, f"mAction{name.title()}") for name in self.actions}
        self._stack.indexChanged.connect(self.refresh)
        self.refresh()

    def close(self) -> None:
        """Follow no steps any more."""
        self._stack.indexChanged.disconnect(self.refresh)

    def keep_steps(self, are_kept: bool) -> None:
        """Let nobody undo what was done until now, whose traces who judges blind does not see; or let everybody."""
        if are_kept != (self._kept is not None):
            self._kept = self._stack.index() if are_kept else None
            self.refresh()

    def meant(self, name: str, key: str, is_ours: bool) -> QAction | None:
        """The action that a key is for; None where QGIS takes it itself, or there is nothing to do.

        ``is_ours``: windows are meant whatever layer is active; else what the active layer has to undo comes first.
        """
        action, of_qgis = self.actions[name], self._of_qgis[name]
        if is_ours:
            return action
        if of_qgis is not None and of_qgis.isEnabled():
            return None if QKeySequence(key) in of_qgis.shortcuts() else of_qgis
        return action if action.isEnabled() else None

    def refresh(self, *_: object) -> None:
        """What can be undone and done again, and by which name."""
        stack = self._stack
        if self._kept is not None:
            self._kept = min(self._kept, stack.index())
        self.undo.setEnabled(stack.index() > (self._kept or 0))
        self.redo.setEnabled(stack.canRedo())
        self.undo.setText(filled(tr("Undo {step}"), step=stack.undoText()) if self.undo.isEnabled() else tr("Undo"))
        self.redo.setText(filled(tr("Redo {step}"), step=stack.redoText()) if self.redo.isEnabled() else tr("Redo"))
        self.undo.setToolTip(_tip(self.undo, "undo"))
        self.redo.setToolTip(_tip(self.redo, "redo"))

    def _undo(self) -> None:
        if self.undo.isEnabled():  # keys trigger it all the same
            self._stack.undo()


def _tip(action: QAction, name: str) -> str:
    shown = [QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText) for key in keys_for(name)]
    return f"{action.text()} ({', '.join(shown)})"
