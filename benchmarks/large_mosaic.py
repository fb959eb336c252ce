"""A large mosaic with two orthoimages over all of it: the demonstration's ground, mirrored on and on."""
from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from osgeo import gdal, gdal_array, ogr

from demo.block import EASTING, EXPOSURES, NORTHING, reference_system
from demo.camera import Box, take
from demo.canvas import PIXEL
from demo.scene import make_scene

from .ground import FORMATS, TILES

FORMATS_SCANNED = ("JPEG 75", "DEFLATE", "uncompressed")
GROUND_PX = 2200
"""Side of the ground that is drawn, no multiple of a tile; beyond, it is mirrored."""
MARGIN_M = 6.0
BAND_PX = (1.0, 8.0, 1.0, 33.0)
"""Full width in which the sources are mixed along each seam; 1: a hard cut."""
BETWEEN_PX = 20
"""How far beside a seam its sources are looked up."""
STRIP_ROWS = 500

Say = Callable[[str], None]


@dataclass(frozen=True, eq=False)
class KnownSeam:
    """A seam from crossing to crossing."""

    vertices: np.ndarray
    """(n, 2) on the map."""
    left: int
    """Number of the source on the left of who walks along it, 1 or 2 as among the files."""
    right: int

    def feature(self, files: Sequence[Path]) -> tuple[dict[str, object], bytes]:
        """Attributes and WKB, as a layer of seamlines has them."""
        line = ogr.Geometry(ogr.wkbLineString)
        for x, y in self.vertices.tolist():
            line.AddPoint_2D(x, y)
        return {"left": files[self.left].name, "right": files[self.right].name}, bytes(line.ExportToWkb())


@dataclass(frozen=True)
class LargeMosaic:
    """The files, and the seams they were made with."""

    side: int
    """Side of the mosaic and both sources, px."""
    files: dict[str, tuple[Path, ...]]
    """Files by format, the mosaic first."""
    seams: tuple[KnownSeam, ...]

    @property
    def megapixels(self) -> float:
        """Megapixels of the mosaic."""
        return self.side**2 / 1e6

    @property
    def seam_px(self) -> float:
        """Length of all seams."""
        return sum(float(np.hypot(*np.diff(seam.vertices, axis=0).T).sum()) for seam in self.seams) / PIXEL


