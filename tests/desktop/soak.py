"""The soak: 5,000 windows inspected and 500 judged in one run of the real QGIS, and what grew meanwhile.

    python -m tests.desktop.soak [--fewer N]

Prints a table, a row for each 500 windows; the exit code is 1 when something grew beyond its allowance, from the first
round, in which all is loaded and every cache filled, to the last. ``--fewer 20`` does a twentieth, for a try.
"""
from __future__ import annotations

import argparse
import os
import sys
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

from demo import desktop
from demo.block import make_block

WINDOWS, JUDGED, ROUNDS = 5000, 500, 10
EXTENT_M = (300.0, 200.0)
SECONDS = 4 * 3600
SCENARIO = Path(__file__).parent / "scenarios" / "soak.py"
ALLOWED = {
    "rss_mb": 0.05,
    "python_objects": 20.0,
    "our_objects": 10.0,
}
"""Growth for each window that is inspected: its row in the layer, the table and the map; results are in a file."""
HELD = 500  # so many results are held in memory as well, which a shorter run does not fill in its first round
ALLOWED_HELD = {"rss_mb": 1.5, "python_objects": 100.0, "our_objects": 110.0}
"""Growth for each of them, with its curves and pictures."""
ALLOWED_AT_ALL = {
    "rss_mb": 150.0,
    "python_objects": 20_000,
    "our_objects": 2_000,
    "qt_objects": 100,
    "widgets": 40,
    "scene_items": 4,
    "layers": 0,
    "tasks": 0,
    "files_open": 8,
    "databases_open": 4,
    "threads": 6,
    "python_threads": 3,
    "temporary_files": 6,
}
"""Growth besides, whatever the windows: caches of pixels and of the map that are not full after a round."""
SLOWER = 2.0  # how many times the interface's work of the first round a window and a key may take in the last one
COLUMNS = {
    "windows": "windows", "judged": "judged", "rss_mb": "MB", "python_objects": "py objects", "our_objects": "ours",
    "qt_objects": "Qt objects", "widgets": "widgets", "scene_items": "items", "layers": "layers", "tasks": "tasks",
    "files_open": "files", "databases_open": "databases", "threads": "threads", "temporary_files": "temp",
    "undo_steps": "undo", "inspect_ms": "ms/window", "inspect_work_ms": "work/window", "key_work_ms": "work/key",
    "inspect_stalls": "stalls", "inspect_longest_ms": "longest", "key_stalls": "key stalls",
    "key_longest_ms": "longest", "look_longest_ms": "look", "draw_longest_ms": "draw", "load": "load",
}  # fmt: skip


def grown(rounds: list[dict[str, Any]]) -> list[str]:
    """What grew beyond its allowance, in sentences."""
    first, last = rounds[0], rounds[-1]
    windows = last["windows"] - first["windows"]
    held = max(min(last["windows"], HELD) - first["windows"], 0)
    items = []
    for name, allowed in ALLOWED_AT_ALL.items():
        growth = last[name] - first[name]
        most = allowed + windows * ALLOWED.get(name, 0) + held * ALLOWED_HELD.get(name, 0)
        if growth > most:
            items.append(f"{name} grew by {growth:g}; {most:g} are allowed for {windows} more windows")
    for name in ("inspect_work_ms", "key_work_ms"):
        if last[name] > SLOWER * first[name]:
            items.append(f"{name} is {last[name]:.1f} in the last round and was {first[name]:.1f} in the first")
    return items


def table(rounds: list[dict[str, Any]]) -> str:
    """A row for each round."""
    cells = [list(COLUMNS.values())]
    cells += [[f"{row[name]:.1f}" if isinstance(row[name], float) else str(row[name]) for name in COLUMNS]
              for row in rounds]  # fmt: skip
    widths = [max(map(len, column)) for column in zip(*cells)]
    return "\n".join("  ".join(cell.rjust(width) for cell, width in zip(row, widths)) for row in cells)


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fewer", type=int, default=1, help="how many times fewer windows")
    fewer = max(parser.parse_args().fewer, 1)
    if reason := desktop.why_not():
        sys.exit(f"The real QGIS can't be started: {reason}")
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(os.environ.get("SOAK", temporary))
        work.mkdir(parents=True, exist_ok=True)
        (work / "rounds.jsonl").unlink(missing_ok=True)
        block = work / "block"
        if not (block / "seamlines.gpkg").exists():
            make_block(block, extent_m=EXTENT_M)
        parameters = {
            "block": str(block), "work": str(work), "screenshots": str(work), "rounds": ROUNDS,
            "windows": max(WINDOWS // fewer, ROUNDS), "judged": max(JUDGED // fewer, ROUNDS),
        }  # fmt: skip
        run = desktop.play(SCENARIO, work / "run", parameters, seconds=SECONDS)
    rounds = run.report.get("rounds", [])
    if run.status != "passed" or run.raised or run.code != 0:
        print("\n".join([run.status, *run.raised, run.output, f"exit code {run.code}"]))
        return 1
    print(table(rounds))
    for place, count in Counter(place for row in rounds for place in row["stalled_at"]).most_common(8):
        print(f"stalled {count} times at {place or 'a place that is not Python'}")
    print(f"most of ours: {rounds[-1]['most_of_ours']}")
    result = grown(rounds)
    print("\n".join(result) or f"Nothing grew beyond its allowance in {run.seconds / 60:.0f} min.")
    return int(bool(result))


if __name__ == "__main__":
    sys.exit(main())
