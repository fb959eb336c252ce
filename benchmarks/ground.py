"""Rasters with natural content: a mosaic and two orthoimages of the demonstration's scene, in every tile format."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from osgeo import gdal
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.seams.measure.window.inspection import Block
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings, WindowRequest

from demo.block import EXPOSURES, write_image
from demo.camera import Box, take
from demo.canvas import PIXEL
from demo.mosaic import assemble, balance
from demo.scene import make_scene

SIDE = 1024
"""Side of a window, px."""
FIRST = 50
"""Column and row of the first window: it lies across tiles as most windows do, 5 x 5 of them."""
EXTENT = 2.15 * SIDE * PIXEL
"""Side of the mosaic, m: 2 x 2 windows and some more."""
MARGIN = 6.0
"""How much larger the orthoimages are, m."""

FORMATS = {
    "uncompressed": [],
    "DEFLATE": ["COMPRESS=DEFLATE", "PREDICTOR=2"],
    "JPEG 75": ["COMPRESS=JPEG", "JPEG_QUALITY=75", "PHOTOMETRIC=YCBCR"],
    "JPEG 90": ["COMPRESS=JPEG", "JPEG_QUALITY=90", "PHOTOMETRIC=YCBCR"],
}
COMPRESSED = tuple(FORMATS)[1:]
TILES = ["TILED=YES", "BLOCKXSIZE=256", "BLOCKYSIZE=256"]


@dataclass(frozen=True)
class Ground:
    """The files by format, the mosaic first."""

    files: dict[str, tuple[Path, ...]]

    def pixels(self) -> np.ndarray:
        """All of the mosaic, 8 bit (bands, rows, columns)."""
        return gdal.Open(str(self.files["uncompressed"][0])).ReadAsArray()

    def bits_per_sample(self, tile_format: str) -> float:
        """How well the tiles are compressed."""
        path = self.files[tile_format][0]
        return 8 * path.stat().st_size / self.pixels().size

    def requests(self, tile_format: str) -> list[WindowRequest]:
        """2 x 2 windows, each of them covered by the mosaic and both orthoimages."""
        refs = [RasterRef(str(path)) for path in self.files[tile_format]]
        block = Block(describe_mosaic(refs[0]), tuple(Source(ref, describe(ref).extent) for ref in refs[1:]))
        places = [PixelWindow(FIRST + column, FIRST + row, SIDE, SIDE) for row in (0, SIDE) for column in (0, SIDE)]
        return [WindowRequest(number, block.mosaic, block.sources_over(place), place, InspectionSettings())
                for number, place in enumerate(places, 1)]


def make_ground(folder: Path) -> Ground:
    """Draw the scene, photograph it twice, mosaic the two images and write the three in all formats."""
    rng = np.random.default_rng(2010)
    extent = (EXTENT, EXTENT)
    scene = make_scene(extent, 2 * MARGIN, rng)
    footprint = Box(-MARGIN, -MARGIN, EXTENT + MARGIN, EXTENT + MARGIN)
    images = [take(scene, exposure, footprint, rng) for exposure in EXPOSURES[:2]]
    left, right = (image.name for image in images)

    def weights(x: np.ndarray, y: np.ndarray) -> dict[str, np.ndarray]:
        share = np.clip((x - EXTENT / 2) / 2.0 + 0.5, 0, 1) + 0 * y
        return {left: 1 - share, right: share}

    written = [("mosaic", assemble(images, balance(images), {}, weights, extent), 0.0, 0.0)]
    written += [(Path(image.name).stem, image.pixels, image.left, image.top) for image in images]
    files: dict[str, list[Path]] = {tile_format: [] for tile_format in FORMATS}
    for name, pixels, x, y in written:
        master = folder / f"{name}.tif"
        write_image(master, pixels, x, y)
        for tile_format, options in FORMATS.items():
            path = folder / f"{name}_{tile_format.replace(' ', '_').lower()}.tif"
            gdal.Translate(str(path), str(master), creationOptions=TILES + options)
            files[tile_format].append(path)
    return Ground({tile_format: tuple(paths) for tile_format, paths in files.items()})
