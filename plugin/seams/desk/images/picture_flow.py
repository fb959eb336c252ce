"""How the views share the room there is."""
from __future__ import annotations

from qgis.PyQt.QtCore import QSize
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import QScrollArea, QWidget

from .picture_view import PictureView

GAP = 4
"""Between views, px."""


class PictureFlow(QWidget):
    """Views of one size in as many columns as make them largest; scrolled when they would become too small."""

    def __init__(self, scrolled: QScrollArea) -> None:
        super().__init__()
        self._scrolled = scrolled
        self._views: list[PictureView] = []

    def set_views(self, views: list[PictureView]) -> None:
        self._views = views
        self.arrange()

    def arrange(self) -> None:
        """By the room without a scroll bar, or the bar would come and go; only then within the width it leaves."""
        if not self._views:
            return
        least, area = self._views[0].minimumSizeHint(), self._scrolled.maximumViewportSize()
        columns = max(range(1, len(self._views) + 1), key=lambda columns: self._worth(columns, area, least))
        rows, _, height = self._shares(columns, area)
        fits = height >= least.height()
        height = max(height, least.height())
        self.setMinimumHeight(0 if fits else rows * (height + GAP) - GAP)
        width = (min(area.width(), self.width()) - (columns - 1) * GAP) // columns
        for i, view in enumerate(self._views):
            row, column = divmod(i, columns)
            view.setGeometry(column * (width + GAP), row * (height + GAP), width, height)

    def _shares(self, columns: int, area: QSize) -> tuple[int, int, int]:
        """Rows, and the width and height that each view gets."""
        rows = -(-len(self._views) // columns)
        return rows, (area.width() - (columns - 1) * GAP) // columns, (area.height() - (rows - 1) * GAP) // rows

    def _worth(self, columns: int, area: QSize, least: QSize) -> tuple[bool, int, int]:
        """The shorter side of a view's picture counts, where columns are not too narrow; then little scrolling."""
        _, width, height = self._shares(columns, area)
        side = min(width, max(height, least.height()) - self._views[0].image_rect().top())
        return columns == 1 or width >= least.width(), side, columns

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.arrange()
