"""Pictures that lie over the map where their windows are, whatever way it is turned and whatever its reference
system."""
from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsCsException, QgsPointXY, QgsProject
from qgis.gui import QgsMapCanvas, QgsMapCanvasItem
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QImage, QPainter, QPainterPath, QPolygonF, QTransform
from qgis.PyQt.QtWidgets import QStyleOptionGraphicsItem, QWidget

from ....imagery.errors import WindowError
from ....imagery.grids import Extent
from ....toolkit.painting import painting
from ....toolkit.reference_systems import transformation

if TYPE_CHECKING:
    import numpy as np

_BELOW_BANDS = 5.0  # of the canvas' items: above the map, below outlines and marks


class PlacedPicture(NamedTuple):
    """A picture on the ground."""

    image: QImage
    extent: Extent  # extent of the whole image, in the overlay's reference system
    shown: Extent  # extent of the part that is seen: a window may end within a cell


def rgba_image(rgba: np.ndarray) -> QImage:
    """(rows, columns, 4) uint8, alpha not multiplied in; as Qt draws it soonest."""
    rows, columns = rgba.shape[:2]
    pixels = rgba.tobytes()  # kept until the copy is made: Qt reads them where they are
    image = QImage(pixels, columns, rows, 4 * columns, QImage.Format.Format_RGBA8888)
    return image.convertToFormat(QImage.Format.Format_ARGB32_Premultiplied)  # a copy


class PictureOverlay:
    """The one owner of the canvas item, which is made when something is first shown; ``close`` takes it off."""

    def __init__(self, canvas: QgsMapCanvas, smooth: bool = True, above: float = 0.0, opacity: float = 1.0) -> None:
        self._canvas, self._smooth, self._above, self._opacity = canvas, smooth, above, opacity
        self._item: _PictureItem | None = None

    @property
    def pictures(self) -> tuple[PlacedPicture, ...]:
        """What is shown."""
        return self._item.pictures if self._item is not None else ()

    def show(self, pictures: Sequence[PlacedPicture], crs: QgsCoordinateReferenceSystem) -> None:
        """These and no others; ``crs`` is that of their extents."""
        if self._item is None:
            if not pictures:
                return
            self._item = _PictureItem(self._canvas, self._smooth, self._opacity)
            self._item.setZValue(_BELOW_BANDS + self._above)
        self._item.put(tuple(pictures), crs)

    def hide(self) -> None:
        """Show nothing until the next ``show``."""
        if self._item is not None:
            self._item.put((), QgsCoordinateReferenceSystem())

    def set_visible(self, is_visible: bool) -> None:
        """Let what is shown be seen, or not for now."""
        if self._item is not None:
            self._item.setVisible(is_visible)

    def close(self) -> None:
        """Take it off the canvas; a later ``show`` makes it anew."""
        item, self._item = self._item, None
        if item is not None and not sip.isdeleted(self._canvas):
            self._canvas.scene().removeItem(item)


class _PictureItem(QgsMapCanvasItem):
    """Covers the canvas, and follows it."""

    def __init__(self, canvas: QgsMapCanvas, smooth: bool, opacity: float) -> None:
        super().__init__(canvas)
        self._canvas, self._smooth, self._opacity = canvas, smooth, opacity
        self.pictures: tuple[PlacedPicture, ...] = ()
        self._crs = QgsCoordinateReferenceSystem()

    def put(self, pictures: tuple[PlacedPicture, ...], crs: QgsCoordinateReferenceSystem) -> None:
        self.pictures, self._crs = pictures, crs
        self.updatePosition()

    def updatePosition(self) -> None:
        self.prepareGeometryChange()
        self.update()

    def boundingRect(self) -> QRectF:
        return QRectF(self._canvas.rect())

    def paint(
        self, painter: QPainter, _option: QStyleOptionGraphicsItem | None = None, _widget: QWidget | None = None
    ) -> None:
        if not self.pictures:
            return
        if self._opacity == 1:
            self._paint_pictures(painter)
            return
        ratio = painter.device().devicePixelRatioF()  # where pictures overlap they are seen through as elsewhere
        together = QImage(self._canvas.size() * ratio, QImage.Format.Format_ARGB32_Premultiplied)
        together.setDevicePixelRatio(ratio)
        together.fill(Qt.GlobalColor.transparent)
        with painting(together) as on_image:
            self._paint_pictures(on_image)
        painter.setOpacity(self._opacity)
        painter.drawImage(QPointF(), together)

    def _paint_pictures(self, painter: QPainter) -> None:
        map_crs, context = self._canvas.mapSettings().destinationCrs(), QgsProject.instance().transformContext()
        try:
            transform = transformation(self._crs, map_crs, context)
        except WindowError:
            return
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, self._smooth)
        for picture in self.pictures:
            try:
                around, shown = (self._on_canvas(extent, transform) for extent in (picture.extent, picture.shown))
            except QgsCsException:
                continue
            if not shown.boundingRect().intersects(self.boundingRect()):
                continue
            pixels = QRectF(picture.image.rect())
            corners = QPolygonF([pixels.topLeft(), pixels.topRight(), pixels.bottomRight(), pixels.bottomLeft()])
            warp = QTransform()
            if not QTransform.quadToQuad(corners, around, warp):
                continue
            path = QPainterPath()
            path.addPolygon(shown)
            painter.save()
            painter.setClipPath(path)
            painter.setTransform(warp, True)
            painter.drawImage(QPointF(), picture.image)
            painter.restore()

    def _on_canvas(self, extent: Extent, transform: QgsCoordinateTransform) -> QPolygonF:
        """The corners in pixels of the canvas, from the upper left clockwise."""
        xmin, ymin, xmax, ymax = extent
        corners = ((xmin, ymax), (xmax, ymax), (xmax, ymin), (xmin, ymin))
        return QPolygonF([self.toCanvasCoordinates(transform.transform(QgsPointXY(*corner))) for corner in corners])
