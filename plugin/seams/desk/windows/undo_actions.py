"""Undo and redo of the windows, and their keys wherever the focus is.

QGIS's own actions have the same keys, and Qt does nothing where two actions compete for one. So QGIS's own do it where
they reach: while the active layer has something to undo. Ours have the keys in the dock, on the map while windows are
drawn, and in the main window while QGIS's are disabled.
"""
from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import TYPE_CHECKING

from qgis.core import QgsApplication, QgsVectorLayer
from qgis.gui import QgsMapCanvas, QgsMapTool
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QEvent, QObject, Qt
from qgis.PyQt.QtGui import QKeyEvent, QKeySequence
from qgis.PyQt.QtWidgets import QAction, QMainWindow, QWidget

from ....toolkit.translation import filled, tr

if TYPE_CHECKING:
    from qgis.PyQt.QtGui import QUndoStack  # Qt 5 has it in QtWidgets, and QGIS brings it to neither place

    from ..session import Session

_CONTROL, _SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
_UNDO_KEYS = {"Ctrl+Z": (Qt.Key.Key_Z, _CONTROL)}
_REDO_KEYS = {"Ctrl+Shift+Z": (Qt.Key.Key_Z, _CONTROL | _SHIFT), "Ctrl+Y": (Qt.Key.Key_Y, _CONTROL)}


class UndoActions(QObject):
    """``undo`` and ``redo`` are for buttons."""

    def __init__(self, session: Session, window: QMainWindow, parent: QObject) -> None:
        super().__init__(parent)
        self._session = session
        self._window = window
        self._is_in_sight = False
        self._stack: QUndoStack | None = None
        self._filtered: set[QWidget] = set()
        self.undo = self._button("Undo", tr("Undo"), self._undo)
        self.redo = self._button("Redo", tr("Redo"), self._redo)
        self._keys = [
            _Key(key, action, window, window.findChild(QAction, name))
            for action, name, keys in (
                (self.undo, "mActionUndo", _UNDO_KEYS), (self.redo, "mActionRedo", _REDO_KEYS)
            )
            for key in keys
        ]  # fmt: skip
        session.windowsChanged.connect(self.refresh)
        session.inputsChanged.connect(self.refresh)
        self.refresh()

    def close(self) -> None:
        """Take the keys off all widgets."""
        self.set_in_sight(False)
        self._follow(None)
        for widget in list(self._filtered):
            self._leave_keys_in(widget)
        for key in self._keys:
            key.close()

    def take_keys_in(self, widget: QWidget) -> None:
        """In a widget and all within it the keys are for windows, whatever layer is active; text fields have theirs."""
        self._filtered.add(widget)
        widget.installEventFilter(self)

    def take_keys_while(self, tool: QgsMapTool, canvas: QgsMapCanvas) -> None:
        """On the map they are as long as a tool is in use."""
        tool.activated.connect(partial(self.take_keys_in, canvas))
        tool.deactivated.connect(partial(self._leave_keys_in, canvas))

    def _leave_keys_in(self, widget: QWidget) -> None:
        self._filtered.discard(widget)
        widget.removeEventFilter(self)

    def set_in_sight(self, is_in_sight: bool) -> None:
        """The main window's keys are ours only while the operator sees what they do."""
        self._is_in_sight = is_in_sight
        self.refresh()

    def refresh(self, *_: object) -> None:
        """What can be undone and done again, and by which name."""
        layer = self._layer()
        stack = layer.undoStack() if layer is not None else None
        self._follow(stack)
        undo_name, redo_name = (stack.undoText(), stack.redoText()) if stack is not None else ("", "")
        self.undo.setEnabled(stack is not None and stack.canUndo())
        self.redo.setEnabled(stack is not None and stack.canRedo())
        self.undo.setToolTip(_tip(tr("Takes the last change of the windows back ({keys})."), _UNDO_KEYS, undo_name))
        self.redo.setToolTip(_tip(tr("Does again what was taken back ({keys})."), _REDO_KEYS, redo_name))
        for key in self._keys:
            key.set_in_sight(self._is_in_sight)

    def eventFilter(self, _receiver: QObject, event: QEvent) -> bool:
        """Whether an event is one of the keys; what it stands for is done then."""
        if event.type() not in (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress):
            return False
        action = self._action_of(event)
        if action is None:
            return False
        event.accept()  # a key whose override is accepted comes as a key press and as nobody's shortcut
        if event.type() == QEvent.Type.KeyPress:
            action.trigger()
        return True

    def _follow(self, stack: QUndoStack | None) -> None:
        """Windows are told of while a step is still being made, which can be undone only at its end."""
        if stack is self._stack:
            return
        if self._stack is not None and not sip.isdeleted(self._stack):
            self._stack.indexChanged.disconnect(self.refresh)
        self._stack = stack
        if stack is not None:
            stack.indexChanged.connect(self.refresh)

    def _action_of(self, event: QKeyEvent) -> QAction | None:
        pressed = event.key(), event.modifiers()
        for action, keys in ((self.undo, _UNDO_KEYS), (self.redo, _REDO_KEYS)):
            if pressed in keys.values():
                return action
        return None

    def _layer(self) -> QgsVectorLayer | None:
        layer = self._session.window_layer()
        return layer if layer is not None and layer.isEditable() else None

    def _undo(self) -> None:
        if (layer := self._layer()) is not None:
            layer.undoStack().undo()

    def _redo(self) -> None:
        if (layer := self._layer()) is not None:
            layer.undoStack().redo()

    def _button(self, icon: str, text: str, slot: Callable[..., None]) -> QAction:
        action = QAction(QgsApplication.getThemeIcon(f"/mAction{icon}.svg"), text, self)
        action.triggered.connect(slot)
        return action


class _Key:
    """A key in the main window, while QGIS's own action is disabled or has another one."""

    def __init__(self, key: str, action: QAction, window: QMainWindow, own: QAction | None) -> None:
        self._window, self._own, self._action = window, own, action
        self._is_in_sight = False
        self._shortcut = QAction(action.text(), window)
        self._shortcut.setShortcut(QKeySequence(key))
        self._shortcut.triggered.connect(self._trigger)
        window.addAction(self._shortcut)
        if own is not None:
            own.changed.connect(self._refresh)

    def set_in_sight(self, is_in_sight: bool) -> None:
        self._is_in_sight = is_in_sight
        self._refresh()

    def close(self) -> None:
        if self._own is not None:
            self._own.changed.disconnect(self._refresh)
        self._window.removeAction(self._shortcut)
        self._shortcut.deleteLater()

    def _refresh(self) -> None:
        is_enabled = self._action.isEnabled()
        if self._own is not None and self._own.isEnabled():
            is_enabled = self._shortcut.shortcut() not in self._own.shortcuts()
        self._shortcut.setEnabled(self._is_in_sight and is_enabled)

    def _trigger(self) -> None:
        """What the active layer has to undo comes first, as with QGIS's own key."""
        (self._own if self._own is not None and self._own.isEnabled() else self._action).trigger()


def _tip(text: str, keys: Iterable[str], step: str) -> str:
    shown = [QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText) for key in keys]
    tip = filled(text, keys=", ".join(shown))
    return f"{tip}\n\n" + (step or tr("There is no such change."))
