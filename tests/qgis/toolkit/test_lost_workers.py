"""A worker process that is killed in the middle of a run costs nothing but time."""
from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from seam_inspector import PixelWindow, WindowRequest, WindowResult, WorkersLostError, open_block
from seam_inspector.plugin.seams.measure.window.inspection import inspect_windows
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
    paths = [write_raster(tmp_path / f"{seed}.tif", orthoimage((SIDE, SIDE), seed=seed)) for seed in (0, 1)]
    block = open_block(*paths)
    windows = (PixelWindow(8 * number, 0, 256, 256) for number in range(WINDOWS))
    return [block.window(block.mosaic.grid.window_extent(window)) for window in windows]


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
    with pytest.raises(WorkersLostError, match=f"{cluster} is gone, or has no workers that answer; start"):
        list(lose(cluster, requests, loss))
