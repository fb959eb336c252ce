"""All blocks of a mosaic, measured by an executor, each once whatever happens to the run.

Who measures a block keeps it in a file of its own and returns what little the process that hands out the blocks has to
know; a block that an earlier run has kept is only looked at. So a scan that was stopped in any way goes on where it
was, as long as what decides on its result is the same, which a fingerprint tells.
"""
from __future__ import annotations

import math
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from functools import cached_property, partial
from hashlib import blake2b
from itertools import chain
from operator import attrgetter
from pathlib import Path
from typing import Any, Callable

import numpy as np

from ....imagery import messages as imagery_messages
from ....imagery.atomic_files import drop_unfinished
from ....imagery.documents import plugin_version
from ....imagery.errors import Message, SettingsError
from ....imagery.file_identity import FileState, known_states, local_states, states_text
from ....imagery.gdal_paths import is_remote
from ....imagery.messages import system_reason
from ....imagery.rasters import Raster
from ....imagery.records import NotUnderstoodError, RecordFiles, RecordFolder, record_of, sentences_of, value_of
from ....imagery.seam_totals import MOSAIC_FILES, SOURCE_FILES
from .. import messages
from ..blocks.block_grid import SQUARES, UNITS, BlockKey, place_of
from ..blocks.block_pixels import ALL_READ, BlockReading
from ..blocks.scan_block import CELLS, BlockRequest, BlockScan, called_for, scan_block
from ..following.boxes import enlarged
from ..profile.cell_table import CellTable, MixtureTable
from ..seam_cells import NONE, UNKNOWN
from ..source_images import Source
from ..workers import Workers, in_order, unforeseen
from .scan_request import ScanRequest

MOST_ASKED = 20  # remote sources whose server is asked for size and date; more would take seconds before a scan starts


