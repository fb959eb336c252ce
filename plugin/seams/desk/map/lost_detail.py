"""Pictures of the detail that was lost, on the map.

Those lie where their windows are, whatever way the map is turned and whatever its reference system.
"""
from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING, NamedTuple

from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsCsException, QgsPointXY, QgsProject
from qgis.gui import QgsMapCanvas, QgsMapCanvasItem
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QEvent, QObject, QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QImage, QPainter, QPainterPath, QPolygonF, QTransform
from qgis.PyQt.QtWidgets import QLabel, QStyleOptionGraphicsItem, QWidget

from ....imagery.errors import WindowError
from ....imagery.grids import Extent, Grid, PixelWindow
from ....toolkit.connections import Connections
from ....toolkit.desk.theme import blended
from ....toolkit.desk.widgets import single_shot
from ....toolkit.painting import painting
from ....toolkit.reference_systems import transformation
from ....toolkit.translation import tr
from ...window_summary import painted_width_m
from ...words import LOSS_OPACITY, loss_legend, loss_rgba

if TYPE_CHECKING:
    import numpy as np

    from ...measure.window.window_result import WindowResult
    from ...measure.window_records import WindowRecord
    from ..session import Session


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

    def __init__(self, canvas: QgsMapCanvas) -> None:
        self._canvas = canvas
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
            self._item = _PictureItem(self._canvas)
            self._item.setZValue(_BELOW_BANDS)
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

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self._canvas = canvas
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
        ratio = painter.device().devicePixelRatioF()  # where pictures overlap they are seen through as elsewhere
        together = QImage(self._canvas.size() * ratio, QImage.Format.Format_ARGB32_Premultiplied)
        together.setDevicePixelRatio(ratio)
        together.fill(Qt.GlobalColor.transparent)
        with painting(together) as on_image:
            self._paint_pictures(on_image)
        painter.setOpacity(LOSS_OPACITY)
        painter.drawImage(QPointF(), together)

    def _paint_pictures(self, painter: QPainter) -> None:
        map_crs, context = self._canvas.mapSettings().destinationCrs(), QgsProject.instance().transformContext()
        try:
            transform = transformation(self._crs, map_crs, context)
        except WindowError:
            return
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        labels = self._labels()
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
            painter.setClipPath(path.subtracted(labels))
            painter.setTransform(warp, True)
            painter.drawImage(QPointF(), picture.image)
            painter.restore()

    def _labels(self) -> QPainterPath:
        """The ground beneath the map's labels, which are to be read."""
        path, results = QPainterPath(), self._canvas.labelingResults()
        for label in results.allLabels() if results is not None else ():
            outline = map(QgsPointXY, label.labelGeometry.vertices())
            path.addPolygon(QPolygonF([self.toCanvasCoordinates(corner) for corner in outline]))
        return path

    def _on_canvas(self, extent: Extent, transform: QgsCoordinateTransform) -> QPolygonF:
        """The corners in pixels of the canvas, from the upper left clockwise."""
        xmin, ymin, xmax, ymax = extent
        corners = ((xmin, ymax), (xmax, ymax), (xmax, ymin), (xmin, ymin))
        return QPolygonF([self.toCanvasCoordinates(transform.transform(QgsPointXY(*corner))) for corner in corners])


_TOGETHER_MS = 100  # windows that come within this time are painted once
_SLICE_S = 0.05  # of reading results, which of thousands of windows are in a file; then the operator has a turn


@dataclass(frozen=True)
class WindowPicture:
    """Picture of one window's result."""

    of: tuple[object, ...]  # what was measured in the window, as its row says
    image: QImage | None  # none where nothing is to be painted
    window: PixelWindow | None
    cell_px: int  # side of an image's pixel, in pixels of the mosaic; 0 where the loss can't be told


