"""The pictures of lost detail over the map, and their legend, while they are switched on."""
from __future__ import annotations

import time
from dataclasses import dataclass
from typing import TYPE_CHECKING

from qgis.core import QgsCoordinateReferenceSystem
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtGui import QImage

from ....imagery.grids import Grid, PixelWindow
from ....toolkit.desk.widgets import single_shot
from ...loss_colours import LOSS_OPACITY, loss_rgba
from .loss_legend import LossLegend
from .picture_overlay import PictureOverlay, PlacedPicture, rgba_image

if TYPE_CHECKING:
    from ...measure.window.window_result import WindowResult
    from ...measure.window_records import WindowRecord
    from ..session import Session

_TOGETHER_MS = 100  # windows that come within this time are painted once
_SLICE_S = 0.05  # of reading results, which of thousands of windows are in a file; then the operator has a turn


@dataclass(frozen=True)
class _Picture:
    """Of one window's result."""

    of: tuple[object, ...]
    """What was measured in the window, as its row says."""
    image: QImage | None
    """None where nothing is to be painted."""
    window: PixelWindow | None
    cell_px: int
    """Side of an image's pixel, in pixels of the mosaic; 0 where the loss can't be told."""


class LossOverlay(QObject):
    """Follows the session; owns all that it puts on the canvas until ``close``."""

    def __init__(self, canvas: QgsMapCanvas, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._overlay = PictureOverlay(canvas, opacity=LOSS_OPACITY)
        self._legend = LossLegend(canvas)
        self._pictures: dict[int, _Picture] = {}  # by window number
        self._timer = single_shot(self, self._refresh, _TOGETHER_MS)
        self._next_slice = single_shot(self, self._refresh)
        session.resultArrived.connect(self._forget)
        self._signals = (session.resultArrived, session.windowsChanged, session.inputsChanged)
        for signal in self._signals:
            signal.connect(self._refresh_soon)
        session.loss_view.changed.connect(self._refresh)

    @property
    def pictures(self) -> tuple[PlacedPicture, ...]:
        """What lies over the map."""
        return self._overlay.pictures

    def close(self) -> None:
        """Take all off the canvas and follow the session no more."""
        for signal in self._signals:
            signal.disconnect(self._refresh_soon)
        self._session.resultArrived.disconnect(self._forget)
        self._session.loss_view.changed.disconnect(self._refresh)
        self._timer.stop()
        self._next_slice.stop()
        self._overlay.close()
        self._legend.close_legend()

    def _refresh_soon(self, *_: object) -> None:
        if self._session.loss_view.is_shown and not self._timer.isActive():
            self._timer.start()

    def _forget(self, fid: int) -> None:
        """The window was measured anew."""
        row = self._session.row(fid)
        if row is not None:
            self._pictures.pop(row.window_id, None)

    def _refresh(self, *_: object) -> None:
        layer, grid = self._session.mosaic_layer(), self._session.mosaic_grid()
        if not self._session.loss_view.is_shown or layer is None or grid is None:
            self._pictures.clear()
            self._overlay.hide()
            self._legend.hide()
            return
        end, is_late = time.perf_counter() + _SLICE_S, False
        found: dict[int, _Picture] = {}
        for row in self._session.windows():
            if row.stale:
                continue
            picture = self._pictures.get(row.window_id)
            if picture is None or picture.of != row.measured:
                result = self._session.result(row.fid) if not is_late else None
                picture = _picture(row, result) if result is not None else None
                # Only after one that was read, so that each slice gets further
                is_late = is_late or (picture is not None and time.perf_counter() > end)
            if picture is not None:
                found[row.window_id] = picture
        self._pictures = found
        if is_late:
            self._next_slice.start()
        placed = [
            _placed(one.image, one.window, one.cell_px, grid)
            for one in found.values()
            if one.image is not None and one.window is not None
        ]
        self._overlay.show(placed, QgsCoordinateReferenceSystem(layer.crs()))
        self._legend.show_legend(any(one.cell_px for one in found.values()))


def _picture(row: WindowRecord, result: WindowResult) -> _Picture:
    """Where all is even, as in most windows of a sound mosaic, nothing is painted, and that costs no time."""
    loss = result.loss
    if loss is None:
        return _Picture(row.measured, None, None, 0)
    rgba = loss_rgba(loss.kept)
    return _Picture(row.measured, rgba_image(rgba) if rgba[..., 3].any() else None, result.window, loss.cell_px)


def placed_picture(result: WindowResult, image: QImage, grid: Grid, cell_px: int) -> PlacedPicture:
    """Of a window that was measured: an image whose pixels are so many pixels of the mosaic, from its upper left."""
    assert result.window is not None
    return _placed(image, result.window, cell_px, grid)


def _placed(image: QImage, window: PixelWindow, cell_px: int, grid: Grid) -> PlacedPicture:
    whole = PixelWindow(window.column, window.row, cell_px * image.width(), cell_px * image.height())
    return PlacedPicture(image, grid.window_extent(whole), grid.window_extent(window))
