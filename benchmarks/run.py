"""The speed of the measurement, as ratios measured in one run: `make benchmark`.

The curve of a clip against PyWavelets, whole windows, the click and the live curve against the bare GDAL read of their
pixels, one thread against two, memory against the number of windows, the search in a large index, a report of 300
windows, the radiometry of whole rasters against their bare read, and the interior orientation of a scanned frame. It
says what it is at and takes three minutes on two quiet cores; the scan of a whole mosaic has `make benchmark-scan`.
Goals are printed beside the figures; the exit status is 0 whether they are met or not, since a busy machine is no
fault of the code.
"""
from __future__ import annotations

import argparse
import os
import tempfile
from pathlib import Path

from osgeo import gdal

from . import curves, live, photos, radiometry, reports, windows
from .ground import make_ground
from .timing import Goal, print_machine, print_table, say, seconds_so_far

PARTS = (
    ("curves of clips against PyWavelets", lambda ground, quick: curves.run(ground.pixels()[1], quick)),
    ("whole windows against the bare read", windows.run_against_read),
    ("at the click and under the mouse", live.run),
    ("profile and causes against the curves", windows.run_explanation),
    ("windows on one thread and on two", windows.run_threads),
    ("memory against the number of windows", windows.run_memory),
    ("sources out of a large index", windows.run_selection),
    ("a report of many windows", reports.run_report),
    ("radiometry of whole rasters against their bare read", radiometry.run),
    ("interior orientation of a scanned frame", photos.run),
)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.run", description=__doc__.split("\n")[0])
    parser.add_argument("--quick", action="store_true", help="fewer repetitions: one minute instead of three")
    quick = parser.parse_args().quick
    gdal.UseExceptions()
    print_machine(os.environ.get("OPENBLAS_NUM_THREADS", "all"))
    goals: list[Goal] = []
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as folder:
        say("drawing the ground and writing it in all formats")
        ground = make_ground(Path(folder))
        for number, (words, part) in enumerate(PARTS, 1):
            say(f"{number} of {len(PARTS)}: {words}")
            goals += part(ground, quick)
    print_table("Goals", ["figure", "wanted", "measured", ""], [goal.cells for goal in goals])
    print(f"\n{sum(goal.met for goal in goals)} of {len(goals)} goals met, {seconds_so_far():.0f} s")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
