"""What is to be scanned: a mosaic, its orthoimages, its seams."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Callable

import numpy as np

from ....imagery import limits as imagery_limits
from ....imagery.errors import Message, RasterError, SeamsElsewhereError, SettingsError
from ....imagery.grids import PixelWindow, covered_share
from ....imagery.lines import vertex_stations
from ....imagery.open_raster import OpenRaster, check_readable
from ....imagery.rasters import Raster, RasterRef
from .. import messages
from ..blocks.block_grid import UNIT_PX, UNITS, BlockGrid, BlockKey, ScanSettings, blocks_near, place_of, units_along
from ..blocks.scan_block import REACH_PX, BlockRequest
from ..profile.seam_profile import LEAST_SEAM_PX
from ..seam_cells import UNKNOWN, names_apart
from ..seamlines import seam_pieces
from ..seamlines.given_seams import GivenSeams
from ..seamlines.seam_features import source_numbers
from ..seamlines.seam_pieces import PieceIndex, SeamPiece, Side, SidedSeam
from ..source_images import Footprints, Source, whole_images

SHORTEST_PIECE_PX = 1.25 * LEAST_SEAM_PX
"""Shortest piece that can be asked for, as pieces may be shorter than that."""
LEAST_BETWEEN = 0.5
"""Least share of the given seams on two sources or more; with less the mosaic is scanned as one without orthoimages."""
_STEP_PX = 4  # between the places of a seam that are looked at, and the pixels that are read
_ASIDE_PX = 8.0  # to either side: farther than an outline lies off the pixels that it was drawn around
_SHORTEST_PX = 64.0  # beside holes that are shorter a seam goes on
_BLOCK_CELLS = 128  # along a side, each of such a step, that are read at once: a tile or some


@dataclass(frozen=True, eq=False)
class ScanRequest:
    """A mosaic that is to be scanned."""

    mosaic: Raster
    sources: tuple[Source, ...]
    settings: ScanSettings
    given: GivenSeams | None = None
    """Seams that are given; without them they are found from what is followed."""
    counted: PixelWindow | None = None
    """Pixels of the mosaic whose seams and ground are counted; None: all of it."""

    def counts(self, piece: SeamPiece) -> bool:
        """Whether the middle of a piece lies where seams are counted."""
        if self.counted is None:
            return True
        x, y = piece.middle
        column, row = self.mosaic.grid.column_at(x) - self.counted.column, self.mosaic.grid.row_at(y) - self.counted.row
        return 0 <= column < self.counted.width and 0 <= row < self.counted.height

    @property
    def blocks(self) -> BlockGrid:
        """How it is divided."""
        return BlockGrid(self.mosaic.grid)

    @property
    def seams(self) -> tuple[SidedSeam, ...]:
        """Seams that are given."""
        return self.given.seams if self.given else ()

    @cached_property
    def pieces(self) -> list[SeamPiece]:
        """Pieces of the seams that are given."""
        return seam_pieces.cut_in_pieces(self.seams, self.settings.piece_m, self.mosaic.grid)

    @cached_property
    def named(self) -> tuple[dict[str, int], Message | None]:
        """Numbers of the sources by what the seams call them, and which names mean none."""
        return self.numbers_named(self._names)

    @property
    def not_given(self) -> list[str]:
        """What the seams call sources that are not among those given."""
        return sorted(self._names - self.named[0].keys())

    @property
    def _names(self) -> set[str]:
        return {name for seam in self.seams for name in (seam.left, seam.right) if name and isinstance(name, str)}

    def numbers_named(self, names: Iterable[str]) -> tuple[dict[str, int], Message | None]:
        """Numbers of the sources that names mean, those of their parts, too; and which names mean none."""
        return source_numbers(names, [source.ref.paths for source in self.sources])

    @cached_property
    def source_names(self) -> list[str]:
        """What the sources are called in the results."""
        return names_apart([source.ref.path for source in self.sources])

    @cached_property
    def dates(self) -> dict[str, str]:
        """When sources were taken, as far as the seams say, by the names of their files and by those in the seams."""
        given = self.given.dates if self.given else {}
        numbers, _ = self.numbers_named(given)
        return {**given, **{self.source_names[number]: given[name] for name, number in numbers.items()}}

    @cached_property
    def footprints(self) -> Footprints:
        """Footprints of the sources."""
        return Footprints(self.sources)

    @cached_property
    def _along_seams(self) -> np.ndarray | None:
        """Units that the given seams call for, (rows, columns) bool of all blocks; None without them."""
        return None if self.given is None else units_along(self.seams, self.blocks)

    def keys(self) -> list[BlockKey]:
        """Keys of the blocks that are read: all of them, or those in the corridor of given seams."""
        reach = self.settings.corridor_m / self.mosaic.ground_sample_distance / UNIT_PX
        along = self._along_seams
        return list(self.blocks) if along is None or not reach else blocks_near(along, self.blocks, reach)

    def block(self, key: BlockKey) -> BlockRequest:
        """One of its blocks."""
        window = self.blocks.window(key)
        extent = self.mosaic.grid.window_extent(window)
        # As many sources as can be told apart: those that cover most of it.
        covering = sorted(
            self.footprints.meeting(extent), key=lambda number: -covered_share(extent, self.sources[number].extent)
        )
        numbers = sorted(covering[:UNKNOWN])
        refs = tuple(self.sources[number].ref for number in numbers)
        request = BlockRequest(self.mosaic, refs, key, window, self.settings, numbers=tuple(numbers))
        if self._along_seams is None:
            return request
        near, named = self._index.near(window, REACH_PX), self.named[0]

        def place(name: Side) -> int | None:
            number = named.get(name) if isinstance(name, str) else None
            return numbers.index(number) if number in numbers else None

        pieces = ((number, self.pieces[number]) for number in near.numbers.tolist())
        beside = {number: (place(piece.left), place(piece.right)) for number, piece in pieces}
        along_seams = self._along_seams[place_of(key, UNITS)]
        return replace(request, along_seams=along_seams, pieces=near, beside=beside)

    @cached_property
    def _index(self) -> PieceIndex:
        """The given seams by place."""
        return PieceIndex(self.pieces, self.mosaic.grid)


def _check_readable(refs: Iterable[RasterRef], not_read: Callable[[Message], Message]) -> None:
    """Raises RasterError, which ``not_read`` says, where none of some rasters can be read; why the first can't."""
    why: Message | None = None
    for ref in refs:
        try:
            check_readable(OpenRaster(ref))
            return
        except RasterError as error:
            why = why or error.message
    if why is not None:
        raise RasterError(not_read(why))


