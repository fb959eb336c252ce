"""Seam cells: polygons that say which source a mosaic was cut from, where a producer hands them over."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import PurePath

import numpy as np
from osgeo import ogr

from ...imagery.grids import Extent, Grid, PixelWindow, extents_meet
from ...imagery.lines import burnt

UNKNOWN = 255
"""The label of pixels that no cell covers, or one of a source that does not take part."""


@dataclass(frozen=True)
class Cell:
    """One polygon of the mosaic."""

    source: str
    """The source's file name, with or without folder and ending."""
    wkb: bytes
    """Polygon in the mosaic's reference system."""
    extent: Extent
    """Its bounding box."""


def cells_over(cells: Sequence[Cell], extent: Extent) -> tuple[Cell, ...]:
    """Those whose bounding box meets a rectangle."""
    return tuple(cell for cell in cells if extents_meet(cell.extent, extent))


def cell_labels(cells: Sequence[Cell], names: Sequence[str], grid: Grid, window: PixelWindow) -> np.ndarray:
    """Index of each pixel's source in ``names``, (rows, columns) uint8, ``UNKNOWN`` where no cell says."""
    places = {source_stem(name): place for place, name in enumerate(names)}
    named = [(cell, places.get(source_stem(cell.source))) for cell in cells]
    shapes = [(ogr.CreateGeometryFromWkb(cell.wkb), place) for cell, place in named if place is not None]
    return burnt(shapes, grid, window, UNKNOWN)


def is_one_of(labels: np.ndarray, numbers: Iterable[int]) -> np.ndarray:
    """Pixels with one of some labels, bool: of the few that a window has in a tenth of the time of ``np.isin``."""
    found = np.zeros(labels.shape, bool)
    for number in numbers:
        found |= labels == number
    return found


def present(labels: np.ndarray) -> list[int]:
    """The sources that any pixel follows."""
    left, found = int(np.count_nonzero(labels != UNKNOWN)), []
    for number in range(UNKNOWN):
        if not left:
            break
        if count := int(np.count_nonzero(labels == number)):
            found.append(number)
            left -= count
    return found


def source_stem(name: str) -> str:
    """What a source is compared by: its name without folder, ending and capitals."""
    return PurePath(name.replace("\\", "/")).stem.lower()
