"""What listens to the keys of the desk, and undo and redo, which QGIS has the same keys for.

QGIS has shortcuts of its own on some of these keys, and Qt does nothing where two compete for one. So keys are taken
where they arrive, at the widget that has the focus, before anybody makes a shortcut of them.
"""
from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from qgis.core import QgsApplication
from qgis.gui import QgsMapCanvas, QgsMapTool
from qgis.PyQt.QtCore import QEvent, QObject, Qt
from qgis.PyQt.QtGui import QKeySequence
from qgis.PyQt.QtWidgets import QAbstractItemView, QAction, QApplication, QDockWidget, QMainWindow, QWidget

from ...imagery.statistics import INVISIBLE, UNSURE, VISIBLE
from ...toolkit.desk.keyboard import FocusFilter, HeldKeys, is_keyboard_free
from ...toolkit.translation import tr
from .windows.windows_table import WindowsTable

_SURE = {f"sure {10 * digit or 100}": (str(digit),) for digit in range(10)}
MAP, MAP_AND_TABLE, DESK = "map", "map, table", "map, desk"
JUDGING = "while judging: map, desk"
"""The place of the focus for keys to work: the words of the guide, by which ``DeskKeys`` goes."""


class KeyLine(NamedTuple):
    """A line of the guide's table, and the keys that are named in it."""

    shown: str
    where: str
    does: str
    keys: Mapping[str, tuple[str, ...]] = {}
    """Keys by what they do, as ``DeskKeys`` and actions call it; empty where a widget of Qt's or QGIS's has them."""
    is_repeating: bool = False  # whether they go on while they are held


KEYS = (
    KeyLine("V, I, U", JUDGING, "judges: visible, invisible, not sure; then the next window",
            {VISIBLE: ("V",), INVISIBLE: ("I",), UNSURE: ("U",)}),
    KeyLine("N, P", JUDGING, "the next window to judge, the one before", {"next": ("N",), "before": ("P",)}, True),
    KeyLine("Backspace", JUDGING, "takes a judgement back", {"take back": ("Backspace",)}),
    KeyLine("1 to 9, 0", JUDGING, "how sure you are, 10 to 100 %", _SURE),
    KeyLine("R", JUDGING, "a remark", {"remark": ("R",)}),
    KeyLine("S", JUDGING, "takes seamlines and a scan's layers off the map, and puts them back",
            {"seamlines": ("S",)}),
    KeyLine("L", JUDGING, "shows or hides where detail was lost", {"lost detail": ("L",)}),
    KeyLine("J", DESK, "judging: QGIS's panels and what lies over the mosaic go; again: all as before",
            {"layout": ("J",)}),
    KeyLine("Space", MAP_AND_TABLE, "held: the hard cut in place of the mosaic; tapped: until the next tap",
            {"flicker": ("Space",)}),
    KeyLine("Tab", MAP, "the next of the window's places that lost most", {"next place": ("Tab",)}, True),
    KeyLine("Ctrl+Z; Ctrl+Shift+Z, Ctrl+Y", "everywhere", "undo; redo",
            {"undo": ("Ctrl+Z",), "redo": ("Ctrl+Shift+Z", "Ctrl+Y")}, True),
    KeyLine("Shift, Ctrl", "map, while drawing", "one more window selected; a new window here, whatever is there"),
    KeyLine("Esc, right click", "map, while drawing", "drops the rectangle; ends drawing"),
    KeyLine("Enter, double click", "table", "the window at 2x"),
    KeyLine("Del", "table", "removes the selected windows"),
)  # fmt: skip


_EVENTS = (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress, QEvent.Type.KeyRelease)
_PLACES = {MAP: ("map",), MAP_AND_TABLE: ("map", "table")}  # of the focus; other keys work in the rest of the desk too
_MODIFIERS = {"Ctrl": Qt.KeyboardModifier.ControlModifier, "Shift": Qt.KeyboardModifier.ShiftModifier}


class UndoActions:
    """Undo and redo of the windows, for buttons and keys."""

    def __init__(self, stack: Any, window: QMainWindow, parent: QObject) -> None:
        """``stack``: a QUndoStack, whose actions say what they undo."""
        self.undo = stack.createUndoAction(parent, tr("Undo"))
        self.redo = stack.createRedoAction(parent, tr("Redo"))
        self.actions = {"undo": self.undo, "redo": self.redo}  # actions by the names of their keys
        self._of_qgis = {name: window.findChild(QAction, f"mAction{name.title()}") for name in self.actions}
        for name, action in self.actions.items():
            action.setIcon(QgsApplication.getThemeIcon(f"/mAction{name.title()}.svg"))

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


