"""A scan by processes gives the same bytes as one by threads, and a process that is killed costs its blocks only."""
from __future__ import annotations

import os
import signal
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest
from seam_inspector.plugin.imagery.records import RecordFiles
from seam_inspector.plugin.seams.measure.scan.scan_request import ScanRequest
from seam_inspector.plugin.seams.measure.scan.whole_scan import whole_scan
from seam_inspector.plugin.seams.measure.workers import Workers

from tests.numbers.seams.scan.whole_scan_lives import plain_values, request_of
from tests.numbers.synthetic import orthoimage, write_raster

pytestmark = pytest.mark.slow

ROWS, COLUMNS = 2100, 6200  # 2 x 4 blocks, the last ones small


@pytest.fixture(scope="module")
def request_(tmp_path_factory: pytest.TempPathFactory) -> ScanRequest:
    """A mosaic cut hard out of two images along a crooked line that runs across."""
    folder = tmp_path_factory.mktemp("large")
    north, south = (np.tile(orthoimage((ROWS, COLUMNS // 4), bands=1, seed=seed), (1, 1, 4)) for seed in (1, 2))
    seam = ROWS / 2 + 90 * np.sin(np.arange(COLUMNS) / 300)
    mosaic = np.where(np.arange(ROWS)[:, np.newaxis] < seam, north, south)
    files = [write_raster(folder / f"{name}.tif", pixels, options=["TILED=YES"])
             for name, pixels in (("mosaic", mosaic), ("north", north), ("south", south))]
    return request_of(*files)


def scanned(request: ScanRequest, loss: Path, executor: Executor, ahead: int) -> list[object]:
    """All that it tells, and the picture's bytes."""
    with whole_scan(request, loss) as scan:
        assert not any(step.notices for step in scan.steps(Workers(executor, ahead)))
        result = scan.result(str(loss), Workers(executor, ahead))
        scan.finish()
    assert result is not None
    return [*plain_values(result), loss.read_bytes()]


@pytest.fixture(scope="module")
def by_threads(request_: ScanRequest, tmp_path_factory: pytest.TempPathFactory) -> list[object]:
    with ThreadPoolExecutor(2) as executor:
        result = scanned(request_, tmp_path_factory.mktemp("threads") / "loss.tif", executor, 4)
    assert len(result[0]) > 20  # type: ignore[arg-type]  # pieces
    return result


def test_processes_give_the_same_bytes_as_threads(
    request_: ScanRequest, by_threads: list[object], tmp_path: Path
) -> None:
    with ProcessPoolExecutor(2, get_context("spawn")) as executor:
        assert scanned(request_, tmp_path / "loss.tif", executor, 20) == by_threads  # several blocks at a time


class GivesToOthers(Executor):
    """Processes, one of which is killed before certain tasks; what is lost with it others do, as on a cluster."""

    def __init__(self) -> None:
        self.killed_at: set[int] = set()
        self.tasks = 0
        self._pool = ProcessPoolExecutor(2, get_context("spawn"))

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        self.tasks += 1
        under_way = self._pool.submit(fn, *args, **kwargs)
        if self.tasks in self.killed_at:
            os.kill(next(iter(self._pool._processes)), signal.SIGKILL)
            assert isinstance(under_way.exception(), BrokenProcessPool)
            self._pool = ProcessPoolExecutor(2, get_context("spawn"))
            under_way = self._pool.submit(fn, *args, **kwargs)
        wait([under_way])
        return under_way

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        self._pool.shutdown()


@pytest.mark.release
@pytest.mark.skipif(os.name == "nt", reason="no SIGKILL")
def test_a_process_killed_while_outputs_are_made_costs_its_blocks_only(
    request_: ScanRequest, by_threads: list[object], tmp_path: Path
) -> None:
    loss, blocks = tmp_path / "loss.tif", request_.blocks.rows * request_.blocks.columns
    with GivesToOthers() as executor, whole_scan(request_, loss) as scan:
        measured = sum(1 for _ in scan.steps(Workers(executor, 2)))
        assert executor.tasks == measured
        executor.killed_at = {measured + 3, measured + blocks + 1}  # the outputs of a block, and pieces
        result = scan.result(str(loss), Workers(executor, 2))
        scan.finish()
    assert result is not None
    assert [*plain_values(result), loss.read_bytes()] == by_threads
    assert measured + blocks < executor.tasks < measured + 2 * blocks  # each once


class Unseeing(Executor):
    """Workers that see nothing of the disk on which the output lies."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self._monkeypatch, self.tasks = monkeypatch, 0

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        def save(*_: object) -> None:
            raise FileNotFoundError

        self.tasks += 1
        done: Future[Any] = Future()
        with self._monkeypatch.context() as elsewhere:
            elsewhere.setattr(RecordFiles, "save", save)
            done.set_result(fn(*args, **kwargs))
        return done


def test_what_workers_measure_that_see_no_folder_is_kept_and_put_together_here(
    request_: ScanRequest, by_threads: list[object], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    loss, executor = tmp_path / "loss.tif", Unseeing(monkeypatch)
    with whole_scan(request_, loss) as scan:
        measured = sum(1 for _ in scan.steps(Workers(executor, 2)))
        result = scan.result(str(loss), Workers(executor, 2))
        scan.finish()
    assert executor.tasks == measured
    assert result is not None
    assert [*plain_values(result), loss.read_bytes()] == by_threads
