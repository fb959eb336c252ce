"""A server that drips while an algorithm reads from it: whoever cancels does not wait for the server."""
from __future__ import annotations

import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from seam_inspector.plugin.imagery.remote_files import wait_for_left_alone

from tests.qgis.runs import Log, run_unchecked
from tests.qgis.scenes import BLURRED, SHARP, Scene, windows
from tests.range_server import NONE, Answer, Fault, serving

pytestmark = [pytest.mark.usefixtures("provider"), pytest.mark.slow]

SOON_S = 5.0
CALLS: dict[str, Callable[[str, list[str]], dict[str, Any]]] = {
    "inspectwindows": lambda mosaic, sources: {
        "WINDOWS": windows(SHARP, BLURRED), "MOSAIC": mosaic, "SOURCES": sources},
    "scanmosaic": lambda mosaic, sources: {"MOSAIC": mosaic, "SOURCES": sources},
    "predictloss": lambda mosaic, sources: {"WINDOWS": windows(SHARP, BLURRED), "SOURCES": sources},
    "checkradiometry": lambda mosaic, sources: {"RASTERS": [mosaic]},
    "checknoise": lambda mosaic, sources: {"RASTERS": [mosaic]},
    "simulatebayer": lambda mosaic, sources: {"RASTER": mosaic},
    "enhancephoto": lambda mosaic, sources: {"PHOTO": mosaic, "OPERATION": "mean", "SIZE": 3.0},
}  # fmt: skip


class Dripping:
    """The first requests are answered, then three bytes come a second; the run is cancelled a second after that."""

    def __init__(self, answered: int, log: Log) -> None:
        self._left, self._log = answered, log
        self._lock = threading.Lock()
        self.cancelled: float | None = None

    def __call__(self, asked: Answer) -> Fault:
        with self._lock:
            self._left -= 1
            if self._left == -1:
                threading.Timer(1.0, self._cancel).start()
            return NONE if self._left >= 0 else Fault(dripping=0.33)

    def _cancel(self) -> None:
        self.cancelled = time.monotonic()
        self._log.cancel()


@pytest.mark.parametrize("answered", [0, 5, 12])
@pytest.mark.parametrize("name", CALLS)
def test_a_cancelled_run_does_not_wait_for_a_server_that_drips(name: str, answered: int, scene: Scene) -> None:
    log = Log()
    with serving(scene.mosaic.parent) as server:
        server.fault = dripping = Dripping(answered, log)
        mosaic, *sources = (server.vsi(Path(one).name) for one in (scene.mosaic, *scene.sources))
        outcome = run_unchecked(name, log, **CALLS[name](mosaic, sources))
        ended = time.monotonic()
    wait_for_left_alone()
    if dripping.cancelled is None:
        assert outcome.complaint is None, "it had all that it needs before"
    else:
        assert ended - dripping.cancelled < SOON_S, outcome.complaint
        assert not any("left out" in said for said in log.warnings)
    outcome.close()
