"""The picture of losses: what its pixels say, and the file."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.seams.measure.blocks.block_grid import BLOCK_PX, CELLS_PX
from seam_inspector.plugin.seams.measure.profile.cell_table import CELL_PX
from seam_inspector.plugin.seams.measure.profile.ground import grounds
from seam_inspector.plugin.seams.measure.scan.loss_raster import BANDS, NODATA, loss_cells, loss_raster

from tests.numbers.seams.profile.blends import SIDE, blend, spread
from tests.numbers.seams.scan.results.one_window import scan_of_window
from tests.numbers.synthetic import GeoTransform, write_raster

COUNT = SIDE // CELL_PX
KEPT, CONTRAST, ADDED, SOURCE, MIXTURE = range(len(BANDS))


def pixels_of(width: int, cell_px: int) -> np.ndarray:
    made = blend(width)
    scan = scan_of_window(made.detail(), made.labels)
    labels = np.where(scan.labels < 2, scan.labels.astype(int) + 1, 0)
    return loss_cells(scan, labels, grounds(scan.cells), cell_px)


@pytest.mark.parametrize("width", [0, 33, 100])
def test_the_finest_pixels_keep_what_the_cells_of_a_window_keep(width: int) -> None:
    """Energy over that which ground of the same energy has."""
    table = blend(width).detail().cells
    (finest, *_) = grounds(table)
    mm, cc = (spread(table, sums[0], COUNT).sum(axis=0) for sums in (table.mm, table.cc))
    expected = mm / (cc * finest.amplitude(cc / CELL_PX**2))
    pixels = pixels_of(width, CELL_PX)[KEPT]
    assert pixels.shape == (BLOCK_PX // CELL_PX, BLOCK_PX // CELL_PX)
    assert pixels[:COUNT, :COUNT] == pytest.approx(expected, rel=0.01, abs=0.003)
    assert (pixels[COUNT:] == NODATA).all()
    assert (pixels[:, COUNT:] == NODATA).all()


GEOTRANSFORM: GeoTransform = (400000.0, 0.25, 0.0, 5500000.0, 0.0, -0.25)


@pytest.fixture(scope="module")
def mosaic(tmp_path_factory: pytest.TempPathFactory) -> Raster:
    """Three blocks by two, of which the last ones are small."""
    path = tmp_path_factory.mktemp("mosaic") / "mosaic.tif"
    pixels = np.zeros((2 * BLOCK_PX - 1000, 2 * BLOCK_PX + 96), np.uint8)
    options = ["TILED=YES", "COMPRESS=DEFLATE", "SPARSE_OK=TRUE"]
    return describe_mosaic(RasterRef(write_raster(path, pixels, geotransform=GEOTRANSFORM, options=options)))


def written(path: Path, mosaic: Raster, cell_px: int = 32) -> np.ndarray:
    """What went in."""
    side = BLOCK_PX // cell_px
    rows, columns = -(-mosaic.rows // cell_px), -(-mosaic.columns // cell_px)
    everything = np.random.default_rng(1).random((len(BANDS), 2 * side, 3 * side), np.float32)
    everything[SOURCE] = np.ceil(3 * everything[SOURCE])
    everything[:, 5:20, 3:30] = NODATA
    with loss_raster(str(path), mosaic, cell_px) as raster:
        for row in range(2):
            for column in range(3):
                block = np.s_[:, row * side : (row + 1) * side, column * side : (column + 1) * side]
                raster.write(row, column, everything[block])
        raster.close(["one.tif", "zwei ö.tif", "three.tif"], {})
    return everything[:, :rows, :columns]


def test_every_block_is_where_it_belongs(tmp_path: Path, mosaic: Raster) -> None:
    expected = written(tmp_path / "loss.tif", mosaic)
    dataset = gdal.Open(str(tmp_path / "loss.tif"))
    np.testing.assert_array_equal(dataset.ReadAsArray(), expected)
    assert dataset.GetGeoTransform() == (400000.0, 8.0, 0.0, 5500000.0, 0.0, -8.0)
    of_mosaic = gdal.Open(mosaic.ref.path)
    assert dataset.GetSpatialRef().IsSame(of_mosaic.GetSpatialRef())


def test_bands_have_names_nodata_statistics_and_sources_their_names(tmp_path: Path, mosaic: Raster) -> None:
    expected = written(tmp_path / "loss.tif", mosaic)
    dataset = gdal.Open(str(tmp_path / "loss.tif"))
    names = [dataset.GetRasterBand(number + 1).GetDescription() for number in range(dataset.RasterCount)]
    assert names == ["kept_1", "contrast_1", "added_1", "source", "mixture"]
    for number, values in enumerate(expected, 1):
        band = dataset.GetRasterBand(number)
        assert band.GetNoDataValue() == NODATA
        low, high, mean, _ = band.GetStatistics(False, False)
        known = values[values != NODATA]
        assert (low, high, mean) == pytest.approx((known.min(), known.max(), known.mean()), rel=1e-4)
    assert dataset.GetRasterBand(SOURCE + 1).GetCategoryNames() == ["", "one.tif", "zwei ö.tif", "three.tif"]


def test_overviews_are_means_but_for_the_numbers_of_sources(tmp_path: Path, mosaic: Raster) -> None:
    expected = written(tmp_path / "loss.tif", mosaic, 16)
    dataset = gdal.Open(str(tmp_path / "loss.tif"))
    assert max(dataset.RasterXSize, dataset.RasterYSize) > 256
    kept, source = (dataset.GetRasterBand(number + 1) for number in (KEPT, SOURCE))
    assert kept.GetOverviewCount() == source.GetOverviewCount() == 1
    overview = kept.GetOverview(0).ReadAsArray()
    even = np.s_[40:80, 40:80]  # where nothing lacks
    wanted = expected[KEPT].astype(float)[80:160, 80:160].reshape(40, 2, 40, 2).mean(axis=(1, 3))
    assert overview[even] == pytest.approx(wanted, abs=1e-5)
    assert set(np.unique(source.GetOverview(0).ReadAsArray())) <= {NODATA, 1, 2, 3}


def test_what_is_not_measured_takes_no_room(tmp_path: Path, mosaic: Raster) -> None:
    huge = replace(mosaic, columns=10**5, rows=10**5)
    cells = np.full((len(BANDS), 64, 64), NODATA, np.float32)
    with loss_raster(str(tmp_path / "loss.tif"), huge, 32) as raster:
        raster.write(20, 30, cells)
        cells[:, 10:50, 20:] = 2
        raster.write(30, 40, cells)
        raster.close([], {})
    dataset = gdal.Open(str(tmp_path / "loss.tif"))
    assert dataset.RasterXSize == dataset.RasterYSize == 3125
    assert (tmp_path / "loss.tif").stat().st_size < 200_000
    assert (dataset.ReadAsArray(2000, 2000, 9, 9) == NODATA).all()
    band = dataset.GetRasterBand(SOURCE + 1)
    assert band.GetStatistics(False, False) == [2, 2, 2, 0]
    assert band.GetOverviewCount() == 4
    for level in range(4):
        overview, factor = band.GetOverview(level), 2 ** (level + 1)
        assert overview.XSize == overview.YSize == -(-3125 // factor)
        pixels = overview.ReadAsArray()
        assert pixels[(30 * 64 + 20) // factor, (40 * 64 + 40) // factor] == 2
        assert np.count_nonzero(pixels != NODATA) <= (40 // factor + 2) * (44 // factor + 2)


@pytest.mark.parametrize("cell_px", CELLS_PX)
def test_larger_pixels_are_sums_of_cells(cell_px: int) -> None:
    made = blend(33)
    cells = made.detail().cells
    side = SIDE // cell_px

    def summed(name: str) -> np.ndarray:
        each = spread(cells, getattr(cells, name)[0], COUNT).sum(axis=0)
        return each.reshape(side, cell_px // CELL_PX, side, -1).sum(axis=(1, 3))

    pixels = pixels_of(33, cell_px)[:, :side, :side]
    mm, cc, mc = map(summed, ("mm", "cc", "mc"))
    assert pixels[CONTRAST] == pytest.approx(np.sqrt(mm / cc), rel=1e-4)
    assert pixels[ADDED] == pytest.approx(np.maximum(1 - mc**2 / (mm * cc), 0), abs=1e-4)
    mixture = np.linspace(0, 1, COUNT**2).reshape(side, cell_px // CELL_PX, side, -1).mean(axis=(1, 3))
    assert pixels[MIXTURE] == pytest.approx(mixture, abs=1e-5)
