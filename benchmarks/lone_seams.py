"""How well seams are judged without orthoimages: `python -m benchmarks.lone_seams`, with SEAM_INSPECTOR_DATA set.

Orthoimages of Brighton are cut or feathered along seams that are known, with what production does afterwards; all
seams of one making stand for one mosaic. Printed: what all of them keep with its interval and what is true; of pieces
of 256 px how often the interval covers the truth, holds 1, and tells a loss or that there is none. Seams are random, or
led through smooth ground as mosaicking software leads them. Constants were set in the west (the default), ``--half
east`` is held back. Then both Brighton mosaics along their own seam lines.
"""
from __future__ import annotations

import argparse
import os
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from unittest.mock import Mock

import numpy as np
from osgeo import gdal, ogr
from scipy import ndimage
from seam_inspector.plugin.imagery.grids import Grid, PixelWindow
from seam_inspector.plugin.imagery.lines import find_seams
from seam_inspector.plugin.imagery.rasters import Raster
from seam_inspector.plugin.seams.measure.compared_image import ComparedImage
from seam_inspector.plugin.seams.measure.profile.cell_table import CELL_PX
from seam_inspector.plugin.seams.measure.scan.lone_kept import LoneSeams
from seam_inspector.plugin.seams.measure.scan.lone_stretches import (
    REACH_PX,
    STRIP_PX,
    ZONES_PX,
    LoneStretches,
    LoneTable,
    lone_cells,
    lone_stretches,
)
from seam_inspector.plugin.seams.measure.seamlines.seam_pieces import PieceIndex, SeamPiece, SidedSeam, cut_in_pieces
from skimage import graph, measure

from . import aftermaths as after
from .known_windows import Imagery, brighton, crooked_cut, hard_cut
from .seam_makings import Change, feather
from .timing import print_table

PIECE_PX = 256.0
SIDES_PX = (416, 1000)
MIN_VALID = 0.97
MIN_SHARE = 0.15
TRIES = 60_000
LUMINANCE = np.array([0.299, 0.587, 0.114], np.float32)
MAKINGS: dict[str, tuple[float, str] | None] = {
    "hard cut": None, "cosine 13 px": (13, "cosine"), "cosine 33 px": (33, "cosine"), "cosine 66 px": (66, "cosine"),
    "Gaussian, sigma 13.3 px": (13.3, "gaussian"), "cosine 128 px": (128, "cosine"), "linear 256 px": (256, "linear"),
}
AFTERMATHS: dict[str, Change] = {
    "": after.nothing, "unsharp 1": after.unsharp(1.0), "JPEG 75": after.jpeg(75), "JPEG 50": after.jpeg(50),
    "noise 5 DN": after.noise(5),
}
PLAIN = ("hard cut", "cosine 33 px", "Gaussian, sigma 13.3 px")
"""These with every aftermath."""
HEADER = (
    "seam and aftermath", "true", "all seams", "band px", "pieces", "covered", "holds 1", "loss", "sound", "needed px",
)


@dataclass(frozen=True, eq=False)
class Region:
    """Ground that two orthoimages show."""

    first: np.ndarray
    """(bands, rows, columns) 8 bit."""
    second: np.ndarray
    valid: np.ndarray
    """(rows, columns) bool."""


@dataclass(frozen=True, eq=False)
class Measured:
    """Stretches of one seam, and what its pieces truly kept."""

    stretches: LoneStretches
    energy: np.ndarray
    """(pieces,) of the finest detail in their strips."""


def regions(imagery: Imagery, east: bool, count: int, rng: np.random.Generator) -> Iterator[Region]:
    """Random ones in one half of the imagery."""
    half = imagery.columns // 2
    for _ in range(TRIES):
        a, b = (imagery.placed[i] for i in rng.choice(len(imagery.placed), 2, replace=False))
        top, bottom = max(a.row, b.row), min(a.row + a.bands.shape[1], b.row + b.bands.shape[1])
        left, right = max(a.column, b.column), min(a.column + a.bands.shape[2], b.column + b.bands.shape[2])
        left, right = (max(left, half), right) if east else (left, min(right, half))
        if min(bottom - top, right - left) < SIDES_PX[0]:
            continue
        height, width = (
            min(length, int(rng.integers(*SIDES_PX))) // CELL_PX * CELL_PX for length in (bottom - top, right - left)
        )
        row = top + int(rng.integers(bottom - top - height + 1))
        column = left + int(rng.integers(right - left - width + 1))
        first, second = (
            one.bands[:3, row - one.row : row - one.row + height, column - one.column : column - one.column + width]
            for one in (a, b)
        )
        valid = (first != 0).any(axis=0) & (second != 0).any(axis=0)
        if valid.mean() >= MIN_VALID:
            yield Region(first, second, valid)
            count -= 1
        if not count:
            return


