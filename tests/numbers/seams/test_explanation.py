"""What one window's explanation says of places: shifts on the ground, and parts that lie elsewhere."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.imagery.clips import Clip
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.limits import DEFAULT_LEVELS, DEFAULT_WAVELET, LUMINANCE
from seam_inspector.plugin.imagery.rasters import Raster
from seam_inspector.plugin.imagery.wavelets import Curve, measure_bands
from seam_inspector.plugin.seams.measure.compared_image import MeasuredClip
from seam_inspector.plugin.seams.measure.judgement.causes import Cause
from seam_inspector.plugin.seams.measure.judgement.explanation import explain

from benchmarks.scenes import Scene, blur, explained, whole_values
from tests.numbers.seams.inspecting import MakeRaster, block_of, inspect, mosaic_of
from tests.numbers.synthetic import ORIGIN, orthoimage

GSD = 0.1


def seen_from(ground: np.ndarray, columns: float, rows: float) -> np.ndarray:
    """(bands, rows, columns) of a periodic scene on a pixel grid that lies so many px to the right and down."""
    across, down = np.fft.fftfreq(ground.shape[2]), np.fft.fftfreq(ground.shape[1])[:, np.newaxis]
    turned = np.fft.fft2(ground) * np.exp(2j * np.pi * (across * columns + down * rows))
    return whole_values(np.fft.ifft2(turned).real)


@pytest.mark.parametrize("beside", [(0.3, 0.2), (-0.4, 0.1), (0.0, -0.35)])
@pytest.mark.parametrize("off", [(0.0, 0.0), (1.2, -0.7)])
def test_a_shift_is_told_on_the_ground_wherever_the_pixel_grids_lie(
    make_raster: MakeRaster, beside: tuple[float, float], off: tuple[float, float]
) -> None:
    ground = ndimage.gaussian_filter(orthoimage((256, 256)).astype(np.float32), (0, 0.7, 0.7), mode="wrap")
    origin = (ORIGIN[0] + GSD * beside[0], ORIGIN[1] - GSD * beside[1])
    source = make_raster("source.tif", seen_from(ground, *beside), gsd=GSD, origin=origin)
    mosaic = mosaic_of(make_raster, seen_from(ground, -off[0], -off[1]), gsd=GSD)  # what it shows lies off its place
    (change, *_) = (pair.change for pair in inspect(block_of(mosaic, source), PixelWindow(64, 64, 128, 128)).pairs)
    assert (change.shift.x, change.shift.y) == pytest.approx(off, abs=0.05)


@pytest.mark.parametrize(("share", "is_moved"), [(0.4, False), (0.6, True), (1.0, True)])
def test_a_part_is_misregistered_when_moving_a_source_explains_half_of_it(
    mosaic: Raster, share: float, is_moved: bool
) -> None:
    rng = np.random.default_rng(8)
    scene = ndimage.gaussian_filter(orthoimage((264, 264)).astype(np.float32), (0, 0.6, 0.6))
    first, second = (
        whole_values(ndimage.shift(scene, (0, *place), order=3)[:, 4:-4, 4:-4] + rng.normal(0, 3, (3, 256, 256)))
        for place in ((0, 0), (0.3, -0.4))
    )
    moved = whole_values(ndimage.shift(second.astype(np.float32), (0, 0, 3), order=3))
    bands, rows, border = first.copy(), slice(94, 164), 90 + round(80 * share)
    bands[:, rows, 90:border] = moved[:, rows, 90:border]
    bands[:, rows, border:170] = orthoimage((256, 256), seed=99)[:, rows, border:170]  # and no source shows the rest
    clips = tuple(Clip(mosaic, plane, 0.0) for plane in (first, second))
    explanation = explained(Scene(PixelWindow(0, 0, 256, 256), np.zeros((256, 256), np.uint8), clips, mosaic), bands)[0]
    assert (Cause.MISREGISTRATION in explanation.causes) is is_moved
    assert (Cause.MISSING_SOURCE in explanation.causes) is (share < 1)
    if is_moved:
        shift = explanation.changes[1][LUMINANCE].shift
        assert (shift.x, shift.y) == pytest.approx((3, 0), abs=0.1)


@pytest.fixture(scope="module")
def sharp_and_soft() -> tuple[np.ndarray, np.ndarray]:
    """Two sources of one scene, the second of them blurred."""
    rng = np.random.default_rng(8)
    scene = orthoimage((256, 256)).astype(np.float32)
    soft = ndimage.gaussian_filter(scene, (0, 1, 1))
    first, second = (whole_values(plane + rng.normal(0, 1.5, plane.shape)) for plane in (scene, soft))
    return first, second


def detail_of_composite(mosaic: Raster, bands: np.ndarray, sources: Sequence[np.ndarray], labels: np.ndarray) -> Curve:
    """The composite's curve where labels are known."""
    clips = [Clip(mosaic, pixels, 0.0) for pixels in (bands, *sources)]
    mosaic_detail, *others = (
        MeasuredClip(clip, *measure_bands(clip.bands, mosaic.band_names, DEFAULT_WAVELET, DEFAULT_LEVELS))
        for clip in clips
    )
    explanation = explain(mosaic_detail, others, DEFAULT_WAVELET, DEFAULT_LEVELS, labels)
    return explanation.curves[LUMINANCE]


