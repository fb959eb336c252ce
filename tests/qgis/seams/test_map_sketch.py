"""The sketch map of a report: to scale, readable, in the user's numbers."""
from __future__ import annotations

import pytest
from seam_inspector.plugin.seams.report.inspection_report import Box, Sketch, SketchBackground, SketchShape, map_sketch


def shape(x: float, y: float, label: str = "1", side: float = 100) -> SketchShape:
    return SketchShape((x, y, x + side, y + side), "#d55e00", label, "")


def boxes(sketch: Sketch) -> list[Box]:
    """Left, top, width and height in mm of the shapes, in the order they are drawn."""
    return [box for box, _ in sketch.shapes]


def millimetres_per_metre(sketch: Sketch) -> float:
    """Scale by the bar: mm on paper per metre."""
    number, unit = sketch.bar_words.split()
    return sketch.bar / (float(number) * {"km": 1000, "m": 1}[unit])


@pytest.mark.parametrize(
    ("step", "metres"), [(1000.0, (1.0, 1.0)), (0.01, (78000.0, 111000.0)), (2e5, (0.3048, 0.3048))]
)
def test_the_sketch_is_to_scale_and_north_is_up(step: float, metres: tuple[float, float]) -> None:
    side = step / 4
    sketch = map_sketch([shape(0, 0, "sw", side), shape(step, 2 * step, "ne", side)], *metres)
    south_west, north_east = boxes(sketch)
    scale = millimetres_per_metre(sketch)
    assert north_east[0] - south_west[0] == pytest.approx(step * metres[0] * scale, rel=0.01)
    assert south_west[1] - north_east[1] == pytest.approx(2 * step * metres[1] * scale, rel=0.01)
    assert south_west[2:] == pytest.approx((side * metres[0] * scale, side * metres[1] * scale), rel=0.01)
    assert sketch.width <= 170.01
    assert sketch.height + sketch.strip <= 132


def test_the_background_lies_where_its_pixels_do() -> None:
    shapes = [shape(0, 0), shape(900, 900)]
    background = SketchBackground(b"jpeg", (0, 0, 1000, 500))
    sketch = map_sketch(shapes, background=background)
    assert sketch.background is not None
    (x, y, width, height), jpeg = sketch.background
    assert jpeg == b"jpeg"
    first, last = boxes(sketch)
    assert (x, y + height) == pytest.approx((first[0], first[1] + first[3]), abs=0.02)
    assert x + width == pytest.approx(last[0] + last[2], abs=0.02)
    assert width == pytest.approx(2 * height, abs=0.02)
