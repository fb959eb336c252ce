"""Windows on the map: one is gone to, whether the operator sees it, and which are selected."""
from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from qgis.core import QgsCoordinateReferenceSystem, QgsPointXY, QgsRectangle
from qgis.gui import QgsMapCanvas

from ....imagery.grids import Grid
from ....toolkit.connections import Connections
from ....toolkit.layers import transformed_box

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
            crs = self._canvas.mapSettings().destinationCrs()
            shown = transformed_box(views[self._looked[1]], self._crs(), crs)
            if shown is not None:
                self._canvas.setExtent(shown)
                self._canvas.refresh()
        self._session.select([fid])

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
        from ...measure.judgement.greatest_loss import worst_places

        result = self._session.result(fid)
        if result is None or result.window is None or result.loss is None:
            return []
        left, _, _, top = grid.window_extent(result.window)
        places = worst_places(result.loss, self._is_blind())
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
        view = transformed_box(settings.visibleExtent(), settings.destinationCrs(), self._crs())
        if grid is None or place is None or view is None:
            return True  # nothing leads there
        shown, least = view.intersect(place), _LEAST_SHOWN * min(_area(place), _area(view))
        return bool(self._canvas.width() * grid.pixel_width >= least_pixels * view.width() and _area(shown) >= least)

    def _place(self, fid: int) -> QgsRectangle | None:
        row, layer = self._session.row(fid), self._session.window_layer()
        if row is None or row.extent is None or layer is None:
            return None
        return transformed_box(QgsRectangle(*row.extent), layer.crs(), self._crs())

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