def random_cut(region: Region, rng: np.random.Generator) -> np.ndarray:
    """Labels along a random crooked line."""
    rows, columns = region.valid.shape
    side = max(rows, columns)
    top, left = (side - rows) // 2, (side - columns) // 2
    return crooked_cut(side, rng)[top : top + rows, left : left + columns].astype(np.uint8)


def led_cut(region: Region, rng: np.random.Generator) -> np.ndarray | None:
    """Labels along the cheapest way from top to bottom: through ground that is alike in both images, or smooth."""
    rows, columns = region.valid.shape
    first, second = (np.tensordot(LUMINANCE, one.astype(np.float32), 1) for one in (region.first, region.second))
    difference = np.abs(first - second)
    costs = (
        lambda: ndimage.gaussian_filter(difference, 1.0) + 3,
        lambda: ndimage.gaussian_filter(difference, 4.0) + ndimage.gaussian_gradient_magnitude(first, 2.0) + 2,
        lambda: ndimage.gaussian_filter(np.abs(first - ndimage.gaussian_filter(first, 8)), 4.0) + 2,
    )
    cost = np.where(region.valid, costs[int(rng.integers(len(costs)))](), 1e4)
    ends = [(row, int(rng.integers(columns // 4, 3 * columns // 4))) for row in (0, rows - 1)]
    path = np.array(graph.route_through_array(cost, *ends, fully_connected=False)[0])
    free = np.ones((rows, columns), bool)
    free[tuple(path.T)] = False
    parts, count = ndimage.label(free)
    if count < 2:
        return None
    one, other = np.argsort(np.bincount(parts.ravel())[1:])[::-1][:2] + 1
    labels = ndimage.distance_transform_edt(parts != one) < ndimage.distance_transform_edt(parts != other)
    return labels.astype(np.uint8) if MIN_SHARE < labels.mean() < 1 - MIN_SHARE else None


def pieces_of(labels: np.ndarray, grid: Grid) -> list[SeamPiece]:
    """The border between two labels, straightened as a traced seam is."""
    line = max(measure.find_contours(labels.astype(float), 0.5), key=len) + 0.5
    line = ndimage.gaussian_filter1d(line, 1.5, axis=0, mode="nearest")[::3]
    return cut_in_pieces([SidedSeam(np.column_stack([line[:, 1], grid.rows - line[:, 0]]), None, None)], PIECE_PX, grid)


def measured(bands: np.ndarray, valid: np.ndarray, pieces: Sequence[SeamPiece], grid: Grid) -> Measured:
    """A whole mosaic at once."""
    window = PixelWindow(0, 0, *(length // CELL_PX * CELL_PX for length in (grid.columns, grid.rows)))
    bands, valid = bands[:, : window.height, : window.width], valid[: window.height, : window.width]
    index = PieceIndex(pieces, grid)
    plane = np.tensordot(LUMINANCE, bands.astype(np.float32), 1)
    image = ComparedImage(bands, (), {}, {}, Mock(Raster), valid=valid, judged=plane)
    table = lone_cells(image, window, window, index, "coif3")
    found = lone_stretches(table, pieces, range(len(pieces)), index, grid.ground_sample_distance)
    return Measured(found, _energy(table, index, len(pieces)))


def _energy(table: LoneTable, index: PieceIndex, count: int) -> np.ndarray:
    strip = table.chosen(table.bin < ZONES_PX.index(STRIP_PX))
    number = index.beside((strip.column + 0.5) * CELL_PX, (strip.row + 0.5) * CELL_PX, REACH_PX).number
    return np.bincount(number, strip.energy, count)


def row_of(name: str, made: Sequence[Measured], hard: Sequence[Measured], pixel_m: float = 1.0) -> tuple[str, ...]:
    """One mosaic's line of the table; ``hard``: the same seams cut hard, with the same aftermath."""
    first, stretches, seam_ids = 0, [], []
    for number, one in enumerate(made):
        stretches.append(replace(one.stretches, piece=one.stretches.piece + first))
        seam_ids += [number] * len(one.energy)
        first += len(one.energy)
    energy, of_hard = (np.concatenate([one.energy for one in several]) for several in (made, hard))
    return line_of(name, LoneStretches.joined(stretches), seam_ids, energy, of_hard, pixel_m)


def line_of(
    name: str, stretches: LoneStretches, seam_ids: Sequence[int], energy: np.ndarray, hard: np.ndarray, pixel_m: float
) -> tuple[str, ...]:
    seams = LoneSeams(stretches, seam_ids)
    whole = seams.kept()
    found = [(one, share) for one, share in zip(seams.by_piece(), energy / np.maximum(hard, 1)) if one]
    if whole is None or not found:
        return (name, *["-"] * (len(HEADER) - 1))
    own = [one for one, _ in found]
    shares = [
        np.mean([one.low <= share <= one.high for one, share in found]),
        np.mean([one.low <= 1 <= one.high for one in own]),
        np.mean([one.tells_loss for one in own]),
        np.mean([one.tells_sound for one in own]),
    ]
    needed = seams.judgeable_px
    return (
        name, f"{energy.sum() / hard.sum():.2f}", f"{whole.kept:.2f} [{whole.low:.2f}, {whole.high:.2f}]",
        f"{whole.band_width_px:.0f}", str(len(found)), *(f"{100 * share:.0f} %" for share in shares),
        "-" if needed is None else f"{needed:.0f}",
    )


def simulated(imagery: Imagery, east: bool, led: bool, count: int) -> None:
    """Print the table of one half."""
    rng = np.random.default_rng([east, led])
    found: dict[tuple[str, str], list[Measured]] = {}
    for number, region in enumerate(regions(imagery, east, count, rng)):
        labels = led_cut(region, rng) if led else random_cut(region, rng)
        grid = Grid(0.0, float(region.valid.shape[0]), 1.0, 1.0, *region.valid.shape[::-1])
        pieces = [] if labels is None or labels.min() == labels.max() else pieces_of(labels, grid)
        if labels is None or not pieces:
            continue
        sources = [region.first, region.second]
        for making, shape in MAKINGS.items():
            mosaic = hard_cut(sources, labels) if shape is None else feather(sources, labels, *shape)
            for aftermath, change in AFTERMATHS.items():
                if not aftermath or making in PLAIN:
                    bands = change(mosaic, np.random.default_rng(number))
                    found.setdefault((making, aftermath), []).append(measured(bands, region.valid, pieces, grid))
    kind = "seams led through smooth ground" if led else "random seams"
    rows = [
        row_of(", ".join(part for part in key if part), made, found["hard cut", key[1]]) for key, made in found.items()
    ]
    length = sum(one.stretches.length_px.sum() for one in found["hard cut", ""])
    print_table(f"{'East, held back' if east else 'West'}: {kind}, {length:.0f} px of seam", HEADER, rows)


def real(folder: Path, piece_m: float) -> None:
    """Print what both Brighton mosaics keep along their own seam lines."""
    files = {name: gdal.Open(str(folder / f"mosaic_{name}.tif")) for name in ("hardseam", "feather0p4m")}
    left, width, _, top, _, height = files["hardseam"].GetGeoTransform()
    grid = Grid(left, top, width, -height, files["hardseam"].RasterXSize, files["hardseam"].RasterYSize)
    source = ogr.Open(str(folder / "seamlines.gpkg"))
    lines = [bytes(one.GetGeometryRef().ExportToWkb()) for one in source.GetLayerByName("seamlines")]
    pieces = cut_in_pieces([SidedSeam(one.vertices, None, None) for one in find_seams(lines, width)], piece_m, grid)
    seam_ids = [piece.seam_id for piece in pieces]
    rows = []
    for aftermath, change in AFTERMATHS.items():
        made = {}
        for name, file in files.items():
            bands = file.ReadAsArray()[:3]
            made[name] = measured(change(bands, np.random.default_rng(0)), (bands != 0).any(axis=0), pieces, grid)
            both = made[name].energy, made["hardseam"].energy
            title = ", ".join(part for part in (name, aftermath) if part)
            rows.append(line_of(title, made[name].stretches, seam_ids, *both, width))
    print_table(f"Brighton's own seams in {len(pieces)} pieces of {piece_m:g} m", HEADER, rows)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.lone_seams", description=__doc__.split("\n")[0])
    parser.add_argument("--half", choices=("west", "east"), default="west", help="east is held back")
    parser.add_argument("--seams", type=int, default=60, help="random ones, and as many led ones")
    arguments = parser.parse_args()
    data = os.environ.get("SEAM_INSPECTOR_DATA")
    if not data:
        print("Set SEAM_INSPECTOR_DATA to the folder of the real data.")
        return 1
    gdal.UseExceptions()
    started = time.perf_counter()
    folder = Path(data) / "seams" / "brighton"
    for piece_m in (PIECE_PX * 0.03, 25.0):
        real(folder, piece_m)
    imagery = brighton(folder)
    for led in (False, True):
        simulated(imagery, arguments.half == "east", led, arguments.seams)
    print(f"\n{time.perf_counter() - started:.0f} s")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
