"""Failed seams of a whole mosaic: request -> runs cut anew, what a scan says of them, and the mended mosaic as a VRT.

The mosaic lies below, and is never touched; the patches lie above.

A scan's journal keeps what is made, so that a run that was stopped in any way goes on where it was.
"""
from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from operator import attrgetter
from pathlib import Path
from xml.sax.saxutils import escape

import numpy as np
from osgeo import gdal

from ....imagery import messages as imagery_messages
from ....imagery.atomic_files import files_written, unfinished_name
from ....imagery.errors import CancelledError, Message
from ....imagery.file_identity import check_is_file, refuse_overwriting
from ....imagery.gdal_calls import gdal_writing
from ....imagery.grids import PixelWindow
from ....imagery.open_raster import OpenRaster, describe_mosaic
from ....imagery.raster_pool import rasters_kept
from ....imagery.raster_writer import whole_raster
from ....imagery.rasters import Raster
from ....imagery.records import Column, RecordFolder
from .. import messages
from ..blocks.block_grid import BlockKey, ScanSettings
from ..scan.block_runs import BlockLook, JournaledBlocks, ScanInputs, ScanStep, held, journal_beside
from ..scan.scan_request import ScanRequest
from ..scan.whole_scan import whole_scan
from ..seamlines.given_seams import GivenSeams
from ..seamlines.seam_features import source_numbers
from ..seamlines.seam_pieces import PieceIndex, SidedSeam, around_pieces
from ..source_images import Source
from ..workers import Workers
from .failed_runs import SeamRun, part_of, seam_runs
from .mend_run import GROUND_PX, MendedRun, MendSettings, RunRequest, mend_run, not_mended

MENDED_KEPT = 0.9
"""kept_1 of a seam that counts as mended: less is the band of a seam profile."""
MENDED, IMPROVED, LEFT = "mended", "improved", "left"
"""What became of a run: it keeps that much; it keeps more than before; it stays as it was."""
JOURNAL_ENDING = ".mend"
PATCHED = 0.6
"""Share of the time that the patches take; the rest is to measure what was made."""
_WIDEST_PX = 800.0  # of a corridor on either side, so that memory does not grow with it
_CORRIDOR_PX = 64.0
_ONE_PIECE_M = 1e9
_PATCHES = "patch_*.tif"
MENDED_DOMAIN = "SEAM_INSPECTOR_MENDED"
"""Metadata domain of a mended mosaic: how many patches lie on it."""


@dataclass(frozen=True, eq=False)
class MendRequest:
    """Seams that are to be cut anew."""

    mosaic: Raster
    sources: tuple[Source, ...]
    pieces: tuple[SeamRun, ...]
    """All pieces of seam of the mosaic, none of them a ring."""
    settings: MendSettings

    @cached_property
    def numbers(self) -> dict[str, int]:
        """Numbers of the sources by what the pieces call them."""
        names = {str(side) for piece in self.pieces for side in (piece.piece.left, piece.piece.right)}
        return source_numbers(names, [source.ref.paths for source in self.sources])[0]

    @cached_property
    def runs(self) -> tuple[list[SeamRun], list[SeamRun]]:
        """What is cut anew, and what stays since its orthoimages are not known."""
        return seam_runs(self.pieces, self.numbers, self.mosaic.ground_sample_distance)

    @cached_property
    def index(self) -> PieceIndex:
        """All pieces by place."""
        return PieceIndex([piece.piece for piece in self.pieces], self.mosaic.grid)

    def near(self, run: SeamRun, reach_px: float) -> PieceIndex:
        """All pieces near a run."""
        there = around_pieces([run.piece], self.mosaic.grid, 0.0).cut_to(self.mosaic.columns, self.mosaic.rows)
        return self.index.near(there, reach_px)

    def run(self, key: BlockKey, run: SeamRun) -> RunRequest:
        """To cut one of the runs, or a part of it."""
        beside = [self.pieces[number].piece for number in self.near(run, GROUND_PX).numbers.tolist()]
        named = [self.numbers.get(str(side)) for piece in beside for side in (piece.left, piece.right)]
        order = dict.fromkeys([*run.sides, *(number for number in named if number is not None)])
        return RunRequest(
            key, self.mosaic, tuple(self.sources[number] for number in order), run,
            self.near(run, 2 * _WIDEST_PX),
            min(self.settings.width_m / self.mosaic.ground_sample_distance, _WIDEST_PX), self.settings.blend_px,
        )


