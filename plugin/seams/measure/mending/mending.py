"""Failed seams of a whole mosaic: request -> runs cut anew, their patches as files, and what a scan says of them.

A scan's journal keeps what is made, so that a run that was stopped in any way goes on where it was.
"""
from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Callable

import numpy as np

from ....imagery import messages as imagery_messages
from ....imagery.errors import CancelledError, Message, SettingsError
from ....imagery.messages import system_reason
from ....imagery.raster_pool import rasters_kept
from ....imagery.rasters import Raster
from ....imagery.records import Column, record_of, sentences_of, value_of
from ..scan.block_runs import BlockLook, JournaledBlocks, ScanStep, held
from ..scan.lines.given_seams import GivenSeams
from ..scan.lines.piece_index import PieceIndex
from ..scan.lines.seam_pieces import SidedSeam
from ..scan.scan_journal import ScanJournal, fingerprint_of, open_journal
from ..scan.scan_request import ScanRequest
from ..scan.scan_settings import ScanSettings
from ..scan.whole_scan import whole_scan
from ..source_images import Source
from . import messages
from .failed_runs import ScannedPiece, SeamRun, seam_runs
from .mend_run import GROUNDS_PX, MendedRun, MendSettings, RunRequest, mend_run, not_mended
from .mended_mosaic import PlacedPatch, joined_patches, open_mosaic, write_mended, write_patch

MENDED_KEPT = 0.9
"""kept_1 of a seam that counts as mended: less is the band of a seam profile."""
MENDED, IMPROVED, LEFT = "mended", "improved", "left"
"""What became of a run: it keeps that much; it keeps more than before; it stays as it was."""
JOURNAL_ENDING = ".mend"
_WIDEST_PX = 800.0  # of a corridor on either side, so that memory does not grow with it
_PATCHED = 0.6  # of the time; the rest is to measure what was made
_CORRIDOR_PX = 64.0
_ONE_PIECE_M = 1e9


@dataclass(frozen=True, eq=False)
class MendRequest:
    """Seams that are to be cut anew."""

    mosaic: Raster
    sources: tuple[Source, ...]
    pieces: tuple[ScannedPiece, ...]
    """All pieces of seam of the mosaic, none of them a ring."""
    settings: MendSettings

    @cached_property
    def scan(self) -> ScanRequest:
        """Of the mosaic, for what the names of sources mean."""
        return ScanRequest(self.mosaic, self.sources, ScanSettings())

    @cached_property
    def numbers(self) -> dict[str, int]:
        """Of the sources by what the pieces call them."""
        names = {str(side) for one in self.pieces for side in (one.piece.left, one.piece.right)}
        return self.scan.numbers_named(names)[0]

    @cached_property
    def runs(self) -> tuple[list[SeamRun], float]:
        """What is cut anew, and the metres whose orthoimages are not known."""
        return seam_runs(self.pieces, self.settings.what, self.numbers, self.mosaic.ground_sample_distance)

    @cached_property
    def index(self) -> PieceIndex:
        """All pieces by place."""
        return PieceIndex([one.piece for one in self.pieces], self.mosaic.grid)

    def run(self, key: tuple[int, int]) -> RunRequest:
        """One of them, by its number."""
        run = self.runs[0][key[0]]
        reach = min(self.settings.width_m / self.mosaic.ground_sample_distance, _WIDEST_PX)
        window = run.window(self.mosaic.grid)
        near = self.index.near(window, 2 * _WIDEST_PX)
        beside = [self.pieces[number].piece for number in self.index.near(window, GROUNDS_PX[0]).numbers.tolist()]
        named = [self.numbers.get(str(side)) for piece in beside for side in (piece.left, piece.right)]
        order = dict.fromkeys([*run.sides, *(number for number in named if number is not None)])
        sources = tuple(self.sources[number] for number in order)
        return RunRequest(key, self.mosaic, sources, run, near, reach, self.settings)


