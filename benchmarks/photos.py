"""The interior orientation of a whole scanned frame against its bare read and against one template in OpenCV."""
from __future__ import annotations

import tempfile
from functools import partial
from pathlib import Path

import cv2
import numpy as np
from osgeo import gdal
from scipy import ndimage
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.photos.measure import limits
from seam_inspector.plugin.photos.measure.camera_calibration import CameraCalibration
from seam_inspector.plugin.photos.measure.interior_orientation import orient_photo
from seam_inspector.plugin.photos.measure.mark_templates import MarkShape, draw
from seam_inspector.plugin.photos.measure.orientation import OrientationSettings
from seam_inspector.plugin.photos.measure.photo import Photo

from .ground import Ground
from .timing import Goal, interleaved, print_table

SIDE_PX = 5600  # 42 um on a photo of 23 cm
SPAN_MM = 212.0
MOST_SECONDS = 5.0
CAMERA = {"1": (106.0, -106.0), "2": (-106.0, -106.0), "3": (-106.0, 106.0), "4": (106.0, 106.0)}
MARK = MarkShape(limits.RING_WITH_CROSS, 38.0, diagonal=True, interrupted=True, softness=1.5)


def scanned_frame(picture: np.ndarray, path: Path) -> np.ndarray:
    """Write a photo of ``picture`` (rows, columns) with a mark in each dark corner; return one mark, cut out."""
    repeats = [-(-SIDE_PX // side) for side in picture.shape]
    pixels = np.tile(picture, repeats)[:SIDE_PX, :SIDE_PX].astype(np.float64)
    scale = 0.9 * SIDE_PX / SPAN_MM
    half, cut = 120, 40
    for x, y in CAMERA.values():
        column, row = (round(SIDE_PX / 2 + scale * along) for along in (x, -y))
        pixels[row - half : row + half + 1, column - half : column + half + 1] = 40 + 60 * draw(MARK, margin=half)
    pixels += ndimage.gaussian_filter(np.random.default_rng(7).standard_normal(pixels.shape), 0.5) * 6
    made = np.clip(np.rint(pixels), 0, 255).astype(np.uint8)
    memory = gdal.GetDriverByName("MEM").Create("", SIDE_PX, SIDE_PX, 1, gdal.GDT_Byte)
    memory.WriteArray(made)
    gdal.Translate(str(path), memory, format="JPEG", creationOptions=["QUALITY=90"])
    return made[row - cut : row + cut + 1, column - cut : column + cut + 1]


def bare_read(path: Path) -> np.ndarray:
    """All pixels by GDAL alone."""
    return np.asarray(gdal.Open(str(path)).ReadAsArray())


def one_template(path: Path, mark: np.ndarray) -> object:
    """One mark, cut out of this very photo, looked for in the whole of it: to the pixel, upright, in one size."""
    return cv2.minMaxLoc(cv2.matchTemplate(bare_read(path), mark, cv2.TM_CCOEFF_NORMED))


def whole(path: Path) -> None:
    """Four marks of a kind, size and angle that nobody says, to a fraction of a pixel, and the transformation."""
    made = orient_photo(Photo(RasterRef(str(path))), CameraCalibration(CAMERA), {}, OrientationSettings())
    assert made.count(limits.MEASURED) == len(CAMERA)


def run(ground: Ground, quick: bool) -> list[Goal]:
    """Print the time of a whole frame."""
    with tempfile.TemporaryDirectory(prefix="seam_inspector_") as folder:
        path = Path(folder) / "photo.jpg"
        mark = scanned_frame(ground.pixels()[1], path)
        ours, read, peer = interleaved(
            [partial(whole, path), partial(bare_read, path), partial(one_template, path, mark)], 1 if quick else 3
        )
    seconds = sorted(ours.cpu)[len(ours.cpu) // 2]
    print_table(
        f"Interior orientation of a frame of {SIDE_PX} x {SIDE_PX} px, nothing known but the calibration",
        ["", "time", "over the bare read", "over one template in OpenCV"],
        [
            ["interior orientation", ours.milliseconds, str(ours.over(read)), str(ours.over(peer))],
            ["one template in OpenCV", peer.milliseconds, str(peer.over(read)), ""],
            ["bare read", read.milliseconds, "", ""],
        ],
    )
    return [Goal("interior orientation of a frame: seconds of one core", MOST_SECONDS, seconds, at_least=False)]
