"""What the patches of a block say of the source that is followed."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.blocks.block_grid import SQUARE_PX
from seam_inspector.plugin.seams.measure.blocks.patches import (
    PATCH_PX,
    PATCH_START_PX,
    SquareLook,
    look_at_squares,
    middle_sources,
)
from seam_inspector.plugin.seams.measure.profile.cell_table import CELL_PX, FARTHEST
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from benchmarks.aftermaths import jpeg
from tests.numbers.seams.scan.blocks.scenes import (
    NODATA,
    SHAPE,
    SIDE,
    Scene,
    as_bytes,
    beside,
    blended,
    images,
    scene,
)
from tests.numbers.synthetic import placed_wavedec, texture

WAVELET, LEVELS = "coif3", 3
PER_SIDE = SIDE // SQUARE_PX


def look_at(one: Scene) -> SquareLook:
    return look_at_squares(one.pixels(), WAVELET, LEVELS)


def patches_of(labels: np.ndarray) -> np.ndarray:
    """What lies under each patch, (rows, columns, pixels)."""
    rows, columns = (length // SQUARE_PX for length in labels.shape)
    squares = labels.reshape(rows, SQUARE_PX, columns, SQUARE_PX).swapaxes(1, 2)
    inside = np.s_[PATCH_START_PX : PATCH_START_PX + PATCH_PX]
    return squares[:, :, inside, inside].reshape(rows, columns, -1)


def crooked() -> np.ndarray:
    """Labels of three images, (rows, columns)."""
    row, column = np.mgrid[:SIDE, :SIDE]
    labels = (column > 430 + 0.5 * row * np.sin(row / 150)).astype(np.uint8)
    labels[(labels == 1) & (row > 600 + 60 * np.cos(column / 90))] = 2
    return labels


def test_a_patch_within_one_source_names_it_and_one_over_a_seam_is_doubtful(tmp_path: Path) -> None:
    labels, given = crooked(), images(count=3)
    found = look_at(scene(tmp_path, np.choose(labels, given), given))
    under = patches_of(labels)
    single = (under == under[..., :1]).all(axis=2)
    assert single.sum() > 40
    assert (found.source[single] == under[single][:, 0]).all()
    assert not found.doubtful[single].any()
    share = np.stack([(under == number).mean(axis=2) for number in range(3)]).max(axis=0)
    through = share < 0.7
    assert through.sum() >= 3
    assert found.doubtful[through].all()
    assert not found.empty.any()


@pytest.mark.parametrize("change", ["gain", "sharpened", "noise"])
def test_what_was_done_to_the_whole_mosaic_does_not_mislead(tmp_path: Path, change: str) -> None:
    given = images()
    made = blended(*given, beside(SIDE / 2)).astype(float)
    if change == "gain":
        made = 90 + 0.6 * (made - 120)
    elif change == "sharpened":
        made += 0.6 * (made - ndimage.uniform_filter(made, 3, mode="wrap"))
    else:
        made += 5 * np.random.default_rng(1).standard_normal(SHAPE)
    found = look_at(scene(tmp_path, as_bytes(made), given))
    right = found.source == np.repeat([[0, 1]], PER_SIDE // 2, axis=1)
    assert right[~found.doubtful].all()
    assert right.mean() > 0.95
    assert change == "noise" or not found.doubtful.any()


def test_what_the_mosaic_s_jpeg_rounded_anew_is_no_other_image(tmp_path: Path) -> None:
    """One of two orthoimages lies in the mosaic's squares of 8 px and so comes out to the bit, the other does not."""
    compress, rng = jpeg(75), np.random.default_rng(0)

    def compressed(plane: np.ndarray, columns: int = 0) -> np.ndarray:
        bands = compress(np.stack([np.roll(plane, columns, axis=1)] * 3), rng)
        return np.roll(bands[0], -columns, axis=1)

    first, second = (as_bytes(128 + 30 * texture(SHAPE, 2.4, seed)) for seed in (1, 2))
    given = [compressed(first), compressed(second, 3)]
    made = compressed(blended(*given, beside(SIDE / 2)))
    found = look_at(scene(tmp_path, made, given))
    right = found.source == np.repeat([[0, 1]], PER_SIDE // 2, axis=1)
    assert right.mean() > 0.95


@pytest.mark.parametrize("beta", [0.0, 1.2, 2.0])
def test_what_no_source_explains_follows_none_for_sure(tmp_path: Path, beta: float) -> None:
    stranger = as_bytes(120 + 30 * texture(SHAPE, beta, 99))
    found = look_at(scene(tmp_path, stranger, images()))
    assert (found.source[~found.doubtful] == UNKNOWN).all()
    assert found.doubtful.mean() < 0.3
    assert not len(found.cells)


def test_a_source_that_ends_is_not_followed_beyond(tmp_path: Path) -> None:
    first, second = (one.copy() for one in images())
    made = first.copy()
    first[:, SIDE // 2 :] = NODATA
    found = look_at(scene(tmp_path, made, [first, second]))
    assert (found.source[:, : PER_SIDE // 2] == 0).all()
    beyond = np.s_[:, PER_SIDE // 2 :]
    assert not (found.source[beyond] == 0)[~found.doubtful[beyond]].any()


def test_sampled_cells_hold_the_finest_detail_as_pywavelets_has_it(tmp_path: Path) -> None:
    given = images()
    made = blended(*given, beside(SIDE / 2))
    cells = look_at(scene(tmp_path, made, given)).cells
    assert len(cells) == PER_SIDE**2
    assert (cells.bin == FARTHEST).all()
    assert (cells.area == [[CELL_PX**2], [0], [0]]).all()
    energy = np.square(placed_wavedec(made, WAVELET, 1)[1]).sum(axis=0)
    per_cell = CELL_PX // 2
    by_cell = energy.reshape(SIDE // CELL_PX, per_cell, -1, per_cell).sum(axis=(1, 3))
    expected = by_cell[cells.row, cells.column]
    for sums in (cells.mm, cells.cc, cells.mc):  # the mosaic is its own hard cut there
        assert sums[0] == pytest.approx(expected, rel=0.02)
        assert not sums[1:].any()


@pytest.mark.parametrize("axis", [0, 1])
@pytest.mark.parametrize(("place", "expected"), [(2 * SQUARE_PX + 90, 1), (3 * SQUARE_PX + 30, 0)])
def test_a_patch_midway_tells_in_which_half_the_seam_lies(
    tmp_path: Path, axis: int, place: int, expected: int
) -> None:
    given = images()
    weight = beside(place)
    one = scene(tmp_path, blended(*given, weight if axis else weight.T), given)
    found = middle_sources(one.pixels(), look_at(one), axis)
    differing = found[:, 2] if axis else found[2]
    assert (differing == expected).all()
    others = np.delete(found, 2, axis=axis)
    assert (others == UNKNOWN).all()


@pytest.mark.parametrize("width", [0.0, 66.0])
def test_images_of_a_triplet_are_not_taken_for_one_that_is_missing(tmp_path: Path, width: float) -> None:
    """They have most of their fine detail in common; what the missing one leaves over is told by the best ground."""
    first, second, missing = images(count=3, own=6.0)
    common = 8 * texture(SHAPE, 0.8, 60)
    first, second, missing = (as_bytes(one + common) for one in (first, second, missing))
    made = blended(blended(first, second, beside(SIDE / 4)), missing, beside(5 * SIDE / 8, width))
    found = look_at(scene(tmp_path, made, [first, second]))
    west, east = found.source[:, :4], found.source[:, 6:]
    assert (west == np.repeat([[0, 1]], 2, axis=1)).mean() > 0.95
    assert (east == UNKNOWN).mean() > 0.95
    assert not found.doubtful[:, 6:].any()
    assert set(np.unique(look_at(scene(tmp_path, made, [first, second, missing])).source)) == {0, 1, 2}
