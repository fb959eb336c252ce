"""What is measured while a window is being moved, against a whole inspection; and rasters read side by side."""
from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.raster_pool import ReadingLanes, close_rasters, one_by_one
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.window.explained_window import live_profile, read_live
from seam_inspector.plugin.seams.measure.window.inspection import (
    Block,
    inspect_in_stages,
    inspect_window,
    window_request,
)
from seam_inspector.plugin.seams.measure.window.measured_window import (
    HELD_WINDOWS,
    InspectionSettings,
    MeasuredAhead,
    WindowRequest,
)

from tests.numbers.seams.inspecting import MakeRaster, block_of, mosaic_of
from tests.numbers.synthetic import orthoimage
from tests.patience import PATIENCE_S

SIZE = (640, 640)
WINDOW = PixelWindow(64, 64, 512, 512)


@pytest.fixture
def lanes() -> Iterator[ReadingLanes]:
    made = ReadingLanes(4)
    yield made
    made.close()


@pytest.fixture(scope="module")
def images() -> tuple[np.ndarray, np.ndarray]:
    return orthoimage(SIZE, seed=1), orthoimage(SIZE, seed=2)


@pytest.fixture
def feathered(make_raster: MakeRaster, images: tuple[np.ndarray, np.ndarray]) -> Block:
    """Two sources, the left and the right half of the mosaic, mixed across 24 px."""
    left, right = images
    weight = np.clip((np.arange(SIZE[1]) - 308) / 24, 0, 1)
    mosaic = np.round((1 - weight) * left + weight * right).astype(np.uint8)
    return block_of(mosaic_of(make_raster, mosaic), make_raster("a.tif", left), make_raster("b.tif", right))


def wait_until(condition: Callable[[], object]) -> None:
    stop = time.monotonic() + PATIENCE_S
    while not condition():
        assert time.monotonic() < stop
        time.sleep(0.01)


def request_of(block: Block, window: PixelWindow = WINDOW, window_id: int = 3) -> WindowRequest:
    return window_request(block, window_id, block.mosaic.grid.window_extent(window), InspectionSettings())


def test_live_curves_and_profile_are_those_of_the_whole_inspection(feathered: Block, lanes: ReadingLanes) -> None:
    request = request_of(feathered)
    whole, pixels = inspect_window(request), read_live(request, lanes)
    assert [(clip.raster, clip.role) for clip in pixels.result.clips] == [(c.raster, c.role) for c in whole.clips]
    for live, clip in zip(pixels.result.clips, whole.clips):
        assert list(live.curves) == ["luminance"]
        assert live.curves["luminance"].detail == pytest.approx(clip.curves["luminance"].detail, rel=1e-4)
        assert live.curves["luminance"].background == pytest.approx(clip.curves["luminance"].background, rel=1e-4)
    assert pixels.result.paper_verdict == whole.paper_verdict
    profile = live_profile(pixels)
    assert profile.kept == pytest.approx(whole.profile.kept, rel=1e-3)
    assert (profile.low, profile.high) == pytest.approx((whole.profile.low, whole.profile.high), rel=1e-3)
    assert profile.kept[0] < 0.8


def test_outside_the_mosaic_nothing_is_live(feathered: Block, lanes: ReadingLanes) -> None:
    request = request_of(feathered)
    assert read_live(replace(request, window=None), lanes) is None
    gone = replace(request, mosaic=replace(feathered.mosaic, ref=RasterRef("/nowhere/mosaic.tif")))
    assert read_live(gone, lanes) is None


def test_lanes_find_what_one_thread_finds(feathered: Block, lanes: ReadingLanes) -> None:
    request = request_of(feathered)
    refs = [request.mosaic.ref, RasterRef("/nowhere/a.tif"), *(source.ref for source in request.sources)]
    readings = [(ref, lambda raster: raster.read(WINDOW).bands) for ref in refs]
    alone, side_by_side = one_by_one(readings), lanes(readings)
    assert [isinstance(result, RasterError) for result in side_by_side] == [False, True, False, False]
    assert str(alone[1]) == str(side_by_side[1])
    assert all(np.array_equal(a, b) for a, b in zip(alone, side_by_side) if isinstance(a, np.ndarray))


def test_each_raster_has_its_thread_and_stays_open_until_it_is_let_go(feathered: Block, lanes: ReadingLanes) -> None:
    refs = [feathered.mosaic.ref, *(source.ref for source in feathered.sources)]
    readings = [(ref, lambda raster: (threading.get_ident(), raster)) for ref in refs]
    first, again = lanes(readings), lanes(readings)
    assert first == again
    assert len({result[0] for result in first if isinstance(result, tuple)}) == 3
    lanes.let_go()
    assert all(opened not in first for opened in lanes(readings))


@pytest.mark.slow
@pytest.mark.skipif(not os.path.isdir("/proc/self/fd"), reason="open files are counted on Linux")
def test_two_hundred_windows_leave_no_more_files_open(feathered: Block, lanes: ReadingLanes) -> None:
    rasters = {os.path.realpath(raster.ref.path) for raster in (feathered.mosaic, *feathered.sources)}

    def open_rasters() -> list[str]:
        """Paths of the block's rasters, once for each descriptor of this process that holds them open."""
        held = (os.path.realpath(descriptor) for descriptor in Path("/proc/self/fd").iterdir())
        return sorted(path for path in held if path in rasters)

    close_rasters()
    assert not open_rasters()
    for step in range(200):
        request = request_of(feathered, PixelWindow(step % 60, step % 50, 64, 64))
        assert read_live(request, lanes) is not None
    assert open_rasters() == sorted(rasters)
    lanes.let_go()
    wait_until(lambda: not open_rasters())


def test_what_was_measured_ahead_is_there_and_the_same(feathered: Block, lanes: ReadingLanes) -> None:
    reads: list[int] = []

    def read_each(readings: object) -> list:
        reads.append(1)
        return lanes(readings)  # type: ignore[arg-type]

    ahead, request = MeasuredAhead(read_each), request_of(feathered)
    ahead(replace(request, window_id=0))
    first, whole = inspect_in_stages(request, ahead)
    assert reads == [1]
    assert first.window_id == whole.window_id == 3
    assert repr(whole) == repr(inspect_window(request))
    for step in range(1, HELD_WINDOWS + 1):
        ahead(request_of(feathered, replace(WINDOW, column=step)))
    ahead(request)
    assert len(reads) == HELD_WINDOWS + 2  # it was the oldest, and forgotten
    ahead.forget()
    ahead(request)
    assert len(reads) == HELD_WINDOWS + 3


def test_a_click_waits_for_the_window_that_is_being_measured(feathered: Block, lanes: ReadingLanes) -> None:
    begun, may_read = threading.Event(), threading.Event()
    reads: list[int] = []

    def slowly(readings: object) -> list:
        reads.append(1)
        begun.set()
        assert may_read.wait(60)
        return lanes(readings)  # type: ignore[arg-type]

    ahead, request, results = MeasuredAhead(slowly), request_of(feathered), []
    threads = [threading.Thread(target=lambda: results.append(ahead(request))) for _ in range(2)]
    threads[0].start()
    assert begun.wait(60)
    threads[1].start()
    may_read.set()
    for thread in threads:
        thread.join(60)
    assert reads == [1]
    assert len(results) == 2
