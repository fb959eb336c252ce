"""Where the seam of the judged window enters what is seen of it: ticks at the edge, as a line would hide it."""
from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from qgis.core import QgsPointXY
from qgis.gui import QgsMapCanvas, QgsMapCanvasItem
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QPointF, QRectF
from qgis.PyQt.QtGui import QColor, QPainter, QPen, QPolygonF

from ....toolkit.layers import transformed_point

if TYPE_CHECKING:
    import numpy as np

    from ..session import Session

_FILL, _EDGE = QColor("#00e5ff"), QColor(0, 0, 0, 200)  # as the lost detail's distances: no colour of a verdict
_APART = 3  # samples without the seam between two crossings


class Tick(NamedTuple):
    """Where a seam crosses an edge, px of the screen, and the way inwards."""

    column: float
    row: float
    inwards: tuple[int, int]


def seam_ticks(places: np.ndarray, box: tuple[float, float, float, float], reach: float) -> list[Tick]:
    """On the edges of a box (left, top, right, bottom), px of the screen.

    ``places``: (n, 2), column and row of the middles of the squares in which sources meet; they ``reach`` so far.
    """
    import numpy as np

    left, top, right, bottom = box
    columns, rows = places.T if len(places) else (np.empty(0), np.empty(0))
    inside = (columns >= left) & (columns <= right) & (rows >= top) & (rows <= bottom)
    found = []
    for across, along, edge, inwards in (
        (columns, rows, left, (1, 0)), (columns, rows, right, (-1, 0)),
        (rows, columns, top, (0, 1)), (rows, columns, bottom, (0, -1)),
    ):  # fmt: skip
        hits = np.sort(along[inside & (np.abs(across - edge) <= reach)])
        for part in np.split(hits, np.flatnonzero(np.diff(hits) > _APART * reach) + 1):
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
        """Show the ticks of a window; None: of none."""
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
        import numpy as np

        from ...measure.profile.window_detail import SAMPLE_PX

        grid, layer = self._session.mosaic_grid(), self._session.mosaic_layer()
        result = None if self._fid is None else self._session.result(self._fid)
        if grid is None or layer is None or result is None or result.window is None or result.loss is None:
            return []
        window, to_screen = result.window, self._canvas.getCoordinateTransform()
        left, _, _, top = grid.window_extent(window)
        corners = []
        for column, row in ((0, 0), (window.width, 0), (0, window.height)):
            corner = QgsPointXY(left + column * grid.pixel_width, top - row * grid.pixel_height)
            on_map = transformed_point(corner, layer.crs(), self._canvas.mapSettings().destinationCrs())
            if on_map is None:
                return []
            corners.append(to_screen.transform(on_map))
        # Of a window that small what its reference system and a rotated map make of it is affine.
        origin, right, down = (np.array([corner.x(), corner.y()]) for corner in corners)
        sides = np.stack([right - origin, down - origin])
        axes = sides / [[window.width], [window.height]]
        outline = np.stack([origin, right, down, origin + sides.sum(axis=0)])
        low, high = outline.min(axis=0), outline.max(axis=0)
        seen = self._canvas.width(), self._canvas.height()
        box = max(low[0], 0.0), max(low[1], 0.0), min(high[0], seen[0]), min(high[1], seen[1])
        places = origin + (result.loss.seam[:, ::-1] + 0.5) * SAMPLE_PX @ axes
        ticks = seam_ticks(places, box, SAMPLE_PX * float(np.hypot(*axes.T).max()))
        return [(to_screen.toMapCoordinates(round(tick.column), round(tick.row)), tick.inwards) for tick in ticks]
