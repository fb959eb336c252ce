"""Whole windows: against the bare read, on one and two threads, by the hundred, and out of an index of 500 images."""
from __future__ import annotations

import sys
import time
from collections import deque
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from itertools import cycle, islice
from multiprocessing import get_context
from pathlib import Path
from statistics import median

import numpy as np
from osgeo import gdal
from seam_inspector.plugin.imagery.clips import Clip, read_clip
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.imagery.wavelets import Curve, measure_bands
from seam_inspector.plugin.seams.measure.compared_image import MeasuredClip
from seam_inspector.plugin.seams.measure.judgement.explanation import Explanation, explain
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.seams.measure.window.inspection import (
    inspect_window,
    inspect_windows,
    make_block,
    window_request,
)
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings, WindowRequest

from .ground import COMPRESSED, FORMATS, SIDE, Ground
from .timing import Goal, Spread, Timing, interleaved, print_table, say

Place = tuple[str, PixelWindow]
"""A raster and the pixels of it that a window needs."""

Curves = dict[str, Curve]
"""Curves by band."""

MOST_OF_BARE_READ = 2.0
CLOSE_TO_TWO = 1.8
MOST_OF_CURVES = 2.5
EXPLAINED_SIDES = (256, 512, 1024)
MOST_MEMORY_GROWTH = 1.1  # the peak of two threads is not the same in every run


def places(request: WindowRequest) -> list[Place]:
    """What a window reads of each of its rasters, worked out apart from the code under test."""
    found = []
    window = request.window
    assert window is not None
    for ref in (request.mosaic.ref, *(source.ref for source in request.sources)):
        grid = describe(ref).grid
        assert grid is not None
        column = round((request.mosaic.grid.left - grid.left) / grid.pixel_width)
        row = round((grid.top - request.mosaic.grid.top) / grid.pixel_height)
        found.append((ref.path, replace(window, column=window.column + column, row=window.row + row)))
    return found


def bare_read(wanted: Sequence[Place]) -> list[np.ndarray]:
    """Those pixels read by GDAL alone; each dataset is opened and closed, so no block is in the cache."""
    return [gdal.Open(path).ReadAsArray(at.column, at.row, at.width, at.height) for path, at in wanted]


def clips_only(request: WindowRequest) -> list[np.ndarray]:
    """The clips of a window's rasters, without their curves."""
    assert request.window is not None
    refs = [request.mosaic.ref, *(source.ref for source in request.sources)]
    return [read_clip(OpenRaster(ref), request.mosaic, request.window).bands for ref in refs]


def measured_only(request: WindowRequest) -> list[Curves]:
    """The curves of a window's rasters from their files, without what explains them."""
    assert request.window is not None
    settings = request.settings
    refs = [request.mosaic.ref, *(source.ref for source in request.sources)]
    clips = [read_clip(OpenRaster(ref), request.mosaic, request.window) for ref in refs]
    return [one.curves for one in measure_clips(clips, settings.wavelet, settings.levels)]


def measure_clips(clips: Sequence[Clip], wavelet: str, levels: int) -> list[MeasuredClip]:
    """Curves and coarse components of each."""
    return [MeasuredClip(clip, *measure_bands(clip.bands, clip.raster.band_names, wavelet, levels)) for clip in clips]


def check(requests: Sequence[WindowRequest]) -> None:
    """That both sides read the same pixels and that no raster is left out."""
    for request in requests:
        assert inspect_window(request).source_count == 2
        assert all(map(np.array_equal, bare_read(places(request)), clips_only(request)))


def joined(timings: Sequence[Timing]) -> Timing:
    """The repetitions of several calls as those of one."""
    return Timing(tuple(x for timing in timings for x in timing.wall), tuple(x for one in timings for x in one.cpu))


