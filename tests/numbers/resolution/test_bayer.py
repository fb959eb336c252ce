"""A single-chip camera: the paper's experiment with thin lines, OpenCV as witness, and files in strips."""
from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from scipy import ndimage
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.open_raster import describe_north_up
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.resolution.measure import bayer
from seam_inspector.plugin.resolution.measure.target import BAYER_PATTERNS, DEMOSAICS

from tests.numbers.synthetic import orthoimage, read_pixels

cv2 = pytest.importorskip("cv2", reason="OpenCV is the witness here; it is in requirements-dev.txt")

MakeRaster = Callable[..., str]
SIDE = 41


def line_scene(width: int, diagonal: bool = False) -> np.ndarray:
    """(3, rows, columns): a black line of so many pixels on white, upright, or from corner to corner."""
    rows, columns = np.indices((SIDE, SIDE))
    away = columns - rows if diagonal else columns - SIDE // 2
    black = (away >= -(width // 2)) & (away <= (width - 1) // 2)
    return np.repeat(np.where(black, 0.0, 1.0)[np.newaxis], 3, axis=0)


def touched(seen: np.ndarray, diagonal: bool = False) -> list[int]:
    """Distances from the line's middle, in pixels along a row, at which any colour is not the ground's."""
    rows, columns = np.indices((SIDE, SIDE))
    away = columns - rows if diagonal else columns - SIDE // 2
    inside = slice(8, -8)
    dimmed = (seen < 1).any(axis=0)[inside, inside]
    return sorted(set(away[inside, inside][dimmed].tolist()))


def true_black(seen: np.ndarray) -> int:
    """How many columns are black in all colours and rows: where an upright line kept its colour."""
    return int((seen[:, 8:-8] == 0).all(axis=(0, 1)).sum())


@pytest.mark.parametrize("pattern", BAYER_PATTERNS)
def test_a_line_needs_five_pixels_of_the_image_to_keep_its_colour(pattern: str) -> None:
    """The paper's five are pixels after interpolation: two of transition on either side of the true colour."""
    spreads = {}
    for width in range(1, 8):
        seen = bayer.simulated(line_scene(width), pattern, "bilinear")
        if true_black(seen):
            spreads[width] = len(touched(seen))
            assert true_black(seen) == width - 2
    assert min(spreads.values()) == 5
    assert min(spreads) == 3


@pytest.mark.parametrize("pattern", BAYER_PATTERNS)
def test_opencv_says_the_same(pattern: str) -> None:
    """Away from the borders, which OpenCV copies, and to 1 DN, as it rounds otherwise."""
    scene = orthoimage((64, 80))
    colours = np.array(["RGB".index(colour) for colour in pattern]).reshape(2, 2)
    chip = np.choose(np.tile(colours, (32, 40)), scene)
    expected = np.moveaxis(cv2.cvtColor(chip, getattr(cv2, f"COLOR_Bayer{pattern[:1:-1]}2RGB")), -1, 0)
    interpolated = bayer.interpolated(chip, pattern, "bilinear")
    assert np.abs(interpolated.astype(int) - expected)[:, 2:-2, 2:-2].max() <= 1
    for index, colour in enumerate("RGB"):  # what the chip has seen stays
        for place, there in enumerate(pattern):
            if there == colour:
                row, column = divmod(place, 2)
                assert np.array_equal(interpolated[index, row::2, column::2], scene[index, row::2, column::2])


@pytest.mark.parametrize("demosaic", DEMOSAICS)
@pytest.mark.parametrize("pattern", BAYER_PATTERNS)
def test_a_plain_scene_stays_as_it_is(pattern: str, demosaic: str) -> None:
    scene = np.array([10, 120, 250], np.uint8)[:, np.newaxis, np.newaxis].repeat(16, 1).repeat(17, 2)
    assert np.array_equal(bayer.simulated(scene, pattern, demosaic), scene)


GREEN_AT_OTHERS = ((0, 0, -1, 0, 0), (0, 0, 2, 0, 0), (-1, 2, 4, 2, -1), (0, 0, 2, 0, 0), (0, 0, -1, 0, 0))
IN_ITS_ROW = ((0, 0, 0.5, 0, 0), (0, -1, 0, -1, 0), (-1, 4, 5, 4, -1), (0, -1, 0, -1, 0), (0, 0, 0.5, 0, 0))
AT_OPPOSITE = ((0, 0, -1.5, 0, 0), (0, 2, 0, 2, 0), (-1.5, 0, 6, 0, -1.5), (0, 2, 0, 2, 0), (0, 0, -1.5, 0, 0))
"""The filters as Malvar, He and Cutler print them (2004, figure 2), eight times as large."""


def filtered_as_published(chip: np.ndarray, pattern: str) -> np.ndarray:
    """(3, rows, columns) by the printed filters alone, pixel by pixel, mirrored at the borders."""
    green, row, column, opposite = (
        ndimage.correlate(chip, np.array(kernel) / 8, mode="mirror")
        for kernel in (GREEN_AT_OTHERS, IN_ITS_ROW, np.transpose(IN_ITS_ROW), AT_OPPOSITE)
    )
    made = np.empty((3, *chip.shape))
    for y, x in np.ndindex(chip.shape):
        here, beside = pattern[2 * (y % 2) + x % 2], pattern[2 * (y % 2) + (x + 1) % 2]
        for index, colour in enumerate("RGB"):
            if colour == here:
                made[index, y, x] = chip[y, x]
            elif colour == "G":
                made[index, y, x] = green[y, x]
            elif here == "G":
                made[index, y, x] = row[y, x] if beside == colour else column[y, x]
            else:
                made[index, y, x] = opposite[y, x]
    return made


@pytest.mark.parametrize("pattern", BAYER_PATTERNS)
def test_malvar_is_the_published_filters(pattern: str) -> None:
    chip = np.random.default_rng(1).uniform(0, 255, (21, 26))
    assert np.allclose(bayer.interpolated(chip, pattern, "malvar"), filtered_as_published(chip, pattern), atol=1e-10)


def psnr(scene: np.ndarray, seen: np.ndarray) -> float:
    """dB, of 8 bit."""
    return 10 * np.log10(255**2 / np.mean((seen.astype(float) - scene)[:, 8:-8, 8:-8] ** 2))


@pytest.mark.release
@pytest.mark.parametrize(
    "path", ["noise/seneca/IMG_0460.jpg", "frames/ngi/3324c_2015_1004_05_0182_RGB.tif",
             "seams/packo/19FD5606Ax00020_16372.tif", "seams/brighton/mosaic_hardseam.tif"],
)
def test_malvar_is_nearer_to_real_scenes(data_folder: Path, path: str) -> None:
    """3 dB and more nearer; the documentation says by how much, and that OpenCV's way is not nearer than bilinear."""
    source = gdal.Open(str(data_folder / path))
    scene = source.ReadAsArray(source.RasterXSize // 2 - 128, source.RasterYSize // 2 - 128, 256, 256)
    away = {way: psnr(scene, bayer.simulated(scene, "RGGB", way)) for way in DEMOSAICS}
    assert away["malvar"] > away["bilinear"] + 3
    assert away["edge_aware"] < away["malvar"] - 3


def test_without_opencv_it_explains(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "cv2", None)
    monkeypatch.setattr(bayer, "find_spec", lambda name: None)
    with pytest.raises(SettingsError, match=r"needs OpenCV .* choose malvar or bilinear"):
        bayer.check_demosaic("edge_aware")
    bayer.check_demosaic("bilinear")


@pytest.mark.parametrize("demosaic", DEMOSAICS)
def test_strips_of_a_file_fit_together(
    make_raster: MakeRaster, monkeypatch: pytest.MonkeyPatch, demosaic: str
) -> None:
    scene = orthoimage((61, 50))
    path, target = make_raster("scene.tif", scene, nodata=0), make_raster("seen.tif", scene)
    monkeypatch.setattr(bayer, "_STRIP_PIXELS", 50 * 10)
    bayer.simulate_file(describe_north_up(RasterRef(path)), target, "GRBG", demosaic)
    seen = read_pixels(target, 0, 0, 50, 61)
    assert np.array_equal(seen, bayer.simulated(scene, "GRBG", demosaic))
    assert describe_north_up(RasterRef(target)).grid == describe_north_up(RasterRef(path)).grid


def test_a_single_band_is_a_grey_scene_and_nodata_stays(make_raster: MakeRaster) -> None:
    scene = orthoimage((32, 32))[:1]
    scene[0, :4] = 0
    target = make_raster("seen.tif", scene)
    bayer.simulate_file(describe_north_up(RasterRef(make_raster("g.tif", scene, nodata=0))), target, "RGGB", "bilinear")
    seen = read_pixels(target, 0, 0, 32, 32)
    assert seen.shape == (3, 32, 32)
    assert not seen[:, :4].any()
