"""The chart's distances on the map, and the map's in the chart."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsCoordinateReferenceSystem, QgsPointXY
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....toolkit.layers import transformed_point
from .loss_overlay import placed_picture
from .picture_overlay import PictureOverlay, rgba_image

if TYPE_CHECKING:
    import numpy as np

    from ...measure.profile.seam_profile import ProfileBin
    from ...measure.window.window_result import WindowResult
    from ..session import Session

_MOST_SAMPLES = 512  # a side: a distance transform of more would hold up the interface
_HIGHLIGHT = (0, 255, 255, 150)  # no colour of a loss, and seen on vegetation and on asphalt


class ProfileOnMap(QObject):
    """Owns what lies on the canvas until ``close``."""

    distanceChanged = pyqtSignal(object)
    """The distance from the seam, m, of the mouse on the map inside the window; None elsewhere."""

    def __init__(self, canvas: QgsMapCanvas, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._canvas, self._session = canvas, session
        self._overlay = PictureOverlay(canvas, smooth=False, above=1.0)
        self._result: WindowResult | None = None
        self._distances: np.ndarray | None = None  # px, of squares of _side pixels
        self._side = 1
        self._told: float | None = None
        canvas.xyCoordinates.connect(self._follow_mouse)

    def close(self) -> None:
        """Take all off the canvas and follow the mouse no more."""
        self._canvas.xyCoordinates.disconnect(self._follow_mouse)
        self._overlay.close()

    def follow(self, result: WindowResult | None) -> None:
        """The window whose profile is shown; None for none."""
        if result is not self._result:
            self._result, self._distances = result, None
            self._overlay.hide()
            self._tell(None)

    def highlight(self, one: ProfileBin | None) -> None:
        """Show the ground of a bin on the map; None: nothing."""
        import numpy as np

        layer, grid, result = self._session.mosaic_layer(), self._session.mosaic_grid(), self._result
        distances = None if one is None else self._seam_distances()
        if one is None or distances is None or layer is None or grid is None or result is None:
            self._overlay.hide()
            return
        rgba = np.zeros((*distances.shape, 4), np.uint8)
        rgba[(distances >= one.near_px) & (distances < one.far_px)] = _HIGHLIGHT
        placed = placed_picture(result, rgba_image(rgba), grid, self._side)
        self._overlay.show([placed], QgsCoordinateReferenceSystem(layer.crs()))

    def distance_at(self, point: QgsPointXY) -> float | None:
        """From the seam, m, of a point on the map; None outside the window."""
        layer, grid, result = self._session.mosaic_layer(), self._session.mosaic_grid(), self._result
        if layer is None or grid is None or result is None or result.window is None:
            return None
        place = transformed_point(point, self._canvas.mapSettings().destinationCrs(), layer.crs())
        if place is None:
            return None
        column = (place.x() - grid.left) / grid.pixel_width - result.window.column
        row = (grid.top - place.y()) / grid.pixel_height - result.window.row
        if not (0 <= column < result.window.width and 0 <= row < result.window.height):
            return None
        distances = self._seam_distances()
        if distances is None:
            return None
        rows, columns = distances.shape
        away = distances[min(int(row / self._side), rows - 1), min(int(column / self._side), columns - 1)]
        return float(away) * result.ground_sample_distance

    def _seam_distances(self) -> np.ndarray | None:
        """Of the followed window, (rows, columns) px; None without a seam."""
        result = self._result
        if self._distances is None and result is not None and result.loss is not None and len(result.loss.seam):
            import numpy as np
            from scipy import ndimage

            from ...measure.profile.loss_picture import SAMPLE_PX

            window = result.window
            assert window is not None
            step = 1
            while max(window.width, window.height) / (step * SAMPLE_PX) > _MOST_SAMPLES:
                step *= 2
            self._side = step * SAMPLE_PX
            seam = np.zeros((-(-window.height // self._side), -(-window.width // self._side)), bool)
            seam[tuple(result.loss.seam.T // step)] = True
            self._distances = self._side * ndimage.distance_transform_edt(~seam)
        return self._distances

    def _follow_mouse(self, point: QgsPointXY) -> None:
        if self._result is not None:
            self._tell(self.distance_at(point))

    def _tell(self, distance: float | None) -> None:
        if distance != self._told:
            self._told = distance
            self.distanceChanged.emit(distance)
