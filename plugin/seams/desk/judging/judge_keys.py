"""Single keys that judge and step while the focus is in the desk, on the map, in the layer tree or a toolbar."""
from __future__ import annotations

from collections.abc import Callable, Mapping

from qgis.gui import QgsLayerTreeView, QgsMapCanvas
from qgis.PyQt.QtCore import QEvent, QObject, Qt
from qgis.PyQt.QtWidgets import QApplication, QToolBar, QWidget

from ....toolkit.desk.keyboard import FocusFilter, is_keyboard_free

_KEYS = (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress)
_OURS = (QgsMapCanvas, QgsLayerTreeView, QToolBar)  # beside the desk and the main window itself
_PLAIN = (Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.KeypadModifier)


class JudgeKeys(QObject):
    """Takes its keys before anybody else does, so that no shortcut of QGIS on the same key is ambiguous with them.

    It listens while the desk is in sight. Keys stay with a text field that has the focus, with menus and dialogs, with
    other docks, whose lists find a row by its letter, with other windows than QGIS's main one and the desk's, and with
    a tool of QGIS that is editing on the map.
    """

    def __init__(self, desk: QWidget, main_window: QWidget, is_editing: Callable[[], bool]) -> None:
        super().__init__(desk)
        self._desk = desk
        self._main_window = main_window
        self._is_editing = is_editing
        self._actions: Mapping[int, Callable[[], bool]] = {}
        self._repeating: frozenset[int] = frozenset()
        self._keyboard = FocusFilter(self)

    def set_keys(self, actions: Mapping[int, Callable[[], bool]], repeating: frozenset[int]) -> None:
        """What each key does; an action that has nothing to do says so by False, and the key is somebody else's then.

        ``repeating``: keys that go on while they are held.
        """
        self._actions, self._repeating = actions, repeating

    def listen(self, listening: bool) -> None:
        """While the desk is in sight."""
        self._keyboard.listen(listening)

    def close(self) -> None:
        """Listen no more."""
        self.listen(False)

    def eventFilter(self, _receiver: QObject | None, event: QEvent | None) -> bool:
        if event is None or event.type() not in _KEYS:
            return False
        key = event.key()
        if key not in self._actions or event.modifiers() not in _PLAIN or not self._is_free():
            return False
        if event.type() == QEvent.Type.ShortcutOverride:
            event.accept()  # so that it comes as a key press and not as somebody's shortcut
            return True
        if event.isAutoRepeat() and key not in self._repeating:
            return True
        return self._actions[key]()

    def _is_free(self) -> bool:
        focus = QApplication.focusWidget()
        window = focus.window() if focus is not None else QApplication.activeWindow()
        is_ours = window in (self._main_window, self._desk.window()) and self._is_ours(focus)
        return is_ours and is_keyboard_free() and not self._is_editing()

    def _is_ours(self, focus: QWidget | None) -> bool:
        """Whether nobody else's widget has the focus."""
        if focus is None or focus is self._main_window:
            return True
        widget: QWidget | None = focus
        while widget is not None and widget is not self._desk and not isinstance(widget, _OURS):
            widget = widget.parentWidget()
        return widget is not None
