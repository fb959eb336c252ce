"""The picture of where detail was lost: a GeoTIFF of cells, written block row by block row."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager

import numpy as np
from osgeo import gdal

from ....imagery import messages as imagery_messages
from ....imagery.gdal_calls import gdal_writing
from ....imagery.raster_writer import GEOTIFF, whole_raster
from ....imagery.rasters import Raster
from ..blocks.block_grid import BLOCK_PX, LABEL_PX
from ..blocks.scan_block import BlockScan
from ..following.boxes import in_squares
from ..profile.cell_table import CELL_PX
from ..profile.ground import LevelGround

BANDS = ("kept_1", "contrast_1", "added_1", "source", "mixture")
NODATA = -1.0  # all that is shown is 0 or more
SETTINGS_DOMAIN = "SEAM_INSPECTOR"
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
        self._tiles: set[tuple[int, int]] = set()  # of the first overview, that have something to show
        self._sums = np.zeros((3, len(BANDS)))  # by band how many pixels are known, their values, and their squares
        self._least, self._most = np.full(len(BANDS), np.inf), np.full(len(BANDS), -np.inf)

    def write(self, row: int, column: int, cells: np.ndarray) -> None:
        """The cells of one block by its row and column."""
        left, top = column * self._side, row * self._side
        width, height = self._dataset.RasterXSize - left, self._dataset.RasterYSize - top
        cells = np.ascontiguousarray(cells[:, :height, :width])
        known = cells != NODATA
        if not known.any():
            return
        values = np.where(known, cells, 0).astype(np.float64)
        self._sums += [plane.sum(axis=(1, 2)) for plane in (known, values, np.square(values))]
        self._least = np.minimum(self._least, np.where(known, cells, np.inf).min(axis=(1, 2)))
        self._most = np.maximum(self._most, cells.max(axis=(1, 2)))
        self._tiles.add((top // (2 * TILE), left // (2 * TILE)))
        with gdal_writing(self._failure):
            self._dataset.WriteArray(cells, left, top)

    def close(self, names: Sequence[str], settings: Mapping[str, str] | None = None) -> None:
        """Overviews, statistics and the names of the sources, which their numbers from 1 on mean; ``settings``: what
        only the whole scan knows, beside its settings."""
        with gdal_writing(self._failure):
            dataset = self._dataset
            for name, value in (settings or {}).items():
                dataset.SetMetadataItem(name, value, SETTINGS_DOMAIN)
            dataset.GetRasterBand(SOURCE_BAND).SetCategoryNames(["", *names])
            dataset.FlushCache()
            _write_overviews(dataset, self._tiles)
            for number, (count, total, squares) in enumerate(self._sums.T.tolist()):
                if count:
                    mean, ends = total / count, (float(self._least[number]), float(self._most[number]))
                    deviation = max(squares / count - mean**2, 0.0) ** 0.5
                    dataset.GetRasterBand(number + 1).SetStatistics(*ends, mean, deviation)
            dataset.FlushCache()
            self._dataset = None


@contextmanager
def loss_raster(
    path: str, mosaic: Raster, cell_px: int, settings: Mapping[str, str] | None = None
) -> Iterator[LossRaster]:
    """A GeoTIFF that is there when the block ends, or not at all. Raises RasterError where none can be written.

    ``settings``: how it was measured, which goes along with it as metadata of ``SETTINGS_DOMAIN``.
    """
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
            dataset.SetMetadata(dict(settings or {}), SETTINGS_DOMAIN)
        yield LossRaster(dataset, path, cell_px)


TILE = 256
"""Side of the parts of an overview that are made at a time; a picture that is no larger has none."""


def _write_overviews(dataset: gdal.Dataset, tiles: Iterable[tuple[int, int]]) -> None:
    """Halve a picture until it is no larger than a tile. ``tiles``: rows and columns of those of the first overview
    that are not empty."""
    longest = max(dataset.RasterXSize, dataset.RasterYSize)
    factors = [2**level for level in range(1, 31) if longest / 2 ** (level - 1) > TILE]
    if not factors:
        return
    dataset.BuildOverviews("NONE", factors)
    wanted = set(tiles)
    for level in range(len(factors)):
        for row, column in sorted(wanted):
            for number in range(1, dataset.RasterCount + 1):
                band = dataset.GetRasterBand(number)
                finer = band.GetOverview(level - 1) if level else band
                left, top = 2 * TILE * column, 2 * TILE * row
                width, height = min(2 * TILE, finer.XSize - left), min(2 * TILE, finer.YSize - top)
                made = _halved(finer.ReadAsArray(left, top, width, height), number == SOURCE_BAND)
                band.GetOverview(level).WriteArray(made, left // 2, top // 2)
        wanted = {(row // 2, column // 2) for row, column in wanted}


def _halved(pixels: np.ndarray, are_names: bool) -> np.ndarray:
    """Each two by two pixels as one, (rows, columns) float32: the mean of those that are known, or of numbers of
    sources the one that stands most often, of several the first. Beyond the edge nothing is known."""
    rows, columns = pixels.shape
    even = np.pad(pixels, ((0, rows % 2), (0, columns % 2)), constant_values=NODATA)
    four = np.stack([even[row::2, column::2] for row in (0, 1) for column in (0, 1)])
    known = four != NODATA
    if are_names:
        votes = np.where(known, (four[:, np.newaxis] == four).sum(axis=1), 0)
        return np.take_along_axis(four, votes.argmax(axis=0)[np.newaxis], axis=0)[0]
    count, total = known.sum(axis=0), np.where(known, four, 0).sum(axis=0, dtype=np.float64)
    return np.where(count, total / np.maximum(count, 1), NODATA).astype(np.float32)
