"""The directional components of a clip's detail, against those of PyWavelets."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.imagery.clips import Clip, read_clip
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.imagery.wavelets import measure_bands, measure_directions

from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import luminance, orthoimage, wavedec, without_mean

SIDE = 128


@pytest.fixture
def clip(make_raster: MakeRaster) -> Clip:
    return read(make_raster("clip.tif", orthoimage((SIDE, SIDE))))


def read(path: str) -> Clip:
    ref = RasterRef(path)
    return read_clip(OpenRaster(ref), describe(ref), PixelWindow(0, 0, SIDE, SIDE))


@pytest.mark.parametrize(("wavelet", "levels"), [("coif3", 3), ("haar", 1), ("db4", 4)])
def test_they_are_those_of_pywavelets(clip: Clip, wavelet: str, levels: int) -> None:
    shares = measure_directions(clip, wavelet, levels)
    planes = dict(zip(("luminance", "red", "green", "blue"), (luminance(clip.bands), *clip.bands)))
    assert list(shares) == list(planes)
    for name, plane in planes.items():
        energy = np.sum(without_mean(plane) ** 2)
        expected = [[np.sum(part**2) / energy for part in level] for level in wavedec(plane, wavelet, levels)[:0:-1]]
        np.testing.assert_allclose(shares[name], expected, rtol=1e-6)


def test_their_sum_is_the_detail_of_the_curve(clip: Clip) -> None:
    curves, _ = measure_bands(clip.bands, clip.raster.band_names, "coif3", 3)
    for name, directions in measure_directions(clip, "coif3", 3).items():
        assert curves[name].detail == pytest.approx([sum(level) for level in directions], abs=1e-6)


def test_lines_show_up_in_their_direction(make_raster: MakeRaster) -> None:
    """First LH: plough marks from west to east; then HL: from north to south; then HH: both ways at once."""
    row, column = np.mgrid[:SIDE, :SIDE]
    for place, marks in enumerate((row, column, row + column)):
        path = make_raster(f"{place}.tif", (100 + 50 * (marks % 2)).astype(np.uint8))
        ((finest, *coarser),) = measure_directions(read(path), "haar", 2).values()
        assert finest == pytest.approx([float(place == direction) for direction in range(3)], abs=1e-9)
        assert coarser == [pytest.approx((0, 0, 0), abs=1e-9)]
