"""The mosaic's own detail in cells along its seams, with what tells ground from ground: all that can be known of a seam
where no orthoimage is given. Block by block, from the request to the cells' record."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from ....imagery.clips import read_clip
from ....imagery.errors import Message, NotCoveredError, RasterError
from ....imagery.grids import PixelWindow
from ....imagery.raster_pool import open_raster
from ....imagery.records import packed, understanding, unpacked
from ....imagery.wavelets import judged_plane, placed_components
from ..blocks.block_grid import BlockKey, rectangles
from ..blocks.mosaic_reading import ALL_READ, BlockReading
from ..blocks.scan_block import BlockRequest
from ..following.boxes import in_squares
from ..profile.cell_table import CELL_PX
from ..seamlines.piece_index import PieceIndex
from ..while_measuring import measuring
from .block_runs import BlockLook

REACH_PX = 128.0
"""Cells whose middle lies farther than this from any seam are left out."""
ZONES_PX = (0, 4, 8, 12, 16, 24, 32, 48, 64, 96, 128)
"""Edges of the zones of distance."""
BEYOND = len(ZONES_PX) - 1
"""The zone of what lies farther off than all of them, which only cells on the outer edge have a part in."""
MARGIN_PX = 64
"""So much more than the cells' window has to be given on all sides, or up to the mosaic's edge (mirrored there)."""

_GRID_PX = 2  # of the finest coefficients
_SPLIT_PX = 36.0  # cells nearer than this are split by zone, others lie in that of their middle
_COLOURS = 3  # bands that tell ground from ground; with fewer its brightness does


@dataclass(frozen=True, eq=False)
class LoneTable:
    """Cells of 16 px, and the parts of them in each zone of distance. Some 40 bytes for each pixel of seam."""

    row: np.ndarray
    """(cells,) int32: of the mosaic's cells."""
    column: np.ndarray
    """(cells,) int32"""
    colour: np.ndarray
    """(cells, 1 or 3) float32: mean of the measured plane, then what the bands beside the second differ from it."""
    cell: np.ndarray
    """(parts,) int32: number of the cell that the part is of."""
    zone: np.ndarray
    """(parts,) uint8: of ``ZONES_PX``, by the distance from the nearest seam."""
    area: np.ndarray
    """(parts,) float32: pixels."""
    energy: np.ndarray
    """(parts,) float32: of the details at level 1, DN squared, summed."""

    def __len__(self) -> int:
        """How many cells."""
        return len(self.row)

    @classmethod
    def empty(cls, colours: int = _COLOURS) -> LoneTable:
        """Without cells."""
        place, number = np.zeros(0, np.int32), np.zeros(0, np.float32)
        return cls(place, place, np.zeros((0, colours), np.float32), place, np.zeros(0, np.uint8), number, number)

    @classmethod
    def joined(cls, tables: Sequence[LoneTable]) -> LoneTable:
        """Cells of several windows that share no cell; at least one table, all of one mosaic."""
        some = [table for table in tables if len(table)] or list(tables[:1])
        firsts = np.cumsum([0, *(len(table) for table in some[:-1])])
        cells = [table.cell + np.int32(first) for table, first in zip(some, firsts)]
        parts = {
            name: np.concatenate([getattr(table, name) for table in some])
            for name in ("row", "column", "colour", "zone", "area", "energy")
        }
        return cls(cell=np.concatenate(cells), **parts)


@dataclass(frozen=True, eq=False)
class MosaicPixels:
    """What the mosaic shows in a window."""

    window: PixelWindow
    """On the mosaic's grid."""
    plane: np.ndarray
    """(rows, columns): what is measured."""
    bands: np.ndarray
    """(bands, rows, columns), the first three of which are taken as colours, fewer as none."""
    valid: np.ndarray | None = None
    """(rows, columns) bool; None: everywhere."""


