"""A whole mosaic: request -> blocks -> what they tell, and what a scan that was stopped has left.

What one block and its neighbours tell is worked out by those who measure, as the blocks were (``block_outputs``); here
their chains are joined to seams and cut in pieces, which they then measure (``piece_sums``).
"""
from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
from osgeo import ogr
from scipy.spatial import cKDTree

from ....imagery.errors import CancelledError, Message, SeamsElsewhereError
from ....imagery.file_identity import known_states, states_text
from ....imagery.grids import shared_extent
from ....imagery.lines import points_along
from ....imagery.messages import CANCELLED
from ....imagery.raster_pool import rasters_kept
from ....imagery.rasters import Raster
from ....imagery.records import RecordFolder
from ....imagery.seam_totals import METRES, MOSAIC_FILES, NEIGHBOURS, SYSTEM, PieceState
from .. import messages
from ..blocks.block_grid import LABEL_PX, UNIT_PX, UNITS, ScanSettings, labels_in, place_of, squares_met
from ..blocks.block_pixels import MosaicReading
from ..blocks.scan_block import EMPTY, NOT_LOOKED
from ..inputs.mixed_images import mixed_images
from ..judgement.visibility import white_grey
from ..profile.cell_table import CELL_PX
from ..seamlines.given_seams import GivenSeams, given_seams
from ..seamlines.seam_features import read_seam_features
from ..seamlines.seam_pieces import PieceIndex, SeamPiece, Side, SidedSeam, around_pieces, cut_in_pieces, sided
from ..seamlines.seam_tracing import SourcePolygon, multipolygon, polygons_of, rectangle, seams_of, trace_borders
from ..window.inspection import Block, PathLike
from ..workers import Workers, measuring
from . import piece_sums, scan_result
from .block_runs import BlockRun, ScanInputs, ScanStep, journal_beside
from .followed_ground import LEAST_BESIDE, LEAST_UNEXPLAINED, FollowedGround, common_shift
from .lone_scan import LoneScanning
from .loss_raster import SOURCE_BAND, LossRaster, loss_raster
from .scan_request import ScanRequest, scan_request
from .scan_result import JudgedPiece, PieceFigures, ScanResult

_BLOCKS_OF_PIECES = 4
"""Side by side, whose pieces are measured together; it must not depend on who measures, as the last digits do on it."""
_MOST_AROUND = 5.0
"""Metres of seam per metre around the orthoimages. Brighton's crooked seams: 0.8; its mosaic warped by nearest
neighbour: 22."""
_TRACED, _CUT, _MEASURED = 0.5, 0.6, 0.95
"""Shares of the time at the ends of what there is to do."""


