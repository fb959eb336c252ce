"""Orthoimages of photos: every pixel is seen by the camera itself and resampled where the photo shows it."""
from __future__ import annotations

import math
import os
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from threading import Lock
from typing import Callable

import numpy as np
from osgeo import gdal

from ...imagery import messages as imagery_messages
from ...imagery.gdal_calls import gdal_pixels, gdal_silenced
from ...imagery.grids import Grid, PixelWindow
from ...imagery.open_raster import OpenRaster, damaged
from ...imagery.raster_pool import reading_threads
from ...imagery.reference_systems import horizontal_wkt, transform_points
from .frames import FrameCamera

STRIP_ROWS = 256  # a tile of a GeoTIFF, so that none is written twice
_PART_COLUMNS, _NARROWEST = 512, 16  # px that are made at once, fewer where each is made of many
_KNOT_PX = 16  # between places whose reference system is changed; the ones between lie on the Earth's curve within mm
_MOST_THREADS = 4
_PHASES = 4096  # places between two pixels that weights are tabled for: at most 0.0001 px off
_SMALLEST_WEIGHT = 1e-6
_AT_ONCE = 16384  # places whose sums stay in a processor's own memory


def _catmull_rom(distance: np.ndarray) -> np.ndarray:
    near = (1.5 * distance - 2.5) * distance**2 + 1
    return np.where(distance < 1, near, ((2.5 - 0.5 * distance) * distance - 4) * distance + 2)


def _b_spline(distance: np.ndarray) -> np.ndarray:
    return np.where(distance < 1, (distance / 2 - 1) * distance**2 + 2 / 3, (2 - distance) ** 3 / 6)


_NEAREST = "nearest"
KERNELS: dict[str, tuple[float, Callable[[np.ndarray, float], np.ndarray]]] = {
    _NEAREST: (1.0, lambda distance, wide: np.ones_like(distance)),
    "bilinear": (1.0, lambda distance, wide: 1 - distance / wide),
    "cubic": (2.0, lambda distance, wide: _catmull_rom(distance / wide)),
    "cubicspline": (2.0, lambda distance, wide: _b_spline(distance / wide)),
    "lanczos": (3.0, lambda distance, wide: np.sinc(distance / wide) * np.sinc(distance / wide / 3)),
    "average": (1.0, lambda distance, wide: np.clip(wide / 2 + 0.5 - distance, 0, 1)),
}
"""Reach of a kernel in pixels or steps, whichever are wider; and the weight of a pixel by its distance from the place
and by the wider of a pixel and a step, px."""