def test_cells_are_believed_even_where_the_mosaic_shows_another_source(
    mosaic: Raster, sharp_and_soft: tuple[np.ndarray, np.ndarray]
) -> None:
    first, second = sharp_and_soft
    known = np.where(np.arange(256) < 128, 1, 0) + np.zeros((256, 1), np.uint8)
    detail = detail_of_composite(mosaic, first, sharp_and_soft, known.astype(np.uint8))
    cut = np.where(known == 1, second, first)
    expected = measure_bands(cut, mosaic.band_names, DEFAULT_WAVELET, DEFAULT_LEVELS)[0][LUMINANCE]
    assert detail.detail[0] == pytest.approx(expected.detail[0], rel=0.03)


def test_luminance_is_as_clipped_as_the_band_that_is_most(
    mosaic: Raster, sharp_and_soft: tuple[np.ndarray, np.ndarray]
) -> None:
    source, bands = sharp_and_soft[0], sharp_and_soft[0].copy()
    bands[0] = np.minimum(bands[0], np.quantile(bands[0], 0.95))
    share = float(((bands[0] == bands[0].max()) & (source[0] < source[0].max())).mean())
    place = Scene(PixelWindow(0, 0, 256, 256), np.zeros((256, 256), np.uint8), (Clip(mosaic, source, 0.0),), mosaic)
    change = explained(place, bands)[0].changes[-1]
    assert share > 0.03
    assert (change[LUMINANCE].clipped, change["red"].clipped, change["green"].clipped) == (share, share, 0)


def test_a_blur_is_not_taken_for_the_shift_between_sources(mosaic: Raster) -> None:
    rng = np.random.default_rng(8)
    scene = ndimage.gaussian_filter(orthoimage((264, 264)).astype(np.float32), (0, 0.6, 0.6))  # as a lens draws it
    images = [scene, ndimage.shift(scene, (0, 0.6, -1.5), order=3)]
    noisy = [image[:, 4:-4, 4:-4] + rng.normal(0, 1.5, (3, 256, 256)) for image in images]
    clips = tuple(Clip(mosaic, whole_values(image), 0.0) for image in noisy)
    labels = np.where(np.arange(256) < 180, 0, 1) + np.zeros((256, 1), np.uint8)
    window = PixelWindow(0, 0, 256, 256)
    place = Scene(window, labels.astype(np.uint8), clips, mosaic)
    explanation = explained(place, blur(place, 0.8))[0]
    assert explanation.cause is Cause.BLUR
    for change in (explanation.changes[0], explanation.changes[1]):
        shift = change[LUMINANCE].shift
        assert shift.length < 0.1