class Gathering:
    """Puts together what a journal holds."""

    def __init__(self, request: ScanRequest, journal: RecordFolder, reading: MosaicReading) -> None:
        self._request, self._files, self._reading = request, journal.files, reading
        self._blocks = request.blocks
        self._shown: dict[int, int] = {}  # numbers of the sources in the picture of losses
        number = np.min_scalar_type(-len(request.sources) - 1)
        self._units = np.full((self._blocks.rows * UNITS, self._blocks.columns * UNITS), NOT_LOOKED, number)

    def result(self, raster: LossRaster | None, workers: Workers) -> tuple[ScanResult, list[str]]:
        """All of it, without windows; the picture of losses on the way, and the names of the sources in it.

        Raises SettingsError when the journal can't be read, RasterError when the picture can't be written,
        CancelledError.
        """
        request, settings = self._request, self._request.settings
        known = given_polygons(request)
        borders = self._borders(raster, workers.part(0, _TRACED), not (request.given and known))
        polygons = known or tuple(polygons_of(borders))
        pieces = list(request.pieces) if request.given else cut_in_pieces(
            seams_of(borders), settings.piece_m, request.mosaic.grid
        )
        too_many = () if request.given else tuple(_more_than_outlines(request, pieces))
        pieces = [] if too_many else pieces
        for unread in self._reading.unread:
            self._units[squares_met(unread, UNIT_PX)] = NOT_LOOKED
        if request.counted is not None:  # what lies beside it is counted where it belongs
            elsewhere = np.ones(self._units.shape, bool)
            elsewhere[squares_met(request.counted, UNIT_PX)] = False
            self._units[elsewhere] = EMPTY
        workers.tell(_CUT)
        judged, notes, notices = self._judged(pieces, workers.part(_CUT, _MEASURED))
        ground = FollowedGround(self._units, self._blocks, [part.piece for part in judged], settings.piece_m)
        judged = tuple(part for part in judged if request.counts(part.piece))
        if names := request.not_given:
            notes["not_given"] = ", ".join(names)
        if doubtful := [name for name, source in zip(request.source_names, request.sources) if source.may_be_copy]:
            notes["may_be_copies"] = ", ".join(doubtful)
        sources = {name: source.ref for name, source in zip(request.source_names, request.sources)}
        alike = messages.SAME_ALONG_THE_SEAM.template
        detailed = [
            part for part in judged if part.state in (PieceState.PASSED, PieceState.FAILED)
            or (part.reason is not None and part.reason.template == alike)
        ]
        mixed, of_mixed = mixed_images(
            request.mosaic, sources, [(part.left or "", part.right or "", part.piece) for part in detailed]
        )
        notes.update({**ground.told, **of_mixed})
        shift = common_shift(request, ground.unexplained_places) if ground.unexplained >= LEAST_BESIDE else None
        if shift is not None:
            notes["mosaic_shift"] = "{:.2f} {:.2f}".format(*shift)
        notices = [*too_many, *_notices(ground, shift), *mixed, *notices]
        if polygons and not (pieces or request.given or too_many):
            followed = ", ".join(request.source_names[polygon.source] for polygon in polygons)
            notices.append(messages.SCAN_WITHOUT_SEAMS(name=followed))
        names = request.source_names
        made = ScanResult(judged, polygons, notices=tuple(notices), told=notes, sources=tuple(names))
        return made, [names[number] for number in self._shown]

    def _judged(
        self, pieces: Sequence[SeamPiece], workers: Workers
    ) -> tuple[tuple[JudgedPiece, ...], dict[str, str], list[Message]]:
        """The pieces of seam with their verdicts, and what there is to tell of those that may be none."""
        request = self._request
        measured, brightest = self._measured(pieces, workers)
        white = white_grey(request.mosaic, brightest)
        judged, doubtful = [], self._near_missing(measured)
        for number, figures in enumerate(measured):
            if number in doubtful:
                figures = replace(figures, strip=replace(figures.strip, profile=None, area_px=0.0))
            sides = [self._name(side) for side in (figures.piece.left, figures.piece.right)]
            judged.append(scan_result.judge_piece(figures, sides, request.mosaic.ground_sample_distance, white))
        if not request.given:
            return tuple(judged), {"seams": "found"}, []
        # Where a piece was measured there is a seam, though smooth ground tells the sources apart on a part of it.
        alike = {
            number for number, figures in enumerate(measured)
            if number not in doubtful and figures.is_unchanged and judged[number].state is PieceState.NOT_MEASURED
        }
        named = {number for number in alike if pieces[number].left or pieces[number].right}
        counted = {number for number in named if request.counts(pieces[number])}
        unchanged = scan_result.metres([judged[number] for number in counted])
        notes = {"seams": "given", "unchanged_metres": f"{unchanged:.1f}"}
        within = scan_result.metres([judged[number] for number in alike - named])
        seams = tuple(piece for number, piece in enumerate(judged) if number not in alike - named)
        return seams, notes, [messages.SEAMS_WITHIN_ONE(metres=within)] if within else []

    def _near_missing(self, measured: Sequence[PieceFigures]) -> set[int]:
        """Numbers of pieces that reach the ground of an orthoimage that was not given: nobody knows what they kept."""
        missing, grid = {*self._request.not_given}, self._request.mosaic.grid
        pieces = [figures.piece for figures in measured]
        ends = [piece.vertices[[0, -1]] for piece in pieces if missing & {piece.left, piece.right}]
        if not ends:
            return set()
        nodes, near = cKDTree(grid.to_pixels(np.concatenate(ends))), set()
        for number, piece in enumerate(pieces):
            places = points_along(grid.to_pixels(piece.vertices), CELL_PX)
            if nodes.query(places, distance_upper_bound=2 * CELL_PX)[0].min() <= 2 * CELL_PX:
                near.add(number)
        return near

    def _name(self, side: Side) -> str | None:
        """Name of a source as its file has it, else as the seams do."""
        if isinstance(side, str):
            number = self._request.named[0].get(side)
            return side if number is None else self._request.source_names[number]
        return None if side is None else self._request.source_names[side]

    def _borders(self, raster: LossRaster | None, workers: Workers, traces: bool) -> list[SidedSeam]:
        """Borders of what is followed, none unless they are traced; the picture of losses on the way."""
        edges, grid = [np.zeros((4, 0), np.int64)], self._blocks.grid
        size = labels_in(grid.columns), labels_in(grid.rows)
        cell_px = self._request.settings.cell_px if raster is not None else 0
        work = partial(piece_sums.block_outputs, self._files, size, cell_px, traces)
        for block in workers.map(work, self._blocks, self._blocks.rows * self._blocks.columns):
            edges.append(block.edges)
            self._units[place_of(block.key, UNITS)] = block.ground
            # Their sources are numbered in the order in which the picture of losses meets them.
            shown = {source: self._shown.setdefault(source, len(self._shown) + 1) for source in block.sources}
            if raster is not None and block.cells is not None:
                cells, band = block.cells.copy(), SOURCE_BAND - 1
                for source, number in shown.items():
                    cells[band][block.cells[band] == source + 1] = number
                raster.write(*block.key, cells)
        return trace_borders(np.concatenate(edges, axis=1), grid, size[0], LABEL_PX)

    def _measured(self, pieces: Sequence[SeamPiece], workers: Workers) -> tuple[list[PieceFigures], float]:
        """Figures of all pieces, which then say what lies beside them, and the brightest cell along any."""
        index, named = PieceIndex(pieces, self._blocks.grid), self._request.named[0]
        groups = piece_sums.by_blocks(pieces, self._blocks, _BLOCKS_OF_PIECES)
        levels, is_given = self._request.settings.levels, self._request.given is not None
        work = partial(piece_sums.measure_pieces, self._files, self._blocks, levels, is_given)

        def near(numbers: np.ndarray) -> piece_sums.Pieces:
            held = [pieces[number] for number in numbers.tolist()]
            # With what lies nearer to a cell than any of them.
            around = around_pieces(held, self._blocks.grid, 2 * piece_sums.REACH_PX)
            return held, numbers, index.near(around, 0.0)

        of_piece, brightest = dict[int, PieceFigures](), 0.0
        for numbers, (group, largest) in zip(groups, workers.map(work, map(near, groups), len(groups))):
            brightest = max(brightest, largest)
            for number, figures in zip(numbers.tolist(), group):
                beside = figures.beside
                of_piece[number] = figures if beside is None else replace(
                    figures, piece=sided(figures.piece, beside, named)
                )
        return [of_piece[number] for number in range(len(pieces))], brightest


