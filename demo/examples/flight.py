"""Two photos of a drone, their orientations and the surface below, in the folders that OpenDroneMap leaves."""
from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
from osgeo import osr
from scipy import ndimage

from .files import system, texture, write_raster

COLUMNS, ROWS, FOCAL = 600, 400, 0.8  # px, focal length in widths of the photo
UTM, CORNER, PIXEL, SIDE = 32634, (419_600.0, 5_545_400.0), 0.5, 1600  # of the ground: upper left, m, px
MIDDLE = (CORNER[0] + SIDE * PIXEL / 2, CORNER[1] - SIDE * PIXEL / 2)  # the reconstruction's reference
GROUND, HEIGHT = 300.0, 240.0  # m above the ellipsoid, of the flight above it
PLACES = ((-40.0, 0.0, 5.0), (40.0, 10.0, -5.0))  # m east and north of the reference, kappa in degrees


def make_flight(folder: Path) -> None:
    """Write `opensfm/reconstruction.json`, `images` and `odm_dem/dsm.tif`."""
    for name in ("opensfm", "images", "odm_dem"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    ground = 120 + 30 * texture((SIDE, SIDE), 2, np.random.default_rng(1912))
    rows, columns = np.mgrid[:ROWS, :COLUMNS] + 0.5
    step = HEIGHT / (FOCAL * COLUMNS)
    shots = {}
    for number, (east, north, kappa) in enumerate(PLACES, 1):
        sine, cosine = math.sin(math.radians(kappa)), math.cos(math.radians(kappa))
        across, up = (columns - COLUMNS / 2) * step, (ROWS / 2 - rows) * step
        x, y = east + cosine * across - sine * up, north + sine * across + cosine * up
        seen = ndimage.map_coordinates(ground, [SIDE / 2 - y / PIXEL, SIDE / 2 + x / PIXEL], order=1)
        write_raster(folder / "images" / f"DJI_{number:04d}.tif", np.clip(seen, 0, 255).astype(np.uint8)[np.newaxis])
        turn = np.array([[cosine, sine, 0], [sine, -cosine, 0], [0, 0, -1]])
        half = math.radians(kappa) / 2  # half a turn about this axis makes the camera look down
        shots[f"DJI_{number:04d}.tif"] = {
            "rotation": [math.pi * math.cos(half), math.pi * math.sin(half), 0.0],
            "translation": (-turn @ [east, north, GROUND + HEIGHT]).tolist(), "camera": "v2 drone",
        }  # fmt: skip
    camera = {"projection_type": "perspective", "width": COLUMNS, "height": ROWS, "focal": FOCAL, "k1": 0.0, "k2": 0.0}
    longitude, latitude, _ = osr.CoordinateTransformation(system(UTM), system(4326)).TransformPoint(*MIDDLE)
    reference = {"longitude": longitude, "latitude": latitude, "altitude": 0.0}
    document = [{"cameras": {"v2 drone": camera}, "shots": shots, "reference_lla": reference}]
    (folder / "opensfm" / "reconstruction.json").write_text(json.dumps(document, indent=1), encoding="utf-8")
    flat = np.full((1, SIDE // 4, SIDE // 4), GROUND, np.float32)
    write_raster(folder / "odm_dem" / "dsm.tif", flat, UTM, (*CORNER, 4 * PIXEL))
