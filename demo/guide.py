"""The guide's pictures of the plugin, made anew: `make pictures`, after `make demo`.

    python -m demo.guide --block output/demo/block --output docs/pictures --brighton FOLDER

Plays the first inspection in the real QGIS as docs/start/first_inspection.md tells it, draws the pictures of
docs/start/reading.md, and plays the desk and a scan on the Brighton mosaic where its folder is there.
"""
from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

from . import reading, screenshot
from .desktop import REPOSITORY, play, why_not
from .screenshot import as_jpeg

SCENARIO = REPOSITORY / "tests" / "desktop" / "scenarios" / "first_inspection.py"
SCREEN = "1300x920"
BRIGHTON = "mosaic_feather0p4m"
BRIGHTON_SIDE_M, BRIGHTON_SMALL_SIDE_M = 15.0, 1.9  # 512 and 64 px
BRIGHTON_PIECE_M = 5.0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--block", type=Path, required=True, help="folder that `make demo` left")
    parser.add_argument("--output", type=Path, required=True, help="folder for the pictures")
    parser.add_argument("--brighton", type=Path, help="folder with the real mosaic of the desk's pages")
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
    if arguments.brighton is None or not arguments.brighton.is_dir():
        print("The pictures of the desk and of a scan stay as they are: there is no folder with the Brighton mosaic.")
        return 0
    return screenshot.draw(
        arguments.brighton, arguments.output, BRIGHTON, BRIGHTON_SIDE_M, BRIGHTON_SMALL_SIDE_M, BRIGHTON_PIECE_M
    )


if __name__ == "__main__":
    sys.exit(main())
