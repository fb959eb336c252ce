"""Sums of detail over cells and distances from the seam: against PyWavelets, scipy's distances and plain geometry."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from seam_inspector.plugin.imagery.wavelets import detail_components
from seam_inspector.plugin.seams.measure.profile.cell_table import (
    CELL_PX,
    EDGES_PX,
    FARTHEST,
    PRODUCTS,
    CellTable,
    MixtureTable,
)
from seam_inspector.plugin.seams.measure.profile.detail_sums import (
    MeetingSources,
    detail_sums,
    energy_of_rounding,
    seam_geometry,
    seam_samples,
)
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from tests.numbers.synthetic import texture, wavedec

LEVELS, WAVELET = 3, "coif3"
SHAPE = (128, 160)
@pytest.fixture(scope="module")
def planes() -> np.ndarray:
    """A mosaic, its cut and two sources, all of which have half of their detail in common; (4, rows, columns)."""
    common, *own = (25 * texture(SHAPE, 1.2, seed) for seed in range(1, 6))
    return np.stack([common + one for one in own]).astype(np.float32)


def sums_of(planes: np.ndarray, labels: np.ndarray, numbers: Sequence[int] = (0, 1), levels: int = LEVELS,
            valid: dict[int, np.ndarray] | None = None) -> tuple[CellTable, MixtureTable]:
    """Sums of the mosaic, the cut and the sources of these numbers."""
    sources = MeetingSources(labels.astype(np.uint8), numbers, valid or {})
    return detail_sums(list(detail_components(planes, WAVELET, levels)), sources)


def coefficients(planes: np.ndarray) -> list[np.ndarray]:
    """Coefficients by PyWavelets: level by level (planes, 3, rows, columns)."""
    found = [wavedec(plane, WAVELET, LEVELS)[:0:-1] for plane in planes]
    return [np.stack([np.array(one[level]) for one in found]) for level in range(LEVELS)]


def followed(details: np.ndarray, labels: np.ndarray, level: int) -> np.ndarray:
    """Those of the source that is followed where each lies, (3, rows, columns)."""
    side = 2 ** (level + 1)
    coarse = labels[::2, ::2][side // 4 :: max(side // 2, 1), side // 4 :: max(side // 2, 1)]
    return np.asarray(np.where(coarse == 0, details[2], details[3]))


def halves(shape: tuple[int, int] = SHAPE, border: int = 64) -> np.ndarray:
    """Source 0 in the west, 1 in the east."""
    return np.broadcast_to((np.arange(shape[1]) >= border).astype(np.uint8), shape)


def marked(values: np.ndarray, level: int = 1, levels: int = LEVELS) -> list[np.ndarray]:
    """Details whose energies are given at one level and nothing at the others: (rows, columns) of that level."""
    found = []
    for r in range(1, levels + 1):
        shape = tuple(length * 2**level // 2**r for length in values.shape)
        details = np.zeros((3, 2, *shape))
        if r == level:
            details[1] = np.sqrt(values)
        found.append(details)
    return found


def of_marked(details: list[np.ndarray], labels: np.ndarray) -> CellTable:
    return detail_sums(details, MeetingSources(labels.astype(np.uint8)))[0]


def with_gap(gap: Sequence[slice]) -> np.ndarray:
    labels = halves().copy()
    labels[tuple(gap)] = UNKNOWN
    return labels


def test_what_is_unknown_takes_no_part_nor_do_its_neighbours() -> None:
    gap = np.s_[32:80, 96:144]
    labels = with_gap(gap)
    energies = np.zeros((64, 80))
    energies[16:40, 48:72] = 1e6  # of the gap itself
    energies[13, 50] = energies[30, 45] = 1e6  # 5 px beside it
    found = of_marked(marked(energies), labels)
    assert found.mm[0].sum() == 0
    grown = np.zeros(SHAPE, bool)
    grown[32 - 8 : 80 + 8, 96 - 8 : 144 + 8] = True
    assert found.area[0].sum() == (~grown).sum()
    energies[10, 50] = 1.0  # 12 px beside it
    assert of_marked(marked(energies), labels).mm[0].sum() == pytest.approx(1)


def test_the_border_of_what_is_unknown_is_no_seam() -> None:
    labels = np.zeros(SHAPE, np.uint8)
    labels[:, 64:96] = UNKNOWN
    found = seam_geometry(labels)
    assert not seam_samples(labels)[0].any()
    assert set(np.unique(found.bins)) == {FARTHEST, len(EDGES_PX)}
    labels[:, 96:] = 1  # two sources, and between them ground that neither explains
    assert not seam_samples(labels)[0].any()


def test_beside_a_seam_each_source_meets_the_other(planes: np.ndarray) -> None:
    """Products by what is followed and what lies beyond, by PyWavelets' coefficients of each plane."""
    labels = halves()
    beside = sums_of(planes, labels)[1]
    assert beside.products.shape[:2] == (len(PRODUCTS), LEVELS)
    np.testing.assert_array_equal(np.unique(np.column_stack([beside.source, beside.other]), axis=0), [[0, 1], [1, 0]])
    for r, (mosaic, cut, west, east) in enumerate(coefficients(planes)):
        for source, side, s, o in ((0, np.s_[:, :, : 64 >> (r + 1)], west, east),
                                   (1, np.s_[:, :, 64 >> (r + 1) :], east, west)):
            planes_of = {"m": mosaic[side], "s": s[side], "o": o[side], "k": (cut - s)[side]}
            planes_of |= {"p": s[side], "q": o[side]}
            own = beside.products[:, r, beside.source == source].sum(axis=1)
            for name, found in zip(PRODUCTS[1:-1], own[1:-1]):
                expected = (planes_of[name[0]] * planes_of[name[1]]).sum()
                assert found == pytest.approx(expected, rel=1e-3, abs=1e-3 * own[1]), (r, source, name)
            assert own[0] == planes_of["m"][0].size * 4 ** (r + 1)
            assert own[-1] == 0


