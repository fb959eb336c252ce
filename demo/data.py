"""Everything that the examples of the guide take: `make demo-data`.

    python -m demo.data FOLDER [--small]

The folder gets `block` (a mosaic, its five orthoimages, their index and the seamlines), `delivery` (twelve sheets,
four of them spoilt), `noise` (the same ground by a clean sensor and on film), `bars` (a bar target, the lines across
its groups, passes at three heights), `photo` (a scanned photograph with fiducial marks), `satellite` (an image with
its RPC, terrain and points), `flight` (two photos of a drone as OpenDroneMap orients them) and `judged` (windows that
an operator judged). What is there already stays as it is.
"""
from __future__ import annotations

import argparse
from pathlib import Path
from typing import Callable

from osgeo import gdal

from .block import EPSG
from .delivery import make_delivery
from .examples.bar_target import make_bar_target
from .examples.files import box, write_layer
from .examples.flight import make_flight
from .examples.judged_windows import make_judged_windows
from .examples.noise_pair import make_noise_pair
from .examples.satellite_scene import make_satellite_scene
from .examples.scanned_photo import make_scanned_photo
from .run import DONE, make_demonstration

SMALL = (250.0, 200.0)  # m, of a block that is made in a few seconds
INDEX = "sources.gpkg"


def make_data(folder: Path, small: bool = False, progress: Callable[[str], None] = print) -> None:
    """Make what is not there yet."""
    makers: dict[str, Callable[[Path], object]] = {
        "block": lambda place: make_demonstration(place, SMALL) if small else make_demonstration(place),
        "delivery": make_delivery,
        "noise": make_noise_pair,
        "bars": make_bar_target,
        "photo": make_scanned_photo,
        "satellite": make_satellite_scene,
        "flight": make_flight,
        "judged": make_judged_windows,
    }
    for name, make in makers.items():
        done = folder / name / DONE
        if not done.exists():
            progress(f"Making {folder / name}")
            make(folder / name)
            done.touch()
    if not (folder / "block" / INDEX).exists():
        _index(folder / "block")


def _index(block: Path) -> None:
    """The orthoimages of the block, as gdaltindex lists them."""
    features = []
    for path in sorted(block.glob("strip*.tif")):
        image = gdal.Open(str(path))
        left, pixel, _, top, _, _ = image.GetGeoTransform()
        outline = box(left, top - pixel * image.RasterYSize, left + pixel * image.RasterXSize, top)
        features.append((outline, {"location": path.name}))
    write_layer(block / INDEX, EPSG, features)


def main() -> None:
    """Command line: write all into a folder."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--small", action="store_true", help="a block of 250 x 200 m instead of 500 x 400 m")
    arguments = parser.parse_args()
    gdal.UseExceptions()  # GDAL 3.7 warns whoever leaves it open
    make_data(arguments.folder, arguments.small)


if __name__ == "__main__":
    main()
