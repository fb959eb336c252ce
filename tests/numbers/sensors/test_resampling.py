"""Values between pixels are those of GDAL's warper, at any step; what is missing plays no part."""
from __future__ import annotations

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.sensors.measure.photo_warp import KERNELS, Resampler

from tests.numbers.synthetic import wkt

PIXELS = np.random.default_rng(3).uniform(0, 255, (1, 120, 140)).astype(np.float32)


def by_gdal(name: str, step: float, count: int, left: float, top: float) -> np.ndarray:
    source = gdal.GetDriverByName("MEM").Create("", 140, 120, 1, gdal.GDT_Float32)
    source.GetRasterBand(1).WriteArray(PIXELS[0])
    source.SetGeoTransform((0, 1, 0, 0, 0, -1))
    source.SetProjection(wkt(32633))
    bounds = (left, -top - count * step, left + count * step, -top)
    made = gdal.Warp("", source, format="MEM", outputBounds=bounds, width=count, height=count,
                     resampleAlg="near" if name == "nearest" else name)  # fmt: skip
    return np.asarray(made.ReadAsArray())


# GDAL 3.6 rounds where a widened lanczos lies to whole steps, and its mean over less than a pixel is that pixel
CASES = [(name, step) for name in KERNELS for step in (0.8, 1.0, 2.0, 3.3)
         if (name, step) not in (("lanczos", 2.0), ("lanczos", 3.3), ("average", 0.8))]  # fmt: skip


@pytest.mark.parametrize(("name", "step"), CASES)
def test_values_are_those_of_gdal(name: str, step: float) -> None:
    left, top, count = 30.3, 31.7, int(60 / step)
    middles = (np.arange(count) + 0.5) * step
    columns, rows = (side.ravel() for side in np.meshgrid(left + middles, top + middles))
    values, there = Resampler.of(name, (step, step)).at(PIXELS, None, columns, rows)
    assert there.all()
    assert values.reshape(count, count) == pytest.approx(by_gdal(name, step, count, left, top), abs=0.1)


@pytest.mark.parametrize("name", KERNELS)
def test_what_is_missing_plays_no_part(name: str) -> None:
    valid = np.ones(PIXELS.shape[1:], bool)
    valid[50:60, 50:70] = False
    rng = np.random.default_rng(4)
    columns, rows = rng.uniform(30, 90, 500), rng.uniform(30, 80, 500)
    holes = np.where(valid, PIXELS, 1e6).astype(np.float32)
    flat = np.where(valid, 7.0, 1e6)[None].astype(np.float32)
    resampler = Resampler.of(name, (1.5, 1.0))
    values, there = resampler.at(holes, valid, columns, rows)
    assert (there == valid[rows.astype(int), columns.astype(int)]).all()
    assert np.abs(values[:, there]).max() < 1e4
    assert resampler.at(flat, valid, columns, rows)[0][:, there] == pytest.approx(7.0, rel=1e-4)


def test_a_widened_lanczos_is_its_formula() -> None:
    column, row = 61.3, 57.9
    across, down = ((np.arange(size) + 0.5 - place) / 2 for size, place in ((140, column), (120, row)))
    weights = [np.where(np.abs(steps) < 3, np.sinc(steps) * np.sinc(steps / 3), 0) for steps in (across, down)]
    expected = weights[1] @ PIXELS[0] @ weights[0] / weights[0].sum() / weights[1].sum()
    values, _ = Resampler.of("lanczos", (2.0, 2.0)).at(PIXELS, None, np.array([column]), np.array([row]))
    assert values[0, 0] == pytest.approx(expected, abs=0.05)
