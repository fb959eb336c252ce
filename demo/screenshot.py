"""Pictures of the inspection desk in the real QGIS, with the demonstration block inspected: part of `make demo`.

    python -m demo.screenshot --block output/demo/block --output output/demo

Leaves desk.png and desk_images.png in the output folder. Where there is no virtual screen it says so, and that is all.
"""
from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from .desktop import REPOSITORY, play, why_not

SCENARIO = REPOSITORY / "tests" / "desktop" / "scenarios" / "demo.py"
PICTURES = ("desk.png", "desk_images.png")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--block", type=Path, required=True, help="folder with mosaic.tif, orthoimages and seamlines")
    parser.add_argument("--output", type=Path, required=True, help="folder for the pictures")
    parser.add_argument("--side", type=float, default=100.0, help="window side in metres (100)")
    arguments = parser.parse_args()
    reason = why_not()
    if reason:
        print(f"No pictures of the desk: {reason}.")
        return 0
    print("Playing the same in the real QGIS, for pictures of the desk")
    with tempfile.TemporaryDirectory() as folder:
        shots = Path(folder) / "screenshots"
        parameters = {"block": str(arguments.block.resolve()), "side_m": arguments.side, "screenshots": str(shots)}
        run = play(SCENARIO, Path(folder), parameters, screen="1500x950")
        if run.status != "passed":
            print(f"No pictures of the desk: {run.status.strip().splitlines()[-1]}")
            return 0
        arguments.output.mkdir(parents=True, exist_ok=True)
        for name in PICTURES:
            shrink(shots / name)
            shutil.copy(shots / name, arguments.output / name)
    print(f"Pictures of the desk are in {arguments.output}: {', '.join(PICTURES)}")
    return 0


def shrink(picture: Path) -> None:
    """To fewer colours, where pngquant is there: the README shows them."""
    if shutil.which("pngquant"):
        options = ["--nofs", "--force", "--ext", ".png", "--skip-if-larger"]
        subprocess.run(["pngquant", "128", *options, str(picture)], check=False)


if __name__ == "__main__":
    sys.exit(main())
