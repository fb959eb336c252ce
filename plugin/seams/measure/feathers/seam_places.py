"""Where a seam runs, or may run, in a window: as the distance of each pixel from it on the ground."""
from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from osgeo import gdal, ogr
from scipy import ndimage

from ....imagery.gdal_calls import gdal_silenced
from ....imagery.grids import Extent, Grid, PixelWindow
from ....imagery.rasters import Raster
from ....imagery.reference_systems import geometry_on

_DIRECTIONS = np.pi / 4 * (np.arange(4) + 0.5)
"""Of the seams that are assumed. All are 8 % longer than a window's side; the mean of all directions is 12 %."""
_MIN_SIDE_SHARE = 0.01  # of the window: smaller pieces are what is left between a line's steps and the pixels


class Seamlines:
    """Lines along which images are to be joined, or polygons with such borders, in the windows' reference system."""

    def __init__(self, geometries: Iterable[bytes]) -> None:
        """``geometries``: WKB of each."""
        self._geometries = list(geometries)
        boxes = [ogr.CreateGeometryFromWkb(wkb).GetEnvelope() for wkb in self._geometries]
        self._xmin, self._xmax, self._ymin, self._ymax = np.array(boxes, float).reshape(-1, 4).T

    def over(self, extent: Extent) -> tuple[bytes, ...]:
        """Those whose bounding box meets a rectangle."""
        xmin, ymin, xmax, ymax = extent
        meets = (self._xmin <= xmax) & (self._xmax >= xmin) & (self._ymin <= ymax) & (self._ymax >= ymin)
        return tuple(self._geometries[number] for number in np.flatnonzero(meets))


def assumed_seams(rows: int, columns: int, pixel_m: tuple[float, float]) -> list[np.ndarray]:
    """Straight seams through the middle of a window, in four directions: (rows, columns) m from each of them.

    Windows lie along seams, and a seam runs through its window in any direction. ``pixel_m``: height and width of a
    pixel.
    """
    y, x = np.ogrid[:rows, :columns]
    y, x = (y - (rows - 1) / 2) * pixel_m[0], (x - (columns - 1) / 2) * pixel_m[1]
    return [x * np.cos(direction) + y * np.sin(direction) for direction in _DIRECTIONS]


def drawn_seam(
    lines: Sequence[bytes], wkt: str, mosaic: Raster, window: PixelWindow, pixel_m: tuple[float, float]
) -> np.ndarray | None:
    """Distance from the seamlines of a window, (rows, columns) m; None where they do not divide it.

    ``lines``: WKB in the reference system ``wkt``. One side is the largest part of the window, the other all the rest.

    Raises RasterError when the lines can't be transformed to the mosaic's reference system.
    """
    borders = [_border(line, wkt, mosaic.wkt) for line in lines]
    parts, _ = ndimage.label(~_burnt(borders, mosaic.grid, window))
    sizes = np.bincount(parts.ravel())
    sizes[0] = 0
    sides = np.flatnonzero(sizes >= _MIN_SIDE_SHARE * parts.size)
    if len(sides) < 2:
        return None
    nearest = ndimage.distance_transform_edt(~np.isin(parts, sides), return_distances=False, return_indices=True)
    largest = parts[tuple(nearest)] == sizes.argmax()
    inside, outside = (ndimage.distance_transform_edt(side, pixel_m) for side in (largest, ~largest))
    half = min(pixel_m) / 2  # the seam runs between two pixels
    return np.where(largest, inside - half, half - outside)


def _border(line: bytes, wkt: str, target_wkt: str) -> ogr.Geometry:
    geometry = geometry_on(ogr.CreateGeometryFromWkb(line).GetLinearGeometry(), wkt, target_wkt)
    return geometry.Boundary() if geometry.GetDimension() == 2 else geometry


def _burnt(lines: Sequence[ogr.Geometry], grid: Grid, window: PixelWindow) -> np.ndarray:
    """Pixels that a line runs through, (rows, columns) bool."""
    xmin, _, _, ymax = grid.window_extent(window)
    with gdal_silenced():
        target = gdal.GetDriverByName("MEM").Create("", window.width, window.height, 1, gdal.GDT_Byte)
        target.SetGeoTransform((xmin, grid.pixel_width, 0, ymax, 0, -grid.pixel_height))
        vector = ogr.GetDriverByName("Memory").CreateDataSource("")
        layer = vector.CreateLayer("seams")
        for line in lines:
            feature = ogr.Feature(layer.GetLayerDefn())
            feature.SetGeometry(line)
            layer.CreateFeature(feature)
        gdal.RasterizeLayer(target, [1], layer, burn_values=[1], options=["ALL_TOUCHED=TRUE"])
        return target.ReadAsArray() > 0