def lone_cells(pixels: MosaicPixels, window: PixelWindow, pieces: PieceIndex, wavelet: str) -> LoneTable:
    """The cells of a window that lie along seams and have all their pixels.

    ``pixels``: of the window with ``MARGIN_PX`` on all sides where the mosaic goes on; both start at multiples of 16
    and have sides that are multiples of 16. ``pieces``: those near the window.
    """
    around, plane, bands, valid = pixels.window, pixels.plane, pixels.bands, pixels.valid
    first_row, first_column = window.row // CELL_PX, window.column // CELL_PX
    rows, columns = window.height // CELL_PX, window.width // CELL_PX
    down, across = np.mgrid[first_row : first_row + rows, first_column : first_column + columns]
    distance = pieces.beside((across + 0.5) * CELL_PX, (down + 0.5) * CELL_PX, REACH_PX).distance_px
    top, left = (window.row - around.row) // CELL_PX, (window.column - around.column) // CELL_PX
    place = np.s_[top : top + rows, left : left + columns]
    near = np.isfinite(distance)
    if valid is not None:
        full = in_squares(valid, CELL_PX).all(axis=(1, 3))
        near &= ndimage.binary_erosion(full, np.ones((3, 3)), border_value=1)[place]  # whose neighbours are full, too
    if not near.any():
        return LoneTable.empty(_COLOURS if len(bands) >= _COLOURS else 1)
    if valid is not None:
        plane = np.where(valid, plane, plane[valid].mean(dtype=np.float64).astype(plane.dtype))
    (details,) = placed_components(plane[np.newaxis], wavelet, 1)
    finest = np.einsum("dij,dij->ij", details[:, 0], details[:, 0])
    colours = [_by_cell(plane)[place]]
    if len(bands) >= _COLOURS:
        second = _by_cell(bands[1])[place]
        colours += [_by_cell(bands[i])[place] - second for i in (0, 2)]
    row, column = down[near].astype(np.int32), across[near].astype(np.int32)
    energies = in_squares(finest, CELL_PX // _GRID_PX).swapaxes(1, 2)[place][near]
    parts = _parts(energies, row, column, distance[near], pieces)
    return LoneTable(row, column, np.stack([colour[near] for colour in colours], axis=1).astype(np.float32), *parts)


def _parts(
    finest: np.ndarray, row: np.ndarray, column: np.ndarray, distance: np.ndarray, pieces: PieceIndex
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Cell, zone, area and energy of the parts, from the finest energies (cells, 8, 8) and the middles' distances."""
    count, per_cell = len(row), CELL_PX // _GRID_PX
    split = distance < _SPLIT_PX
    at = (np.arange(per_cell) + 0.5) * _GRID_PX
    shape = (np.count_nonzero(split), per_cell, per_cell)
    x = np.broadcast_to(column[split, np.newaxis, np.newaxis] * CELL_PX + at, shape)
    y = np.broadcast_to(row[split, np.newaxis, np.newaxis] * CELL_PX + at[:, np.newaxis], shape)
    exact = pieces.beside(x, y, REACH_PX).distance_px
    zones = np.empty((count, per_cell, per_cell), np.intp)
    zones[split] = np.digitize(exact, ZONES_PX) - 1
    zones[~split] = (np.digitize(distance[~split], ZONES_PX) - 1)[:, np.newaxis, np.newaxis]
    np.minimum(zones, BEYOND, out=zones)
    key = (zones + np.arange(count)[:, np.newaxis, np.newaxis] * (BEYOND + 1)).ravel()
    samples = np.bincount(key, minlength=count * (BEYOND + 1))
    sums = np.bincount(key, finest.ravel(), count * (BEYOND + 1))
    there = np.flatnonzero(samples)
    return (
        (there // (BEYOND + 1)).astype(np.int32), (there % (BEYOND + 1)).astype(np.uint8),
        (samples[there] * _GRID_PX**2).astype(np.float32), sums[there].astype(np.float32),
    )


def _by_cell(values: np.ndarray) -> np.ndarray:
    """Means over the cells, (rows, columns)."""
    return np.asarray(in_squares(values, CELL_PX).mean(axis=(1, 3)))


@dataclass(frozen=True, eq=False)
class LoneScan:
    """What was measured along the seams of one block."""

    key: BlockKey
    table: LoneTable
    notices: tuple[Message, ...] = ()
    """What could not be read; the block then lacks it."""
    reading: BlockReading = ALL_READ
    """What could be read."""
    sources: tuple[int, ...] = ()
    """None."""

    @classmethod
    def nothing(cls, request: BlockRequest, notices: tuple[Message, ...]) -> LoneScan:
        """A block of which nothing could be measured."""
        return cls(request.key, LoneTable.empty(), notices, BlockReading((request.window,), False))


@measuring()
def scan_lone_block(request: BlockRequest) -> LoneScan:
    """The cells along the seams of a block, which are its ``pieces``. What can't be read is told in its notices."""
    assert request.wanted is not None
    assert request.pieces is not None
    tables = [LoneTable.empty(3 if len(request.mosaic.band_names) >= 3 else 1)]
    notices: list[Message] = []
    unread: list[PixelWindow] = []
    parts = rectangles(request.wanted)
    for part in parts:
        window = part.moved_by(request.window.column, request.window.row)
        try:
            around = window.with_margin(MARGIN_PX)
            clip = read_clip(open_raster(request.mosaic.ref), request.mosaic, around, partly=True, holes=True)
        except NotCoveredError:
            continue
        except RasterError as error:
            notices.append(error.message.as_warning())
            unread.append(window)
        else:
            bands = clip.bands if request.grey_factor == 1 else clip.bands * np.float32(request.grey_factor)
            pixels = MosaicPixels(around, judged_plane(bands, clip.raster.band_names), bands, clip.valid)
            near = request.pieces.near(around, REACH_PX)
            tables.append(lone_cells(pixels, window, near, request.settings.wavelet))
    reading = BlockReading(tuple(unread), not unread or len(unread) < len(parts))
    return LoneScan(request.key, LoneTable.joined(tables), tuple(dict.fromkeys(notices)), reading)


def lone_record_of(scan: LoneScan) -> bytes:
    """All but the notices, which are told once."""
    return packed({"key": np.array(scan.key), **vars(scan.table)})


def lone_scan_of(record: bytes) -> LoneScan:
    """What ``lone_record_of`` made bytes of. Raises NotUnderstoodError for anything else."""
    with understanding():
        kept = unpacked(record)
        row, column = kept.pop("key").tolist()
        return LoneScan((row, column), LoneTable(**kept))


LONE_LOOK = BlockLook("lone", scan_lone_block, LoneScan.nothing, lone_record_of, lone_scan_of)
