"""How well spoilt windows are told from sound ones, and what was done to them: `make benchmark-detection`.

Real orthoimages are made into mosaics by known operations (``operations``): a seam, and what came over the whole mosaic
afterwards. What the plugin says of a window is compared with what was done, its kept_1 with the detail that is truly
left, and its measures with usual ones. Figures stand by halves: the operations and the ground that may be looked at
while limits are set, and those that are held back.

On Brighton and PackO where SEAM_INSPECTOR_DATA is set, and on a generated block.
"""
from __future__ import annotations

import argparse
import os
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from math import ceil
from pathlib import Path

from osgeo import gdal

from demo.block import make_block

from .detection_tables import print_areas, print_operations, print_summary, print_tones, print_truth
from .known_windows import Imagery, brighton, imagery, packo
from .operations import OPERATIONS
from .outcomes import POOL, Outcome, outcomes
from .production import Operation

SIDES = (512, 256)
COUNT = 3
OTHER_SHARE = 0.5
"""Of the windows, on imagery other than Brighton's."""
BLOCK_EXTENT = (330.0, 264.0)
HALVES = {"used": False, "held back": True}


@dataclass(frozen=True)
class Ground:
    """An imagery and which share of the windows it gets."""

    imagery: Imagery
    share: float


def grounds(data: Path | None, wanted: str, stack: ExitStack) -> Iterator[Ground]:
    """Whatever there is of what is wanted by its name."""
    real = data is not None and (data / "seams" / "brighton").is_dir()
    makers = {"Brighton": brighton, "PackO": packo} if real else {}
    for name, maker in makers.items():
        if data is not None and wanted in name.lower():
            yield Ground(maker(data / "seams" / name.lower()), 1.0 if maker is brighton else OTHER_SHARE)
    if wanted in "block":
        block = make_block(stack.enter_context(tempfile.TemporaryDirectory(prefix="seam_inspector_")), BLOCK_EXTENT)
        yield Ground(imagery("block", block.sources), OTHER_SHARE if real else 1.0)


def measured(ground: Ground, side: int, held_back: bool, operations: Sequence[Operation], count: int) -> list[Outcome]:
    """The outcomes of one half of the operations on one half of the ground."""
    own = [one for one in operations if one.in_half(held_back)]
    count = ceil(count * ground.share)
    started = time.perf_counter()
    windows = ground.imagery.windows(side, POOL * count, held_back)
    found = list(outcomes(own, windows, count))
    if found:
        half = next(name for name, held in HALVES.items() if held is held_back)
        print(f"{ground.imagery.name}, {side} px, {half}: {len(found)} mosaics of {len(windows)} windows, "
              f"{time.perf_counter() - started:.0f} s", flush=True)
    return found


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.detection", description=__doc__.split("\n")[0])
    parser.add_argument("--windows", type=int, default=COUNT, help=f"of each operation on Brighton ({COUNT})")
    parser.add_argument("--only", default="", help="operations whose name holds this, such as 'hard cut' or 'JPEG'")
    parser.add_argument("--half", choices=HALVES, help="only these; 'used' while limits are set")
    parser.add_argument("--side", type=int, choices=SIDES, help="only windows of this side, px")
    parser.add_argument("--imagery", default="", help="only the one whose name holds this, such as Brighton")
    arguments = parser.parse_args()
    gdal.UseExceptions()
    started = time.perf_counter()
    operations = [one for one in OPERATIONS if arguments.only in one.name]
    data = os.environ.get("SEAM_INSPECTOR_DATA")
    halves = {name: held for name, held in HALVES.items() if arguments.half in (None, name)}
    sides = [side for side in SIDES if arguments.side in (None, side)]
    with ExitStack() as stack:
        found = [
            one
            for ground in grounds(Path(data) if data else None, arguments.imagery.lower(), stack)
            for side in sides
            for held_back in halves.values()
            for one in measured(ground, side, held_back, operations, arguments.windows)
        ]
    for side in sides:
        for name, held_back in halves.items():
            report(f"{side} px, {name}", [one for one in found if one.window.side == side
                                          and one.window.held_back is held_back])
    print(f"\n{time.perf_counter() - started:.0f} s")
    return 0


def report(title: str, found: Sequence[Outcome]) -> None:
    """Print all tables of one half, and the areas of each imagery for itself."""
    if not found:
        return
    print_operations(title, found)
    names = list(dict.fromkeys(one.window.imagery for one in found))
    for name in names if len(names) > 1 else ():
        own = [one for one in found if one.window.imagery == name]
        print_areas(f"{title}, {name}", own)
    print_areas(title, found)
    print_truth(title, found)
    print_tones(title, found)
    print_summary(title, found)


if __name__ == "__main__":
    raise SystemExit(main())
