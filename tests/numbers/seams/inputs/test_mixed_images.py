"""Orthoimages into which a supplier mixed the mosaic along its bad seams."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector import ScanSettings, open_block, scan
from seam_inspector.plugin.imagery.open_raster import describe
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.inputs.mixed_images import mixed_images
from seam_inspector.plugin.seams.measure.seamlines.seam_pieces import SeamPiece

from tests.numbers.synthetic import write_raster

PIXEL, LEFT, TOP = 0.1, 500000.0, 5500000.0
ROWS, COLUMNS = 384, 1100
LENGTH = 25.0  # of a piece; four of them, along the middle row


def exposures(alike: float) -> list[np.ndarray]:
    """Two images of one ground, whose finest detail correlates by ``alike``."""
    random = np.random.default_rng(1)
    shared, *others = (random.normal(0, 20, (ROWS, COLUMNS)) for _ in range(3))
    coarse = ndimage.gaussian_filter(random.normal(0, 300, (ROWS, COLUMNS)), 6)
    return [128 + coarse + alike**0.5 * shared + (1 - alike) ** 0.5 * other for other in others]


def mixed_into(
    images: list[np.ndarray], share: float, feather_px: int, band_px: float, length_px: int = COLUMNS
) -> list[np.ndarray]:
    """The images with so much of their mosaic within a band along its seam, or the first pixels of that."""
    from_seam = np.arange(ROWS)[:, np.newaxis] + 0.5 - ROWS / 2
    below = np.clip(from_seam / max(feather_px, 0.01) + 0.5, 0, 1)
    mosaic = (1 - below) * images[0] + below * images[1]
    is_mixed = (abs(from_seam) < band_px) & (np.arange(COLUMNS) < length_px)
    return [np.where(is_mixed, (1 - share) * image + share * mosaic, image) for image in images]


def told_of(folder: Path, images: list[np.ndarray]) -> tuple[str, dict[str, str]]:
    """What is told of four pieces along the middle; the first image lies above them, on the left."""
    paths = [str(folder / f"{name}.tif") for name in ("upper", "lower")]
    for path, image in zip(paths, images):
        write_raster(path, image.clip(1, 255).round().astype(np.uint8)[np.newaxis], PIXEL, (LEFT, TOP))
    x, y = LEFT + 5, TOP - ROWS * PIXEL / 2
    pieces = [
        SeamPiece(1, station, LENGTH, np.array([(x + station, y), (x + station + LENGTH, y)]), 0, 1)
        for station in (0.0, 25.0, 50.0, 75.0)
    ]
    sources = {Path(path).name: RasterRef(path) for path in paths}
    notices, notes = mixed_images(describe(RasterRef(paths[0])), sources, [(*sources, piece) for piece in pieces])
    assert bool(notices) is bool(notes)
    return " ".join(map(str, notices)), notes


@pytest.mark.parametrize("alike", [0.0, 0.5, 0.95])
def test_honest_orthoimages_hold_no_mosaic(tmp_path: Path, alike: float) -> None:
    """Also where one of them is softer, or has less contrast, all over."""
    first, second = exposures(alike)
    for other in (second, ndimage.gaussian_filter(second, 0.5), 40 + 0.6 * second):
        assert not told_of(tmp_path, [first, other])[1]


@pytest.mark.parametrize(("share", "feather_px", "band_px"), [
    (0.3, 0, 50), (0.4, 12, 50), (0.5, 50, 100), (0.6, 100, 150), (0.75, 100, 150), (0.95, 30, 60),
])  # fmt: skip
@pytest.mark.parametrize("alike", [0.0, 0.5])
def test_the_mosaic_in_orthoimages_is_told_with_its_share(
    tmp_path: Path, alike: float, share: float, feather_px: int, band_px: float
) -> None:
    words, notes = told_of(tmp_path, mixed_into(exposures(alike), share, feather_px, band_px))
    assert notes == {"mixed_sources": "lower.tif, upper.tif", "mixed_metres": "100.0", "mixed_at": notes["mixed_at"]}
    percent = float(words.partition("up to ")[2].partition(" %")[0])
    assert 60 * share < percent < 100 * share + 5


@pytest.mark.parametrize("band_px", [26, 60])
def test_orthoimages_that_are_the_mosaic_along_a_seam_hold_all_of_it(tmp_path: Path, band_px: int) -> None:
    words, _ = told_of(tmp_path, mixed_into(exposures(0.5), 1.0, 30, band_px))
    assert "up to 100 % of the mosaic" in words


@pytest.mark.parametrize(("share", "both", "percent"), [(0.5, True, 50), (1.0, False, 100)])
def test_a_place_of_forty_metres_along_a_seam_of_a_hundred_is_enough(
    tmp_path: Path, share: float, both: bool, percent: float
) -> None:
    """Also in one of the two alone."""
    first, second = exposures(0.3)
    mixed = mixed_into([first, second], share, 33, 40, 450)
    words, notes = told_of(tmp_path, mixed if both else [first, mixed[1]])
    assert notes["mixed_sources"] == "lower.tif, upper.tif"
    assert float(words.partition("up to ")[2].partition(" %")[0]) == pytest.approx(percent, rel=0.4)


def test_a_scan_tells_of_orthoimages_that_hold_the_mosaic(tmp_path: Path) -> None:
    """A feather that lost 30 % seems to have lost nothing."""
    images = exposures(0.3)
    from_seam = np.arange(ROWS)[:, np.newaxis] + 0.5 - ROWS / 2
    below = np.clip(from_seam / 40 + 0.5, 0, 1)
    planes = {
        "mosaic": (1 - below) * images[0] + below * images[1],
        **dict(zip(("upper", "lower"), mixed_into(images, 0.6, 40, 80))),
    }
    paths = [str(tmp_path / f"{name}.tif") for name in planes]
    for path, plane in zip(paths, planes.values()):
        write_raster(path, plane.clip(1, 255).round().astype(np.uint8)[np.newaxis], PIXEL, (LEFT, TOP))
    result = scan(open_block(paths[0], paths[1:]), ScanSettings(piece_m=LENGTH))
    assert result.told["mixed_sources"] == "lower.tif, upper.tif"
    assert float(result.told["mixed_metres"]) == pytest.approx(110, abs=5)
    assert any("mixed into the orthoimages (lower.tif, upper.tif)" in str(notice) for notice in result.notices)
