"""Mosaics of made-up orthoimages as files, and requests to scan blocks of them."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

import numpy as np
from scipy import ndimage
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.seams.measure.blocks.block_grid import BlockGrid, BlockKey, ScanSettings
from seam_inspector.plugin.seams.measure.blocks.block_pixels import BlockPixels
from seam_inspector.plugin.seams.measure.blocks.scan_block import BlockRequest, BlockScan, scan_block
from seam_inspector.plugin.seams.measure.scan.block_runs import both_looks
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN
from seam_inspector.plugin.seams.measure.source_images import Source

from tests.numbers.synthetic import texture, write_raster

SIDE = 1024
SHAPE = (SIDE, SIDE)
NODATA = 0


@dataclass(frozen=True, eq=False)
class Scene:
    """A mosaic and its orthoimages."""

    mosaic: Raster
    sources: tuple[Source, ...]

    def pixels(self, margin_px: int | None = 0) -> BlockPixels:
        """Pixels of its first block."""
        window = BlockGrid(self.mosaic.grid).window((0, 0))
        return BlockPixels(self.mosaic, [source.ref for source in self.sources], window, margin_px)

    def request(self, key: BlockKey = (0, 0), wanted: np.ndarray | None = None,
                along_seams: np.ndarray | None = None, **settings: object) -> BlockRequest:
        """To scan one block."""
        return BlockRequest(
            self.mosaic, tuple(source.ref for source in self.sources), key, BlockGrid(self.mosaic.grid).window(key),
            ScanSettings(**settings), wanted, along_seams,  # type: ignore[arg-type]
        )


def measured(request: BlockRequest) -> BlockScan:
    """A block alone by both looks: at its patches, then at its seams by what these told."""
    first = scan_block(request)
    followed = np.pad(first.squares, 1, constant_values=UNKNOWN)
    taps = first.learned.taps
    seams = replace(request, wanted=first.wanted, taps=taps, followed=followed)
    return both_looks(first, scan_block(seams))


@lru_cache(maxsize=4)
def images(shape: tuple[int, int] = SHAPE, count: int = 2, detail_dn: float = 9.0) -> tuple[np.ndarray, ...]:
    """Images of one ground, each with fine detail of its own, (rows, columns) 8 bit without the value 0."""
    contrast = np.exp(0.3 * ndimage.gaussian_filter(texture(shape, 3.0, 7), 12, mode="wrap"))
    ground = 120 + 22 * texture(shape, 3.0, 40)
    return tuple(as_bytes(ground + detail_dn * contrast * texture(shape, 0.8, seed)) for seed in range(1, count + 1))


def as_bytes(values: np.ndarray) -> np.ndarray:
    """8 bit, none of them 0."""
    return np.clip(np.rint(values), 1, 255).astype(np.uint8)


def beside(place: float, width: float = 0.0, shape: tuple[int, int] = SHAPE) -> np.ndarray:
    """Weight of the second of two images that meet at a column, feathered by a cosine over a full width."""
    columns = np.arange(shape[1]) + 0.5 - place
    part = (columns > 0).astype(float) if not width else np.clip(columns / width + 0.5, 0, 1)
    return np.broadcast_to(0.5 - 0.5 * np.cos(np.pi * part), shape)


def blended(first: np.ndarray, second: np.ndarray, weight: np.ndarray) -> np.ndarray:
    """Two images by the weight of the second."""
    return as_bytes((1 - weight) * first + weight * second)


def scene(folder: Path, mosaic: np.ndarray, given: Sequence[np.ndarray], nodata: int | None = NODATA) -> Scene:
    """A scene as files on one grid."""
    ref = RasterRef(write_raster(folder / "mosaic.tif", mosaic, nodata=nodata))
    refs = [RasterRef(write_raster(folder / f"source_{number}.tif", pixels, nodata=nodata))
            for number, pixels in enumerate(given)]
    return Scene(describe_mosaic(ref), tuple(Source(ref, describe(ref).extent) for ref in refs))


def window(left: int, top: int, width: int, height: int) -> PixelWindow:
    """A window of a mosaic."""
    return PixelWindow(left, top, width, height)
