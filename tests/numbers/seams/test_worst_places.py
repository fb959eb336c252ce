"""Places of a window that are looked at: those that lost most, or the seam where nothing is lost."""
from __future__ import annotations

import numpy as np
from seam_inspector.plugin.seams.measure.judgement.visibility import SHOWN_PX, worst_places
from seam_inspector.plugin.seams.measure.profile.window_detail import SAMPLE_PX, LossPicture

CELL, SIDE = 8, 512
NOTHING = np.empty((0, 2), np.uint16)


def picture(kept: np.ndarray, seam: np.ndarray = NOTHING) -> LossPicture:
    return LossPicture(kept.astype(np.float32), CELL, seam)


def even() -> np.ndarray:
    return np.full((SIDE // CELL, SIDE // CELL), 1.02)


def test_the_worst_place_comes_first_and_no_two_overlap() -> None:
    kept = even()
    kept[8:24, 8:24] = 0.6  # columns and rows 64 to 192
    kept[40:56, 36:52] = 0.3
    kept[0, 0] = np.nan
    spots = worst_places(picture(kept))
    assert len(spots) == 2
    for (column, row), (low, high, left, right) in zip(spots, ((320, 448, 288, 416), (64, 192, 64, 192))):
        half = SHOWN_PX / 2
        assert row - half <= low < high <= row + half + CELL  # all of it is shown, to a cell
        assert column - half <= left < right <= column + half + CELL


def test_a_place_that_lost_little_beside_the_worst_is_none() -> None:
    kept = even()
    kept[8:24, 8:24], kept[40:56, 36:52] = 0.9, 0.1
    assert len(worst_places(picture(kept))) == 1


def test_where_nothing_is_lost_the_seam_is_looked_at_from_its_middle_on() -> None:
    rows = np.arange(0, SIDE // SAMPLE_PX)
    seam = np.stack([rows, np.full_like(rows, 50)], axis=1).astype(np.uint16)
    spots = worst_places(picture(even(), seam))
    assert abs(spots[0][1] - SIDE / 2) <= SAMPLE_PX
    assert {column for column, _ in spots} == {50.5 * SAMPLE_PX}
    heights = sorted(row for _, row in spots)
    assert len(heights) == 3
    assert min(np.diff(heights)) >= SHOWN_PX
    assert worst_places(picture(even())) == []
    beside = even()
    beside[8:24, 20:36], beside[44:56, 8:16] = 0.2, 0.5  # more is gone on a field than along the seam
    (in_field, *_), (on_seam, *_) = (worst_places(picture(beside, seam), is_along) for is_along in (False, True))
    assert in_field[0] > 200 > on_seam[0] == 50.5 * SAMPLE_PX
    softened = 0.6 + 0.1 * np.random.default_rng(1).random(even().shape)
    assert worst_places(picture(softened, seam)) == spots  # all over, a little more here and there
    lossy = even()
    lossy[8:24, 8:24] = 0.3
    assert worst_places(picture(lossy, seam), True, is_hidden=True) == spots  # who judges blind is not told where
