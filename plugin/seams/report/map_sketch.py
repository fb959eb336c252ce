"""A map sketch: rectangles in their colours, north up, with a scale bar, over a picture where there is one.

All places and lengths of the sketch are millimetres on paper, from its upper left corner.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ...imagery.grids import Extent
from ...toolkit.charts.round_ticks import round_below
from ...toolkit.translation import formatted

_WIDTH, _HEIGHT, _STRIP = 170.0, 90.0, 11.0  # mm: the map at most, below the summary, and what stands below it
_NARROWEST = 60.0  # mm: room for the scale bar
_MARGIN = 0.06  # of the longer side, around all shapes
_SMALLEST = 1.6  # mm: a shape's side, so that it is seen
_LETTERS = 3.0  # mm high
_CROWDED = 4.0  # mm: labels nearer to each other than that are left out

Box = tuple[float, float, float, float]
"""Left, top, width and height, mm."""


@dataclass(frozen=True)
class SketchShape:
    """A rectangle on the map."""

    extent: Extent  # map units
    colour: str
    label: str  # written beside it where there is room
    tip: str  # said when the pointer rests on it
    anchor: str = ""  # where a click leads in the page; empty for nowhere


@dataclass(frozen=True)
class SketchBackground:
    """A picture below the shapes."""

    jpeg: bytes
    extent: Extent  # map units


@dataclass(frozen=True)
class Sketch:
    """What is drawn where."""

    width: float
    height: float  # height of the map
    strip: float  # height of what stands below the map
    letters: float
    background: tuple[Box, bytes] | None
    shapes: Sequence[tuple[Box, SketchShape]]
    labels: Sequence[tuple[float, float, str]]  # middle of the foot of each
    bar: float  # length of the scale bar
    bar_words: str


def sketch_extent(shapes: Sequence[SketchShape], metres_x: float = 1.0, metres_y: float = 1.0) -> Extent:
    """What the sketch shows: all shapes, and a margin around them that is equally wide on the ground."""
    xs = [x for shape in shapes for x in (shape.extent[0], shape.extent[2])]
    ys = [y for shape in shapes for y in (shape.extent[1], shape.extent[3])]
    margin = _MARGIN * max((max(xs) - min(xs)) * metres_x, (max(ys) - min(ys)) * metres_y)
    x, y = margin / metres_x, margin / metres_y
    return min(xs) - x, min(ys) - y, max(xs) + x, max(ys) + y


def map_sketch(
    shapes: Sequence[SketchShape],
    metres_x: float = 1.0,
    metres_y: float = 1.0,
    background: SketchBackground | None = None,
) -> Sketch:
    """The sketch of one shape or more; later shapes lie above earlier ones, and are labelled first.

    ``metres_x``, ``metres_y``: metres on the ground per map unit.
    """
    frame = _Frame(sketch_extent(shapes, metres_x, metres_y), metres_x, metres_y)
    placed = [(_seen_box(frame, shape), shape) for shape in shapes]
    bar, words = _scale_bar(frame)
    picture = None if background is None else (frame.box(background.extent), background.jpeg)
    return Sketch(frame.width, frame.height, _STRIP, _LETTERS, picture, placed, _labels(placed), bar, words)


class _Frame:
    """From map units to millimetres on paper."""

    def __init__(self, extent: Extent, metres_x: float, metres_y: float) -> None:
        across, down = (extent[2] - extent[0]) * metres_x, (extent[3] - extent[1]) * metres_y
        self.metres_per_mm = max(across / _WIDTH, down / _HEIGHT, 1e-9)
        self._x, self._y = metres_x / self.metres_per_mm, metres_y / self.metres_per_mm
        self.width, self.height = max(across / self.metres_per_mm, _NARROWEST), down / self.metres_per_mm
        self._left = extent[0] - (self.width - across / self.metres_per_mm) / 2 / self._x
        self._top = extent[3]

    def box(self, extent: Extent) -> Box:
        left, top = (extent[0] - self._left) * self._x, (self._top - extent[3]) * self._y
        return left, top, (extent[2] - extent[0]) * self._x, (extent[3] - extent[1]) * self._y


def _seen_box(frame: _Frame, shape: SketchShape) -> Box:
    """Not smaller than can be seen."""
    x, y, width, height = frame.box(shape.extent)
    wider, higher = max(_SMALLEST - width, 0), max(_SMALLEST - height, 0)
    return x - wider / 2, y - higher / 2, width + wider, height + higher


def _labels(placed: Sequence[tuple[Box, SketchShape]]) -> list[tuple[float, float, str]]:
    """The labels there is room for, the last shape's first."""
    taken: list[tuple[float, float, str]] = []
    for (x, y, width, height), shape in reversed(placed):
        across, down = x + width / 2, y + height / 2 + 0.36 * _LETTERS
        reach = max(_CROWDED, 0.65 * _LETTERS * len(shape.label))
        if all(abs(across - a) > reach or abs(down - b) > _LETTERS for a, b, _ in taken):
            taken.append((across, down, shape.label))
    return taken


def _scale_bar(frame: _Frame) -> tuple[float, str]:
    """A round length of about a quarter of the width, and its words."""
    metres = round_below(0.3 * frame.width * frame.metres_per_mm)
    words = formatted(metres / 1000, "g") + " km" if metres >= 1000 else formatted(metres, "g") + " m"
    return metres / frame.metres_per_mm, words