@dataclass(frozen=True, eq=False)
class ScanInputs:
    """The files of a mosaic and of its orthoimages, as they are before they are read.

    Local files by path, size, time of change and bytes, those that a VRT or an archive is made of too; no remote source
    is opened. The remote mosaic, and up to ``MOST_ASKED`` remote sources, by what their server says of them;
    more by their names.
    """

    mosaic: Raster
    sources: Sequence[Source]

    @property
    def _paths(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        return self.mosaic.ref.paths, tuple(path for source in self.sources for path in source.ref.paths)

    @cached_property
    def _states(self) -> tuple[Mapping[str, FileState], Mapping[str, FileState]]:
        of_mosaic, of_sources = self._paths
        return known_states(of_mosaic), known_states(of_sources, sum(map(is_remote, of_sources)) <= MOST_ASKED)

    def fingerprint(self, settings: Any, seams: Iterable[object] = ()) -> str:
        """Fingerprint that is the same as long as the result of a scan would be: a digest of all its inputs.

        ``settings``: a dataclass of numbers and texts; ``seams``: arrays, texts, numbers or bytes.
        """
        ref, files = self.mosaic.ref, zip(self._paths, self._states)
        digest = blake2b(digest_size=12)
        for item in (
            plugin_version(), *((paths, *states.items()) for paths, states in files),
            ref.wkt, ref.nodata, self.mosaic.geotransform, self.mosaic.wkt,
            *((source.ref.wkt, source.ref.nodata, source.extent) for source in self.sources), settings, *seams,
        ):  # texts that do not depend on the process
            value = (item.dtype.str, item.shape, item.tobytes()) if isinstance(item, np.ndarray) else item
            digest.update(f"{value!r}\n".encode())
        return digest.hexdigest()

    def check(self) -> None:
        """Raise SettingsError where a raster has changed meanwhile."""
        now = local_states(chain(*self._paths))
        for path, state in chain(*(states.items() for states in self._states)):
            if now.get(path, state) != state:  # of one that is gone blocks have told
                raise SettingsError(messages.SCAN_INPUT_CHANGED(name=Path(path).name))

    @property
    def told(self) -> dict[str, str]:
        """What layers say of them."""
        of_mosaic, of_sources = self._states
        return {MOSAIC_FILES: states_text(of_mosaic.items()), SOURCE_FILES: states_text(of_sources.items())}


_KIND = "Seam Inspector: journal of a scan"


@contextmanager
def journal_beside(output: Path, ending: str, fingerprint: str) -> Iterator[tuple[RecordFolder, Message | None]]:
    """The journal beside an output, for this run alone, and what became of an earlier run. What was killed while it
    wrote the output leaves nothing.

    Raises SettingsError as ``open_journal`` does.
    """
    journal, notice = open_journal(output.with_name(output.name + ending), fingerprint)
    try:
        drop_unfinished(output)
        yield journal, notice
    finally:
        journal.close()


def open_journal(path: Path, fingerprint: str) -> tuple[RecordFolder, Message | None]:
    """The journal in a folder, for this scan alone, of what it has measured so far, and what the user should know of an
    earlier one there. What is measured outlives the process; what was written last may be lost with the power.

    An earlier scan of the same ``fingerprint`` goes on. Of another fingerprint nothing is kept.

    Raises SettingsError where no folder can be, another scan has it, or it is something else.
    """
    try:
        journal = RecordFolder(path, _KIND, fingerprint)
    except (OSError, SettingsError) as error:
        why = error.message if isinstance(error, SettingsError) else system_reason(error)
        raise SettingsError(imagery_messages.FILE_NOT_WRITTEN(path=path, error=why)) from None
    if journal.was_of is not None and journal.was_of != fingerprint:
        return journal, messages.SCAN_ANEW()
    done = len(journal.files.names)
    return journal, messages.GOES_ON(done=done) if done else None


def save(files: RecordFiles, name: str, payload: bytes) -> None:
    """Keep something. Raises SettingsError on a full disk; what was saved stays."""
    try:
        files.save(name, payload)
    except OSError as error:
        raise not_saved(files, system_reason(error)) from None


def not_saved(files: RecordFiles, reason: Message | str) -> SettingsError:
    """Why something could not be kept."""
    return SettingsError(messages.SCAN_JOURNAL_NOT_SAVED(path=files.folder, error=reason, done=len(files.names)))


_AS_WELL, _LEAST_LEFT = 1.3, 0.002
"""Times the least share that a source leaves over in any block, and what rounding makes of it: as well explained. Under
JPEG, blocks with wide feathers leave over 1.4 times as much as others, and more."""
_FEWEST_TIMED = 3  # blocks before an estimate of the time left is honest

# No type parameters: typing keeps classes that have some for as long as Python runs, and with them the whole plugin.
Request = Any
"""Has the ``key`` of its block."""
Scan = Any
"""Has the ``key`` of its block, its ``reading``, and ``notices``: what could not be read, which the block lacks until a
later run measures it anew."""


@dataclass(frozen=True)
class BlockLook:
    """One kind of measurement of blocks."""

    name: str
    """Name of its files."""
    measure: Callable[[Request], Scan]
    nothing: Callable[[Request, tuple[Message, ...]], Scan]
    """The result where nothing could be measured, and why."""
    kind: type
    """Class of its results."""
    brief: Callable[[Scan], Any] = attrgetter("key")
    """What has to be known of it to hand out more blocks."""


@dataclass(frozen=True, eq=False)
class ScanStep:
    """One block more is done."""

    key: BlockKey
    brief: Any
    notices: tuple[Message, ...] = ()
    """What could not be read in it."""
    reading: BlockReading = ALL_READ
    was_held: bool = False
    """Whether an earlier run has measured it."""
    record: bytes | None = None
    """All of it, where who measured it doesn't see the folder to keep it in."""
    trouble: Message | str = ""
    """Why it could not be kept."""
    share: float = 0.0
    """Share of all blocks that is done, 0 to 1."""
    seconds_left: float | None = None
    """At the pace so far; None before that is known."""


class JournaledBlocks:
    """Has blocks measured that a journal doesn't hold yet; knows how much is done, and how long the rest will take."""

    def __init__(self, journal: RecordFolder, workers: Workers) -> None:
        self._journal, self._workers = journal, workers
        self._total = self._done = self._timed = 0
        self._started = time.monotonic()

    def steps(
        self, look: BlockLook, keys: Sequence[BlockKey], request: Callable[[BlockKey], Request]
    ) -> Iterator[ScanStep]:
        """The blocks as they are measured, or were by an earlier run."""
        files = self._journal.files
        self._total += len(keys)
        measure, failed = partial(_looked_at, look, files), partial(_without, look, files)
        for block in in_order(map(request, keys), measure, failed, self._workers, self._workers.together):
            if block.trouble:
                raise not_saved(files, block.trouble)
            if block.record is not None:
                self._journal.is_shared = False
                save(files, _name(look, block.key), block.record)
            self._done += 1
            self._timed += not block.was_held
            if block.was_held:  # by an earlier run, which began with the same blocks
                self._started = time.monotonic()
            seconds_left = None
            if self._timed >= _FEWEST_TIMED:
                seconds_left = (time.monotonic() - self._started) / self._timed * (self._total - self._done)
            yield replace(block, record=None, share=self._done / self._total, seconds_left=seconds_left)


def _looked_at(look: BlockLook, files: RecordFiles, request: Request) -> ScanStep:
    scan = None
    with suppress(SettingsError):  # damaged: it is measured again
        scan = held(look, files, request.key)
    if scan is not None and not scan.notices:  # which say what it lacks
        return ScanStep(scan.key, look.brief(scan), was_held=True)
    try:
        scan = look.measure(request)
    except Exception as error:  # which costs this block only
        return _without(look, files, request, unforeseen(error))
    return _kept(look, files, scan)


def _without(look: BlockLook, files: RecordFiles, request: Request, reason: Message) -> ScanStep:
    """A step of a block of which the measuring failed in a way that nobody foresaw."""
    return _kept(look, files, look.nothing(request, (reason.as_warning(),)))


def _kept(look: BlockLook, files: RecordFiles, scan: Scan) -> ScanStep:
    record = record_of(scan, exact=True)
    step = ScanStep(scan.key, look.brief(scan), scan.notices, scan.reading)
    try:
        files.save(_name(look, scan.key), record)
    except FileNotFoundError:
        return replace(step, record=record)
    except OSError as error:
        return replace(step, trouble=system_reason(error))
    return step


def held(look: BlockLook, files: RecordFiles, key: BlockKey) -> Any:
    """The scan that was kept of one block; None where there is none. Raises SettingsError where it can't be read any
    more; it is then forgotten, and measured again when the scan is started again."""
    name = _name(look, key)
    try:
        record = files.load(name)
        return None if record is None else value_of(look.kind, record, sentences_of(imagery_messages, messages))
    except (OSError, NotUnderstoodError) as error:
        files.forget(name)
        why = system_reason(error) if isinstance(error, OSError) else str(error)
        raise SettingsError(messages.SCAN_JOURNAL_NOT_READ(path=files.folder, error=why)) from None


def _name(look: BlockLook, key: BlockKey) -> str:
    return f"{look.name} {key[0]} {key[1]}"


class BlockRun:
    """Measures the blocks that a journal doesn't hold yet."""

    def __init__(self, request: ScanRequest, journal: RecordFolder) -> None:
        self._request, self._journal = request, journal
        blocks = request.blocks
        self._squares = np.full((blocks.rows * SQUARES + 2, blocks.columns * SQUARES + 2), NONE, np.int32)
        self._wanted = np.zeros((blocks.rows * UNITS, blocks.columns * UNITS), bool)
        self._known: dict[int, dict[BlockKey, tuple[float, np.ndarray]]] = {}
        """The share that a source leaves over, and its filter, in each block that tells what came over it."""

    def steps(self, workers: Workers) -> Iterator[ScanStep]:
        """First the patches of every block; then its seams, by what all blocks tell of their sources."""
        blocks, keys, squares = JournaledBlocks(self._journal, workers), self._request.keys(), self._squares[1:-1, 1:-1]
        for step in blocks.steps(FIRST_LOOK, keys, self._request.block):
            sources, followed, wanted, learned = step.brief
            numbers = global_numbers(sources)
            squares[place_of(step.key, SQUARES)] = numbers[followed]
            self._wanted[place_of(step.key, UNITS)] = wanted
            for place, taps in learned.taps.items():
                self._known.setdefault(int(numbers[place]), {})[step.key] = learned.left_over[place], taps
            yield step
        if not workers.cancelled():
            # And at the borders of blocks what only neighbours together show.
            self._wanted |= called_for(squares, NONE, pairs=range(SQUARES - 1, max(squares.shape), SQUARES))
            second = [key for key in keys if self._wanted[place_of(key, UNITS)].any()]
            yield from blocks.steps(SECOND_LOOK, second, self._looked_at_again)

    def _looked_at_again(self, key: BlockKey) -> BlockRequest:
        request, (rows, columns) = self._request.block(key), place_of(key, SQUARES)
        around = self._squares[rows.start : rows.stop + 2, columns.start : columns.stop + 2]
        followed, taps = np.full(around.shape, UNKNOWN, np.uint8), {}
        for place, number in enumerate(request.numbers):
            followed[around == number] = place
            if (nearest := self._taps(key, number)) is not None:
                taps[place] = nearest
        return replace(request, wanted=self._wanted[place_of(key, UNITS)], taps=taps, followed=followed)

    def _taps(self, key: BlockKey, number: int) -> np.ndarray | None:
        """The filter of a source near a block: of the nearest one that explains its ground about as well as any does,
        since what was done to a part of it, and what is mixed there, is no filter of the source's."""
        known = self._known.get(number)
        if not known:
            return None
        most = _AS_WELL * min(left_over for left_over, _ in known.values()) + _LEAST_LEFT
        good = (block for block, (left_over, _) in known.items() if left_over <= most)
        return known[min(good, key=lambda block: (math.dist(key, block), block))][1]


SECOND_LOOK = BlockLook("border", scan_block, BlockScan.nothing, BlockScan)
FIRST_LOOK = replace(SECOND_LOOK, name="block", brief=attrgetter("sources", "squares", "wanted", "learned"))


def whole_block(files: RecordFiles, key: BlockKey) -> BlockScan | None:
    """What was measured of one block by both looks, its sources by their numbers in the whole scan, int32, ``NONE``
    where none is followed; None where nothing was. Raises SettingsError as ``held`` does."""
    first, second = (held(look, files, key) for look in (FIRST_LOOK, SECOND_LOOK))
    if first is None:
        return None
    scan: BlockScan = first if second is None else both_looks(first, second)
    numbers, beside = global_numbers(scan.sources), scan.beside
    return replace(
        scan, labels=numbers[scan.labels], beside=replace(
            beside, source=numbers[beside.source], other=numbers[beside.other]
        ),
        ground=np.where(scan.ground < 0, scan.ground, numbers[np.maximum(scan.ground, 0)]),
    )


def global_numbers(sources: Sequence[int]) -> np.ndarray:
    """(256,) int32: the number in the whole scan of each source of a block; ``NONE`` for ``UNKNOWN``."""
    by_label = np.full(UNKNOWN + 1, NONE, np.int32)
    by_label[: len(sources)] = sources
    return by_label


def both_looks(first: BlockScan, second: BlockScan) -> BlockScan:
    """A block with what was looked at once more."""

    def merged(name: str) -> np.ndarray:
        old, new = getattr(first, name), getattr(second, name)
        return np.where(enlarged(second.dense, len(old) // UNITS), new, old)

    per_unit = CELLS // UNITS
    cells, beside = first.cells, first.beside
    was_cell, was_beside = (
        second.dense[table.row % CELLS // per_unit, table.column % CELLS // per_unit] for table in (cells, beside)
    )
    return replace(
        first, **{name: merged(name) for name in ("labels", "mixture", "grey", "grain", "ground")},
        dense=first.dense | second.dense, cells=CellTable.joined([cells.chosen(~was_cell), second.cells]),
        beside=MixtureTable.joined([beside.chosen(~was_beside), second.beside]), notices=first.notices + second.notices,
    )
