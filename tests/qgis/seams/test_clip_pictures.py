"""Pictures of a window as they were delivered."""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.clip_pictures import make_pictures
from seam_inspector.plugin.seams.measure.window.inspection import make_block
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings, WindowRequest
from seam_inspector.plugin.toolkit import pictures

from tests.numbers.synthetic import orthoimage, write_raster

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


def test_unreadable_and_uncovering_sources_are_left_out(tmp_path: Path) -> None:
    rasters(tmp_path, "u1")
    asked = request(paths(tmp_path))
    (tmp_path / "1.tif").unlink()
    write_raster(tmp_path / "2.tif", np.full((3, 24, 256), 90, "u1"))  # of the ground around the window only
    assert [picture.raster for picture in make_pictures(asked)[0]] == ["0.tif"]


def test_without_the_mosaic_the_sources_are_there(tmp_path: Path) -> None:
    rasters(tmp_path, "u1")
    asked = request(paths(tmp_path))
    (tmp_path / "0.tif").unlink()
    assert [(picture.raster, picture.is_mosaic) for picture in make_pictures(asked)[0]] == [
        ("1.tif", False), ("2.tif", False)
    ]


def test_a_source_that_covers_some_of_it_is_shown_with_squares(tmp_path: Path) -> None:
    rasters(tmp_path, "u1")
    write_raster(tmp_path / "1.tif", np.full((3, 256, 80), 200, "u1"))
    partly = make_pictures(request(paths(tmp_path, 2)))[0][1].pixels
    assert set(np.unique(partly[:, :40])) == {200}
    assert set(np.unique(partly[:, 40:])) == {88, 104}


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
    (picture,) = make_pictures(request(paths(tmp_path, 1)))[0]
    wanted = np.moveaxis(pixels[PART], 0, -1) * (255 / white)
    assert abs(picture.pixels - wanted.clip(0, 255)).max() <= 0.5001


@pytest.mark.parametrize("value", [-(2.0**63), 2.0**62, 1e15, 0.0])
@pytest.mark.filterwarnings("error")
def test_pixels_that_are_alike_have_a_picture_however_large_they_are(value: float) -> None:
    alike = np.full((4, 4), value)
    for pixels in (alike, alike.astype(np.float32), alike.astype(np.int64)):
        low, high = pictures.cut_range([pixels])
        assert (pictures.to_bytes(pixels, low, high) == pictures.to_bytes(pixels, low, high)[0]).all()
        assert high > low
        assert np.ptp(pictures.to_bytes(pixels, value, value)) == 0


@pytest.mark.filterwarnings("error")
def test_what_is_no_number_is_black() -> None:
    pixels = np.array([[np.nan, np.inf, -np.inf, 1e38, 10.0, 20.0]])
    low, high = pictures.cut_range([pixels])
    assert (low, high) == pytest.approx((10.2, 19.8))
    assert pictures.to_bytes(pixels, low, high).tolist() == [[0, 255, 0, 255, 0, 255]]