def run_against_read(ground: Ground, quick: bool) -> list[Goal]:
    """Print clip + curves of whole windows against the bare read of the same pixels."""
    repetitions = 3 if quick else 7
    rows, goals = [], []
    for tile_format in FORMATS:
        requests = ground.requests(tile_format)
        check(requests)
        timings = []
        for request in requests:
            wanted = places(request)
            calls = (partial(bare_read, wanted), partial(clips_only, request), partial(measured_only, request))
            timings.append(interleaved(calls, repetitions))
        bare, clip, whole = map(joined, zip(*timings))
        ratio = whole.over(bare)
        rows.append([tile_format, f"{ground.bits_per_sample(tile_format):.1f}", bare.milliseconds, clip.milliseconds,
                     f"{clip.over(bare).median:.2f}", whole.milliseconds, str(ratio), f"{whole.cpu_over(bare):.2f}"])
        if tile_format in COMPRESSED:
            text = f"clip + curves, {tile_format}: times the bare read"
            processor = whole.cpu_over(bare)
            goals.append(Goal(text, MOST_OF_BARE_READ, ratio.median, at_least=False, processor=processor))
    print_table(
        f"Whole windows of {SIDE} px, a mosaic and two sources, RGB with luminance, against the bare GDAL read",
        ["tiles of 256 px", "bits", "bare read", "clips", "ratio", "clips + curves", "ratio (least-most)", "CPU"],
        rows,
        f"Medians of {repetitions} interleaved repetitions of 4 windows, ratios pair by pair. Bits: per sample,\n"
        "  of the mosaic's file. Bare read: open and ReadAsArray of the same pixels; every repetition opens its own\n"
        "  datasets, so tiles are decoded anew. CPU: the last ratio in processor time.",
    )
    return goals


def explained(clips: Sequence[Clip], wavelet: str, levels: int) -> Explanation:
    """All that is measured in a window from its clips: curves, profile and causes."""
    mosaic, *sources = measure_clips(clips, wavelet, levels)
    return explain(mosaic, sources, wavelet, levels)


def run_explanation(ground: Ground, quick: bool) -> list[Goal]:
    """Print what profile and causes of windows cost as a multiple of their curves, both from clips in memory."""
    repetitions = 3 if quick else 5
    rows, goals = [], []
    for side in EXPLAINED_SIDES:
        timings = []
        for request in ground.requests("uncompressed"):
            assert request.window is not None
            window = replace(request.window, width=side, height=side)
            refs = [request.mosaic.ref, *(source.ref for source in request.sources)]
            clips = [read_clip(OpenRaster(ref), request.mosaic, window) for ref in refs]
            wavelet, levels = request.settings.wavelet, request.settings.levels
            mosaic, *sources = measure_clips(clips, wavelet, levels)
            calls = (
                partial(measure_clips, clips, wavelet, levels),
                partial(explain, mosaic, sources, wavelet, levels),
                partial(explained, clips, wavelet, levels),
            )
            timings.append(interleaved(calls, repetitions))
        of_curves, explanation, whole = map(joined, zip(*timings))
        ratio = explanation.over(of_curves)
        multiples = f"{explanation.cpu_over(of_curves):.2f}", whole.milliseconds, f"{whole.over(of_curves).median:.2f}"
        rows.append([f"{side} px", of_curves.milliseconds, explanation.milliseconds, str(ratio), *multiples])
        text, processor = f"profile and causes, {side} px: times the curves", explanation.cpu_over(of_curves)
        goals.append(Goal(text, MOST_OF_CURVES, ratio.median, at_least=False, processor=processor))
    print_table(
        "Profile and causes of windows, a mosaic and two sources, RGB with luminance, against their curves",
        ["window", "curves", "profile, causes", "ratio (least-most)", "CPU", "all", "ratio"],
        rows,
        f"Medians of {repetitions} interleaved repetitions of 4 windows, clips in memory. CPU: the first ratio in\n"
        "  processor time. All: a window with its curves, profile and causes, and what multiple of the curves that is.",
    )
    return goals


def inspect_many(requests: Sequence[WindowRequest], count: int, threads: int) -> None:
    """Measure ``count`` windows, the given ones over and over."""
    many: Iterator[WindowRequest] = islice(cycle(requests), count)
    with ThreadPoolExecutor(threads) as executor:
        for result in inspect_windows(many, executor, 2 * threads):
            assert result.source_count == 2


def read_many(requests: Sequence[WindowRequest], count: int, threads: int) -> None:
    """Only read the pixels of ``count`` windows: what two threads gain where nothing of ours takes part."""
    wanted = islice(cycle([places(request) for request in requests]), count)
    with ThreadPoolExecutor(threads) as executor:
        deque(executor.map(bare_read, wanted), maxlen=0)


