"""Pictures of the inspection desk in the real QGIS, with the demonstration block inspected: `make demo-pictures`.

    python -m demo.screenshot --block output/demo/block --output output/demo

Leaves desk.png and its kin in the output folder: everything the desk shows, then the desk on a small screen, in a dark
theme, at 200 % and in Polish. Where there is no virtual screen it says so, and that is all.
"""
from __future__ import annotations

import argparse
import io
import sys
import tempfile
from pathlib import Path
from typing import Any

from PIL import Image

from .desktop import REPOSITORY, play, why_not

SCENARIO = REPOSITORY / "tests" / "desktop" / "scenarios" / "pictures.py"
STARTS: dict[str, dict[str, Any]] = {
    "": {"screen": "1280x860"},
    "desk_small": {"screen": "1366x768"},
    "desk_dark": {"screen": "1366x850", "theme": "Night Mapping"},
    "desk_200": {"screen": "2800x1800", "scale": 2},
    "desk_polish": {"screen": "1366x850", "locale": "pl"},
}
"""How QGIS is started for a picture; without a name, for all that the desk shows."""
MOST_BYTES = 300_000
COLOURS = (256, 128, 64, 32)
_OCTREE, _NO_DITHER = 2, 0  # the median cut, Pillow's default, gives a chart's colours away for more greens of a meadow


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--block", type=Path, required=True, help="folder with mosaic.tif, orthoimages and seamlines")
    parser.add_argument("--output", type=Path, required=True, help="folder for the pictures")
    parser.add_argument("--mosaic", default="mosaic", help="name of the mosaic in that folder (mosaic)")
    parser.add_argument("--side", type=float, default=50.0, help="window side in metres (50)")
    parser.add_argument("--small-side", type=float, default=12.8, help="the same where there are many (12.8)")
    parser.add_argument("--piece", type=float, default=25.0, help="pieces of a scan in metres (25)")
    arguments = parser.parse_args()
    reason = why_not()
    if reason:
        print(f"No pictures of the desk: {reason}.")
        return 0
    chosen = arguments
    return draw(chosen.block, chosen.output, chosen.mosaic, chosen.side, chosen.small_side, chosen.piece)


def draw(block: Path, output: Path, mosaic: str, side_m: float, small_side_m: float, piece_m: float) -> int:
    """All pictures of the desk with a block; 1 where one could not be drawn."""
    print("Playing the desk in the real QGIS; it takes some minutes")
    output.mkdir(parents=True, exist_ok=True)
    parameters = {
        "block": str(block.resolve()),
        "mosaic": mosaic,
        "side_m": side_m,
        "spacing_m": 2 * side_m,
        "small_side_m": small_side_m,
        "piece_m": piece_m,
        "screenshots": str(output.resolve()),
    }
    failed = 0
    for name, options in STARTS.items():
        with tempfile.TemporaryDirectory() as folder:
            run = play(SCENARIO, Path(folder), {**parameters, "name": name}, seconds=500, **options)
        pictures = [Path(path) for path in run.report.get("screenshots", [])]
        for picture in pictures:
            shrink(picture)
        if run.status != "passed":
            failed = 1
            print(f"Not all pictures of the desk: {run.status.strip().splitlines()[-1]}")
        else:
            print(f"Pictures of the desk are in {output}: {', '.join(picture.name for picture in pictures)}")
    return failed


def shrink(picture: Path) -> None:
    """To fewer colours, as many as a page can carry."""
    with Image.open(picture) as opened:
        image = opened.convert("RGB")
    for colours in COLOURS:
        written = io.BytesIO()
        image.quantize(colours, method=_OCTREE, dither=_NO_DITHER).save(written, "PNG", optimize=True)
        if written.tell() <= MOST_BYTES:
            break
    picture.write_bytes(written.getvalue())


def as_jpeg(picture: Path) -> None:
    """In its place: a palette would mix up the colours of a legend that stands over a photograph."""
    with Image.open(picture) as opened:
        opened.convert("RGB").save(picture.with_suffix(".jpg"), quality=88, subsampling=0, optimize=True)
    picture.unlink()


if __name__ == "__main__":
    sys.exit(main())