@dataclass(frozen=True)
class Resampler:
    """A kernel for a step between places, widened where places are further apart than pixels."""

    tables: tuple[np.ndarray, np.ndarray]  # (taps, phases + 1) float32 along columns and rows, the sum of a phase 1
    nearest: bool  # whether the pixel that a place lies in is all

    @classmethod
    def of(cls, name: str, step_px: tuple[float, float]) -> Resampler:
        """The kernel ``name`` of ``KERNELS`` for places ``step_px`` apart along columns and rows."""
        radius, weight = KERNELS[name]
        tables = []
        for step in step_px:
            wide = max(step, 1.0)
            half = math.ceil(radius * wide)
            distance = np.abs(np.arange(1 - half, half + 1)[:, None] - np.arange(_PHASES + 1) / _PHASES)
            weights = np.where(distance < radius * wide, weight(distance, wide), 0.0)
            tables.append((weights / weights.sum(axis=0)).astype(np.float32))
        return cls((tables[0], tables[1]), name == _NEAREST)

    @property
    def margin_px(self) -> tuple[int, int]:
        """Pixels around a place, along columns and rows, that have a share."""
        return len(self.tables[0]) // 2, len(self.tables[1]) // 2

    def at(
        self, bands: np.ndarray, valid: np.ndarray | None, columns: np.ndarray, rows: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """(bands, n) values at places (n,), 0.5 the middle of the first pixel, and (n,) bool where there are any: where
        the pixel that a place lies in is ``valid`` (rows, columns). ``bands`` reach ``margin_px`` beyond the places."""
        width = bands.shape[2]
        column, row = columns.astype(np.int64), rows.astype(np.int64)
        pixel = row * width + column
        valid = None if valid is not None and valid.all() else valid
        sound = np.ones(len(columns), bool) if valid is None else valid.ravel().take(pixel)
        if self.nearest:
            return bands.reshape(len(bands), -1).take(pixel, axis=1), sound
        left, top = np.floor(columns - 0.5), np.floor(rows - 0.5)
        phases = [((place - 0.5 - first) * _PHASES + 0.5).astype(np.int32)
                  for place, first in ((columns, left), (rows, top))]
        before = [side - 1 for side in self.margin_px]
        first = (top.astype(np.int64) - before[1]) * width + left.astype(np.int64) - before[0]
        planes = [np.where(valid, band, 0) for band in bands] if valid is not None else list(bands)
        if valid is not None:
            planes.append(valid)
        pixels = [np.ascontiguousarray(plane, np.result_type(bands, np.float32)).ravel() for plane in planes]
        values = np.zeros((len(planes), len(columns)), pixels[0].dtype)
        for start in range(0, len(columns), _AT_ONCE):
            part = slice(start, start + _AT_ONCE)
            weights = [[line.take(phase[part]) for line in table] for table, phase in zip(self.tables, phases)]
            for plane, sums in zip(pixels, values):
                _add_convolved(sums[part], plane, width, first[part], *weights)
        if valid is None:
            return values, sound
        sound &= values[-1] > _SMALLEST_WEIGHT
        return values[:-1] / np.where(sound, values[-1], 1), sound


def _add_convolved(
    sums: np.ndarray, pixels: np.ndarray, width: int, first: np.ndarray, across: list[np.ndarray],
    down: list[np.ndarray],
) -> None:  # fmt: skip
    """Add pixels from ``first`` on (n,), the flat index of the upper left one, weighted."""
    taken, line = np.empty_like(sums), np.empty_like(sums)
    for below, weight_down in enumerate(down):
        line.fill(0)
        for beside, weight in enumerate(across):
            pixels[below * width + beside :].take(first, out=taken, mode="clip")
            taken *= weight
            line += taken
        line *= weight_down
        sums += line


@dataclass(frozen=True)
class PhotoWarp:
    """A photo, its camera and the ground that it shows."""

    image: OpenRaster
    camera: FrameCamera  # in its pixels
    wkt: str  # reference system of the camera's position
    terrain: gdal.Dataset  # heights in the camera's own kind, with nodata where there are none
    grid: Grid  # what is made, all pixels square
    grid_wkt: str  # its reference system

    def strips(
        self, resampling: str, nodata: float, cancelled: Callable[[], bool]
    ) -> Iterator[tuple[int, np.ndarray]]:
        """First row and (bands, rows, columns) of strip after strip, in the photo's data type, ``nodata`` beyond it.
        Ends early when cancelled. Raises RasterError where the photo can't be read."""
        grid, reading = self.grid, Lock()  # GDAL's datasets belong to one thread at a time
        step, heights, raster = self._step_px(), self._heights(), self.image.raster
        resampler, kind, bands = Resampler.of(resampling, step), np.dtype(raster.data_type), len(raster.band_names)
        width = max(int(_PART_COLUMNS / max(step[0] * step[1], 1)), _NARROWEST)
        with reading_threads(min(os.cpu_count() or 1, _MOST_THREADS)) as threads:
            for top in range(0, grid.rows, STRIP_ROWS):
                high = min(STRIP_ROWS, grid.rows - top)
                strip = np.full((bands, high, grid.columns), nodata, kind)

                def fill(left: int, top: int = top, strip: np.ndarray = strip) -> None:
                    if not cancelled():
                        part = PixelWindow(left, top, min(width, grid.columns - left), strip.shape[1])
                        self._fill(strip[:, :, left : left + width], part, heights, resampler, nodata, reading)

                list(threads.map(fill, range(0, grid.columns, width)))
                if cancelled():
                    return
                yield top, strip

    def _fill(
        self, target: np.ndarray, part: PixelWindow, heights: gdal.Dataset, resampler: Resampler, nodata: float,
        reading: Lock,
    ) -> None:  # fmt: skip
        with reading:
            height = self._height_of(heights, part)
        column, row = self._seen(part, height)
        across, down = resampler.margin_px
        shown = (column >= 0) & (row >= 0) & (column < self.image.columns) & (row < self.image.rows)
        column, row = column[shown], row[shown]
        if not column.size:
            return
        left, top = int(column.min()) - across, int(row.min()) - down
        window = PixelWindow(left, top, int(column.max()) + across + 1 - left, int(row.max()) + down + 1 - top)
        inside = window.cut_to(self.image.columns, self.image.rows)
        with reading:
            block = self.image.read(inside)
        beside = window.margins_of(inside)
        whole = inside == window
        valid = None if whole and block.invalid is None else np.pad(block.valid, beside)
        bands = block.bands if whole else np.pad(block.bands, ((0, 0), *beside))
        values, sound = resampler.at(bands, valid, column - left, row - top)
        if target.dtype.kind in "iu":
            limits = np.iinfo(target.dtype)
            if values.dtype.kind == "f":  # the nearest pixels are whole
                np.clip(np.rint(values, out=values), limits.min, limits.max, out=values)
            values[:, (values == nodata).all(axis=0)] = nodata + (1 if nodata < limits.max else -1)  # dark, not missing
        if not sound.all():
            shown[shown] = sound
            values = values[:, sound]
        for band, value in zip(target, values):
            band[shown] = value

    def _heights(self) -> gdal.Dataset:
        """The terrain on the orthoimage's pixels, computed where it is read; NaN without."""
        grid = self.grid
        with gdal_silenced():
            return gdal.Warp(
                "", self.terrain, format="VRT", dstSRS=horizontal_wkt(self.grid_wkt), outputBounds=grid.extent,
                width=grid.columns, height=grid.rows, resampleAlg="bilinear",
                warpOptions=["INIT_DEST=nan"],  # as a nodata value it would double the time
            )  # fmt: skip

    def _height_of(self, heights: gdal.Dataset, part: PixelWindow) -> np.ndarray:
        """(rows, columns) m. Raises RasterError where the terrain can't be read."""
        name = os.path.basename(self.terrain.GetDescription())
        window, unread = (part.column, part.row, part.width, part.height), imagery_messages.NOT_READABLE(name=name)
        return np.asarray(gdal_pixels(lambda: heights.ReadAsArray(*window), unread, partial(damaged, name, part)))

    def _seen(self, part: PixelWindow, height: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Columns and rows of the photo, (rows, columns) each, that show places at their ``height`` (m); NaN where none
        does."""
        columns, rows = part.column + np.arange(part.width) + 0.5, part.row + np.arange(part.height) + 0.5
        knots = [np.append(np.arange(side[0], side[-1], _KNOT_PX), side[-1]) for side in (columns, rows)]
        coarse = self._places(*(side.ravel() for side in np.meshgrid(*knots))).T.reshape(2, *map(len, knots[::-1]))
        sides = zip((columns, rows), knots)  # between which it is linear
        across, down = (np.stack([np.interp(side, at, knot) for knot in np.eye(len(at))]) for side, at in sides)
        x, y = down.T @ coarse @ across
        return self.camera.seen(x, y, height, np.float32)

    def _places(self, columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
        """(n, 2) x and y, in the camera's system, of (n,) columns and rows of the orthoimage."""
        grid = self.grid
        places = np.column_stack([grid.left + columns * grid.pixel_width, grid.top - rows * grid.pixel_height])
        return transform_points(places, self.grid_wkt, self.wkt)

    def _step_px(self) -> tuple[float, float]:
        """Distance in the photo between neighbouring pixels of the orthoimage, along its columns and rows, px."""
        grid, steps, heights, ground = self.grid, np.linspace(0.1, 0.9, 9), self._heights(), []
        columns, rows = (side.ravel() for side in np.meshgrid(steps * grid.columns, steps * grid.rows))
        height = [self._height_of(heights, PixelWindow(int(x), int(y), 1, 1))[0, 0] for x, y in zip(columns, rows)]
        for right, down in ((0, 0), (1, 0), (0, 1)):
            ground.append(self.camera.project(np.column_stack([self._places(columns + right, rows + down), height])))
        changes = np.stack([ground[1] - ground[0], ground[2] - ground[0]])
        known = np.isfinite(changes).all(axis=(0, 2))
        along = np.median(np.linalg.norm(changes[:, known], axis=0), axis=0) if known.any() else np.ones(2)
        return float(along[0]), float(along[1])
