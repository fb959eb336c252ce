"""A plane through a small kernel is what scipy makes of it, and products are numpy's, whoever works them out."""
from __future__ import annotations

import os
import subprocess
import sys
from ctypes.util import find_library

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.imagery import wavelets
from seam_inspector.plugin.imagery.wavelets import correlated


@pytest.mark.parametrize("shape", [(512, 512), (64, 72), (101, 67), (3, 5), (130, 2)])
@pytest.mark.parametrize("taps", [(5, 5), (3, 7), (1, 1), (7, 1)])
def test_a_plane_is_correlated_as_by_scipy(shape: tuple[int, int], taps: tuple[int, int]) -> None:
    rng = np.random.default_rng(2)
    plane = (100 + 30 * rng.standard_normal(shape)).astype(np.float32)
    kernel = rng.standard_normal(taps).astype(np.float32)
    before = plane.copy()
    result = correlated(plane, kernel)
    assert result.dtype == np.float32
    np.testing.assert_allclose(result, ndimage.correlate(plane, kernel, mode="nearest"), atol=2e-3)
    np.testing.assert_array_equal(plane, before)


@pytest.fixture
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(wavelets, "numpy_has_plain_products", lambda: True)


@pytest.mark.usefixtures("plain")
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("many", [(), (3,), (2, 4)])
def test_products_are_those_of_numpy(dtype: type, many: tuple[int, ...]) -> None:
    rng = np.random.default_rng(1)
    first, second = rng.random((7, 5)).astype(dtype), rng.random((*many, 5, 18)).astype(dtype)[..., ::2]
    out = np.full((*many, 7, 18), -1, dtype)
    wavelets.multiply(first, second, out[..., 1::2])
    np.testing.assert_allclose(out[..., 1::2], first @ second, rtol=1e-5)
    assert (out[..., ::2] == -1).all()
    matrix = rng.random((6, 4)).astype(dtype)
    np.testing.assert_allclose(wavelets.product(matrix.T, matrix), matrix.T @ matrix, rtol=1e-5)


@pytest.mark.usefixtures("plain")
def test_kernels_and_wavelets_are_the_same_by_other_products(monkeypatch: pytest.MonkeyPatch) -> None:
    plane = np.random.default_rng(2).normal(120, 30, (150, 203)).astype(np.float32)
    taps = np.random.default_rng(3).random((5, 5)).astype(np.float32)

    def made() -> list[np.ndarray]:
        pair = wavelets.filter_taps("coif3")
        return [wavelets.correlated(plane, taps), *wavelets.decomposed(plane[np.newaxis], [100.0], pair, np.float32)[0]]

    by_scipy = made()
    monkeypatch.setattr(wavelets, "numpy_has_plain_products", lambda: False)
    for expected, other in zip(by_scipy, made()):
        np.testing.assert_allclose(expected, other, rtol=1e-5, atol=2e-3)


GSL = find_library("gslcblas")


@pytest.mark.slow
@pytest.mark.skipif(not (GSL and sys.platform.startswith("linux")), reason="no CBLAS of GSL on this machine")
def test_a_process_that_was_started_with_the_library_of_gsl_is_told() -> None:
    code = f"import {wavelets.__name__} as made; print(made.numpy_has_plain_products())"
    for preloaded, preloads in (("", "False"), (str(GSL), "True")):
        made = subprocess.run(
            [sys.executable, "-c", code], env={**os.environ, "LD_PRELOAD": preloaded}, capture_output=True, text=True,
            check=True,
        )
        assert made.stdout.strip() == preloads