def _more_than_outlines(request: ScanRequest, pieces: Sequence[SeamPiece]) -> Iterator[Message]:
    """Places where labels change so often that their borders can't be seams: an image has a seam around it at most."""
    grid = request.mosaic.grid
    shared = [shared_extent(source.extent, grid.extent) for source in request.sources]
    around = sum(2 * ((e[2] - e[0]) * grid.metres_x + (e[3] - e[1]) * grid.metres_y) for e in shared if e is not None)
    length = sum(piece.length_m for piece in pieces)
    if length > _MOST_AROUND * around:
        yield messages.MORE_SEAMS_THAN_OUTLINES(metres=length, around=around)


def _notices(ground: FollowedGround, shift: tuple[float, float] | None) -> Iterator[Message]:
    """What of the ground is in no figure; ``shift``: by which the mosaic lies beside all its orthoimages."""
    if shift is not None:
        yield messages.MOSAIC_BESIDE(share=100 * ground.unexplained, east=shift[0], north=shift[1])
    elif ground.unexplained >= LEAST_UNEXPLAINED:
        place = ground.unexplained_places[0]
        yield messages.MOSAIC_UNEXPLAINED(share=100 * ground.unexplained, x=place.x, y=place.y)
    if ground.unseen:
        place = ground.unseen[0]
        yield messages.BORDERS_WITHOUT_SEAM(
            metres=sum(border.metres for border in ground.unseen), longest=place.metres, x=place.x, y=place.y
        )


