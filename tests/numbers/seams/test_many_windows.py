"""From many requests to many results, on any executor."""
from __future__ import annotations

import pickle
from collections.abc import Iterator
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict
from seam_inspector.plugin.seams.measure.window.inspection import Block, inspect_window, inspect_windows, window_request
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings, WindowRequest
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult

from tests.numbers.conftest import MakeRaster
from tests.numbers.seams.inspecting import SIZE, assert_not_comparable, block_of, inspect, mosaic_of, softened
from tests.numbers.synthetic import orthoimage, texture


class Inline(Executor):
    """Runs a task when it is submitted."""

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


class Stalled(Executor):
    """Never gets to its tasks."""

    def __init__(self) -> None:
        self.futures: list[Future[Any]] = []

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        self.futures.append(Future())
        return self.futures[-1]


class Failing(Inline):
    """One window of which raises what nobody foresaw."""

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        def task(measure: Any, requests: list[WindowRequest]) -> list[WindowResult]:
            if requests[0].window_id == 2:
                raise MemoryError("no room")
            results: list[WindowResult] = fn(measure, requests)
            return results

        return super().submit(task, *args, **kwargs)


@pytest.fixture
def block(make_raster: MakeRaster) -> Block:
    """A mosaic with two sources."""
    scene = orthoimage(SIZE, 3)
    mosaic = mosaic_of(make_raster, softened(scene, 0.7))
    return block_of(mosaic, make_raster("a.tif", scene), make_raster("b.tif", softened(scene, 0.3)))


class Requests:
    """Requests one after the other, and how many of them were taken."""

    def __init__(self, block: Block, count: int) -> None:
        self.taken = 0
        self._block, self._count = block, count

    def __iter__(self) -> Iterator[WindowRequest]:
        for number in range(self._count):
            self.taken += 1
            window = PixelWindow(8 * (number % 20), 4 * number % 128, 64, 64)
            extent = self._block.mosaic.grid.window_extent(window)
            yield window_request(self._block, number, extent, InspectionSettings())


@pytest.mark.slow
def test_every_executor_gives_the_same_results_in_the_order_of_the_requests(block: Block) -> None:
    alone = [inspect_window(request) for request in Requests(block, 10)]
    assert [result.window_id for result in alone] == list(range(10))
    assert {result.judgement.verdict for result in alone} <= {Verdict.SIGNIFICANT, Verdict.REDUCED}
    assert list(inspect_windows(Requests(block, 10), Inline(), 4)) == alone
    with ThreadPoolExecutor(4) as pool:
        assert list(inspect_windows(Requests(block, 10), pool, 8)) == alone
        assert list(inspect_windows(Requests(block, 3), pool, 100)) == alone[:3]
        assert list(inspect_windows(Requests(block, 0), pool, 4)) == []


@pytest.mark.slow
@pytest.mark.parametrize("ahead", [1, 2, 5])
def test_no_more_windows_are_under_way_than_asked_for(block: Block, ahead: int) -> None:
    requests = Requests(block, 6)
    with ThreadPoolExecutor(2) as pool:
        for yielded, result in enumerate(inspect_windows(requests, pool, ahead)):
            assert result.window_id == yielded
            assert requests.taken == min(yielded + ahead, 6)  # so the first comes before the last is thought of


def test_a_window_that_fails_costs_no_other(block: Block) -> None:
    results = list(inspect_windows(Requests(block, 5), Failing(), 2))
    assert [result.window_id for result in results] == list(range(5))
    failed = results.pop(2)
    assert_not_comparable(failed, "The window could not be measured (MemoryError: no room); please report this.")
    assert results == [inspect_window(request) for request in Requests(block, 5) if request.window_id != 2]


def test_cancelling_does_not_wait_for_windows_that_are_not_ready(block: Block) -> None:
    executor, looks = Stalled(), []

    def cancelled() -> bool:
        looks.append(None)
        return len(looks) > 4

    assert list(inspect_windows(Requests(block, 50), executor, 3, cancelled)) == []
    assert len(executor.futures) == 3
    assert all(future.cancelled() for future in executor.futures)


def test_a_result_is_small_whatever_the_window(make_raster: MakeRaster) -> None:
    """10,000 results must not hold 10,000 clips: but for the picture of lost detail, four bytes for 64 pixels."""
    scene = (100 + 20 * texture((512, 512), 1.5)).astype(np.float32)
    block = block_of(mosaic_of(make_raster, scene), make_raster("a.tif", scene))
    small, large = (inspect(block, PixelWindow(0, 0, side, side)) for side in (64, 512))
    assert bytes_without_picture(large) < bytes_without_picture(small) + 200 < 5000
    assert large.loss is not None
    assert len(pickle.dumps(large.loss)) < 512 * 512 // 16 + 1000


def bytes_without_picture(result: WindowResult) -> int:
    """What a result takes, the picture of lost detail left out."""
    assert result.explanation is not None
    return len(pickle.dumps(replace(result, explanation=replace(result.explanation, loss=None))))
