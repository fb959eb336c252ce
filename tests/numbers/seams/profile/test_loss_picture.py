"""The picture of lost detail, against loops over PyWavelets' coefficients and against where the seam is."""
from __future__ import annotations

import pickle

import numpy as np
import pytest
from seam_inspector.plugin.seams.measure.profile.window_detail import LOSS_CELL_PX, LossPicture, loss_picture
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from tests.numbers.seams.profile.blends import SIDE, WAVELET, Blend, blend
from tests.numbers.synthetic import placed_wavedec, texture

CELLS = SIDE // LOSS_CELL_PX


def picture_of(
    made: Blend, mosaic: np.ndarray | None = None, labels: np.ndarray | None = None,
    inside: tuple[slice, slice] | None = None,
) -> LossPicture | None:
    labels = made.labels if labels is None else labels
    return loss_picture(made.detail(mosaic, labels, inside), labels, inside)


def same_everywhere(hard: np.ndarray, labels: np.ndarray) -> Blend:
    """Two sources that look the same."""
    return Blend((hard, hard), np.stack([labels == 0, labels == 1]).astype(float), labels, np.zeros(labels.shape))


def kept_of(made: Blend, mosaic: np.ndarray | None = None, labels: np.ndarray | None = None) -> np.ndarray:
    picture = picture_of(made, mosaic, labels)
    return picture.kept


def smoothed(cells: np.ndarray) -> np.ndarray:
    """Cells smoothed by a Gaussian of one cell, cut at four, the cells mirrored at the edge."""
    weights = np.exp(-0.5 * np.arange(-4, 5) ** 2)
    weights /= weights.sum()
    padded = np.pad(cells, 4, mode="symmetric")
    made = np.zeros_like(cells)
    for row in range(cells.shape[0]):
        for column in range(cells.shape[1]):
            made[row, column] = weights @ padded[row : row + 9, column : column + 9] @ weights
    return made


def energies(plane: np.ndarray) -> np.ndarray:
    """Energies of PyWavelets' finest details, in cells."""
    finest = np.sum(np.square(placed_wavedec(plane, WAVELET, 1)[1]), axis=0)
    step = LOSS_CELL_PX // 2
    return np.array([
        [finest[row : row + step, column : column + step].sum() for column in range(0, finest.shape[1], step)]
        for row in range(0, finest.shape[0], step)
    ])


def test_it_is_what_loops_over_pywavelets_say() -> None:
    """The ground around is as it was, so what is expected of a cell is what its composite has."""
    made = blend(0)
    mosaic = made.hard - 0.5 * np.where(made.distance < 10, texture(made.hard.shape, 1.2, 5) * 8, 0)
    expected = smoothed(energies(mosaic)) / smoothed(energies(made.hard))
    kept = kept_of(made, mosaic)
    assert kept.dtype == np.float32
    assert kept.shape == (CELLS, CELLS)
    np.testing.assert_allclose(kept, expected, rtol=5e-3)
    assert expected.min() < 0.95 or expected.max() > 1.05


def test_a_hard_cut_is_even_and_a_feather_a_line_along_the_seam() -> None:
    assert abs(kept_of(blend(0)) - 1).max() < 1e-3
    made = blend(33)
    kept = kept_of(made)
    distance = made.distance.reshape(CELLS, LOSS_CELL_PX, CELLS, LOSS_CELL_PX).mean(axis=(1, 3))
    assert (kept[distance < 4] < 0.8).all()
    assert np.median(kept[distance < 4]) == pytest.approx(made.truth(0, 12), abs=0.1)
    assert abs(kept[distance > 48] - 1).max() < 0.1


