"""Seams of which nothing is given but the mosaic and the seam lines: what they kept, and when that can be told."""
from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr
from scipy import ndimage
from seam_inspector.plugin.imagery.grids import Grid, PixelWindow
from seam_inspector.plugin.imagery.lines import find_seams
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict
from seam_inspector.plugin.seams.measure.limits import MAX_SIGNIFICANT_KEPT
from seam_inspector.plugin.seams.measure.scan.lone_kept import (
    COLOURLESS,
    LoneKept,
    LoneSeams,
    judge_pieces,
    judge_stretches,
    runs_of,
    verdict_of,
)
from seam_inspector.plugin.seams.measure.scan.lone_stretches import LoneTable, lone_cells, lone_stretches
from seam_inspector.plugin.seams.measure.seamlines.seam_pieces import PieceIndex, cut_in_pieces

from benchmarks.aftermaths import jpeg, nothing, unsharp
from tests.numbers.seams.scan.lone_mosaics import (
    SHAPE,
    WAVELET,
    LoneMosaic,
    brightness,
    image_of,
    lone_mosaic,
    pieces_along,
    seams_of,
    table_of,
)
from tests.numbers.synthetic import placed_wavedec, texture


def whole(seams: LoneSeams) -> LoneKept:
    kept = seams.kept()
    assert kept is not None
    return kept


def strip_energy(plane: np.ndarray, distance: np.ndarray) -> float:
    """Energy of the finest detail within 8 px of the seam, by PyWavelets."""
    energy = np.sum(np.square(placed_wavedec(plane, WAVELET, 1)[1]), axis=0)
    return float(energy[np.abs(distance[::2, ::2]) < 8].sum())


@pytest.fixture(scope="module")
def made() -> LoneMosaic:
    return lone_mosaic()


# --- what is kept ----------------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("width_px", [24, 48])
@pytest.mark.parametrize("in_common", [0.0, 0.5])
def test_a_feather_keeps_what_pywavelets_says(width_px: int, in_common: float) -> None:
    mosaic = lone_mosaic(seed=1, in_common=in_common, uneven=0.3)
    feathered = mosaic.blended(width_px)
    true = strip_energy(feathered, mosaic.distance) / strip_energy(mosaic.blended(0), mosaic.distance)
    feathered_kept, hard = whole(mosaic.seams(feathered)), whole(mosaic.seams(mosaic.blended(0)))
    assert feathered_kept.low <= true <= feathered_kept.high
    assert feathered_kept.kept / hard.kept == pytest.approx(true, abs=0.05)
    assert feathered_kept.tells_loss
    assert not hard.tells_loss


def test_a_hard_cut_holds_one(made: LoneMosaic) -> None:
    kept = whole(made.seams(made.blended(0)))
    assert kept.low <= 1 <= kept.high
    assert kept.band_width_px == 0


@pytest.mark.parametrize("width_px", [0, 48])
@pytest.mark.parametrize(
    "aftermath",
    [
        pytest.param(lambda plane: plane + (plane - ndimage.gaussian_filter(plane, 1.0)), id="unsharp"),
        pytest.param(lambda plane: plane + np.random.default_rng(0).normal(0, 3, plane.shape), id="noise"),
        pytest.param(lambda plane: ndimage.gaussian_filter(plane, 0.5), id="blur"),
        pytest.param(lambda plane: 16 * plane + 1000, id="12 bit"),
        pytest.param(lambda plane: 0.4 * plane, id="flat"),
    ],
)
def test_what_came_over_the_whole_mosaic_changes_nothing(made: LoneMosaic, width_px: int, aftermath) -> None:
    kept = whole(made.seams(np.asarray(aftermath(made.blended(width_px)), np.float32)))
    assert kept.tells_loss is bool(width_px)
    assert kept.low <= 1


def test_the_band_is_as_wide_as_the_feather_takes_a_tenth() -> None:
    mosaic = lone_mosaic()
    narrow, wide = (whole(mosaic.seams(mosaic.blended(width))).band_width_px for width in (24, 64))
    # A linear blend of textures with nothing in common keeps 0.9 at the weight s where s^2 + (1 - s)^2 is that.
    share = (1 - np.sqrt(0.8)) / 2
    assert narrow == pytest.approx(24 * (1 - 2 * share), abs=8)
    assert wide == pytest.approx(64 * (1 - 2 * share), abs=12)


def test_a_blurred_source_is_no_loss_along_the_seam(made: LoneMosaic) -> None:
    blurred = ndimage.gaussian_filter(made.second, 0.8)
    kept = whole(made.seams(np.where(made.distance > 0, blurred, made.first)))
    assert kept.low <= 1 <= kept.high


