"""From the blocks of a scan to what it tells: pieces of seam, the picture of losses, polygons, worst windows."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Callable

import numpy as np
from osgeo import ogr
from scipy import ndimage

from ....imagery import messages as imagery_messages
from ....imagery.errors import CancelledError, Message
from ..following.boxes import enlarged, in_squares
from ..profile.cell_table import CellTable, MixtureTable
from ..profile.ground import LevelGround, grounds
from ..seam_cells import UNKNOWN
from . import messages
from .block_runs import NOTHING, block_scans, global_numbers
from .blocks.block_grid import BLOCK_PX, LABEL_PX, LABELS, UNITS, BlockKey
from .blocks.scan_block import CELLS, BlockScan
from .lines.seam_pieces import SeamPiece, Side, cut_in_pieces, sides_of
from .lines.seam_tracing import SourcePolygon, polygons_of, seams_of, trace_borders
from .loss_raster import loss_cells, loss_raster
from .piece_sums import PieceSums
from .scan_journal import ScanJournal
from .scan_request import ScanRequest
from .scan_result import ScanResult, judge_piece, without_verdict, worst_windows

FARTHEST_FILLED_PX = 700
"""Between samples where seamlines are given: as far as the next one."""

LEAST_UNEXPLAINED = 0.03
"""Of the mosaic, to be told."""


class Gathering:
    """Reads a journal block row by block row, so that memory does not grow with the mosaic."""

    def __init__(self, request: ScanRequest, journal: ScanJournal) -> None:
        self._request, self._journal = request, journal
        self._grid = request.blocks
        self._units = self._unexplained = 0
        self._label_type = np.int16 if len(request.sources) <= np.iinfo(np.int16).max else np.int32

    def result(self, loss_path: str, goes_on: Callable[[float], bool]) -> ScanResult | None:
        """All of it; the picture of losses is written to ``loss_path``, if that is not empty.

        ``goes_on`` takes the share that is done; where it says no the result is None. Raises RasterError when the
        picture can't be written.
        """
        request, grid = self._request, self._request.mosaic.grid
        borders = list(trace_borders(self._label_strips(lambda share: goes_on(0.2 * share)), grid, LABEL_PX))
        if not goes_on(0.2):
            return None
        pieces = list(request.pieces)
        if request.seams:
            strips = self._label_strips(lambda share: goes_on(0.2 + 0.1 * share))
            pieces = sides_of(pieces, strips, grid, LABEL_PX, request.named[0])
            if not goes_on(0.3):
                return None
        else:
            pieces = cut_in_pieces(seams_of(borders), request.settings.piece_m, grid)
        try:
            sums = self._sums(pieces, loss_path, lambda share: goes_on(0.3 + 0.5 * share))
        except CancelledError:
            return None
        judged = tuple(
            judge_piece(piece, (self._name(piece.left), self._name(piece.right)), found,
                        request.mosaic.ground_sample_distance, seen)
            for piece, found, seen in zip(pieces, sums.profiles(), sums.visibilities(request.mosaic))
        )
        polygons = given_polygons(request) or tuple(polygons_of(borders))
        worst = worst_windows(judged, request.mosaic, request.settings.worst_count, request.settings.levels)
        notices = (*self._notices(), *without_verdict(judged))
        return ScanResult(judged, polygons, tuple(worst), notices) if goes_on(1.0) else None

    def _name(self, side: Side) -> str | None:
        """Of a source as its file has it, else as the seams do."""
        if isinstance(side, str):
            number = self._request.named[0].get(side)
            return side if number is None else self._request.sources[number].ref.name
        return None if side is None else self._request.sources[side].ref.name

    def _label_strips(self, goes_on: Callable[[float], bool]) -> Iterator[np.ndarray]:
        """Rows of the whole mosaic's labels, numbers of sources, ``NOTHING`` where none is followed; as far as
        ``goes_on`` says so."""
        mosaic, half = self._request.mosaic, LABEL_PX // 2
        columns = -(-(mosaic.columns - half) // LABEL_PX)
        for row in range(self._grid.rows):
            if not goes_on(row / self._grid.rows):
                return
            strip = np.concatenate([self._labels(scan) for scan in self._row(row)], axis=1)
            rows = -(-(min(mosaic.rows - row * BLOCK_PX, BLOCK_PX) - half) // LABEL_PX)
            yield strip[:rows, :columns]

    def _row(self, row: int) -> list[BlockScan]:
        return [self._block((row, column)) for column in range(self._grid.columns)]

    def _block(self, key: BlockKey) -> BlockScan:
        found = block_scans(self._journal, key)
        if not found:
            return BlockScan.nothing(self._request.block(key), ())
        return found[0] if len(found) == 1 else both_looks(*found)

    def _labels(self, scan: BlockScan) -> np.ndarray:
        labels = scan.labels if self._request.seam_squares is None else filled(scan)
        numbers = global_numbers(scan, self._request.numbers).astype(self._label_type)
        return np.asarray(numbers[labels])

    def _sums(
        self, pieces: Sequence[SeamPiece], loss_path: str, goes_on: Callable[[float], bool]
    ) -> PieceSums:
        """Of all pieces; the picture of losses on the way. Raises CancelledError where ``goes_on`` says no."""
        mosaic, settings = self._request.mosaic, self._request.settings
        sums = PieceSums(pieces, mosaic.grid, settings.levels)
        if not loss_path:
            for _, _, scan, ground in self._blocks_on_ground():
                sums.add(scan.cells, self._mixture(scan), ground, self._grid.window(scan.key), scan.grey)
            return sums
        names: dict[int, int] = {}
        with loss_raster(loss_path, mosaic, settings.cell_px, settings.told) as raster:
            for row, column, scan, ground in self._blocks_on_ground():
                sums.add(scan.cells, self._mixture(scan), ground, self._grid.window(scan.key), scan.grey)
                labels = self._labels(scan)
                for number in np.unique(labels[labels != NOTHING]).tolist():
                    names.setdefault(number, len(names) + 1)
                table = np.zeros(len(self._request.sources) + 1, np.int32)
                table[list(names)] = list(names.values())
                raster.write(row, column, loss_cells(scan, table[labels], ground, settings.cell_px))
                if not column and not goes_on(row / self._grid.rows):
                    raise CancelledError(imagery_messages.CANCELLED())  # which leaves no picture
            raster.add_setting("seams", "given" if self._request.seams else "found")
            if (share := self._share_unexplained) is not None:
                raster.add_setting("unexplained", f"{share:.4f}")
            raster.close([self._request.sources[number].ref.name for number in names])
        return sums

    def _blocks_on_ground(self) -> Iterator[tuple[int, int, BlockScan, list[LevelGround | None]]]:
        """Every block, and what its ground makes one expect, with that of its neighbours where it has little."""
        rows: dict[int, list[BlockScan]] = {}
        for row in range(self._grid.rows):
            rows = {near: rows.get(near) or self._row(near)
                    for near in range(max(row - 1, 0), min(row + 2, self._grid.rows))}
            for column, scan in enumerate(rows[row]):
                around = [one.cells for near in rows.values() for one in near[max(column - 1, 0) : column + 2]]
                self._account(scan)
                yield row, column, scan, grounds(scan.cells, around=CellTable.joined(around))

    def _mixture(self, scan: BlockScan) -> MixtureTable:
        """With the numbers of sources that all blocks share."""
        numbers = global_numbers(scan, self._request.numbers)
        return replace(scan.beside, source=numbers[scan.beside.source], other=numbers[scan.beside.other])

    def _account(self, scan: BlockScan) -> None:
        """Count units with pixels of the mosaic, and those of them that follow no source anywhere."""
        step = LABELS // UNITS
        followed = (in_squares(scan.labels, step) != UNKNOWN).any(axis=(1, 3))
        self._units += int(np.count_nonzero(~scan.outside))
        self._unexplained += int(np.count_nonzero(~scan.outside & ~followed))

    @property
    def _share_unexplained(self) -> float | None:
        """Of the mosaic, that follows no source; None where not all of it was looked at."""
        return None if self._request.seam_squares is not None else self._unexplained / max(self._units, 1)

    def _notices(self) -> tuple[Message, ...]:
        share = self._share_unexplained
        if share is None or share < LEAST_UNEXPLAINED:
            return ()
        return (messages.MOSAIC_UNEXPLAINED(share=100 * share),)


def given_polygons(request: ScanRequest) -> tuple[SourcePolygon, ...]:
    """What the given seams say themselves of which source each part came from."""
    cells = request.given.cells if request.given else ()
    numbers, _ = request.numbers_named({one.source for one in cells})
    by_source: dict[int, ogr.Geometry] = {}
    for cell in cells:
        if cell.source in numbers:
            whole = by_source.setdefault(numbers[cell.source], ogr.Geometry(ogr.wkbMultiPolygon))
            outline = ogr.ForceToMultiPolygon(ogr.CreateGeometryFromWkb(cell.wkb))
            for number in range(outline.GetGeometryCount()):
                whole.AddGeometry(outline.GetGeometryRef(number))
    return tuple(SourcePolygon(source, bytes(by_source[source].ExportToWkb())) for source in sorted(by_source))


def filled(scan: BlockScan) -> np.ndarray:
    """Labels of a block of which only strips along its seams and some samples were looked at: what is nearest."""
    step = LABELS // UNITS
    labels = scan.labels[step // 2 :: step, step // 2 :: step]
    known = labels != UNKNOWN
    if not known.any():
        return scan.labels
    distance, (row, column) = ndimage.distance_transform_edt(~known, return_indices=True)
    nearest = np.where(distance <= FARTHEST_FILLED_PX / LABEL_PX / step, labels[row, column], UNKNOWN).astype(np.uint8)
    nearest[scan.dense | scan.outside] = UNKNOWN
    return np.where(scan.labels == UNKNOWN, enlarged(nearest, step), scan.labels)


def both_looks(first: BlockScan, second: BlockScan) -> BlockScan:
    """A block with what was looked at once more."""
    labels_px, cells_px = len(first.labels) // UNITS, len(first.mixture) // UNITS
    labels, mixture, clear, grey = (
        np.where(enlarged(second.dense, times), new, old)
        for times, new, old in (
            (labels_px, second.labels, first.labels), (cells_px, second.mixture, first.mixture),
            (cells_px, second.clear, first.clear), (cells_px, second.grey, first.grey),
        )
    )
    cells, beside = first.cells, first.beside
    replaced, was_beside = (
        second.dense[one.row % CELLS // cells_px, one.column % CELLS // cells_px] for one in (cells, beside)
    )
    return replace(
        first, labels=labels, mixture=mixture, clear=clear, grey=grey, dense=first.dense | second.dense,
        cells=CellTable.joined([cells.chosen(~replaced), second.cells]),
        beside=MixtureTable.joined([beside.chosen(~was_beside), second.beside]),
        notices=first.notices + second.notices,
    )
