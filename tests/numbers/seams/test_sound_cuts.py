"""Hard cuts of uncommon grounds, and of images that differ in sharpness, in a compressed mosaic: none lost anything."""
from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector import ScanSettings, open_block, scan
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.seam_totals import PieceState
from seam_inspector.plugin.seams.measure.judgement.causes import Cause
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict

from benchmarks.aftermaths import jpeg
from benchmarks.large_mosaic import draw_ground
from tests.numbers.seams.inspecting import MakeRaster, block_of, inspect, mosaic_of
from tests.numbers.synthetic import texture

SHAPE = (512, 512)
ROWS, COLUMNS = np.mgrid[: SHAPE[0], : SHAPE[1]]


def half_even(seed: int) -> list[np.ndarray]:
    """Rough alike all over in the south, without any detail in the north, which no compression touches."""
    south = np.clip((ROWS - SHAPE[0] / 2) / 8 + 0.5, 0, 1)
    grounds = (110 + 25 * texture(SHAPE, 1.5, seed + k) + 10 * texture(SHAPE, 0.8, seed + 7 + k) for k in (0, 1))
    return [south * ground + (1 - south) * 128 for ground in grounds]


def sharp_beside_soft(seed: int) -> list[np.ndarray]:
    """Compression leaves of the sharp image what resembles the soft one."""
    scene = 110 + 25 * texture(SHAPE, 2.0, seed)
    sharp, other = (scene + 12 * texture(SHAPE, 0.7, seed + k) for k in (1, 2))
    return [sharp, ndimage.gaussian_filter(other, 1.2)]


@pytest.mark.slow
@pytest.mark.parametrize("ground", [half_even, sharp_beside_soft])
@pytest.mark.parametrize("seed", [1, 40])
@pytest.mark.parametrize("quality", [50, 85])
def test_a_sound_cut_in_a_compressed_mosaic_is_sound(
    make_raster: MakeRaster, ground: object, seed: int, quality: int
) -> None:
    images = [np.clip(np.rint(np.stack([plane, 0.9 * plane + 8, 1.05 * plane - 5])), 1, 255).astype(np.uint8)
              for plane in ground(seed)]  # type: ignore[operator]
    border = SHAPE[1] / 2 + 40 * np.sin(ROWS / 60)
    mosaic = jpeg(quality)(np.where(border > COLUMNS, *images), np.random.default_rng(seed))
    sources = [make_raster(f"{name}.tif", image) for name, image in zip("ab", images)]
    result = inspect(block_of(mosaic_of(make_raster, mosaic), *sources), PixelWindow(0, 0, *SHAPE[::-1]))
    assert Cause.MISSING_SOURCE not in result.causes
    assert result.judgement.verdict in (Verdict.PRESERVED, Verdict.REDUCED)  # reduced by what compression took
    # Of squares of 8 px that hold both images compression does take something along the seam.
    assert result.profile.kept[0] == pytest.approx(1, abs=0.2 if ground is sharp_beside_soft else 0.05)
    assert result.profile.high >= (0.94 if ground is sharp_beside_soft else 0.95)


@pytest.fixture(scope="module")
def photographs() -> list[np.ndarray]:
    """Two of one generated ground, (3, rows, columns) 8 bit."""
    return [plane[:, 300 : 300 + SHAPE[0], 300 : 300 + SHAPE[1]] for plane in draw_ground()]


@pytest.mark.slow
@pytest.mark.parametrize(
    "toned", [lambda values: 0.8 * values + 10, lambda values: 255 * (values / 255) ** 0.7], ids=["gain", "gamma"]
)
def test_one_image_as_it_was_beside_one_in_other_tones(
    make_raster: MakeRaster, photographs: list[np.ndarray], toned: Callable[[np.ndarray], np.ndarray]
) -> None:
    """All compressed once: what comes out to the bit says nothing of what is left over of others."""
    rng, through = np.random.default_rng(3), jpeg(75)
    second = np.clip(np.rint(toned(photographs[1].astype(float))), 1, 255).astype(np.uint8)
    border = SHAPE[1] / 2 + 20 * np.sin(ROWS / 40)
    mosaic = through(np.where(border > COLUMNS, photographs[0], second), rng)
    sources = [make_raster(f"{name}.tif", through(image, rng)) for name, image in zip("ab", photographs)]
    result = inspect(block_of(mosaic_of(make_raster, mosaic), *sources), PixelWindow(0, 0, *SHAPE[::-1]))
    assert Cause.MISSING_SOURCE not in result.causes
    assert result.profile.high >= 0.95