def test_a_seam_led_along_smooth_ground_is_no_loss() -> None:
    """Fallow land is smoother and has a colour of its own; the seam runs through it, more of it lies around."""
    rows, columns = SHAPE
    border = 384 + 20 * np.sin(np.arange(rows) / 200)
    pieces, grid = pieces_along(border, SHAPE, 512)
    across = np.arange(columns) - border[:, np.newaxis]
    fallow = np.abs((across + 48) % 96 - 48) < 30
    plane = np.where(fallow, 120 + 4 * texture(SHAPE, 1.2, 5), 110 + 8 * texture(SHAPE, 1.2, 6)).astype(np.float32)
    bands = np.stack([plane, plane, np.where(fallow, plane, 0.7 * plane)])
    share = strip_energy(plane, across) / (np.abs(across) < 8).sum() * plane.size / strip_energy(plane, 0 * across)
    assert share < 0.6
    kept = whole(seams_of(plane, pieces, grid, bands))
    assert kept.low <= 1 <= kept.high
    assert whole(seams_of(plane, pieces, grid)).kept < kept.kept  # the colour tells


def test_without_colour_more_has_to_be_lost(made: LoneMosaic) -> None:
    plane = made.blended(48)
    three, grey = (whole(made.seams(plane, bands)) for bands in (None, plane[np.newaxis]))
    assert grey.kept == pytest.approx(three.kept, abs=0.01)
    assert grey.high == pytest.approx(np.exp(COLOURLESS) * three.high, rel=0.02)


@pytest.mark.slow
def test_a_wide_feather_is_compared_with_what_lies_beyond() -> None:
    """The seam is long enough to tell."""
    mosaic = lone_mosaic(seed=1, rows=4096, uneven=0.2)
    wide, narrow, hard = (mosaic.seams(mosaic.blended(width)) for width in (120, 48, 0))
    assert (wide.range, narrow.range, hard.range) == (1, 0, 0)
    assert whole(wide).kept < 0.75


# --- intervals and verdicts ------------------------------------------------------------------------------------


