"""Whether two images fit along a new cut, over all of it."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.seams.measure.mending.new_cut import CELL_PX, cheapest_way, fit_along

from tests.numbers.synthetic import texture

ROWS, COLUMNS = 1024, 160
WAY = np.column_stack([np.arange(ROWS // CELL_PX), np.full(ROWS // CELL_PX, COLUMNS // CELL_PX // 2)])


def images(shift_px: int) -> list[np.ndarray]:
    """Images of one ground, the second one to the right in its lower quarter."""
    ground = 120 + 20 * texture((ROWS, COLUMNS), 2.0, 1)
    other = ground.copy()
    other[3 * ROWS // 4 :] = np.roll(ground, shift_px, axis=1)[3 * ROWS // 4 :]
    return [np.asarray(plane + 3 * texture((ROWS, COLUMNS), 0.8, seed), np.float32)
            for plane, seed in ((ground, 2), (other, 3))]  # fmt: skip


@pytest.mark.parametrize("shift_px", [3, 8])
def test_a_misfit_in_a_part_of_the_way_counts(shift_px: int) -> None:
    misfit, reason, far = fit_along(WAY, *images(shift_px), np.ones((ROWS, COLUMNS), bool))
    assert CELL_PX * np.count_nonzero(far) == pytest.approx(ROWS / 4, abs=64)
    assert not far[: len(far) * 5 // 8].any()
    assert misfit == pytest.approx(shift_px, abs=0.3)
    assert reason is not None


def test_images_that_fit_all_along_are_cut() -> None:
    misfit, reason, _ = fit_along(WAY, *images(0), np.ones((ROWS, COLUMNS), bool))
    assert misfit == pytest.approx(0, abs=0.1)
    assert reason is None


def test_a_roof_beside_the_way_is_no_misfit() -> None:
    """What the images show in different places, and the way leads around."""
    planes = images(0)
    middle = COLUMNS // 2
    for plane, by in zip(planes, (0, 9)):
        plane[400:480, middle + 16 + by : middle + 60 + by] = 40 + 8 * (np.arange(80) // 8 % 2)[:, np.newaxis]
    misfit, reason, _ = fit_along(WAY, *planes, np.ones((ROWS, COLUMNS), bool))
    assert misfit == pytest.approx(0, abs=0.3)
    assert reason is None


def test_the_way_follows_a_valley_in_any_direction() -> None:
    """Diagonally as well, and from end to end where these are barred themselves."""
    side = 24
    cost = np.full((side, side), 50.0)
    allowed = np.ones((side, side), bool)
    valley = [*((9, column) for column in range(2, 9)), *((row, row) for row in range(9, 21))]
    for row, column in valley:
        cost[row - 1 : row + 2, column - 1 : column + 2] = 0.0
    start, end = valley[0], valley[-1]
    allowed[start], allowed[end] = False, False
    for turn in (np.asarray, np.fliplr, np.flipud, np.transpose):
        numbers = turn(np.arange(side**2).reshape(side, side))
        place = {int(number): (row, column) for (row, column), number in np.ndenumerate(numbers)}
        first, last = (place[row * side + column] for row, column in (start, end))
        way = cheapest_way(turn(cost), turn(allowed), first, last)
        assert [int(numbers[row, column]) for row, column in way.tolist()] == [
            row * side + column for row, column in valley
        ]


def test_where_a_wall_lies_between_there_is_no_way() -> None:
    allowed = np.ones((9, 9), bool)
    allowed[:, 4] = False
    assert cheapest_way(np.ones((9, 9)), allowed, (4, 0), (4, 8)) is None
    assert cheapest_way(np.ones((9, 9)), ~np.ones((9, 9), bool), (4, 0), (4, 8)) is None
