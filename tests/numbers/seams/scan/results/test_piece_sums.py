"""Pieces of seam add up to what a window says of the same seam."""
from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.seams.measure.profile.detail_cells import CELL_PX, EDGES_PX
from seam_inspector.plugin.seams.measure.profile.seam_profile import STRIP_PX, seam_profile
from seam_inspector.plugin.seams.measure.scan.blocks.cell_table import CellTable
from seam_inspector.plugin.seams.measure.scan.blocks.scan_block import CELLS
from seam_inspector.plugin.seams.measure.scan.lines.piece_index import PieceIndex
from seam_inspector.plugin.seams.measure.scan.results.block_ground import grounds, whole_cells
from seam_inspector.plugin.seams.measure.scan.results.piece_sums import PieceSums
from seam_inspector.plugin.seams.measure.visibility import window_visibility

from tests.numbers.seams.profile.blends import LEVELS, SIDE, blend
from tests.numbers.seams.scan.results.one_window import GRID, WINDOW, pieces_of, profiles_of, table_of

WIDTHS = [0, 13, 33, 66, 100]

# --- one seam in one window -------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", [0, 3])
@pytest.mark.parametrize("width", WIDTHS)
def test_a_seam_of_one_piece_keeps_what_its_window_keeps(width: int, seed: int) -> None:
    made = blend(width, seed=seed)
    cells = made.cells()
    expected = seam_profile(cells)
    (found,) = profiles_of(table_of(cells), pieces_of(made))
    assert expected is not None
    assert found.profile is not None
    assert found.profile.kept == pytest.approx(expected.kept, rel=0.01)
    assert (found.profile.low, found.profile.high) == pytest.approx((expected.low, expected.high), rel=0.03)
    assert found.profile.band_width_px == pytest.approx(expected.band_width_px, abs=2)
    assert found.profile.added_beside == pytest.approx(expected.added_beside, abs=0.02)


@pytest.mark.parametrize("width", WIDTHS)
def test_it_holds_what_pywavelets_says(width: int) -> None:
    made = blend(width)
    (found,) = profiles_of(table_of(made.cells()), pieces_of(made))
    assert found.profile is not None
    assert found.profile.kept[0] == pytest.approx(made.truth(0, STRIP_PX), abs=0.05)
    assert found.profile.low < made.truth(0, STRIP_PX) < found.profile.high


def test_bins_are_those_of_the_window() -> None:
    made = blend(66)
    cells = made.cells()
    expected = seam_profile(cells)
    (found,) = profiles_of(table_of(cells), pieces_of(made))
    assert expected is not None
    assert found.profile is not None
    window_bins = {one.near_px: one for one in expected.bins if one.level == 1 and one.far_px <= 96}
    piece_bins = {one.near_px: one for one in found.profile.bins if one.far_px <= 96}
    assert piece_bins.keys() == window_bins.keys()
    for near, one in piece_bins.items():
        assert one.kept == pytest.approx(window_bins[near].kept, rel=0.01)
        assert one.area_px == pytest.approx(window_bins[near].area_px)


def test_the_fit_is_that_of_the_strip() -> None:
    made = blend(33)
    table = table_of(made.cells())
    strip = table.bin < EDGES_PX.index(STRIP_PX)
    (found,) = profiles_of(table, pieces_of(made))
    mm, cc, mc = (float(one[0, strip].sum()) for one in (table.mm, table.cc, table.mc))
    assert found.fit == pytest.approx(mc**2 / (mm * cc), rel=1e-4)
    assert found.area_px == pytest.approx(table.area[0, strip].sum())


# --- more pieces, more blocks -----------------------------------------------------------------------------------


def test_pieces_share_the_strip_and_their_mean_is_the_whole() -> None:
    made = blend(33)
    table = table_of(made.cells())
    (whole,) = profiles_of(table, pieces_of(made))
    parts = profiles_of(table, pieces_of(made, 4))
    assert sum(one.area_px for one in parts) == pytest.approx(whole.area_px)
    areas = np.array([one.area_px for one in parts])
    assert areas.min() > 0.15 * areas.sum()
    kept = np.array([one.profile.kept[0] for one in parts if one.profile])
    assert kept.min() < whole.profile.kept[0] < kept.max()
    assert np.average(kept, weights=areas) == pytest.approx(whole.profile.kept[0], abs=0.04)
    for one in parts:
        assert one.profile.high / one.profile.low > whole.profile.high / whole.profile.low