@pytest.mark.slow
def test_intervals_of_pieces_cover_the_truth() -> None:
    """8 pieces each on 6 mosaics: hard cuts and feathers."""
    inside = []
    for seed in range(3):
        mosaic = lone_mosaic(256, 10 * seed)
        near = np.abs(mosaic.distance[::2, ::2]) < 8
        by_row = [
            (np.sum(np.square(placed_wavedec(mosaic.blended(width), WAVELET, 1)[1]), axis=0) * near).sum(axis=1)
            for width in (0, 40)
        ]
        for width, energies in zip((0, 40), by_row):
            by_piece = mosaic.seams(mosaic.blended(width)).by_piece()
            for kept, piece in zip(by_piece, mosaic.pieces):
                if kept is not None:
                    rows = slice(*sorted(int(SHAPE[0] - y) // 2 for y in piece.vertices[[0, -1], 1]))
                    inside.append(kept.low <= energies[rows].sum() / by_row[0][rows].sum() <= kept.high)
    assert len(inside) > 40
    assert np.mean(inside) >= 0.93


@pytest.mark.slow
def test_a_sound_piece_is_never_reduced_by_a_coin_toss() -> None:
    verdicts = []
    for seed in range(4):
        mosaic = lone_mosaic(128, 20 + seed)
        verdicts += [
            piece.verdict for piece in judge_pieces(mosaic.seams(mosaic.blended(0)), mosaic.pieces, 1.0)
        ]
    lossy = sum(verdict in (Verdict.REDUCED, Verdict.SIGNIFICANT) for verdict in verdicts)
    assert lossy <= 0.03 * len(verdicts)


def test_a_feather_is_significant_and_a_hard_cut_preserved(made: LoneMosaic) -> None:
    seams = made.seams(made.blended(48))
    feathered = judge_pieces(seams, made.pieces, 1.0)
    assert Verdict.PRESERVED not in {piece.verdict for piece in feathered}
    stretches = judge_stretches(seams, feathered, 1.0)
    assert {piece.verdict for piece in stretches} == {Verdict.SIGNIFICANT}
    sound = made.seams(made.blended(0))
    hard = judge_pieces(sound, made.pieces, 1.0)
    assert {piece.verdict for piece in hard} <= {Verdict.PRESERVED, Verdict.NOT_COMPARABLE}
    assert {piece.verdict for piece in judge_stretches(sound, hard, 1.0)} == {Verdict.PRESERVED}


def test_short_pieces_have_no_verdict_and_are_told_together() -> None:
    """A piece never says what only the seam around it tells."""
    mosaic = lone_mosaic(piece_px=32)
    seams = mosaic.seams(mosaic.blended(32))
    judged = judge_pieces(seams, mosaic.pieces, 1.0)
    assert [piece.verdict for piece in judged].count(Verdict.NOT_COMPARABLE) > 0.5 * len(judged)
    for piece in judged:
        assert piece.low is not None
        assert piece.high is not None
        if piece.verdict is Verdict.SIGNIFICANT:
            assert piece.high <= max(2 * piece.low, MAX_SIGNIFICANT_KEPT)
    stretches = judge_stretches(seams, judged, 1.0)
    spans = [(each.piece.station_m, each.piece.station_m + each.piece.length_m) for each in stretches]
    for piece in judged:
        if piece.verdict is Verdict.NOT_COMPARABLE:
            middle = piece.piece.station_m + piece.piece.length_m / 2
            assert any(first < middle < last for first, last in spans)
    for stretch in stretches:
        assert stretch.is_stretch
        assert stretch.verdict is Verdict.SIGNIFICANT
        assert stretch.piece.length_m > 40
        assert stretch.low is not None
        assert stretch.high is not None
        assert stretch.high <= 2 * stretch.low


def test_a_lonely_short_piece_says_how_much_seam_is_needed() -> None:
    """Two stretches of a feather in ground as uneven as it gets."""
    mosaic = lone_mosaic(piece_px=128, seed=3)
    seams = mosaic.seams(mosaic.blended(0))
    needed = seams.judgeable_px
    assert needed is not None
    assert 64 <= needed < 2048
    for piece in judge_pieces(seams, mosaic.pieces, 0.25):
        if piece.verdict is Verdict.NOT_COMPARABLE:
            assert piece.low is not None
            assert f"{100 * piece.low:.0f}" in str(piece.reason)


def test_more_seam_gives_narrower_intervals(made: LoneMosaic) -> None:
    seams = made.seams(made.blended(48))
    pieces = [stretch.high / stretch.low for stretch in seams.by_piece() if stretch is not None]
    half = seams.kept(range(len(made.pieces) // 2))
    assert half is not None
    assert whole(seams).high / whole(seams).low < half.high / half.low < np.median(pieces)


def test_verdicts_follow_the_interval() -> None:
    def kept(value: float, low: float, high: float) -> Verdict | None:
        return verdict_of(LoneKept(value, low, high, 0.0, 256.0))

    assert kept(0.6, 0.5, 0.8) is Verdict.SIGNIFICANT
    assert kept(0.6, 0.3, 0.8) is Verdict.REDUCED  # surely less than all, and no number
    assert kept(0.8, 0.7, 0.95) is Verdict.REDUCED
    assert kept(1.0, 0.75, 1.2) is Verdict.PRESERVED
    assert kept(0.8, 0.5, 1.3) is None


def test_runs_are_pieces_of_one_seam_in_a_row() -> None:
    assert runs_of([1, 1, 1, 1, 2, 2], [10, 10, 10, 10, 10, 10], 20) == [[0, 1], [2, 3], [4, 5]]
    assert runs_of([1, 1, 1, 2], [10, 10, 10, 5], 100) == [[0, 1, 2], [3]]
    assert runs_of([], [], 10) == []


# --- where nothing can be said ---------------------------------------------------------------------------------


def test_ground_on_one_side_alone_is_not_enough() -> None:
    mosaic = lone_mosaic()
    seams = mosaic.seams(mosaic.blended(48), valid=mosaic.distance < 40)
    assert seams.kept() is None
    (first, *_) = judge_pieces(seams, mosaic.pieces, 1.0)
    assert first.verdict is Verdict.NOT_COMPARABLE
    assert "one side" in str(first.reason)


def test_a_mosaic_without_detail_says_nothing(made: LoneMosaic) -> None:
    seams = made.seams(np.full(SHAPE, 100, np.float32))
    assert seams.kept() is None
    assert seams.judgeable_px is None


def test_no_seam_is_no_result(made: LoneMosaic) -> None:
    index = PieceIndex(made.pieces, made.grid)
    nothing_found = lone_stretches(LoneTable.empty(), made.pieces, range(len(made.pieces)), index, 1.0)
    assert LoneSeams(nothing_found, [1] * len(made.pieces)).kept() is None
    none = lone_stretches(LoneTable.empty(), made.pieces, [], index, 1.0)
    assert len(none) == 0
    assert judge_pieces(LoneSeams(none, []), [], 1.0) == []


# --- the table -------------------------------------------------------------------------------------------------


def test_cells_hold_what_pywavelets_says(made: LoneMosaic) -> None:
    plane = made.blended(48)
    table = table_of(plane, made.pieces, made.grid)
    finest = np.sum(np.square(placed_wavedec(plane, WAVELET, 1)[1]), axis=0)
    finest = finest.reshape(SHAPE[0] // 16, 8, SHAPE[1] // 16, 8).sum(axis=(1, 3))
    inner = (table.row > 6) & (table.row < SHAPE[0] // 16 - 7)  # PyWavelets goes round, the table mirrors
    place = table.row[inner], table.column[inner]
    energy = np.zeros_like(finest)
    np.add.at(energy, (table.row, table.column), table.energy)
    np.testing.assert_allclose(energy[place], finest[place], rtol=1e-3)
    np.testing.assert_array_equal(np.bincount(np.unique(table.keys, return_inverse=True)[1], table.area), 256)
    means = plane.reshape(SHAPE[0] // 16, 16, SHAPE[1] // 16, 16).mean(axis=(1, 3))
    np.testing.assert_allclose(table.colour[0], means[table.row, table.column], rtol=1e-5)


def test_zones_are_those_of_the_true_distance() -> None:
    pieces, grid = pieces_along(np.full(256, 160.0), (256, 320), 64)
    table = table_of(texture((256, 320)).astype(np.float32), pieces, grid)
    area = np.bincount(table.bin, table.area)
    np.testing.assert_array_equal(area[:5], 256 * 2 * np.array([4, 4, 4, 4, 8]))


def test_windows_with_margins_make_the_whole(made: LoneMosaic) -> None:
    plane, index = made.blended(48), PieceIndex(made.pieces, made.grid)
    once = table_of(plane, made.pieces, made.grid)
    parts = []
    for first in range(0, SHAPE[0], 512):
        top, bottom = max(first - 64, 0), min(first + 576, SHAPE[0])
        around, window = PixelWindow(0, top, SHAPE[1], bottom - top), PixelWindow(0, first, SHAPE[1], 512)
        given = plane[top:bottom]
        image = image_of(given, np.stack([given] * 3))
        parts.append(lone_cells(image, around, window, index.near(around, 128), WAVELET))
    again = pickle.loads(pickle.dumps(LoneTable.joined([LoneTable.empty(), *parts])))
    assert len(again) == len(once)
    for name in ("row", "column", "bin", "area"):
        np.testing.assert_array_equal(getattr(again, name), getattr(once, name))
    np.testing.assert_allclose(again.energy, once.energy, rtol=1e-3, atol=1e-2)
    np.testing.assert_allclose(again.colour, once.colour, rtol=1e-5)


def test_missing_pixels_and_what_lies_beside_them_take_no_part(made: LoneMosaic) -> None:
    valid = np.ones(SHAPE, bool)
    valid[800:832, 300:500] = False
    plane = made.blended(0)
    broken = np.where(valid, plane, np.nan).astype(np.float32)
    table = table_of(broken, made.pieces, made.grid, valid=valid)
    assert not ((table.row >= 49) & (table.row < 53) & (table.column >= 17) & (table.column < 33)).any()
    assert np.isfinite(table.energy).all()
    assert np.isfinite(table.colour).all()
    assert whole(made.seams(broken, valid=valid)).kept == pytest.approx(whole(made.seams(plane)).kept, abs=0.05)


# --- Brighton --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("aftermath", [nothing, unsharp(1.0), jpeg(75)], ids=["as it is", "unsharp 1", "JPEG 75"])
@pytest.mark.parametrize("name", ["hardseam", "feather0p4m"])
def test_brightons_feather_shows_and_its_hard_cut_does_not(data_folder: Path, name: str, aftermath) -> None:
    folder = data_folder / "seams" / "brighton"
    file = gdal.Open(str(folder / f"mosaic_{name}.tif"))
    left, size, _, top, _, _ = file.GetGeoTransform()
    bands = file.ReadAsArray()[:3]
    rows, columns = (length // 16 * 16 for length in bands.shape[1:])
    bands = bands[:, :rows, :columns]
    valid = (bands != 0).any(axis=0)
    grid = Grid(left, top, size, size, columns, rows)
    source = ogr.Open(str(folder / "seamlines.gpkg"))
    lines = [bytes(row.GetGeometryRef().ExportToWkb()) for row in source.GetLayerByName("seamlines")]
    pieces = cut_in_pieces([_Sided(seam.vertices) for seam in find_seams(lines, size)], 25.0, grid)
    changed = aftermath(bands, np.random.default_rng(0))
    kept = whole(seams_of(brightness(changed), pieces, grid, changed, valid))
    if name == "hardseam":
        assert kept.low <= 1 <= kept.high
    else:
        assert kept.high < 1
        assert kept.low <= 0.59 <= kept.high  # against the hard cut, as it is
        assert 20 < kept.band_width_px < 60


class _Sided:
    left = right = None

    def __init__(self, vertices: np.ndarray) -> None:
        self.vertices = vertices
