"""The picture of losses while a scan is under way: a GeoTIFF that a map shows as its blocks are filled in."""
from __future__ import annotations

import time
from pathlib import Path

import numpy as np

from ..imagery import messages as imagery_messages
from ..imagery.gdal_calls import gdal_writing
from ..imagery.rasters import Raster
from .measure.profile.ground import grounds
from .measure.scan.blocks.block_grid import BLOCK_PX
from .measure.scan.blocks.scan_block import BlockScan
from .measure.scan.results.loss_raster import BANDS, NODATA, created_cells, loss_cells

MOST_CELLS = 16_000_000  # of the picture, so that it is drawn in a moment, without overviews
_LARGEST_CELL_PX = 256
_FLUSH_S = 0.5


class PictureSoFar:
    """kept_1 of each block by its own ground; the final one knows the ground of neighbours, too.

    Uncompressed and whole from the start, so that whoever reads it meanwhile finds every pixel in its place.
    """

    def __init__(self, path: Path, mosaic: Raster, cell_px: int) -> None:
        """Makes the file, or makes it anew. Raises RasterError where none can be."""
        while mosaic.columns * mosaic.rows > MOST_CELLS * cell_px**2 and cell_px < _LARGEST_CELL_PX:
            cell_px *= 2
        self._cell_px, self._side = cell_px, BLOCK_PX // cell_px
        self._failure = imagery_messages.RASTER_NOT_WRITTEN(path=path)
        dataset = created_cells(str(path), mosaic, cell_px, BANDS[:1], self._failure)
        with gdal_writing(self._failure):
            dataset.GetRasterBand(1).Fill(NODATA)
            dataset.FlushCache()
        self.has_content = False
        """Whether something was filled in."""
        self._dataset, self._flushed = dataset, -_FLUSH_S  # so that the first block is seen at once

    def add(self, scan: BlockScan) -> None:
        """Fill in what was measured in a block. Raises RasterError when the disk is full."""
        found = loss_cells(
            scan, np.zeros(scan.labels.shape, np.int32), grounds(scan.cells), self._cell_px
        )[0]
        row, column = (one * self._side for one in scan.key)
        dataset = self._dataset
        width, height = (min(self._side, size - start) for size, start in (
            (dataset.RasterXSize, column), (dataset.RasterYSize, row),
        ))
        found = found[:height, :width]
        if not (found != NODATA).any():
            return
        with gdal_writing(self._failure):
            before = dataset.GetRasterBand(1).ReadAsArray(column, row, width, height)
            dataset.GetRasterBand(1).WriteArray(np.where(found != NODATA, found, before), column, row)
            self.has_content = True
            if time.monotonic() - self._flushed > _FLUSH_S:
                self.flush()

    def flush(self) -> None:
        """Let others see what is there. Raises RasterError when the disk is full."""
        with gdal_writing(self._failure):
            self._dataset.FlushCache()
        self._flushed = time.monotonic()

    def close(self) -> None:
        """Let go of the file; the last of it is written."""
        self.flush()
        self._dataset = None
