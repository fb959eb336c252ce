"""The mosaic's own detail in cells along its seams, with what tells ground from ground: all that can be known of a seam
where no orthoimage is given. And stretches of seam with the ground on both sides of them: what pieces, whole seams and
the mosaic are judged by.

How much fine detail ground like that has is told by comparing cells with others that look like them: a generalised
linear model with a logarithmic link (McCullagh and Nelder 1989) of the finest energy over a quadratic in the brightness
and the colour. It is fitted to cells off the seam, so whatever was done to the whole mosaic is in it. Coarser detail is
left out: it would tell grounds apart better, and would hide feathers between images that show the ground in different
places, since these take from it, too."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from scipy import ndimage

from ....imagery.grids import PixelWindow
from ....imagery.wavelets import placed_components
from ..compared_image import ComparedImage
from ..energy_response import bounded, log_link_fit
from ..following.boxes import in_squares, square_shares
from ..profile.cell_table import CELL_PX, Rows
from ..seamlines.seam_pieces import PieceIndex, SeamPiece

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
class LoneTable(Rows):
    """A row for each cell and zone of distance, its ``bin``, of ``ZONES_PX``. Some 60 bytes for each pixel of seam."""

    area: np.ndarray
    """(n,) float32: pixels."""
    energy: np.ndarray
    """(n,) float32: of the details at level 1, DN squared, summed."""
    colour: np.ndarray
    """(1 or 3, n) float32, of the cell: mean of the measured plane, then what the bands beside the second differ from
    it."""

    @classmethod
    def empty(cls) -> LoneTable:
        """A table without rows."""
        place, number = np.zeros(0, np.int32), np.zeros(0, np.float32)
        return cls(place, place, np.zeros(0, np.uint8), number, number, np.zeros((_COLOURS, 0), np.float32))

    @classmethod
    def of_all(cls, tables: Sequence[LoneTable]) -> LoneTable:
        """Tables of one mosaic as one; those without rows tell nothing of its colours."""
        return cls.joined([table for table in tables if len(table)] or [cls.empty()])


def lone_cells(
    mosaic: ComparedImage, around: PixelWindow, window: PixelWindow, pieces: PieceIndex, wavelet: str
) -> LoneTable:
    """The cells of a window that lie along seams and have all their pixels.

    ``mosaic``: its pixels ``around``, in the window with ``MARGIN_PX`` on all sides where the mosaic goes on, the first
    three of its bands taken as colours, fewer as none; both start at multiples of 16 and have sides that are multiples
    of 16. ``pieces``: those near the window.
    """
    plane, bands, valid = mosaic.plane, mosaic.bands, mosaic.valid
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
        return LoneTable.empty()
    if valid is not None:
        plane = np.where(valid, plane, plane[valid].mean(dtype=np.float64).astype(plane.dtype))
    (details,) = placed_components(plane[np.newaxis], wavelet, 1)
    finest = np.einsum("dij,dij->ij", details[:, 0], details[:, 0])
    colours = [square_shares(plane, CELL_PX)[place]]
    if len(bands) >= _COLOURS:
        second = square_shares(bands[1], CELL_PX)[place]
        colours += [square_shares(bands[i], CELL_PX)[place] - second for i in (0, 2)]
    row, column = down[near].astype(np.int32), across[near].astype(np.int32)
    energies = in_squares(finest, CELL_PX // _GRID_PX).swapaxes(1, 2)[place][near]
    cell, zone, area, energy = _parts(energies, row, column, distance[near], pieces)
    colour = np.stack([plane[near] for plane in colours]).astype(np.float32)
    return LoneTable(row[cell], column[cell], zone, area, energy, colour[:, cell])


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
        there // (BEYOND + 1), (there % (BEYOND + 1)).astype(np.uint8),
        (samples[there] * _GRID_PX**2).astype(np.float32), sums[there].astype(np.float32),
    )


STRETCH_PX = 64.0
"""Pieces are cut evenly into stretches of about this length; how much these differ tells the interval."""
STRIP_PX = 8
"""Width on either side of the seam that kept_1 is of."""
RANGES_PX = ((16, 64), (64, 128))
"""Ground that the strip is compared with; the second where feathers reach beyond the first."""
FEWEST_CELLS = 250
"""Fewest cells of ground; with fewer in a tile and beside it, what is expected is found from all cells of the table."""

_TILE_CELLS = 64  # what is expected is found anew in each tile of so many cells a side
_BESIDE_CELLS = 32  # and from cells up to so far beside it
_LEAST_PART_PX = 32.0  # area of a part: smaller ones have fewer than 8 coefficients in each direction
STRIP = slice(0, 1)
"""Place of the strip among the parts of stretches; those of the ground follow, left and right of each range."""
_PARTS = 1 + 2 * len(RANGES_PX)


def ground_of(range_: int) -> slice:
    """Places of the ground on both sides among the parts of stretches; ``range_``: place in ``RANGES_PX``."""
    return slice(1 + 2 * range_, 3 + 2 * range_)


@dataclass(frozen=True, eq=False)
class LoneStretches:
    """Sums of n stretches; parts are the strip beside the seam and the ground."""

    piece: np.ndarray
    """(n,) number of the piece."""
    length_px: np.ndarray
    """(n,)"""
    area: np.ndarray
    """(parts, n) pixels."""
    matched: np.ndarray
    """(parts, n) mean of the finest detail over what is expected of ground like that."""
    plain: np.ndarray
    """(parts, n) the same in DN squared a pixel."""
    zone_area: np.ndarray
    """(zones, n) pixels by distance."""
    zone_matched: np.ndarray
    """(zones, n) mean."""
    has_colour: np.ndarray
    """(n,) bool: whether ground was matched by more than its brightness."""

    def __len__(self) -> int:
        return len(self.piece)

    @classmethod
    def joined(cls, parts: Sequence[LoneStretches]) -> LoneStretches:
        """Stretches of several blocks; at least one."""
        return cls(*(np.concatenate([getattr(part, f.name) for part in parts], axis=-1) for f in fields(cls)))

    def chosen(self, where: np.ndarray) -> LoneStretches:
        """Stretches that a mask or an index names."""
        return LoneStretches(*(getattr(self, f.name)[..., where] for f in fields(self)))


def lone_stretches(
    table: LoneTable, pieces: Sequence[SeamPiece], numbers: Sequence[int], index: PieceIndex, pixel_m: float
) -> LoneStretches:
    """The stretches of some pieces, by number.

    ``table`` holds all cells along them, and what is around: those of the neighbouring blocks. ``index``: of all
    pieces, or of those near the table. ``pixel_m``: side of a pixel on the ground.
    """
    start, length = np.array([(pieces[n].station_m, pieces[n].length_m) for n in numbers]).reshape(-1, 2).T
    counts = np.maximum(1, np.round(length / pixel_m / STRETCH_PX)).astype(np.intp)
    count = int(counts.sum())
    # The stretch that is nearest to each cell, where that is one of those asked for, and its side.
    _, first, of_cell = np.unique(table.keys, return_index=True, return_inverse=True)
    cells = table.chosen(first)
    seam = index.beside((cells.column + 0.5) * CELL_PX, (cells.row + 0.5) * CELL_PX, REACH_PX)
    order = np.full(len(pieces) + 1, -1)
    order[list(numbers)] = np.arange(len(numbers))
    order = order[seam.number]  # -1, no piece, is the last
    is_near = order >= 0
    order = order[is_near]
    share = (seam.station_m[is_near] - start[order]) / length[order]
    stretch = np.zeros(len(cells), np.intp)
    stretch[is_near] = np.clip((share * counts[order]).astype(np.intp), 0, counts[order] - 1)
    stretch[is_near] += (np.cumsum(counts) - counts)[order]

    ratio = table.energy / table.area / _expected(table, of_cell, cells)[of_cell]
    belongs = is_near[of_cell]
    piece_of = np.repeat(np.arange(len(counts)), counts)
    zones = len(ZONES_PX) - 1
    inner = belongs & (table.bin < zones)
    place = table.bin.astype(np.intp) * count + stretch[of_cell]
    zone_area, zone_matched = _means(ratio[inner], table.area[inner], place[inner], piece_of, zones)
    # The strip's parts of a cell are one: smaller ones would be capped oftener than the cells of the ground.
    part = np.full(len(table), -1)
    part[table.bin < ZONES_PX.index(STRIP_PX)] = 0
    for range_, (near, far) in enumerate(RANGES_PX):
        there = (table.bin >= ZONES_PX.index(near)) & (table.bin < ZONES_PX.index(far))
        part[there] = ground_of(range_).start + ~seam.on_left[of_cell[there]]
    used = belongs & (part >= 0)
    key, merged = np.unique(of_cell[used].astype(np.int64) * _PARTS + part[used], return_inverse=True)
    cell, part = np.divmod(key, _PARTS)
    area = np.bincount(merged, table.area[used], len(key))
    plain = np.bincount(merged, table.energy[used], len(key)) / area
    matched = np.bincount(merged, (table.area * ratio)[used], len(key)) / area
    large = area >= _LEAST_PART_PX
    area, place = area[large], (part * count + stretch[cell])[large]
    areas, matched_means = _means(matched[large], area, place, piece_of, _PARTS)
    _, plain_means = _means(plain[large], area, place, piece_of, _PARTS)
    return LoneStretches(
        np.repeat(np.asarray(numbers, dtype=np.intp), counts), np.repeat(length / pixel_m / counts, counts),
        areas, matched_means, plain_means, zone_area, zone_matched, np.full(count, len(table.colour) > 1),
    )


def _means(
    values: np.ndarray, area: np.ndarray, place: np.ndarray, piece_of: np.ndarray, groups: int
) -> tuple[np.ndarray, np.ndarray]:
    """Areas and means (groups, stretches), with none counted as more than ``CAP`` times its piece's mean.

    ``place``: the group of each value, times the number of stretches, and its stretch; ``piece_of``: each stretch.
    """
    count = len(piece_of)
    group, stretch = np.divmod(place, count)
    of_piece = piece_of[stretch] * groups + group
    capped = np.minimum(values, CAP * capped_means(values, area, of_piece)[of_piece])
    areas = np.bincount(place, area, groups * count)
    means = np.bincount(place, area * capped, groups * count) / np.where(areas > 0, areas, 1)
    return areas.reshape(groups, count), means.reshape(groups, count)


def _expected(table: LoneTable, of_cell: np.ndarray, cells: LoneTable) -> np.ndarray:
    """The finest energy a pixel that ground like each cell's has, (cells,). ``of_cell``: the cell of each row."""
    far = table.bin >= ZONES_PX.index(RANGES_PX[0][0])
    area = np.bincount(of_cell[far], table.area[far], len(cells))
    energy = np.bincount(of_cell[far], table.energy[far], len(cells)) / np.maximum(area, 1)
    known = area >= _LEAST_PART_PX
    expected = np.full(len(cells), np.nan)
    if not known.any():
        return expected
    tile_row, tile_column, colour = cells.row // _TILE_CELLS, cells.column // _TILE_CELLS, cells.colour.T
    for row, column in np.unique(np.column_stack([tile_row, tile_column]), axis=0):
        inside = (tile_row == row) & (tile_column == column)
        beside = known & _near(cells.row, row) & _near(cells.column, column)
        if np.count_nonzero(beside) < FEWEST_CELLS:
            beside = known
        expected[inside] = expected_energies(colour[beside], energy[beside], area[beside], colour[inside])
    return expected


