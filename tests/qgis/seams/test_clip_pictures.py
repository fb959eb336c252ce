"""Pictures of a window: one stretch for all of them, against numpy's percentiles."""
from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.clip_pictures import ClipPicture, make_pictures
from seam_inspector.plugin.seams.measure.inspection import InspectionSettings, WindowRequest, make_block

from tests.numbers.synthetic import ORIGIN, orthoimage, write_raster

WINDOW = PixelWindow(40, 24, 128, 96)
PART = (..., slice(24, 120), slice(40, 168))


def request(paths: Sequence[Path], window: PixelWindow | None = WINDOW) -> WindowRequest:
    """The first path is the mosaic's."""
    mosaic = describe_mosaic(RasterRef(str(paths[0])))
    sources = make_block(mosaic, [RasterRef(str(path)) for path in paths[1:]])[0].sources if paths[1:] else ()
    return WindowRequest(1, mosaic, sources, window, InspectionSettings())


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
        assert picture.pixels.flags.c_contiguous
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
    part = np.full((3, 64, 64), 90, "u1")
    write_raster(tmp_path / "2.tif", part)
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
    assert make_pictures(request(paths(tmp_path)), lambda: True) == []


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


def test_no_qt_is_needed(repository: Path) -> None:
    code = "import sys; import seam_inspector.plugin.seams.clip_pictures; print('qgis' in sys.modules)"
    finished = subprocess.run(
        [sys.executable, "-c", code], cwd=repository / "build" / "plugins", capture_output=True, text=True, check=True
    )
    assert finished.stdout.strip() == "False"