@pytest.mark.slow
@pytest.mark.parametrize("quality", [60, 75, 90])
@pytest.mark.parametrize("how_many", [1, 2])
def test_orthoimages_that_were_compressed_since_make_no_blur_of_a_sound_mosaic(
    make_raster: MakeRaster, photographs: list[np.ndarray], quality: int, how_many: int
) -> None:
    rng, border = np.random.default_rng(4), SHAPE[1] / 2 + 20 * np.sin(ROWS / 40)
    mosaic = np.where(border > COLUMNS, *photographs)
    stored = [jpeg(quality)(photograph, rng) for photograph in photographs[:how_many]] + photographs[how_many:]
    sources = [make_raster(f"{name}.tif", image) for name, image in zip("ab", stored)]
    result = inspect(block_of(mosaic_of(make_raster, mosaic), *sources), PixelWindow(0, 0, *SHAPE[::-1]))
    assert not {Cause.BLUR, Cause.NOISE_ADDED, Cause.SHARPENED, Cause.MISSING_SOURCE} & set(result.causes)
    assert result.judgement.verdict is Verdict.PRESERVED
    soft = ndimage.gaussian_filter(mosaic.astype(float), (0, 1, 1))
    result = inspect(block_of(mosaic_of(make_raster, soft), *sources), PixelWindow(0, 0, *SHAPE[::-1]))
    assert Cause.BLUR in result.causes


@pytest.mark.parametrize("share", [0.25, 0.35])
def test_what_is_mixed_into_all_of_one_side_is_no_noise(
    make_raster: MakeRaster, photographs: list[np.ndarray], share: float
) -> None:
    border = SHAPE[1] / 2 + 20 * np.sin(ROWS / 40)
    first, second = (photograph.astype(float) for photograph in photographs)
    mosaic = np.where(border > COLUMNS, (1 - share) * first + share * second, second)
    sources = [make_raster(f"{name}.tif", image) for name, image in zip("ab", photographs)]
    result = inspect(block_of(mosaic_of(make_raster, mosaic), *sources), PixelWindow(0, 0, *SHAPE[::-1]))
    assert result.profile.kept[0] < 0.97


@pytest.mark.parametrize("seed", [1, 40])
def test_a_feather_is_seen_beside_even_ground(make_raster: MakeRaster, seed: int) -> None:
    """40 px wide, and half of the window says nothing of tones."""
    images = [np.clip(np.rint(plane), 1, 255) for plane in half_even(seed)]
    second = np.clip((COLUMNS - SHAPE[1] / 2) / 40 + 0.5, 0, 1)
    made = 255 * ((1 - second) * images[0] + second * images[1]) ** 0.6 / 255**0.6
    planes = [np.stack([np.rint(4 * plane - 500)] * 3).astype(np.int16) for plane in (made, *images)]
    sources = [make_raster(f"{name}.tif", plane) for name, plane in zip("ab", planes[1:])]
    result = inspect(block_of(mosaic_of(make_raster, planes[0]), *sources), PixelWindow(0, 0, *SHAPE[::-1]))
    assert result.judgement.verdict is Verdict.SIGNIFICANT
    assert result.profile.kept[0] == pytest.approx(0.55, abs=0.07)


@pytest.mark.parametrize("lean", [0.3, 0.8])
def test_a_cut_where_a_compressed_orthoimage_ends_lost_nothing(make_raster: MakeRaster, lean: float) -> None:
    """The codec's squares at its end hold what lies beyond, which is no detail of the ground."""
    strong, weak = (110 + amplitude * texture(SHAPE, 0.8, seed) for amplitude, seed in ((25, 1), (10, 2)))
    ends, everywhere = 160 + lean * ROWS > COLUMNS, np.ones(SHAPE, bool)

    def compressed(name: str, plane: np.ndarray, valid: np.ndarray) -> str:
        options = ["COMPRESS=JPEG", "JPEG_QUALITY=90", "PHOTOMETRIC=YCBCR", "TILED=YES"]
        pixels = np.stack([np.clip(plane, 1, 255) * valid] * 3).astype(np.uint8)
        return make_raster(f"{name}.tif", pixels, valid=valid, options=options)

    mosaic = compressed("mosaic", np.where(ends, weak, strong), everywhere)
    sources = compressed("ending", weak, ends), compressed("whole", strong, everywhere)
    pieces = scan(open_block(mosaic, sources), ScanSettings(piece_m=10.0)).pieces
    assert sum(piece.piece.length_m for piece in pieces) > 40
    assert not [piece for piece in pieces if piece.state is PieceState.FAILED]
