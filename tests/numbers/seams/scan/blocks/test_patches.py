"""What the patches of a block say of the source that is followed."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.blocks.block_grid import SQUARE_PX
from seam_inspector.plugin.seams.measure.blocks.patches import SquareLook, look_at_squares
from seam_inspector.plugin.seams.measure.profile.cell_table import CELL_PX, FARTHEST
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from benchmarks.aftermaths import jpeg
from tests.numbers.seams.scan.blocks.scenes import SHAPE, SIDE, Scene, as_bytes, beside, blended, images, scene
from tests.numbers.synthetic import placed_wavedec, texture

WAVELET, LEVELS = "coif3", 3
PER_SIDE = SIDE // SQUARE_PX


def look_at(case: Scene) -> SquareLook:
    return look_at_squares(case.pixels(), WAVELET, LEVELS)


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
    look = look_at(scene(tmp_path, as_bytes(made), given))
    right = look.source == np.repeat([[0, 1]], PER_SIDE // 2, axis=1)
    assert right[~look.doubtful].all()
    assert right.mean() > 0.95
    assert change == "noise" or not look.doubtful.any()


def test_what_the_mosaic_s_jpeg_rounded_anew_is_no_other_image(tmp_path: Path) -> None:
    """One of two orthoimages lies in the mosaic's squares of 8 px and so comes out to the bit, the other does not."""
    compress, rng = jpeg(75), np.random.default_rng(0)

    def compressed(plane: np.ndarray, columns: int = 0) -> np.ndarray:
        bands = compress(np.stack([np.roll(plane, columns, axis=1)] * 3), rng)
        return np.roll(bands[0], -columns, axis=1)

    first, second = (as_bytes(128 + 30 * texture(SHAPE, 2.4, seed)) for seed in (1, 2))
    given = [compressed(first), compressed(second, 3)]
    made = compressed(blended(*given, beside(SIDE / 2)))
    look = look_at(scene(tmp_path, made, given))
    right = look.source == np.repeat([[0, 1]], PER_SIDE // 2, axis=1)
    assert right.mean() > 0.95


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


def test_a_field_so_weak_that_rounding_tells_in_it_is_of_no_other_image(tmp_path: Path) -> None:
    """A tenth and more of its detail is left over, of all other ground a thousandth."""
    weak = np.full(SHAPE, 1, np.float32)
    weak[: 2 * SQUARE_PX, : 3 * SQUARE_PX] = 0.04
    given = [as_bytes(120 + weak * (plane.astype(np.float32) - 120)) for plane in images(detail_dn=20.0)]
    made = blended(*given, beside(SIDE / 2)) + np.random.default_rng(3).uniform(-1, 1, SHAPE)
    look = look_at(scene(tmp_path, as_bytes(made), given))
    assert not (look.source == UNKNOWN).any()


@pytest.mark.parametrize("width", [0.0, 66.0])
def test_images_of_a_triplet_are_not_taken_for_one_that_is_missing(tmp_path: Path, width: float) -> None:
    """They have most of their fine detail in common; what the missing one leaves over is more than others do."""
    first, second, missing = images(count=3, detail_dn=6.0)
    common = 8 * texture(SHAPE, 0.8, 60)
    first, second, missing = (as_bytes(plane + common) for plane in (first, second, missing))
    made = blended(blended(first, second, beside(SIDE / 4)), missing, beside(5 * SIDE / 8, width))
    look = look_at(scene(tmp_path, made, [first, second]))
    west, east = look.source[:, :4], look.source[:, 6:]
    assert (west == np.repeat([[0, 1]], 2, axis=1)).mean() > 0.95
    assert (east == UNKNOWN).mean() > 0.95
    assert not look.doubtful[:, 6:].any()
    assert set(np.unique(look_at(scene(tmp_path, made, [first, second, missing])).source)) == {0, 1, 2}
