"""What the benchmark of mosaicking programs takes for true: weights read from grey images, or fitted to a mosaic."""
from __future__ import annotations

import pytest

from benchmarks.known_windows import KnownWindow
from benchmarks.program_makings import MODES, Mode
from benchmarks.programs import OVERLAP_PX, Mixture, against_ground, fitted, made_by, overlap_of, probed
from benchmarks.seam_makings import mixed, signed_distance
from tests.numbers.seams.made_up_window import made_up_window

SIDE = 256


@pytest.fixture(scope="module")
def window() -> KnownWindow:
    return made_up_window(SIDE)


def mode_of(name: str) -> Mode:
    return next(mode for mode in MODES if mode.name == name)


def truth(window: KnownWindow, mixture: Mixture) -> float:
    return against_ground(mixed(overlap_of(window).images, mixture.weights, mixture.labels), window)


def test_the_last_image_on_top_is_cut_where_it_ends(window: KnownWindow) -> None:
    overlap = overlap_of(window)
    mixture = probed(mode_of("GDAL, gdalbuildvrt"), overlap)
    assert (mixture.labels == overlap.inside[1]).all()
    assert (mixture.labels != overlap.is_second).mean() == pytest.approx(OVERLAP_PX / 2 / SIDE, abs=0.01)
    assert mixture.feather_px == 0
    assert truth(window, mixture) == pytest.approx(1)


def test_a_blend_along_a_line_is_a_feather(window: KnownWindow) -> None:
    overlap = overlap_of(window)
    mixture = probed(mode_of("GDAL, gdalwarp -cutline -cblend 5"), overlap)
    depth, weight = signed_distance(overlap.is_second), mixture.weights[1]
    assert (weight[depth < -6] == 0).all()
    assert (weight[depth > 6] == 1).all()
    assert mixture.feather_px == pytest.approx(10, abs=2)


@pytest.mark.parametrize("name", ["gdalwarp -cutline", "gdalwarp -cutline -cblend 5", "gdalwarp -cutline -cblend 32"])
def test_fitted_weights_tell_what_read_ones_tell(window: KnownWindow, name: str) -> None:
    mode, overlap = mode_of(f"GDAL, {name}"), overlap_of(window)
    by_fit = fitted(overlap, made_by(mode, overlap)[0])
    assert truth(window, by_fit) == pytest.approx(truth(window, probed(mode, overlap)), abs=0.03)
