"""The ground around a small window: where it lies, that it is read, and that it changes nothing but what it is for."""
from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict
from seam_inspector.plugin.seams.measure.window.inspection import inspect_window
from seam_inspector.plugin.seams.measure.window.measured_window import (
    ENOUGH_PX,
    MARGIN_PX,
    InspectionSettings,
    WindowRequest,
    place_in,
    surroundings,
)

from tests.numbers.seams.inspecting import MakeRaster, block_of, mosaic_of
from tests.numbers.synthetic import decompose, luminance, orthoimage

SIZE = (448, 480)
WINDOW = PixelWindow(176, 160, 128, 128)


@pytest.fixture(scope="module")
def images() -> tuple[np.ndarray, np.ndarray]:
    return orthoimage(SIZE, seed=1), orthoimage(SIZE, seed=2)


def blended(images: tuple[np.ndarray, np.ndarray], width: float) -> np.ndarray:
    """Along the middle of the window."""
    place = np.arange(SIZE[1]) + 0.5 - (WINDOW.column + WINDOW.width / 2)
    weight = (place > 0).astype(float) if not width else np.clip(place / width + 0.5, 0, 1)
    return np.rint((1 - weight) * images[0] + weight * images[1]).astype(np.uint8)


def request_of(make_raster: MakeRaster, images: tuple[np.ndarray, np.ndarray], width: float,
               window: PixelWindow = WINDOW, **of_sources: object) -> WindowRequest:
    mosaic = mosaic_of(make_raster, blended(images, width))
    paths = [make_raster(f"{number}.tif", image, **of_sources) for number, image in enumerate(images)]
    block = block_of(mosaic, *paths)
    return WindowRequest(1, mosaic, block.sources, window, InspectionSettings())


@pytest.mark.parametrize(("width", "verdict"), [(0, Verdict.PRESERVED), (33, Verdict.SIGNIFICANT)])
def test_a_window_of_128_px_is_measured_and_its_curves_are_its_own(
    make_raster: MakeRaster, images: tuple[np.ndarray, np.ndarray], width: int, verdict: Verdict
) -> None:
    """Curves as PyWavelets has them of exactly its pixels, whatever lies around."""
    request = request_of(make_raster, images, width)
    assert request.around == PixelWindow(48, 32, 384, 384)
    result = inspect_window(request)
    assert result.judgement.verdict is verdict
    assert result.profile.by_energy is not None
    inner = np.s_[:, 160:288, 176:304]
    for clip, pixels in zip(result.clips, (blended(images, width), *images)):
        for band, plane in zip(("red", "green", "blue"), pixels[inner]):
            curve = clip.curves[band]
            np.testing.assert_allclose((*curve.detail, curve.background), decompose(plane).shares, rtol=1e-4)
    first = decompose(luminance(blended(images, width)[inner])).shares[0]
    ratios = [first / decompose(luminance(image[inner])).shares[0] for image in images]
    assert result.judgement.ratios.detail[0] == pytest.approx(max(ratios), rel=1e-4)


def test_a_window_keeps_what_a_larger_one_keeps_there(
    make_raster: MakeRaster, images: tuple[np.ndarray, np.ndarray]
) -> None:
    """That is what the ground around is for."""
    small, large = (
        inspect_window(request_of(make_raster, images, 66, window)).profile
        for window in (WINDOW, PixelWindow(48, 32, 384, 384))
    )
    assert small.low <= large.high
    assert large.low <= small.high
    assert small.kept[0] == pytest.approx(large.kept[0], abs=0.06)


def test_a_source_that_ends_beside_the_window_takes_part_as_far_as_it_goes(
    make_raster: MakeRaster, images: tuple[np.ndarray, np.ndarray]
) -> None:
    first, second = (image.copy() for image in images)
    mosaic = mosaic_of(make_raster, blended(images, 33))
    first[:, :, WINDOW.column + WINDOW.width + 20 :] = 0
    second[:, : WINDOW.row - 40] = 0
    paths = [make_raster(f"{number}.tif", pixels, nodata=0) for number, pixels in enumerate((first, second))]
    block = block_of(mosaic, *paths)
    result = inspect_window(WindowRequest(1, mosaic, block.sources, WINDOW, InspectionSettings()))
    assert len(result.clips) == 3  # the window itself is covered by both
    whole = inspect_window(request_of(make_raster, images, 33)).profile
    assert result.profile.kept[0] == pytest.approx(whole.kept[0], abs=0.06)
    assert not result.notices


def test_a_mosaic_without_pixels_around_the_window_is_measured_all_the_same(
    make_raster: MakeRaster, images: tuple[np.ndarray, np.ndarray]
) -> None:
    image = blended(images, 33)
    image[:, :, : WINDOW.column - 8] = 0
    mosaic = mosaic_of(make_raster, image, nodata=0)
    block = block_of(mosaic, *(make_raster(f"{number}.tif", image) for number, image in enumerate(images)))
    result = inspect_window(WindowRequest(1, mosaic, block.sources, WINDOW, InspectionSettings()))
    assert result.judgement.verdict is Verdict.SIGNIFICANT
    inner = np.s_[:, 160:288, 176:304]
    (shown, *_) = result.clips
    np.testing.assert_allclose(shown.curves["red"].detail, decompose(image[inner][0]).shares[:-1], rtol=1e-4)


@given(
    column=st.integers(0, 900), row=st.integers(0, 900), width=st.integers(8, 100), height=st.integers(8, 100),
    right=st.integers(0, 900), below=st.integers(0, 900), levels=st.integers(1, 6),
)
def test_it_lies_inside_the_mosaic_around_the_window_in_whole_steps(
    column: int, row: int, width: int, height: int, right: int, below: int, levels: int
) -> None:
    step = max(16, 2**levels)
    window = PixelWindow(column, row, width * 8, height * 8)
    columns, rows = column + window.width + right, row + window.height + below
    mosaic = Raster(RasterRef("mosaic.tif"), columns, rows, (0.0, 0.1, 0.0, 0.0, 0.0, -0.1), "", ("red",), "uint8")
    around = surroundings(window, mosaic, levels)
    assert around.column >= 0
    assert around.row >= 0
    assert around.column + around.width <= columns
    assert around.row + around.height <= rows
    inside = place_in(window, around)
    assert (inside[0].stop - inside[0].start, inside[1].stop - inside[1].start) == (window.height, window.width)
    down, across = (row, below), (column, right)
    for place, length, side, room in (
        (inside[0], around.height, window.height, down), (inside[1], around.width, window.width, across)
    ):
        wanted = min(MARGIN_PX, max(ENOUGH_PX - side, 0) // 2)
        for margin, there in zip((place.start, length - place.stop), room):
            assert margin % step == 0
            assert margin == min(wanted, there) // step * step
