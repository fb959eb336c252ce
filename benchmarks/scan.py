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
from .timing import Goal, Run, Speed, print_machine, print_table, say, seconds_so_far, timed

SIDE = 10000
WINDOWS, BLOCKS = 12, 8
"""How many windows and blocks of the peers are measured."""
MOST_OF_BARE_READ = {"JPEG 75": {SEAMS: 2.5, GIVEN: 2.5, FULL: 6.0}, "DEFLATE": {SEAMS: 1.3, GIVEN: 1.3}}
OVER_PYWAVELETS = {SEAMS: 4.0, GIVEN: 4.0}
INSPECTED, LOOP, LOOP_BY_BAND = "inspect_window", "pywt.wavedec2, luminance", "pywt.wavedec2, three bands"
"""The peers."""


@dataclass
class Figures:
    """What was measured on one tile format."""

    reads: list[Run] = field(default_factory=list)
    """Bare reads, one before each scan."""
    scans: dict[str, Run] = field(default_factory=dict)
    """Runs by kind."""
    peers: dict[str, Speed] = field(default_factory=dict)
    """Speeds by name."""

    @property
    def read(self) -> Run:
        """The bare read, median."""
        return Run(*(statistics.median(values) for values in zip(*((run.wall, run.cpu) for run in self.reads))))

    def over_read(self, kind: str) -> float:
        """How many times longer than the bare read."""
        return self.scans[kind].wall / self.read.wall

    def cpu_over_read(self, kind: str) -> float:
        """How many times longer than the bare read on the processor, which other processes hardly move."""
        return self.scans[kind].cpu / self.read.cpu


def measure(made: LargeMosaic, tile_format: str, threads: int, folder: Path) -> Figures:
    """All figures of one tile format; bare reads and scans take turns, so that drift of the machine hits both."""
    paths, figures = made.files[tile_format], Figures()
    for kind in KINDS:
        say(f"{tile_format}: bare read")
        figures.reads.append(timed(partial(bare_read, paths, made.side, threads)))
        say(f"{tile_format}: scan, {kind}")
        figures.scans[kind] = timed(partial(scan_once, made, tile_format, kind, threads, folder))
    say(f"{tile_format}: {WINDOWS} windows and {BLOCKS} blocks of the peers")
    figures.peers = {
        INSPECTED: inspected_windows(paths, made.side, threads, WINDOWS),
        LOOP: pywavelets_loop(paths, made.side, threads, BLOCKS),
        LOOP_BY_BAND: pywavelets_loop(paths, made.side, threads, BLOCKS // 2, by_band=True),
    }
    return figures


def print_figures(made: LargeMosaic, found: dict[str, Figures], threads: int) -> list[Goal]:
    """The tables, and the goals."""
    rows, goals = [], []
    for tile_format, one in found.items():
        bits = 8 * made.files[tile_format][0].stat().st_size / (3e6 * made.megapixels)
        bare, loop = Speed.of(made.megapixels, one.read), one.peers[LOOP]
        rows.append([f"{tile_format}, {bits:.1f} bits", "bare read", *bare.cells, "1.00", "1.00", "", ""])
        for kind in KINDS:
            speed = Speed.of(made.megapixels, one.scans[kind])
            rows.append(["", f"scan, {kind}", *speed.cells, f"{one.over_read(kind):.2f}",
                         f"{one.cpu_over_read(kind):.2f}", f"{speed.core / one.peers[INSPECTED].core:.1f}",
                         f"{speed.core / loop.core:.1f}"])
            if (most := MOST_OF_BARE_READ.get(tile_format, {}).get(kind)) is not None:
                text = f"scan, {kind}, {tile_format}: times the bare read"
                goals.append(Goal(text, most, one.over_read(kind), at_least=False))
            if kind in OVER_PYWAVELETS:
                text = f"scan, {kind}, {tile_format}: times as fast as a loop with pywt.wavedec2"
                goals.append(Goal(text, OVER_PYWAVELETS[kind], made.megapixels / one.scans[kind].wall / loop.wall))
        for name, speed in one.peers.items():
            slower = f"{bare.wall / speed.wall:.2f}", f"{bare.core / speed.core:.2f}"
            rows.append(["", name, *speed.cells, *slower, "", ""])
    print_table(
        f"A mosaic of {made.side} x {made.side} px, three bands, two sources everywhere, {made.seam_px:,.0f} px of "
        f"seams; {threads} threads",
        ["tiles of 256 px", "", "Mpx/s", "a core", "x bare read", "CPU", "x windows' speed", "x loop's speed"],
        rows,
        "Mpx/s: of the mosaic; each of them is read from three rasters. A core: the same by processor time, as are\n"
        "  the last three columns. Bare read: by GDAL, each tile decoded once, one before each scan, the median.\n"
        "  Times the bare read's time by the clock, and in processor time (CPU). inspect_window: over\n"
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
    print_machine(f"as they come, in {given.threads} threads")
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
