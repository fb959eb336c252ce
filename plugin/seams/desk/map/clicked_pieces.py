"""A click on a piece of a scanned seam: what the scan found there, its profile, and a window to judge it by."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from qgis.core import QgsFeatureRequest, QgsGeometry, QgsPointXY, QgsProject, QgsRectangle, QgsVectorLayer
from qgis.gui import QgsMapCanvas, QgsMapToolIdentify, QgsMapToolPan
from qgis.PyQt.QtCore import QEvent, QObject, QPoint, Qt, pyqtSignal

from ....imagery.errors import SeamInspectorError
from ....imagery.grids import PixelWindow
from ....toolkit.connections import Connections
from ....toolkit.desk.tool_dock import is_drag
from ....toolkit.layers import layer_path, transformed_point
from ...measure.window_records import SEAM, WindowRecord
from ...tables.record_tables import read_windows
from ...tables.scan_layers import SEAMS
from ..mosaic_scans import worst_layer
from .window_tool import clicked_window

if TYPE_CHECKING:
    from ..session import Session

_REACH_PX = 8  # screen pixels at 96 dpi, from a line


@dataclass(frozen=True)
class ClickedPiece:
    """The piece that was clicked."""

    record: WindowRecord  # what the scan found, as of a window
    window: PixelWindow  # the standard window around the click, which the charts are of


class ClickedPieces(QObject):
    """Follows clicks of the tools that pan and identify until ``close``."""

    changed = pyqtSignal()  # another piece is looked at, or none any more

    def __init__(
        self, canvas: QgsMapCanvas, session: Session, parent: QObject, is_blind: Callable[[], bool]
    ) -> None:
        super().__init__(parent)
        self._canvas, self._session, self._is_blind = canvas, session, is_blind
        self._pressed_at: QPoint | None = None
        self.current: ClickedPiece | None = None  # what is looked at
        canvas.viewport().installEventFilter(self)
        self._connections = Connections(
            (session.selectionChanged, self._follow_selection), (session.inputsChanged, self.leave)
        )

    def close(self) -> None:
        """Follow no clicks any more."""
        self._canvas.viewport().removeEventFilter(self)
        self._connections.close()

    def judge(self) -> bool:
        """Make the window, which is inspected and selected. Whether there is a piece."""
        piece = self.current
        self.leave()
        if piece is not None:
            self._session.add_window(piece.window)
        return piece is not None

    def leave(self) -> None:
        """No piece is looked at."""
        if self.current is not None:
            self.current = None
            self._session.leave()
            self.changed.emit()

    def eventFilter(self, _watched: QObject | None, event: QEvent | None) -> bool:
        """A click, whose tool has it as ever."""
        if event is not None and event.type() in (QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonRelease):
            is_ours = isinstance(self._canvas.mapTool(), (QgsMapToolPan, QgsMapToolIdentify))
            if event.button() == Qt.MouseButton.LeftButton and is_ours and not self._is_blind():
                if event.type() == QEvent.Type.MouseButtonPress:
                    self._pressed_at = event.pos()
                elif self._pressed_at is not None and not is_drag(self._pressed_at, event.pos()):
                    self._take(event.pos())
        return False

    def _take(self, place: QPoint) -> None:
        point = self._canvas.getCoordinateTransform().toMapCoordinates(place)
        piece, grid, mosaic = self._piece_at(point), self._session.mosaic_grid(), self._session.mosaic_layer()
        if piece is None or grid is None or mosaic is None:
            self.leave()
            return
        here = transformed_point(point, self._canvas.mapSettings().destinationCrs(), mosaic.crs())
        try:
            window = None if here is None else clicked_window(grid, (here.x(), here.y()), self._session.inputs)
        except SeamInspectorError:  # beside the mosaic, or where it has no room
            window = None
        if window is not None:
            self._session.select([])
            self.current = ClickedPiece(piece, window)
            self._session.hover(window, is_live=True)
            self.changed.emit()

    def _piece_at(self, point: QgsPointXY) -> WindowRecord | None:
        """The nearest piece of the mosaic's last scan, where the map shows it."""
        worst = worst_layer(QgsProject.instance(), self._session.inputs.mosaic)
        vectors = (vector for vector in self._canvas.layers() if isinstance(vector, QgsVectorLayer))
        shown = [vector for vector in vectors if worst is not None and layer_path(vector) == layer_path(worst)
                 and f"layername={SEAMS.name}" in vector.source()]  # fmt: skip
        if not shown:
            return None
        layer, map_crs = shown[0], self._canvas.mapSettings().destinationCrs()
        reach = _REACH_PX * self._canvas.logicalDpiX() / 96 * self._canvas.mapUnitsPerPixel()
        beside = QgsPointXY(point.x() + reach, point.y())
        here, there = (transformed_point(place, map_crs, layer.crs()) for place in (point, beside))
        if here is None or there is None:
            return None
        around, clicked = QgsRectangle(here, here).buffered(here.distance(there)), QgsGeometry.fromPointXY(here)
        request = QgsFeatureRequest(around).setFlags(QgsFeatureRequest.Flag.ExactIntersect)
        nearest = min(layer.getFeatures(request), key=lambda seam: seam.geometry().distance(clicked), default=None)
        if nearest is None:
            return None
        (row,) = read_windows([nearest], layer.fields().names())
        return replace(row, reference=SEAM)

    def _follow_selection(self) -> None:
        if self._session.selected():
            self.leave()

