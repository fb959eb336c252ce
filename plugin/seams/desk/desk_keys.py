"""What listens to the keys of the desk.

QGIS has shortcuts of its own on some of these keys, and Qt does nothing where two compete for one. So keys are taken
where they arrive, at the widget that has the focus, before anybody makes a shortcut of them.
"""
from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from qgis.gui import QgsLayerTreeView, QgsMapCanvas, QgsMapTool
from qgis.PyQt.QtCore import QEvent, QObject, Qt
from qgis.PyQt.QtWidgets import QApplication, QDockWidget, QToolBar, QWidget

from ...toolkit.desk.keyboard import FocusFilter, is_keyboard_free
from .keys import KEYS
from .windows.undo_actions import UndoActions

_EVENTS = (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress, QEvent.Type.KeyRelease)
_OURS = (QgsMapCanvas, QgsLayerTreeView, QToolBar)  # beside the desk and the main window itself
_MODIFIERS = {"Ctrl": Qt.KeyboardModifier.ControlModifier, "Shift": Qt.KeyboardModifier.ShiftModifier}


class DeskKeys(QObject):
    """Listens while the desk is in sight. All keys stay with a text field that has the focus, with menus and dialogs.

    Those that judge stay with other docks too, whose lists find a row by its letter, with other windows than QGIS's
    main one and the desk's, and with a tool of QGIS that is editing on the map. Those of undo are for windows in the
    desk and on the map while windows are drawn; elsewhere they are QGIS's own as long as the active layer has something
    to undo.
    """

    def __init__(
        self, desk: QWidget, main_window: QWidget, canvas: QgsMapCanvas, tool: QgsMapTool | None = None,
        steps: UndoActions | None = None,
    ) -> None:
        """``tool`` draws windows."""
        super().__init__(desk)
        self._desk, self._main_window, self._canvas, self._tool, self._steps = desk, main_window, canvas, tool, steps
        self._meant = {_pressed(key): (name, key) for line in KEYS for name, keys in line.keys.items() for key in keys}
        self._repeating = {name for line in KEYS if line.is_repeating for name in line.keys}
        self._of_map = {name for line in KEYS if line.is_map for name in line.keys}
        self._actions: Mapping[str, Callable[[], bool]] = {}
        self._released: Mapping[str, Callable[[], None]] = {}
        self._held: set[str] = set()
        self._keyboard = FocusFilter(self)
        desk.installEventFilter(self)

    def set_actions(
        self, actions: Mapping[str, Callable[[], bool]], released: Mapping[str, Callable[[], None]] | None = None
    ) -> None:
        """What single keys do, by their names; one that has nothing to do says so by False, and the key is somebody
        else's then. ``released``: what letting go of one does."""
        self._actions, self._released = actions, released or {}

    def listen(self, listening: bool) -> None:
        """While the desk is in sight."""
        self._keyboard.listen(listening)

    def close(self) -> None:
        """Listen no more."""
        self._desk.removeEventFilter(self)
        self.listen(False)

    def eventFilter(self, receiver: QObject | None, event: QEvent | None) -> bool:
        """Whether an event is one of the keys; what it stands for is done then."""
        if event is None:
            return False
        if receiver is self._desk and event.type() in (QEvent.Type.Show, QEvent.Type.Hide):
            self.listen(event.type() == QEvent.Type.Show)
        if event.type() not in _EVENTS or not is_keyboard_free():
            return False
        name, key = self._meant.get((event.key(), event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier), ("", ""))
        if event.type() == QEvent.Type.KeyRelease:
            return self._let_go(name, event.isAutoRepeat())
        act = self._action(name, key) if name else None
        if act is None:
            return False
        if event.type() == QEvent.Type.ShortcutOverride:
            event.accept()  # so that it comes as a key press and not as somebody's shortcut
            return True
        if event.isAutoRepeat() and name not in self._repeating:
            return True
        is_done = act() is not False
        if is_done and name in self._released:
            self._held.add(name)
        return is_done

    def _let_go(self, name: str, is_repeated: bool) -> bool:
        """Whether it is of a key that was pressed here."""
        if name not in self._held:
            return False
        if not is_repeated:
            self._held.discard(name)
            self._released[name]()
        return True

    def _action(self, name: str, key: str) -> Callable[[], object] | None:
        """What a key does here; None where it is somebody else's."""
        focus = QApplication.focusWidget()
        window = focus.window() if focus is not None else QApplication.activeWindow()
        around = list(_around(focus))
        if self._steps is not None and name in self._steps.actions:
            if window is not self._main_window and not isinstance(window, QDockWidget):
                return None
            is_drawing = self._tool is not None and self._canvas.mapTool() is self._tool
            is_ours = self._desk in around or self._steps.is_active(self._canvas.currentLayer())
            action = self._steps.meant(name, key, is_ours or (is_drawing and self._canvas in around))
            return action.trigger if action is not None else None
        if window not in (self._main_window, self._desk.window()) or self._is_editing():
            return None
        is_free = focus in (None, self._main_window, self._desk, self._canvas) or (
            name not in self._of_map and any(widget is self._desk or isinstance(widget, _OURS) for widget in around)
        )
        return self._actions.get(name) if is_free else None

    def _is_editing(self) -> bool:
        """Whether a tool of QGIS is editing on the map: letters are its then."""
        tool = self._canvas.mapTool()
        return tool is not None and bool(tool.flags() & QgsMapTool.Flag.EditTool)


def _around(widget: QWidget | None) -> Iterator[QWidget]:
    """A widget and those that it is in."""
    while widget is not None:
        yield widget
        widget = widget.parentWidget()


def _pressed(key: str) -> tuple[int, Qt.KeyboardModifier]:
    """As a key event says it."""
    *modifiers, name = key.split("+")
    held = Qt.KeyboardModifier.NoModifier
    for modifier in modifiers:
        held |= _MODIFIERS[modifier]
    return getattr(Qt.Key, f"Key_{name}"), held
