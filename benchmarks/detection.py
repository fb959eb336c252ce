"""How well spoilt windows are told from sound ones, and what was done to them: `make benchmark-detection`.

Orthoimages are made into mosaics by known operations (``operations``): a seam, and what came over the whole mosaic
afterwards. What the plugin says of a window is compared with what was done, and its kept_1 with the detail that is
truly left (``true_profile``). Figures stand by halves: the operations and the ground that may be looked at while limits
are set, and those that are held back.

On Brighton and PackO where SEAM_INSPECTOR_DATA is set, on a generated block, on images of several dates and on those of
a satellite that are nearly alike.
"""
from __future__ import annotations

import argparse
import os
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import ceil
from pathlib import Path

from osgeo import gdal

from demo.block import make_block

from .block_mosaics import print_block
from .campaign import POOL, outcomes, spread
from .cause_tables import print_causes, print_missing, print_operations, print_tones
from .figures import grounds_of
from .kept_tables import print_areas, print_hard_cuts, print_measures, print_truth, print_usable
from .known_windows import Imagery, brighton, imagery, packo
from .made_grounds import dates, satellites
from .misfit_cases import is_misfit, misfit_tasks, print_misfits
from .operations import OPERATIONS
from .outcomes import Outcome
from .production import HALVES
from .promises import print_promises

SIDES = (512, 256, 128)
COUNT = 2
OTHER_SHARE = 0.5
"""Share of the windows on imagery other than Brighton's."""
MISFIT_WINDOWS, MISSING_WINDOWS = 2, 4
"""So many times as many for images that do not fit, and for a source that is missing."""
LINE = "own line"
"""What ``--only`` has to hold for the block's own mosaics."""
LINE_SIDE = 1024
"""px: the demonstration's own windows of 100 m."""
LINE_WINDOWS = 4
BLOCK_EXTENT = (330.0, 264.0)


@dataclass(frozen=True)
class Ground:
    """An imagery and which share of the windows it gets."""

    imagery: Imagery
    share: float


def grounds(data: Path | None, wanted: str) -> Iterator[Ground]:
    """Whatever there is of what is wanted by its name."""
    real: dict[str, Callable[[], Imagery]] = {}
    if data is not None and (data / "seams" / "brighton").is_dir():
        seams = data / "seams"
        real = {"brighton": lambda: brighton(seams / "brighton"), "packo": lambda: packo(seams / "packo")}
    for name, make in {**real, "block": block, "dates": dates, "satellites": satellites}.items():
        if wanted in name:
            yield Ground(make(), OTHER_SHARE if real and name != "brighton" else 1.0)


def block() -> Imagery:
    """The orthoimages of the demonstration's block (0.10 m)."""
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as folder:
        return imagery("block", make_block(folder, BLOCK_EXTENT).sources)


@dataclass(frozen=True)
class Extent:
    """How much is done."""

    wanted: str
    """What names of operations hold."""
    sides: Sequence[int]
    halves: Sequence[str]
    count: int
    jobs: int
    with_peers: bool

    def measured(self, ground: Ground) -> Iterator[tuple[str, Outcome]]:
        """Half and outcome of each half of the operations on one half of the ground."""
        count = ceil(self.count * ground.share)
        for side in self.sides:
            for half in self.halves:
                started = time.perf_counter()
                own = [one for one in OPERATIONS if one.in_half(half) and self.wanted in one.name]
                windows = ground.imagery.windows(side, POOL * count, half != HALVES[0])
                often = [one for one in own if one.making.missing]
                tasks = spread([one for one in own if one not in often], windows, count, self.with_peers)
                tasks += spread(often, windows, MISSING_WINDOWS * count, self.with_peers)
                if half != HALVES[2]:
                    tasks += misfit_tasks(windows, MISFIT_WINDOWS * count, self.wanted)
                found = list(outcomes(tasks, self.jobs))
                yield from ((half, one) for one in found)
                if found:
                    print(f"{ground.imagery.name}, {side} px, {half}: {len(found)} mosaics of {len(windows)} windows, "
                          f"{time.perf_counter() - started:.0f} s", flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.detection", description=__doc__.split("\n")[0])
    parser.add_argument("--windows", type=int, default=COUNT, help=f"of each operation on Brighton ({COUNT})")
    parser.add_argument("--only", default="", help="operations whose name holds this, such as 'hard cut' or 'JPEG'")
    parser.add_argument("--half", choices=HALVES, help="only these; 'used' while limits are set")
    parser.add_argument("--side", type=int, choices=SIDES, help="only windows of this side, px")
    parser.add_argument("--imagery", default="", help="only the one whose name holds this, such as Brighton")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="processes (all cores)")
    parser.add_argument("--peers", action="store_true", help="usual measures beside the plugin's; slow")
    parser.add_argument("--operations", action="store_true", help="a line for each operation as well")
    arguments = parser.parse_args()
    gdal.UseExceptions()
    started = time.perf_counter()
    data = os.environ.get("SEAM_INSPECTOR_DATA")
    halves = [half for half in HALVES if arguments.half in (None, half)]
    sides = [side for side in SIDES if arguments.side in (None, side)]
    extent = Extent(arguments.only, sides, halves, arguments.windows, arguments.jobs, arguments.peers)
    found: dict[str, list[Outcome]] = {half: [] for half in halves}
    for ground in grounds(Path(data) if data else None, arguments.imagery.lower()):
        for half, one in extent.measured(ground):
            found[half].append(one)
    for half, own in found.items():
        report(half, own, arguments.operations)
        if arguments.imagery.lower() in "block" and arguments.only in LINE and half != HALVES[2]:
            of_line = sides if arguments.side else [LINE_SIDE, *sides]
            print_block(half, of_line, half != HALVES[0], LINE_WINDOWS * arguments.windows)
    print(f"\n{time.perf_counter() - started:.0f} s")
    return 0


def report(title: str, every: Sequence[Outcome], with_operations: bool) -> None:
    """Print all tables of one half, and the truth on each ground for itself."""
    misfits, found = [one for one in every if is_misfit(one)], [one for one in every if not is_misfit(one)]
    if misfits:
        print_misfits(title, misfits)
    if not found:
        return
    if with_operations:
        print_operations(title, found)
    print_truth(title, found)
    names = grounds_of(found)
    for name in names if len(names) > 1 else ():
        print_truth(f"{title}, {name}", [one for one in found if one.window.imagery == name])
    print_areas(title, found)
    print_measures(title, found)
    print_hard_cuts(title, found)
    print_usable(title, found)
    print_causes(title, found)
    print_missing(title, found)
    print_tones(title, found)
    print_promises(title, every)


if __name__ == "__main__":
    raise SystemExit(main())
