"""Which part of the pictures is seen, and how large: one for all views, so that they move together."""
from __future__ import annotations

import math

from qgis.PyQt.QtCore import QObject, QRectF, pyqtSignal

from ....imagery.grids import PixelWindow
from ...measure.limits import JUDGED_MAGNIFICATION

BEST_ZOOM = JUDGED_MAGNIFICATION
ZOOMS = (1.0, 2.0, 4.0, 8.0)

Point = tuple[float, float]


class Viewport(QObject):
    """Screen pixels are those of the device, whatever the desktop's scaling; window pixels count from its corner."""

    changed = pyqtSignal()
    cursorMoved = pyqtSignal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.window = (1, 1)
        """Columns and rows of the pictures."""
        self.screen = (1, 1)
        """Width and height of one view, screen pixels."""
        self.zoom: float | None = BEST_ZOOM
        """Screen pixels per window pixel; None: whatever makes all of the window seen."""
        self.centre: Point = (0.5, 0.5)
        """Centre of the views, as shares of the window's sides, so that it holds for windows of other sizes too."""
        self.cursor: Point | None = None
        """Where the mouse is, window pixels."""

    @property
    def scale(self) -> float:
        """Screen pixels per window pixel."""
        return self._fitting() if self.zoom is None else self.zoom

    def origin(self) -> Point:
        """The window's upper left corner in a view, screen pixels."""
        x, y = self._seen_centre(self.scale)
        return (
            self.screen[0] / 2 - x * self.window[0] * self.scale,
            self.screen[1] / 2 - y * self.window[1] * self.scale,
        )

    def window_point(self, x: float, y: float) -> Point:
        """Window pixels of a place in a view."""
        left, top = self.origin()
        return (x - left) / self.scale, (y - top) / self.scale

    def box(self, window: PixelWindow | None) -> QRectF:
        """Where a part of the pictures is in a view, screen pixels; None: all of them."""
        part, scale, (left, top) = window or PixelWindow(0, 0, *self.window), self.scale, self.origin()
        return QRectF(left + part.column * scale, top + part.row * scale, part.width * scale, part.height * scale)

    def pan(self, dx: float, dy: float) -> None:
        """Move the pictures by screen pixels."""
        x, y = self._seen_centre(self.scale)
        self._set_centre(x - dx / (self.window[0] * self.scale), y - dy / (self.window[1] * self.scale))

    def zoom_by(self, steps: int, x: float | None = None, y: float | None = None) -> None:
        """Go to a larger (or smaller) step of 1, 2, 4, 8 and all of the window; (x, y) of the views stays in place."""
        fitting, now = self._fitting(), self.scale
        scales = sorted({*ZOOMS, fitting})
        larger = [scale for scale in scales if scale > now]
        smaller = [scale for scale in scales if scale < now]
        wanted = larger[: steps] if steps > 0 else smaller[steps:] if steps < 0 else []
        if not wanted:
            return
        scale = wanted[-1] if steps > 0 else wanted[0]
        x, y = self.screen[0] / 2 if x is None else x, self.screen[1] / 2 if y is None else y
        held = self.window_point(x, y)
        self.zoom = None if scale == fitting and scale not in ZOOMS else scale
        self._set_centre(
            (held[0] - (x - self.screen[0] / 2) / scale) / self.window[0],
            (held[1] - (y - self.screen[1] / 2) / scale) / self.window[1],
        )

    def set_zoom(self, zoom: float | None) -> None:
        """Zoom around the views' centre; None: see all of the window."""
        self.zoom = zoom
        self.changed.emit()

    def set_cursor(self, point: Point | None) -> None:
        if point != self.cursor:
            self.cursor = point
            self.cursorMoved.emit()

    def _fitting(self) -> float:
        scale = min(self.screen[0] / self.window[0], self.screen[1] / self.window[1])
        return min(float(math.floor(scale)), ZOOMS[-1]) if scale >= 1 else max(scale, 1e-3)

    def _set_centre(self, x: float, y: float) -> None:
        """A side that is seen whole keeps its centre for when it is not."""
        margins = self._margins(self.scale)
        kept = [_within(new, margin, old) for old, new, margin in zip(self.centre, (x, y), margins)]
        self.centre = (kept[0], kept[1])
        self.changed.emit()

    def _seen_centre(self, scale: float) -> Point:
        """The centre, moved so that the views show nothing beyond the window where it is larger than they are."""
        x, y = (_within(share, margin, 0.5) for share, margin in zip(self.centre, self._margins(scale)))
        return x, y

    def _margins(self, scale: float) -> Point:
        """Half of a view as shares of the window's sides."""
        return self.screen[0] / (2 * scale * self.window[0]), self.screen[1] / (2 * scale * self.window[1])


def _within(share: float, margin: float, where_all_is_seen: float) -> float:
    """A centre from which no view reaches beyond the window; margins are half a view."""
    return where_all_is_seen if margin >= 0.5 else min(max(share, margin), 1 - margin)
