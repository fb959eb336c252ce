"""What one window's explanation says of places: shifts on the ground, and parts that lie elsewhere."""
from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.imagery.band_names import LUMINANCE
from seam_inspector.plugin.imagery.clips import Clip
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.rasters import Raster
from seam_inspector.plugin.seams.measure.causes import Cause

from benchmarks.scenes import Scene, explained, whole_values
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
    assert change is not None
    assert change.shift is not None
    assert (change.shift.x, change.shift.y) == pytest.approx(off, abs=0.05)


# --- a part of the window that lies elsewhere ------------------------------------------------------------------


@pytest.mark.parametrize(("share", "cause"), [(0.45, Cause.NONE), (0.6, Cause.MISREGISTRATION)])
def test_a_part_is_misregistered_when_moving_a_source_explains_half_of_it(
    mosaic: Raster, share: float, cause: Cause
) -> None:
    rng = np.random.default_rng(8)
    scene = ndimage.gaussian_filter(orthoimage((264, 264)).astype(np.float32), (0, 0.6, 0.6))
    first, second = (
        whole_values(ndimage.shift(scene, (0, *place), order=3)[:, 4:-4, 4:-4] + rng.normal(0, 3, (3, 256, 256)))
        for place in ((0, 0), (0.3, -0.4))
    )
    moved = whole_values(ndimage.shift(second.astype(np.float32), (0, 0, 3), order=3))
    bands, rows, border = first.copy(), slice(96, 160), 90 + round(80 * share)
    bands[:, rows, 90:border] = moved[:, rows, 90:border]
    bands[:, rows, border:170] = orthoimage((256, 256), seed=99)[:, rows, border:170]  # and no source shows the rest
    clips = tuple(Clip(mosaic, one, 0.0) for one in (first, second))
    found = explained(Scene(PixelWindow(0, 0, 256, 256), np.zeros((256, 256), np.uint8), clips, mosaic), bands)[0]
    assert found.cause is cause
    if cause is Cause.MISREGISTRATION:
        shift = found.changes[1][LUMINANCE].shift
        assert shift is not None
        assert (shift.x, shift.y) == pytest.approx((3, 0), abs=0.1)
