"""A label of so many lines at most."""
from __future__ import annotations

from qgis.PyQt.QtCore import QEvent, QSize, Qt
from qgis.PyQt.QtGui import QFontMetrics, QMouseEvent, QPainter, QPaintEvent, QResizeEvent
from qgis.PyQt.QtWidgets import QSizePolicy, QToolTip, QWidget

from .theme import readable_palette
from .tooltips import rich_tip

_WRAPPED = int(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter) | int(Qt.TextFlag.TextWordWrap)


class ClippedLabel(QWidget):
    """Plain text on at most so many lines, as high as they are whatever it says, so that nothing around it jumps;
    of a range of lines as high as it needs.

    What does not fit ends in an ellipsis; the tooltip tells all of it, which a click shows at once.
    """

    def __init__(self, lines: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._fewest = self._most = self._lines = lines
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
            self._fit()
            self.update()

    def set_lines(self, fewest: int, most: int) -> None:
        """As high as the text needs, from now on."""
        if (fewest, most) != (self._fewest, self._most):
            self._fewest, self._most = fewest, most
            self._fit()

    def _fit(self) -> None:
        """Take as many lines as the text needs, and as there may be."""
        metrics, lines = self.fontMetrics(), self._fewest if self._text or self._fewest == self._most else 1
        while lines < self._most and not self._fits(metrics, self._text, lines):
            lines += 1
        if lines != self._lines:
            self._lines = lines
            self.updateGeometry()
        is_cut = not self._fits(metrics, self._text, lines)
        self.setCursor(Qt.CursorShape.PointingHandCursor if is_cut else Qt.CursorShape.ArrowCursor)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.oldSize().width() != event.size().width():
            self._fit()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        QToolTip.showText(self.mapToGlobal(event.pos()), self.toolTip(), self)

    def sizeHint(self) -> QSize:
        metrics, margins = self.fontMetrics(), self.contentsMargins()
        return QSize(30 * metrics.averageCharWidth(), _height(metrics, self._lines) + margins.top() + margins.bottom())

    def minimumSizeHint(self) -> QSize:
        return QSize(10 * self.fontMetrics().averageCharWidth(), self.sizeHint().height())

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._fit()
            self.updateGeometry()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setPen(readable_palette(self).color(self.foregroundRole()))
        painter.drawText(self.contentsRect(), _WRAPPED, self._fitting(self.fontMetrics()))
        painter.end()

    def _fitting(self, metrics: QFontMetrics) -> str:
        """As much of the text as there are lines for."""
        if self._fits(metrics, self._text, self._lines):
            return self._text
        shortest, longest = 0, len(self._text)
        while longest - shortest > 1:
            middle = (shortest + longest) // 2
            if self._fits(metrics, self._text[:middle].rstrip() + "…", self._lines):
                shortest = middle
            else:
                longest = middle
        return self._text[:shortest].rstrip() + "…"

    def _fits(self, metrics: QFontMetrics, text: str, lines: int) -> bool:
        width = self.contentsRect().width()
        needed = metrics.boundingRect(0, 0, width, 10000, _WRAPPED, text)
        return needed.height() <= _height(metrics, lines) and needed.width() <= width


def _height(metrics: QFontMetrics, lines: int) -> int:
    return metrics.boundingRect(0, 0, 10000, 10000, _WRAPPED, "\n".join("X" * lines)).height()
