"""How the scan of a mosaic grows with threads and workers: the figures of `docs/appendix/cluster.md`.

    .venv/bin/python -m benchmarks.scan_scale [--side 12288]

All that workers do is timed on one core, task by task; what goes to them and comes back is weighed; what the one
process that hands out and puts together does itself is timed, too, on threads and behind a Dask cluster. From these
figures 4, 16, 64 and more workers are simulated: each takes the next task as it is free, results are taken in order,
and no more than two tasks per worker are under way, as in the plugin; what is put together follows when all are done,
but for the picture, which a thread of its own writes meanwhile.
"""
from __future__ import annotations

import argparse
import heapq
import pickle
import tempfile
import time
from collections import defaultdict
from collections.abc import Callable, Sequence
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from osgeo import gdal
from seam_inspector.plugin.seams.measure.scan.whole_scan import whole_scan
from seam_inspector.plugin.seams.measure.workers import Workers

from .large_mosaic import FORMATS_SCANNED, LargeMosaic, make_large_mosaic
from .scan_engine import AHEAD, KINDS, scan_request
from .timing import Run, print_machine, print_table, say, timed

WORKERS = (1, 2, 4, 16, 64, 256)
BLOCKS = 20_000
"""Blocks of a simulated mosaic: a sheet index of 84 gigapixels."""
DASK_TASKS = 300
TRACED, CUT, MEASURED = 0.5, 0.6, 0.95
"""Shares that ``WholeScan.result`` tells when blocks have told their outputs, pieces are cut, and all are measured."""


@dataclass
class Tasks:
    """Tasks of one kind, as workers do them."""

    seconds: list[float] = field(default_factory=list)
    """Seconds of the processor, task by task."""
    to_worker: int = 0
    """Bytes in all, as the next."""
    back: int = 0


class Weighing(Executor):
    """Does everything at once in the thread that asks, and weighs it."""

    def __init__(self) -> None:
        self.kinds: defaultdict[str, Tasks] = defaultdict(Tasks)
        self.spent = 0.0
        """Seconds of the thread: on tasks, and to weigh them."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        started = time.thread_time()
        done: Future[Any] = Future()
        found = fn(*args, **kwargs)
        work = fn.args[0]  # type: ignore[attr-defined]  # a partial of the look, or of what is to be done
        one = self.kinds[getattr(work, "name", "") or work.__name__]
        one.seconds.append(time.thread_time() - started)
        one.to_worker += len(pickle.dumps((fn, args), 5))
        one.back += len(pickle.dumps(found, 5))
        done.set_result(found)
        self.spent += time.thread_time() - started
        return done


@dataclass(frozen=True)
class ScanCosts:
    """What one kind of scan costs; seconds of the processor."""

    blocks: int
    """That are put together."""
    kinds: dict[str, Tasks]
    """Kinds of tasks, in the order in which they are done."""
    handed: dict[str, float]
    """In the one process, while each of them is done."""
    cut: float
    """In between, to join borders and cut pieces, as the next."""
    end: float
    """When all pieces are measured."""
    aside: float
    """In the picture's thread."""

    @property
    def worked(self) -> float:
        """Seconds that workers work, a block."""
        return sum(sum(kind.seconds) for kind in self.kinds.values()) / self.blocks

    @property
    def gathered(self) -> float:
        """Seconds of the one process, a block, with the picture."""
        return (sum(self.handed.values()) + self.cut + self.end + self.aside) / self.blocks


def measure_scan(made: LargeMosaic, kind: str, folder: Path) -> ScanCosts:
    """A whole scan in one thread."""
    request = scan_request(made, next(iter(made.files)), kind)
    weighing = Weighing()
    told: dict[float, float] = {}

    def own() -> float:
        return time.thread_time() - weighing.spent

    def note(share: float) -> None:
        for limit in (TRACED, CUT, MEASURED):
            if share >= limit:
                told.setdefault(limit, own())

    with whole_scan(request, folder / "loss.tif") as scan:
        started = own()
        for _ in scan.steps(Workers(weighing, AHEAD)):
            pass
        measured, process, thread = own(), time.process_time(), time.thread_time()
        assert scan.result(str(folder / "loss.tif"), Workers(weighing, AHEAD, progress=note)) is not None
        ended = own()
        aside = (time.process_time() - process) - (time.thread_time() - thread)
        scan.finish()
    looks = [name for name in weighing.kinds if name in ("block", "border")]
    handed = {name: (measured - started) / len(looks) for name in looks}
    handed["block_outputs"], handed["measure_pieces"] = told[TRACED] - measured, told[MEASURED] - told[CUT]
    count = request.blocks.rows * request.blocks.columns
    return ScanCosts(
        count, dict(weighing.kinds), handed, told[CUT] - told[TRACED], ended - told[MEASURED], max(aside, 0.0)
    )


def blocks_in_threads(made: LargeMosaic, kind: str, threads: int, folder: Path) -> Run:
    """All blocks with their journal, without what follows."""
    def run() -> None:
        with whole_scan(scan_request(made, next(iter(made.files)), kind), folder / "threads.tif") as scan:
            with ThreadPoolExecutor(threads) as executor:
                for _ in scan.steps(Workers(executor, AHEAD * threads)):
                    pass
            scan.finish()

    return timed(run)


def payload(size: int) -> np.ndarray:
    """What a task of the cluster gives back."""
    return np.zeros(size, np.uint8)


def dask_seconds(size: float) -> float | None:
    """Seconds that the gathering process takes for one result of so many bytes from a cluster, None without Dask."""
    try:
        from distributed import Client, LocalCluster
    except ImportError:
        return None
    with LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        executor = client.get_executor(pure=False)
        list(executor.map(payload, [int(size)] * 20))
        started = time.process_time()
        for future in [executor.submit(payload, int(size)) for _ in range(DASK_TASKS)]:
            future.result()
        return (time.process_time() - started) / DASK_TASKS


