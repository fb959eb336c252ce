"""Clicks on the map: the tool that places windows, and pieces of a scanned seam, which other tools click."""
from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeatureRequest,
    QgsGeometry,
    QgsPointXY,
    QgsProject,
    QgsRectangle,
    QgsVectorLayer,
    QgsWkbTypes,
)
from qgis.gui import QgsMapCanvas, QgsMapMouseEvent, QgsMapToolIdentify, QgsMapToolPan, QgsRubberBand
from qgis.PyQt.QtCore import QEvent, QObject, QPoint, Qt, pyqtSignal
from qgis.PyQt.QtGui import QKeyEvent

from ....imagery import limits as imagery_limits
from ....imagery import messages as imagery_messages
from ....imagery.errors import SeamInspectorError, WindowError
from ....imagery.grids import Extent, Grid, PixelWindow, snap_window, standard_window
from ....imagery.open_raster import OpenRaster
from ....imagery.seam_totals import profile_of
from ....toolkit.connections import Connections
from ....toolkit.desk.tool_dock import DrawingTool, is_drag
from ....toolkit.layers import layer_path, transformed_place
from ....toolkit.table_fields import text
from ....toolkit.translation import filled, sentence, shown_metres, tr
from ...charts.profile_painter import shown_profile
from ...measure import messages
from ...measure.planning.window_placing import fitting_window, window_side_px
from ...measure.window_records import SEAM, ProfileRecord, WindowRecord
from ...tables.record_tables import read_windows
from ...tables.scan_layers import SEAMS
from ..mosaic_scans import worst_layer
from .under_mouse import ClickedPiece
from .window_view import OutlineTone, WindowOutline

if TYPE_CHECKING:
    from ..inputs.project_inputs import Inputs
    from ..session import Session

_SEAM_REACH_PX = 12  # screen pixels at 96 dpi

Point = tuple[float, float]


@dataclass(frozen=True)
class _Draft:
    """What a click or the end of a drag would make here, in the mosaic's reference system."""

    extent: Extent  # the window's pixels, or what was drawn when it can't be a window
    window: PixelWindow | None
    text: str
    tone: OutlineTone
    seam_point: Point | None = None


