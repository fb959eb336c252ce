"""Bar targets whose panel ends somewhere: how far it reaches, what begins there, and the group that theory resolves."""
from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from tests.numbers.resolution.bar_targets import STEP, Bars, Ends, coverage, theoretical_share

DARK, BRIGHT = 40.0, 170.0
"""DN of a target's gaps and of its bars; the other way round for dark bars."""


@dataclass(frozen=True)
class Ground:
    """What lies beside the bars of each group."""

    margin: float
    """How far the panel reaches beyond the outer bars on either side, bars."""
    value: float
    """DN of what begins there, for bright bars; that of dark ones mirrors it."""
    gap: float = DARK
    """DN of the target's gaps."""
    bar: float = BRIGHT
    """DN of its bars."""


PANEL = Ground(2.0, 60.0)
GROUNDS = {
    "panel": PANEL, "60 DN": Ground(0.0, 60.0), "100 DN": Ground(0.0, 100.0), "130 DN": Ground(0.0, 130.0),
    "a dark panel one bar wide": Ground(1.0, 130.0),
}


@dataclass(frozen=True)
class Scene:
    """A rendered target: groups one step apart, the coarsest first, at random phases."""

    pixels: np.ndarray
    """(rows, columns) uint8."""
    cycles: tuple[float, ...]
    """px of a bar and a gap, by group."""
    lines: dict[int, Ends]
    """A line across each group, roughly drawn."""
    sigma: float
    """Sigma of the blur, px."""
    bars: int

    @property
    def expected(self) -> int:
        """The finest group whose amplitude keeps half of the full one in theory, on the panel's own ground."""
        kept = [self.bars_share(cycle) >= 0.5 for cycle in self.cycles]
        return kept.index(False) - 1 if False in kept else len(kept) - 1

    def bars_share(self, cycle: float) -> float:
        """In theory, without noise and at every phase."""
        return theoretical_share(cycle, self.sigma)


def ground_scene(
    random: np.random.Generator, ground: Ground, dark_bars: bool = False, bars: int = 3, groups: int = 12,
    sigma: float | None = None, noise: float | None = None, angle: float | None = None, length: float = 5.0,
    limit: int = 7, roughly: bool = True, finest: float | None = None,
) -> Scene:
    """A target whose group ``limit``, of ``finest`` px, is about the finest one that its blur leaves resolved."""
    sigma = random.uniform(0.45, 1.4) if sigma is None else sigma
    noise = random.uniform(0.5, 4) if noise is None else noise
    angle = math.radians(random.uniform(-8, 8)) if angle is None else angle
    finest = finest or 4.0 * math.hypot(sigma, math.sqrt(1 / 12)) * STEP ** random.uniform(-0.5, 0.5)
    cycles = [finest * STEP ** (limit - group) for group in range(groups)]
    x, placed = 24.0, []
    for cycle in cycles:
        reach = (bars - 0.5) * cycle / 2 + 1.2 * cycle + 8
        x += reach
        placed.append(Bars(x + random.uniform(-0.5, 0.5), 0, cycle, length * cycle / 2, angle, bars))
        x += reach
    height = int(2 * (length * cycles[0] / 4 + 16) + 0.15 * bars * cycles[0])
    shape = height, int(x) + 24
    placed = [Bars(bar.x, height / 2 + random.uniform(-0.5, 0.5), bar.cycle, bar.length, angle, bars) for bar in placed]
    panels = [
        # one box as wide as the bars and the margins: ``coverage`` makes a bar half a cycle wide
        Bars(bar.x, bar.y, 2 * ((bars - 0.5) * bar.cycle + ground.margin * bar.cycle), bar.length + 2 * ground.margin
             * bar.cycle / 2, angle, 1)
        for bar in placed
    ]
    seen = ground.value + (ground.gap - ground.value) * coverage(shape, panels, sigma)
    seen += (ground.bar - ground.gap) * coverage(shape, placed, sigma)
    if dark_bars:
        seen = ground.gap + ground.bar - seen
    seen += random.normal(0, noise, shape)
    error = 8 if roughly else 0
    lines = {
        group: shown.line(random.uniform(1.5, 1.8) if roughly else 1.6, math.radians(random.uniform(-error, error)))
        for group, shown in enumerate(placed)
    }
    return Scene(np.clip(np.rint(seen), 0, 255).astype(np.uint8), tuple(cycles), lines, sigma, bars)
