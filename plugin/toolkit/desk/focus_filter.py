"""Listens to the keyboard wherever the focus is, without a filter of all of the application's events.

Such a filter makes a Python object of every receiver, also of those that are being deleted, and of those of libraries
that tell nothing of their types, such as the web views of QGIS's map tips: QGIS crashes then.
"""
from __future__ import annotations

from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtWidgets import QApplication, QWidget


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
