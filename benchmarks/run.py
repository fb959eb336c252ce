"""The speed of the measurement, as ratios measured in one run: `make benchmark`.

The curve of a clip against PyWavelets, whole windows against the bare GDAL read of their pixels, one thread against
two, memory against the number of windows, the search in a large index, a report of 300 windows, the radiometry of whole
rasters against their bare read, and the interior orientation of a scanned frame. Goals are printed beside the figures;
the exit status is 0 whether they are met or not, since a busy machine is no fault of the code.
"""
from __future__ import annotations

import argparse
import os
import tempfile
import time
from pathlib import Path

from osgeo import gdal

from . import curves, photos, radiometry, reports, windows
from .ground import make_ground
from .timing import Goal, print_machine, print_table


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.run", description=__doc__.split("\n")[0])
    parser.add_argument("--quick", action="store_true", help="fewer repetitions: some 30 s instead of three minutes")
    quick = parser.parse_args().quick
    gdal.UseExceptions()
    started = time.perf_counter()
    print_machine(os.environ["OPENBLAS_NUM_THREADS"])
    goals: list[Goal] = []
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as folder:
        ground = make_ground(Path(folder))
        goals += curves.run(ground.pixels()[1], quick)
        for part in (
            windows.run_against_read,
            windows.run_explanation,
            windows.run_threads,
            windows.run_memory,
            windows.run_selection,
            reports.run_report,
        ):
            goals += part(ground, quick)
        goals += radiometry.run(ground, quick)
        goals += photos.run(ground, quick)
    print_table("Goals", ["figure", "wanted", "measured", ""], [goal.cells for goal in goals])
    print(f"\n{sum(goal.met for goal in goals)} of {len(goals)} goals met, {time.perf_counter() - started:.0f} s")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
