"""A single-chip camera: the paper's experiment with thin lines, OpenCV as witness, and files in strips."""
from __future__ import annotations

import sys
from collections.abc import Callable

import numpy as np
import pytest
from seam_inspector.plugin.imagery.errors import RasterError, SettingsError
from seam_inspector.plugin.imagery.open_raster import describe_north_up
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.resolution.measure import bayer
from seam_inspector.plugin.resolution.measure.limits import BAYER_PATTERNS

from tests.numbers.synthetic import orthoimage, read_pixels

cv2 = pytest.importorskip("cv2", reason="OpenCV is the witness here; it is in requirements-dev.txt")

MakeRaster = Callable[..., str]
OPENCV = {"RGGB": "BG", "BGGR": "RG", "GRBG": "GB", "GBRG": "GR"}
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
def test_a_line_of_one_pixel_spreads_over_three(pattern: str) -> None:
    seen = bayer.simulated(line_scene(1), pattern, "bilinear")
    assert touched(seen) == [-1, 0, 1]
    assert true_black(seen) == 0
    colours = seen[:, 8:-8, SIDE // 2]
    assert np.ptp(colours, axis=0).max() == 1  # it got a colour: one channel does not see it at all


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


def test_at_45_degrees_it_spreads_by_another_root_of_two() -> None:
    """One pixel to either side of an upright line, at 45 degrees two half diagonals of a pixel, at worst.

    A slanted line that lies on green pixels alone is spread less: red and blue don't see it at all.
    """
    sides = {}
    for pattern in BAYER_PATTERNS:
        upright = touched(bayer.simulated(line_scene(1), pattern, "bilinear"))
        slanted = touched(bayer.simulated(line_scene(1, diagonal=True), pattern, "bilinear"), diagonal=True)
        assert min(slanted) == -max(slanted)
        sides[pattern] = max(slanted) / np.sqrt(2) / max(upright)
    assert max(sides.values()) == pytest.approx(np.sqrt(2))
    assert sides["RGGB"] == sides["BGGR"] == max(sides.values())


@pytest.mark.parametrize("pattern", BAYER_PATTERNS)
def test_opencv_says_the_same(pattern: str) -> None:
    """Away from the borders, which OpenCV copies, and to 1 DN, as it rounds otherwise."""
    scene = orthoimage((64, 80))
    chip = bayer.filtered(scene, pattern)
    expected = np.moveaxis(cv2.cvtColor(chip, getattr(cv2, f"COLOR_Bayer{OPENCV[pattern]}2RGB")), -1, 0)
    found = bayer.interpolated(chip, pattern, "bilinear")
    assert np.abs(found.astype(int) - expected)[:, 2:-2, 2:-2].max() <= 1
    for index, colour in enumerate("RGB"):  # what the chip has seen stays
        for place, there in enumerate(pattern):
            if there == colour:
                row, column = divmod(place, 2)
                assert np.array_equal(found[index, row::2, column::2], scene[index, row::2, column::2])


@pytest.mark.parametrize("demosaic", ["bilinear", "edge_aware"])
@pytest.mark.parametrize("pattern", BAYER_PATTERNS)
def test_a_plain_scene_stays_as_it_is(pattern: str, demosaic: str) -> None:
    scene = np.array([10, 120, 250], np.uint8)[:, np.newaxis, np.newaxis].repeat(16, 1).repeat(17, 2)
    assert np.array_equal(bayer.simulated(scene, pattern, demosaic), scene)


def test_edge_aware_is_nearer_to_the_scene() -> None:
    scene = (200 - 150 * line_scene(3)).astype(np.uint8)
    errors = [
        np.abs(bayer.simulated(scene, "RGGB", way).astype(int) - scene)[:, 8:-8, 8:-8].mean()
        for way in ("bilinear", "edge_aware")
    ]
    assert errors[1] < errors[0]


def test_without_opencv_it_explains(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "cv2", None)
    monkeypatch.setattr(bayer, "find_spec", lambda name: None)
    with pytest.raises(SettingsError, match=r"needs OpenCV .* choose bilinear"):
        bayer.check_demosaic("RGGB", "edge_aware")
    bayer.check_demosaic("RGGB", "bilinear")


@pytest.mark.parametrize("words", [("XXXX", "bilinear"), ("RGGB", "cubic")])
def test_unknown_ways_are_refused(words: tuple[str, str]) -> None:
    with pytest.raises(SettingsError, match="choose one of"):
        bayer.check_demosaic(*words)


@pytest.mark.parametrize("demosaic", ["bilinear", "edge_aware"])
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


def test_what_has_no_colours_is_refused(make_raster: MakeRaster) -> None:
    raster = describe_north_up(RasterRef(make_raster("two.tif", orthoimage((16, 16))[:2])))
    with pytest.raises(RasterError, match="has 2 bands and no red, green and blue"):
        bayer.simulate_file(raster, make_raster("out.tif", orthoimage((16, 16))), "RGGB", "bilinear")
    floats = describe_north_up(RasterRef(make_raster("f.tif", orthoimage((16, 16), dtype=np.float32))))
    with pytest.raises(RasterError, match="choose bilinear"):
        bayer.simulate_file(floats, make_raster("out.tif", orthoimage((16, 16))), "RGGB", "edge_aware")
