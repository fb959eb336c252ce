"""Lines across the bars of a target's image, measured and judged."""
from __future__ import annotations

from seam_inspector.plugin.imagery.open_raster import describe_north_up
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.resolution.measure.bar_groups import TargetResolution, judge_lines
from seam_inspector.plugin.resolution.measure.bars import BarLine, MeasuredLine, measure_line
from seam_inspector.plugin.resolution.measure.profiles import Segment
from seam_inspector.plugin.resolution.measure.target import Target

from tests.numbers.resolution.bar_targets import Ends


def measured(path: str, lines: dict[int, Ends], width: float = 3.0, bars: int = 3) -> list[MeasuredLine]:
    raster = describe_north_up(RasterRef(path))
    segments = {group: Segment(ends[:2], ends[2:]) for group, ends in lines.items()}
    return [
        measure_line(raster, BarLine(group, "along", segment), bars, width) for group, segment in segments.items()
    ]


def resolution(path: str, lines: dict[int, Ends], target: Target, width: float = 3.0) -> TargetResolution:
    return judge_lines(describe_north_up(RasterRef(path)), measured(path, lines, width, target.bars), target)
