"""The verdict on a piece of seam, and the windows of the worst ones."""
from __future__ import annotations

from typing import Callable

import numpy as np
import pytest
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.imagery.seam_totals import PieceState
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict
from seam_inspector.plugin.seams.measure.profile.seam_profile import ProfileBin, SeamProfile
from seam_inspector.plugin.seams.measure.profile.seam_sums import StripProfile
from seam_inspector.plugin.seams.measure.scan.scan_result import (
    JudgedPiece,
    PieceFigures,
    judge_piece,
    metres,
    worst_windows,
)
from seam_inspector.plugin.seams.measure.seamlines.seam_pieces import SeamPiece

from tests.numbers.synthetic import write_raster

GSD = 0.25
ROWS, COLUMNS = 2400, 3000


def piece(column: float = 500, row: float = 500, length_m: float = 25.0, seam_id: int = 1) -> SeamPiece:
    """That runs to the right, its middle at a pixel."""
    half = length_m / GSD / 2
    xs = 500000 + (column + np.array([-half, half])) * GSD
    return SeamPiece(seam_id, 100.0, length_m, np.column_stack([xs, [5000000 - row * GSD] * 2]), 0, 1)


def profile(kept: float, low: float, high: float, width_px: float = 0.0) -> StripProfile:
    beside = ProfileBin(1, 0, 2, kept, np.nan, np.nan, np.nan, 500.0)
    return StripProfile(SeamProfile((kept, kept, kept), low, high, width_px, 0.0, (beside,)), 4000.0, 0.9, 1.0)


def judged(kept: float | None, *place: float, **of_piece: float) -> JudgedPiece:
    strip = StripProfile(None, 0.0, 0.0, 0.0) if kept is None else profile(kept, 0.9 * kept, 1.1 * kept)
    return judge_piece(PieceFigures(piece(*place, **of_piece), strip), ("a.tif", "b.tif"), GSD, 255.0)  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def mosaic(tmp_path_factory: pytest.TempPathFactory) -> Raster:
    pixels = np.full((ROWS, COLUMNS), 100, np.uint8)
    return describe_mosaic(RasterRef(write_raster(tmp_path_factory.mktemp("m") / "mosaic.tif", pixels, gsd=GSD)))


@pytest.mark.parametrize(("kept", "low", "high", "verdict"), [
    (1.0, 0.9, 1.1, Verdict.PRESERVED), (0.95, 0.85, 1.02, Verdict.PRESERVED), (0.9, 0.83, 0.97, Verdict.REDUCED),
    (0.5, 0.42, 0.6, Verdict.SIGNIFICANT), (0.9, 0.4, 1.9, Verdict.NOT_COMPARABLE),
    (0.6, 0.45, 0.88, Verdict.REDUCED),
])
def test_a_verdict_follows_kept_and_its_interval(kept: float, low: float, high: float, verdict: Verdict) -> None:
    result = judge_piece(PieceFigures(piece(), profile(kept, low, high, 8.0)), ("a.tif", None), GSD, 255.0)
    assert result.verdict == verdict
    assert (result.least_kept, result.low, result.high) == (kept, low, high)
    assert result.band_width_m == pytest.approx(8.0 * GSD)
    is_doubtful = verdict == Verdict.NOT_COMPARABLE or kept == 0.6  # may be significant
    assert (result.reason is not None) == is_doubtful
    assert (result.left, result.right) == ("a.tif", None)


def test_a_piece_that_was_not_measured_says_why() -> None:
    long, short = judged(None), judged(None, length_m=2.0)
    for result in (long, short):
        assert result.verdict == Verdict.NOT_COMPARABLE
        assert result.kept is result.low is result.high is result.band_width_m is result.least_kept is None
        assert result.visibility is None
    assert str(long.reason) != str(short.reason)
    assert "2" in str(short.reason)


def test_metres_are_counted_by_what_pieces_count_as() -> None:
    pieces = [judged(0.4), judged(1.0, length_m=10.0), judged(None, length_m=7.5)]
    assert metres(pieces) == 42.5
    assert metres(pieces, PieceState.FAILED) == 25.0
    assert metres(pieces, PieceState.PASSED, PieceState.NOT_MEASURED) == 17.5
    assert metres([], PieceState.FAILED) == 0


def test_ground_without_detail_has_nothing_to_lose() -> None:
    """Only where nothing could be measured, and where the orthoimages show hardly more than noise."""
    nothing, measured = StripProfile(None, 0.0, 0.0, 0.0), profile(0.5, 0.45, 0.55)
    for strip, grain, state in (
        (nothing, 0.5 / 255, PieceState.NO_DETAIL), (nothing, 4 / 255, PieceState.NOT_MEASURED),
        (nothing, np.nan, PieceState.NOT_MEASURED), (measured, 0.5 / 255, PieceState.FAILED),
    ):
        result = judge_piece(PieceFigures(piece(), strip, grain=255 * grain), ("a.tif", "b.tif"), GSD, 255.0)
        assert result.state is state
        assert (result.verdict is Verdict.NOT_COMPARABLE) == (state is not PieceState.FAILED)


def everywhere(window: PixelWindow) -> bool:
    return True


def windows(mosaic: Raster, *pieces: JudgedPiece, count: int = 50,
            is_valid: Callable[[PixelWindow], bool] | None = everywhere) -> list[PixelWindow]:
    return [placed.window for placed in worst_windows(pieces, mosaic, count, 3, is_valid)]


def test_the_least_kept_come_first_each_around_its_piece(mosaic: Raster) -> None:
    places = {0.9: (400, 400), 0.5: (2500, 500), 0.7: (1500, 1900)}
    pieces = [judged(kept, *place) for kept, place in places.items()]
    worst = worst_windows(pieces, mosaic, 50, 3, everywhere)
    assert [placed.window_id for placed in worst] == [1, 2, 3]
    for placed, kept in zip(worst, (0.5, 0.7, 0.9)):
        assert placed.window.column + placed.window.width / 2 == pytest.approx(places[kept][0], abs=1)
        assert placed.window.row + placed.window.height / 2 == pytest.approx(places[kept][1], abs=1)
        assert placed.station_m == pytest.approx(112.5)
        assert placed.window.width == placed.window.height == 512  # the power of two beyond 100 m


def test_of_windows_that_share_more_than_half_only_the_worse_stays(mosaic: Raster) -> None:
    kept_windows = windows(mosaic, judged(0.6, 1000, 1000), judged(0.5, 1100, 1000), judged(0.7, 1600, 1000))
    assert [window.column + window.width // 2 for window in kept_windows] == [1100, 1600]


def test_beside_missing_pixels_a_window_is_moved_or_made_smaller(mosaic: Raster) -> None:
    def right_of(edge: int) -> Callable[[PixelWindow], bool]:
        return lambda window: window.column >= edge

    (moved,) = windows(mosaic, judged(0.5, 1000, 1000), is_valid=right_of(900))
    assert moved.column >= 900
    assert moved.width == 512
    assert moved.column <= 1000 < moved.column + moved.width
    (aside,) = windows(mosaic, judged(0.5, 1000, 1000), is_valid=lambda at: at.column >= 850 and at.row >= 850)
    assert (aside.column, aside.row, aside.width) == (872, 872, 512)  # the piece crosses more than a corner of it
    (smaller,) = windows(mosaic, judged(0.5, 1000, 1000), is_valid=lambda window: window.width <= 200)
    assert smaller.width == 128
    assert windows(mosaic, judged(0.5, 1000, 1000), is_valid=lambda window: False) == []
