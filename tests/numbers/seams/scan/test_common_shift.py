"""A mosaic that lies beside all its orthoimages is told so, not that orthoimages are missing."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector import ScanResult, open_block, scan

from tests.numbers.synthetic import orthoimage, write_raster

SIDE = 768
BESIDE, LACK = "does not lie where its orthoimages do", "match none of the orthoimages"


@pytest.fixture
def files(tmp_path: Path) -> Path:
    """A mosaic cut hard out of two of three images of one scene: the second has a texture of its own besides."""
    first, other = (orthoimage((SIDE, SIDE), 1, seed).astype(float) for seed in (1, 2))
    second = np.clip(0.35 * first + 0.65 * other, 0, 255)
    mosaic = np.where(np.arange(SIDE)[:, np.newaxis] < SIDE / 2, first, second)
    third = np.clip(0.5 * first + 0.5 * second, 0, 255)
    for name, pixels in (("mosaic", mosaic), ("first", first), ("second", second), ("third", third)):
        write_raster(tmp_path / f"{name}.tif", pixels.astype(np.uint8))
    return tmp_path


def moved(path: Path, columns: int, rows: int) -> None:
    """The georeference alone, by pixels."""
    dataset = gdal.Open(str(path), gdal.GA_Update)
    left, width, _, top, _, height = dataset.GetGeoTransform()
    dataset.SetGeoTransform((left + columns * width, width, 0, top + rows * height, 0, height))


def scanned(folder: Path, *names: str) -> tuple[ScanResult, str]:
    result = scan(open_block(folder / "mosaic.tif", [folder / f"{name}.tif" for name in names]))
    return result, " ".join(map(str, result.notices))


def test_the_shift_is_told_in_metres(files: Path) -> None:
    moved(files / "mosaic.tif", 15, -20)
    result, words = scanned(files, "first", "second", "third")
    east, north = map(float, result.told["mosaic_shift"].split())
    assert (east, north) == pytest.approx((1.5, 2.0), abs=0.03)
    assert BESIDE in words
    assert LACK not in words


def test_an_orthoimage_that_lacks_is_no_shift(files: Path) -> None:
    """The other one shows the scene where the mosaic has it."""
    result, words = scanned(files, "first")
    assert float(result.told["unexplained"]) > 0.1
    assert "mosaic_shift" not in result.told
    assert BESIDE not in words
    assert LACK in words