class Layout:
    """Two seams across and two down, crooked; every seam changes over from one source to the other."""

    def __init__(self, side: int, rng: np.random.Generator, bands_px: Sequence[float] = BAND_PX) -> None:
        self.side, self._bands_px = side, bands_px
        self._phases = rng.uniform(0, 2 * np.pi, (4, 3))

    def place(self, seam: int, along: np.ndarray) -> np.ndarray:
        """Column of seams 0 and 1 at rows, row of seams 2 and 3 at columns, px."""
        waves = ((60.0, 1700.0), (20.0, 430.0), (5.0, 90.0))
        bends = sum(size * np.sin(2 * np.pi * along / length + phase)
                    for (size, length), phase in zip(waves, self._phases[seam]))
        return (1 + seam % 2) / 3 * self.side + bends

    def share(self, rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
        """Share of the second source, (rows, columns) float32."""
        share = np.zeros((len(rows), len(columns)), np.float32)
        for seam, width in enumerate(self._bands_px):
            beyond = (columns - self.place(seam, rows)[:, None] if seam < 2
                      else rows[:, None] - self.place(seam, columns))
            own = np.clip(beyond / np.float32(width) + np.float32(0.5), 0, 1).astype(np.float32)
            share += own - 2 * share * own  # the sides change over
        return share

    def lines(self) -> Iterator[np.ndarray]:
        """Vertices (n, 2) column, row of the seams from crossing to crossing."""
        along = np.arange(0.0, self.side + 1, 4.0)
        for seam in range(4):
            others = (2, 3) if seam < 2 else (0, 1)
            across = self.place(seam, along)
            sides = sum((along > self.place(other, across)).astype(int) for other in others)
            for part in range(len(others) + 1):
                inside = np.flatnonzero(sides == part)
                inside = np.append(inside, inside[-1] + 1)[: len(along)] if inside[-1] + 1 < len(along) else inside
                vertices = np.column_stack([across[inside], along[inside]])
                yield vertices if seam < 2 else vertices[:, ::-1]

    def source_beside(self, vertices: np.ndarray, sign: int) -> int:
        """Which source lies beside the middle of a line: left of it (-1) or right (1), as one walks along it."""
        middle = len(vertices) // 2
        dx, dy = vertices[middle + 1] - vertices[middle - 1]
        normal = np.array([-dy, dx]) / np.hypot(dx, dy)  # to the right, since rows run down
        column, row = vertices[middle] + sign * BETWEEN_PX * normal
        return round(float(self.share(np.array([row]), np.array([column]))[0, 0]))


def draw_ground() -> tuple[np.ndarray, np.ndarray]:
    """Two photographs of one ground, on one grid, in one tone, 8 bit (3, GROUND_PX, GROUND_PX) each."""
    rng = np.random.default_rng(2010)
    side_m = GROUND_PX * PIXEL
    scene = make_scene((side_m, side_m), 2 * MARGIN_M, rng)
    footprint = Box(-MARGIN_M, -MARGIN_M, side_m + MARGIN_M, side_m + MARGIN_M)
    cut = []
    for exposure in EXPOSURES[:2]:
        image = take(scene, exposure, footprint, rng)
        left, top = (round(-start / PIXEL) for start in (image.left, image.top))
        cut.append(image.pixels[:, top : top + GROUND_PX, left : left + GROUND_PX])
        assert cut[-1].any(axis=0).all()
    return cut[0], cut[1]


def levelled(image: np.ndarray, like: np.ndarray) -> np.ndarray:
    """An 8-bit image with mean and deviation of another one, band by band."""
    tables = [
        np.clip(np.rint((np.arange(256) - own.mean()) * (other.std() / own.std()) + other.mean()), 1, 255)
        for own, other in zip(image, like)
    ]
    return np.stack([table.astype(np.uint8)[own] for table, own in zip(tables, image)])


def make_large_mosaic(folder: Path, side: int, formats: tuple[str, ...] = FORMATS_SCANNED,
                      say: Say = lambda words: None, bands_px: Sequence[float] = BAND_PX) -> LargeMosaic:
    """Write mosaic and sources of ``side`` px in all formats, telling what is under way. ``bands_px``: widths of the
    feathers along its four seams."""
    say("drawing the ground and photographing it twice")
    first, second = draw_ground()
    in_tone = levelled(second, first)  # the mosaic is levelled, the sources stay as they are
    layout = Layout(side, np.random.default_rng(14), bands_px)
    mirrored = np.arange(side) % (2 * GROUND_PX)
    mirrored = np.minimum(mirrored, 2 * GROUND_PX - 1 - mirrored)
    names = ("mosaic", "first", "second")
    files: dict[str, list[Path]] = {one: [] for one in formats}
    for name, of in zip(names, (None, first, second)):
        pixels = np.empty((3, side, side), np.uint8)
        for top in range(0, side, STRIP_ROWS):
            rows = np.arange(top, min(top + STRIP_ROWS, side))
            part = np.ix_(range(3), mirrored[rows], mirrored)
            if of is not None:
                pixels[:, rows] = of[part]
            else:
                share = layout.share(rows, np.arange(side))
                one = first[part].astype(np.float32)
                pixels[:, rows] = np.rint(one + share * (in_tone[part] - one))
        for tile_format in formats:
            path = folder / f"{name}_{tile_format.replace(' ', '_').lower()}.tif"
            say(f"writing {path.name}, {side} x {side} px")
            write(path, pixels, tile_format)
            files[tile_format].append(path)
    corner, step = np.array([EASTING, NORTHING]), np.array([PIXEL, -PIXEL])
    seams = tuple(
        KnownSeam(corner + step * line, *(1 + layout.source_beside(line, side) for side in (-1, 1)))
        for line in layout.lines()
    )
    return LargeMosaic(side, {one: tuple(paths) for one, paths in files.items()}, seams)


def write(path: Path, pixels: np.ndarray, tile_format: str) -> None:
    """A tiled GeoTIFF without overviews."""
    memory = gdal_array.OpenArray(pixels)
    memory.SetProjection(reference_system().ExportToWkt())
    memory.SetGeoTransform((EASTING, PIXEL, 0.0, NORTHING, 0.0, -PIXEL))
    options = [*TILES, *FORMATS[tile_format], f"NUM_THREADS={os.cpu_count() or 1}"]
    gdal.Translate(str(path), memory, creationOptions=options)
