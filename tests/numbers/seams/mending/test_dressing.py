"""What two images are put together to at a new cut: tones pass over, fine detail stays that of one image."""
from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.mending import new_cut

from tests.numbers.synthetic import texture

SHAPE = (192, 320)
BORDER = 160
WHOLE = np.ones(SHAPE, bool)
INSIDE = np.ones(SHAPE, np.float32)


def eased(
    first: np.ndarray, second: np.ndarray, weight: np.ndarray, mosaic: np.ndarray, inside: np.ndarray, valid: np.ndarray
) -> np.ndarray:
    """One band eased."""
    images = [first[np.newaxis], second[np.newaxis]]
    return np.asarray(new_cut.eased(images, weight, mosaic[np.newaxis], inside, valid)[0])


def left_of_border() -> np.ndarray:
    return np.tile((np.arange(SHAPE[1]) < BORDER).astype(np.float32), (SHAPE[0], 1))


def image(seed: int) -> np.ndarray:
    return np.asarray(120 + 9 * texture(SHAPE, 0.8, seed), np.float32)


def jump(made: np.ndarray, fine: np.ndarray) -> float:
    """Root mean square over rows of what 8 px on the right have more than 8 px on the left, but for fine detail."""
    across = ndimage.uniform_filter1d(made - fine, 8, axis=0)
    left, right = across[:, BORDER - 8 : BORDER].mean(axis=1), across[:, BORDER : BORDER + 8].mean(axis=1)
    return float(np.sqrt(np.mean(np.square(right - left))))


@pytest.mark.parametrize("scale_px", [10.0, 16.0, 40.0])
def test_tones_of_every_scale_pass_over_the_cut(scale_px: float) -> None:
    scene, blobs = image(1), ndimage.gaussian_filter(texture(SHAPE, 0.0, 2), scale_px)
    tones = np.asarray(12 + 20 * blobs / blobs.std(), np.float32)
    made = eased(scene + tones, scene, left_of_border(), scene, INSIDE, WHOLE)
    assert jump(made, scene) < 0.4 * jump(scene + left_of_border() * tones, scene)


def test_fine_detail_is_that_of_one_image() -> None:
    first, second, weight = image(3), image(4), left_of_border()
    made = eased(first, second, weight, first, INSIDE, WHOLE)
    fine = [plane - ndimage.gaussian_filter(plane, 2) for plane in (made, weight * first + (1 - weight) * second)]
    assert np.abs(fine[0] - fine[1]).mean() < 0.15 * np.abs(fine[1]).mean()


def test_what_fills_an_image_beyond_its_rim_tells_nothing_of_tones() -> None:
    first, valid = image(5), WHOLE.copy()
    valid[:, BORDER + 16 :] = False
    second = first + 10
    filled = np.where(valid, first, 0)
    made = eased(filled, second, left_of_border(), second, INSIDE, valid)
    whole = eased(first, second, left_of_border(), second, INSIDE, WHOLE)
    assert np.abs(made - whole)[:, : BORDER + 16].max() < 1.5


def test_the_rim_of_a_patch_has_the_mosaics_tones() -> None:
    first = image(6)
    made = eased(first, first, left_of_border(), first + 15, np.zeros(SHAPE, np.float32), WHOLE)
    assert np.abs(made - first - 15).max() < 0.1


def test_how_much_of_the_mosaics_detail_a_source_has() -> None:
    shown, other = image(9), image(10)
    mosaic = np.rint(shown).astype(np.uint8)
    assert new_cut.shown_detail(shown, mosaic, WHOLE) > 0.99
    for part in (0.02, 0.6):
        assert new_cut.shown_detail(part * shown, mosaic, WHOLE) == pytest.approx(part, abs=0.01)
    noisy = np.rint(shown + 9 * texture(SHAPE, 0.0, 11)).astype(np.uint8)
    assert new_cut.shown_detail(shown, noisy, WHOLE) > 0.95
    assert new_cut.shown_detail(9 * other, mosaic, WHOLE) < 0.05
    assert new_cut.shown_detail(shown, np.full(SHAPE, 90, np.uint8), WHOLE) is None
