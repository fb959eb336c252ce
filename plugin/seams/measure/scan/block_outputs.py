"""What a scan tells of one block as soon as it and its neighbours are measured: the borders of what it follows, what
its ground makes one expect, its part of the picture of losses."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ....imagery.errors import SettingsError
from ....imagery.messages import system_reason
from ....imagery.record_store import RecordFiles
from ....imagery.records import record_of, value_of
from .. import messages
from ..blocks.block_grid import LABEL_PX, LABELS, UNITS, BlockKey
from ..blocks.scan_block import NOT_LOOKED
from ..profile.cell_table import CellTable
from ..profile.ground import LevelGround, grounds
from ..seamlines.label_borders import MARGIN, LabelTile, cleaned_edges
from ..while_measuring import measuring
from .block_runs import NOTHING, block_labels, global_numbers, whole_block
from .loss_raster import NODATA, loss_cells
from .scan_journal import not_saved


@dataclass(frozen=True, eq=False)
class OutputsRequest:
    """All that is needed for it, in plain data that can cross threads and processes."""

    files: RecordFiles
    key: BlockKey
    tile: LabelTile
    """Its samples of the labels."""
    numbers: Mapping[str, int]
    """Numbers of the sources of it and its neighbours, by their paths."""
    cell_px: int
    """Side of the picture's cells; 0: none is wanted."""
    traces: bool
    """Whether borders are wanted."""


@dataclass(frozen=True, eq=False)
class BlockOutputs:
    """What comes back."""

    key: BlockKey
    edges: np.ndarray
    """(4, n) of its borders, as ``tile_edges`` has them."""
    cells: np.ndarray | None
    """``loss_cells``, its sources numbered from 1 on as in the whole scan; None where nothing is shown."""
    sources: Sequence[int]
    """That are followed anywhere, ascending."""
    ground: np.ndarray
    """(UNITS, UNITS) int32: as ``BlockScan`` has it, with the numbers of the whole scan."""


@dataclass(frozen=True)
class _BlockGround:
    levels: tuple[LevelGround | None, ...]


@measuring()
def block_outputs(request: OutputsRequest) -> BlockOutputs:
    """Outputs of one block; what its ground makes one expect is kept beside it. Raises SettingsError where what was
    measured can't be read any more, or nothing can be kept."""
    files, key = request.files, request.key
    scan = whole_block(files, key)
    numbers = None if scan is None else global_numbers(scan.sources, request.numbers)
    labels = None if scan is None or numbers is None else numbers[scan.labels]
    edges = np.zeros((4, 0), np.int64)
    if request.traces:
        edges = cleaned_edges(_labels_around(request, labels), request.tile, LABEL_PX)
    if scan is None or numbers is None or labels is None:
        return BlockOutputs(key, edges, None, (), np.full((UNITS, UNITS), NOT_LOOKED, np.int32))
    ground = grounds(scan.cells, lambda: CellTable.joined([scan.cells, *_cells_around(files, key)]))
    try:
        files.save(_ground_name(key), record_of(_BlockGround(tuple(ground))))
    except OSError as error:
        raise not_saved(files, system_reason(error)) from None
    cells = loss_cells(scan, labels + 1, ground, request.cell_px) if request.cell_px else None
    if cells is not None and (cells == NODATA).all():
        cells = None
    used = np.flatnonzero(np.bincount(labels.ravel() - NOTHING)[1:]).tolist()
    ground = np.where(scan.ground < 0, scan.ground, numbers[np.maximum(scan.ground, 0)])
    return BlockOutputs(key, edges, cells, used, ground)


def held_ground(files: RecordFiles, key: BlockKey) -> tuple[LevelGround | None, ...]:
    """What ``block_outputs`` kept of one block, by level; nothing where that was not measured. Raises
    SettingsError where it can't be read any more."""
    try:
        record = files.load(_ground_name(key))
    except OSError as error:
        raise SettingsError(messages.SCAN_JOURNAL_NOT_READ(path=files.folder, error=system_reason(error))) from None
    return () if record is None else value_of(_BlockGround, record, {}).levels


def _labels_around(request: OutputsRequest, own: np.ndarray | None) -> np.ndarray:
    """Labels of the block, ``own``, and of as much of its neighbours as cleaning has to know."""
    place = request.tile.around(MARGIN)
    found = np.full([one.stop - one.start for one in place], NOTHING, np.int32)
    first, last = ([edge // LABELS for edge in edges] for edges in zip(*((one.start, one.stop - 1) for one in place)))
    for row in range(first[0], last[0] + 1):
        for column in range(first[1], last[1] + 1):
            ours, theirs = zip(*(
                (slice(max(start, one.start) - one.start, min(start + LABELS, one.stop) - one.start),
                 slice(max(start, one.start) - start, min(start + LABELS, one.stop) - start))
                for start, one in zip((row * LABELS, column * LABELS), place)
            ))
            if (row, column) == request.key:
                labels = None if own is None else own[theirs]
            else:
                labels = block_labels(request.files, (row, column), request.numbers, theirs)
            if labels is not None:
                found[ours] = labels
    return found


def _cells_around(files: RecordFiles, key: BlockKey) -> list[CellTable]:
    """Cells of the neighbours that were measured."""
    row, column = key
    near = [(row + down, column + across) for down in (-1, 0, 1) for across in (-1, 0, 1) if down or across]
    scans = [whole_block(files, one) for one in near]
    return [scan.cells for scan in scans if scan is not None]


def _ground_name(key: BlockKey) -> str:
    return f"ground {key[0]} {key[1]}"
