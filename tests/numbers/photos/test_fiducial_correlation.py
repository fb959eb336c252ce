"""Templates, correlation and surface against scikit-image, numpy and themselves."""
from __future__ import annotations

import math
from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.errors import PhotoError
from seam_inspector.plugin.photos.measure import limits
from seam_inspector.plugin.photos.measure.correlation import (
    CorrelatedImage,
    SurfaceError,
    correlate,
    fit_surface,
    surface_extremum,
)
from seam_inspector.plugin.photos.measure.mark_templates import MarkShape, cut_out, draw
from seam_inspector.plugin.photos.measure.measuring_marks import MeasuringTemplate, measure_mark
from seam_inspector.plugin.photos.measure.photo import PhotoView
from skimage.feature import match_template

from tests.numbers.synthetic import texture


@pytest.mark.parametrize(("shape", "size"), [((60, 71), (9, 12)), ((33, 40), (33, 7)), ((50, 50), (5, 5))])
def test_correlation_is_scikit_images(shape: tuple[int, int], size: tuple[int, int]) -> None:
    image = 100 + 30 * texture(shape, 1.5, 1)
    template = image[3 : 3 + size[0], 5 : 5 + size[1]][: size[0], : size[1]] if size[0] < shape[0] else image[:, 5:12]
    expected = match_template(image, template)
    assert np.allclose(correlate(image, template), expected, atol=1e-9)
    assert np.allclose(CorrelatedImage(image, np.float32).correlate(template), expected, atol=1e-3)


coefficients = st.tuples(*[st.floats(-1, 1)] * 3, *[st.floats(0.05, 2)] * 2, st.floats(-0.9, 0.9), st.booleans())


@given(coefficients, st.sampled_from([1, 2, 3]))
def test_a_surface_of_the_second_degree_is_found_again(values: tuple[float, ...], reach: int) -> None:
    a0, a1, a2, a3, a5, mix, up = values
    a4 = 2 * mix * math.sqrt(a3 * a5)  # an extremum for any mix between -1 and 1
    given_terms = np.array([a0, a1, a2, a3, a4, a5]) * (1 if up else -1)
    y, x = np.mgrid[-reach : reach + 1, -reach : reach + 1]
    field = sum(c * t for c, t in zip(given_terms, (np.ones(x.shape), x, y, x * x, x * y, y * y)))
    made = fit_surface(field)
    assert made == pytest.approx(given_terms, abs=1e-9)
    expected = np.linalg.solve([[2 * a3, a4], [a4, 2 * a5]], [-a1, -a2])
    if np.abs(expected).max() > reach:
        with pytest.raises(SurfaceError, match="outside"):
            surface_extremum(made, reach)
    else:
        x0, y0, is_maximum = surface_extremum(made, reach)
        assert (x0, y0) == pytest.approx(expected, abs=1e-6)
        assert is_maximum is not up


def window(pixels: np.ndarray) -> PhotoView:
    return PhotoView(pixels, 100, 200)


@pytest.mark.parametrize(("surface", "offset"), list(
    product(limits.SURFACES, ((0.0, 0.0), (0.31, -0.44), (-0.5, 0.2)))
))
def test_a_mark_is_measured_where_it_is(surface: str, offset: tuple[float, float]) -> None:
    shape = MarkShape(limits.RING_WITH_DOT, 20, softness=1.0)
    pixels = 30 + 50 * draw(shape, offset, margin=40) + 0.2 * np.arange(81)
    mark = measure_mark(window(pixels), (140.5, 240.5), 5, MeasuringTemplate(shape, 1), 0.5, surface)
    tolerance = 0.01 if surface == limits.CORRELATION else 0.2
    assert mark.place == pytest.approx((140.5 + offset[0], 240.5 + offset[1]), abs=tolerance)


def test_two_alike_or_none_or_half_a_mark_is_a_failure() -> None:
    shape = MarkShape(limits.RING_WITH_CROSS, 20, softness=0.8)
    template, drawn = MeasuringTemplate(shape, 1), draw(shape, margin=50)
    two = drawn + np.roll(drawn, 30, axis=1)
    noise = 0.05 * texture(drawn.shape, 0, 1)
    halved = drawn.copy()
    halved[:, 51:] = np.roll(drawn, 4, axis=0)[:, 51:]  # a torn film

    def reason(pixels: np.ndarray) -> str:
        made = measure_mark(window(pixels), (150.5, 250.5), 8, template, 0.5, limits.CORRELATION)
        assert made.place is None, made
        return str(made.reason)

    assert "two places look nearly alike" in reason(two + noise)
    assert "correlation is" in reason(noise)
    assert "differ by" in reason(halved + noise)
    small = measure_mark(window(drawn[:9, :9]), (104.5, 204.5), 2, template, 0.5, limits.CORRELATION)
    assert small.place is None
    assert "larger than" in str(small.reason)


def test_a_cut_out_has_the_centre_of_its_symmetry() -> None:
    mark = draw(MarkShape(limits.CROSS, 20, softness=1.0), (0.25, -0.3), margin=30)
    made = cut_out(mark[8:55, 12:58])
    assert made.centre == pytest.approx((30.75 - 12, 30.2 - 8), abs=0.03)
    plain = cut_out(texture((20, 30), 1.5, 3))
    assert plain.centre == (15, 10)
    with pytest.raises(PhotoError, match="needs at least"):
        cut_out(mark[:4, :20])
    with pytest.raises(PhotoError, match="alike"):
        cut_out(np.zeros((20, 20)))


def test_a_flat_image_and_a_template_without_room_correlate_with_nothing() -> None:
    template = texture((9, 9), 1.5, 2)
    assert not correlate(np.full((30, 30), 7.0), template).any()
    assert not correlate(texture((30, 30)), np.ones((5, 5))).any()
    assert correlate(np.zeros((5, 5)), template).size == 0
