"""A window on the map: it is gone to, and whether the operator sees it."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsCoordinateReferenceSystem, QgsRectangle
from qgis.gui import QgsMapCanvas

from ....toolkit.layers import transformed_box

if TYPE_CHECKING:
    from ..session import Session

_SCREEN_PIXELS = 2  # per image pixel: the paper's best viewing scale
_LEAST_PIXELS = 0.9  # the same for a window to be seen; rounded, and turned maps show some more
_LEAST_SHOWN = 0.5  # of the window, or of the map where the window is larger


class WindowView:
    """In the mosaic's reference system, in whose pixels windows are seen."""

    def __init__(self, canvas: QgsMapCanvas, session: Session) -> None:
        self._canvas, self._session = canvas, session

    def show(self, fid: int) -> None:
        """Select a window and show it so that one image pixel covers 2 x 2 screen pixels."""
        grid, place = self._session.mosaic_grid(), self._place(fid)
        if grid is not None and place is not None:
            width = self._canvas.width() / _SCREEN_PIXELS * grid.pixel_width
            height = self._canvas.height() / _SCREEN_PIXELS * grid.pixel_height
            view = QgsRectangle.fromCenterAndSize(place.center(), width, height)
            shown = transformed_box(view, self._crs(), self._canvas.mapSettings().destinationCrs())
            if shown is not None:
                self._canvas.setExtent(shown)
                self._canvas.refresh()
        self._session.select([fid])

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


def _area(box: QgsRectangle) -> float:
    return 0.0 if box.isEmpty() else box.width() * box.height()