def test_what_float32_leaves_of_even_ground_is_no_detail(planes: np.ndarray) -> None:
    """Across the middle nothing but grey that was levelled: kept would be a ratio of what rounding left."""
    ground, across = 110 + planes, slice(32, 112)
    ground[:, across] = 110 * (1 + 3e-7 * texture(SHAPE, 0.5, 9)[across])
    details = list(detail_components(ground, WAVELET, LEVELS))
    found = detail_sums(details, MeetingSources(halves(), (0, 1)), energy_of_rounding(ground[0]))
    with_rounding = detail_sums(details, MeetingSources(halves(), (0, 1)))
    for own, plain in zip(found, with_rounding):
        textured = (own.row + 1) * CELL_PX <= across.start
        assert textured.any()
        for values, before in zip(*(vars(one).values() for one in (own, plain))):
            np.testing.assert_array_equal(values[..., textured], before[..., textured])
    middle = (across.start + across.stop) // 2 // CELL_PX
    cells, beside = (one.row == middle for one in found)
    assert (with_rounding[0].cc[0, cells] > 0).all()
    assert not found[0].cc[0, cells].any()
    assert beside.any()
    assert not found[1].products[1:, 0, beside].any()


def test_what_lies_beyond_whole_cells_is_known_to_them() -> None:
    """A seam, a hole and a third source in a rim narrower than a cell."""
    shape = (CELL_PX * 4 + 8, CELL_PX * 5 + 8)
    labels = np.zeros(shape, np.uint8)
    labels[:, -4:], labels[-4:] = 1, 2
    planes = np.stack([25 * texture(shape, 1.2, seed) for seed in range(5)]).astype(np.float32)
    shares = {number: np.full((9, 11), 1 / 3, np.float32) for number in range(3)}
    valid = {1: np.arange(shape[0])[:, np.newaxis] * np.ones(shape[1]) < 40}
    sources = MeetingSources(labels, (0, 1, 2), valid, shares)
    cells, beside = detail_sums(list(detail_components(planes, WAVELET, 3)), sources)
    assert (cells.row.max(), cells.column.max()) == (3, 4)
    assert cells.bin[cells.column == 4].min() < FARTHEST
    assert set(beside.other.tolist()) == {1, 2}
    assert beside.row[beside.other == 1].max() == 2  # of 40 rows the source has pixels in