class LossOverlay(QObject):
    """Follows the session; owns all that it puts on the canvas until ``close``."""

    def __init__(self, canvas: QgsMapCanvas, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._overlay = PictureOverlay(canvas)
        self._gives_way = False
        self._legend = LossLegend(canvas)
        self._pictures: dict[int, WindowPicture] = {}  # by window number
        self._timer = single_shot(self, self._refresh, _TOGETHER_MS)
        self._next_slice = single_shot(self, self._refresh)
        self._connections = Connections(
            (session.resultArrived, self._forget), (session.resultArrived, self._refresh_soon),
            (session.windowsChanged, self._refresh_soon), (session.inputsChanged, self._refresh_soon),
            (session.lost_detail.toggled, self._refresh),
        )  # fmt: skip

    def close(self) -> None:
        """Take all off the canvas and follow the session no more."""
        self._connections.close()
        self._timer.stop()
        self._next_slice.stop()
        self._overlay.close()
        self._legend.close_legend()

    def give_way(self, to_another_picture: bool) -> None:
        """What the mosaic lost is not to be seen over another picture than the mosaic."""
        self._gives_way = to_another_picture
        self._overlay.set_visible(not to_another_picture)

    def _refresh_soon(self, *_: object) -> None:
        if self._session.lost_detail.isChecked() and not self._timer.isActive():
            self._timer.start()

    def _forget(self, fid: int) -> None:
        """The window was measured anew."""
        row = self._session.row(fid)
        if row is not None:
            self._pictures.pop(row.window_id, None)

    def _refresh(self, *_: object) -> None:
        layer, grid = self._session.mosaic_layer(), self._session.mosaic_grid()
        if not self._session.lost_detail.isChecked() or layer is None or grid is None:
            self._pictures.clear()
            self._overlay.hide()
            self._legend.hide()
            return
        end, is_late = time.perf_counter() + _SLICE_S, False
        pictures: dict[int, WindowPicture] = {}
        for row in self._session.windows():
            if row.stale:
                continue
            picture = self._pictures.get(row.window_id)
            if picture is None or picture.of != row.measured:
                result = self._session.result(row.fid) if not is_late else None
                picture = picture_of(row, result) if result is not None else None
                # Only after one that was read, so that each slice gets further
                is_late = is_late or (picture is not None and time.perf_counter() > end)
            if picture is not None:
                pictures[row.window_id] = picture
        self._pictures = pictures
        if is_late:
            self._next_slice.start()
        placed = [
            placed_picture(picture.image, picture.window, picture.cell_px, grid)
            for picture in pictures.values()
            if picture.image is not None and picture.window is not None
        ]
        self._overlay.show(placed, QgsCoordinateReferenceSystem(layer.crs()))
        self._overlay.set_visible(not self._gives_way)
        self._legend.show_legend(is_reading=is_late)


def picture_of(row: WindowRecord, result: WindowResult) -> WindowPicture:
    """Nothing is painted where all is even, as in most windows of a sound mosaic, and that costs no time."""
    loss = result.loss
    if loss is None:
        return WindowPicture(row.measured, None, None, 0)
    rgba = loss_rgba(loss, painted_width_m(row, result) / result.ground_sample_distance)
    return WindowPicture(row.measured, rgba_image(rgba) if rgba[..., 3].any() else None, result.window, loss.cell_px)


def placed_picture(image: QImage, window: PixelWindow, cell_px: int, grid: Grid) -> PlacedPicture:
    """Picture of a window: an image whose pixels are ``cell_px`` px of the mosaic, from its upper left."""
    whole = PixelWindow(window.column, window.row, cell_px * image.width(), cell_px * image.height())
    return PlacedPicture(image, grid.window_extent(whole), grid.window_extent(window))


_LEGEND = "color: white; background: rgba(20, 20, 20, 215); border-radius: 4px; padding: 3px 6px;"
_GROUND = QColor(128, 128, 128)  # beneath the colours, which are seen through


class LossLegend(QLabel):
    """In the lower right of the canvas; the mouse goes through it."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)  # not of its viewport, which scrolls its children
        self._canvas = canvas
        self.setStyleSheet(_LEGEND)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()
        canvas.installEventFilter(self)

    def show_legend(self, is_reading: bool = False) -> None:
        """In the map's own corner, in front of what it shows. ``is_reading``: some colours are to come."""
        swatch, words = "<td style='background: {}'>&nbsp;&nbsp;&nbsp;&nbsp;</td><td>&nbsp;{}</td>", []
        for text, (*rgb, alpha) in loss_legend():
            colour = blended(QColor(*rgb), _GROUND, LOSS_OPACITY * alpha / 255)
            words.append(swatch.format(colour.name(), escape(text)))
        title = tr("Detail kept: reading ...") if is_reading else tr("Detail kept")
        page = escape(title) + f"<table><tr>{'</tr><tr>'.join(words)}</tr></table>"
        self.setText(page)
        self._place()
        self.show()
        self.raise_()

    def close_legend(self) -> None:
        """Off the canvas."""
        if sip.isdeleted(self):
            return
        self._canvas.removeEventFilter(self)
        self.setParent(None)
        self.deleteLater()

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self._place()
        return False

    def _place(self) -> None:
        self.adjustSize()
        gap = self.fontMetrics().height() // 2
        self.move(self._canvas.width() - self.width() - gap, self._canvas.height() - self.height() - gap)
