"""Windows on the map: one is gone to, whether it is seen, which are selected, and an outline with its label."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCsException,
    QgsGeometry,
    QgsPointXY,
    QgsProject,
    QgsRectangle,
    QgsVectorLayer,
    QgsWkbTypes,
)
from qgis.gui import QgsMapCanvas, QgsRubberBand, QgsVertexMarker
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QRect, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QPolygonF
from qgis.PyQt.QtWidgets import QLabel

from ....imagery.errors import WindowError
from ....imagery.grids import Grid
from ....toolkit.connections import Connections
from ....toolkit.layers import transformed_place
from ....toolkit.reference_systems import transformation

if TYPE_CHECKING:
    from ..session import Session

_SCREEN_PIXELS = 2  # per image pixel: the paper's best viewing scale
_LEAST_PIXELS = 0.9  # the same for a window to be seen; rounded, and turned maps show some more
_LEAST_SHOWN = 0.5  # of the window, or of the map where the window is larger


class WindowView:
    """In the mosaic's reference system, in whose pixels windows are seen."""

    def __init__(self, canvas: QgsMapCanvas, session: Session, is_blind: Callable[[], bool] = lambda: False) -> None:
        """``is_blind``: whether it is hidden where detail was lost."""
        self._canvas, self._session, self._is_blind = canvas, session, is_blind
        self._looked = 0, 0  # the window that was gone to last, and which of its places

    def show(self, fid: int, place: int = 0) -> None:
        """Select a window and show it so that one image pixel covers 2 x 2 screen pixels: all of it where there is
        room, else one of the places that lost most, the worst first.
        """
        views = self.views(fid)
        if views:
            self._looked = fid, place % len(views)
            self._go(views[self._looked[1]], self._crs())
        self._session.select([fid])

    def show_layer(self, layer: QgsVectorLayer) -> None:
        """All of a layer, and a margin."""
        box = layer.extent()
        self._go(box.buffered(max(box.width(), box.height()) / 10), layer.crs())

    def _go(self, box: QgsRectangle, crs: QgsCoordinateReferenceSystem) -> None:
        shown = transformed_place(box, crs, self._canvas.mapSettings().destinationCrs())
        if shown is not None:
            self._canvas.setExtent(shown)
            self._canvas.refresh()

    def show_next_place(self) -> bool:
        """The next place of the selected window, after the last one the first. Whether a window is selected."""
        fids = self._session.selected()
        if len(fids) == 1:
            fid, place = self._looked
            self.show(fids[0], place + 1 if fids[0] == fid and self.is_seen(fid) else 0)
        return len(fids) == 1

    def views(self, fid: int) -> list[QgsRectangle]:
        """What can be shown of a window, in the mosaic's reference system; no two are the same."""
        grid, whole = self._session.mosaic_grid(), self._place(fid)
        if grid is None or whole is None:
            return []
        width = self._canvas.width() / _SCREEN_PIXELS * grid.pixel_width
        height = self._canvas.height() / _SCREEN_PIXELS * grid.pixel_height
        views = []
        for x, y in self._worst_places(fid, grid) or [(whole.center().x(), whole.center().y())]:
            middle = QgsPointXY(
                _within(x, whole.xMinimum(), whole.xMaximum(), width),
                _within(y, whole.yMinimum(), whole.yMaximum(), height),
            )
            view = QgsRectangle.fromCenterAndSize(middle, width, height)
            if view not in views:
                views.append(view)
        return views

    def _worst_places(self, fid: int, grid: Grid) -> list[tuple[float, float]]:
        """In the mosaic's reference system; empty where it is not known where detail was lost, or not to be told."""
        from ...measure.judgement.visibility import worst_places

        result = self._session.result(fid)
        if result is None or result.window is None or result.loss is None:
            return []
        left, _, _, top = grid.window_extent(result.window)
        places = worst_places(result.loss, result.loss_place.is_decisive, self._is_blind())
        return [(left + column * grid.pixel_width, top - row * grid.pixel_height) for column, row in places]

    def follow(self) -> None:
        """Go to the window that is selected, if the map does not show it, small as it may be."""
        fids = self._session.selected()
        if len(fids) == 1 and not self._shows(fids[0], 0):
            self.show(fids[0])

    def is_seen(self, fid: int) -> bool:
        """Whether the map shows most of a window, or is full of it, pixel by pixel."""
        return self._shows(fid, _LEAST_PIXELS)

    def _shows(self, fid: int, least_pixels: float) -> bool:
        """``least_pixels`` of the screen for one of the image."""
        grid, place, settings = self._session.mosaic_grid(), self._place(fid), self._canvas.mapSettings()
        view = transformed_place(settings.visibleExtent(), settings.destinationCrs(), self._crs())
        if grid is None or place is None or view is None:
            return True  # nothing leads there
        shown, least = view.intersect(place), _LEAST_SHOWN * min(_area(place), _area(view))
        return bool(self._canvas.width() * grid.pixel_width >= least_pixels * view.width() and _area(shown) >= least)

    def _place(self, fid: int) -> QgsRectangle | None:
        row, layer = self._session.row(fid), self._session.window_layer()
        if row is None or row.extent is None or layer is None:
            return None
        return transformed_place(QgsRectangle(*row.extent), layer.crs(), self._crs())

    def _crs(self) -> QgsCoordinateReferenceSystem:
        layer = self._session.mosaic_layer()
        return QgsCoordinateReferenceSystem() if layer is None else layer.crs()


def _within(middle: float, low: float, high: float, size: float) -> float:
    """The middle of a view of that size that does not look beyond a window from ``low`` to ``high``, or that has all
    of it in its middle."""
    return (low + high) / 2 if high - low <= size else min(max(middle, low + size / 2), high - size / 2)


def _area(box: QgsRectangle) -> float:
    return 0.0 if box.isEmpty() else box.width() * box.height()


SELECTED = "seam_inspector_selected"
"""Map variable: its keys are a layer's id and a feature's, with a space between (resources/styles/windows.qml)."""


class SelectedWindows:
    """Keeps the variable until ``close``.

    The style does not ask ``is_selected()``: that looks into the layer from the threads that draw the map, and QGIS
    before 3.30 crashes when another window is selected, or the layer goes, while they do.
    """

    def __init__(self, canvas: QgsMapCanvas, session: Session) -> None:
        self._canvas, self._session = canvas, session
        # After a change of windows as well: another layer may have equal ids.
        self._connections = Connections((session.selectionChanged, self._tell), (session.windowsChanged, self._tell))
        self._tell()

    def close(self) -> None:
        """Take the variable away."""
        self._connections.close()
        self._canvas.expressionContextScope().removeVariable(SELECTED)

    def _tell(self) -> None:
        layer = self._session.window_layer()
        keys = {f"{layer.id()} {fid}": True for fid in self._session.selected()} if layer is not None else {}
        self._canvas.expressionContextScope().setVariable(SELECTED, keys)


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
