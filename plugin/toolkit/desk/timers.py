"""Timers that go off once."""
from __future__ import annotations

from typing import Any

from qgis.PyQt.QtCore import QObject, QTimer


def single_shot(parent: QObject, slot: Any, wait_ms: int = 0) -> QTimer:
    """Calls a slot, or emits a signal, once after each ``start``; one more ``start`` begins the waiting anew."""
    timer = QTimer(parent)
    timer.setSingleShot(True)
    timer.setInterval(wait_ms)
    timer.timeout.connect(slot)
    return timer
