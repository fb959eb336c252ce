"""Painters that end with their block."""
from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from qgis.PyQt.QtGui import QPaintDevice, QPainter


@contextmanager
def painting(device: QPaintDevice) -> Iterator[QPainter]:
    """A painter on a widget, an image or a file. It ends though something raised, or a profiler or a traceback holds
    what the painter is known to: where one outlives the painting of its widget, Qt crashes in that of the next."""
    painter = QPainter(device)
    try:
        yield painter
    finally:
        painter.end()