@dataclass(frozen=True, eq=False)
class MendedSeam:
    """One run with what became of it."""

    run: SeamRun
    cut: MendedRun
    outcome: str
    """``MENDED``, ``IMPROVED`` or ``LEFT``."""
    kept: float | None = None
    """kept_1 along the new cut; None where it was not measured."""
    reason: Message | None = None
    """Why it stays as it was."""
    patch: str = ""
    """The file of its patch."""

    @property
    def vertices(self) -> np.ndarray:
        """(n, 2) map units: the seam as it runs now."""
        return self.run.piece.vertices if self.cut.vertices is None or self.outcome == LEFT else self.cut.vertices


CUT_COLUMNS: tuple[Column[MendedSeam], ...] = (
    Column("seam_id", "integer", lambda one: one.run.piece.seam_id),
    Column("station", "real", lambda one: one.run.piece.station_m),
    Column("left_source", "text", lambda one: one.run.piece.left),
    Column("right_source", "text", lambda one: one.run.piece.right),
    Column("length", "real", lambda one: one.run.piece.length_m),
    Column("kept_before", "real", lambda one: one.run.kept),
    Column("kept_after", "real", lambda one: one.kept),
    Column("step_before", "real", lambda one: one.cut.steps[0]),
    Column("step_after", "real", lambda one: one.cut.steps[1]),
    Column("misfit", "real", lambda one: one.cut.misfit),
    Column("outcome", "text", lambda one: one.outcome),
    Column("reason", "text", lambda one: one.reason),
    Column("patch", "text", lambda one: os.path.basename(one.patch)),
)
"""CUTS: one line per run."""


def metres(seams: Sequence[MendedSeam], *outcomes: str) -> float:
    """Length of those that ended so, or of all."""
    return sum((one.run.piece.length_m for one in seams if not outcomes or one.outcome in outcomes), 0.0)


