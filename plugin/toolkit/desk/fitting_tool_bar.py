"""A toolbar that shows words beside its icons where there is room for them."""
from __future__ import annotations

from collections.abc import Sequence

from qgis.PyQt.QtCore import QEvent, QSize, Qt
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import QAction, QToolBar, QWidget

_STYLES = Qt.ToolButtonStyle


class FittingToolBar(QToolBar):
    """Of the ``worded`` actions the last ones lose their words first; the others are icons throughout."""

    def __init__(self, actions: Sequence[QAction], worded: Sequence[QAction], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        side = self.fontMetrics().height() + 3
        self.setIconSize(QSize(side, side))
        self.setToolButtonStyle(_STYLES.ToolButtonIconOnly)
        self.addActions(actions)
        self._worded = [self.widgetForAction(action) for action in worded]
        for action in actions:
            self.widgetForAction(action).setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a toolbar takes it from them
        self._whole = 0
        self._fit()

    def sizeHint(self) -> QSize:
        """With all words."""
        return QSize(self._whole, super().sizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.LanguageChange) and hasattr(self, "_whole"):
            self._fit()

    def _fit(self) -> None:
        for button in self._worded:
            button.setToolButtonStyle(_STYLES.ToolButtonTextBesideIcon)
        self._whole = super().sizeHint().width()
        for button in reversed(self._worded):
            if super().sizeHint().width() <= self.width():
                break
            button.setToolButtonStyle(_STYLES.ToolButtonIconOnly)
