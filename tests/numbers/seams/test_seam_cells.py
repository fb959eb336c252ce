"""Seam cells become labels: which source by its name, which pixels by arithmetic."""
from __future__ import annotations

import numpy as np
import pytest
from osgeo import ogr
from seam_inspector.plugin.imagery.grids import Grid, PixelWindow
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN, Cell, cell_labels

GRID = Grid(500000.0, 5000000.0, 0.1, 0.2, 1000, 800)
WINDOW = PixelWindow(100, 200, 64, 48)
NAMES = ["west.tif", "east.tif"]


def place(column: float, row: float) -> tuple[float, float]:
    """The map point at a place of the window's pixels."""
    return GRID.left + (WINDOW.column + column) * 0.1, GRID.top - (WINDOW.row + row) * 0.2


def cell(source: str, *corners: tuple[float, float]) -> Cell:
    """A polygon by places of the window's pixels."""
    points = ", ".join(f"{x!r} {y!r}" for x, y in (place(*corner) for corner in (*corners, corners[0])))
    outline = ogr.CreateGeometryFromWkt(f"POLYGON(({points}))")
    west, east, south, north = outline.GetEnvelope()
    return Cell(source, bytes(outline.ExportToWkb()), (west, south, east, north))


def box(source: str, left: float, top: float, right: float, bottom: float) -> Cell:
    return cell(source, (left, top), (right, top), (right, bottom), (left, bottom))


def labels(*cells: Cell) -> np.ndarray:
    return cell_labels(cells, [(name,) for name in NAMES], GRID, WINDOW)


def test_a_pixel_belongs_to_the_cell_that_holds_its_centre() -> None:
    drawn = labels(cell("west.tif", (0, 0), (64, 0), (0, 48)), cell("east.tif", (64, 0), (64, 48), (0, 48)))
    row, column = np.mgrid[:48, :64] + 0.5
    west = column / 64 + row / 48
    sure = np.abs(west - 1) > 0.01
    np.testing.assert_array_equal(drawn[sure], (west > 1)[sure])
    assert not (drawn == UNKNOWN).any()


@pytest.mark.parametrize("name", ["west.tif", "west", "WEST.TIF", "/block/images/west.tif", "C:\\block\\west.jp2"])
def test_a_source_may_be_named_with_or_without_folder_and_ending(name: str) -> None:
    assert (labels(box(name, 0, 0, 64, 48)) == 0).all()


@pytest.mark.parametrize("name", ["north.tif", "west_2.tif", "wes", "255"])
def test_a_cell_of_a_source_that_takes_no_part_says_nothing(name: str) -> None:
    assert (labels(box(name, 0, 0, 64, 48)) == UNKNOWN).all()
    known = labels(box("east", 0, 0, 64, 48), box(name, 10, 10, 20, 20))
    assert (known == 1).all()
