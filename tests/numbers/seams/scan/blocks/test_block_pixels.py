"""The pixels of a block are the same however they come to be read."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from seam_inspector.plugin.imagery.errors import NotCoveredError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.measure.blocks.block_grid import BlockGrid
from seam_inspector.plugin.seams.measure.blocks.block_pixels import MOST_HELD, BlockPixels, Planes

from tests.numbers.seams.scan.blocks.scenes import NODATA, Scene, as_bytes, images, scene

SHAPE = (300, 420)
MOSAIC_NUMBER = 5


@pytest.fixture(scope="module")
def crowd(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    """More sources than are held; of one half lacks, of another all, and of the mosaic a corner."""
    given = [one.copy() for one in images(SHAPE, MOST_HELD + 3)]
    mosaic = given[MOSAIC_NUMBER].copy()
    mosaic[:90, :90] = NODATA
    given[1][:, 200:] = NODATA
    given[2][:] = NODATA
    given[MOST_HELD][150:] = NODATA
    return scene(tmp_path_factory.mktemp("crowd"), mosaic, given)


def arrays_of(crowd: Scene) -> list[np.ndarray]:
    """Arrays of the sources as they were written."""
    given = [one.copy() for one in images(SHAPE, len(crowd.sources))]
    given[1][:, 200:] = NODATA
    given[MOST_HELD][150:] = NODATA
    return given


def assert_same(one: Planes, other: Planes) -> None:
    """What lacks may hold anything."""

    def known(valid: np.ndarray | None, shape: tuple[int, ...]) -> np.ndarray:
        return np.ones(shape, bool) if valid is None else valid

    there = [known(planes.mosaic_valid, one.mosaic.shape) for planes in (one, other)]
    np.testing.assert_array_equal(*there)
    np.testing.assert_array_equal(one.mosaic[there[0]], other.mosaic[there[0]])
    for number in set(one.sources) | set(other.sources):
        shown = [planes.sources.get(number) for planes in (one, other)]
        has = [np.zeros(one.mosaic.shape, bool) if source is None else known(source.valid, source.plane.shape)
               for source in shown]
        np.testing.assert_array_equal(*has, err_msg=str(number))
        if has[0].any():
            np.testing.assert_array_equal(shown[0].plane[has[0]], shown[1].plane[has[1]], err_msg=str(number))


@pytest.mark.parametrize("window", [
    PixelWindow(0, 0, 64, 64), PixelWindow(100, 40, 200, 130), PixelWindow(380, 260, 40, 40),
    PixelWindow(-16, -16, 160, 160), PixelWindow(350, 250, 100, 80),
])
@pytest.mark.parametrize("numbers", [(5,), (0, 1), (0, 3, 7), (1, MOST_HELD, MOST_HELD + 2)])
@pytest.mark.parametrize("margin_px", [0, 32])
def test_a_part_is_the_same_held_or_read_anew(
    crowd: Scene, window: PixelWindow, numbers: tuple[int, ...], margin_px: int
) -> None:
    held, anew = (crowd.pixels(margin) for margin in (margin_px, None))
    try:
        expected = anew.part(window, numbers)
    except NotCoveredError:
        if max(numbers) < MOST_HELD:
            valid = held.part(window, numbers).mosaic_valid
            assert not valid.any()
        return
    assert_same(held.part(window, numbers), expected)


def test_patches_are_the_pixels_of_the_files(crowd: Scene) -> None:
    rows, columns = np.array([100, 200]), np.array([10, 250, 379])
    given = arrays_of(crowd)
    found = crowd.pixels().patches(rows, columns, 41)
    assert 2 not in found.sources  # it has no pixels at all
    assert set(found.sources) == set(range(len(given))) - {2}
    for number, source in found.sources.items():
        expected = np.block([[given[number][row : row + 41, column : column + 41] for column in columns]
                             for row in rows])
        there = expected != NODATA
        np.testing.assert_array_equal(source.plane[there], expected[there])
        assert (there if source.valid is None else source.valid == there).all()


def test_of_many_sources_only_some_are_held(crowd: Scene) -> None:
    strip = crowd.pixels().strip_of_patches(np.array([100]), np.array([100]), 40)
    assert set(strip.sources) == set(range(MOST_HELD)) - {2}


def test_a_mosaic_that_says_nothing_of_missing_pixels_is_valid_everywhere(tmp_path: Path) -> None:
    given = images((128, 128))
    assert scene(tmp_path, given[0], given, nodata=None).pixels().valid is None


def test_a_window_without_pixels_of_the_mosaic_is_refused(tmp_path: Path) -> None:
    one = scene(tmp_path, np.full((128, 128), NODATA, np.uint8), [as_bytes(np.full((128, 128), 9))])
    window = BlockGrid(one.mosaic.grid).window((0, 0))
    with pytest.raises(NotCoveredError):
        BlockPixels(one.mosaic, [source.ref for source in one.sources], window)
