"""A whole mosaic: request -> blocks -> result, and what a scan that was stopped has left."""
from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator, Mapping
from concurrent.futures import Executor
from contextlib import contextmanager
from dataclasses import dataclass, replace
from itertools import chain
from pathlib import Path
from typing import Callable

from osgeo import ogr

from ....imagery.errors import CancelledError, Message, SeamsElsewhereError, SettingsError
from ....imagery.file_identity import FileState, known_states, local_states, states_text
from ....imagery.gdal_paths import is_remote
from ....imagery.messages import CANCELLED
from ....imagery.raster_pool import own_threads, rasters_kept
from ....imagery.rasters import Raster
from ....imagery.seam_totals import METRES, MOSAIC_FILES, NEIGHBOURS, SOURCE_FILES, SYSTEM
from .. import messages
from ..blocks.mosaic_reading import MosaicReading
from ..blocks.scan_settings import ScanSettings
from ..seamlines.given_seams import GivenSeams, given_seams
from ..seamlines.seam_features import read_seam_features
from ..while_measuring import measuring
from ..window.inspection import Block, PathLike
from ..workers import Workers
from .block_runs import BlockRun, ScanStep
from .gathering import Gathering
from .lone_scan import LoneScanning
from .scan_journal import MOST_ASKED, ScanJournal, fingerprint_of, journal_beside
from .scan_request import ScanRequest, scan_request
from .scan_result import ScanResult, dated

JOURNAL_ENDING = ".scan"
"""Ending of the file beside the first output that holds what is measured until the scan is complete."""

MEASURED = 0.9
"""Share of the time of a scan in which blocks are measured: the rest is to put them together."""

GoesOn = Callable[[float], bool]
"""Takes the share that is done, and says whether more is wanted."""


class WholeScan:
    """One scan, which may have begun in an earlier run."""

    def __init__(
        self, request: ScanRequest, journal: ScanJournal, notice: Message | None,
        read: tuple[Mapping[str, FileState], Mapping[str, FileState]] = ({}, {}),
    ) -> None:
        """``read``: ``known_states`` of the mosaic and of the sources, before they are read."""
        self.request, self._read = request, read
        self.notice = notice
        """What became of an earlier run: goes on, or starts anew and why."""
        self._journal, self._reading = journal, MosaicReading(request.mosaic)
        if request.sources:
            self._steps = BlockRun(request, journal).steps
            self._result = Gathering(request, journal, self._reading).result
        else:
            alone = LoneScanning(request, journal, self._reading)
            self._steps, self._result = alone.steps, lambda path, goes_on, *_crew: alone.result(path, goes_on)

    def steps(
        self, executor: Executor, ahead: int, cancelled: Callable[[], bool] = lambda: False
    ) -> Iterator[ScanStep]:
        """Scans all blocks, as many of them ``ahead`` as an executor should have under way."""
        with rasters_kept(), measuring():  # memory is kept from one block to the next
            for step in self._steps(Workers(executor, ahead, cancelled)):
                self._reading.add(step.reading, step.notices)
                yield step

    def result(
        self, loss_path: str = "", goes_on: GoesOn = lambda share: True, executor: Executor | None = None,
        ahead: int = 0,
    ) -> ScanResult | None:
        """What all blocks together tell, the picture of losses as a file where a path is given; None when ``goes_on``,
        which is asked with the share that is done, says no. ``executor``: a thread per core where None.

        Raises SettingsError where a raster has changed since the scan began, RasterError where nothing of the mosaic or
        no orthoimage could be read.
        """
        of_mosaic, of_sources = self._read
        now = local_states(chain(*_paths(self.request)))
        for path, state in chain(of_mosaic.items(), of_sources.items()):
            if now.get(path, state) != state:  # of one that is gone blocks have told
                raise SettingsError(messages.SCAN_INPUT_CHANGED(name=Path(path).name))
        self._reading.check()
        with rasters_kept(), measuring(), own_threads(executor, ahead) as crew:
            result = self._result(loss_path, goes_on, *crew)
        dates = self.request.dates
        notes = {**self.request.settings.told, SYSTEM: self.request.mosaic.wkt}
        notes |= {MOSAIC_FILES: states_text(of_mosaic.items()), SOURCE_FILES: states_text(of_sources.items())}
        return result and replace(
            result, told={**notes, **result.told, METRES: repr(result.seam_metres)},
            pieces=tuple(dated(piece, dates) for piece in result.pieces),
            stretches=tuple(dated(stretch, dates) for stretch in result.stretches),
        )

    def finish(self) -> None:
        """All results are where they belong: nothing is left to go on from."""
        self._journal.remove()


