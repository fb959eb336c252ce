"""The image of a bar target with its lines, in as many strips as a page shows it largest."""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..imagery.grids import PixelWindow
from ..imagery.open_raster import OpenRaster
from ..imagery.rasters import Raster
from ..toolkit.charts.figure_files import plain_figure
from .charts import VERDICT_COLOURS, lines_of, verdict_of
from .measure.bar_groups import GroupResult

_LARGEST_PX = 3200  # of the target's longer side: a larger one is not read for a picture
_WIDTH, _HEIGHT = 7.0, 4.0  # inches: of the picture at most
_GAP = 0.12  # inches between strips
_MOST_STRIPS = 8
_LARGEST_PIXEL = 0.08  # inches: no pixel is shown larger
_LETTERS = 7.0  # points
_POINT = 1 / 72  # inches

Line = Sequence[GroupResult]
Box = tuple[float, float, float, float]
"""Left, top, right and bottom, px."""


@dataclass(frozen=True)
class _Strip:
    """A part of the target with the lines in it."""

    lines: Sequence[Line]
    box: Box


def target_picture(raster: Raster, results: Sequence[GroupResult]) -> Figure | None:
    """The image around all lines, each line in the colour of its verdict; None when no line lies on the image.

    A target far wider than high, or higher than wide, is cut between its groups into strips below or beside each other.
    """
    lines = [line for line in lines_of(results) if line[0].measured.segment is not None]
    if not lines:
        return None
    whole = _box(lines, raster, _margin(lines))
    if max(whole[2] - whole[0], whole[3] - whole[1]) > _LARGEST_PX:
        return None
    is_wide = whole[2] - whole[0] >= whole[3] - whole[1]
    strips = max((_strips(lines, raster, is_wide, count) for count in range(1, _MOST_STRIPS + 1)),
                 key=lambda made: _scale(made, is_wide))  # fmt: skip
    return _drawn(raster, whole, strips, is_wide)


def _strips(lines: Sequence[Line], raster: Raster, is_wide: bool, count: int) -> list[_Strip]:
    """The lines in their order along the target, in parts that are about equally long; each as thick as all."""
    margin = _margin(lines)
    whole = _box(lines, raster, margin)
    start, end = (whole[0], whole[2]) if is_wide else (whole[1], whole[3])
    parts: list[list[Line]] = [[] for _ in range(count)]
    for line in lines:
        (x1, y1), (x2, y2) = line_ends(line)
        middle = (x1 + x2) / 2 if is_wide else (y1 + y2) / 2
        parts[min(int(count * (middle - start) / (end - start)), count - 1)].append(line)
    boxes = ((part, _box(part, raster, margin)) for part in parts if part)
    return [
        _Strip(part, (box[0], whole[1], box[2], whole[3]) if is_wide else (whole[0], box[1], whole[2], box[3]))
        for part, box in boxes
    ]


def _scale(strips: Sequence[_Strip], is_wide: bool) -> float:
    """Inches a pixel at which strips fill the picture."""
    widths, heights = ([strip.box[side + 2] - strip.box[side] for strip in strips] for side in (0, 1))
    gaps = _GAP * (len(strips) - 1)
    across, down = (max(widths), sum(heights)) if is_wide else (sum(widths), max(heights))
    room = (_WIDTH, _HEIGHT - gaps) if is_wide else (_WIDTH - gaps, _HEIGHT)
    return min(room[0] / across, room[1] / down, _LARGEST_PIXEL)


