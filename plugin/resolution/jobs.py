"""The jobs of bar groups: opening the image of a target, and measuring one group in it."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Optional

from ..imagery.errors import SeamInspectorError
from ..imagery.open_raster import describe_north_up
from ..imagery.rasters import Raster, RasterRef
from ..toolkit.background_task import Cancelled, Job
from .measure.bar_groups import judge_lines
from .measure.bar_lines import BarLine, MeasuredLine, measure_line
from .measure.profiles import Segment
from .measure.target import Target

MeasuredLines = dict[tuple[Optional["Segment"], int, float], MeasuredLine]
"""By place, bars in a group and width."""


def image_job(ref: RasterRef) -> Job:
    """Opens an image; yields the Raster, or the Message why it can't be used."""

    def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        try:
            yield 1.0, describe_north_up(ref)
        except SeamInspectorError as error:
            yield 1.0, error.message

    return job


def bar_job(
    raster: Raster, line: BarLine, others: Sequence[BarLine], known: MeasuredLines, target: Target, width: float
) -> Job:
    """Measures one line and judges it with the others of its target; yields the TargetResolution, the line's own last.

    ``known``: what was measured before, to which the others are added.
    """

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        measured = []
        for other in others:
            key = other.segment, target.bars, width
            if key not in known:
                known[key] = measure_line(raster, other, target.bars, width)
            measured.append(replace(known[key], line=other))
            if cancelled():
                return
        measured.append(measure_line(raster, line, target.bars, width))
        if not cancelled():
            yield 1.0, judge_lines(raster, measured, target)

    return job
