"""The curves that a chart of relative variances shows. No matplotlib, so that it loads at once."""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from ...toolkit.translation import formatted


@dataclass(frozen=True)
class ChartCurve:
    """One line in a chart: of a raster in one window, or the mean of many."""

    label: str
    """File name without its folder."""
    is_mosaic: bool
    detail: tuple[float, ...]
    """Relative variance at levels 1..R."""
    background: float
    colour: int | None = None
    """Number of a source's colour, so that it keeps it from window to window; None: by its place in the chart."""
    spread: tuple[tuple[float, float], ...] = ()
    """Lowest and highest value of each component when the curve is a mean, else empty."""
    is_composite: bool = False
    """Whether it is the hard-cut composite of the sources, which is none of them."""
    is_reference: bool = False
    """Whether the verdict is taken against it alone, and not against the sources."""

    @property
    def key(self) -> tuple[bool, str]:
        """What tells it from the other curves of the chart, and stays from window to window."""
        return self.is_mosaic, self.label

    @property
    def values(self) -> tuple[float, ...]:
        """Levels 1..R, then the background; NaN for a constant clip."""
        return (*self.detail, self.background)


def least_of_sources(curves: Sequence[ChartCurve], component: int) -> float | None:
    """The lowest share of a component among the sources: of the least sharp one, where it is a detail.

    That of the composite, where the verdict is taken against it.
    """
    rivals = [curve for curve in curves if curve.is_reference]
    rivals = rivals or [curve for curve in curves if not (curve.is_mosaic or curve.is_composite)]
    return min((share for curve in rivals if (share := curve.values[component]) > 0), default=None)


def significance_limit(curves: Sequence[ChartCurve], max_ratio: float) -> float | None:
    """The share at level 1 at or below which a mosaic has lost significantly; None for means and without sources."""
    if any(curve.spread for curve in curves):
        return None
    least = least_of_sources(curves, 0)
    return None if least is None else max_ratio * least


def share_text(share: float) -> str:
    """A share with three digits that count: 0.412, 0.0160, 0.00052."""
    if not share > 0:
        return formatted(share, "g")
    return formatted(share, f".{min(max(2 - math.floor(math.log10(share)), 2), 7)}f")