@dataclass(frozen=True)
class MendedSeam:
    """One run with what became of it."""

    run: SeamRun
    """The seam as the scan found it."""
    cut: MendedRun
    """What cutting it anew gave."""
    outcome: str
    """``mended``, ``improved`` or ``left``."""
    kept: float | None = None
    """kept_1 along the new cut; None where it was not measured."""
    reason: Message | None = None
    """Why it stays as it was."""
    patch: str = ""
    """The name of its patch's file."""

    @property
    def vertices(self) -> np.ndarray:
        """(n, 2) map units: the seam as it runs now."""
        return self.run.piece.vertices if self.cut.vertices is None or self.outcome == LEFT else self.cut.vertices


CUT_COLUMNS: tuple[Column[MendedSeam], ...] = (
    Column("seam_id", "integer", lambda seam: seam.run.piece.seam_id),
    Column("station", "real", lambda seam: seam.run.piece.station_m),
    Column("left_source", "text", lambda seam: seam.run.piece.left),
    Column("right_source", "text", lambda seam: seam.run.piece.right),
    Column("length", "real", lambda seam: seam.run.piece.length_m),
    Column("kept_before", "real", lambda seam: seam.run.kept),
    Column("kept_after", "real", lambda seam: seam.kept),
    Column("step_before", "real", lambda seam: seam.cut.steps[0]),
    Column("step_after", "real", lambda seam: seam.cut.steps[1]),
    Column("misfit", "real", lambda seam: seam.cut.misfit),
    Column("outcome", "text", lambda seam: seam.outcome),
    Column("reason", "text", lambda seam: seam.reason),
    Column("patch", "text", lambda seam: seam.patch),
)
"""CUTS: one line per run."""


def metres(seams: Sequence[MendedSeam], *outcomes: str) -> float:
    """Length of those that ended so, or of all."""
    return sum((seam.run.piece.length_m for seam in seams if not outcomes or seam.outcome in outcomes), 0.0)


