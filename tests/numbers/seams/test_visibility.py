"""What a loss means to an eye: the formulas of the papers by numerical integration, and real orthoimages."""
from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from osgeo import gdal
from scipy.integrate import quad
from scipy.optimize import brentq
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.imagery.wavelets import detail_components
from seam_inspector.plugin.seams.measure.judgement.visibility import visibility, white_grey, window_visibility
from seam_inspector.plugin.seams.measure.limits import MAX_SIGNIFICANT_KEPT

from tests.numbers.seams.profile.blends import SIDE, blend
from tests.numbers.synthetic import luminance, read_pixels

VARIANCES = (126.0, 79.0, 74.0)  # DN squared: the medians beside Brighton's seams
GREY, WHITE = 131.0, 255.0
shares = st.floats(0, 1)
variances = st.tuples(*[st.floats(0.01, 1000)] * 3)
greys = st.floats(2, 255)


def by_integration(kept: tuple[float, ...], variance: tuple[float, ...], grey: float, magnification: float) -> float:
    """Mannos and Sakrison, Legge and Foley, Quick, written out: 96 dpi from 60 cm, gamma 2.2, 1 % flare."""
    luminance_of = lambda value: 0.01 + (value / 255) ** 2.2  # noqa: E731
    slope = (luminance_of(grey + 1e-4) - luminance_of(grey - 1e-4)) / 2e-4
    degree_cm = 60 * 2 * math.tan(math.radians(1) / 2)
    frequencies = np.linspace(0.5, 30, 5000)
    peak = max(_mannos_sakrison(frequency) for frequency in frequencies)
    total = 0.0
    for level, (share, energy) in enumerate(zip(kept, variance)):
        frequency = 3 / 8 / 2**level / magnification * degree_cm / 2.54 * 96
        threshold = 1 / (200 * _mannos_sakrison(frequency) / peak)
        contrast = math.sqrt(energy) * slope / luminance_of(grey)
        left = contrast * math.sqrt(share)
        steps, _ = quad(
            lambda c, t=threshold: 1 / (t * max(1, (c / t) ** 0.6)), left, contrast,
            points=[threshold] if left < threshold < contrast else None,
        )  # fmt: skip
        total += steps**3
    return total ** (1 / 3)


def _mannos_sakrison(frequency: float) -> float:
    return 2.6 * (0.0192 + 0.114 * frequency) * math.exp(-((0.114 * frequency) ** 1.1))


@given(st.tuples(shares, shares, shares), variances, greys, st.sampled_from([1.0, 2.0, 4.0]))
def test_it_is_the_integral_of_the_papers_formulas(
    kept: tuple[float, ...], variance: tuple[float, ...], grey: float, magnification: float
) -> None:
    seen = visibility(kept, variance, grey, WHITE, magnification)
    assert seen == pytest.approx(by_integration(kept, variance, grey, magnification), rel=1e-3, abs=1e-6)


def test_nothing_is_made_up() -> None:
    assert visibility((), VARIANCES, GREY, WHITE) is None
    assert visibility((None, 0.5, 0.5), VARIANCES, GREY, WHITE) is None
    assert visibility((0.5, 0.5, 0.5), VARIANCES, 0.0, WHITE) is None
    assert visibility((0.5, 0.5, 0.5), VARIANCES, -3.0, WHITE) is None
    assert visibility((0.5, 0.5, 0.5), VARIANCES, math.nan, WHITE) is None
    assert visibility((0.5, 0.5, 0.5), VARIANCES, GREY, math.nan) is None
    assert visibility((0.5, None, None), VARIANCES, GREY, WHITE) == visibility((0.5,), VARIANCES, GREY, WHITE)


def raster(data_type: str, bits: int | None = None) -> Raster:
    return Raster(RasterRef("mosaic.tif"), SIDE, SIDE, None, "", ("band_1",), data_type, bits)


