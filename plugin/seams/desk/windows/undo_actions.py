"""Undo and redo of the windows, beside QGIS's own for the active layer, which have the same keys."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsApplication, QgsMapLayer, QgsVectorLayer
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtGui import QKeySequence
from qgis.PyQt.QtWidgets import QAction, QMainWindow

from ....toolkit.translation import filled, tr
from ..keys import keys_for

if TYPE_CHECKING:
    from qgis.PyQt.QtGui import QUndoStack  # Qt 5 has it in QtWidgets, and QGIS brings it to neither place

    from ..session import Session


class UndoActions(QObject):
    """``undo`` and ``redo`` are for buttons."""

    def __init__(self, session: Session, window: QMainWindow, parent: QObject) -> None:
        super().__init__(parent)
        self._session = session
        self._stack: QUndoStack | None = None
        self._kept: int | None = None  # of the steps, those that are not undone; None: all may be
        self.undo = QAction(QgsApplication.getThemeIcon("/mActionUndo.svg"), tr("Undo"), self)
        self.redo = QAction(QgsApplication.getThemeIcon("/mActionRedo.svg"), tr("Redo"), self)
        self.undo.triggered.connect(self._undo)
        self.redo.triggered.connect(self._redo)
        self.actions = {"undo": self.undo, "redo": self.redo}
        """Actions by the names of their keys."""
        self._of_qgis = {name: window.findChild(QAction, f"mAction{name.title()}") for name in self.actions}
        session.windowsChanged.connect(self.refresh)
        session.inputsChanged.connect(self.refresh)
        self.refresh()

    def close(self) -> None:
        """Follow no steps any more."""
        self._follow(None)

    def keep_steps(self, are_kept: bool) -> None:
        """Let nobody undo what was done until now, whose traces who judges blind does not see; or let everybody."""
        if are_kept != (self._kept is not None):
            self._kept = (self._stack.index() if self._stack is not None else 0) if are_kept else None
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
        layer = self._layer()
        stack = layer.undoStack() if layer is not None else None
        self._follow(stack)
        undo_name, redo_name = (stack.undoText(), stack.redoText()) if stack is not None else ("", "")
        if self._kept is not None:
            self._kept = min(self._kept, stack.index() if stack is not None else 0)
        self.undo.setEnabled(stack is not None and stack.index() > (self._kept or 0))
        self.redo.setEnabled(stack is not None and stack.canRedo())
        self.undo.setToolTip(_tip(tr("Undoes the last change to the windows ({keys})."), "undo", undo_name))
        self.redo.setToolTip(_tip(tr("Redoes what was undone ({keys})."), "redo", redo_name))

    def _follow(self, stack: QUndoStack | None) -> None:
        """Windows are told of while a step is still being made, which can be undone only at its end."""
        if stack is self._stack:
            return
        if self._stack is not None and not sip.isdeleted(self._stack):
            self._stack.indexChanged.disconnect(self.refresh)
        self._stack = stack
        if stack is not None:
            stack.indexChanged.connect(self.refresh)

    def _layer(self) -> QgsVectorLayer | None:
        layer = self._session.window_layer()
        return layer if layer is not None and layer.isEditable() else None

    def is_active(self, layer: QgsMapLayer | None) -> bool:
        """Whether QGIS's active layer holds the windows, whose steps are ours and QGIS's alike."""
        return layer is not None and layer is self._layer()

    def _undo(self) -> None:
        if (layer := self._layer()) is not None and self.undo.isEnabled():
            layer.undoStack().undo()

    def _redo(self) -> None:
        if (layer := self._layer()) is not None:
            layer.undoStack().redo()


def _tip(text: str, name: str, step: str) -> str:
    shown = [QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText) for key in keys_for(name)]
    tip = filled(text, keys=", ".join(shown))
    return f"{tip}\n\n" + (step or tr("There is no such change."))
