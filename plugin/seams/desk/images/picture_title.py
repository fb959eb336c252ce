"""The strip above a picture."""
from __future__ import annotations

from qgis.PyQt.QtCore import QRect, QRectF, Qt
from qgis.PyQt.QtGui import QPainter, QPalette

from ....toolkit.desk.theme import readable_on
from ....toolkit.translation import tr
from ...clip_pictures import ClipPicture


def kind_of(picture: ClipPicture) -> str:
    """Mosaic, source or composite, in a word."""
    if picture.is_composite:
        return tr("composite")
    return tr("mosaic") if picture.is_mosaic else tr("source")


def short_name(picture: ClipPicture) -> str:
    """The raster's name, or what it is where there is only one of the kind."""
    return kind_of(picture) if picture.is_mosaic or picture.is_composite else picture.raster


def paint_title(
    painter: QPainter, strip: QRect, palette: QPalette, picture: ClipPicture, name: str, hint: str,
    is_flipped: bool,
) -> None:
    """A badge that says mosaic, source or composite, the name, and a hint where there is room for it.

    A flipped view's strip is highlighted all over.
    """
    metrics = painter.fontMetrics()
    text, faint = palette.color(QPalette.ColorRole.WindowText), palette.color(QPalette.ColorRole.WindowText)
    faint.setAlphaF(0.2)
    bright = palette.color(QPalette.ColorRole.Highlight)
    on_bright = readable_on(bright, palette.color(QPalette.ColorRole.HighlightedText))
    colours = (bright, on_bright) if picture.is_mosaic else (faint, text)
    if is_flipped:
        painter.fillRect(strip, bright)
        colours, text = (on_bright, bright), on_bright
    kind = kind_of(picture)
    badge = QRectF(strip).adjusted(2, 2, -2, -2)
    badge.setWidth(metrics.horizontalAdvance(kind) + 0.8 * metrics.height())
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colours[0])
    painter.drawRoundedRect(badge, badge.height() / 3, badge.height() / 3)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    painter.setPen(colours[1])
    painter.drawText(badge, Qt.AlignmentFlag.AlignCenter, kind)
    painter.setPen(text)
    room = QRectF(strip)
    room.setLeft(badge.right() + metrics.height() / 3)
    if hint and metrics.horizontalAdvance(f"{name}  {hint}") < room.width():
        painter.drawText(room, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight, hint)
    elided = metrics.elidedText(name, Qt.TextElideMode.ElideMiddle, int(room.width()))
    painter.drawText(room, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft, elided)
