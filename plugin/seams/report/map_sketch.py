"""A map sketch as SVG: rectangles in their colours, north up, with a scale bar, over a picture where there is one."""
from __future__ import annotations

import base64
import math
from collections.abc import Sequence
from dataclasses import dataclass

from ...imagery.grids import Extent
from ...toolkit.pages.html_page import text

_WIDTH, _HEIGHT, _STRIP = 170.0, 120.0, 11.0  # mm: the map at most, and what stands below it
_NARROWEST = 60.0  # mm: room for the scale bar
_MARGIN = 0.06  # of the longer side, around all shapes
_SMALLEST = 1.6  # mm: a shape's side, so that it is seen
_LETTERS = 3.0  # mm high
_CROWDED = 4.0  # mm: labels nearer to each other than that are left out


@dataclass(frozen=True)
class SketchShape:
    """A rectangle on the map."""

    extent: Extent
    """Map units."""
    colour: str
    label: str
    """Written beside it where there is room."""
    tip: str
    """Said when the pointer rests on it."""
    anchor: str = ""
    """Where a click leads in the page; empty for nowhere."""


@dataclass(frozen=True)
class SketchBackground:
    """A picture below the shapes."""

    jpeg: bytes
    extent: Extent
    """Map units."""


def sketch_extent(shapes: Sequence[SketchShape], metres_x: float = 1.0, metres_y: float = 1.0) -> Extent:
    """What the sketch shows: all shapes, and a margin around them that is equally wide on the ground."""
    xs = [x for shape in shapes for x in (shape.extent[0], shape.extent[2])]
    ys = [y for shape in shapes for y in (shape.extent[1], shape.extent[3])]
    margin = _MARGIN * max((max(xs) - min(xs)) * metres_x, (max(ys) - min(ys)) * metres_y)
    x, y = margin / metres_x, margin / metres_y
    return min(xs) - x, min(ys) - y, max(xs) + x, max(ys) + y


def map_sketch(
    shapes: Sequence[SketchShape],
    north: str,
    metres_x: float = 1.0,
    metres_y: float = 1.0,
    background: SketchBackground | None = None,
) -> str:
    """The sketch of one shape or more; later shapes lie above earlier ones, and are labelled first.

    ``metres_x``, ``metres_y``: metres on the ground per map unit. ``north``: the letter above the arrow.
    """
    frame = _Frame(sketch_extent(shapes, metres_x, metres_y), metres_x, metres_y)
    width, height = frame.width, frame.height
    opening = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.2f} {height + _STRIP:.2f}" '
        f'style="width:{width:.1f}mm" font-family="sans-serif" font-size="{_LETTERS}">'
    )
    paper = f'<rect width="{width:.2f}" height="{height:.2f}" fill="#f6f8fa" stroke="#8c959f" stroke-width=".2"/>'
    parts = [opening, paper]
    if background is not None:
        x, y, across, down = frame.box(background.extent)
        data = base64.b64encode(background.jpeg).decode()
        parts.append(
            f'<image x="{x:.2f}" y="{y:.2f}" width="{across:.2f}" height="{down:.2f}" preserveAspectRatio="none" '
            f'opacity=".75" href="data:image/jpeg;base64,{data}"/>'
        )
    parts += [_shape(frame, shape) for shape in shapes]
    parts += _labels(frame, shapes)
    parts += _scale_bar(frame)
    parts.append(_north_arrow(frame, north))
    return "".join(parts) + "</svg>"


