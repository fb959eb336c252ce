"""A report of 300 windows, all of them flagged: how long it takes, how large it is, how much memory it needs."""
from __future__ import annotations

import os
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor
from itertools import cycle, islice
from multiprocessing import get_context
from pathlib import Path

from seam_inspector.plugin.seams.measure.window.inspection import Block, inspect_window
from seam_inspector.plugin.seams.measure.window_records import CurveRecord, WindowRecord

from .ground import Ground
from .timing import Goal, print_table
from .windows import peak_memory

WINDOWS = 300
TILE_FORMAT = "DEFLATE"
MOST_SECONDS = 60.0
MOST_MEGABYTES = 30.0


def report_cost(ground: Ground, tile_format: str, count: int) -> tuple[float, float, float, float]:
    """Seconds, processor seconds, MB of the file and growth of the peak memory in MB; for a process of its own."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    from qgis.core import QgsApplication
    from seam_inspector.plugin.seams.report.inspection_report import write_report
    from seam_inspector.plugin.seams.report.report_request import ReportRequest

    application = QgsApplication([], True)  # Qt draws charts in none without an application
    application.initQgis()
    requests = ground.requests(tile_format)
    block = Block(requests[0].mosaic, requests[0].sources)
    records, curves = [], {}
    measured = [inspect_window(request) for request in requests]
    for number, result in enumerate(islice(cycle(measured), count), 1):
        assert result.window is not None
        extent = block.mosaic.grid.window_extent(result.window)
        records.append(WindowRecord(number, extent, "significant", ratios=result.judgement.ratios.detail))
        shares = [(clip.raster, clip.role, clip.curves["luminance"]) for clip in result.clips]
        curves[number] = [CurveRecord(name, role, curve.detail, curve.background) for name, role, curve in shares]
    request = ReportRequest(tuple(records), curves, block=block, wkt=block.mosaic.wkt)
    before = peak_memory()
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as folder:
        path = Path(folder) / "report.html"
        started, cpu = time.perf_counter(), time.process_time()
        assert write_report(path, request) == []
        seconds = time.perf_counter() - started, time.process_time() - cpu
        return (*seconds, path.stat().st_size / 1e6, peak_memory() - before)


def run_report(ground: Ground, quick: bool) -> list[Goal]:
    """Print what a report of many windows costs."""
    count = WINDOWS // 6 if quick else WINDOWS
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as executor:
        seconds, cpu, size, memory = executor.submit(report_cost, ground, TILE_FORMAT, count).result()
    row = [TILE_FORMAT, f"{seconds:.1f} s", f"{cpu:.1f} s", f"{size:.1f} MB", f"{memory:.0f} MB"]
    print_table(
        f"A report of {count} flagged windows of 1024 px with two sources each, curves and clips of all",
        ["tiles of 256 px", "time", "processor", "file", "memory above the start"],
        [row],
    )
    text = f"report of {count} windows, {TILE_FORMAT}"
    return [] if quick else [
        Goal(f"{text}: seconds", MOST_SECONDS, seconds, at_least=False),
        Goal(f"{text}: MB", MOST_MEGABYTES, size, at_least=False),
    ]
