"""Cells where rasters have pixels, on cells of the mosaic's grid: what can take part in a window before it is read."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....imagery import limits as imagery_limits
from ....imagery.clips import MAX_MISSING_SHARE
from ....imagery.grids import Extent, Grid, PixelWindow
from ....imagery.open_raster import OpenRaster, placed
from ....imagery.rasters import Raster
from ....imagery.reference_systems import same_coordinates, transform_points

MOST_CELLS = 4096  # along a side of the mosaic
FEWEST_PX = 4  # side of a cell: as many samples as placing windows takes
MOST_READ = 500_000  # cells at once, of each four pixels are read


@dataclass(frozen=True, eq=False)
class ValidCells:
    """The part of the mosaic's cells that lies in a raster's footprint."""

    column: int
    """First cell, counted on the mosaic."""
    row: int
    valid: np.ndarray
    """(rows, columns) bool: whether the raster has a pixel in the middle of the cell."""

    def share(self, cells: tuple[slice, slice]) -> float:
        """Share of a rectangle of the mosaic's cells in which the raster has pixels."""
        rows, columns = cells
        asked = (rows.stop - rows.start) * (columns.stop - columns.start)
        top, left = max(rows.start - self.row, 0), max(columns.start - self.column, 0)
        bottom, right = max(rows.stop - self.row, 0), max(columns.stop - self.column, 0)
        return np.count_nonzero(self.valid[top:bottom, left:right]) / asked if asked else 0.0


@dataclass(frozen=True)
class CellGrid:
    """Square cells of whole pixels over the mosaic."""

    grid: Grid
    step: int
    """Side of a cell, px."""

    @staticmethod
    def of(grid: Grid) -> CellGrid:
        """Cells as fine as memory allows."""
        step = FEWEST_PX
        while max(grid.columns, grid.rows) > MOST_CELLS * step:
            step *= 2
        return CellGrid(grid, step)

    def cells(self, window: PixelWindow) -> tuple[slice, slice]:
        """Rows and columns of the cells whose middle lies in a window."""
        first = round(window.row / self.step), round(window.column / self.step)
        after = round((window.row + window.height) / self.step), round((window.column + window.width) / self.step)
        return slice(first[0], max(after[0], first[0] + 1)), slice(first[1], max(after[1], first[1] + 1))

    def over(self, extent: Extent) -> tuple[slice, slice]:
        """Rows and columns of the mosaic's cells that meet an extent."""
        grid, step = self.grid, self.step
        left, right = ((x - grid.left) / grid.pixel_width / step for x in (extent[0], extent[2]))
        top, bottom = ((grid.top - y) / grid.pixel_height / step for y in (extent[3], extent[1]))
        rows, columns = -(-grid.rows // step), -(-grid.columns // step)
        return (
            slice(int(np.clip(np.floor(top), 0, rows)), int(np.clip(np.ceil(bottom), 0, rows))),
            slice(int(np.clip(np.floor(left), 0, columns)), int(np.clip(np.ceil(right), 0, columns))),
        )

    def middles(self, cells: slice, across: bool) -> np.ndarray:
        """Coordinates of the middles of columns of cells, or of rows of them."""
        pixels = (np.arange(cells.start, cells.stop) + 0.5) * self.step
        if across:
            return self.grid.left + pixels * self.grid.pixel_width
        return self.grid.top - pixels * self.grid.pixel_height


def valid_cells(source: OpenRaster, extent: Extent, mosaic: Raster) -> ValidCells:
    """Cells where a raster, the mosaic or one with that footprint, has pixels: by nodata, alpha and masks.

    Raises RasterError when it can't be read, or does not lie on the mosaic's map.
    """
    cell_grid, raster = CellGrid.of(mosaic.grid), placed(source.raster)
    rows, columns = cell_grid.over(extent)
    if rows.stop <= rows.start or columns.stop <= columns.start:
        return ValidCells(columns.start, rows.start, np.zeros((0, 0), bool))
    x, y = cell_grid.middles(columns, True), cell_grid.middles(rows, False)
    left, right, skew_x, top, skew_y, down = raster.placement
    if raster.is_north_up and same_coordinates(raster.wkt, mosaic.wkt, mosaic.extent, 0.5 * mosaic.grid.pixel_width):
        at_column, at_row = np.broadcast_arrays(((x - left) / right)[None, :], ((y - top) / down)[:, None])
    else:
        points = np.column_stack([axis.ravel() for axis in np.meshgrid(x, y)])
        moved = transform_points(points, mosaic.wkt, raster.wkt).reshape(len(y), len(x), 2)
        east, north = moved[..., 0] - left, moved[..., 1] - top
        determinant = right * down - skew_x * skew_y
        at_column = (east * down - north * skew_x) / determinant
        at_row = (north * right - east * skew_y) / determinant
    inside = (at_column >= 0) & (at_column < raster.columns) & (at_row >= 0) & (at_row < raster.rows)
    mosaic_pixels = mosaic.ground_sample_distance / raster.ground_sample_distance
    if is_whole(source) or not inside.any():
        return ValidCells(columns.start, rows.start, inside)
    is_valid, at_once = np.zeros_like(inside), max(1, MOST_READ // len(x))
    for first in range(0, len(y), at_once):
        some = slice(first, first + at_once)
        is_valid[some] = _picked(source, at_column[some], at_row[some], inside[some], cell_grid.step * mosaic_pixels)
    return ValidCells(columns.start, rows.start, is_valid)


def _picked(
    source: OpenRaster, at_column: np.ndarray, at_row: np.ndarray, inside: np.ndarray, step: float
) -> np.ndarray:
    """Whether there are pixels at columns and rows of a raster, some ``step`` of its pixels apart."""
    if not inside.any():
        return inside
    left, right = int(at_column[inside].min()), int(at_column[inside].max()) + 1
    top, bottom = int(at_row[inside].min()), int(at_row[inside].max()) + 1
    part = PixelWindow(left, top, right - left, bottom - top)
    thinned = source.thinned(part, max(1, int(step / 2))).valid
    across, down = thinned.shape[1] / part.width, thinned.shape[0] / part.height
    picked = thinned[
        np.clip(((at_row - top) * down).astype(np.int64), 0, thinned.shape[0] - 1),
        np.clip(((at_column - left) * across).astype(np.int64), 0, thinned.shape[1] - 1),
    ]
    return inside & picked


def is_whole(source: OpenRaster) -> bool:
    """Whether nothing in a raster can say that a pixel is none."""
    is_plain = source.roles.alpha is None and source.roles.palette is None
    return is_plain and source.is_all_valid and not source.raster.data_type.startswith("float")


def takes_part(share: float) -> bool:
    """Whether a source with pixels in that share of a window is compared there."""
    return share >= 1 - MAX_MISSING_SHARE


def is_mosaic_enough(share: float) -> bool:
    """Whether a window can be judged in which the mosaic has that share of its pixels."""
    return share >= 1 - imagery_limits.MAX_INVALID_SHARE
