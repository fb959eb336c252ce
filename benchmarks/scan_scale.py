"""How the scan of a mosaic grows with threads and workers: the figures of `docs/acceptance/cluster.md`.

    .venv/bin/python -m benchmarks.scan_scale [--side 8192]

One block after another is timed on one core; what goes to a worker and comes back is weighed; what the one process
that gathers the results does with each of them is timed, too, on threads and behind a Dask cluster. From these figures
4, 16, 64 and more workers are simulated: each takes the next block as it is free, results are taken in order, and no
more than two blocks per worker are under way, as in the plugin.
"""
from __future__ import annotations

import argparse
import heapq
import pickle
import statistics
import tempfile
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from osgeo import gdal
from seam_inspector.plugin.seams.measure.scan.block_runs import record_of
from seam_inspector.plugin.seams.measure.scan.blocks.scan_block import scan_block
from seam_inspector.plugin.seams.measure.scan.scan_journal import open_journal
from seam_inspector.plugin.seams.measure.scan.whole_scan import whole_scan

from .large_mosaic import FORMATS_SCANNED, LargeMosaic, make_large_mosaic
from .scan_engine import AHEAD, KINDS, scan_request
from .timing import Run, print_machine, print_table, say, timed

WORKERS = (1, 2, 4, 16, 64, 256)
BLOCKS = 20_000
"""Of a simulated mosaic: a sheet index of 84 gigapixels."""
DASK_TASKS = 300


@dataclass(frozen=True)
class BlockCosts:
    """What the blocks of one kind of scan cost."""

    seconds: tuple[float, ...]
    """Of the processor, block by block on one core."""
    request_bytes: float
    """That go to a worker, as those below per block."""
    result_bytes: float
    """That come back from it."""
    record_bytes: float
    """Of the journal."""
    kept: float
    """Seconds in the gathering process to keep a result on the disk, threads as workers."""
    gathered: float
    """Seconds in the same process to make the outputs of a block when all blocks are done."""

    @property
    def mean(self) -> float:
        """Seconds of a block."""
        return statistics.fmean(self.seconds)


def measure_blocks(made: LargeMosaic, kind: str, folder: Path) -> BlockCosts:
    """All blocks, one after the other, and what becomes of them."""
    request = scan_request(made, next(iter(made.files)), kind)
    keys = request.keys()
    blocks = list(map(request.block, keys))
    scan_block(blocks[0])  # imports, tables of filters
    seconds, kept, sizes = [], [], []
    journal, _ = open_journal(folder / "blocks", "scale")
    for number, one in enumerate(blocks):
        started = time.process_time()
        found = scan_block(one)
        seconds.append(time.process_time() - started)
        started = time.perf_counter()
        record = record_of(found)
        journal.save(str(number), record)
        kept.append(time.perf_counter() - started)
        sizes.append([len(pickle.dumps(part, 5)) for part in (one, found)] + [len(record)])
    journal.remove()
    asked, given, written = np.mean(sizes, axis=0).tolist()
    return BlockCosts(
        tuple(seconds), asked, given, written, statistics.median(kept), gathering(made, kind, folder)
    )


def gathering(made: LargeMosaic, kind: str, folder: Path) -> float:
    """Seconds of processor per block that follow when all are done."""
    request = scan_request(made, next(iter(made.files)), kind)
    with whole_scan(request, folder / "loss.tif") as scan:
        with ThreadPoolExecutor(2) as executor:
            count = sum(1 for _ in scan.steps(executor, 4))
        run = timed(lambda: scan.result(str(folder / "loss.tif")))
        scan.finish()
    return run.cpu / count


def blocks_in_threads(made: LargeMosaic, kind: str, threads: int, folder: Path) -> Run:
    """All blocks with their journal, without what follows."""
    def run() -> None:
        with whole_scan(scan_request(made, next(iter(made.files)), kind), folder / "threads.tif") as scan:
            with ThreadPoolExecutor(threads) as executor:
                for _ in scan.steps(executor, AHEAD * threads):
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


def simulated(service: Sequence[float], kept: float, workers: int, count: int = BLOCKS) -> float:
    """Seconds until ``count`` blocks are measured and kept in order, one process keeping all of them."""
    drawn = np.random.default_rng(workers).choice(np.asarray(service), count)
    free = [0.0] * workers
    heapq.heapify(free)
    done: list[float] = []
    for number, seconds in enumerate(drawn.tolist()):
        submitted = done[number - AHEAD * workers] if number >= AHEAD * workers else 0.0
        finished = max(submitted, heapq.heappop(free)) + seconds
        heapq.heappush(free, finished)
        done.append(max(done[-1] if done else 0.0, finished) + kept)
    return done[-1]


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.scan_scale", description=__doc__.split("\n")[0])
    parser.add_argument("--side", type=int, default=8192, help="px of the mosaic")
    parser.add_argument("--format", default="JPEG 75", choices=FORMATS_SCANNED)
    parser.add_argument("--kinds", nargs="+", default=KINDS, choices=KINDS)
    chosen = parser.parse_args()
    gdal.UseExceptions()
    print_machine("1")
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as name:
        folder = Path(name)
        made = make_large_mosaic(folder, chosen.side, (chosen.format,), say)
        costs, threads = {}, []
        for kind in chosen.kinds:
            say(f"{kind}: blocks one by one")
            costs[kind] = measure_blocks(made, kind, folder)
            say(f"{kind}: one thread, then two")
            alone, both = (blocks_in_threads(made, kind, count, folder) for count in (1, 2))
            threads.append([kind, f"{alone.wall:.1f} s", f"{both.wall:.1f} s", f"{alone.wall / both.wall:.2f}",
                            f"{both.cpu / alone.cpu:.2f}"])
        say("results through Dask")
        through_dask = {kind: dask_seconds(one.result_bytes) for kind, one in costs.items()}
        read = sum(path.stat().st_size for path in made.files[chosen.format])
    print_table("A block of 2048 px on one core",
                ["", "mean", "slowest", "to a worker", "back", "journal", "keeping it", "through Dask", "gathering"],
                [[kind, f"{one.mean:.3f} s", f"{max(one.seconds):.3f} s", f"{one.request_bytes / 1e3:.1f} kB",
                  f"{one.result_bytes / 1e3:.0f} kB", f"{one.record_bytes / 1e3:.0f} kB", f"{1e3 * one.kept:.1f} ms",
                  f"{1e3 * (through_dask[kind] or 0):.1f} ms", f"{1e3 * one.gathered:.1f} ms"]
                 for kind, one in costs.items()],
                f"Blocks read {read / made.megapixels / 1e6:.2f} bytes per pixel of the mosaic, {chosen.format}, all "
                f"rasters together; {made.seam_px / made.megapixels:.0f} px of seam per megapixel.")
    print_table("Threads", ["", "one", "two", "times faster", "CPU"], threads)
    rows = []
    for kind, cost in costs.items():
        kept = cost.kept + (through_dask[kind] or 0)
        measured = [simulated(cost.seconds, kept, count) for count in WORKERS]
        for name, after in (("blocks", 0.0), ("and outputs", BLOCKS * cost.gathered)):
            times = [seconds + after for seconds in measured]
            rows.append([f"{kind}, {name}", *(f"{times[0] / one:.1f}" for one in times), f"{BLOCKS / times[-1]:.0f}/s"])
    print_table(f"Simulated workers of a cluster, {BLOCKS:,} blocks: times the throughput of one",
                ["", *map(str, WORKERS), "most blocks"], rows,
                f"Most blocks: with {WORKERS[-1]} workers, when the one process that takes the results and makes the\n"
                "  outputs is what all wait for.")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
