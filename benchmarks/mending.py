"""Seams cut anew against the scan that found them: `make benchmark-mending`.

A mosaic with two orthoimages over all of it, feathered along all of its seams. One scan finds what failed, one mending
cuts it anew and measures it: both in one run, in as many threads as the machine has cores, so that their ratio is of
this machine as it was then.
"""
from __future__ import annotations

import argparse
import os
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from osgeo import gdal, ogr
from seam_inspector.plugin.imagery.records import GEOMETRY
from seam_inspector.plugin.seams.measure.limits import ALL
from seam_inspector.plugin.seams.measure.mending.failed_runs import FIELDS, given_pieces
from seam_inspector.plugin.seams.measure.mending.mend_run import MendSettings
from seam_inspector.plugin.seams.measure.mending.mending import (
    LEFT,
    MENDED,
    MendedSeam,
    MendRequest,
    mending,
    metres,
)
from seam_inspector.plugin.seams.measure.scan.scan_result import ScanResult, seam_rows
from seam_inspector.plugin.seams.measure.workers import Workers

from .large_mosaic import LargeMosaic, make_large_mosaic
from .scan_engine import AHEAD, SEAMS, scan_once, scan_request
from .timing import Goal, Run, print_machine, print_table, say, seconds_so_far, timed

SIDE = 10000
FORMAT = "DEFLATE"
BANDS_PX = (33.0, 48.0, 40.0, 33.0)
"""Full width of the feather along each seam."""
WIDTH_M = 10.0
MOST_OF_SCAN, LEAST_MENDED = 3.0, 0.9


def mend_once(made: LargeMosaic, found: ScanResult, threads: int, folder: Path) -> list[MendedSeam]:
    """All pieces of a scan as if they had failed, from its result to the patches and the mended mosaic."""
    whole = scan_request(made, FORMAT, SEAMS)
    rows = [(row, bytes(ogr.CreateGeometryFromWkt(row[GEOMETRY]).ExportToWkb())) for row in seam_rows(found)]
    pieces = tuple(given_pieces(rows, FIELDS, ALL))
    request = MendRequest(whole.mosaic, whole.sources, pieces, MendSettings(WIDTH_M))
    patches, mended = str(folder / "patches"), str(folder / "mended.vrt")
    with ThreadPoolExecutor(threads) as executor, mending(request, patches, mended) as job:
        workers = Workers(executor, AHEAD * threads)
        for step in job.steps(workers):
            assert not step.notices, step.notices
        say("cut anew")
        seams = job.result(workers)
    say(f"{metres(seams, MENDED):,.0f} of {metres(seams):,.0f} m mended, {metres(seams, LEFT):,.0f} m left")
    return seams


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.mending", description=__doc__.split("\n")[0])
    parser.add_argument("--side", type=int, default=SIDE, help=f"px of the mosaic, {SIDE} unless told")
    parser.add_argument("--threads", type=int, default=os.cpu_count() or 1)
    given = parser.parse_args()
    gdal.UseExceptions()
    print_machine(f"as they come, in {given.threads} threads")
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as name:
        folder = Path(name)
        made = make_large_mosaic(folder, given.side, (FORMAT,), say, BANDS_PX)
        found: list[ScanResult] = []
        seams: list[MendedSeam] = []
        scan = timed(lambda: found.append(scan_once(made, FORMAT, SEAMS, given.threads, folder)))
        mend = timed(lambda: seams.extend(mend_once(made, found[0], given.threads, folder)))
    goals = print_figures(made, scan, mend, seams, given.threads)
    print(f"\n{sum(goal.met for goal in goals)} of {len(goals)} goals met, {seconds_so_far():.0f} s")
    return 0


def print_figures(made: LargeMosaic, scan: Run, mend: Run, seams: list[MendedSeam], threads: int) -> list[Goal]:
    """The tables, and the goals."""
    failed = metres(seams)
    print_table(
        f"A mosaic of {made.side} x {made.side} px, three bands, two sources everywhere; {failed:,.0f} m of its seams "
        f"failed; {threads} threads",
        ["", "seconds", "of the processor", "ms a metre that failed"],
        [
            [name, f"{one.wall:.1f}", f"{one.cpu:.1f}", f"{1000 * one.wall / failed:.1f}"]
            for name, one in (("scan", scan), ("mending", mend))
        ],
        "Mending: new cuts, patches, the mended mosaic, and the measurement of what was made.",
    )
    goals = [
        Goal("mending: times the scan", MOST_OF_SCAN, mend.wall / scan.wall, at_least=False),
        Goal("mending: times the scan, processor", MOST_OF_SCAN, mend.cpu / scan.cpu, at_least=False),
        Goal("share of the failed metres that is mended", LEAST_MENDED, metres(seams, MENDED) / failed),
    ]
    print_table("Goals", ["figure", "wanted", "measured", ""], [goal.cells for goal in goals])
    return goals


if __name__ == "__main__":
    raise SystemExit(main())