class Mending:
    """One mending, which may have begun in an earlier run of the program."""

    def __init__(self, request: MendRequest, journal: ScanJournal) -> None:
        self.request, self._journal = request, journal

    @property
    def done(self) -> int:
        """Runs that an earlier one has cut already."""
        return len(self._journal.files.names)

    def steps(self, executor: Executor, ahead: int, cancelled: Callable[[], bool]) -> Iterator[ScanStep]:
        """Cuts all runs anew."""
        keys = [(number, 0) for number in range(len(self.request.runs[0]))]
        with rasters_kept():
            yield from JournaledBlocks(self._journal, executor, ahead, cancelled).steps(_LOOK, keys, self.request.run)

    def result(
        self, patches: str, mended: str, goes_on: Callable[[float], bool], executor: Executor, ahead: int
    ) -> list[MendedSeam]:
        """Writes the patches and the mended mosaic, measures the new cuts, and takes out what is no better.

        ``patches``: a folder, or a GeoTIFF for all of them. Raises SettingsError or RasterError where they can't be
        written, CancelledError when ``goes_on`` says no.
        """
        single = patches.lower().endswith((".tif", ".tiff"))
        with tempfile.TemporaryDirectory() as own, rasters_kept():
            folder = Path(own if single else patches)
            _make_folder(folder)
            placed = dict(self._written(folder))
            write_mended(mended, self.request.mosaic, list(placed.values()))
            seams = self._judged(placed, self._measured(mended, placed, goes_on, executor, ahead))
            better = [placed[number] for number, one in enumerate(seams) if one.outcome != LEFT]
            for number, one in enumerate(seams):
                if one.outcome == LEFT and number in placed:
                    os.unlink(placed[number].path)
            if single:
                better = [joined_patches(patches, self.request.mosaic, better)] if better else []
            write_mended(mended, self.request.mosaic, better)
        return seams

    def _written(self, folder: Path) -> Iterator[tuple[int, PlacedPatch]]:
        refs = [self.request.mosaic.ref, *(one.ref for one in self.request.sources)]
        inputs = {os.path.realpath(one.path) for one in refs}
        for number, cut in enumerate(self._cuts):
            path = str(folder / f"patch_{number + 1:04d}.tif")
            if cut.window is None:
                continue
            if os.path.realpath(path) in inputs:
                raise SettingsError(messages.PATCH_IS_INPUT(path=path))
            whole = self._cut(number)
            assert whole.pixels is not None
            assert whole.inside is not None
            yield number, write_patch(path, self.request.mosaic, cut.window, whole.pixels, whole.inside)

    @cached_property
    def _cuts(self) -> list[MendedRun]:
        """All of them without their pixels."""
        every = (self._cut(number) for number in range(len(self.request.runs[0])))
        return [replace(one, pixels=None, inside=None) for one in every]

    def _cut(self, number: int) -> MendedRun:
        found: MendedRun | None = held(_LOOK, self._journal.files, (number, 0))
        assert found is not None
        return found

    def _measured(
        self, mended: str, placed: dict[int, PlacedPatch], goes_on: Callable[[float], bool],
        executor: Executor, ahead: int,
    ) -> dict[int, float]:
        """kept_1 of the mended mosaic along the new cuts, by the run's number: a scan of given seams, those that stay
        among them."""
        request = self.request
        numbers = list(placed)
        if not numbers:
            return {}
        runs = request.runs[0]
        cut = {piece for number in numbers for piece in runs[number].numbers}
        near = {
            piece for number in numbers
            for piece in request.index.near(runs[number].window(request.mosaic.grid), _WIDEST_PX).numbers.tolist()
        }
        lines = [(self._cuts[number].vertices, runs[number].piece) for number in numbers]
        lines += [(request.pieces[piece].piece.vertices, request.pieces[piece].piece) for piece in sorted(near - cut)]
        seams = tuple(SidedSeam(vertices, piece.left, piece.right) for vertices, piece in lines if vertices is not None)
        gsd = request.mosaic.ground_sample_distance
        settings = ScanSettings(piece_m=_ONE_PIECE_M, corridor_m=_CORRIDOR_PX * gsd, worst_count=0)
        scanned = ScanRequest(open_mosaic(mended), request.sources, settings, GivenSeams(seams, (), ()))
        with whole_scan(scanned, Path(mended)) as scan:
            for step in scan.steps(executor, ahead, lambda: not goes_on(_PATCHED)):
                goes_on(_PATCHED + (1 - _PATCHED) * step.share)
            found = None if not goes_on(1.0) else scan.result("", goes_on, executor, ahead)
            if found is None:
                raise CancelledError(messages.MENDING_STOPPED())
            scan.finish()
        kept: dict[int, float] = {}
        for one in found.pieces:
            if one.piece.seam_id <= len(numbers) and one.least_kept is not None:
                kept.setdefault(numbers[one.piece.seam_id - 1], one.least_kept)
        return kept

    def _judged(self, placed: dict[int, PlacedPatch], kept: dict[int, float]) -> list[MendedSeam]:
        seams = []
        for number, (run, cut) in enumerate(zip(self.request.runs[0], self._cuts)):
            if number not in placed:
                seams.append(MendedSeam(run, cut, LEFT, reason=cut.reason))
                continue
            now, before = kept.get(number), run.kept or 0.0
            if now is None or now <= before:
                seams.append(MendedSeam(run, cut, LEFT, now, messages.NOT_BETTER()))
            else:
                outcome = MENDED if now >= MENDED_KEPT else IMPROVED
                seams.append(MendedSeam(run, cut, outcome, now, None, placed[number].path))
        return seams


@contextmanager
def mending(request: MendRequest, output: Path) -> Iterator[Mending]:
    """A mending whose results so far are kept beside ``output`` until all is done. Raises SettingsError where no file
    can be, or another one is under way there."""
    lines = [(one.piece.vertices, one.piece.left, one.piece.right) for one in request.pieces]
    given = [item for line in lines for item in line]
    mosaic = request.mosaic
    fingerprint = fingerprint_of(
        mosaic.ref, request.sources, request.settings, given, (mosaic.geotransform, mosaic.own_wkt)
    )
    journal, _ = open_journal(output.with_name(output.name + JOURNAL_ENDING), fingerprint)
    try:
        yield Mending(request, journal)
        journal.remove()
    finally:
        journal.close()


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise SettingsError(imagery_messages.FILE_NOT_WRITTEN(path=folder, error=system_reason(error))) from None


def _run_of(record: bytes) -> Any:
    return value_of(MendedRun, record, sentences_of(imagery_messages, messages))


_LOOK = BlockLook("run", mend_run, not_mended, record_of, _run_of)
