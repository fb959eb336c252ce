"""Arrays in memory measure as files do, and what is no image is refused with a sentence."""
from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector import (
    ScanSettings,
    SeamInspectorWarning,
    SettingsError,
    clip_curves,
    inspect_arrays,
    inspect_window,
    inspect_windows,
    measure_noise,
    open_block,
    seam_profile,
)

from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import orthoimage

SIDE, PIXEL_M = 384, 0.1


class DataArray:
    """The part of xarray's class that is asked for."""

    def __init__(self, values: np.ndarray, dims: tuple[str, ...] = ("y", "x"), first_x: float = 0.0) -> None:
        self.values, self.dims, self.attrs = values, dims, dict[str, object]()
        self.coords = {"x": first_x + np.arange(values.shape[-1])}

    def transpose(self, *names: object) -> DataArray:
        order = [name for name in names if name in self.dims]
        order += [name for name in self.dims if name not in order]
        return DataArray(self.values.transpose([self.dims.index(str(name)) for name in order]), tuple(map(str, order)))


@pytest.fixture(scope="module")
def images() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Two images, and their mixture over a linear feather of 48 px, (rows, columns, bands)."""
    left, right = (np.moveaxis(orthoimage((SIDE, SIDE), seed=seed), 0, -1) for seed in (1, 2))
    weight = np.clip((np.arange(SIDE) - SIDE / 2) / 48 + 0.5, 0, 1)[:, np.newaxis]
    return left, right, np.rint((1 - weight) * left + weight * right).astype(np.uint8)


def test_arrays_measure_as_their_files_do(images: tuple[np.ndarray, ...], make_raster: MakeRaster) -> None:
    left, right, mosaic = images
    paths = [make_raster(f"{i}.tif", np.moveaxis(pixels, -1, 0)) for i, pixels in enumerate((mosaic, left, right))]
    block = open_block(paths[0], paths[1:])
    expected = inspect_window(block.window(block.mosaic.extent)).profile
    profile = seam_profile(mosaic, [left, right], block.mosaic.ground_sample_distance)
    assert profile.kept == pytest.approx(expected.kept, rel=1e-5)
    assert profile.feather_width_px == pytest.approx(48, rel=0.2)
    assert profile.kept[0] < 0.75


@pytest.mark.parametrize("margin_px", [0, 2, 40])
@pytest.mark.parametrize("feather_px", [1, 24])
def test_orthoimages_that_end_where_the_mosaic_leaves_them_tell_of_it_as_whole_ones(
    images: tuple[np.ndarray, ...], margin_px: int, feather_px: int
) -> None:
    left, right = (image.astype(float) for image in images[:2])
    columns = np.arange(SIDE)
    weight = np.clip((columns - SIDE / 2 + 0.5) / feather_px + 0.5, 0, 1)[:, np.newaxis]
    mosaic = (1 - weight) * left + weight * right
    whole = seam_profile(mosaic, [left, right], PIXEL_M)
    left[:, columns >= SIDE // 2 + margin_px], right[:, columns < SIDE // 2 - margin_px] = np.nan, np.nan
    ended = seam_profile(mosaic, [left, right], PIXEL_M)
    assert ended.kept[0] == pytest.approx(whole.kept[0], abs=0.1)


def test_the_mosaic_and_its_copies_are_left_out_of_the_sources(images: tuple[np.ndarray, ...]) -> None:
    left, right, mosaic = images
    expected = seam_profile(mosaic, [left, right], PIXEL_M)
    for other, words in ((mosaic, "is the mosaic itself"), (mosaic.copy(), "is a copy or an overview of it")):
        with pytest.warns(SeamInspectorWarning, match=words) as warned:
            profile = seam_profile(mosaic, [left, other, right], PIXEL_M)
        assert profile == expected
        assert warned[0].filename == __file__


def test_types_and_masks_change_nothing_that_is_measured(images: tuple[np.ndarray, ...]) -> None:
    left, right, mosaic = images
    expected = seam_profile(mosaic, [left, right], PIXEL_M)
    masked = np.ma.masked_array(mosaic, np.zeros(mosaic.shape, bool))
    masked[:4, :4] = np.ma.masked
    for other in (mosaic.astype(np.int64), mosaic.astype(np.float32), masked):
        profile = seam_profile(other, {"left": left, "right": right}, PIXEL_M)
        assert profile.kept == pytest.approx(expected.kept, rel=0.02)


def test_labels_are_turned_as_images_are_and_masked_ones_are_unknown(images: tuple[np.ndarray, ...]) -> None:
    left, right, mosaic = images
    labels = np.zeros((SIDE, SIDE), int)
    labels[:, SIDE // 2 :] = 1
    turned = DataArray(labels.T, ("x", "y"))
    unknown = np.where(np.arange(SIDE)[:, np.newaxis] < 64, -1, labels)
    masked = np.ma.masked_array(1 - labels * 0, unknown < 0) * labels
    for given, expected in ((turned, labels), (masked, unknown), (labels[..., np.newaxis], labels)):
        profile = seam_profile(mosaic, [left, right], PIXEL_M, given)
        assert profile.kept == seam_profile(mosaic, [left, right], PIXEL_M, expected).kept
    for other in (DataArray(labels, ("lat", "lon")), DataArray(labels, ("lon", "lat"))):
        with pytest.raises(SettingsError, match="rename them to y and x"):
            seam_profile(mosaic, [left, right], PIXEL_M, other)


def test_labels_say_where_the_seam_is(images: tuple[np.ndarray, ...]) -> None:
    left, right, _ = images
    labels = np.zeros((SIDE, SIDE), int)
    labels[:, SIDE // 2 :] = 1
    hard = np.where(labels[..., np.newaxis] == 0, left, right)
    inspected = inspect_arrays(hard, [left, right], PIXEL_M, labels)
    assert inspected.profile.kept[0] == pytest.approx(1, abs=0.05)
    assert not [path for path in gdal.ReadDir("/vsimem/") or () if gdal.ReadDir(f"/vsimem/{path}")]


def test_a_mosaic_with_missing_pixels_says_why_it_is_not_measured(images: tuple[np.ndarray, ...]) -> None:
    left, right, mosaic = images
    holed = np.where(np.arange(SIDE)[:, np.newaxis] < 30, np.nan, mosaic)
    result = inspect_arrays(holed, [left, right], PIXEL_M)
    assert str(result.judgement.reason).startswith("7.81% of the pixels of mosaic are invalid")
    assert seam_profile(holed, [left, right], PIXEL_M) is None


def test_arrays_are_called_as_they_were_given(images: tuple[np.ndarray, ...]) -> None:
    left, right, mosaic = images
    sources, labels = {"flight.1": left, "flight.2": right}, np.indices((SIDE, SIDE))[1] // (SIDE // 2)
    result = inspect_arrays(mosaic, sources, PIXEL_M, labels)
    assert [clip.raster for clip in result.clips] == ["mosaic", *sources]
    assert result.profile.kept == inspect_arrays(mosaic, [left, right], PIXEL_M, labels).profile.kept
    assert result.profile.kept != inspect_arrays(mosaic, sources, PIXEL_M).profile.kept


def test_bands_have_names(images: tuple[np.ndarray, ...]) -> None:
    assert "band_1" in clip_curves(images[0][..., 0])
    assert list(measure_noise(images[0])) == ["luminance", "red", "green", "blue"]
    even, same = (clip_curves(np.full((64, 64), 5.0)) for _ in range(2))
    assert (even, hash(even["band_1"])) == (same, hash(same["band_1"]))


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda image: seam_profile(np.moveaxis(image, -1, 0), [image], PIXEL_M), r"bands first; .*moveaxis"),
        (lambda image: seam_profile(image.astype(complex), [image], PIXEL_M), "array of complex128"),
        (lambda image: seam_profile(image > 3, [image], PIXEL_M), "array of bool"),
        (lambda image: seam_profile(image, [image[:-8]], PIXEL_M), r"source_0 .* \(376, 384\); .*\(384, 384\)"),
        (lambda image: seam_profile(image, [image], PIXEL_M, np.zeros((8, 8), int)), r"labels has the shape \(8, 8\);"),
        (lambda image: seam_profile(image, [image], PIXEL_M, np.ones(image.shape[:2], int)), "source 1, of 1"),
        (lambda image: seam_profile(image, [image], PIXEL_M, np.full(image.shape[:2], -5)), "source -5, of 1"),
        (lambda image: seam_profile(image, [image], PIXEL_M, np.full(image.shape[:2], 0.5)), "not whole numbers"),
        (lambda image: seam_profile(image, [image], PIXEL_M, np.full(image.shape[:2], np.nan)), "not whole numbers"),
        (lambda image: seam_profile(image, [image], PIXEL_M, np.full(image.shape[:2], "0")), "not whole numbers"),
        (lambda image: inspect_arrays(image, None, PIXEL_M), "sources is None"),
        (lambda image: inspect_arrays(image, [255 - image], PIXEL_M, settings=ScanSettings()), "InspectionSettings"),
        (lambda image: inspect_arrays(image, {}, PIXEL_M), "sources is empty"),
        (lambda image: seam_profile(image, [image], 0.0), "pixel_size_m is 0"),
        (lambda image: seam_profile(image, [image], True), "pixel_size_m is True"),
        (lambda image: seam_profile(DataArray(image[0]), [DataArray(image[0], first_x=2)], 1.0), "other coordinates x"),
        (lambda image: clip_curves(image[:, :381]), "381 x 384 pixels; cut both sides to a multiple of 8"),
        (lambda image: clip_curves(np.where(image > 250, np.nan, image.astype(float))), "holds NaN"),
        (lambda image: clip_curves(np.ma.masked_greater(image, 250)), "masked pixels"),
        (lambda image: measure_noise(image, ["red", "red", "blue"]), "red twice"),
        (lambda image: measure_noise(image, ["red"]), "1 names for 3 bands"),
        (lambda image: inspect_windows([(0, 0, 1, 1)]), "give its block"),
    ],
)
def test_what_is_no_image_is_told(
    images: tuple[np.ndarray, ...], call: Callable[[np.ndarray], object], words: str
) -> None:
    with pytest.raises(SettingsError, match=words):
        call(images[0])
