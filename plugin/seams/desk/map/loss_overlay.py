"""The pictures of lost detail over the map, and their legend, while they are switched on."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsCoordinateReferenceSystem
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtGui import QImage

from ....imagery.grids import Grid, PixelWindow
from ....toolkit.desk.timers import single_shot
from ...loss_colours import LOSS_OPACITY, loss_rgba
from .loss_legend import LossLegend
from .picture_overlay import PictureOverlay, PlacedPicture, rgba_image

if TYPE_CHECKING:
    from ...measure.profile.loss_picture import LossPicture
    from ...measure.window.window_result import WindowResult
    from ..session import Session

_TOGETHER_MS = 100  # windows that come within this time are painted once


class LossOverlay(QObject):
    """Follows the session; owns all that it puts on the canvas until ``close``."""

    def __init__(self, canvas: QgsMapCanvas, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._overlay = PictureOverlay(canvas, opacity=LOSS_OPACITY)
        self._legend = LossLegend(canvas)
        self._images: dict[int, tuple[LossPicture, QImage | None]] = {}
        self._timer = single_shot(self, self._refresh, _TOGETHER_MS)
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
        self._session.loss_view.changed.disconnect(self._refresh)
        self._timer.stop()
        self._overlay.close()
        self._legend.close_legend()

    def _refresh_soon(self, *_: object) -> None:
        if self._session.loss_view.is_shown and not self._timer.isActive():
            self._timer.start()

    def _refresh(self, *_: object) -> None:
        layer, grid = self._session.mosaic_layer(), self._session.mosaic_grid()
        if not self._session.loss_view.is_shown or layer is None or grid is None:
            self._images.clear()
            self._overlay.hide()
            self._legend.hide()
            return
        found: dict[int, tuple[LossPicture, QImage | None]] = {}
        placed = []
        for row in self._session.windows():
            result = None if row.stale else self._session.result(row.fid)
            if result is None or result.loss is None or result.window is None:
                continue
            known = self._images.get(row.window_id)
            if known is None or known[0] is not result.loss:
                known = result.loss, _image(result.loss)
            found[row.window_id] = known
            if known[1] is not None:
                placed.append(placed_picture(result, known[1], grid, result.loss.cell_px))
        self._images = found
        self._overlay.show(placed, QgsCoordinateReferenceSystem(layer.crs()))
        self._legend.show_legend(bool(found))


def _image(loss: LossPicture) -> QImage | None:
    """None where all is even, as in most windows of a sound mosaic: what is not painted costs no time."""
    rgba = loss_rgba(loss.kept)
    return rgba_image(rgba) if rgba[..., 3].any() else None


def placed_picture(result: WindowResult, image: QImage, grid: Grid, cell_px: int) -> PlacedPicture:
    """Of a window that was measured: an image whose pixels are so many pixels of the mosaic, from its upper left."""
    window = result.window
    assert window is not None
    whole = PixelWindow(window.column, window.row, cell_px * image.width(), cell_px * image.height())
    return PlacedPicture(image, grid.window_extent(whole), grid.window_extent(window))
