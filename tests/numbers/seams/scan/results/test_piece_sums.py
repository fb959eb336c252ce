"""Pieces of seam add up to what a window says of the same seam: a window is a scan of one piece."""
from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.seams.measure.blocks.scan_block import CELLS
from seam_inspector.plugin.seams.measure.judgement.visibility import white_grey, window_visibility
from seam_inspector.plugin.seams.measure.profile.cell_table import CELL_PX, EDGES_PX, CellTable, MixtureTable
from seam_inspector.plugin.seams.measure.profile.ground import grounds
from seam_inspector.plugin.seams.measure.profile.seam_profile import STRIP_PX, Measure
from seam_inspector.plugin.seams.measure.scan.piece_sums import without_even
from seam_inspector.plugin.seams.measure.scan.scan_result import PieceFigures, judge_piece

from tests.numbers.seams.profile.blends import LEVELS, SIDE, blend
from tests.numbers.seams.scan.results.one_window import GRID, WINDOW, pieces_of, profiles_of, sums_of

WIDTHS = [0, 13, 33, 66, 100]


@pytest.mark.parametrize("seed", [0, 3])
@pytest.mark.parametrize("width", WIDTHS)
def test_a_seam_of_one_piece_keeps_what_its_window_keeps(width: int, seed: int) -> None:
    made = blend(width, seed=seed)
    detail = made.detail()
    expected = detail.profile
    (measured,) = profiles_of(detail, pieces_of(made))
    assert measured.profile.kept == pytest.approx(expected.kept, rel=0.01)
    assert (measured.profile.low, measured.profile.high) == pytest.approx((expected.low, expected.high), rel=0.03)
    assert measured.profile.band_width_px == pytest.approx(expected.band_width_px, abs=2)
    assert measured.profile.feather_width_px == pytest.approx(expected.feather_width_px, abs=1)
    assert measured.profile.added_beside == pytest.approx(expected.added_beside, abs=0.02)
    assert measured.profile.measure is expected.measure
    assert measured.profile.lost == pytest.approx(expected.lost, rel=0.05, abs=2000)


def test_one_half_feathered_shows_in_its_pieces_only() -> None:
    hard, soft = blend(0), blend(33)
    half = np.arange(SIDE)[:, np.newaxis] < SIDE // 2
    made = replace(hard, weights=np.where(half, soft.weights, hard.weights))
    parts = [strip.profile for strip in profiles_of(made.detail(), pieces_of(hard, 4))]
    assert max(part.kept[0] for part in parts[:2]) < 0.85
    assert min(part.kept[0] for part in parts[2:]) > 0.93
    assert [part.feather_width_px > 10 for part in parts] == [True, True, False, False]


def test_blocks_add_up_in_any_order() -> None:
    made = blend(33)
    detail, pieces = made.detail(), pieces_of(made, 3)
    ground = detail.ground

    def part(upper: bool, left: bool) -> tuple[CellTable, MixtureTable]:
        half = SIDE // CELL_PX // 2
        rows = slice(0, half) if upper else slice(half, 2 * half)
        place = rows, slice(0, half) if left else slice(half, 2 * half)
        return detail.cells.within(place), detail.mixture.within(place)

    parts = [part(upper, left) for upper in (True, False) for left in (True, False)]
    profiles = []
    for order in ([(detail.cells, detail.mixture)], parts, parts[::-1]):
        sums = sums_of(pieces)
        for cells, mixture in order:
            sums.add(cells, mixture, ground, WINDOW)
        profiles.append([profile.profile for profile in sums.profiles()])
    for others in profiles[1:]:
        for expected, other in zip(profiles[0], others):
            assert other.kept == pytest.approx(expected.kept, rel=1e-6)
            assert other.low == pytest.approx(expected.low, rel=1e-3)
            assert other.high == pytest.approx(expected.high, rel=1e-3)
            assert other.feather_width_px == pytest.approx(expected.feather_width_px, rel=1e-3)


