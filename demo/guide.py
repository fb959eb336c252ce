"""The pictures of the guide's first pages, made anew: `make pictures`, after `make demo`.

    python -m demo.guide --block output/demo/block --output docs/pictures

Plays the first inspection in the real QGIS as docs/start/first_inspection.md tells it, and draws the pictures of
docs/start/reading.md.
"""
from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

from . import reading
from .desktop import REPOSITORY, play, why_not
from .screenshot import as_jpeg

SCENARIO = REPOSITORY / "tests" / "desktop" / "scenarios" / "first_inspection.py"
SCREEN = "1300x920"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--block", type=Path, required=True, help="folder that `make demo` left")
    parser.add_argument("--output", type=Path, required=True, help="folder for the pictures")
    arguments = parser.parse_args()
    reason = why_not()
    if reason:
        print(f"No pictures of the desk: {reason}.")
        return 1
    parameters = {
        "project": str((arguments.block / "block.qgz").resolve()),
        "screenshots": str(arguments.output.resolve()),
    }
    with tempfile.TemporaryDirectory() as folder:
        run = play(SCENARIO, Path(folder), parameters, seconds=900, screen=SCREEN)
    for picture in run.report.get("screenshots", []):
        as_jpeg(Path(picture))
    if run.status != "passed":
        print(f"Not all steps could be played: {run.status.strip().splitlines()[-1]}")
        return 1
    print(run.report["sentence"])
    reading.draw_all(arguments.block, arguments.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
