"""Windows of standard size, drawn rectangles snapped to pixels, and sentences for those that can't be measured."""
from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.errors import SettingsError, WindowError
from seam_inspector.plugin.imagery.grids import Extent, Grid, PixelWindow, snap_window, standard_side_px

LEFT, TOP = 500000.0, 5000000.0


def grid(gsd: float = 0.1, columns: int = 4000, rows: int = 3000, **metres: float) -> Grid:
    return Grid(LEFT, TOP, gsd, gsd, columns, rows, **metres)


def extent(left: float, top: float, right: float, bottom: float, gsd: float = 0.1) -> Extent:
    """A rectangle by pixels from the upper left corner of ``grid``."""
    return (LEFT + left * gsd, TOP - bottom * gsd, LEFT + right * gsd, TOP - top * gsd)


@pytest.mark.parametrize(
    ("gsd", "side_m", "side_px"),
    [
        (0.10, 100, 1024),  # Pyka 2010, section 5
        (0.25, 100, 512),
        (0.05, 100, 2048),
        (0.03, 100, 4096),
        (100 / 1024, 100, 1024),  # spans 100 m exactly
        (0.09765625 - 1e-12, 100, 1024),  # and with a geotransform's rounding
        (0.0976, 100, 2048),
        (0.50, 100, 256),
        (0.10, 12.8, 128),
        (0.10, 12.81, 256),
        (30.0, 100, 4),
        (0.10, 0.05, 1),
    ],
)
def test_standard_side(gsd: float, side_m: float, side_px: int) -> None:
    assert standard_side_px(grid(gsd), side_m) == side_px


def test_standard_side_counts_metres_on_the_ground() -> None:
    in_feet = grid(0.5, metres_x=0.3048, metres_y=0.3048)
    assert standard_side_px(in_feet) == 1024  # 656.2 px
    in_degrees = grid(1e-6, metres_x=68678.0, metres_y=111258.0)  # at 52 degrees north
    assert standard_side_px(in_degrees) == 2048  # 1456 px of 0.0687 m, the shorter side
    assert in_degrees.ground_sample_distance == pytest.approx(0.068678)
    assert Grid(0, 0, 0.3, 0.2, 10, 10, 1.0, 2.0).ground_sample_distance == 0.3
    assert Grid(0, 0, 0.3, 0.2, 10, 10).ground_sample_distance == 0.2  # the shorter side


@pytest.mark.parametrize("side_m", [0.0, -100.0, math.nan, math.inf])
def test_a_side_that_is_no_length_is_refused(side_m: float) -> None:
    with pytest.raises(SettingsError, match="give a positive number of metres"):
        standard_side_px(grid(), side_m)


@pytest.mark.parametrize(
    ("drawn", "levels", "window"),
    [
        (extent(0, 0, 4000, 3000), 3, PixelWindow(0, 0, 4000, 3000)),
        (extent(100, 200, 1124, 1224), 3, PixelWindow(100, 200, 1024, 1024)),
        (extent(100, 200, 1124, 1224), 8, PixelWindow(100, 200, 1024, 1024)),
        (extent(100.4, 199.6, 1124.4, 1223.6), 3, PixelWindow(100, 200, 1024, 1024)),  # to the nearest pixel
        (extent(10, 10, 110, 80), 3, PixelWindow(12, 13, 96, 64)),  # trimmed evenly
        (extent(10, 10, 109, 81), 1, PixelWindow(10, 10, 98, 70)),
        (extent(10, 10, 143, 151), 6, PixelWindow(12, 16, 128, 128)),
        (extent(-500, -20, 100, 100), 2, PixelWindow(0, 0, 100, 100)),  # cut to the mosaic
        (extent(3900, 2900, 9999, 9999), 2, PixelWindow(3900, 2900, 100, 100)),
        (extent(-1e6, -1e6, 1e6, 1e6), 3, PixelWindow(0, 0, 4000, 3000)),
        (extent(7, 7, 71, 71), 3, PixelWindow(7, 7, 64, 64)),  # the smallest
        (extent(0, 0, 256, 300), 8, PixelWindow(0, 22, 256, 256)),
    ],
)
def test_snapping(drawn: Extent, levels: int, window: PixelWindow) -> None:
    assert snap_window(grid(), drawn, levels) == window


@given(
    left=st.floats(-300, 4300),
    top=st.floats(-300, 3300),
    width=st.floats(70, 2000),
    height=st.floats(70, 2000),
    levels=st.integers(1, 5),
)
def test_a_snapped_window_can_be_decomposed_and_covers_what_was_drawn(
    left: float, top: float, width: float, height: float, levels: int
) -> None:
    drawn, step = extent(left, top, left + width, top + height), 2**levels
    inside = max(left, 0), max(top, 0), min(left + width, 4000), min(top + height, 3000)
    try:
        window = snap_window(grid(), drawn, levels)
    except WindowError:
        assert min(inside[2] - inside[0], inside[3] - inside[1]) < 64 + step + 1
        return
    assert window.width % step == window.height % step == 0
    assert min(window.width, window.height) >= 64
    assert window.cut_to(4000, 3000) == window
    snapped = (window.column, window.row, window.column + window.width, window.row + window.height)
    assert max(abs(a - b) for a, b in zip(snapped, inside)) <= step / 2 + 1
    assert snap_window(grid(), grid().window_extent(window), levels) == window


@pytest.mark.parametrize(
    ("drawn", "levels", "sentence"),
    [
        (extent(-200, 0, -1, 200), 3, "outside the mosaic"),
        (extent(4001, 0, 4200, 200), 3, "outside the mosaic"),
        (extent(0, -200, 200, -1), 3, "outside the mosaic"),
        (extent(0, 3001, 200, 3200), 3, "outside the mosaic"),
        (extent(1e12, 1e12, 2e12, 2e12), 3, "outside the mosaic"),
        ((math.nan, 0, 1, 1), 3, "as numbers, the smaller ones first"),
        ((200, 0, 0, 200), 3, "from 200 to 0 and from 0 to 200"),
        ((-math.inf, -math.inf, math.inf, math.inf), 3, "outside the mosaic"),
        (extent(10, 10, 73, 200), 3, "covers 63 x 190 px of the mosaic; a side needs at least 64 px"),
        (extent(10, 10, 200, 72), 6, "covers 190 x 62 px"),
        (extent(10, 10, 10, 10), 3, "covers 0 x 0 px"),
        (extent(-200, 100, 30, 300), 3, "covers 30 x 200 px of the mosaic"),  # what lies on it counts
        (extent(100, 2990, 300, 3200), 3, "covers 200 x 10 px of the mosaic"),
        (extent(0, 0, 200, 300), 8, "covers 200 x 300 px of the mosaic; a side needs at least 256 px"),
        (extent(0, 0, 100, 100), 7, "a side needs at least 128 px, .*use fewer levels"),
    ],
)
def test_a_rectangle_that_cannot_be_measured_says_why(drawn: Extent, levels: int, sentence: str) -> None:
    with pytest.raises(WindowError, match=sentence):
        snap_window(grid(), drawn, levels)


def test_a_window_that_memory_could_not_hold_is_refused() -> None:
    huge = grid(columns=400_000, rows=400_000)
    with pytest.raises(WindowError, match="covers 400000 x 400000 px of the mosaic, but 67 million px"):
        snap_window(huge, huge.extent)
    assert snap_window(huge, extent(0, 0, 8192, 8192)).width == 8192
