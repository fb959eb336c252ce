"""The scan of a whole mosaic against the bare read of the same files: `make benchmark-scan`.

A mosaic of 10,000 x 10,000 px, three bands, with two orthoimages over all of it and 40,000 px of seams, some of them
feathered, as JPEG 75, DEFLATE and uncompressed tiles. Beside the bare read: windows that would cover the mosaic, and a
plain loop with PyWavelets, both on a sample. Everything runs in as many threads as the machine has cores.
"""
from __future__ import annotations

import argparse
import os
import statistics
import tempfile
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from osgeo import gdal

from .large_mosaic import FORMATS_SCANNED, LargeMosaic, make_large_mosaic
from .scan_engine import FULL, GIVEN, KINDS, SEAMS, scan_once
from .scan_peers import bare_read, inspected_windows, pywavelets_loop
from .timing import Goal, Run, print_machine, print_table, say, seconds_so_far, timed

SIDE = 10000
WINDOWS, BLOCKS = 12, 8
"""How many windows and blocks of the peers are measured."""
MOST_OF_BARE_READ = {SEAMS: 2.0, GIVEN: 1.0, FULL: 6.0}
OVER_PYWAVELETS = 10.0
COMPRESSED = ("JPEG 75", "DEFLATE")


@dataclass
class Figures:
    """What was measured on one tile format."""

    reads: list[Run] = field(default_factory=list)
    """Bare reads, one before each scan."""
    scans: dict[str, Run] = field(default_factory=dict)
    """By kind."""
    windows: float = 0.0
    """Megapixels of the mosaic a second, as below."""
    loop: float = 0.0
    loop_by_band: float = 0.0

    @property
    def read(self) -> float:
        """Seconds of the bare read, median."""
        return statistics.median(run.wall for run in self.reads)

    def over_read(self, kind: str) -> float:
        """How many times longer than the bare read."""
        return self.scans[kind].wall / self.read

    def cpu_over_read(self, kind: str) -> float:
        """The same by the time on the processor, which other processes hardly move."""
        return self.scans[kind].cpu / statistics.median(run.cpu for run in self.reads)


def measure(made: LargeMosaic, tile_format: str, threads: int, folder: Path) -> Figures:
    """All figures of one tile format; bare reads and scans take turns, so that drift of the machine hits both."""
    paths, figures = made.files[tile_format], Figures()
    for kind in KINDS:
        say(f"{tile_format}: bare read")
        figures.reads.append(timed(partial(bare_read, paths, made.side, threads)))
        say(f"{tile_format}: scan, {kind}")
        figures.scans[kind] = timed(partial(scan_once, made, tile_format, kind, threads, folder))
    say(f"{tile_format}: {WINDOWS} windows and {BLOCKS} blocks of the peers")
    figures.windows = inspected_windows(paths, made.side, threads, WINDOWS)
    figures.loop = pywavelets_loop(paths, made.side, threads, BLOCKS)
    figures.loop_by_band = pywavelets_loop(paths, made.side, threads, BLOCKS // 2, by_band=True)
    return figures


def print_figures(made: LargeMosaic, found: dict[str, Figures], threads: int) -> list[Goal]:
    """The tables, and the goals."""
    rows, goals = [], []
    for tile_format, one in found.items():
        bits = 8 * made.files[tile_format][0].stat().st_size / (3e6 * made.megapixels)
        bare = made.megapixels / one.read
        rows.append([f"{tile_format}, {bits:.1f} bits", "bare read", f"{bare:.1f}", "1.00", "1.00", "", ""])
        for kind in KINDS:
            speed = made.megapixels / one.scans[kind].wall
            rows.append(["", f"scan, {kind}", f"{speed:.1f}", f"{one.over_read(kind):.2f}",
                         f"{one.cpu_over_read(kind):.2f}", f"{speed / one.windows:.1f}", f"{speed / one.loop:.1f}"])
            if tile_format in COMPRESSED:
                text = f"scan, {kind}, {tile_format}: times the bare read"
                goals.append(Goal(text, MOST_OF_BARE_READ[kind], one.over_read(kind), at_least=False))
        goals.append(Goal(f"scan, {SEAMS}, {tile_format}: times as fast as a loop with pywt.wavedec2",
                          OVER_PYWAVELETS, made.megapixels / one.scans[SEAMS].wall / one.loop))
        for name, speed in (("inspect_window", one.windows), ("pywt.wavedec2, luminance", one.loop),
                            ("pywt.wavedec2, three bands", one.loop_by_band)):
            rows.append(["", name, f"{speed:.1f}", f"{bare / speed:.2f}", "", "", ""])
    print_table(
        f"A mosaic of {made.side} x {made.side} px, three bands, two sources everywhere, {made.seam_px:,.0f} px of "
        f"seams; {threads} threads",
        ["tiles of 256 px", "", "Mpx/s", "x bare read's time", "CPU", "x windows' speed", "x loop's speed"],
        rows,
        "Mpx/s: of the mosaic; each of them is read from three rasters. Bare read: by GDAL alone, every tile decoded\n"
        "  once; one before each scan, the median. CPU: the same ratio in processor time. inspect_window: over\n"
        f"  {WINDOWS} of the windows of 1024 px that would cover the mosaic. pywt.wavedec2: {BLOCKS} blocks of 2048 px "
        "are read,\n  decomposed and summed up by cell, without asking which source is followed. Files lie in the "
        "system's cache.",
    )
    return goals


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.scan", description=__doc__.split("\n")[0])
    parser.add_argument("--side", type=int, default=SIDE, help=f"px of the mosaic, {SIDE} unless told")
    parser.add_argument("--threads", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--formats", nargs="+", default=FORMATS_SCANNED, choices=FORMATS_SCANNED)
    given = parser.parse_args()
    gdal.UseExceptions()
    print_machine(f"1 in each of {given.threads}")
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as name:
        folder = Path(name)
        made = make_large_mosaic(folder, given.side, tuple(given.formats), say)
        found = {one: measure(made, one, given.threads, folder) for one in given.formats}
        goals = print_figures(made, found, given.threads)
    print_table("Goals", ["figure", "wanted", "measured", ""], [goal.cells for goal in goals])
    print(f"\n{sum(goal.met for goal in goals)} of {len(goals)} goals met, "
          f"{seconds_so_far():.0f} s")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
