"""Pictures of a window: as delivered, or one stretch for all of them, against numpy's percentiles."""
from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.clip_pictures import ClipPicture, PictureRequest, WindowPictureSet, with_ground
from seam_inspector.plugin.seams.clip_pictures import make_pictures as make_picture_set
from seam_inspector.plugin.seams.measure.inspection import make_block
from seam_inspector.plugin.seams.measure.window.window_request import InspectionSettings, WindowRequest
from seam_inspector.plugin.toolkit import picture_stretch
from seam_inspector.plugin.toolkit.picture_stretch import Stretch

from tests.numbers.synthetic import ORIGIN, orthoimage, write_raster

WINDOW = PixelWindow(40, 24, 128, 96)
PART = (..., slice(24, 120), slice(40, 168))


def request(paths: Sequence[Path], window: PixelWindow | None = WINDOW) -> WindowRequest:
    """The first path is the mosaic's."""
    mosaic = describe_mosaic(RasterRef(str(paths[0])))
    sources = make_block(mosaic, [RasterRef(str(path)) for path in paths[1:]])[0].sources if paths[1:] else ()
    return WindowRequest(1, mosaic, sources, window, InspectionSettings())


def make_pictures(asked: WindowRequest, stretch: Stretch = Stretch.WINDOW) -> list[ClipPicture]:
    """The pixels of the window alone, without the ground around it."""
    found = []
    for picture in make_picture_set(PictureRequest(asked, stretch)).pictures:
        inside = picture.inside
        if inside is not None:
            part = picture.pixels[inside.row :, inside.column :][: inside.height, : inside.width]
            picture = replace(picture, pixels=part)
        found.append(picture)
    return found


def of_project(asked: WindowRequest, stretch: Stretch, before: WindowPictureSet | None = None) -> WindowPictureSet:
    return make_picture_set(PictureRequest(asked, stretch, before.ranges if before else {}))


def rasters(folder: Path, dtype: str, gains: Sequence[float] = (1, 0.8, 1.1), bands: int = 3) -> list[np.ndarray]:
    """Written as 0.tif, 1.tif, ...: the same ground in other tones."""
    ground = orthoimage((256, 512), bands, dtype=np.float64)
    factor = {"u1": 1, "u2": 40, "i2": 40, "f4": 0.01, "f8": 1e6}[dtype]
    made = [(np.clip(ground * gain, 0, 255) * factor).astype(dtype) for gain in gains]
    for i, pixels in enumerate(made):
        write_raster(folder / f"{i}.tif", pixels)
    return made


def paths(folder: Path, count: int = 3) -> list[Path]:
    return [folder / f"{i}.tif" for i in range(count)]


def stretched(clips: Sequence[np.ndarray]) -> list[np.ndarray]:
    """(rows, columns, bands) uint8 of (bands, rows, columns) clips: percentiles of all bands of all of them."""
    low, high = np.percentile(np.concatenate([clip.ravel() for clip in clips]).astype(float), (2, 98))
    return [
        np.moveaxis(np.clip(np.rint((clip - low) / (high - low) * 255), 0, 255), 0, -1).astype(np.uint8)
        for clip in clips
    ]


@pytest.mark.parametrize("dtype", ["u1", "u2", "i2", "f4", "f8"])
def test_one_stretch_for_all(tmp_path: Path, dtype: str) -> None:
    made = rasters(tmp_path, dtype)
    pictures = make_pictures(request(paths(tmp_path)))
    assert [(picture.raster, picture.is_mosaic) for picture in pictures] == [
        ("0.tif", True), ("1.tif", False), ("2.tif", False)
    ]
    for picture, expected in zip(pictures, stretched([pixels[PART] for pixels in made])):
        assert picture.pixels.dtype == np.uint8
        assert abs(picture.pixels.astype(int) - expected).max() <= 1  # halves may be rounded either way


def test_tones_still_differ_between_rasters(tmp_path: Path) -> None:
    rasters(tmp_path, "u1")
    mosaic, darker, brighter = (picture.pixels.mean() for picture in make_pictures(request(paths(tmp_path))))
    assert darker < mosaic < brighter