@pytest.mark.parametrize(
    ("data_type", "bits", "largest", "white"),
    [
        ("uint8", None, 90.0, 255), ("uint16", 12, 90.0, 4095), ("uint16", None, 3000.0, 4095),
        ("uint16", None, 60_000.0, 65_535), ("float32", None, 180.0, 255), ("int16", None, 3000.0, 4095),
        ("float32", None, 0.4, 0.4),
    ],
)  # fmt: skip
def test_white_is_the_brightest_value_that_the_image_can_have(
    data_type: str, bits: int | None, largest: float, white: float
) -> None:
    assert white_grey(raster(data_type, bits), largest) == white


WHOLE = slice(0, SIDE), slice(0, SIDE)


def test_a_feathers_window_is_seen_and_a_hard_cuts_is_not() -> None:
    seen = {}
    for width in (0, 66):
        made = blend(width)
        detail = made.detail()
        seen[width] = window_visibility(detail.profile, detail.judged, made.made, WHOLE, raster("uint8"))
    assert seen[0] < 0.25
    assert seen[66] > seen[0] + 0.8


def windows_of(folder: Path, pattern: str) -> Iterator[np.ndarray]:
    """Windows of 256 px without empty pixels, luminance."""
    for path in sorted(folder.glob(pattern)):
        rows, columns = read_size(path)
        for row in range(0, rows - 255, 512):
            for column in range(0, columns - 255, 512):
                pixels = read_pixels(str(path), column, row, 256, 256)[:3]
                if (pixels.max(axis=0) > 0).all():
                    yield luminance(pixels)


def read_size(path: Path) -> tuple[int, int]:
    dataset = gdal.Open(str(path))
    return dataset.RasterYSize, dataset.RasterXSize


def detail_of(plane: np.ndarray) -> tuple[float, ...]:
    """Variance of the detail at levels 1 to 3, DN squared."""
    levels = detail_components(plane[np.newaxis].astype(np.float32), "coif3", 3)
    return tuple(float((level[:, 0].astype(np.float64) ** 2).sum()) / plane.size for level in levels)


def just_seen(plane: np.ndarray, magnification: float, levels: int) -> float:
    """What has to be kept at all levels for one just noticeable difference."""
    variance, grey = detail_of(plane), float(plane.mean())

    def beyond(kept: float) -> float:
        seen = visibility([kept] * levels, variance[:levels], grey, WHITE, magnification)
        return seen - 1

    return float(brentq(beyond, 1e-9, 1))


@pytest.fixture(scope="module")
def brighton(data_folder: Path) -> list[np.ndarray]:
    windows = list(windows_of(data_folder / "seams" / "brighton", "DJI_*.tif"))
    assert len(windows) > 20
    return windows


@pytest.mark.release
def test_at_2x_one_difference_is_kept_0_62_at_the_finest_level(brighton: list[np.ndarray]) -> None:
    kept = [just_seen(plane, 2, 1) for plane in brighton]
    assert np.median(kept) == pytest.approx(0.62, abs=0.015)
    assert (min(kept), max(kept)) == pytest.approx((0.50, 0.68), abs=0.03)


@pytest.mark.release
@pytest.mark.parametrize(("magnification", "kept"), [(1, 0.67), (2, 0.68), (4, 0.64)])
def test_pooled_over_levels_it_is_near_the_standard_limit(
    brighton: list[np.ndarray], magnification: int, kept: float
) -> None:
    median_kept = float(np.median([just_seen(plane, magnification, 3) for plane in brighton]))
    assert median_kept == pytest.approx(kept, abs=0.02)
    assert median_kept == pytest.approx(MAX_SIGNIFICANT_KEPT, abs=0.07)


@pytest.mark.release
def test_averages_of_strangers_are_seen(brighton: list[np.ndarray]) -> None:
    """Windows of other ground, so that nothing but the coarser levels has anything in common."""
    seen = []
    for plane, other in zip(brighton, brighton[len(brighton) // 2 :]):
        variance, left = detail_of(plane), detail_of((plane - plane.mean() + other - other.mean()) / 2)
        mean = [(a + b) / 2 for a, b in zip(variance, detail_of(other))]
        kept = [of / whole for of, whole in zip(left, mean)]
        assert kept[0] == pytest.approx(0.5, abs=0.05)
        seen.append(visibility(kept, mean, float(plane.mean()), WHITE))
    assert 1.4 <= np.median(seen) <= 1.8
