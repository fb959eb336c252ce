"""What is drawn over the map while a window is being placed: its outline, a label, a mark on the seam."""
from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCsException,
    QgsGeometry,
    QgsPointXY,
    QgsProject,
    QgsRectangle,
    QgsWkbTypes,
)
from qgis.gui import QgsMapCanvas, QgsRubberBand, QgsVertexMarker
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QRect, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QPolygonF
from qgis.PyQt.QtWidgets import QLabel

from ....imagery.errors import WindowError
from ....toolkit.reference_systems import transformation

_CASING = QColor(0, 0, 0, 170)  # around the outline, so that it shows on bright ground as well as on dark
_MARK = QColor("#ff00ff")  # as QGIS marks a snapped vertex
_EDGE_VERTICES = 8  # a straight edge may be curved in the map's reference system
_LABEL_CHARACTERS = 48  # a longer sentence is broken into lines


class OutlineTone(Enum):
    """What the outline means: colour of the line, colour of the label's box, pen. No colour is a verdict's."""

    GOOD = ("#ffffff", "rgba(20, 20, 20, 220)", Qt.PenStyle.SolidLine)
    """It will be a window."""
    DOUBTFUL = ("#ff7bf2", "rgba(105, 15, 95, 235)", Qt.PenStyle.SolidLine)
    """It will be a window that can't be compared."""
    REFUSED = ("#ff4d4d", "rgba(140, 10, 25, 235)", Qt.PenStyle.DashLine)
    """It can't be a window."""


@dataclass(frozen=True)
class _Items:
    """What lies on the canvas."""

    band: QgsRubberBand
    mark: QgsVertexMarker
    label: QLabel


class WindowOutline:
    """The one owner of these items. They are made when first shown; ``close`` takes them off the canvas."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        self._canvas = canvas
        self._items: _Items | None = None
        self._outline = QgsRectangle()  # on the map, for the label to follow

    def show(
        self,
        rectangle: QgsRectangle,
        text: str,
        crs: QgsCoordinateReferenceSystem | None = None,
        tone: OutlineTone = OutlineTone.GOOD,
        mark: QgsPointXY | None = None,
    ) -> None:
        """Draw a rectangle with its label, and a mark where there is one.

        ``crs``: of rectangle and mark; that of the map when it is left out.
        """
        outline = QgsGeometry.fromRect(rectangle)
        spot = QgsGeometry.fromPointXY(mark) if mark is not None else None
        map_crs = self._canvas.mapSettings().destinationCrs()
        if crs is not None and crs != map_crs:
            outline = outline.densifyByCount(_EDGE_VERTICES)
            try:
                transform = transformation(crs, map_crs, QgsProject.instance().transformContext())
                outline.transform(transform)
                if spot is not None:
                    spot.transform(transform)
            except (QgsCsException, WindowError):
                self.hide()
                return
        if self._items is None:
            self._items = _items(self._canvas)
            self._canvas.extentsChanged.connect(self._place_label)
        line, box, pen = tone.value
        band = self._items.band
        band.setStrokeColor(QColor(line))
        band.setLineStyle(pen)
        band.setToGeometry(outline)
        self._items.mark.setVisible(spot is not None)
        if spot is not None:
            self._items.mark.setCenter(spot.asPoint())
        _write(self._items.label, text, box, self._canvas.width())
        self._outline = outline.boundingBox()
        self._place_label()
        self._items.label.show()

    def hide(self) -> None:
        """Show nothing until the next ``show``."""
        if self._items is not None:
            self._items.band.reset(QgsWkbTypes.GeometryType.PolygonGeometry)
            self._items.mark.hide()
            self._items.label.hide()

    def close(self) -> None:
        """Take everything off the canvas; a later ``show`` makes it anew."""
        items, self._items = self._items, None
        if items is None or sip.isdeleted(self._canvas):
            return  # nothing there, or gone with the canvas, which owns it all
        self._canvas.extentsChanged.disconnect(self._place_label)
        self._canvas.scene().removeItem(items.band)
        self._canvas.scene().removeItem(items.mark)
        items.label.hide()
        items.label.setParent(None)
        items.label.deleteLater()

    def _place_label(self) -> None:
        """Above the outline's upper left corner; below it where there is no room; always on the canvas."""
        if self._items is None:
            return
        label = self._items.label
        seen = _on_screen(self._canvas, self._outline)
        gap = max(2, label.fontMetrics().height() // 4)
        top = seen.top() - label.height() - gap
        if top < gap and seen.bottom() + 2 * gap + label.height() <= self._canvas.height():
            top = seen.bottom() + gap
        label.move(
            round(max(gap, min(seen.left(), self._canvas.width() - label.width() - gap))),
            round(max(gap, min(top, self._canvas.height() - label.height() - gap))),
        )


def _items(canvas: QgsMapCanvas) -> _Items:
    """The items, on the canvas and empty."""
    pixel = canvas.fontMetrics().height() / 16  # 1 at the usual font size
    band = QgsRubberBand(canvas, QgsWkbTypes.GeometryType.PolygonGeometry)
    band.setFillColor(QColor(0, 0, 0, 0))  # the image is what the operator looks at
    band.setSecondaryStrokeColor(_CASING)
    band.setWidth(max(2, round(2 * pixel)))
    mark = QgsVertexMarker(canvas)
    mark.setIconType(QgsVertexMarker.IconType.ICON_CIRCLE)
    mark.setIconSize(round(12 * pixel))
    mark.setPenWidth(max(2, round(2 * pixel)))
    mark.setColor(_MARK)
    label = QLabel(canvas)  # not of its viewport, which scrolls its children
    label.setIndent(0)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
    label.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    return _Items(band, mark, label)


def _write(label: QLabel, text: str, box: str, room: int) -> None:
    """Set a label's text and the colour of its box, and fit it to the text, within ``room`` pixels across."""
    metrics = label.fontMetrics()
    gap = max(2, metrics.height() // 5)
    style = f"color: white; background: {box}; border-radius: {gap}px; padding: {gap}px {2 * gap}px;"
    if label.styleSheet() != style:
        label.setStyleSheet(style)
    widest = min(metrics.averageCharWidth() * _LABEL_CHARACTERS, room - 6 * gap)
    lines = metrics.boundingRect(QRect(0, 0, widest, 9999), int(Qt.TextFlag.TextWordWrap), text)
    label.setWordWrap(lines.height() > 1.5 * metrics.height())
    label.setText(text)
    label.resize(lines.width() + 4 * gap + 2, lines.height() + 2 * gap + 2)


def _on_screen(canvas: QgsMapCanvas, rectangle: QgsRectangle) -> QRectF:
    """The canvas pixels of a rectangle on the map, which may be turned."""
    xs, ys = (rectangle.xMinimum(), rectangle.xMaximum()), (rectangle.yMinimum(), rectangle.yMaximum())
    to_pixel = canvas.getCoordinateTransform()
    return QPolygonF([to_pixel.transform(x, y).toQPointF() for x in xs for y in ys]).boundingRect()