class _Frame:
    """From map units to millimetres on paper."""

    def __init__(self, extent: Extent, metres_x: float, metres_y: float) -> None:
        across, down = (extent[2] - extent[0]) * metres_x, (extent[3] - extent[1]) * metres_y
        self.metres_per_mm = max(across / _WIDTH, down / _HEIGHT, 1e-9)
        self._x, self._y = metres_x / self.metres_per_mm, metres_y / self.metres_per_mm
        self.width, self.height = max(across / self.metres_per_mm, _NARROWEST), down / self.metres_per_mm
        self._left = extent[0] - (self.width - across / self.metres_per_mm) / 2 / self._x
        self._top = extent[3]

    def box(self, extent: Extent) -> tuple[float, float, float, float]:
        """Left, top, width and height."""
        left, top = (extent[0] - self._left) * self._x, (self._top - extent[3]) * self._y
        return left, top, (extent[2] - extent[0]) * self._x, (extent[3] - extent[1]) * self._y


def _seen_box(frame: _Frame, shape: SketchShape) -> tuple[float, float, float, float]:
    """Not smaller than can be seen."""
    x, y, width, height = frame.box(shape.extent)
    wider, higher = max(_SMALLEST - width, 0), max(_SMALLEST - height, 0)
    return x - wider / 2, y - higher / 2, width + wider, height + higher


def _shape(frame: _Frame, shape: SketchShape) -> str:
    x, y, width, height = _seen_box(frame, shape)
    place = f'x="{x:.2f}" y="{y:.2f}" width="{width:.2f}" height="{height:.2f}"'
    drawn = (
        f'<rect {place} fill="none" stroke="#fff" stroke-width="1"/><rect {place} fill="{text(shape.colour)}" '
        f'fill-opacity=".3" stroke="{text(shape.colour)}" stroke-width=".6"/><title>{text(shape.tip)}</title>'
    )
    return f'<a href="#{text(shape.anchor)}">{drawn}</a>' if shape.anchor else f"<g>{drawn}</g>"


def _labels(frame: _Frame, shapes: Sequence[SketchShape]) -> list[str]:
    """The labels there is room for, the last shape's first."""
    taken: list[tuple[float, float]] = []
    parts = []
    for shape in reversed(shapes):
        x, y, width, height = _seen_box(frame, shape)
        across, down = x + width / 2, y + height / 2 + 0.36 * _LETTERS
        reach = max(_CROWDED, 0.65 * _LETTERS * len(shape.label))
        if all(abs(across - a) > reach or abs(down - b) > _LETTERS for a, b in taken):
            taken.append((across, down))
            parts.append(
                f'<text x="{across:.2f}" y="{down:.2f}" text-anchor="middle" fill="#111" stroke="#fff" '
                f'stroke-width=".8" paint-order="stroke" pointer-events="none">{text(shape.label)}</text>'
            )
    return parts


def _scale_bar(frame: _Frame) -> list[str]:
    """A round length of about a quarter of the width, in two halves."""
    most = 0.3 * frame.width * frame.metres_per_mm
    decade = 10.0 ** math.floor(math.log10(most))
    metres = max(digit * decade for digit in (1, 2, 5) if digit * decade <= most)
    length, y = metres / frame.metres_per_mm, frame.height + 2.0
    words = f"{metres / 1000:g} km" if metres >= 1000 else f"{metres:g} m"
    bar = 'height="1.4" stroke="#111" stroke-width=".2"'
    return [
        f'<rect x="1" y="{y:.2f}" width="{length / 2:.2f}" fill="#111" {bar}/>',
        f'<rect x="{1 + length / 2:.2f}" y="{y:.2f}" width="{length / 2:.2f}" fill="#fff" {bar}/>',
        f'<text x="1" y="{y + 5.2:.2f}" text-anchor="middle" dx="1">0</text>',
        f'<text x="{1 + length:.2f}" y="{y + 5.2:.2f}" text-anchor="middle">{words}</text>',
    ]


def _north_arrow(frame: _Frame, north: str) -> str:
    x, y = frame.width - 5, frame.height + 1.2
    return (
        f'<path d="M{x:.2f} {y:.2f} l2 6.5 l-2 -1.6 l-2 1.6 z" fill="#111"/>'
        f'<text x="{x:.2f}" y="{y + 9.4:.2f}" text-anchor="middle" font-weight="bold">{text(north)}</text>'
    )
