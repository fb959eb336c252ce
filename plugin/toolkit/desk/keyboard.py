"""Single keys that mean something in the desk: whether the keyboard is free for them, which are held, and Space held
over a view."""
from __future__ import annotations

import time
from functools import partial

from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject, Qt, QTimer, pyqtSignal
from qgis.PyQt.QtGui import QKeyEvent
from qgis.PyQt.QtWidgets import QAbstractSpinBox, QApplication, QComboBox, QLineEdit, QPlainTextEdit, QTextEdit, QWidget

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
        """Begin or stop to watch the keyboard."""
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
    """The keys that are down. X repeats a held key by releasing and pressing it within 3 ms, and Qt does not always say
    so: a release that a press follows within 50 ms is none.
    """

    released = pyqtSignal(int, float)  # a key, and for how many seconds it was held

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._pressed: dict[int, float] = {}  # when each that is down was pressed
        self._up: dict[int, float] = {}  # when each was released that may be down again at once

    def press(self, event: QKeyEvent) -> bool:
        """Whether the key went down now, and is not repeated."""
        key = event.key()
        if key in self._up and time.monotonic() - self._up[key] > _REPEATED_MS / 1000:
            self._let_go(key)  # the timer waits behind what keeps the interface busy
        is_repeated = self._up.pop(key, None) is not None or event.isAutoRepeat()
        if not is_repeated:
            if not self._pressed:
                QApplication.instance().applicationStateChanged.connect(self._leave)
            self._pressed[key] = time.monotonic()
        return not is_repeated

    def release(self, event: QKeyEvent) -> bool:
        """Whether it is a key that was pressed here."""
        key = event.key()
        if key in self._pressed and not event.isAutoRepeat():
            self._up[key] = time.monotonic()
            QTimer.singleShot(_REPEATED_MS, Qt.TimerType.PreciseTimer, partial(self._stay_up, key, self._up[key]))
        return key in self._pressed

    def forget(self, key: int) -> None:
        """The key is somebody else's, or of no more interest."""
        self._up.pop(key, None)
        if self._pressed.pop(key, None) is not None and not self._pressed:
            QApplication.instance().applicationStateChanged.disconnect(self._leave)

    def close(self) -> None:
        """Forget the keys that are down; no signal tells of it."""
        for key in list(self._pressed):
            self.forget(key)

    def _stay_up(self, key: int, since: float) -> None:
        if self._up.get(key) == since:
            self._let_go(key)

    def _let_go(self, key: int) -> None:
        seconds = self._up.get(key, time.monotonic()) - self._pressed[key]
        self.forget(key)
        self.released.emit(key, seconds)

    def _leave(self, state: Qt.ApplicationState) -> None:
        if state != Qt.ApplicationState.ApplicationActive:  # the keys' release goes to somebody else
            for key in list(self._pressed):
                self._let_go(key)
