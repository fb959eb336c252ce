"""A plane through a small kernel is what scipy makes of it."""
from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.imagery.filters import correlated


@pytest.mark.parametrize("shape", [(512, 512), (64, 72), (101, 67), (3, 5), (130, 2)])
@pytest.mark.parametrize("taps", [(5, 5), (3, 7), (1, 1), (7, 1)])
def test_a_plane_is_correlated_as_by_scipy(shape: tuple[int, int], taps: tuple[int, int]) -> None:
    rng = np.random.default_rng(2)
    plane = (100 + 30 * rng.standard_normal(shape)).astype(np.float32)
    kernel = rng.standard_normal(taps).astype(np.float32)
    before = plane.copy()
    found = correlated(plane, kernel)
    assert found.dtype == np.float32
    np.testing.assert_allclose(found, ndimage.correlate(plane, kernel, mode="nearest"), atol=2e-3)
    np.testing.assert_array_equal(plane, before)
