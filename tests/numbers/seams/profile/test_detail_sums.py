"""Sums of detail over cells and distances from the seam: against PyWavelets, scipy's distances and plain geometry."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import ndimage
from seam_inspector.plugin.imagery.wavelets import detail_components
from seam_inspector.plugin.seams.measure.profile.detail_cells import CELL_PX, EDGES_PX, DetailCells, detail_cells
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from tests.numbers.synthetic import texture, wavedec

LEVELS, WAVELET = 3, "coif3"
SHAPE = (128, 160)


@pytest.fixture(scope="module")
def planes() -> np.ndarray:
    """A mosaic and its composite, which have half of their detail in common; (2, rows, columns) float32."""
    common, own, other = (25 * texture(SHAPE, 1.2, seed) for seed in (1, 2, 3))
    return np.stack([common + own, common + other]).astype(np.float32)


def cells_of(planes: np.ndarray, labels: np.ndarray, levels: int = LEVELS) -> DetailCells:
    return detail_cells(list(detail_components(planes, WAVELET, levels)), labels.astype(np.uint8))


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


def test_sums_are_those_of_pywavelets(planes: np.ndarray) -> None:
    found = cells_of(planes, halves())
    own, reference = ([np.array(parts) for parts in wavedec(plane, WAVELET, LEVELS)[:0:-1]] for plane in planes)
    for r in range(LEVELS):
        for sums, a, b in ((found.mm, own, own), (found.cc, reference, reference), (found.mc, own, reference)):
            assert sums[r].sum() == pytest.approx((a[r] * b[r]).sum(), rel=1e-4)


def test_each_cell_holds_the_coefficients_of_its_pixels(planes: np.ndarray) -> None:
    found = cells_of(planes, halves())
    own, reference = ([np.array(parts) for parts in wavedec(plane, WAVELET, LEVELS)[:0:-1]] for plane in planes)
    rows, columns = (length // CELL_PX for length in SHAPE)
    for r in range(LEVELS):
        side = CELL_PX >> (r + 1)
        for sums, a, b in ((found.mm, own, own), (found.cc, reference, reference), (found.mc, own, reference)):
            expected = (a[r] * b[r]).sum(axis=0).reshape(rows, side, columns, side).sum(axis=(1, 3))
            np.testing.assert_allclose(sums[r].sum(axis=0), expected, rtol=1e-3, atol=1e-4 * expected.std())


def test_cells_add_up_to_the_window(planes: np.ndarray) -> None:
    found = cells_of(planes, halves())
    assert found.area.sum(axis=(1, 2, 3)).tolist() == [SHAPE[0] * SHAPE[1]] * LEVELS
    assert (found.area.sum(axis=1) == CELL_PX**2).all()


@pytest.mark.parametrize("shape", [(72, 88), (64, 104), (120, 64)])
def test_what_sticks_out_of_whole_cells_is_in_none(shape: tuple[int, int]) -> None:
    planes = np.stack([20 * texture(shape, 1.0, seed) for seed in (1, 2)]).astype(np.float32)
    found = cells_of(planes, halves(shape, 32))
    rows, columns = (length // CELL_PX for length in shape)
    assert found.area.shape == (LEVELS, len(EDGES_PX), rows, columns)
    assert (found.area.sum(axis=1) == CELL_PX**2).all()
    own = np.array(wavedec(planes[0], WAVELET, LEVELS)[-1])[:, : rows * 8, : columns * 8]
    assert found.mm[0].sum() == pytest.approx((own**2).sum(), rel=1e-3)


@settings(max_examples=20)
@given(a=st.floats(0.1, 10), b=st.floats(0.1, 10), border=st.integers(1, 127))
def test_sums_are_quadratic(a: float, b: float, border: int) -> None:
    shape = (64, 128)
    planes = np.stack([20 * texture(shape, 1.0, seed) for seed in (1, 2)])
    labels = halves(shape, border)
    plain, scaled = (cells_of(one, labels) for one in (planes, planes * np.array([a, b])[:, np.newaxis, np.newaxis]))
    np.testing.assert_allclose(scaled.mm, a**2 * plain.mm, rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(scaled.cc, b**2 * plain.cc, rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(scaled.mc, a * b * plain.mc, rtol=1e-6, atol=1e-4)


# --- distances -------------------------------------------------------------------------------------------------


def test_along_a_straight_seam_bins_are_strips_on_both_sides(planes: np.ndarray) -> None:
    area = cells_of(planes, halves()).area[0].sum(axis=(1, 2))
    for number, (near, far) in enumerate(zip(EDGES_PX, EDGES_PX[1:])):
        west, east = (max(0, min(far, reach) - near) for reach in (64, SHAPE[1] - 64))
        assert area[number] == (west + east) * SHAPE[0], (near, far)


def crooked(shape: tuple[int, int] = SHAPE) -> np.ndarray:
    """Three sources that meet."""
    row, column = np.mgrid[: shape[0], : shape[1]]
    border = shape[1] / 2 + 14 * np.sin(row / 11)
    labels: np.ndarray = np.where(column < border, 0, np.where(row < 40 + column / 6, 1, 2))
    return labels.astype(np.uint8)


def by_scipy(labels: np.ndarray) -> np.ndarray:
    """Distance of each pixel's middle from the nearest border between two labels, px."""
    apart = [ndimage.distance_transform_edt(labels == label) - 0.5 for label in np.unique(labels)]
    return np.max(apart, axis=0)


