"""The job that measures one bar group in the background."""
from __future__ import annotations

from collections.abc import Iterator

from ..core.rasters import Mosaic
from ..core.resolution.groups import BarLine, judge, measure_line
from ..core.resolution.target import Target
from .tasks import Cancelled, Job


def bar_job(raster: Mosaic, line: BarLine, target: Target, width: float) -> Job:
    """Measures and judges one line by itself; yields the Resolution."""

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        measured = measure_line(raster, line, target.bars, width)
        if not cancelled():
            yield 1.0, judge(raster, [measured], target)

    return job
