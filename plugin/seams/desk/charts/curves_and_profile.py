"""The tab with the curves and the seam profile: one above the other where that fits, else side by side."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QEvent, QObject, Qt
from qgis.PyQt.QtGui import QResizeEvent, QShowEvent
from qgis.PyQt.QtWidgets import QScrollArea, QSplitter, QVBoxLayout, QWidget

from ....toolkit.desk.widgets import single_shot
from ..charts.curves_panel import CurvesPanel
from .profile_panel import ProfilePanel

if TYPE_CHECKING:
    from ..session import Session

_WIDE_CHARACTERS = 75  # a tab wider than that has room for two charts side by side
_SPARE_LINES = 1  # that the dock's sentence may be longer for another window, without the charts moving to and fro


class CurvesAndProfile(QWidget):
    """Both panels; the border between them can be moved."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.curves = CurvesPanel(session)
        self.profile = ProfilePanel(session)
        self._scroll: QScrollArea | None = None
        self._arranger = single_shot(self, self._arrange)  # when all around it have their new sizes
        self._splitter = QSplitter(Qt.Orientation.Vertical)
        self._splitter.setChildrenCollapsible(False)
        for panel in (self.curves, self.profile):
            self._splitter.addWidget(panel)
            self._splitter.setStretchFactor(self._splitter.count() - 1, 1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._splitter)

    @property
    def is_side_by_side(self) -> bool:
        """How they stand."""
        return bool(self._splitter.orientation() == Qt.Orientation.Horizontal)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._arranger.start()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        around = self.parentWidget()
        while around is not None and not isinstance(around, QScrollArea):
            around = around.parentWidget()
        if around is not None and self._scroll is None:
            self._scroll = around
            around.viewport().installEventFilter(self)
        self._arranger.start()

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self._arranger.start()
        return False

    def _arrange(self) -> None:
        is_wide = self.width() > _WIDE_CHARACTERS * self.fontMetrics().averageCharWidth()
        orientation = Qt.Orientation.Horizontal if is_wide or self._is_low() else Qt.Orientation.Vertical
        if orientation != self._splitter.orientation():
            self._splitter.setOrientation(orientation)
            self._splitter.setSizes([1000, 1000])

    def _is_low(self) -> bool:
        """Whether the dock has no room for one chart below the other, so that it would have to be scrolled."""
        scroll = self._scroll
        if scroll is None or scroll.widget() is None:
            return False
        others = scroll.widget().minimumSizeHint().height() - self.minimumSizeHint().height()
        stacked = sum(panel.minimumSizeHint().height() for panel in (self.curves, self.profile))
        spare = _SPARE_LINES * self.fontMetrics().height() if self.is_side_by_side else 0
        return bool(scroll.viewport().height() - others < stacked + self._splitter.handleWidth() + spare)