class WindowTool(DrawingTool):
    """Click: the window that is there, else a new standard one, on the seam when one is near. Drag: a new rectangle.

    Shift and a click add a window to the selection or take it out, as in QGIS's own tools; Ctrl and a click make a new
    one where there is one already. Esc cancels a drag, the right button ends. Middle button, wheel and Space move the
    map as ever: the canvas keeps these to itself, and no flag of this tool (zooming by Shift and drag, context menu)
    takes the others.
    """

    def __init__(self, canvas: QgsMapCanvas, session: Session) -> None:
        super().__init__(canvas)
        self._session = session
        self._overlay = WindowOutline(canvas)
        self._pressed_at: QPoint | None = None
        self._anchor: Point | None = None  # where the drag began, on the mosaic
        self._is_drag = False
        self._is_new = False  # by Ctrl, where there is a window already
        self._cursor: QgsPointXY | None = None  # on the map; None while it is elsewhere

    def _listen(self) -> None:
        super()._listen()
        self.canvas().viewport().installEventFilter(self)
        self._session.inputsChanged.connect(self._show_draft)
        self._session.liveChanged.connect(self._show_draft)

    def _listen_no_more(self) -> None:
        super()._listen_no_more()
        self.canvas().viewport().removeEventFilter(self)
        self._session.inputsChanged.disconnect(self._show_draft)
        self._session.liveChanged.disconnect(self._show_draft)

    def _clear(self) -> None:
        self._forget()
        self._overlay.close()

    def canvasPressEvent(self, event: QgsMapMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._pressed_at = event.pixelPoint()
            self._anchor = self._on_mosaic(event.mapPoint())
            self._is_drag = False

    def canvasMoveEvent(self, event: QgsMapMouseEvent) -> None:
        self._follow(event)
        self._show_draft()

    def canvasReleaseEvent(self, event: QgsMapMouseEvent) -> None:
        if event.button() == Qt.MouseButton.RightButton:
            if self._pressed_at is not None:  # to end here would give the other button's release to the next tool
                self._forget()
            else:
                self.finished.emit()
        elif event.button() == Qt.MouseButton.LeftButton and self._pressed_at is not None:
            self._follow(event)
            there = self._window_there()
            if there is not None:
                self._forget()
                is_added = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
                self._session.select(sorted({*self._session.selected()} ^ {there.fid}) if is_added else [there.fid])
                return
            draft = self._draft()
            if draft is not None and draft.window is not None:
                self._forget()
                self._session.add_window(draft.window)
            else:
                self._show_draft()
                self._end_drag()

    def eventFilter(self, _watched: QObject | None, event: QEvent | None) -> bool:
        """Clear the map when the cursor leaves it: an outline left behind looks like a window."""
        if event is not None and event.type() == QEvent.Type.Leave and self._pressed_at is None:
            self._forget()
        return False

    def _key_pressed(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and self._pressed_at is not None:
            event.accept()
            self._forget()

    def _follow(self, event: QgsMapMouseEvent) -> None:
        self._cursor = event.mapPoint()
        self._is_new = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        if self._pressed_at is not None:
            self._is_drag = self._is_drag or is_drag(self._pressed_at, event.pixelPoint())

    def _end_drag(self) -> None:
        self._pressed_at = self._anchor = None
        self._is_drag = False

    def _forget(self) -> None:
        self._end_drag()
        self._cursor = None
        self._overlay.hide()
        self._session.leave()

    def _window_there(self) -> WindowRecord | None:
        """The window that a click would select."""
        layer = self._session.window_layer()
        if layer is None or self._cursor is None or self._is_drag or self._is_new:
            return None
        map_crs = self.canvas().mapSettings().destinationCrs()
        return window_under(self._session.windows(), layer, self._cursor, map_crs)

    def _show_draft(self) -> None:
        """Draw what a click, or the end of the drag, would make at the cursor."""
        there, windows = self._window_there(), self._session.window_layer()
        if there is not None and there.extent is not None and windows is not None:
            text = filled(tr("window {number}: click selects it, drag draws another"), number=there.window_id)
            self._overlay.show(QgsRectangle(*there.extent), text, windows.crs())
            self._session.leave()
            return
        draft, layer = self._draft(), self._session.mosaic_layer()
        if draft is not None and layer is not None:
            mark = QgsPointXY(*draft.seam_point) if draft.seam_point is not None else None
            self._overlay.show(QgsRectangle(*draft.extent), draft.text, layer.crs(), draft.tone, mark)
        elif self._cursor is not None:  # beside the cursor
            text = sentence(self._session.problem() or imagery_messages.WINDOW_OUTSIDE())
            self._overlay.show(QgsRectangle(self._cursor, self._cursor), text, tone=OutlineTone.REFUSED)
        if draft is not None and draft.window is not None:
            self._session.hover(draft.window, is_live=self._is_drag or draft.seam_point is not None)
        else:
            self._session.leave()

    def _draft(self) -> _Draft | None:
        """None without mosaic, or where the map has no place on it."""
        grid, layer = self._session.mosaic_grid(), self._session.mosaic_layer()
        point = self._on_mosaic(self._cursor) if self._cursor is not None else None
        if grid is None or layer is None or self._cursor is None or point is None:
            return None
        if self._is_drag and self._anchor is not None:
            (x1, x2), (y1, y2) = (sorted(pair) for pair in zip(self._anchor, point))
            extent = x1, y1, x2, y2
            try:
                return self._accepted(grid, snap_window(grid, extent, self._session.inputs.levels))
            except WindowError as error:
                return _Draft(extent, None, sentence(error.message), OutlineTone.REFUSED)
        reach = reach_of(self.canvas(), self._cursor, _SEAM_REACH_PX, layer.crs())
        seam_point = self._session.seam_point_near(*point, reach)
        centre = seam_point or point
        try:
            return self._accepted(grid, clicked_window(grid, centre, self._session.inputs), seam_point)
        except SeamInspectorError as error:
            return _Draft((*centre, *centre), None, sentence(error.message), OutlineTone.REFUSED)

    def _accepted(self, grid: Grid, window: PixelWindow, seam_point: Point | None = None) -> _Draft:
        block = self._session.block()
        sources = 0 if block is None else len(block.sources_over(window))
        is_useless = self._session.is_useless(window)
        tone = OutlineTone.DOUBTFUL if is_useless or not sources else OutlineTone.GOOD
        width, height = window.width * grid.pixel_width, window.height * grid.pixel_height
        spans = {"width": shown_metres(width * grid.metres_x), "height": shown_metres(height * grid.metres_y)}
        text = tr("{width} x {height} m, {columns} x {rows} px")
        if not sources:
            text = tr("{width} x {height} m, {columns} x {rows} px, no source lies there")
        elif is_useless:
            text = tr("{width} x {height} m, {columns} x {rows} px, nothing can be compared there")
        text = filled(text, **spans, columns=window.width, rows=window.height)
        return _Draft(grid.window_extent(window), window, text, tone, seam_point)

    def _on_mosaic(self, point: QgsPointXY) -> Point | None:
        """A point of the map in the mosaic's reference system; None when it has no place there."""
        layer = self._session.mosaic_layer()
        if layer is None:
            return None
        place = transformed_place(point, self.canvas().mapSettings().destinationCrs(), layer.crs())
        return (place.x(), place.y()) if place is not None else None


def reach_of(canvas: QgsMapCanvas, point: QgsPointXY, pixels: int, crs: QgsCoordinateReferenceSystem) -> float:
    """How far so many pixels of a screen of 96 dpi reach beside a point of the map, in a system's units; 0 where that
    has no such place."""
    map_crs = canvas.mapSettings().destinationCrs()
    beside = QgsPointXY(point.x() + pixels * canvas.logicalDpiX() / 96 * canvas.mapUnitsPerPixel(), point.y())
    here, there = (transformed_place(place, map_crs, crs) for place in (point, beside))
    return 0.0 if here is None or there is None else float(here.distance(there))


def clicked_window(grid: Grid, centre: Point, inputs: Inputs) -> PixelWindow:
    """The standard window around a point, moved into the grid where it would stick out.

    Raises SettingsError when the side is too short for the levels, WindowError when the point lies outside the
    grid or the grid is too small for the side.
    """
    side_px = window_side_px(grid, inputs.placing)
    xmin, ymin, xmax, ymax = grid.extent
    if not (xmin <= centre[0] <= xmax and ymin <= centre[1] <= ymax):
        raise WindowError(imagery_messages.WINDOW_OUTSIDE())
    if side_px > min(grid.columns, grid.rows):
        metres_x, metres_y = grid.pixel_width * grid.metres_x, grid.pixel_height * grid.metres_y
        width, height, side = grid.columns * metres_x, grid.rows * metres_y, side_px * max(metres_x, metres_y)
        raise WindowError(messages.MOSAIC_TOO_SMALL(width=width, height=height, side=side))
    if side_px * side_px > imagery_limits.MAX_WINDOW_PIXELS:
        most = imagery_limits.MAX_WINDOW_PIXELS // 1_000_000
        raise WindowError(imagery_messages.WINDOW_TOO_LARGE(width=side_px, height=side_px, most=most))
    return standard_window(grid, *centre, side_px).moved_into(grid.columns, grid.rows)


def window_under(
    windows: Iterable[WindowRecord], layer: QgsVectorLayer, point: QgsPointXY, crs: QgsCoordinateReferenceSystem
) -> WindowRecord | None:
    """The window of a layer under a point; of several the one whose middle is nearest. None where there is none."""
    here = transformed_place(point, crs, layer.crs())
    if here is None:
        return None
    x, y = here.x(), here.y()
    under = [(at, row) for row in windows if (at := row.extent) and at[0] <= x <= at[2] and at[1] <= y <= at[3]]
    return min(under, key=lambda held: QgsRectangle(*held[0]).center().sqrDist(here), default=(None, None))[1]


_REACH_PX = 8  # screen pixels at 96 dpi, from a line
_MARK_PX = 5


class ClickedPieces(QObject):
    """Follows clicks of the tools that pan and identify until ``close``, and marks the piece that is looked at."""

    changed = pyqtSignal()  # another piece is looked at, or none any more

    def __init__(
        self, canvas: QgsMapCanvas, session: Session, parent: QObject, is_blind: Callable[[], bool]
    ) -> None:
        super().__init__(parent)
        self._canvas, self._session, self._is_blind = canvas, session, is_blind
        self._pressed_at: QPoint | None = None
        self._mark = QgsRubberBand(canvas, QgsWkbTypes.GeometryType.LineGeometry)
        self._mark.setColor(canvas.selectionColor())
        self._mark.setWidth(_MARK_PX)
        canvas.viewport().installEventFilter(self)
        self._connections = Connections(
            (session.selectionChanged, self._follow_selection), (session.inputsChanged, self.leave),
            (canvas.mapToolSet, self.leave), (self.changed, session.liveChanged.emit),
        )

    def close(self) -> None:
        """Follow no clicks any more."""
        self._canvas.viewport().removeEventFilter(self)
        self._connections.close()
        self._canvas.scene().removeItem(self._mark)

    def judge(self) -> bool:
        """Select a window that holds the place, or make one, which is inspected; where none can be made the piece stays
        in view. Whether there is a piece."""
        piece = self._session.piece
        if piece is None:
            return False
        layer, mosaic = self._session.window_layer(), self._session.mosaic_layer()
        rows = [row for row in self._session.windows() if row.is_compared or not row.verdict]
        there = None
        if layer is not None and mosaic is not None:
            there = window_under(rows, layer, piece.place, mosaic.crs())
        if there is None:
            self._session.add_window(piece.window)
        else:
            self._session.select([there.fid])
        return True

    def leave(self, *_: object) -> None:
        """No piece is looked at."""
        if self._session.piece is not None:
            self._session.piece = None
            self._mark.reset(QgsWkbTypes.GeometryType.LineGeometry)
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
        clicked, block, mosaic = self._piece_at(point), self._session.block(), self._session.mosaic_layer()
        map_crs = self._canvas.mapSettings().destinationCrs()
        here = None if mosaic is None else transformed_place(point, map_crs, mosaic.crs())
        if clicked is None or block is None or here is None:
            self.leave()
            return
        (piece, outline, layer), grid = clicked, block.mosaic.grid
        try:
            window = clicked_window(grid, (here.x(), here.y()), self._session.inputs)
            is_valid = OpenRaster(block.mosaic.ref).is_valid  # where no window is, the standard one says so
            window = fitting_window(here.x(), here.y(), grid, window.width, is_valid) or window
        except SeamInspectorError:  # beside the mosaic, or where it has no room
            return
        strips = [
            ProfileRecord(1, (strip.near_m + strip.far_m) / 2, strip.kept, strip.kept, strip.kept)
            for strip in profile_of(str(piece.others["profile"]))[1:]  # without the judged strip
        ]
        profile = shown_profile(piece, strips, grid.ground_sample_distance, self._session.inputs.min_kept)
        self._session.select([])
        self._session.piece = ClickedPiece(piece, window, profile, here)
        self._mark.setToGeometry(outline, layer)
        self._session.leave()  # the window of a piece before
        self._session.hover(window, is_live=True)
        self.changed.emit()

    def _piece_at(self, point: QgsPointXY) -> tuple[WindowRecord, QgsGeometry, QgsVectorLayer] | None:
        """The nearest piece of the mosaic's last scan, where the map shows it, its line and their layer."""
        worst = worst_layer(QgsProject.instance(), self._session.inputs.mosaic)
        vectors = (vector for vector in self._canvas.layers() if isinstance(vector, QgsVectorLayer))
        shown = [vector for vector in vectors if worst is not None and layer_path(vector) == layer_path(worst)
                 and f"layername={SEAMS.name}" in vector.source()]  # fmt: skip
        if not shown:
            return None
        layer, map_crs = shown[0], self._canvas.mapSettings().destinationCrs()
        here = transformed_place(point, map_crs, layer.crs())
        if here is None:
            return None
        reach, clicked = reach_of(self._canvas, point, _REACH_PX, layer.crs()), QgsGeometry.fromPointXY(here)
        request = QgsFeatureRequest(QgsRectangle(here, here).buffered(reach))
        request.setFlags(QgsFeatureRequest.Flag.ExactIntersect)
        nearest = min(layer.getFeatures(request), key=lambda seam: seam.geometry().distance(clicked), default=None)
        if nearest is None:
            return None
        names = layer.fields().names()
        (row,) = read_windows([nearest], names)
        profile = text(nearest["profile"]) if "profile" in names else ""
        return replace(row, reference=SEAM, others={"profile": profile}), nearest.geometry(), layer

    def _follow_selection(self) -> None:
        if self._session.selected():
            self.leave()