@pytest.mark.parametrize("place", [150, 203, 256, 311])
def test_the_line_lies_where_the_seam_is(place: int) -> None:
    """Within the pixel by which coif3's own middle lies beside that of its two samples."""
    column = np.broadcast_to(np.arange(SIDE), (SIDE, SIDE))
    rng = np.random.default_rng(place)
    hard = 120 + 10 * rng.standard_normal((SIDE, SIDE))
    mosaic = 120 + (hard - 120) * np.sqrt(1 - 0.6 * np.exp(-0.5 * ((column + 0.5 - place) / 8) ** 2))
    labels = (column >= place).astype(np.uint8)
    lost = np.clip(1 - kept_of(same_everywhere(hard, labels), mosaic), 0.1, None) - 0.1
    middles = (np.arange(CELLS) + 0.5) * LOSS_CELL_PX
    assert float((lost.sum(axis=0) * middles).sum() / lost.sum()) == pytest.approx(place, abs=1.2)


@pytest.mark.parametrize(("first", "second"), [(1.0, 0.6), (0.6, 1.0), (0.6, 0.6)])
def test_of_images_that_lost_detail_themselves_each_shows_its_own_loss(first: float, second: float) -> None:
    """One was blurred before it was cut, and the other is byte for byte what it was."""
    made = blend(0)
    left = np.where(made.labels == 0, first, second)
    kept, far = kept_of(made, 120 + (made.hard - 120) * left), made.distance[4::8, 4::8] > 48
    of_first = made.labels[4::8, 4::8] == 0
    for where, amplitude in ((of_first & far, first), (~of_first & far, second)):
        assert np.median(np.minimum(kept[where], 1)) == pytest.approx(amplitude**2, abs=0.05)


def test_ground_that_compression_left_rough_is_not_called_lost() -> None:
    """Cells that lose all beside others that lose nothing show more than their scatter."""
    made = blend(0)
    rng = np.random.default_rng(12)
    left = np.exp(0.35 * rng.standard_normal((SIDE // 8, SIDE // 8))).repeat(8, axis=0).repeat(8, axis=1)
    rough = 120 + (made.hard - 120) * left
    assert (kept_of(made, rough) <= 0.9).mean() < 0.1
    feathered = 120 + (blend(66).made - 120) * left
    assert (kept_of(blend(66), feathered) <= 0.9)[made.distance[4::8, 4::8] < 6].mean() > 0.5


def test_nothing_of_one_edge_shows_at_the_other() -> None:
    """The wavelets are periodic; a feather along the left edge only."""
    rng = np.random.default_rng(8)
    hard = 120 + 10 * rng.standard_normal((SIDE, SIDE))
    mosaic = np.where(np.arange(SIDE) < 24, 120 + 0.7 * (hard - 120), hard)
    labels = np.broadcast_to((np.arange(SIDE) >= 4), (SIDE, SIDE)).astype(np.uint8)
    kept = kept_of(same_everywhere(hard, labels), mosaic)
    assert (kept[:, 0] < 0.6).all()
    assert abs(kept[:, -1] - 1).max() < 0.02


def test_what_no_source_explains_is_not_told() -> None:
    made = blend(33)
    labels = made.labels.copy()
    labels[:96, :96] = UNKNOWN
    kept = kept_of(made, labels=labels)
    assert np.isnan(kept[:12, :12]).all()
    assert not np.isnan(kept[14:, 14:]).any()
    np.testing.assert_allclose(kept[30:, 30:], kept_of(made)[30:, 30:], rtol=0.05)


def test_of_what_was_read_around_a_window_nothing_is_shown() -> None:
    made = blend(33)
    inside = np.s_[128:384, 96:352]
    whole, inner = picture_of(made), picture_of(made, inside=inside)
    np.testing.assert_array_equal(inner.kept, whole.kept[16:48, 12:44])
    row, column = inner.seam.T.astype(int) * 2
    assert len(row) > 200
    assert made.distance[row + 128, column + 96].max() <= 3


def test_without_ground_to_compare_with_there_is_none_and_it_can_cross_processes() -> None:
    made = blend(33)
    striped = (np.arange(SIDE)[:, np.newaxis] // 40 % 2 + np.zeros((1, SIDE))).astype(np.uint8)
    assert picture_of(made, labels=striped) is None
    picture = picture_of(made)
    again = pickle.loads(pickle.dumps(picture))
    np.testing.assert_array_equal(again.kept, picture.kept if picture else None)
    assert again.cell_px == LOSS_CELL_PX