def test_one_band_is_grey(tmp_path: Path) -> None:
    made = rasters(tmp_path, "u2", bands=1)
    for picture, expected in zip(make_pictures(request(paths(tmp_path))), stretched([a[PART] for a in made])):
        assert picture.pixels.shape == (96, 128, 3)
        assert abs(picture.pixels.astype(int) - expected).max() <= 1


def test_near_infrared_is_left_out(tmp_path: Path) -> None:
    made = rasters(tmp_path, "u1", bands=4)
    for picture, expected in zip(make_pictures(request(paths(tmp_path))), stretched([a[PART][:3] for a in made])):
        assert abs(picture.pixels.astype(int) - expected).max() <= 1


def test_data_types_are_stretched_for_themselves(tmp_path: Path) -> None:
    """A mosaic of 8 bit beside orthoimages of 16: with one stretch it would be black."""
    ground = rasters(tmp_path, "u1")[0]
    write_raster(tmp_path / "1.tif", ground.astype("u2") * 100)
    mosaic, source = make_pictures(request(paths(tmp_path, 2)))
    assert abs(mosaic.pixels.astype(int) - source.pixels).max() <= 1  # halves may be rounded either way


def test_large_windows_are_sampled_well_enough(tmp_path: Path) -> None:
    pixels = orthoimage((1280, 1536))
    write_raster(tmp_path / "0.tif", pixels)
    window = PixelWindow(0, 0, 1536, 1280)
    (picture,) = make_pictures(request(paths(tmp_path, 1), window))
    (expected,) = stretched([pixels])
    assert abs(picture.pixels.astype(int) - expected).max() <= 4


@pytest.mark.parametrize("dtype", ["u1", "f4"])
def test_a_constant_raster_is_mid_grey(tmp_path: Path, dtype: str) -> None:
    write_raster(tmp_path / "0.tif", np.full((3, 256, 256), 7, dtype))
    (picture,) = make_pictures(request(paths(tmp_path, 1)))
    assert set(np.unique(picture.pixels)) == {128}


def test_unreadable_and_uncovering_sources_are_left_out(tmp_path: Path) -> None:
    rasters(tmp_path, "u1")
    asked = request(paths(tmp_path))
    (tmp_path / "1.tif").unlink()
    write_raster(tmp_path / "2.tif", np.full((3, 24, 256), 90, "u1"))  # of the ground around the window only
    assert [picture.raster for picture in make_pictures(asked)] == ["0.tif"]


def test_without_the_mosaic_the_sources_are_there(tmp_path: Path) -> None:
    rasters(tmp_path, "u1")
    asked = request(paths(tmp_path))
    (tmp_path / "0.tif").unlink()
    assert [(picture.raster, picture.is_mosaic) for picture in make_pictures(asked)] == [
        ("1.tif", False), ("2.tif", False)
    ]


def test_nothing_without_a_window_or_when_cancelled(tmp_path: Path) -> None:
    rasters(tmp_path, "u1")
    assert make_pictures(request(paths(tmp_path), None)) == []
    assert make_picture_set(PictureRequest(request(paths(tmp_path))), lambda: True).pictures == ()


def test_offsets_and_resampling_are_told(tmp_path: Path) -> None:
    ground = rasters(tmp_path, "u1")[0]
    write_raster(tmp_path / "1.tif", ground, origin=(ORIGIN[0] - 0.025, ORIGIN[1] - 0.05))
    write_raster(tmp_path / "2.tif", ground, gsd=0.2)
    _, shifted, coarser = make_pictures(request(paths(tmp_path)))
    assert abs(shifted.offset_x) == pytest.approx(0.25)
    assert abs(shifted.offset_y) == pytest.approx(0.5)
    assert (shifted.resampled, coarser.resampled) == (False, True)


def test_reduced_pictures_are_means(tmp_path: Path) -> None:
    pixels = orthoimage((1024, 1024))
    write_raster(tmp_path / "0.tif", pixels)
    (picture,) = make_pictures(request(paths(tmp_path, 1), PixelWindow(0, 0, 1000, 600)))
    assert [reduced.shape for reduced in picture.reduced] == [(300, 500, 3), (150, 250, 3)]
    means = picture.pixels.reshape(300, 2, 500, 2, 3).mean(axis=(1, 3))
    assert abs(picture.reduced[0] - means).max() <= 0.5


