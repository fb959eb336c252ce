"""A worker process that is killed in the middle of a run costs nothing but time."""
from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from seam_inspector.plugin.imagery.errors import WorkersLostError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.seams.measure.window.inspection import Block, inspect_windows
from seam_inspector.plugin.seams.measure.window.window_request import InspectionSettings, WindowRequest
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult
from seam_inspector.plugin.toolkit import executors
from seam_inspector.plugin.toolkit.executors import open_executor

from tests.numbers.synthetic import orthoimage, write_raster
from tests.qgis.clusters import needs_dask, scheduler_process, two_workers

pytestmark = [pytest.mark.slow, pytest.mark.release, needs_dask]

SIDE, WINDOWS = 512, 24


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[str]:
    with two_workers(tmp_path) as address:
        yield address


@pytest.fixture
def requests(tmp_path: Path) -> list[WindowRequest]:
    refs = [
        RasterRef(write_raster(tmp_path / f"{number}.tif", orthoimage((SIDE, SIDE), seed=number)))
        for number in range(2)
    ]
    block = Block(describe_mosaic(refs[0]), tuple(Source(ref, describe(ref).extent) for ref in refs[1:]))
    return [
        WindowRequest(number, block.mosaic, block.sources, PixelWindow(8 * number, 0, 256, 256), InspectionSettings())
        for number in range(WINDOWS)
    ]


@pytest.fixture
def impatient(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(executors, "LOOK_SECONDS", 0.1)
    monkeypatch.setattr(executors, "PATIENCE_SECONDS", 1.0)


def lose(address: str, requests: list[WindowRequest], loss: Callable[[], object]) -> Iterator[WindowResult]:
    """Results, the loss happening after the fourth."""
    with open_executor(address) as (executor, ahead):
        for count, result in enumerate(inspect_windows(requests, executor, ahead), 1):
            yield result
            if count == 4:
                loss()


def end_all(address: str) -> None:
    """End the workers and who would start them anew."""
    from distributed import Client

    with Client(address) as client:
        client.run(lambda dask_worker: dask_worker.loop.add_callback(dask_worker.close), nanny=True)


@pytest.mark.usefixtures("impatient")
@pytest.mark.parametrize("number", [None, signal.SIGKILL, signal.SIGSTOP], ids=["workers", "scheduler", "stopped"])
def test_a_cluster_that_is_lost_is_told(cluster: str, requests: list[WindowRequest], number: int | None) -> None:
    process = scheduler_process(cluster)
    loss = (lambda: os.kill(process, number)) if number else (lambda: end_all(cluster))
    with pytest.raises(WorkersLostError, match=f"{cluster} is gone, or has no workers any more; start"):
        list(lose(cluster, requests, loss))
