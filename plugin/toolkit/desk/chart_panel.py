"""The base of tabs with a chart."""
from __future__ import annotations

from qgis.PyQt.QtCore import QEvent, Qt
from qgis.PyQt.QtGui import QPalette, QShowEvent
from qgis.PyQt.QtWidgets import QHBoxLayout, QLabel, QStackedWidget, QVBoxLayout, QWidget

from .widgets import single_shot

_RESTYLING = (QEvent.Type.PaletteChange, QEvent.Type.StyleChange, QEvent.Type.FontChange)


class ChartPanel(QWidget):
    """A chart or the words in its place; below it words, and a button. Looks anew once it comes into sight."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._timer = single_shot(self, self._refresh)
        self._text = QLabel()
        self._text.setTextFormat(Qt.TextFormat.PlainText)
        self._text.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._text.setWordWrap(True)
        self._text.setAutoFillBackground(True)
        self._text.setBackgroundRole(QPalette.ColorRole.Base)
        self._text.setForegroundRole(QPalette.ColorRole.Text)
        self._text.setMargin(self.fontMetrics().height())
        self._text.setMinimumSize(1, 1)
        self._pages = QStackedWidget()
        self._pages.addWidget(self._text)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._refresh_now()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in _RESTYLING:
            self._refresh_now()

    def _lay_out(self, words: QWidget, button: QWidget) -> None:
        layout, below = QVBoxLayout(self), QHBoxLayout()
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(self.fontMetrics().height() // 5)
        layout.addWidget(self._pages, 1)
        layout.addLayout(below)
        below.addWidget(words, 1)
        below.addWidget(button)

    def _refresh_now(self, *_: object) -> None:
        """Refresh as soon as the signals under way have been handled."""
        self._timer.start(0)

    def _refresh(self) -> None:
        """Show what is selected now; nothing while the panel is out of sight."""
        raise NotImplementedError
