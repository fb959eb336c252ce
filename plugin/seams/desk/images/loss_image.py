"""The picture of lost detail, painted over a picture of the window."""
from __future__ import annotations

import numpy as np
from qgis.PyQt.QtCore import QPointF, QRectF
from qgis.PyQt.QtGui import QImage, QPainter

from ....imagery.grids import PixelWindow
from ...loss_colours import loss_rgba
from ...measure.profile.loss_picture import LossPicture
from .viewport import Viewport

_OPACITY = 0.6  # what lies beneath is what is judged


class LossImage:
    """On its array's own memory; it keeps the array as long as it lives."""

    def __init__(self, loss: LossPicture) -> None:
        self.loss = loss
        self._pixels = np.ascontiguousarray(loss_rgba(loss.kept))
        rows, columns = self._pixels.shape[:2]
        self._image = QImage(self._pixels.data, columns, rows, 4 * columns, QImage.Format.Format_RGBA8888)

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
        painter.setOpacity(_OPACITY)
        painter.drawImage(QRectF(x, y, cell * self._image.width(), cell * self._image.height()), self._image)
        painter.restore()