def parting_seams(given: GivenSeams, numbers: Mapping[str, int], mosaic: OpenRaster) -> tuple[SidedSeam, ...]:
    """The given seams that part two orthoimages, ``numbers`` by their names, as far as the mosaic has pixels on both
    sides or on none: what runs along the border of its pixels is an outline. Raises SeamsElsewhereError without any.
    """
    parting: list[SidedSeam] = []
    for seam in given.seams:
        left, right = (numbers.get(side, side) if isinstance(side, str) else side for side in (seam.left, seam.right))
        is_date = isinstance(left, str) and given.dates.get(left) == left
        # Not where one orthoimage lies on both sides, by whichever names; two of one day are two.
        if left is None or left != right or is_date:
            parting += _off_border(seam, mosaic)
    if not parting:
        raise SeamsElsewhereError(messages.SEAMS_PART_NOTHING())
    return tuple(parting)


def _off_border(seam: SidedSeam, mosaic: OpenRaster) -> Iterator[SidedSeam]:
    if seam.left is not None and seam.right is not None:
        yield seam
        return
    path = mosaic.raster.grid.to_pixels(seam.vertices)
    along = vertex_stations(path)
    stations = np.linspace(0, along[-1], int(along[-1] / _STEP_PX) + 2)
    sides = seam_pieces.points_beside(path, along, stations, (_ASIDE_PX,))
    left, right = (_has_pixels(mosaic, side[:, 0]) for side in sides)
    on_border = np.flatnonzero(np.diff(np.concatenate([[False], left != right, [False]])))
    first, last = stations[on_border[::2]], stations[on_border[1::2] - 1]
    long = last - first >= min(_SHORTEST_PX, along[-1] / 2)
    if not long.any():
        yield seam
        return
    cuts = np.concatenate([[0.0], np.column_stack([first, last])[long].ravel(), along[-1:]])
    for number, vertices in enumerate(seam_pieces.cut_at(seam.vertices, along, cuts)):
        if number % 2 == 0 and cuts[number + 1] - cuts[number] > 2 * _ASIDE_PX:
            yield replace(seam, vertices=vertices)


