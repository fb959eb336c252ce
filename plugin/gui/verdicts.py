"""Verdicts for the eye: their words, meanings and colours, the same as on the map (resources/styles/windows.qml)."""
from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QLocale, QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QIcon, QPainter, QPen, QPixmap, QPolygonF

from ..adapters.text import tr

if TYPE_CHECKING:
    from ..adapters.window_layer import WindowRow

COLOURS = {
    "significant": "#d55e00",
    "reduced": "#f0c800",
    "preserved": "#0072b2",
    "not_comparable": "#8a8a8a",
    "": "#e8e8e8",
}
"""By verdict, worst first; the empty one is that of a window not inspected."""
VERDICTS = tuple(COLOURS)
_CHIP_SIDES = (12, 16, 20, 24, 32, 48)  # px; an icon takes the next larger one and scales it down


def verdict_word(verdict: str) -> str:
    """What the table calls a verdict."""
    return {
        "significant": tr("significant"),
        "reduced": tr("reduced"),
        "preserved": tr("preserved"),
        "not_comparable": tr("not comparable"),
        "": tr("not inspected"),
    }.get(verdict, verdict)


def observer_word(observer: str) -> str:
    """What the table calls the observer's word."""
    return {"visible": tr("visible"), "invisible": tr("invisible")}.get(observer, observer)


def verdict_chip(verdict: str, stale: bool = False) -> QIcon:
    """A square in the verdict's colour; only half of it is filled when the verdict is out of date.

    It looks the same in selected rows.
    """
    icon = QIcon()
    for side in _CHIP_SIDES:
        pixmap = _chip(verdict, stale, side)
        for mode in (QIcon.Mode.Normal, QIcon.Mode.Selected, QIcon.Mode.Active):
            icon.addPixmap(pixmap, mode)
    return icon


def window_sentence(row: WindowRow) -> str:
    """What was found in a window, in plain words."""
    if not row.verdict:
        return tr("Not inspected yet.")
    if row.verdict == "not_comparable":
        found = row.reason or tr("The mosaic could not be compared with a source here.")
    else:
        found = _detail_sentence(row)
    return tr("{finding} Changed since: inspect it again.").format(finding=found) if row.stale else found


def windows_sentence(rows: Sequence[WindowRow]) -> str:
    """What was found in several windows, in plain words."""
    counts = Counter(row.verdict for row in rows)
    parts = [f"{counts[verdict]} {verdict_word(verdict)}" for verdict in (*VERDICTS, *_unknown(counts))
             if counts[verdict]]
    changed = sum(row.stale for row in rows)
    if changed:
        parts.append(tr("{count} changed since").format(count=changed))
    return tr("{count} windows selected: {verdicts}.").format(count=len(rows), verdicts=", ".join(parts))


def window_tip(row: WindowRow) -> str:
    """The same as rich text that wraps, for a tooltip."""
    return rich_tip(window_sentence(row))


def rich_tip(text: str) -> str:
    """Qt breaks the lines of a tooltip only when it is rich text."""
    return f"<p>{escape(text)}</p>"


def percent(ratio: float) -> str:
    """Whole per cents; one decimal where they would hide that a ratio is not 1, or is small."""
    decimals = 1 if ratio < 0.1 or (0.99 < ratio < 1.01 and ratio != 1) else 0
    share = 100 * ratio
    if ratio < 1:
        share = min(share, 99.9)
    return QLocale().toString(share, "f", decimals)


def _detail_sentence(row: WindowRow) -> str:
    ratio = row.ratios[0] if row.ratios else None
    if ratio is None:
        return f"{verdict_word(row.verdict).capitalize()}."
    if row.sources == 1:
        against = tr("Detail at level 1 is {percent} % of the source's: {verdict}.")
    else:
        against = tr("Detail at level 1 is {percent} % of the least sharp source's: {verdict}.")
    verdict = tr("significant loss") if row.verdict == "significant" else verdict_word(row.verdict)
    return against.format(percent=percent(ratio), verdict=verdict)


def _unknown(counts: Counter[str]) -> list[str]:
    return [verdict for verdict in counts if verdict not in VERDICTS]


def _chip(verdict: str, stale: bool, side: int) -> QPixmap:
    colour = QColor(COLOURS.get(verdict, COLOURS["not_comparable"]))
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
        edge = QColor(COLOURS["not_comparable"])
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
