"""Work in the background: one QgsTask for every job, and the jobs as generators of plain data.

A job never sees a layer, the project or a widget. It yields (share done, result); each result reaches the
interface's thread by the signal ``arrived``, the end by ``ended``.
"""
from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from enum import Enum
from typing import Callable

from qgis.core import QgsTask
from qgis.PyQt.QtCore import pyqtSignal

from ..core import messages
from ..core.errors import SeamInspectorError
from ..core.inspection import Settings, WindowRequest
from ..core.messages import Message
from ..core.nearest import SeamIndex
from ..core.pixels import validity_check
from ..core.placing import place_windows
from ..core.rasters import Mosaic
from ..core.runs import inspect_windows
from ..core.seamlines import find_seams
from .courtesy import courteous
from .pictures import make_pictures

Cancelled = Callable[[], bool]
Job = Callable[[Cancelled], Iterator[tuple[float, object]]]


class End(Enum):
    """How a task ended; a cancelled one did not fail."""

    DONE = "done"
    FAILED = "failed"
    CANCELLED = "cancelled"


@dataclass(frozen=True)
class Outcome:
    """What the interface learns when a task has ended."""

    end: End
    message: Message | None = None
    """Why it failed."""


class BackgroundTask(QgsTask):
    """Runs a job. Keep a reference until it has ended, or it is collected before it runs."""

    arrived = pyqtSignal(object)
    ended = pyqtSignal(object)

    def __init__(self, description: str, job: Job) -> None:
        super().__init__(description, QgsTask.Flag.CanCancel)
        self._job = job
        self._failure: Message | None = None

    def run(self) -> bool:
        try:
            with courteous():
                for share, result in self._job(self.isCanceled):
                    self.arrived.emit(result)
                    self.setProgress(100 * share)
        except SeamInspectorError as error:
            self._failure = error.message
        except Exception as error:  # the last door: a task must not raise into QGIS
            self._failure = messages.TASK_FAILED(task=self.description(), error=f"{type(error).__name__}: {error}")
        return self._failure is None and not self.isCanceled()

    def finished(self, result: bool) -> None:
        if result:
            self.ended.emit(Outcome(End.DONE))
        elif self._failure is not None:
            self.ended.emit(Outcome(End.FAILED, self._failure))
        else:
            self.ended.emit(Outcome(End.CANCELLED))


def inspection_job(requests: Iterable[WindowRequest], count: int) -> Job:
    """Inspects ``count`` windows; yields a WindowResult each, in their order."""

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        # One core is left to the interface.
        workers = max(1, (os.cpu_count() or 1) - 1)
        with ThreadPoolExecutor(workers, thread_name_prefix="seam-inspector") as executor:
            results = inspect_windows(requests, executor, 2 * workers, cancelled)
            for done, result in enumerate(results, 1):
                yield done / count, result

    return job


def seams_job(lines: Iterable[bytes | None], pixel_size: float) -> Job:
    """Finds the seams of a layer of lines or polygons; yields the SeamIndex of them."""

    def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        yield 1.0, SeamIndex(find_seams(lines, pixel_size))

    return job


def placing_job(
    lines: Iterable[bytes | None], mosaic: Mosaic, side_m: float, spacing_m: float, settings: Settings
) -> Job:
    """Places windows along the seams of a layer; yields the Placement."""

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        valid = validity_check(mosaic)
        seams = find_seams(lines, mosaic.grid.pixel_width)
        placement = place_windows(
            seams, mosaic.grid, side_m, spacing_m, settings.levels, lambda window: not cancelled() and valid(window)
        )
        if not cancelled():
            yield 1.0, placement

    return job


def pictures_job(request: WindowRequest) -> Job:
    """Reads the clips of one window as pictures; yields the list of them."""

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        yield 1.0, make_pictures(request, cancelled)

    return job
