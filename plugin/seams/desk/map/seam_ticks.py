"""Where the seam of the judged window enters what is seen of it: ticks at the edge, as a line would hide it."""
from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from qgis.core import QgsPointXY
from qgis.gui import QgsMapCanvas, QgsMapCanvasItem
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QPointF, QRectF
from qgis.PyQt.QtGui import QColor, QPainter, QPen, QPolygonF

from ....toolkit.layers import transformed_box, transformed_point

if TYPE_CHECKING:
    import numpy as np

    from ..session import Session

_FILL, _EDGE = QColor("#00e5ff"), QColor(0, 0, 0, 200)  # as the lost detail's distances: no colour of a verdict
_APART = 3  # samples without the seam between two crossings


class Tick(NamedTuple):
    """Where a seam crosses an edge, px, and the way inwards."""

    column: float
    row: float
    inwards: tuple[int, int]


def seam_ticks(seam: np.ndarray, box: tuple[float, float, float, float], sample_px: int) -> list[Tick]:
    """On the edges of a box (left, top, right, bottom), px from the window's upper left.

    ``seam``: (n, 2), row and column of the squares of ``sample_px`` in which sources meet.
    """
    import numpy as np

    left, top, right, bottom = box
    rows, columns = ((seam + 0.5) * sample_px).T if len(seam) else (np.empty(0), np.empty(0))
    inside = (columns >= left) & (columns <= right) & (rows >= top) & (rows <= bottom)
    found = []
    for across, along, edge, inwards in (
        (columns, rows, left, (1, 0)), (columns, rows, right, (-1, 0)),
        (rows, columns, top, (0, 1)), (rows, columns, bottom, (0, -1)),
    ):  # fmt: skip
        hits = np.sort(along[inside & (np.abs(across - edge) <= sample_px)])
        for part in np.split(hits, np.flatnonzero(np.diff(hits) > _APART * sample_px) + 1):
            if len(part):
                place = float(part.mean())
                found.append(Tick(edge, place, inwards) if inwards[0] else Tick(place, edge, inwards))
    return found


class _TicksItem(QgsMapCanvasItem):
    """Paints triangles that point inwards."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self.ticks: list[tuple[QgsPointXY, tuple[int, int]]] = []
        """On the map."""
        self._side = canvas.fontMetrics().height()

    def boundingRect(self) -> QRectF:
        width, height = self._canvas.width(), self._canvas.height()  # and as much around while the map is dragged
        return QRectF(-width, -height, 3 * width, 3 * height)

    def paint(self, painter: QPainter, *_: object) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(_EDGE, 1.5))
        painter.setBrush(_FILL)
        for point, (right, down) in self.ticks:
            foot, half = self.toCanvasCoordinates(point), self._side / 3
            tip = foot + self._side * QPointF(right, down)
            beside = half * QPointF(down, right)
            painter.drawPolygon(QPolygonF([foot + beside, tip, foot - beside]))


class SeamTicks:
    """The one owner of them on the canvas, until ``close``."""

    def __init__(self, canvas: QgsMapCanvas, session: Session) -> None:
        self._canvas, self._session = canvas, session
        self._item = _TicksItem(canvas)
        self._fid: int | None = None
        canvas.extentsChanged.connect(self._follow)

    def show(self, fid: int | None) -> None:
        """Of a window; None: of none."""
        self._fid = fid
        self._follow()

    def close(self) -> None:
        """Take them off the canvas."""
        if not sip.isdeleted(self._canvas):
            self._canvas.extentsChanged.disconnect(self._follow)
            self._canvas.scene().removeItem(self._item)

    def ticks(self) -> list[tuple[QgsPointXY, tuple[int, int]]]:
        """On the map, each with the way inwards on the screen."""
        return self._item.ticks

    def _follow(self) -> None:
        self._item.ticks = self._found()
        self._item.update()

    def _found(self) -> list[tuple[QgsPointXY, tuple[int, int]]]:
        from ...measure.profile.window_detail import SAMPLE_PX

        grid, layer = self._session.mosaic_grid(), self._session.mosaic_layer()
        result = None if self._fid is None else self._session.result(self._fid)
        if grid is None or layer is None or result is None or result.window is None or result.loss is None:
            return []
        window, settings = result.window, self._canvas.mapSettings()
        view = transformed_box(settings.visibleExtent(), settings.destinationCrs(), layer.crs())
        if view is None:
            return []
        left, _, _, top = grid.window_extent(window)
        box = (
            max((view.xMinimum() - left) / grid.pixel_width, 0.0),
            max((top - view.yMaximum()) / grid.pixel_height, 0.0),
            min((view.xMaximum() - left) / grid.pixel_width, window.width),
            min((top - view.yMinimum()) / grid.pixel_height, window.height),
        )  # fmt: skip
        found = []
        for tick in seam_ticks(result.loss.seam, box, SAMPLE_PX):
            place = QgsPointXY(left + tick.column * grid.pixel_width, top - tick.row * grid.pixel_height)
            on_map = transformed_point(place, layer.crs(), settings.destinationCrs())
            if on_map is not None:
                found.append((on_map, tick.inwards))
        return found