def together(ahead: int) -> int:
    """Requests that are handed out at once where so many are under way."""
    with ThreadPoolExecutor(1) as executor:
        return Workers(executor, ahead).together


def simulated(service: Sequence[float], handed: float, workers: int, count: int) -> float:
    """Seconds until ``count`` tasks are done, of which one process takes ``handed`` seconds each, in their order."""
    drawn = np.random.default_rng(workers).choice(np.asarray(service), count)
    step = together(AHEAD * workers)
    tasks = [sum(drawn[first : first + step].tolist()) for first in range(0, count, step)]
    free = [0.0] * workers
    heapq.heapify(free)
    done: list[float] = []
    each = handed * count / len(tasks)
    for number, seconds in enumerate(tasks):
        submitted = done[number - AHEAD * workers] if number >= AHEAD * workers else 0.0
        finished = max(submitted, heapq.heappop(free)) + seconds
        heapq.heappush(free, finished)
        done.append(max(done[-1] if done else 0.0, finished) + each)
    return done[-1]


def whole_seconds(cost: ScanCosts, through_dask: dict[str, float], workers: int) -> float:
    """Seconds of a scan of ``BLOCKS`` blocks."""
    by_kind = {}
    for name, kind in cost.kinds.items():
        count = round(BLOCKS * len(kind.seconds) / cost.blocks)
        by_kind[name] = simulated(
            kind.seconds, cost.handed[name] / len(kind.seconds) + through_dask.get(name, 0.0), workers, count
        )
    share = BLOCKS / cost.blocks
    beside = by_kind["block_outputs"] + cost.cut * share + by_kind["measure_pieces"]
    looks = sum(seconds for name, seconds in by_kind.items() if name in ("block", "border"))
    return looks + max(beside, cost.aside * share) + cost.end * share


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.scan_scale", description=__doc__.split("\n")[0])
    parser.add_argument("--side", type=int, default=12288, help="px of the mosaic")
    parser.add_argument("--format", default="JPEG 75", choices=FORMATS_SCANNED)
    parser.add_argument("--kinds", nargs="+", default=KINDS, choices=KINDS)
    chosen = parser.parse_args()
    gdal.UseExceptions()
    print_machine("1")
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as name:
        folder = Path(name)
        made = make_large_mosaic(folder, chosen.side, (chosen.format,), say)
        blocks_in_threads(made, chosen.kinds[0], 1, folder)  # imports, tables of filters
        costs, threads = {}, []
        for kind in chosen.kinds:
            say(f"{kind}: task by task")
            costs[kind] = measure_scan(made, kind, folder)
            say(f"{kind}: one thread, then two")
            alone, both = (blocks_in_threads(made, kind, count, folder) for count in (1, 2))
            threads.append([kind, f"{alone.wall:.1f} s", f"{both.wall:.1f} s", f"{alone.wall / both.wall:.2f}",
                            f"{both.cpu / alone.cpu:.2f}"])
        say("results through Dask")
        through_dask = {kind: through(cost) for kind, cost in costs.items()}
        read = sum(path.stat().st_size for path in made.files[chosen.format])
    print_table("What workers do, of the processor, per block of 2048 px",
                ["", "task", "time", "slowest task", "to a worker", "back", "handing out", "through Dask"],
                [[kind, name, f"{1e3 * sum(one.seconds) / cost.blocks:.0f} ms", f"{1e3 * max(one.seconds):.0f} ms",
                  f"{one.to_worker / cost.blocks / 1e3:.1f} kB", f"{one.back / cost.blocks / 1e3:.1f} kB",
                  f"{1e3 * cost.handed[name] / cost.blocks:.2f} ms",
                  f"{1e3 * through_dask[kind].get(name, 0) * len(one.seconds) / cost.blocks:.2f} ms"]
                 for kind, cost in costs.items() for name, one in cost.kinds.items()],
                f"Blocks read {read / made.megapixels / 1e6:.2f} bytes per pixel of the mosaic, {chosen.format}, all "
                f"rasters together; {made.seam_px / made.megapixels:.0f} px of seam per megapixel.")
    print_table("What one process does, of the processor, per block",
                ["", "handing out", "joining and cutting", "the end", "picture, aside", "in all"],
                [[kind, *(f"{1e3 * part / cost.blocks:.2f} ms" for part in (
                    sum(cost.handed.values()), cost.cut, cost.end, cost.aside, cost.gathered * cost.blocks))]
                 for kind, cost in costs.items()])
    print_table("Threads", ["", "one", "two", "times faster", "CPU"], threads)
    rows = []
    for kind, cost in costs.items():
        times = [whole_seconds(cost, through_dask[kind], count) for count in WORKERS]
        rows.append([kind, *(f"{times[0] / time:.1f}" for time in times), f"{BLOCKS / times[-1]:.0f}/s"])
        rows.append(["of each", *(f"{100 * times[0] / time / count:.0f} %" for time, count in zip(times, WORKERS)), ""])
    print_table(f"Simulated workers of a cluster, {BLOCKS:,} blocks: times the throughput of one",
                ["", *map(str, WORKERS), "most blocks"], rows,
                f"Most blocks: with {WORKERS[-1]} workers, when the one process is what all wait for.")
    return 0


def through(cost: ScanCosts) -> dict[str, float]:
    """Seconds of the one process for each result of a cluster, as several come together; none without Dask."""
    found = {}
    for name, kind in cost.kinds.items():
        seconds = dask_seconds(together(1000) * kind.back / len(kind.seconds))
        if seconds is not None:
            found[name] = seconds / together(1000)
    return found


if __name__ == "__main__":
    raise SystemExit(main())
