"""A bar target as a camera saw it that is sharper across the flight than along, the lines across its groups, and passes
over such a target at three heights.
"""
from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy import ndimage

from demo.block import EASTING, EPSG, NORTHING

from .files import Value, write_layer, write_raster

PIXEL = 0.05  # m
GROUPS = range(5, 18, 2)
STEP = 2 ** (1 / 6)
REFERENCE, REFERENCE_CM = 9, 30.0
FINE = 8  # parts of a pixel that the target is drawn in
DARK, BRIGHT = 25.0, 190.0  # DN
BLUR = {"along": 1.3, "across": 0.9}  # sigma, px
NOISE = 1.0  # DN
SPACE, MARGIN = 8, 20  # px between groups, around all
SEEN = {"along": 11, "across": 13}  # the finest group that the observer told apart


@dataclass(frozen=True)
class Group:
    """Three bars. Lengths in pixels, the middle as column and row."""

    number: int
    direction: str
    column: float
    row: float
    cycle: float

    @property
    def width(self) -> float:
        """From the first bar to the last; bars are as long."""
        return 2.5 * self.cycle


def make_bar_target(folder: Path) -> None:
    """Write `target.tif`, `groups.gpkg` and `passes.csv`."""
    folder.mkdir(parents=True, exist_ok=True)
    random = np.random.default_rng(9)
    groups, columns, rows = _layout()
    seen = np.zeros((rows, columns))
    for direction, sigma in BLUR.items():
        drawn = np.zeros((rows * FINE, columns * FINE), np.float32)
        for group in groups:
            if group.direction == direction:
                _draw(drawn, group)
        drawn = ndimage.gaussian_filter(drawn, sigma * FINE)
        seen += drawn.reshape(rows, FINE, columns, FINE).mean(axis=(1, 3))
    noise = NOISE * random.standard_normal((3, rows, columns))
    pixels = np.clip(np.rint(DARK + (BRIGHT - DARK) * seen + noise), 0, 255).astype(np.uint8)
    write_raster(folder / "target.tif", pixels, EPSG, (EASTING, NORTHING, PIXEL))
    write_layer(folder / "groups.gpkg", EPSG, ((_line(group), _fields(group)) for group in groups))
    _write_passes(folder / "passes.csv", random)


def _layout() -> tuple[list[Group], int, int]:
    """Two rows of groups, along the flight above; columns and rows of the picture."""
    groups: list[Group] = []
    column, top = float(MARGIN), float(MARGIN)
    for number in GROUPS:
        cycle = REFERENCE_CM / 100 / PIXEL * STEP ** (REFERENCE - number)
        width = 2.5 * cycle
        middle = column + width / 2
        groups.append(Group(number, "along", middle, top + width / 2, cycle))
        groups.append(Group(number, "across", middle, top + 45 + width / 2, cycle))
        column += width + SPACE
    return groups, int(column) + MARGIN, int(top) + 45 + 26 + MARGIN


def _draw(drawn: np.ndarray, group: Group) -> None:
    """Bars that lie side by side along the columns for the flight's direction, along the rows for the other."""
    half = group.width / 2
    for number in range(3):
        start = number * group.cycle - half
        across, along = (start, start + group.cycle / 2), (-half, half)
        (left, right), (upper, lower) = (across, along) if group.direction == "along" else (along, across)
        columns = slice(round((group.column + left) * FINE), round((group.column + right) * FINE))
        rows = slice(round((group.row + upper) * FINE), round((group.row + lower) * FINE))
        drawn[rows, columns] = 1


def _line(group: Group) -> str:
    """Across the bars, from ground to ground."""
    reach = 0.6 * group.width
    dx, dy = (reach, 0.0) if group.direction == "along" else (0.0, reach)
    ends = ((group.column - dx, group.row - dy), (group.column + dx, group.row + dy))
    return f"LINESTRING ({', '.join(f'{EASTING + x * PIXEL} {NORTHING - y * PIXEL}' for x, y in ends)})"


def _fields(group: Group) -> dict[str, Value]:
    seen = "visible" if group.number <= SEEN[group.direction] else "invisible"
    return {"group": group.number, "direction": group.direction, "observer": seen}


def _write_passes(path: Path, random: np.random.Generator) -> None:
    """Five passes at each height, read by two observers."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["sensor", "image_type", "direction", "height", "grd", "grd_2"])
        for direction, centimetres in (("along", 0.0125), ("across", 0.0118)):  # at 1 m above the target
            for height in (1500, 2000, 2500):
                for _ in range(5):
                    flown = height + random.normal(0, 15)
                    read = centimetres * flown * (1 + random.normal(0, 0.03, 2))
                    readings = [f"{one:.1f}" for one in read]
                    table.writerow(["KS-87", "black and white", direction, f"{flown:.0f}", *readings])