@pytest.mark.parametrize("level", [1, 2, 3])
def test_distances_are_those_of_scipy(level: int) -> None:
    """The energies handed over are the distances themselves, so that each bin tells the mean over its coefficients."""
    labels = crooked()
    side = 2**level
    rows, columns = (length // side for length in SHAPE)
    distance = by_scipy(labels).reshape(rows, side, columns, side).mean(axis=(1, 3))
    found = detail_cells(marked(distance, level), labels)
    counts = found.area[level - 1].sum(axis=(1, 2)) / side**2
    means = found.mm[level - 1].sum(axis=(1, 2)) / np.maximum(counts, 1)
    reach = 2.5 + side / 2  # the grid of distances has 2 px, and a coefficient its own size
    for number in np.flatnonzero(counts >= 8):
        far = EDGES_PX[number + 1] if number + 1 < len(EDGES_PX) else np.inf
        assert EDGES_PX[number] - reach <= means[number] <= far + reach
    known = np.flatnonzero(counts >= 8)
    assert (np.diff(means[known]) > 0).all()
    expected = np.histogram(distance, [*EDGES_PX, 1e9])[0]
    within = [np.abs(np.cumsum(counts) - np.cumsum(expected)).max() / counts.sum()]
    assert max(within) < 0.06 * side / 2 + 0.02


def test_a_coefficient_lies_in_the_bin_of_its_distance() -> None:
    for column, near in ((31, 0), (32, 0), (30, 2), (33, 2), (29, 4), (26, 8), (24, 12), (21, 16), (14, 32), (50, 32)):
        energies = np.zeros((64, 80))
        energies[20, column] = 9.0
        found = detail_cells(marked(energies), halves())
        ((number, row, cell),) = np.argwhere(found.mm[0])
        bin_of = EDGES_PX[number]
        assert (bin_of, row, cell) == (near, 40 // CELL_PX, 2 * column // CELL_PX), column
        assert found.mm[0, number, row, cell] == pytest.approx(9.0)


# --- what no source explains -----------------------------------------------------------------------------------


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
    found = detail_cells(marked(energies), labels)
    assert found.mm[0].sum() == 0
    grown = np.zeros(SHAPE, bool)
    grown[32 - 8 : 80 + 8, 96 - 8 : 144 + 8] = True
    assert found.area[0].sum() == (~grown).sum()
    energies[10, 50] = 1.0  # 12 px beside it
    assert detail_cells(marked(energies), labels).mm[0].sum() == pytest.approx(1)


def test_the_border_of_what_is_unknown_is_no_seam(planes: np.ndarray) -> None:
    labels = np.zeros(SHAPE, np.uint8)
    labels[:, 64:96] = UNKNOWN
    found = cells_of(planes, labels)
    assert not found.has_seam
    assert found.area[0, :-1].sum() == 0
    labels[:, 96:] = 1  # two sources, and between them ground that neither explains
    assert not cells_of(planes, labels).has_seam


def test_nothing_is_left_where_nothing_is_known(planes: np.ndarray) -> None:
    found = cells_of(planes, np.full(SHAPE, UNKNOWN))
    assert not found.has_seam
    assert found.area.sum() == found.mm.sum() == found.cc.sum() == 0
    assert (found.source == UNKNOWN).all()


def test_one_source_has_no_seam_and_two_have_one(planes: np.ndarray) -> None:
    alone = cells_of(planes, np.zeros(SHAPE))
    assert not alone.has_seam
    assert alone.area[0, -1].sum() == SHAPE[0] * SHAPE[1]
    assert cells_of(planes, halves()).has_seam


def test_each_cell_names_the_source_of_its_middle(planes: np.ndarray) -> None:
    labels = with_gap(np.s_[:16, :16])
    found = cells_of(planes, labels).source
    assert found.dtype == np.uint8
    np.testing.assert_array_equal(found, labels[8::16, 8::16])
    assert found[0, 0] == UNKNOWN