def test_pictures_are_compared_by_identity() -> None:
    """Arrays have no truth value."""
    pixels = np.zeros((2, 2, 3), np.uint8)
    assert ClipPicture("a", True, pixels) != ClipPicture("a", True, pixels)


def test_a_source_that_covers_some_of_it_is_shown_with_squares(tmp_path: Path) -> None:
    rasters(tmp_path, "u1")
    write_raster(tmp_path / "1.tif", np.full((3, 256, 80), 200, "u1"))
    partly = make_pictures(request(paths(tmp_path, 2)), Stretch.DELIVERED)[1].pixels
    assert set(np.unique(partly[:, :40])) == {200}
    assert set(np.unique(partly[:, 40:])) == {88, 104}


def test_a_mosaic_with_holes_is_shown(tmp_path: Path) -> None:
    pixels = orthoimage((256, 512))
    pixels[:, 60:100, 60:120] = 0
    write_raster(tmp_path / "0.tif", pixels, nodata=0)
    (picture,) = make_pictures(request(paths(tmp_path, 1)), Stretch.DELIVERED)
    assert set(np.unique(picture.pixels[36:76, 20:80])) == {88, 104}
    assert np.array_equal(picture.pixels[:30], np.moveaxis(pixels[PART], 0, -1)[:30])


# --- as delivered, and one stretch for the project ---------------------------------------------------------------


def test_8_bit_is_shown_as_it_is(tmp_path: Path) -> None:
    made = rasters(tmp_path, "u1")
    for picture, pixels in zip(make_pictures(request(paths(tmp_path)), Stretch.DELIVERED), made):
        assert np.array_equal(picture.pixels, np.moveaxis(pixels[PART], 0, -1))


@pytest.mark.parametrize(("largest", "nbits", "white"), [(3900, None, 4095), (900, 12, 4095), (60000, None, 65535)])
def test_16_bit_is_shown_by_its_range(tmp_path: Path, largest: int, nbits: int | None, white: int) -> None:
    """The mosaic's largest value lies outside of the window."""
    pixels = (orthoimage((256, 512)).astype("u2") * 3) % 700
    pixels[0, 240:, 480:] = largest
    pixels[0, 60, 60] = 65000 if nbits is None else largest  # a hot pixel makes no difference
    write_raster(tmp_path / "0.tif", pixels)
    if nbits:
        gdal.Translate(str(tmp_path / "n.tif"), str(tmp_path / "0.tif"), creationOptions=[f"NBITS={nbits}"])
        (tmp_path / "n.tif").replace(tmp_path / "0.tif")
    (picture,) = make_pictures(request(paths(tmp_path, 1)), Stretch.DELIVERED)
    wanted = np.moveaxis(pixels[PART], 0, -1) * (255 / white)
    assert abs(picture.pixels - wanted.clip(0, 255)).max() <= 0.5001


def test_the_range_grows_with_the_largest_value_seen(tmp_path: Path) -> None:
    """A source that uses more bits than the mosaic: all are shown by them, and earlier windows are made anew."""
    dark = orthoimage((256, 512)).astype("u2") * 3  # below 1024
    write_raster(tmp_path / "0.tif", dark)
    write_raster(tmp_path / "1.tif", dark * 4)
    first = of_project(request(paths(tmp_path, 1)), Stretch.DELIVERED)
    assert first.ranges == {"uint16": (0.0, 1023.0)}
    second = of_project(request(paths(tmp_path, 2)), Stretch.DELIVERED, first)
    assert second.ranges == {"uint16": (0.0, 4095.0)}
    assert of_project(request(paths(tmp_path, 1)), Stretch.DELIVERED, second).ranges == second.ranges


def test_contrast_is_the_same_in_all_windows(tmp_path: Path) -> None:
    """A grey that two windows have looks the same in both, unless each has a stretch of its own."""
    pixels = orthoimage((256, 512))
    pixels[:, :, 256:] = 100 + pixels[:, :, 256:] // 16  # asphalt: nearly one grey
    pixels[:, 40:50, 100:110] = pixels[:, 40:50, 400:410] = 105
    write_raster(tmp_path / "0.tif", pixels)
    rich, flat = PixelWindow(0, 0, 256, 256), PixelWindow(256, 0, 256, 256)
    greys = {}
    for stretch in Stretch:
        seen = set()
        for window, column in ((rich, 100), (flat, 144)):
            (picture,) = make_pictures(request(paths(tmp_path, 1), window), stretch)
            seen |= set(np.unique(picture.pixels[40:50, column : column + 10]).tolist())
        greys[stretch] = seen
    assert greys[Stretch.DELIVERED] == {105}
    assert len(greys[Stretch.COMMON]) == 1
    assert len(greys[Stretch.WINDOW]) > 1


