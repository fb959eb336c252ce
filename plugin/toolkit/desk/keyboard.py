"""Single keys that mean something in the desk: whether the keyboard is free for them, which are held, and Space held
over a view."""
from __future__ import annotations

import time
from functools import partial

from qgis.PyQt import sip
from qgis.PyQt.QtCore import QEvent, QObject, Qt, QTimer, pyqtSignal
from qgis.PyQt.QtGui import QKeyEvent
from qgis.PyQt.QtWidgets import QAbstractSpinBox, QApplication, QComboBox, QLineEdit, QPlainTextEdit, QTextEdit, QWidget

from .widgets import single_shot

_TYPED_IN = (QLineEdit, QTextEdit, QPlainTextEdit, QAbstractSpinBox, QComboBox)


def is_keyboard_free() -> bool:
    """Whether nobody is typing, which finds a line of a choice too, and no menu or dialog waits for an answer."""
    if QApplication.activeModalWidget() is not None or QApplication.activePopupWidget() is not None:
        return False
    focus = QApplication.focusWidget()
    return focus is None or not (isinstance(focus, _TYPED_IN) or focus.inherits("QsciScintilla"))


class FocusFilter:
    """Keeps an event filter on the widget that has the focus and on the active window, which has the keys else."""

    def __init__(self, listener: QObject) -> None:
        self._listener = listener
        self._watched: list[QWidget] = []
        self._is_on = False

    def listen(self, is_on: bool) -> None:
        """From now on, or no more."""
        if is_on == self._is_on:
            return
        self._is_on = is_on
        if is_on:
            QApplication.instance().focusChanged.connect(self._follow)
        else:
            QApplication.instance().focusChanged.disconnect(self._follow)
        self._follow()

    def _follow(self, *_: object) -> None:
        for widget in self._watched:
            if not sip.isdeleted(widget):
                widget.removeEventFilter(self._listener)
        wanted = (QApplication.focusWidget(), QApplication.activeWindow()) if self._is_on else ()
        self._watched = [widget for widget in dict.fromkeys(wanted) if widget is not None]
        for widget in self._watched:
            widget.installEventFilter(self._listener)


_REPEATED_MS = 50  # longer than a key that repeats is up, shorter than one that is tapped twice


class HeldKeys(QObject):
    """Which keys are down. X repeats a held key by releasing and pressing it within 3 ms, and Qt does not always say
    so: a release that a press follows within 50 ms is none.
    """

    released = pyqtSignal(int, float)
    """A key, and for how many seconds it was held."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._pressed: dict[int, float] = {}  # when each that is down was pressed
        self._up: dict[int, tuple[float, QTimer]] = {}  # when each was released that may be down again at once

    def press(self, event: QKeyEvent) -> bool:
        """Whether the key went down now, and is not repeated."""
        key = event.key()
        if key in self._up and time.monotonic() - self._up[key][0] > _REPEATED_MS / 1000:
            self._let_go(key)  # the timer waits behind what keeps the interface busy
        is_repeated = event.isAutoRepeat() or key in self._up
        self._stop(key)
        if not is_repeated:
            if not self._pressed:
                QApplication.instance().applicationStateChanged.connect(self._leave)
            self._pressed[key] = time.monotonic()
        return not is_repeated

    def release(self, event: QKeyEvent) -> bool:
        """Whether it is a key that was pressed here."""
        key = event.key()
        if key in self._pressed and not event.isAutoRepeat():
            self._stop(key)
            timer = single_shot(self, partial(self._let_go, key), _REPEATED_MS)
            timer.setTimerType(Qt.TimerType.PreciseTimer)
            self._up[key] = time.monotonic(), timer
            timer.start()
        return key in self._pressed

    def forget(self, key: int) -> None:
        """The key is somebody else's, or of no more interest."""
        self._stop(key)
        if self._pressed.pop(key, None) is not None and not self._pressed:
            QApplication.instance().applicationStateChanged.disconnect(self._leave)

    def close(self) -> None:
        """No key is down any more, and nobody is told so."""
        for key in list(self._pressed):
            self.forget(key)

    def _stop(self, key: int) -> None:
        if key in self._up:
            _, timer = self._up.pop(key)
            timer.stop()
            timer.deleteLater()

    def _let_go(self, key: int) -> None:
        until = self._up[key][0] if key in self._up else time.monotonic()
        seconds = until - self._pressed[key]
        self.forget(key)
        self.released.emit(key, seconds)

    def _leave(self, state: Qt.ApplicationState) -> None:
        if state != Qt.ApplicationState.ApplicationActive:  # the keys' release goes to somebody else
            for key in list(self._pressed):
                self._let_go(key)


_KEYS = (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress, QEvent.Type.KeyRelease)


class SpaceKey(QObject):
    """Which view Space is held over.

    Taking the focus instead would keep the arrow keys from the table of windows while the mouse rests on a view.
    The keyboard is listened to only while the mouse is over a view, a view has the focus by Tab, or
    Space is still held.
    """

    changed = pyqtSignal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._hovered: QWidget | None = None
        self._focused: QWidget | None = None
        self._is_held = False
        self._is_watching = False
        self._keyboard = FocusFilter(self)
        self._keys = HeldKeys(self)
        self._keys.released.connect(lambda *_: self._hold(False))

    @property
    def view(self) -> QWidget | None:
        """The view under the mouse, else the one with the focus, while Space is held."""
        return (self._hovered or self._focused) if self._is_held else None

    def set_hovered(self, view: QWidget, is_hovered: bool) -> None:
        """The mouse came to a view or left it; coming to the next one may be told first."""
        if is_hovered or self._hovered is view:
            self._hovered = view if is_hovered else None
            self._update()

    def set_focused(self, view: QWidget, is_focused: bool) -> None:
        """The keyboard's focus came to a view or left it."""
        if is_focused or self._focused is view:
            self._focused = view if is_focused else None
            self._update()

    def release(self) -> None:
        """Forget the key and the views: they go out of sight."""
        self._hovered = self._focused = None
        self._is_held = False
        self._keys.close()
        self._update()

    def _update(self) -> None:
        watching = self._is_held or self._hovered is not None or self._focused is not None
        if watching != self._is_watching:
            self._is_watching = watching
            self._keyboard.listen(watching)
        self.changed.emit()

    def _hold(self, is_held: bool) -> None:
        if is_held != self._is_held:
            self._is_held = is_held
            self._update()

    def eventFilter(self, _receiver: QObject, event: QEvent) -> bool:
        kind = event.type()
        if kind not in _KEYS or event.key() != Qt.Key.Key_Space:
            return False
        if not self._is_held:
            plain = event.modifiers() == Qt.KeyboardModifier.NoModifier
            if kind == QEvent.Type.KeyRelease or not plain or not is_keyboard_free():
                return False
        if kind == QEvent.Type.ShortcutOverride:
            event.accept()  # so that it comes as a key press and not as somebody's shortcut
        elif kind == QEvent.Type.KeyPress:
            self._keys.press(event)
            self._hold(True)
        else:
            self._keys.release(event)
        return True