def _drawn(raster: Raster, whole: Box, strips: Sequence[_Strip], is_wide: bool) -> Figure:
    scale = _scale(strips, is_wide)
    sizes = [((one.box[2] - one.box[0]) * scale, (one.box[3] - one.box[1]) * scale) for one in strips]
    gaps = _GAP * (len(strips) - 1)
    width = max(size[0] for size in sizes) if is_wide else sum(size[0] for size in sizes) + gaps
    height = sum(size[1] for size in sizes) + gaps if is_wide else max(size[1] for size in sizes)
    figure = plain_figure(width, height)
    pixels, left, top = _toned(raster, whole), whole[0], whole[1]
    x, y = 0.0, height
    for strip, (across, down) in zip(strips, sizes):
        axes = figure.add_axes((x / width, (y - down) / height, across / width, down / height))
        first, upper, last, lower = strip.box
        shown = pixels[int(upper - top) : int(lower - top), int(first - left) : int(last - left)]
        axes.imshow(shown, cmap="gray", vmin=0, vmax=1, extent=(first, last, lower, upper), interpolation="nearest")
        axes.set_axis_off()
        _draw_lines(axes, strip.lines, scale)
        axes.set_xlim(first, last)
        axes.set_ylim(lower, upper)
        x, y = (x, y - down - _GAP) if is_wide else (x + across + _GAP, y)
    return figure


def _draw_lines(axes: Axes, lines: Sequence[Line], scale: float) -> None:
    """Lines, and the numbers of their groups beyond their ends where they cover no other number."""
    taken: list[tuple[float, float, float]] = []
    for line in lines:
        (x1, y1), (x2, y2) = line_ends(line)
        axes.plot([x1, x2], [y1, y2], color=VERDICT_COLOURS[verdict_of(line)], linewidth=1.6)
    for line in lines:
        words = str(line[0].measured.line.group)
        (x1, y1), (x2, y2) = line_ends(line)
        length = max(math.hypot(x2 - x1, y2 - y1), 1e-9)
        half = (0.35 * len(words) + 0.35) * _LETTERS * _POINT / scale  # px: half the label's width
        away = 0.55 * _LETTERS * _POINT / scale + half * abs(x2 - x1) / length
        for end, start in (((x2, y2), (x1, y1)), ((x1, y1), (x2, y2))):
            x = end[0] + away * (end[0] - start[0]) / length
            y = end[1] + away * (end[1] - start[1]) / length
            high = 1.3 * _LETTERS * _POINT / scale
            if all(abs(x - other) > half + reach or abs(y - down) > high for other, down, reach in taken):
                taken.append((x, y, half))
                axes.text(
                    x, y, words, fontsize=_LETTERS, color="white", ha="center", va="center", clip_on=True,
                    bbox={"facecolor": "black", "alpha": 0.6, "pad": 0.8, "linewidth": 0},
                )  # fmt: skip
                break


def _margin(lines: Sequence[Line]) -> float:
    """px around lines in which their numbers have room."""
    return 0.5 * max(math.dist(*line_ends(line)) for line in lines) + 6


def _box(lines: Sequence[Line], raster: Raster, margin: float) -> Box:
    """What is shown around lines, whole pixels on the image."""
    ends = np.array([end for line in lines for end in line_ends(line)])
    (left, top), (right, bottom) = ends.min(axis=0), ends.max(axis=0)
    return (
        max(0, math.floor(left - margin)), max(0, math.floor(top - margin)),
        min(raster.columns, math.ceil(right + margin)), min(raster.rows, math.ceil(bottom + margin)),
    )  # fmt: skip


def line_ends(line: Line) -> tuple[tuple[float, float], tuple[float, float]]:
    """Both ends of a line as it was measured, column and row."""
    segment = line[0].measured.segment
    assert segment is not None
    return segment.start, segment.end


def _toned(raster: Raster, box: Box) -> np.ndarray:
    """The pixels of a box, 0 to 1."""
    left, top, right, bottom = map(int, box)
    bands = OpenRaster(raster.ref).read(PixelWindow(left, top, right - left, bottom - top)).bands
    shown = np.moveaxis(bands[:3], 0, -1) if raster.has_luminance else bands[0]
    low, high = np.percentile(shown, (0.5, 99.5))
    return np.asarray(np.clip((shown - low) / max(high - low, 1e-9), 0, 1))