def test_one_stretch_is_the_mosaics_own_cut(tmp_path: Path) -> None:
    made = rasters(tmp_path, "u2")
    low, high = np.percentile(made[0].astype(float), (2, 98))
    for picture, pixels in zip(make_pictures(request(paths(tmp_path)), Stretch.COMMON), made):
        wanted = np.clip(np.rint((np.moveaxis(pixels[PART], 0, -1) - low) / (high - low) * 255), 0, 255)
        assert abs(picture.pixels.astype(int) - wanted).max() <= 2


def test_real_numbers_are_cut_alike_in_all_windows(tmp_path: Path) -> None:
    """They have no range of their own."""
    made = rasters(tmp_path, "f4")
    found = of_project(request(paths(tmp_path)), Stretch.DELIVERED)
    assert found.ranges["float32"] == pytest.approx(np.percentile(made[0].astype(float), (2, 98)), rel=1e-3)


def test_a_large_raster_is_sampled_in_pieces(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(picture_stretch, "_MOST_DECODED", 1)
    pixels = orthoimage((1536, 2048))
    write_raster(tmp_path / "0.tif", pixels)
    found = of_project(request(paths(tmp_path, 1)), Stretch.COMMON).ranges["uint8"]
    assert found == pytest.approx(np.percentile(pixels.astype(float), (2, 98)), abs=4)


# --- ground around small windows ---------------------------------------------------------------------------------


def test_small_windows_are_shown_with_the_ground_around_them(tmp_path: Path) -> None:
    pixels = orthoimage((512, 1024))
    write_raster(tmp_path / "0.tif", pixels)
    for column in (480, 8):  # the second at the mosaic's edge, its picture beyond
        found = of_project(request(paths(tmp_path, 1), PixelWindow(column, 240, 64, 64)), Stretch.DELIVERED)
        (picture,) = found.pictures
        assert picture.pixels.shape == (384, 384, 3)
        assert picture.inside == PixelWindow(160, 160, 64, 64)
        window = np.moveaxis(pixels[:, 240:304, column : column + 64], 0, -1)
        assert np.array_equal(picture.pixels[160:224, 160:224], window)
    assert set(np.unique(picture.pixels[:, :152])) == {88, 104}


def test_large_windows_are_shown_as_they_are() -> None:
    window = PixelWindow(100, 50, 512, 384)
    assert with_ground(window) == (window, PixelWindow(0, 0, 512, 384))


def test_no_qt_is_needed(repository: Path) -> None:
    code = "import sys; import seam_inspector.plugin.seams.clip_pictures; print('qgis' in sys.modules)"
    finished = subprocess.run(
        [sys.executable, "-c", code], cwd=repository / "build" / "plugins", capture_output=True, text=True, check=True
    )
    assert finished.stdout.strip() == "False"


@pytest.mark.parametrize("value", [-(2.0**63), 2.0**62, 1e15, 0.0])
@pytest.mark.filterwarnings("error")
def test_pixels_that_are_alike_have_a_picture_however_large_they_are(value: float) -> None:
    alike = np.full((4, 4), value)
    for pixels in (alike, alike.astype(np.float32), alike.astype(np.int64)):
        low, high = picture_stretch.cut_range([pixels])
        assert (picture_stretch.to_bytes(pixels, low, high) == picture_stretch.to_bytes(pixels, low, high)[0]).all()
        assert high > low
        assert np.ptp(picture_stretch.to_bytes(pixels, value, value)) == 0


@pytest.mark.filterwarnings("error")
def test_what_is_no_number_is_black() -> None:
    pixels = np.array([[np.nan, np.inf, -np.inf, 1e38, 10.0, 20.0]])
    low, high = picture_stretch.cut_range([pixels])
    assert (low, high) == pytest.approx((10.2, 19.8))
    assert picture_stretch.to_bytes(pixels, low, high).tolist() == [[0, 255, 0, 255, 0, 255]]
