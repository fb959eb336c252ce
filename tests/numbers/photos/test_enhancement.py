"""The side operations against scipy on the whole photo at once."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from scipy import ndimage
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.photos.measure import limits, photo
from seam_inspector.plugin.photos.measure.enhancement import enhance

from tests.numbers.synthetic import ORIGIN, orthoimage, write_plain, write_raster


@pytest.fixture(autouse=True)
def narrow_strips(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(photo, "STRIP_PIXELS", 700)  # so that a test's photo has many


def enhanced(path: str, folder: Path, operation: str, size: float = 3) -> gdal.Dataset:
    enhance(RasterRef(path), str(folder / "out.tif"), operation, size)
    return gdal.Open(str(folder / "out.tif"))


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.float32])
@pytest.mark.parametrize("operation", limits.OPERATIONS)
def test_strips_make_what_scipy_makes_of_the_whole(tmp_path: Path, operation: str, dtype: type) -> None:
    pixels = orthoimage((53, 71), dtype=dtype)
    path = write_raster(tmp_path / "photo.tif", pixels)
    exact = pixels.astype(float)
    largest = float(exact.max()) if dtype is np.float32 else float(np.iinfo(dtype).max)
    if dtype is np.float32:
        largest = float(exact[0].max())
    expected = {
        limits.NEGATIVE: lambda: largest - exact,
        limits.GREY: lambda: np.tensordot([0.299, 0.587, 0.114], exact, 1)[np.newaxis] * 255 / largest,
        limits.MEAN: lambda: ndimage.uniform_filter(exact, (0, 3, 3)),
        limits.GAUSSIAN: lambda: ndimage.gaussian_filter(exact, (0, 3, 3)),
        limits.LAPLACE: lambda: np.stack([ndimage.laplace(band) for band in exact]),
        limits.SOBEL: lambda: np.stack([np.hypot(ndimage.sobel(b, 0), ndimage.sobel(b, 1)) for b in exact]),
    }[operation]()
    made = enhanced(path, tmp_path, operation)
    signed = operation in (limits.LAPLACE, limits.SOBEL)
    wanted = np.float32 if signed else np.uint8 if operation == limits.GREY else dtype
    assert made.ReadAsArray().dtype == wanted
    rounded = 0.51 if np.dtype(wanted).kind == "u" else 0.01
    assert np.abs(made.ReadAsArray() - np.clip(expected, 0 if rounded > 0.5 else -1e9, 1e9)).max() <= rounded
    assert made.GetGeoTransform()[:4:3] == ORIGIN
    assert "UTM zone 33N" in made.GetProjection()


def test_a_photo_without_a_place_on_the_map_gets_none(tmp_path: Path) -> None:
    path = write_plain(tmp_path / "photo.bmp", orthoimage((20, 30), 1)[0])
    assert enhanced(path, tmp_path, limits.NEGATIVE).GetGeoTransform(can_return_null=True) is None


def test_invalid_pixels_stay_invalid(tmp_path: Path) -> None:
    pixels = orthoimage((40, 50))
    pixels[:, 30:, :20] = 0
    path = write_raster(tmp_path / "photo.tif", pixels, nodata=0)
    made = enhanced(path, tmp_path, limits.MEAN)
    mask = made.GetRasterBand(1).GetMaskBand().ReadAsArray()
    assert ((mask == 0) == (pixels == 0).all(axis=0)).all()


@pytest.mark.parametrize(("operation", "size"), [
    (limits.MEAN, 4), (limits.MEAN, 1), (limits.MEAN, 999), (limits.GAUSSIAN, 0), (limits.GAUSSIAN, 999)
])
def test_a_size_that_makes_no_sense_is_refused(tmp_path: Path, operation: str, size: float) -> None:
    path = write_plain(tmp_path / "photo.tif", orthoimage((20, 30), 1)[0])
    with pytest.raises(SettingsError, match="px; give"):
        enhanced(path, tmp_path, operation, size)