def _near(places: np.ndarray, tile: int) -> np.ndarray:
    """Cells that lie in a row (column) of tiles or beside it."""
    first = tile * _TILE_CELLS
    return (places >= first - _BESIDE_CELLS) & (places < first + _TILE_CELLS + _BESIDE_CELLS)


CAP = 2.0
"""A cell counts at most as so many times what is expected of it: kerbs and roofs are not what is looked for."""

_ROUNDS = 12  # in a fit and in a capped mean: with 5 a fit to JPEG has not ended, and a sound piece is called lossy
_OUTERMOST = (0.01, 0.99)  # of each property: beyond these quantiles the model is held where it is


def expected_energies(
    properties: np.ndarray, energies: np.ndarray, weights: np.ndarray, wanted: np.ndarray
) -> np.ndarray:
    """What is expected of cells with the properties ``wanted``, (m, p), from others, (n, p), and their energies.

    ``energies`` and ``weights``: (n,). Returns (m,), all positive.
    """
    low, high = np.quantile(properties.astype(np.float64), _OUTERMOST, axis=0)
    known, asked = np.clip(properties, low, high), np.clip(wanted, low, high)
    middle, spread = known.mean(axis=0), np.maximum(known.std(axis=0), 1e-9)
    level = max(float(np.average(energies, weights=weights)), 1e-12)
    coefficients = log_link_fit(_terms((known - middle) / spread), energies / level, weights, CAP - 1, _ROUNDS)
    return np.asarray(level * np.exp(bounded(coefficients @ _terms((asked - middle) / spread))))


def capped_means(values: np.ndarray, weights: np.ndarray, groups: np.ndarray) -> np.ndarray:
    """The mean of each group, with none counted as more than ``CAP`` times the mean; 0 for an empty one."""
    count = int(groups.max()) + 1 if len(groups) else 0
    total = np.bincount(groups, weights, count)
    total = np.where(total > 0, total, 1)
    mean = np.bincount(groups, weights * values, count) / total
    for _ in range(_ROUNDS):
        mean = np.bincount(groups, weights * np.minimum(values, CAP * mean[groups]), count) / total
    return mean


def _terms(properties: np.ndarray) -> np.ndarray:
    """1, the properties and their products, (terms, n)."""
    first, second = np.triu_indices(properties.shape[1])
    return np.vstack([np.ones(len(properties)), properties.T, (properties[:, first] * properties[:, second]).T])