class DeskKeys(QObject):
    """Listens while the desk is open. Keys stay with what takes them itself: text fields, menus, dialogs, a tool of
    QGIS that is editing on the map.

    Single keys work while the map or the desk has the focus, those of judging only while windows are judged. Then all
    stay with the desk: QGIS would remove a window by Backspace, and Tab would lead to its toolbars. Those of undo are
    for windows in the desk and on the map while windows are drawn; elsewhere they are QGIS's own as long as the active
    layer has something to undo.
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
        self._where = {name: line.where for line in KEYS for name in line.keys}
        self._actions: Mapping[str, Callable[[], object]] = {}
        self._released: Mapping[str, Callable[[float], None]] = {}
        self._is_judging: Callable[[], bool] = bool
        self._keyboard = FocusFilter(self)
        self._held = HeldKeys(self)
        self._held.released.connect(self._let_go)
        desk.installEventFilter(self)

    def set_actions(
        self, actions: Mapping[str, Callable[[], object]], released: Mapping[str, Callable[[float], None]],
        is_judging: Callable[[], bool],
    ) -> None:
        """What single keys do, by their names; one that has nothing to do says so by False, and the key is somebody
        else's then, unless windows are judged. ``released``: what letting go of one does, with the seconds that it was
        held; ``is_judging``: whether windows are judged.
        """
        self._actions, self._released, self._is_judging = actions, released, is_judging

    def listen(self, listening: bool) -> None:
        """While the desk is open."""
        self._keyboard.listen(listening)
        if not listening:
            self._held.close()

    def close(self) -> None:
        """Listen no more."""
        self._desk.removeEventFilter(self)
        self.listen(False)

    def eventFilter(self, receiver: QObject | None, event: QEvent | None) -> bool:
        """Whether an event is one of the keys; what it stands for is done then."""
        if event is None:
            return False
        if receiver is self._desk and event.type() in (QEvent.Type.Show, QEvent.Type.Hide):
            self.listen(not self._desk.isHidden())  # also behind another dock
        if event.type() not in _EVENTS:
            return False
        if event.type() == QEvent.Type.KeyRelease:
            return self._held.release(event)
        if not is_keyboard_free():
            return False
        name, key = self._meant.get((event.key(), event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier), ("", ""))
        act = self._action(name, key) if name else None
        if act is None:
            return False
        if event.type() == QEvent.Type.ShortcutOverride:
            event.accept()  # so that it comes as a key press and not as somebody's shortcut
            return True
        if not self._held.press(event) and name not in self._repeating:
            return True
        is_taken = act() is not False or self._is_judging()
        if not is_taken:
            self._held.forget(event.key())
        return is_taken

    def _let_go(self, key: int, seconds: float) -> None:
        name, _ = self._meant.get((key, Qt.KeyboardModifier.NoModifier), ("", ""))
        if name in self._released:
            self._released[name](seconds)

    def _action(self, name: str, key: str) -> Callable[[], object] | None:
        """What a key does here; None where it is somebody else's."""
        focus = QApplication.focusWidget()
        window = focus.window() if focus is not None else QApplication.activeWindow()
        if self._steps is not None and name in self._steps.actions:
            if window is not self._main_window and not isinstance(window, QDockWidget):
                return None
            is_drawing = self._tool is not None and self._canvas.mapTool() is self._tool
            is_ours = _holds(self._desk, focus) or (is_drawing and _holds(self._canvas, focus))
            action = self._steps.meant(name, key, is_ours)
            return action.trigger if action is not None else None
        where = self._where[name]
        is_here = self._place(focus, window) in _PLACES.get(where, ("map", "table", "desk"))
        if not is_here or self._is_editing() or (where == JUDGING and not self._is_judging()):
            return None
        return self._actions.get(name)

    def _place(self, focus: QWidget | None, window: QWidget | None) -> str:
        """The place that has the focus; empty where keys are somebody else's. Without one in a window of ours they are
        the map's.
        """
        if focus is None:
            return "map" if window in (self._main_window, self._desk.window()) else ""
        if focus is self._main_window or _holds(self._canvas, focus):
            return "map"
        if not _holds(self._desk, focus):
            return ""
        if isinstance(focus, WindowsTable):
            return "table"
        return "" if isinstance(focus, QAbstractItemView) else "desk"  # whose rows are looked for by their letters

    def _is_editing(self) -> bool:
        """Whether a tool of QGIS is editing on the map: letters are its then."""
        tool = self._canvas.mapTool()
        return tool is not None and bool(tool.flags() & QgsMapTool.Flag.EditTool)


def _holds(widget: QWidget, focus: QWidget | None) -> bool:
    """Whether the focus is in a widget, and not in a dialog of it."""
    return focus is not None and (focus is widget or widget.isAncestorOf(focus))


def _pressed(key: str) -> tuple[int, Qt.KeyboardModifier]:
    """Key and modifiers as a key event says them."""
    *modifiers, name = key.split("+")
    held = Qt.KeyboardModifier.NoModifier
    for modifier in modifiers:
        held |= _MODIFIERS[modifier]
    return getattr(Qt.Key, f"Key_{name}"), held
