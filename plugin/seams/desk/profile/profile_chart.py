"""The chart of a seam profile. It takes plain data: what is measured under the mouse can be shown in it, too."""
from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QEvent, QRectF, QSize, pyqtSignal
from qgis.PyQt.QtGui import QFontMetricsF, QMouseEvent, QPainter, QPaintEvent
from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from ....toolkit.desk.theme import chart_style
from ...charts.profile_scale import ShownProfile
from .profile_painter import ProfilePainter

if TYPE_CHECKING:
    from ...measure.profile.seam_profile import ProfileBin, SeamProfile

_LEAST_PX = 150
"""Height in which the limit and the interval can still be told apart."""
_DIMMED = 0.35  # how much is left of a chart that is disabled


class ProfileChart(QWidget):
    """Shows one profile; says which distance the mouse points at."""

    pointed = pyqtSignal(object)  # ProfileBin, or None when the mouse is elsewhere

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shown: ShownProfile | None = None
        self._levels = frozenset({1})
        self._pointed: ProfileBin | None = None
        self._marked_m: float | None = None
        self.setMouseTracking(True)
        self.setMinimumSize(11 * self.fontMetrics().height(), _LEAST_PX)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def sizeHint(self) -> QSize:
        return 2 * self.minimumSize()

    @property
    def shown(self) -> ShownProfile | None:
        """What is seen."""
        return self._shown

    @property
    def pointed_bin(self) -> ProfileBin | None:
        """What the mouse points at, here or on the map."""
        if self._pointed is None and self._marked_m is not None and self._shown is not None:
            return self._shown.bin_at(self._marked_m)
        return self._pointed

    def show_profile(self, profile: SeamProfile, pixel_m: float, min_kept: float) -> None:
        """Paint a profile; ``pixel_m``: the mosaic's pixel size, ``min_kept``: the limit of a significant loss."""
        shown = ShownProfile(profile, pixel_m, min_kept, self._levels)
        if shown != self._shown:
            self._shown = shown
            self._point(None)
            self.update()

    def show_levels(self, levels: frozenset[int]) -> None:
        """Which levels are drawn from now on."""
        self._levels = levels
        if self._shown is not None:
            self._shown = replace(self._shown, levels=levels)
        self.update()

    def mark(self, distance_m: float | None) -> None:
        """A line at the distance that the mouse has from the seam on the map; none when it is elsewhere."""
        if distance_m != self._marked_m:
            self._marked_m = distance_m
            self.update()

    def painter_for(self, shown: ShownProfile) -> ProfilePainter:
        """In the widget as it is now."""
        return ProfilePainter(shown, QRectF(self.rect()), chart_style(self), QFontMetricsF(self.font()))

    def paintEvent(self, _event: QPaintEvent) -> None:
        if self._shown is None:
            return
        painter = QPainter(self)
        painter.setOpacity(1.0 if self.isEnabled() else _DIMMED)
        self.painter_for(self._shown).paint(painter, self._pointed, self._marked_m)
        painter.end()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._shown is None:
            return
        placed = self.painter_for(self._shown)
        x = event.pos().x()
        is_inside = placed.axes.left() <= x <= placed.axes.right()
        self._point(self._shown.bin_at(placed.distance_at(x)) if is_inside else None)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._point(None)

    def _point(self, one: ProfileBin | None) -> None:
        if one != self._pointed:
            self._pointed = one
            self.update()
            self.pointed.emit(one)
