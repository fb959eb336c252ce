"""A scanned photograph with four fiducial marks, its camera, and the marks as an operator pointed at them."""
from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from scipy import ndimage

from .files import texture, write_raster

CAMERA = {"1": (106.004, -106.002), "2": (-105.998, -105.998), "3": (-106.007, 106.006), "4": (106.0, 105.999)}
"""mm, x to the right, y upwards."""
SIDE = 900  # px
SCALE = 3.7  # px to the mm
TURN = 0.8  # degrees, clockwise
RING, LINE = 15.0, 3.5  # radius and width of a mark, px
FINE = 5  # parts of a pixel that a mark is drawn in
DARK, LIGHT = 40.0, 110.0
OPERATOR = 0.15  # px, standard deviation


def make_scanned_photo(folder: Path) -> None:
    """Write `photo.tif`, `camera.csv` and `by_hand.csv`."""
    folder.mkdir(parents=True, exist_ok=True)
    random = np.random.default_rng(2007)
    places = _places()
    grey = 125 + 40 * texture((SIDE, SIDE), 2, random)
    y, x = np.mgrid[:SIDE, :SIDE] + 0.5
    nearest = np.minimum.reduce([np.hypot(x - column, y - row) for column, row in places.values()])
    seen = DARK + np.clip((nearest - 2.2 * RING) / 3, 0, 1) * (grey - DARK)
    for place in places.values():
        _add_mark(seen, place)
    seen = ndimage.gaussian_filter(seen, 0.8) + 2 * random.standard_normal(seen.shape)
    write_raster(folder / "photo.tif", np.clip(np.rint(seen), 0, 255).astype(np.uint8)[np.newaxis])
    calibration = "".join(f"{name},{x},{y}\n" for name, (x, y) in CAMERA.items())
    more = "principal_point,0.004,-0.011\nfocal_length,152.961,\n"
    (folder / "camera.csv").write_text("mark,x_mm,y_mm\n" + calibration + more, encoding="utf-8")
    pointed = {name: np.array(place) + random.normal(0, OPERATOR, 2) for name, place in places.items()}
    rows = "".join(f"{name},{column:.2f},{row:.2f}\n" for name, (column, row) in pointed.items())
    (folder / "by_hand.csv").write_text("mark,column,row\n" + rows, encoding="utf-8")


def _places() -> Mapping[str, tuple[float, float]]:
    """Column and row of each mark."""
    c, s = math.cos(math.radians(TURN)), math.sin(math.radians(TURN))
    return {name: (SIDE / 2 + SCALE * (c * x + s * y), SIDE / 2 + SCALE * (s * x - c * y))
            for name, (x, y) in CAMERA.items()}


def _add_mark(seen: np.ndarray, place: tuple[float, float]) -> None:
    """A ring with a diagonal cross that is open in the middle."""
    half = int(RING + LINE) + 3
    left, top = int(place[0]) - half, int(place[1]) - half
    parts = (np.arange((2 * half + 1) * FINE) + 0.5) / FINE
    u, v = np.meshgrid(parts + left - place[0], parts + top - place[1])
    r = np.hypot(u, v)
    ring = np.abs(r - RING) <= LINE / 2
    arms = (np.minimum(np.abs(u - v), np.abs(u + v)) / math.sqrt(2) <= LINE / 2) & (r <= RING) & (r > 0.3 * RING)
    share = (ring | arms).reshape(2 * half + 1, FINE, 2 * half + 1, FINE).mean(axis=(1, 3))
    seen[top : top + 2 * half + 1, left : left + 2 * half + 1] += (LIGHT - DARK) * share