def _has_pixels(mosaic: OpenRaster, places: np.ndarray) -> np.ndarray:
    """Whether the mosaic has pixels at columns and rows, (n, 2); what can't be read counts as some."""
    size = np.array([mosaic.columns, mosaic.rows])
    has_pixels = ((places >= 0) & (places < size)).all(axis=1)
    can_lack = mosaic.roles.alpha is not None
    if not can_lack and mosaic.is_all_valid and not mosaic.raster.data_type.startswith("float"):
        return np.asarray(has_pixels)
    cell = np.floor(places / _STEP_PX).astype(np.int64)
    block = np.where(has_pixels[:, np.newaxis], cell // _BLOCK_CELLS, -1)
    for key in np.unique(block[has_pixels], axis=0):
        here = (block == key).all(axis=1)
        left, top = (key * _BLOCK_CELLS * _STEP_PX).tolist()
        wide, high = (min(_BLOCK_CELLS * _STEP_PX, end) for end in (mosaic.columns - left, mosaic.rows - top))
        with suppress(RasterError):
            valid = mosaic.thinned(PixelWindow(left, top, wide, high), _STEP_PX).valid
            column, row = (cell[here] - key * _BLOCK_CELLS).T
            has_pixels[here] = valid[row.clip(max=len(valid) - 1), column.clip(max=valid.shape[1] - 1)]
    return np.asarray(has_pixels)


def scan_request(
    mosaic: Raster, sources: Sequence[Source], settings: ScanSettings, given: GivenSeams | None = None
) -> tuple[ScanRequest, list[Message]]:
    """A mosaic with the sources that can tell something of it, and what to tell of the others and of the seams.

    Raises SettingsError when a setting is out of its range, there are neither sources nor seams, no source lies on
    the mosaic, or that is too small; RasterError when nothing of the mosaic or no source can be read.
    """
    settings.check()
    if not sources and given is None:
        raise SettingsError(messages.NEITHER_SOURCES_NOR_SEAMS())
    if min(mosaic.columns, mosaic.rows) < imagery_limits.MIN_SIDE_PX:
        raise SettingsError(messages.SCAN_MOSAIC_TOO_SMALL(
            width=mosaic.columns, height=mosaic.rows, fewest=imagery_limits.MIN_SIDE_PX
        ))
    kept, notices = whole_images(mosaic, sources)
    needed = SHORTEST_PIECE_PX * mosaic.ground_sample_distance
    if settings.piece_m < needed:
        settings = replace(settings, piece_m=needed)
        notices.append(messages.PIECES_LENGTHENED(needed=needed))
    if settings.corridor_m and given is None:
        notices.append(messages.CORRIDOR_WITHOUT_SEAMS())
    request = ScanRequest(mosaic, tuple(kept), settings, given)
    meeting = [request.sources[number].ref for number in request.footprints.meeting(mosaic.extent)]
    if kept and not meeting:
        raise SettingsError(messages.NO_SOURCE_ON_MOSAIC(count=len(kept)))
    _check_readable([mosaic.ref], lambda why: messages.MOSAIC_NOT_READ(name=mosaic.ref.name, why=why))
    _check_readable(meeting, lambda why: messages.SOURCES_NOT_READ(why=why))
    if given is not None and given.seams:
        seams = parting_seams(given, request.named[0], OpenRaster(mosaic.ref))
        request = replace(request, given=replace(given, seams=seams))
    if kept and given is not None:
        seams_m = sum(piece.length_m for piece in request.pieces)
        # On two sources or more, without which nothing can be told of a seam.
        places = [(piece.length_m, *(piece.vertices[:2].sum(axis=0) / 2).tolist()) for piece in request.pieces]
        between = sum(length for length, x, y in places if len(request.footprints.meeting((x, y, x, y))) > 1)
        if between < LEAST_BETWEEN * seams_m:
            notices.append(messages.SOURCES_TOO_FEW(between=between, all=seams_m))
            request = replace(request, sources=())
    if given is not None:
        outside = seam_pieces.cut_off(given.seams, request.pieces, mosaic.grid)
        unnamed = request.named[1] if request.sources else None
        notices = [*notices, *given.notices, *(notice for notice in (outside, unnamed) if notice is not None)]
    return request, notices
