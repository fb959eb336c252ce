"""The jobs of bar groups: opening the image of a target, and measuring one group in it."""
from __future__ import annotations

from collections.abc import Iterator

from ..imagery.errors import SeamInspectorError
from ..imagery.open_raster import describe_north_up
from ..imagery.rasters import Raster, RasterRef
from ..toolkit.background_task import Cancelled, Job
from .measure.bar_groups import judge_lines
from .measure.bar_lines import BarLine, measure_line
from .measure.target import Target


def image_job(ref: RasterRef) -> Job:
    """Opens an image; yields the Raster, or the Message why it can't be used."""

    def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        try:
            yield 1.0, describe_north_up(ref)
        except SeamInspectorError as error:
            yield 1.0, error.message

    return job


def bar_job(raster: Raster, line: BarLine, target: Target, width: float) -> Job:
    """Measures and judges one line by itself; yields the TargetResolution."""

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        measured = measure_line(raster, line, target.bars, width)
        if not cancelled():
            yield 1.0, judge_lines(raster, [measured], target)

    return job