def given_polygons(request: ScanRequest) -> tuple[SourcePolygon, ...]:
    """What the given seams say themselves of which source each part came from."""
    cells = request.given.cells if request.given else ()
    numbers, _ = request.numbers_named({cell.source for cell in cells})
    by_source: dict[int, list[ogr.Geometry]] = {}
    for cell in cells:
        if cell.source in numbers:
            by_source.setdefault(numbers[cell.source], []).append(ogr.CreateGeometryFromWkb(cell.wkb))
    return tuple(
        SourcePolygon(source, bytes(multipolygon(parts).ExportToWkb())) for source, parts in sorted(by_source.items())
    )


JOURNAL_ENDING = ".scan"
"""Ending of the file beside the first output that holds what is measured until the scan is complete."""

MEASURED = 0.9
"""Share of the time of a scan in which blocks are measured: the rest is to put them together."""


class WholeScan:
    """One scan, which may have begun in an earlier run."""

    def __init__(
        self, request: ScanRequest, journal: RecordFolder, notice: Message | None, inputs: ScanInputs
    ) -> None:
        """``inputs``: as they are before they are read."""
        self.request, self._journal, self._inputs = request, journal, inputs
        self.notice = notice
        """What became of an earlier run: goes on, or starts anew and why."""
        self._reading = MosaicReading(request.mosaic)
        if request.sources:
            self._steps = BlockRun(request, journal).steps
            self._result = Gathering(request, journal, self._reading).result
        else:
            alone = LoneScanning(request, journal)
            self._steps, self._result = alone.steps, alone.result

    def steps(self, workers: Workers) -> Iterator[ScanStep]:
        """Scans all blocks."""
        with rasters_kept(), measuring(), workers.at_work() as crew:  # memory is kept from one block to the next
            for step in self._steps(crew):
                self._reading.add(step.reading, step.notices)
                yield step

    def result(self, loss_path: str = "", workers: Workers | None = None) -> ScanResult | None:
        """What all blocks together tell, the picture of losses as a file where a path is given; None when it was
        cancelled. ``workers``: a thread per core where None.

        Raises SettingsError where a raster has changed since the scan began, RasterError where nothing of the mosaic or
        no orthoimage could be read.
        """
        self._inputs.check()
        self._reading.check()
        workers = workers or Workers()
        if not self._journal.is_shared:
            workers = replace(workers, executor=None, ahead=0)
        request, (of_reading, unread) = self.request, self._reading.told
        mosaic, settings = request.mosaic, request.settings
        try:
            picture = loss_raster(loss_path, mosaic, settings.cell_px) if loss_path else nullcontext()
            with rasters_kept(), measuring(), workers.at_work() as crew, picture as raster:
                result, shown = self._result(raster, crew)
                notes = {**settings.told, **of_reading, **result.told}
                if raster is not None:
                    # So that somebody else finds what it was made of, wherever the program was started.
                    sources = [path for source in request.sources for path in source.ref.paths]
                    paths = {"mosaic": mosaic.ref.paths, "sources": sources}
                    files = {name: json.dumps(held, ensure_ascii=False) for name, held in paths.items()}
                    raster.close(shown, {**notes, **files})
                worst = scan_result.worst_windows(result.pieces, mosaic, settings.worst_count, settings.levels)
                crew.tell(1.0)
        except CancelledError:  # which leaves no picture
            return None
        notes = {SYSTEM: mosaic.wkt, **self._inputs.told, **notes, METRES: repr(result.seam_metres)}
        pieces, stretches = (
            tuple(scan_result.dated(piece, request.dates) for piece in every)
            for every in (result.pieces, result.stretches)
        )
        notices = (*unread, *result.notices, *scan_result.without_verdict(pieces))
        return replace(result, pieces=pieces, stretches=stretches, worst=tuple(worst), told=notes, notices=notices)

    def measured(self, loss_path: str, workers: Workers) -> tuple[ScanResult | None, list[Message]]:
        """``result`` after all ``steps``, and what could not be read in them."""
        notices: list[Message] = []
        for step in self.steps(workers):
            notices += step.notices
            workers.progress(MEASURED * step.share)
        return None if workers.cancelled() else self.result(loss_path, workers.part(MEASURED)), notices

    def finish(self) -> None:
        """All results are where they belong: nothing is left to go on from."""
        self._journal.remove()


