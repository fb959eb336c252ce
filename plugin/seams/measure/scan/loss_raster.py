"""The picture of losses: a GeoTIFF of cells, written block row by block row."""
from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager

import numpy as np
from osgeo import gdal

from ....imagery import messages as imagery_messages
from ....imagery.gdal_calls import gdal_writing
from ....imagery.raster_writer import GEOTIFF, whole_raster
from ....imagery.rasters import Raster
from ....imagery.seam_totals import TOTALS_DOMAIN
from ..blocks.block_grid import BLOCK_PX, LABEL_PX
from ..blocks.scan_block import BlockScan
from ..following.boxes import in_squares
from ..profile.cell_table import CELL_PX
from ..profile.ground import LevelGround

BANDS = ("kept_1", "contrast_1", "added_1", "source", "mixture")
NODATA = -1.0  # all that is shown is 0 or more
SOURCE_BAND = BANDS.index("source") + 1  # as GDAL counts


def loss_cells(
    scan: BlockScan, labels: np.ndarray, ground: Sequence[LevelGround | None], cell_px: int
) -> np.ndarray:
    """One block's pixels, (5, rows, columns) float32 of whole blocks, ``NODATA`` where nothing was measured.

    ``labels``: (rows, columns) int of the block, numbers of sources in the band's names, 0 where none is followed.
    """
    side, step = BLOCK_PX // cell_px, cell_px // CELL_PX
    made = empty_cells(side)
    cells = scan.cells.whole
    per_block = BLOCK_PX // CELL_PX
    place = (cells.row % per_block) // step * side + (cells.column % per_block) // step
    mm, cc, mc = (np.bincount(place, values[0], side * side) for values in (cells.mm, cells.cc, cells.mc))
    if (finest := ground[0] if ground else None) is not None:
        expected = np.bincount(place, cells.cc[0] * finest.amplitude(cells.energy(0)), side * side)
        _put(made[0], mm, expected)
    _put(made[1], mm, cc)
    np.sqrt(made[1], out=made[1], where=made[1] >= 0)
    _put(made[2], mc**2, mm * cc)
    np.subtract(1, np.minimum(made[2], 1), out=made[2], where=made[2] >= 0)
    per_cell = cell_px // LABEL_PX
    source = labels[per_cell // 2 :: per_cell, per_cell // 2 :: per_cell]
    anywhere = in_squares(labels, per_cell).max(axis=(1, 3))  # the mosaic may end before the middle
    made[3] = np.where(source > 0, source, np.where(anywhere > 0, anywhere, NODATA))
    parts = in_squares(scan.mixture, step)
    known = ~np.isnan(parts)
    counts = known.sum(axis=(1, 3))
    made[4] = np.where(counts > 0, np.where(known, parts, 0).sum(axis=(1, 3)) / np.maximum(counts, 1), NODATA)
    return made


def empty_cells(side: int) -> np.ndarray:
    """A block of which nothing was measured, (5, side, side) float32."""
    return np.full((len(BANDS), side, side), NODATA, np.float32)


def _put(target: np.ndarray, above: np.ndarray, below: np.ndarray) -> None:
    known = below > 0
    target[known.reshape(target.shape)] = (above[known] / below[known]).astype(np.float32)


class LossRaster:
    """Writes the cells of blocks where they belong. All methods raise RasterError when the disk is full."""

    def __init__(self, dataset: gdal.Dataset, path: str, cell_px: int) -> None:
        self._dataset, self._failure = dataset, imagery_messages.RASTER_NOT_WRITTEN(path=path)
        self._side = BLOCK_PX // cell_px
        self._shown = np.zeros(len(BANDS), bool)  # bands that have something to show

    def write(self, row: int, column: int, cells: np.ndarray) -> None:
        """The cells of one block by its row and column."""
        left, top = column * self._side, row * self._side
        width, height = self._dataset.RasterXSize - left, self._dataset.RasterYSize - top
        cells = np.ascontiguousarray(cells[:, :height, :width])
        known = cells != NODATA
        if not known.any():
            return
        self._shown |= known.any(axis=(1, 2))
        with gdal_writing(self._failure):
            self._dataset.WriteArray(cells, left, top)

    def close(self, names: Sequence[str], settings: Mapping[str, str]) -> None:
        """Overviews, statistics and the names of the sources, which their numbers from 1 on mean; ``settings``: how it
        was measured, which goes along with it as metadata of ``TOTALS_DOMAIN``."""
        with gdal_writing(self._failure):
            dataset = self._dataset
            dataset.SetMetadata({**settings}, TOTALS_DOMAIN)
            dataset.GetRasterBand(SOURCE_BAND).SetCategoryNames(["", *names])
            dataset.FlushCache()
            for number in (np.flatnonzero(self._shown) + 1).tolist():
                dataset.GetRasterBand(number).ComputeStatistics(False)
            if self._shown.any():
                _write_overviews(dataset)
            dataset.FlushCache()
            self._dataset = None


@contextmanager
def loss_raster(path: str, mosaic: Raster, cell_px: int) -> Iterator[LossRaster]:
    """A GeoTIFF that is there when the block ends, or not at all. Raises RasterError where none can be written."""
    columns, rows = -(-mosaic.columns // cell_px), -(-mosaic.rows // cell_px)
    # At the fastest level the file is 3 % larger and takes half the time: one thread writes what many measure.
    options = ["TILED=YES", "BIGTIFF=IF_SAFER", "COMPRESS=DEFLATE", "ZLEVEL=1", "PREDICTOR=3", "INTERLEAVE=BAND"]
    options.append("SPARSE_OK=TRUE")  # what is not written is ``NODATA``
    left, across, skew, top, down, height = mosaic.placement
    with whole_raster(path) as unfinished:
        with gdal_writing(imagery_messages.RASTER_NOT_WRITTEN(path=path)):
            driver = gdal.GetDriverByName(GEOTIFF)
            dataset = driver.Create(unfinished, columns, rows, len(BANDS), gdal.GDT_Float32, options)
            dataset.SetGeoTransform((left, across * cell_px, skew * cell_px, top, down * cell_px, height * cell_px))
            dataset.SetProjection(mosaic.wkt)
            for number, name in enumerate(BANDS, 1):
                dataset.GetRasterBand(number).SetDescription(name)
                dataset.GetRasterBand(number).SetNoDataValue(NODATA)
        yield LossRaster(dataset, path, cell_px)


TILE = 256
"""Side of the least overview; a picture that is no larger has none."""


def _write_overviews(dataset: gdal.Dataset) -> None:
    """Halve a picture until it is no larger than a tile: means, and the source that most pixels follow."""
    longest = max(dataset.RasterXSize, dataset.RasterYSize)
    factors = [2**level for level in range(1, 31) if longest / 2 ** (level - 1) > TILE]
    if not factors:
        return
    dataset.BuildOverviews("AVERAGE", factors)
    source = dataset.GetRasterBand(SOURCE_BAND)
    gdal.RegenerateOverviews(source, [source.GetOverview(level) for level in range(len(factors))], "MODE")
