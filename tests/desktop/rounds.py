"""300 rounds of new project, load, Place, Inspect in one run of the real QGIS.

None crashes it, and no windows are written without the mosaic's reference system.

    python -m tests.desktop.rounds [--fewer N]
"""
from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

from demo import desktop
from demo.block import make_block

ROUNDS = 300
EXTENT_M = (120.0, 80.0)
SECONDS = 4 * 3600
SCENARIO = Path(__file__).parent / "scenarios" / "rounds.py"


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fewer", type=int, default=1, help="how many times fewer rounds")
    rounds = max(ROUNDS // max(parser.parse_args().fewer, 1), 2)
    if reason := desktop.why_not():
        sys.exit(f"The real QGIS can't be started: {reason}")
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        make_block(work / "block", extent_m=EXTENT_M)
        run = desktop.play(SCENARIO, work / "run", {"block": str(work / "block"), "rounds": rounds}, seconds=SECONDS)
    unsound = run.report.get("unsound", [])
    if run.status != "passed" or run.raised or run.code != 0 or unsound:
        print("\n".join([run.status, *run.raised, run.output[-5000:], f"exit code {run.code}", *map(str, unsound)]))
        return 1
    print(f"{run.report['rounds']} rounds, every file in its mosaic's reference system, in {run.seconds / 60:.0f} min.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