def test_one_half_feathered_shows_in_its_pieces_only() -> None:
    hard, soft = blend(0), blend(33)
    mosaic = np.where(np.arange(SIDE)[:, np.newaxis] < SIDE // 2, soft.made, hard.made)
    parts = profiles_of(table_of(hard.cells(mosaic)), pieces_of(hard, 4))
    kept = [one.profile.kept[0] for one in parts]
    assert max(kept[:2]) < 0.85
    assert min(kept[2:]) > 0.93


def test_blocks_add_up_in_any_order() -> None:
    made = blend(33)
    table, pieces = table_of(made.cells()), pieces_of(made, 3)
    ground, index = grounds(table, table), PieceIndex(pieces, GRID)
    upper = table.row < SIDE // CELL_PX // 2
    left = table.column < SIDE // CELL_PX // 2
    parts = [table.chosen(rows & columns) for rows in (upper, ~upper) for columns in (left, ~left)]
    found = []
    for order in ([table], parts, parts[::-1]):
        sums = PieceSums(len(pieces), LEVELS)
        for part in order:
            sums.add(part, ground, index, WINDOW)
        found.append(sums.profiles())
    for others in found[1:]:
        for one, other in zip(found[0], others):
            assert other.profile.kept == pytest.approx(one.profile.kept, rel=1e-6)
            assert other.profile.low == pytest.approx(one.profile.low, rel=1e-3)
            assert other.profile.high == pytest.approx(one.profile.high, rel=1e-3)


# --- what an eye sees of it -------------------------------------------------------------------------------------

MOSAIC = Raster(RasterRef("mosaic.tif"), SIDE, SIDE, None, "", ("band_1",), "uint8")


@pytest.mark.parametrize("width", [0, 33, 66])
def test_a_piece_is_seen_as_its_window_is(width: int) -> None:
    made = blend(width)
    cells, count = made.cells(), SIDE // CELL_PX
    grey = np.full((CELLS, CELLS), np.nan, np.float32)
    grey[:count, :count] = made.made.reshape(count, CELL_PX, count, CELL_PX).mean(axis=(1, 3))
    expected = window_visibility(seam_profile(cells), cells, made.made, MOSAIC)
    (found,) = profiles_of(table_of(cells), pieces_of(made), grey, MOSAIC)
    assert found.visibility == pytest.approx(expected, rel=0.03, abs=0.03)
    assert (found.visibility > 1) == (width > 0)


def test_a_piece_on_ground_of_unknown_brightness_is_not_said_to_be_seen() -> None:
    made = blend(66)
    table, pieces = table_of(made.cells()), pieces_of(made)
    grey = np.full((CELLS, CELLS), 120, np.float32)
    for known in ({}, {"grey": grey}, {"mosaic": MOSAIC}):
        (found,) = profiles_of(table, pieces, **known)
        assert found.profile is not None
        assert found.visibility is None


# --- too little -------------------------------------------------------------------------------------------------


def test_a_piece_that_no_cell_is_near_to_is_not_measured() -> None:
    made = blend(0)
    table = table_of(made.cells())
    (found,) = profiles_of(table.chosen(table.bin >= EDGES_PX.index(64)), pieces_of(made))
    assert found.profile is None
    assert found.area_px == 0
    assert found.fit == 0


def test_without_ground_nothing_is_measured() -> None:
    made = blend(0)
    table = table_of(made.cells())
    beside = table.chosen(table.bin < EDGES_PX.index(24))
    assert grounds(beside, beside) == [None] * LEVELS
    (found,) = profiles_of(beside, pieces_of(made))
    assert found.profile is None


def test_a_table_without_rows_adds_nothing() -> None:
    made = blend(0)
    empty = CellTable.empty(LEVELS)
    assert grounds(empty, empty) == [None] * LEVELS
    (found,) = profiles_of(empty, pieces_of(made))
    assert found.profile is None
    assert profiles_of(table_of(made.cells()), []) == []


# --- the ground -------------------------------------------------------------------------------------------------


def test_cells_of_several_bins_are_put_together() -> None:
    cells = blend(33).cells()
    whole = whole_cells(table_of(cells))
    assert len(whole.row) == (SIDE // CELL_PX) ** 2
    for name in ("area", "mm", "cc", "mc"):
        expected = getattr(cells, name).sum(axis=1).reshape(LEVELS, -1)
        assert getattr(whole, name) == pytest.approx(expected, rel=1e-5, abs=1e-2)
    assert (whole.nearest == (cells.area[0] > 0).argmax(axis=0).ravel()).all()


def test_a_block_with_little_ground_takes_its_neighbours() -> None:
    made = blend(33)
    table = table_of(made.cells())
    few = table.chosen((table.row < 1) & (table.column < 20))
    assert grounds(few, few)[0] is None
    (own, around) = (grounds(one, table)[0] for one in (table, few))
    assert own is not None
    assert around is not None
    energies = np.geomspace(1, 500, 20)
    assert around.response.amplitude(energies) == pytest.approx(own.response.amplitude(energies), rel=1e-6)


@pytest.mark.parametrize("gain", [0.5, 1.0, 1.7])
def test_what_was_done_to_all_cancels(gain: float) -> None:
    made = blend(33)
    plain, changed = (profiles_of(table_of(made.cells(mosaic)), pieces_of(made))[0].profile
                      for mosaic in (made.made, gain * made.made))
    assert changed.kept == pytest.approx(plain.kept, rel=0.01)
    assert changed.high == pytest.approx(plain.high, rel=0.02)


def test_ground_that_a_wide_feather_reached_widens_the_interval() -> None:
    narrow, wide = (profiles_of(table_of(one.cells()), pieces_of(one))[0].profile for one in (blend(33), blend(300)))
    assert wide.high / wide.low > 1.1 * narrow.high / narrow.low


def test_a_line_far_off_the_seam_does_not_take_its_loss_over() -> None:
    made = blend(33)
    table = table_of(made.cells())
    (piece,) = pieces_of(made)
    moved = [replace(piece, vertices=piece.vertices + (by * GRID.pixel_width, 0)) for by in (30.0, 90.0)]
    near, far = (profiles_of(table, [one])[0].profile for one in moved)
    assert near is not None
    assert near.kept[0] == pytest.approx(profiles_of(table, [piece])[0].profile.kept[0], abs=0.1)
    assert far is None
