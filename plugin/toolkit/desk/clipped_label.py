"""A label of a fixed number of lines."""
from __future__ import annotations

from qgis.PyQt.QtCore import QEvent, QSize, Qt
from qgis.PyQt.QtGui import QFontMetrics, QPainter, QPaintEvent
from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from .theme import readable_palette
from .tooltips import rich_tip

_WRAPPED = int(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter) | int(Qt.TextFlag.TextWordWrap)


class ClippedLabel(QWidget):
    """Plain text on at most so many lines, as high as they are whatever it says, so that nothing around it jumps.

    What does not fit ends in an ellipsis; the tooltip tells all of it.
    """

    def __init__(self, lines: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._lines = lines
        self._text = ""
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)

    def text(self) -> str:
        """All of the text."""
        return self._text

    def setText(self, text: str, tip: str = "") -> None:
        """Say something else; ``tip``: more than that, as rich text, for the tooltip."""
        self.setToolTip(tip or (rich_tip(text) if text else ""))
        if text != self._text:
            self._text = text
            self.setAccessibleName(text)
            self.update()

    def sizeHint(self) -> QSize:
        metrics, margins = self.fontMetrics(), self.contentsMargins()
        return QSize(30 * metrics.averageCharWidth(), self._height(metrics) + margins.top() + margins.bottom())

    def minimumSizeHint(self) -> QSize:
        return QSize(10 * self.fontMetrics().averageCharWidth(), self.sizeHint().height())

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self.updateGeometry()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setPen(readable_palette(self).color(self.foregroundRole()))
        painter.drawText(self.contentsRect(), _WRAPPED, self._fitting(self.fontMetrics()))
        painter.end()

    def _fitting(self, metrics: QFontMetrics) -> str:
        """As much of the text as there are lines for."""
        if self._fits(metrics, self._text):
            return self._text
        shortest, longest = 0, len(self._text)
        while longest - shortest > 1:
            middle = (shortest + longest) // 2
            if self._fits(metrics, self._text[:middle].rstrip() + "…"):
                shortest = middle
            else:
                longest = middle
        return self._text[:shortest].rstrip() + "…"

    def _fits(self, metrics: QFontMetrics, text: str) -> bool:
        width = self.contentsRect().width()
        needed = metrics.boundingRect(0, 0, width, 10000, _WRAPPED, text)
        return needed.height() <= self._height(metrics) and needed.width() <= width

    def _height(self, metrics: QFontMetrics) -> int:
        lines = "\n".join("X" * self._lines)
        return metrics.boundingRect(0, 0, 10000, 10000, _WRAPPED, lines).height()
