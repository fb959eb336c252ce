"""Windows along seams: evenly, inside the mosaic, no place twice, and the log says where there are none."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from osgeo import ogr
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.grids import Grid
from seam_inspector.plugin.imagery.lines import Seam, find_seams
from seam_inspector.plugin.seams.measure import messages as seams_messages
from seam_inspector.plugin.seams.measure.planning.window_placing import (
    Placement,
    PlacingSettings,
    fitting_side_m,
    place_windows,
    window_side_px,
)

STANDARD = PlacingSettings(100, 200)
KILOMETRE = Grid(left=576000, top=5188000, pixel_width=0.5, pixel_height=0.5, columns=4000, rows=2000)
"""2000 m x 1000 m; a window of 100 m has 256 px, that is 128 m."""


def seam(*vertices: tuple[float, float], number: int = 1) -> Seam:
    """A seam by metres from the lower left corner of KILOMETRE."""
    return Seam(number, np.array(vertices, dtype=float) + (576000, 5187000))


def stations(placement: Placement, number: int = 1) -> list[float]:
    return [window.station_m for window in placement.windows if window.seam_id == number]


def templates(placement: Placement) -> list[str]:
    return [message.template for message in placement.dropped]


def point_at(vertices: np.ndarray, station: float) -> np.ndarray:
    along = np.append(0, np.cumsum(np.hypot(*np.diff(vertices, axis=0).T)))
    return np.array([np.interp(station, along, vertices[:, 0]), np.interp(station, along, vertices[:, 1])])


def test_windows_are_one_spacing_apart_and_centred_on_the_seam() -> None:
    placement = place_windows([seam((200, 500), (1250, 500))], KILOMETRE, STANDARD)
    assert stations(placement) == pytest.approx([125, 325, 525, 725, 925])
    assert [window.window_id for window in placement.windows] == [1, 2, 3, 4, 5]
    assert {(window.window.width, window.window.height) for window in placement.windows} == {(256, 256)}
    first = placement.windows[0].window
    assert (first.column + 128, first.row + 128) == (650, 1000)  # 325 m from the left, 500 m from the top
    assert placement.dropped == ()


def test_metres_are_counted_on_the_ground_when_the_map_is_in_degrees() -> None:
    degrees = Grid(15.0, 60.0, 1e-5, 5e-6, 4000, 4000, metres_x=55_800.0, metres_y=111_400.0)
    east = Seam(1, np.array([(15.005, 59.99), (15.025, 59.99)]))
    north = Seam(2, np.array([(15.035, 59.982), (15.035, 59.998)]))
    placement = place_windows([east, north], degrees, STANDARD)
    assert np.diff(stations(placement, 1)) == pytest.approx(200)
    assert np.diff(stations(placement, 2)) == pytest.approx(200)
    assert len(stations(placement, 1)) == round(0.02 * 55_800 / 200)
    assert len(stations(placement, 2)) == round(0.016 * 111_400 / 200)


def test_a_window_that_sticks_out_is_moved_along_the_seam() -> None:
    placement = place_windows([seam((0, 500), (220, 500))], KILOMETRE, PlacingSettings(200, 200))
    (window,) = placement.windows
    assert stations(placement) == pytest.approx([128], abs=0.25)
    assert window.window.column == 0
    assert placement.dropped == ()


def test_a_mosaic_smaller_than_the_window_says_both_sizes() -> None:
    small = Grid(0, 20, 0.1, 0.1, 300, 200)
    placement = place_windows([Seam(1, np.array([(0, 3), (25.6, 22.6)]))], small, PlacingSettings(25, 200))
    assert placement.windows == ()
    assert str(placement.dropped[0]) == (
        "The mosaic is 30.0 x 20.0 m, too small for a window of 25.6 m; give a shorter side."
    )


def test_a_spacing_shorter_than_half_a_window_gives_fewer_windows_and_says_how_many() -> None:
    placement = place_windows([seam((200, 500), (1200, 500))], KILOMETRE, PlacingSettings(100, 10))
    assert len(placement.windows) == pytest.approx(1000 / 64, abs=1)
    (message,) = placement.dropped
    assert message == seams_messages.WINDOWS_CROWDED(count=100 - len(placement.windows))


def test_a_seam_that_folds_back_is_measured_once() -> None:
    there_and_back = seam((200, 500), (1200, 500), (1200, 505), (200, 505))
    placement = place_windows([there_and_back], KILOMETRE, STANDARD)
    assert len(placement.windows) == 5
    assert templates(placement) == [seams_messages.WINDOWS_CROWDED.template]


def test_a_ring_does_not_end_where_it_began() -> None:
    turn = np.linspace(0, 2 * np.pi, 73)
    ring = seam(*zip(500 + 300 * np.cos(turn), 500 + 300 * np.sin(turn)))
    placement = place_windows([ring], KILOMETRE, STANDARD)
    assert len(placement.windows) == 9
    assert placement.dropped == ()


def test_seams_within_windows_of_longer_ones_have_none_and_one_sentence_says_so() -> None:
    loops = [seam((x, 510), (x + 15, 510), (x + 15, 520), number=number) for number, x in enumerate([290, 310, 490], 2)]
    placement = place_windows([seam((200, 500), (1200, 500)), *loops], KILOMETRE, STANDARD)
    assert {window.seam_id for window in placement.windows} == {1}
    assert placement.dropped == (seams_messages.SEAMS_LEFT_OUT(count=3, shortest=8.0),)


def test_specks_and_seams_outside_are_summed_up() -> None:
    specks = [seam((x, 800), (x + 2, 800), (x + 2, 802), number=x) for x in range(200, 700, 100)]
    outside = [seam((-900, y), (-200, y), number=1000 + y) for y in range(0, 900, 100)]
    placement = place_windows([*outside, *specks], KILOMETRE, STANDARD)
    assert placement.windows == ()
    assert placement.dropped == (seams_messages.SEAMS_LEFT_OUT(count=14, shortest=8.0),)


coordinate = st.one_of(st.floats(-300, 2300), st.integers(0, 40).map(lambda k: k * 50.0))
polylines = st.lists(st.tuples(coordinate, coordinate), min_size=2, max_size=8, unique=True)


@given(polylines, st.sampled_from([32, 50, 100, 250, 500]), st.floats(1, 600))
def test_what_every_placement_promises(points: Sequence[tuple[float, float]], side: float, spacing: float) -> None:
    line = seam(*points)
    placement = place_windows([line], KILOMETRE, PlacingSettings(side, spacing))
    for placed in placement.windows:
        assert placed.window.cut_to(KILOMETRE.columns, KILOMETRE.rows) == placed.window
        left, bottom, right, top = KILOMETRE.window_extent(placed.window)
        x, y = point_at(line.vertices, placed.station_m)
        # Centred: the seam point is nearer than half a pixel to the middle.
        assert max(abs(x - (left + right) / 2), abs(y - (bottom + top) / 2)) <= 0.2500001
    for a, b in combinations(placement.windows, 2):
        assert a.window.shared_pixels(b.window) <= a.window.width * a.window.height / 2
    assert stations(placement) == sorted(stations(placement))
    assert [placed.window_id for placed in placement.windows] == list(range(1, len(placement.windows) + 1))
    assert placement.windows or placement.dropped  # nothing is left out in silence


@given(polylines, st.floats(20, 600))
def test_the_direction_of_a_line_does_not_matter(points: Sequence[tuple[float, float]], spacing: float) -> None:
    path = seam(*points).vertices
    assume(np.ptp(path, axis=0).max() > 1)
    placements = []
    for vertices in (path, path[::-1]):
        text = ", ".join(f"{x!r} {y!r}" for x, y in vertices.tolist())
        geometry = bytes(ogr.CreateGeometryFromWkt(f"LINESTRING ({text})").ExportToWkb())
        placements.append(place_windows(find_seams([geometry], 0.5), KILOMETRE, PlacingSettings(100, spacing)))
    forth, back = placements
    assert [placed.window for placed in forth.windows] == [placed.window for placed in back.windows]


@pytest.mark.parametrize("length", [0, -5, float("nan"), float("inf")])
def test_lengths_are_positive(length: float) -> None:
    with pytest.raises(SettingsError, match="window side"):
        place_windows([seam((0, 0), (500, 500))], KILOMETRE, PlacingSettings(length, 200))
    with pytest.raises(SettingsError, match="spacing"):
        place_windows([seam((0, 0), (500, 500))], KILOMETRE, PlacingSettings(100, length))


def test_a_window_too_small_for_the_levels_says_how_long_it_must_be() -> None:
    line = seam((100, 500), (1900, 500))
    with pytest.raises(SettingsError, match=r"a side of 128\.0 m or more"):
        place_windows([line], KILOMETRE, PlacingSettings(60, 200, 8))
    with pytest.raises(SettingsError, match=r"a side of 32\.0 m or more"):
        place_windows([line], KILOMETRE, PlacingSettings(10, 200, 3))
    assert place_windows([line], KILOMETRE, PlacingSettings(128, 200, 8)).windows
    assert place_windows([line], KILOMETRE, PlacingSettings(32, 200, 3)).windows


def test_a_side_that_replaces_one_is_that_of_its_windows_to_the_centimetre() -> None:
    grid = Grid(left=576000, top=5188000, pixel_width=0.03, pixel_height=0.03, columns=2100, rows=2100)
    assert fitting_side_m(grid, STANDARD) == 15.36
    assert fitting_side_m(replace(grid, pixel_width=5.0, pixel_height=5.0), STANDARD) == 1280  # 256 px of 5 m
    assert fitting_side_m(replace(grid, pixel_width=1.0, pixel_height=1.0), STANDARD) == 256
    assert window_side_px(grid, PlacingSettings(15.36)) == 512


def test_a_moved_window_does_not_double_its_neighbour() -> None:
    placement = place_windows([seam((0, 500), (600, 500))], KILOMETRE, PlacingSettings(100, 70))
    assert stations(placement)[:2] == pytest.approx([90, 160])
    assert [str(message) for message in placement.dropped] == [
        ("Places along the seams without a window, which would stick out of the mosaic or hold too few valid pixels: "
        "1, on seam 1 (20.0 m).")
    ]


def test_a_seam_that_runs_too_near_the_edge_is_logged() -> None:
    placement = place_windows([seam((100, 20), (1900, 20))], KILOMETRE, STANDARD)
    assert placement.windows == ()
    (message,) = placement.dropped
    assert str(message) == (
        "Places along the seams without a window, which would stick out of the mosaic or hold too few valid pixels: "
        "1, on seam 1 (100.0\u20131700.0 m)."
    )