class Mending:
    """One mending, which may have begun in an earlier run of the program."""

    def __init__(self, request: MendRequest, patches: str, mended: str, journal: RecordFolder) -> None:
        """``patches``: a folder."""
        self.request, self._journal, self._mended, self._folder = request, journal, mended, Path(patches)
        self._cuts: list[tuple[BlockKey, SeamRun]] = []

    @property
    def done(self) -> int:
        """Runs that an earlier one has cut already."""
        return len(self._journal.files.names)

    def steps(self, workers: Workers) -> Iterator[ScanStep]:
        """Cuts all runs anew."""
        fitting = {}
        runs = {(number, 0): run for number, run in enumerate(self.request.runs[0])}
        with rasters_kept(), workers.at_work() as crew:
            blocks = JournaledBlocks(self._journal, crew)
            for step in blocks.steps(_LOOK, list(runs), lambda key: self.request.run(key, runs[key])):
                fitting[step.key] = step.brief
                yield step
            self._cuts = [part for key, run in runs.items() for part in self._parts(key, run, fitting.get(key, ()))]
            parts = {key: run for key, run in self._cuts if key not in runs}
            yield from blocks.steps(_LOOK, list(parts), lambda key: self.request.run(key, parts[key]))

    def _parts(
        self, key: BlockKey, run: SeamRun, fitting: Sequence[tuple[float, float]]
    ) -> Iterator[tuple[BlockKey, SeamRun]]:
        """A run whose images fit in parts only as those, which are cut by themselves, and what stays beside them."""
        if not fitting:
            yield key, run
            return
        grid, station, whole = self.request.mosaic.grid, run.piece.station_m, run.piece.length_m
        places = [0.0, *(end for part in fitting for end in part), whole]
        for place, (first, last) in enumerate(zip(places, places[1:])):
            if last > first:
                part = part_of(run, first, last, np.array([grid.metres_x, grid.metres_y]))
                span = station + first if first else -np.inf, station + last if last < whole else np.inf
                yield (key[0], (place + 1) // 2 if place % 2 else 0), replace(part, span=span)

    def result(self, workers: Workers) -> list[MendedSeam]:
        """Measures the new cuts, and writes the patches that are better than the mosaic, and the mended mosaic. All
        wanted seams, whatever became of them.

        Raises SettingsError or RasterError where they can't be written, CancelledError.
        """
        place, mosaic = Path(self._mended), self.request.mosaic
        # The folder may go away meanwhile, or its disk be full.
        with files_written(place), rasters_kept(), tempfile.TemporaryDirectory(
            prefix=unfinished_name(place), dir=place.parent
        ) as folder:
            tried: list[MendedRun] = []  # without their patches, which are files in the folder
            for number, (key, _) in enumerate(self._cuts):
                cut: MendedRun | None = held(_LOOK, self._journal.files, key)
                assert cut is not None
                if cut.patch is not None:
                    cut.patch.tofile(Path(folder) / _patch_name(number))
                tried.append(replace(cut, patch=None))
            cuts = {n: cut.vertices for n, cut in enumerate(tried) if cut.window is not None}
            patches = {str(Path(folder) / _patch_name(n)): cut.window for n, cut in enumerate(tried) if cut.window}
            write_mended(path := str(Path(folder) / "mended.vrt"), mosaic, patches)
            kept = self._measured(path, cuts, workers) if cuts else {}
            seams = [self._judged(n, cut, kept.get(n)) for n, cut in enumerate(tried)]
            better = {
                str(self._folder / seam.patch): seam.cut.window for seam in seams if seam.patch and seam.cut.window
            }
            for path in better:
                with whole_raster(path) as unfinished:
                    shutil.move(Path(folder) / os.path.basename(path), unfinished)
            write_mended(self._mended, mosaic, better)
        reason = messages.SIDES_UNKNOWN()
        named, unnamed = self.request.runs
        return seams + [
            MendedSeam(run, MendedRun((number, 0), reason), LEFT, reason=reason)
            for number, run in enumerate(unnamed, len(named))
        ]

    def _measured(self, path: str, cuts: dict[int, np.ndarray | None], workers: Workers) -> dict[int, float]:
        """kept_1 of the mosaic with its patches, a VRT at ``path``, along the new cuts, by the run's number: a scan of
        given seams, those that stay among them."""
        request = self.request
        whole = {self._cuts[number][0][0] for number in cuts}  # runs, of which parts may stay
        lines = [(vertices, self._cuts[number][1].piece) for number, vertices in cuts.items()]
        lines += [
            (run.piece.vertices, run.piece) for number, (key, run) in enumerate(self._cuts)
            if number not in cuts and key[0] in whole
        ]
        runs = [run for key, run in self._cuts if key[0] in whole]
        near = {piece for run in runs for piece in request.near(run, _WIDEST_PX).numbers.tolist()}
        near -= {piece for run in runs for piece in run.numbers}
        lines += [(request.pieces[piece].piece.vertices, request.pieces[piece].piece) for piece in sorted(near)]
        seams = tuple(SidedSeam(vertices, piece.left, piece.right) for vertices, piece in lines if vertices is not None)
        corridor = _CORRIDOR_PX * request.mosaic.ground_sample_distance
        settings = ScanSettings(levels=1, piece_m=_ONE_PIECE_M, corridor_m=corridor, worst_count=0)
        mended = describe_mosaic(replace(request.mosaic.ref, path=path))
        with whole_scan(ScanRequest(mended, request.sources, settings, GivenSeams(seams, (), ())), Path(path)) as scan:
            result, _ = scan.measured("", workers)
        if result is None:
            raise CancelledError(messages.STOPPED())
        kept: dict[int, float] = {}
        numbers = list(cuts)
        for judged in result.pieces:
            if judged.piece.seam_id <= len(numbers) and judged.least_kept is not None:
                kept.setdefault(numbers[judged.piece.seam_id - 1], judged.least_kept)
        return kept

    def _judged(self, number: int, cut: MendedRun, kept: float | None) -> MendedSeam:
        run = self._cuts[number][1]
        if cut.window is None:
            return MendedSeam(run, cut, LEFT, reason=cut.reason)
        if kept is None:
            return MendedSeam(run, cut, LEFT, reason=messages.CUT_NOT_MEASURED())
        if kept <= (run.kept or 0.0):
            return MendedSeam(run, cut, LEFT, kept, messages.NOT_BETTER())
        return MendedSeam(run, cut, MENDED if kept >= MENDED_KEPT else IMPROVED, kept, None, _patch_name(number))


@contextmanager
def mending(request: MendRequest, patches: str, mended: str, read: Iterable[str] = ()) -> Iterator[Mending]:
    """A mending whose results so far are kept beside the mended mosaic until all is done. ``read``: further inputs.
    Raises SettingsError where a setting is out of its range, no file can be, or another one is under way there."""
    request.settings.check()
    check_is_file("patches", patches)
    given = [item for piece in request.pieces for item in (piece.piece.vertices, piece.piece.left, piece.piece.right)]
    given.append(np.array([piece.is_wanted for piece in request.pieces]))
    refs = request.mosaic.ref, *(source.ref for source in request.sources)
    with files_written(patches):
        folder = Path(patches)
        folder.mkdir(parents=True, exist_ok=True)
        outputs = {"mended": mended, **{path.name: str(path) for path in folder.glob(_PATCHES)}}
    fingerprint = ScanInputs(request.mosaic, request.sources).fingerprint(request.settings, given)
    refuse_overwriting(outputs, (*read, *(path for ref in refs for path in ref.paths)))
    with journal_beside(Path(mended), JOURNAL_ENDING, fingerprint) as (journal, _):
        yield Mending(request, patches, mended, journal)
        journal.remove()


def write_mended(path: str, mosaic: Raster, patches: Mapping[str, PixelWindow]) -> None:
    """The mosaic and above it its patches, where their alpha is set, as a VRT. Raises RasterError where it can't be
    written.

    ``patches``: their places in the mosaic's pixels by their files.
    """
    with whole_raster(path) as unfinished, gdal_writing(imagery_messages.RASTER_NOT_WRITTEN(path=path)):
        below = OpenRaster(mosaic.ref)
        whole = gdal.GetDriverByName("VRT").CreateCopy("", below.dataset)
        whole.SetProjection(mosaic.wkt)
        placed = enumerate(patches.items())
        for (number, index), (place, (patch, window)) in product(enumerate(below.roles.indices, 1), placed):
            file = escape(os.path.abspath(patch))
            size = f'xSize="{window.width}" ySize="{window.height}"'
            source = (
                f'<ComplexSource><SourceFilename relativeToVRT="0">{file}</SourceFilename>'
                f"<SourceBand>{number}</SourceBand><UseMaskBand>true</UseMaskBand>"
                f'<SrcRect xOff="0" yOff="0" {size}/>'
                f'<DstRect xOff="{window.column}" yOff="{window.row}" {size}/></ComplexSource>'
            )
            whole.GetRasterBand(index + 1).SetMetadataItem(f"source_{place}", source, "new_vrt_sources")
        whole.SetMetadataItem("patches", str(len(patches)), MENDED_DOMAIN)
        Path(unfinished).write_text(whole.GetMetadata("xml:VRT")[0], encoding="utf-8")


def _patch_name(number: int) -> str:
    return _PATCHES.replace("*", f"{number + 1:04d}")


_LOOK = BlockLook("run", mend_run, not_mended, MendedRun, brief=attrgetter("fitting"))
