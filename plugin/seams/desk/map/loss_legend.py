"""The scale of lost detail on the map: the same for all windows, in sight as long as their pictures are."""
from __future__ import annotations

from qgis.gui import QgsMapCanvas
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QEvent, QObject, QPointF, QRectF, QSize, Qt
from qgis.PyQt.QtGui import QColor, QPainter, QPaintEvent
from qgis.PyQt.QtWidgets import QWidget

from ....toolkit.translation import tr
from ...loss_colours import LOSS_OPACITY, loss_legend

_BACK, _TEXT = QColor(20, 20, 20, 215), QColor("#ffffff")
_GROUND = QColor(128, 128, 128)  # beneath the colours, which are seen through


class LossLegend(QWidget):
    """In the lower right of the canvas; the mouse goes through it."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)  # not of its viewport, which scrolls its children
        self._canvas = canvas
        self._is_empty = False
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.hide()
        canvas.installEventFilter(self)

    def show_legend(self, has_pictures: bool) -> None:
        """``has_pictures``: whether any window has one; else it is said that there is none yet."""
        self._is_empty = not has_pictures
        self._place()
        self.show()
        self.raise_()
        self.update()

    def close_legend(self) -> None:
        """Off the canvas."""
        if sip.isdeleted(self):
            return
        self._canvas.removeEventFilter(self)
        self.hide()
        self.setParent(None)
        self.deleteLater()

    def lines(self) -> list[str]:
        """Title and entries."""
        words = [tr("No picture yet: inspect windows")] if self._is_empty else [one for one, _ in loss_legend()]
        return [tr("Detail kept (L hides it)"), *words]

    def sizeHint(self) -> QSize:
        line = self.fontMetrics().height()
        widths = [self.fontMetrics().horizontalAdvance(one) for one in self.lines()]
        across = max(widths[0], max(widths[1:]) + 1.8 * line) + line
        return QSize(round(across), round((len(widths) * 1.15 + 0.7) * line))

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self._place()
        return False

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        line = self.fontMetrics().height()
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(_BACK)
        painter.drawRoundedRect(QRectF(self.rect()), line / 4, line / 4)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(_TEXT)
        title, *words = self.lines()
        painter.drawText(QPointF(line / 2, 1.2 * line), title)
        for number, text in enumerate(words, 1):
            base = (1.2 + 1.15 * number) * line
            if not self._is_empty:
                colour = QColor(*loss_legend()[number - 1][1])
                colour.setAlphaF(LOSS_OPACITY * colour.alphaF())
                swatch = QRectF(line / 2, base - 0.75 * line, 1.4 * line, 0.85 * line)
                painter.fillRect(swatch, _GROUND)
                painter.fillRect(swatch, colour)
            painter.drawText(QPointF(line / 2 + (0 if self._is_empty else 1.8 * line), base), text)
        painter.end()

    def _place(self) -> None:
        self.resize(self.sizeHint())
        gap = self.fontMetrics().height() // 2
        self.move(self._canvas.width() - self.width() - gap, self._canvas.height() - self.height() - gap)