@contextmanager
def whole_scan(request: ScanRequest, output: Path) -> Iterator[WholeScan]:
    """A scan whose results so far are kept beside ``output`` until it is finished; the same scan goes on from there.

    Raises SettingsError where no file can be, or another scan is under way there.
    """
    seams = [(seam.vertices, seam.left, seam.right) for seam in request.seams]
    of_mosaic, of_sources = _paths(request)
    asked = sum(map(is_remote, of_sources)) <= MOST_ASKED
    read = known_states(of_mosaic), known_states(of_sources, asked)
    items = [item for seam in seams for item in seam]
    place = request.mosaic.geotransform, request.mosaic.wkt
    fingerprint = fingerprint_of(request.mosaic.ref, request.sources, request.settings, items, place)
    with journal_beside(output, JOURNAL_ENDING, fingerprint) as (journal, notice):
        yield WholeScan(request, journal, notice, read)


def _paths(request: ScanRequest) -> tuple[list[str], list[str]]:
    """Paths of the mosaic and of the sources."""
    return [*request.mosaic.ref.paths], [path for source in request.sources for path in source.ref.paths]


@dataclass(frozen=True)
class ScanRun:
    """Who scans, and who is told how far it is."""

    executor: Executor | None = None
    """The executor that measures blocks; a thread per core where None."""
    ahead: int = 0
    """Blocks that the executor should have under way; twice this machine's cores where 0."""
    progress: Callable[[float], object] = lambda share: None
    """Is told the share that is done, 0 to 1, now and then; what it raises ends the scan."""
    cancelled: Callable[[], bool] = lambda: False
    """Is asked several times a second whether the scan is to end."""


def scan(
    block: Block, settings: ScanSettings | None = None, *, seamlines: PathLike = "", loss: PathLike = "",
    run: ScanRun | None = None,
) -> ScanResult:
    """Scan a whole mosaic: what each piece of its seams kept, and windows of the places that kept least.

    ``seamlines``: a vector file, without which seams are found; ``loss``: a GeoTIFF for the picture of losses, over
    nothing that is read; ``run``: in one thread per core where None. Raises SettingsError when the inputs make no scan,
    SeamlineError for seamlines that are none, RasterError when the picture can't be written, CancelledError.
    """
    path, settings, run = os.fspath(seamlines), settings or ScanSettings(), run or ScanRun()
    ScanSettings.check(settings)
    given, notices = None, list[Message]()
    if path:
        features, notices = read_seam_features(path, block.mosaic.wkt)
        paths = [source.ref.path for source in block.sources]
    try:
        if path:
            given = given_seams(features, block.mosaic.grid, settings.source_field, paths)
        request, of_request = scan_request(block.mosaic, block.sources, settings, given)
    except SeamsElsewhereError as error:  # a sheet without any, of a mosaic that has some
        given = GivenSeams((), (), (error.message.as_warning(),))
        request, of_request = scan_request(block.mosaic, block.sources, settings, given)
    request = replace(request, counted=block.sheet_window)
    notices += of_request

    def goes_on(share: float) -> bool:
        run.progress(MEASURED + (1 - MEASURED) * share)
        return not run.cancelled()

    with tempfile.TemporaryDirectory() as folder:
        output = Path(os.fspath(loss) or Path(folder) / "loss.tif")
        with whole_scan(request, output) as whole, own_threads(run.executor, run.ahead) as opened:
            notices += [whole.notice] if whole.notice else []
            for step in whole.steps(*opened, run.cancelled):
                notices += step.notices
                run.progress(MEASURED * step.share)
            result = None if run.cancelled() else whole.result(os.fspath(loss), goes_on, *opened)
            if result is None:
                raise CancelledError(messages.SCAN_STOPPED() if loss else CANCELLED())
            whole.finish()
    result = result if block.sheet is None else _of_sheet(result, block.sheet, len(block.mosaic.ref.parts))
    return replace(result, notices=tuple(dict.fromkeys((*notices, *result.notices))))


def rectangle(xmin: float, ymin: float, xmax: float, ymax: float) -> ogr.Geometry:
    """A rectangle as a polygon."""
    return ogr.CreateGeometryFromWkt(
        f"POLYGON (({xmin!r} {ymin!r},{xmax!r} {ymin!r},{xmax!r} {ymax!r},{xmin!r} {ymax!r},{xmin!r} {ymin!r}))"
    )


def _of_sheet(result: ScanResult, sheet: Raster, neighbours: int) -> ScanResult:
    """What a scan tells of a sheet whose pieces alone it counted, with what lies where cut to the sheet's outline."""
    outline = rectangle(*sheet.extent)
    parts = ((polygon, ogr.CreateGeometryFromWkb(polygon.wkb).Intersection(outline)) for polygon in result.polygons)
    polygons = tuple(
        replace(polygon, wkb=bytes(part.ExportToWkb(ogr.wkbNDR))) for polygon, part in parts if not part.IsEmpty()
    )
    states = states_text(known_states([sheet.ref.path]).items())
    return replace(result, polygons=polygons, told={**result.told, MOSAIC_FILES: states, NEIGHBOURS: str(neighbours)})