MOSAIC = Raster(RasterRef("mosaic.tif"), SIDE, SIDE, None, "", ("band_1",), "uint8")


@pytest.mark.parametrize("width", [0, 33, 66])
def test_a_piece_is_seen_as_its_window_is(width: int) -> None:
    made = blend(width)
    detail, count = made.detail(), SIDE // CELL_PX
    grey = np.full((CELLS, CELLS), np.nan, np.float32)
    grey[:count, :count] = made.made.reshape(count, CELL_PX, count, CELL_PX).mean(axis=(1, 3))
    whole = slice(0, SIDE), slice(0, SIDE)
    expected = window_visibility(detail.profile, detail.judged, made.made, whole, MOSAIC)
    (made_piece,) = pieces_of(made)
    sums = sums_of([made_piece])
    sums.add(detail.cells, detail.mixture, detail.ground, WINDOW, grey)
    grey, brightest = sums.grey
    (strip,) = sums.profiles()
    judged = judge_piece(PieceFigures(made_piece, strip, *grey), ("a", "b"), 0.1, white_grey(MOSAIC, brightest))
    assert judged.visibility == pytest.approx(expected, rel=0.03, abs=0.03)
    assert (judged.visibility > 1) == (width > 0)


def test_without_ground_the_mixture_is_measured_and_without_both_nothing() -> None:
    made = blend(33)
    detail = made.detail()
    beside = replace(detail, cells=detail.cells.chosen(detail.cells.bin < EDGES_PX.index(24)))
    assert grounds(beside.cells) == [None] * LEVELS
    mixture = detail.mixture.chosen(detail.mixture.bin < EDGES_PX.index(24))
    (measured,) = profiles_of(replace(beside, mixture=mixture), pieces_of(made))
    assert measured.profile.measure is Measure.MIXTURE
    assert measured.profile.kept[0] == pytest.approx(made.truth(), abs=0.05)
    (nothing,) = profiles_of(replace(beside, mixture=MixtureTable.empty(LEVELS)), pieces_of(made))
    assert nothing.profile is None


def test_a_line_far_off_the_seam_does_not_take_its_loss_over() -> None:
    made = blend(33)
    detail = made.detail()
    (piece,) = pieces_of(made)
    moved = [replace(piece, vertices=piece.vertices + (by * GRID.pixel_width, 0)) for by in (30.0, 90.0)]
    near, far = (profiles_of(detail, [piece])[0].profile for piece in moved)
    assert near.kept[0] == pytest.approx(profiles_of(detail, [piece])[0].profile.kept[0], abs=0.1)
    assert far is None


@pytest.mark.parametrize(("grain", "grey", "is_measured"), [
    (9.0, 600.0, True), (0.06, 600.0, False), (0.0, 0.4, False), (0.001, 0.4, True), (np.nan, 600.0, True),
    (0.0, np.nan, True),
])  # fmt: skip
def test_a_piece_along_even_ground_is_not_measured(grain: float, grey: float, is_measured: bool) -> None:
    made = blend(33)
    profiles = profiles_of(made.detail(), pieces_of(made))
    (piece,) = without_even(profiles, np.array([grain]), np.array([grey]))
    assert (piece.profile is not None) == is_measured
    assert piece.area_px == profiles[0].area_px


def test_the_fit_is_that_of_the_strip() -> None:
    made = blend(33)
    detail = made.detail()
    table = detail.cells
    strip = table.bin < EDGES_PX.index(STRIP_PX)
    (measured,) = profiles_of(detail, pieces_of(made))
    mm, cc, mc = (float(sums[0, strip].sum()) for sums in (table.mm, table.cc, table.mc))
    assert measured.fit == pytest.approx(mc**2 / (mm * cc), rel=1e-4)
    assert measured.area_px == pytest.approx(table.area[0, strip].sum())
