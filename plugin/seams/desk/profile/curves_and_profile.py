"""The tab with the curves and the seam profile: side by side where it is wide, else one above the other."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import QSplitter, QVBoxLayout, QWidget

from ..curves.curves_panel import CurvesPanel
from .profile_panel import ProfilePanel

if TYPE_CHECKING:
    from ..session import Session

_WIDE_CHARACTERS = 110  # a tab wider than that has room for two charts side by side


class CurvesAndProfile(QWidget):
    """Both panels; the border between them can be moved."""

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.curves = CurvesPanel(session)
        self.profile = ProfilePanel(session)
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
        is_wide = self.width() > _WIDE_CHARACTERS * self.fontMetrics().averageCharWidth()
        orientation = Qt.Orientation.Horizontal if is_wide else Qt.Orientation.Vertical
        if orientation != self._splitter.orientation():
            self._splitter.setOrientation(orientation)
            self._splitter.setSizes([1000, 1000] if is_wide else [1200, 1000])
