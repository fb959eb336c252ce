"""A whole mosaic: request -> blocks -> result, and what a scan that was stopped has left."""
from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from osgeo import ogr

from ....imagery.errors import CancelledError, Message, SeamsElsewhereError
from ....imagery.file_identity import known_states, states_text
from ....imagery.messages import CANCELLED
from ....imagery.raster_pool import rasters_kept
from ....imagery.rasters import Raster
from ....imagery.seam_totals import METRES, MOSAIC_FILES, NEIGHBOURS, SYSTEM
from .. import messages
from ..blocks.block_pixels import MosaicReading
from ..blocks.scan_settings import ScanSettings
from ..seamlines.given_seams import GivenSeams, given_seams
from ..seamlines.seam_features import read_seam_features
from ..while_measuring import measuring
from ..window.inspection import Block, PathLike
from ..workers import Workers
from .block_runs import BlockRun, ScanStep
from .gathering import Gathering
from .lone_scan import LoneScanning
from .scan_journal import ScanInputs, ScanJournal, journal_beside
from .scan_request import ScanRequest, scan_request
from .scan_result import ScanResult, dated

JOURNAL_ENDING = ".scan"
"""Ending of the file beside the first output that holds what is measured until the scan is complete."""

MEASURED = 0.9
"""Share of the time of a scan in which blocks are measured: the rest is to put them together."""


class WholeScan:
    """One scan, which may have begun in an earlier run."""

    def __init__(
        self, request: ScanRequest, journal: ScanJournal, notice: Message | None, inputs: ScanInputs
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
            alone = LoneScanning(request, journal, self._reading)
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
        try:
            with rasters_kept(), measuring(), workers.at_work() as crew:
                result = self._result(loss_path, crew)
        except CancelledError:  # which leaves no picture
            return None
        dates, notes = self.request.dates, {**self.request.settings.told, SYSTEM: self.request.mosaic.wkt}
        return replace(
            result, told={**notes, **self._inputs.told, **result.told, METRES: repr(result.seam_metres)},
            pieces=tuple(dated(piece, dates) for piece in result.pieces),
            stretches=tuple(dated(stretch, dates) for stretch in result.stretches),
        )

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
    with tempfile.TemporaryDirectory() as folder:
        output = Path(os.fspath(loss) or Path(folder) / "loss.tif")
        with whole_scan(request, output) as whole:
            result, of_steps = whole.measured(os.fspath(loss), workers)
            notices += [*filter(None, [whole.notice]), *of_steps]
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
