"""The guide's table of speed: three runs in processes of their own, as ratios with their spread: `make speed`.

    python -m benchmarks.speed [--runs 3] [--write docs/reference/speed.md]

Prints the table as Markdown; ``--write`` puts it between the two marks of a page. Times are those of the processor, so
that other processes change little; the load is told beside the machine all the same.
"""
from __future__ import annotations

import argparse
import os
import platform
import re
import sys
import tempfile
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from datetime import date
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from osgeo import gdal

from . import curves, windows
from .ground import make_ground
from .timing import Spread, is_system_blas

ROWS = (
    ("curve, 1024 px, uint8: times", "Curve of 1024 x 1024 px: times as fast as `pywt.wavedec2` (float32)"),
    ("clip + curves, DEFLATE: times", "Clip and curves of a window of 1024 px, DEFLATE tiles: times the bare read"),
    ("clip + curves, JPEG 75: times", "The same, JPEG tiles of quality 75"),
    ("profile and causes, 512 px: times", "Profile and causes of a window of 512 px: times its curves"),
)
"""How a figure of the benchmarks begins, and its words in the table."""
BEGIN, END = "<!-- speed: made by make speed -->", "<!-- end of speed -->"


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.speed", description=__doc__.split("\n")[0])
    parser.add_argument("--runs", type=int, default=3, help="how often all is measured (3)")
    parser.add_argument("--write", type=Path, help="a page with the two marks")
    arguments = parser.parse_args()
    load = os.getloadavg()[0]
    runs = []
    for number in range(1, arguments.runs + 1):
        with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as executor:
            runs.append(executor.submit(measured).result())
        print(f"run {number} of {arguments.runs} done", file=sys.stderr)
    text = table(runs, load)
    print(text)
    if arguments.write:
        page = arguments.write.read_text(encoding="utf-8")
        before, marked, rest = page.partition(BEGIN)
        _, ended, after = rest.partition(END)
        if not (marked and ended):
            parser.error(f"{arguments.write} has no marks {BEGIN} and {END}")
        arguments.write.write_text(f"{before}{BEGIN}\n{text}\n{END}{after}", encoding="utf-8")
    return 0


def measured() -> dict[str, float]:
    """The ratios of one run in processor time, by the benchmarks' names; tables go to the error output."""
    gdal.UseExceptions()
    standard, sys.stdout = sys.stdout, sys.stderr
    try:
        with tempfile.TemporaryDirectory(prefix="seam_inspector_") as folder:
            ground = make_ground(Path(folder))
            goals = curves.run(ground.pixels()[1], True)
            goals += windows.run_against_read(ground, True)
            goals += windows.run_explanation(ground, True)
    finally:
        sys.stdout = standard
    return {goal.text: goal.processor for goal in goals}


def table(runs: Iterable[dict[str, float]], load: float) -> str:
    """Medians of the runs, least and most, and the machine."""
    runs = list(runs)
    rows = ["| what | median | least to most |", "|---|---|---|"]
    for begin, words in ROWS:
        figures = Spread.of(next(value for name, value in run.items() if name.startswith(begin)) for run in runs)
        rows.append(f"| {words} | {figures.median:.1f} | {figures.least:.1f} to {figures.most:.1f} |")
    return "\n".join([*rows, "", f"*Processor time, {len(runs)} runs on {machine(load)}, {date.today():%d %B %Y}.*"])


def machine(load: float) -> str:
    """Processor, cores, libraries, and what else the machine did when the runs began."""
    info = Path("/proc/cpuinfo")
    found = re.search(r"^model name\s*: (.+)$", info.read_text(), re.MULTILINE) if info.exists() else None
    processor = found[1].strip() if found else platform.processor() or platform.machine()
    blas = "Debian's" if is_system_blas() else "its wheel's"
    threads = os.environ.get("OPENBLAS_NUM_THREADS", "all")
    return (
        f"{processor}, {os.cpu_count()} cores, {threads} of them used, Python {platform.python_version()}, "
        f"numpy {np.__version__} with {blas} BLAS, GDAL {gdal.__version__}, load {load:.1f}"
    )


if __name__ == "__main__":
    raise SystemExit(main())
