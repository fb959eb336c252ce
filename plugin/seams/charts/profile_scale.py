"""What a chart of a seam profile shows, and where: kept detail against the distance from the seam. No Qt, no
matplotlib: the desk paints it, the report writes it as SVG."""
from __future__ import annotations

from dataclasses import dataclass
from math import floor, log10
from typing import TYPE_CHECKING

from ...toolkit.translation import shown_number

if TYPE_CHECKING:
    from ..measure.profile.seam_profile import ProfileBin, SeamProfile

FARTHEST_PX = 400.0
"""Where the last bin, which has no end, is drawn to."""
_LOWEST_TOP, _HIGHEST_TOP = 1.2, 2.0  # of the axis of shares, between which the values choose
_HIGHEST_END = 1.45  # of an interval that is shown whole
_LEAST_MIXTURE = 0.05  # of any bin: a cut mixes nothing, but for a pixel on a border that was found
_TICK_STEPS = (1.0, 2.0, 5.0)


@dataclass(frozen=True)
class ShownProfile:
    """What a chart shows."""

    profile: SeamProfile
    pixel_m: float
    """The mosaic's pixel size, m."""
    min_kept: float
    """Share at or below which a loss is significant."""
    levels: frozenset[int] = frozenset({1})
    """Which are drawn; the finest of them with its interval."""

    def bins(self, level: int) -> list[ProfileBin]:
        """Of one level, from the seam outwards."""
        return [one for one in self.profile.bins if one.level == level]

    @property
    def main_level(self) -> int:
        """The finest that is drawn."""
        return min(self.levels, default=1)

    @property
    def mixed(self) -> list[ProfileBin]:
        """Where the images' mixture is drawn, from the seam outwards: beside level 1, where anything is mixed."""
        known = [one for one in self.bins(1) if one.mixture is not None] if 1 in self.levels else []
        return known if any((one.mixture or 0) >= _LEAST_MIXTURE for one in known) else []

    def bin_at(self, distance_m: float) -> ProfileBin | None:
        """The main level's bin at a distance from the seam; None where nothing was measured."""
        away = distance_m / self.pixel_m
        return next((one for one in self.bins(self.main_level) if one.near_px <= away < one.far_px), None)


class ProfileScale:
    """Where everything of one chart is, in the rectangle of its axes; y runs downwards.

    The axis of distances goes by their square roots: bins near the seam are narrow, and matter most.
    """

    def __init__(self, shown: ShownProfile, left: float, top: float, width: float, height: float) -> None:
        self._shown, self._left, self._width, self._height = shown, left, width, height
        self._bottom = top + height
        highest = max((one.kept for level in shown.levels for one in shown.bins(level)), default=1.0)
        ends = max((min(one.high, _HIGHEST_END) for one in shown.bins(shown.main_level)), default=1.0)
        self.most_kept = min(max(1.08 * highest, 1.03 * ends, _LOWEST_TOP), _HIGHEST_TOP)
        """The share at the axis's upper end."""

    def x_of(self, distance_m: float) -> float:
        """Of a distance from the seam."""
        away = min(max(distance_m / self._shown.pixel_m, 0.0), FARTHEST_PX)
        return float(self._left + self._width * (away / FARTHEST_PX) ** 0.5)

    def distance_at(self, x: float) -> float:
        """From the seam, m."""
        share = min(max((x - self._left) / max(self._width, 1.0), 0.0), 1.0)
        return float(share**2 * FARTHEST_PX * self._shown.pixel_m)

    def y_of(self, kept: float) -> float:
        """Of a share that is kept; what is above the axis stays at its end."""
        return float(self._bottom - self._height * min(max(kept, 0.0), self.most_kept) / self.most_kept)

    def ends(self, one: ProfileBin) -> tuple[float, float]:
        """Left and right of a bin."""
        metres = self._shown.pixel_m
        return self.x_of(one.near_px * metres), self.x_of(min(one.far_px, FARTHEST_PX) * metres)

    def mixture_line(self) -> list[tuple[float, float]]:
        """The share of the image beyond the seam: through the middles of the bins, from end to end; empty for none."""
        shown = self._shown.mixed
        if not shown:
            return []
        points = [(self.x_of(one.middle_px * self._shown.pixel_m), self.y_of(one.mixture or 0)) for one in shown]
        return [(self.ends(shown[0])[0], points[0][1]), *points, (self.ends(shown[-1])[1], points[-1][1])]

    def share_ticks(self, step: float) -> list[float]:
        """The shares that have a line."""
        return [number * step for number in range(int(self.most_kept / step) + 1)]

    def distance_ticks(self) -> list[tuple[float, str]]:
        """Round distances and their words; more than there may be room for."""
        farthest = FARTHEST_PX * self._shown.pixel_m
        ticks, size = [0.0], 10.0 ** floor(log10(farthest) - 3)
        while size <= farthest:
            ticks += [float(f"{step * size:.3g}") for step in _TICK_STEPS if step * size <= farthest]
            size *= 10
        known = (tick for tick in ticks if not tick or tick >= 2 * self._shown.pixel_m)
        return [(tick, shown_number(tick, len(f"{tick:.12g}".partition(".")[2]))) for tick in known]