def run_threads(ground: Ground, quick: bool) -> list[Goal]:
    """Print windows per second on one and on two threads."""
    count, rounds = (8, 1) if quick else (12, 2)
    rows, goals = [], []
    for tile_format in ("DEFLATE", "JPEG 75"):
        say(f"{count} windows in one thread and in two, {rounds} times, {tile_format}")
        requests = ground.requests(tile_format)
        calls = [partial(job, requests, count, threads) for job in (inspect_many, read_many) for threads in (1, 2)]
        one, two, read_by_one, read_by_two = interleaved(calls, rounds)
        ratio = one.over(two)
        rows.append([tile_format, *(f"{count / median(timing.wall):.1f}" for timing in (one, two)), str(ratio),
                     f"{two.cpu_over(one):.2f}", str(read_by_one.over(read_by_two))])
        goals.append(Goal(f"two threads, {tile_format}: times the throughput of one", CLOSE_TO_TWO, ratio.median))
    print_table(
        f"Throughput of {count} windows",
        ["tiles of 256 px", "1 thread, windows/s", "2 threads", "ratio (least-most)", "CPU", "ratio of bare reads"],
        rows,
        f"Medians of {rounds} interleaved rounds. Goal: close to two, taken as {CLOSE_TO_TWO}. CPU: times the\n"
        "  processor time of one thread. Ratio of bare reads: what GDAL alone gains by a second thread.",
    )
    return goals


def peak_memory() -> float:
    """Most memory this process ever held, MB."""
    status = Path("/proc/self/status")
    if status.exists():  # ru_maxrss would count what the process held that started this one
        return next(int(line.split()[1]) for line in status.read_text().splitlines() if line.startswith("VmHWM")) / 1024
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / (2**20 if sys.platform == "darwin" else 1024)


def memory_after(ground: Ground, counts: Sequence[int]) -> list[float]:
    """Peak memory after each number of windows on two threads, MB; for a process of its own."""
    peaks = [peak_memory()]
    many = islice(cycle(ground.requests("DEFLATE")), counts[-1])
    with ThreadPoolExecutor(2) as executor:
        for done, _ in enumerate(inspect_windows(many, executor, 4), 1):
            if done in counts:
                peaks.append(peak_memory())
    return peaks


def run_memory(ground: Ground, quick: bool) -> list[Goal]:
    """Print the peak memory after few and after ten times as many windows."""
    counts = (8, 80) if quick else (12, 120)
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as executor:
        start, few, many = executor.submit(memory_after, ground, counts).result()
    print_table(
        "Peak memory of a process with two threads",
        ["at the start", f"after {counts[0]} windows", f"after {counts[1]} windows", "growth"],
        [[f"{start:.0f} MB", f"{few:.0f} MB", f"{many:.0f} MB", f"{many - few:.1f} MB"]],
    )
    text = f"memory after {counts[1]} windows: times that after {counts[0]}"
    return [Goal(text, MOST_MEMORY_GROWTH, many / few, at_least=False)]


def run_selection(ground: Ground, quick: bool) -> list[Goal]:
    """Print how long it takes to find the sources of many windows in a large index; no source is opened."""
    windows, columns, rows = 1000, 25, 20
    repetitions = 3 if quick else 7
    mosaic = ground.requests("DEFLATE")[0].mosaic
    step, side = 1000, 3000  # px: nine images lie over every place, some four cover a whole window there
    mosaic = replace(mosaic, columns=(columns + 2) * step, rows=(rows + 2) * step)
    grid = mosaic.grid
    indexed = [
        Source(RasterRef(f"/nowhere/{row}_{column}.tif"),
               grid.window_extent(PixelWindow(column * step, row * step, side, side)))
        for row in range(rows) for column in range(columns)
    ]
    rng = np.random.default_rng(4)
    corners = zip(rng.integers(0, grid.columns - SIDE, windows), rng.integers(0, grid.rows - SIDE, windows))
    drawn = [grid.window_extent(PixelWindow(int(column), int(row), SIDE, SIDE)) for column, row in corners]
    seconds, candidates = [], 0
    for _ in range(repetitions):
        started = time.perf_counter()
        block, _notices = make_block(mosaic, (), indexed)
        requests = [window_request(block, number, extent, InspectionSettings()) for number, extent in enumerate(drawn)]
        seconds.append(time.perf_counter() - started)
        candidates = sum(len(request.sources) for request in requests)
    spread = Spread.of(1e3 * x for x in seconds)
    print_table(
        f"Overlap: requests for {windows} windows out of {len(indexed)} indexed sources, none of them opened",
        ["all windows (least-most)", "a window", "candidates per window"],
        [[f"{spread} ms", f"{spread.median / windows:.3f} ms", f"{candidates / windows:.2f}"]],
    )
    return []
