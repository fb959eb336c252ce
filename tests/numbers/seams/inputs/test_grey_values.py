"""Floating point values are brought to those of 8 bit, by powers of ten alone."""
from __future__ import annotations

import math

import numpy as np
import pytest
from seam_inspector.plugin.seams.measure.compared_image import USUAL_RANGE, factor_of


@pytest.mark.parametrize("widest", [1e-6, 1.0, 1.4, 3e5, 1e12])
def test_values_of_any_scale_come_to_those_of_8_bit(widest: float) -> None:
    values = np.random.default_rng(1).uniform(0, widest, 5000)
    factor = factor_of(values)
    assert 255 / 10 <= np.ptp(values * factor) / 1.5 <= 255 * 1.05
    assert math.log10(factor / 255) == pytest.approx(round(math.log10(factor / 255)), abs=1e-9)


@pytest.mark.parametrize("values", [
    np.full(50, 0.3), np.zeros(0), np.arange(256, dtype=np.uint8), np.linspace(0, USUAL_RANGE[0] * 1.1, 500),
    np.linspace(0, USUAL_RANGE[1] * 0.9, 500),
])  # fmt: skip
def test_what_is_usual_whole_or_all_alike_stays_as_it_is(values: np.ndarray) -> None:
    assert factor_of(values) == 1
