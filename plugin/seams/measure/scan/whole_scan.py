"""A whole mosaic: request -> blocks -> result, and what a scan that was stopped has left."""
from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Callable, Protocol

from ....imagery.atomic_files import drop_unfinished
from ....imagery.message import Message
from ....imagery.raster_pool import rasters_kept
from .block_runs import BlockRun, ScanStep
from .inputs.scan_request import ScanRequest
from .journal.scan_fingerprint import fingerprint_of
from .journal.scan_journal import ScanJournal, open_journal
from .lone.lone_scan import LoneScanning
from .results.gathering import Gathering, ScanResult
from .results.judged_pieces import dated

JOURNAL_ENDING = ".scan"
"""Of the file beside the first output that holds what is measured until the scan is complete."""

GoesOn = Callable[[float], bool]
"""Takes the share that is done, and says whether more is wanted."""


class Scanning(Protocol):
    """With orthoimages or without."""

    def steps(self, executor: Executor, ahead: int, cancelled: Callable[[], bool]) -> Iterator[ScanStep]:
        """Measures all blocks."""

    def result(self, loss_path: str, goes_on: GoesOn) -> ScanResult | None:
        """What they tell together."""


class WholeScan:
    """One scan, which may have begun in an earlier run."""

    def __init__(self, request: ScanRequest, journal: ScanJournal, notice: Message | None) -> None:
        self.request = request
        self.notice = notice
        """What became of an earlier run: goes on, or starts anew and why."""
        self._journal = journal
        self._scanning: Scanning = _BySources(request, journal) if request.sources else LoneScanning(request, journal)

    def steps(
        self, executor: Executor, ahead: int, cancelled: Callable[[], bool] = lambda: False
    ) -> Iterator[ScanStep]:
        """Scans all blocks, as many of them ``ahead`` as an executor should have under way."""
        with rasters_kept():
            yield from self._scanning.steps(executor, ahead, cancelled)

    def result(self, loss_path: str = "", goes_on: GoesOn = lambda share: True) -> ScanResult | None:
        """What all blocks together tell, the picture of losses as a file where a path is given; None when ``goes_on``,
        which is asked with the share that is done, says no."""
        with rasters_kept():
            found = self._scanning.result(loss_path, goes_on)
        dates = self.request.dates
        return found and replace(found, pieces=tuple(dated(piece, dates) for piece in found.pieces))

    def finish(self) -> None:
        """All results are where they belong: nothing is left to go on from."""
        self._journal.remove()


class _BySources:
    """A scan by orthoimages."""

    def __init__(self, request: ScanRequest, journal: ScanJournal) -> None:
        self.steps = BlockRun(request, journal).steps
        self.result = Gathering(request, journal).result


@contextmanager
def whole_scan(request: ScanRequest, output: Path) -> Iterator[WholeScan]:
    """A scan whose results so far are kept beside ``output`` until it is finished; the same scan goes on from there.

    Raises SettingsError where no file can be, or another scan is under way there.
    """
    seams = [(seam.vertices, seam.left, seam.right) for seam in request.seams]
    fingerprint = fingerprint_of(
        request.mosaic.ref, request.sources, request.settings, [item for seam in seams for item in seam]
    )
    journal, notice = open_journal(output.with_name(output.name + JOURNAL_ENDING), fingerprint)
    try:
        drop_unfinished(output)
        yield WholeScan(request, journal, notice)
    finally:
        journal.close()
