"""Verdicts for the eye: chips and tooltips. The colours are those on the map (resources/styles/windows.qml)."""
from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QIcon, QPainter, QPen, QPixmap, QPolygonF

from ....toolkit.desk.theme import plain_icon
from ....toolkit.desk.widgets import rich_tip
from ....toolkit.translation import filled, tr
from ...verdict_words import VERDICTS, verdict_colour, verdict_word
from ...window_summary import cause_numbers, explanation_of, window_sentence

if TYPE_CHECKING:
    from ...measure.window.window_result import WindowResult
    from ...measure.window_records import WindowRecord

_CHIP_SIDES = (12, 16, 20, 24, 32, 48)  # px; an icon takes the next larger one and scales it down


def verdict_chip(verdict: str, stale: bool = False) -> QIcon:
    """A square in the verdict's colour; only half of it is filled when the verdict is out of date."""
    return plain_icon(*(_chip(verdict, stale, side) for side in _CHIP_SIDES))


def windows_sentence(rows: Sequence[WindowRecord]) -> str:
    """What was found in several windows, in plain words."""
    counts = Counter(row.verdict for row in rows)
    words = dict.fromkeys([*VERDICTS, *counts])  # the unknown ones last
    parts = [f"{counts[verdict]} {verdict_word(verdict)}" for verdict in words if counts[verdict]]
    changed = sum(row.stale for row in rows)
    if changed:
        parts.append(filled(tr("{count} changed since"), count=changed))
    return filled(tr("{count} windows selected: {verdicts}."), count=len(rows), verdicts=", ".join(parts))


def window_tip(row: WindowRecord, result: WindowResult | None = None) -> str:
    """The sentence about a window, and the numbers behind it, as rich text that wraps, for a tooltip."""
    found = explanation_of(row, result)
    return rich_tip(window_sentence(row, result), *(cause_numbers(found) if found is not None else ()))


def _chip(verdict: str, stale: bool, side: int) -> QPixmap:
    colour = QColor(verdict_colour(verdict))
    pixmap = QPixmap(side, side)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    margin, width = side / 12, max(side / 10, 1.0)
    square = QRectF(margin, margin, side - 2 * margin, side - 2 * margin)
    edge = colour.darker(130)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colour)
    if stale:
        painter.drawPolygon(QPolygonF([square.topLeft(), square.topRight(), square.bottomLeft()]))
        edge = colour
    elif verdict:
        painter.drawRoundedRect(square, side / 6, side / 6)
    else:  # nothing known: an empty box, to be seen on light and on dark rows
        edge = QColor(verdict_colour("not_comparable"))
        painter.setBrush(QColor(232, 232, 232, 90))
        painter.drawRect(square)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    pen = QPen(edge, width)
    if not verdict:
        pen.setStyle(Qt.PenStyle.DotLine)
    painter.setPen(pen)
    inner = square.adjusted(width / 2, width / 2, -width / 2, -width / 2)
    painter.drawRoundedRect(inner, side / 6, side / 6)
    if stale:
        painter.drawLine(QPointF(inner.left(), inner.bottom()), QPointF(inner.right(), inner.top()))
    painter.end()
    return pixmap