@contextmanager
def whole_scan(request: ScanRequest, output: Path) -> Iterator[WholeScan]:
    """A scan whose results so far are kept beside ``output`` until it is finished; the same scan goes on from there.

    Raises SettingsError where no file can be, or another scan is under way there.
    """
    inputs = ScanInputs(request.mosaic, request.sources)
    seams = [item for seam in request.seams for item in (seam.vertices, seam.left, seam.right)]
    with journal_beside(output, JOURNAL_ENDING, inputs.fingerprint(request.settings, seams)) as (journal, notice):
        yield WholeScan(request, journal, notice, inputs)


def scan(
    block: Block, settings: ScanSettings | None = None, *, seamlines: PathLike = "", loss: PathLike = "",
    workers: Workers | None = None,
) -> ScanResult:
    """Scan a whole mosaic: what each piece of its seams kept, and windows of the places that kept least.

    ``seamlines``: a vector file, without which seams are found; ``loss``: a GeoTIFF for the picture of losses, over
    nothing that is read; ``workers``: a thread per core where None. Raises SettingsError when the inputs make no scan,
    SeamlineError for seamlines that are none, RasterError when the picture can't be written, CancelledError.
    """
    path, settings, workers = os.fspath(seamlines), settings or ScanSettings(), workers or Workers()
    ScanSettings.check(settings)
    given, notices, paths = None, list[Message](), [source.ref.path for source in block.sources]
    try:
        if path:
            features, notices = read_seam_features(path, block.mosaic.wkt)
            given = given_seams(features, block.mosaic.grid, settings.source_field, paths)
        request, of_request = scan_request(block.mosaic, block.sources, settings, given)
    except SeamsElsewhereError as error:  # a sheet without any, of a mosaic that has some
        given = GivenSeams((), (), (error.message.as_warning(),))
        request, of_request = scan_request(block.mosaic, block.sources, settings, given)
    request = replace(request, counted=block.sheet_window)
    notices += of_request
    with tempfile.TemporaryDirectory() as folder:
        output = Path(os.fspath(loss) or Path(folder) / "loss.tif")
        with whole_scan(request, output) as whole:
            result, of_steps = whole.measured(os.fspath(loss), workers)
            notices += [*filter(None, [whole.notice]), *of_steps]
            if result is None:
                raise CancelledError(messages.STOPPED() if loss else CANCELLED())
            whole.finish()
    result = result if block.sheet is None else _of_sheet(result, block.sheet, len(block.mosaic.ref.parts))
    return replace(result, notices=tuple(dict.fromkeys((*notices, *result.notices))))


def _of_sheet(result: ScanResult, sheet: Raster, neighbours: int) -> ScanResult:
    """What a scan tells of a sheet whose pieces alone it counted, with what lies where cut to the sheet's outline."""
    outline = rectangle(*sheet.extent)
    parts = ((polygon, ogr.CreateGeometryFromWkb(polygon.wkb).Intersection(outline)) for polygon in result.polygons)
    polygons = tuple(
        replace(polygon, wkb=bytes(part.ExportToWkb(ogr.wkbNDR))) for polygon, part in parts if not part.IsEmpty()
    )
    states = states_text(known_states([sheet.ref.path]).items())
    return replace(result, polygons=polygons, told={**result.told, MOSAIC_FILES: states, NEIGHBOURS: str(neighbours)})
