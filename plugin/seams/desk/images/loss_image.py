"""The picture of lost detail, painted over a picture of the window."""
from __future__ import annotations

from qgis.PyQt.QtCore import QPointF, QRectF
from qgis.PyQt.QtGui import QPainter

from ....imagery.grids import PixelWindow
from ...measure.profile.loss_picture import LossPicture
from ...words import LOSS_OPACITY, loss_rgba
from ..map.picture_overlay import rgba_image
from .viewport import Viewport


class LossImage:
    """Ready to be painted at any scale."""

    def __init__(self, loss: LossPicture) -> None:
        self.loss = loss
        self._image = rgba_image(loss_rgba(loss.kept))

    def paint(
        self, painter: QPainter, corner: QPointF, viewport: Viewport, ratio: float, inside: PixelWindow | None
    ) -> None:
        """Over a picture whose corner on the widget is given; ``inside``: the window in it, None: all of it."""
        window = inside or PixelWindow(0, 0, *viewport.window)
        scale, (left, top) = viewport.scale, viewport.origin()
        x, y = left + window.column * scale, top + window.row * scale
        cell = self.loss.cell_px * scale
        painter.save()
        painter.translate(corner)
        painter.scale(1 / ratio, 1 / ratio)
        painter.setClipRect(QRectF(x, y, window.width * scale, window.height * scale) & QRectF(0, 0, *viewport.screen))
        painter.setOpacity(LOSS_OPACITY)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)  # as on the map
        painter.drawImage(QRectF(x, y, cell * self._image.width(), cell * self._image.height()), self._image)
        painter.restore()
