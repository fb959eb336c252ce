"""Judged windows that belong together are resampled together."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.imagery.grids import Extent
from seam_inspector.plugin.seams.measure.calibration.threshold_calibration import (
    Neighbourhoods,
    effective_count,
    find_neighbourhoods,
)


def window(x: float, y: float = 0.0, side: float = 100.0) -> Extent:
    return x, y, x + side, y + side


def test_windows_far_apart_are_neighbourhoods_of_their_own() -> None:
    assert len(set(find_neighbourhoods([window(500 * place) for place in range(12)]))) == 12


@pytest.mark.parametrize("spacing", [0, 30, 100, 200])
def test_windows_that_overlap_or_are_near_belong_together(spacing: float) -> None:
    groups = [window(5000 * group + spacing * place, 300 * group) for group in range(6) for place in range(4)]
    numbers = find_neighbourhoods(groups)
    assert len(set(numbers)) == 6
    assert all(len(set(numbers[start : start + 4])) == 1 for start in range(0, 24, 4))


def test_degrees_do_as_well_as_metres() -> None:
    metres = [window(2000 * (place // 3) + 100 * (place % 3), 40 * place) for place in range(15)]
    degrees = [(left / 70e3, bottom / 111e3, right / 70e3, top / 111e3) for left, bottom, right, top in metres]
    numbers = find_neighbourhoods(metres)
    assert find_neighbourhoods(degrees) == numbers
    assert len(set(numbers)) == 5


def test_a_long_row_is_cut() -> None:
    row = [window(200 * place) for place in range(40)]
    numbers = find_neighbourhoods(row)
    assert 8 <= len(set(numbers)) <= 16
    for group in set(numbers):
        members = [place for place, number in enumerate(numbers) if number == group]
        assert members == list(range(members[0], members[-1] + 1))
        assert len(members) <= 4  # 800 m


def test_windows_without_an_outline_stand_for_themselves() -> None:
    numbers = find_neighbourhoods([None, window(0), None, window(50)])
    assert numbers[1] == numbers[3]
    assert len(set(numbers)) == 3
    assert find_neighbourhoods([]) == []


def test_a_neighbourhood_is_drawn_as_a_whole_and_both_kinds_remain() -> None:
    visible, invisible = [0, 0, 0, 1, 2, 5], [0, 1, 1, 3, 3, 4, 4]
    places = Neighbourhoods(visible, invisible)
    seen, unseen = places.resamples()
    drawn = {place: seen[:, visible.index(place)] for place in set(visible)}
    drawn.update({place: unseen[:, invisible.index(place)] for place in set(invisible)})
    assert (seen == np.column_stack([drawn[place] for place in visible])).all()
    assert (unseen == np.column_stack([drawn[place] for place in invisible])).all()
    assert (drawn[2] + drawn[5] == 1).all()  # those of one kind among themselves, one fewer than there are
    assert (drawn[3] + drawn[4] == 1).all()
    assert (drawn[0] + drawn[1] == 1).all()
    assert min(seen.sum(axis=1).min(), unseen.sum(axis=1).min()) >= 2
    assert len(np.unique(np.hstack([seen, unseen]), axis=0)) == 8


def test_resamples_of_single_windows_spread_as_samples_do() -> None:
    seen, unseen = Neighbourhoods(range(7), range(7, 19)).resamples()
    assert (seen.shape, unseen.shape) == ((2000, 7), (2000, 12))
    values = np.arange(7)
    means = (seen * values).sum(axis=1) / seen.sum(axis=1)
    assert means.std() == pytest.approx(values.std(ddof=1) / 7**0.5, rel=0.04)


def test_one_neighbourhood_of_its_kind_takes_part_too() -> None:
    places = Neighbourhoods([0, 0, 1, 1, 2, 2], [2, 2, 3, 3, 4, 4])  # one of both kinds
    drawn = np.hstack(places.resamples())
    assert set(drawn[:, 4]) >= {0, 1, 2}
    assert (drawn[:, :6].sum(axis=1) >= 2).all()
    assert (drawn[:, 6:].sum(axis=1) >= 2).all()


def test_uneven_neighbourhoods_tell_less_than_as_many_even_ones() -> None:
    assert effective_count([0, 0, 1, 1, 2, 2]) == pytest.approx(3)
    assert effective_count([0, 0, 0, 0, 1, 2]) == pytest.approx(2)
    assert Neighbourhoods([0, 0, 1, 1], [2, 3, 4]).fewest == pytest.approx(2)
