"""Windows of real orthoimages, each with a seam that is known: what the operations are done to.

A window lies in the middle of a frame, the ground that the files hold. Frames in the west may be looked at while limits
are set, those in the east are held back; none has ground of both.
"""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, islice
from pathlib import Path

import numpy as np
from osgeo import gdal
from scipy import ndimage
from skimage.registration import phase_cross_correlation

from .detail import detail_energy, luminance_of

MARGIN_PX = 128
"""How much wider a frame is than its window on every side, where the imagery has that much."""
ENOUGH_FRAMES = 32
STEP_PX = 16
"""Raster of the frames that are looked at."""
MIN_TEXTURE = 4.0
"""Variance of the finest detail, DN2: a window with less has no texture to judge by."""
FARTHEST_MISFIT_PX = 4.0
MIN_SECOND_SHARE = 0.1
"""Least share of a window's pixels that come from the source it has second most of."""
MIN_VALID = 0.9995
MOST_SOURCES = 4
RAGGED_EVERY = 4
"""One in so many of the imagery's windows lies on a seam of its own, whose sources may cover it partly."""


@dataclass(frozen=True, eq=False)
class KnownWindow:
    """The orthoimages of one frame and the hard cut that is known."""

    imagery: str
    number: int
    held_back: bool
    pixel_m: float
    side: int
    """Side of the window in the frame's middle, px."""
    sources: tuple[np.ndarray, ...]
    """(bands, rows, columns) of the frame, 8 bit; pixels that a source doesn't have hold those of the hard cut."""
    valid: tuple[np.ndarray, ...]
    """Where each source has pixels, (rows, columns) bool."""
    labels: np.ndarray
    """(rows, columns) uint8: index of each pixel's source in ``sources``."""

    @property
    def middle(self) -> tuple[slice, slice]:
        """The window's rows and columns in its frame."""
        start = (self.labels.shape[0] - self.side) // 2
        inside = slice(start, start + self.side)
        return inside, inside

    @property
    def is_covered(self) -> bool:
        """Whether every source covers all of the frame."""
        return all(mask.all() for mask in self.valid)

    @property
    def main(self) -> tuple[int, int]:
        """The two sources with most pixels."""
        order = np.bincount(self.labels.ravel(), minlength=2).argsort()[::-1]
        return int(order[0]), int(order[1])


@dataclass(frozen=True)
class WindowFacts:
    """What tables ask of a window, without its pixels."""

    imagery: str
    number: int
    held_back: bool
    side: int
    main: tuple[int, int]
    texture: float
    """Variance of the finest detail, the mean of the main sources, DN2."""
    misfit: tuple[float, float]
    """How the second main source lies on the first: down and right, px; nan where that can't be told."""

    @classmethod
    def of(cls, window: KnownWindow) -> WindowFacts:
        planes = [luminance_of(window.sources[number][(slice(None), *window.middle)]) for number in window.main]
        texture = np.mean([detail_energy(plane, 1, "coif3").mean() for plane in planes])
        return cls(window.imagery, window.number, window.held_back, window.side, window.main, float(texture),
                   misfit_of(*planes))

    @property
    def has_texture(self) -> bool:
        return self.texture >= MIN_TEXTURE


def misfit_of(first: np.ndarray, second: np.ndarray) -> tuple[float, float]:
    """How one plane lies on another: down and right, px; nan where phase correlation finds nothing near."""
    fine = [plane - ndimage.gaussian_filter(plane, 4.0) for plane in (first, second)]
    found = phase_cross_correlation(*fine, upsample_factor=20)[0]
    y, x = (-float(value) for value in found)
    return (y, x) if np.hypot(y, x) <= FARTHEST_MISFIT_PX else (np.nan, np.nan)


@dataclass(frozen=True, eq=False)
class PlacedImage:
    """An orthoimage and where it lies on the common grid."""

    bands: np.ndarray
    row: int
    column: int
    nodata: int

    @property
    def valid(self) -> np.ndarray:
        """Where it has pixels."""
        return np.asarray((self.bands != self.nodata).any(axis=0))

    def over(self, row: int, column: int, side: int) -> np.ndarray:
        """Its pixels in a square, nodata where it has none."""
        square = np.full((3, side, side), self.nodata, np.uint8)
        top, left = max(row, self.row), max(column, self.column)
        bottom = min(row + side, self.row + self.bands.shape[1])
        right = min(column + side, self.column + self.bands.shape[2])
        if top < bottom and left < right:
            square[:, top - row : bottom - row, left - column : right - column] = self.bands[
                :3, top - self.row : bottom - self.row, left - self.column : right - self.column
            ]
        return square


@dataclass(frozen=True, eq=False)
class Imagery:
    """Orthoimages on one grid, and the cut of their own mosaic where that is known."""

    name: str
    pixel_m: float
    placed: tuple[PlacedImage, ...]
    rows: int
    columns: int
    own_labels: np.ndarray | None = None
    """(rows, columns) uint8: number of each pixel's source from 1, 0 for none."""

    def windows(self, side: int, count: int, held_back: bool) -> list[KnownWindow]:
        """Up to ``count`` windows of one half, spread over the imagery, always the same."""
        frame = self._frame(side)
        covering = self._covering(frame)
        half = _half(list(covering), frame, held_back)
        rng = np.random.default_rng([self.rows, self.columns, held_back])
        crooked = (self._crooked(corner, covering[corner], frame, turn, rng) for turn, corner in enumerate(half))
        own = (self._own(corner, frame, side) for corner in _half(list(self._corners(frame)), frame, held_back))
        ragged = (window for window in own if window is not None)
        return [
            KnownWindow(self.name, 2 * number + held_back, held_back, self.pixel_m, side, *parts)
            for number, parts in enumerate(islice(_mixed(crooked, ragged), count))
        ]

    def _frame(self, side: int) -> int:
        """With the widest of three margins at which either half has ground for enough of them."""
        for margin in (MARGIN_PX, MARGIN_PX // 2):
            frame = side + 2 * margin
            corners = list(self._covering(frame))
            if min(len(_half(corners, frame, held_back)) for held_back in (False, True)) >= ENOUGH_FRAMES:
                return frame
        return side

    def _corners(self, frame: int) -> Iterator[tuple[int, int]]:
        for row in range(0, self.rows - frame + 1, STEP_PX):
            for column in range(0, self.columns - frame + 1, STEP_PX):
                yield row, column

    def _covering(self, frame: int) -> dict[tuple[int, int], list[int]]:
        """Upper left corners of all frames that two sources or more cover, and which do."""
        rows, columns = (range(0, size - frame + 1, STEP_PX) for size in (self.rows, self.columns))
        if not rows or not columns:
            return {}
        first, last = np.ix_(rows, columns), np.ix_(np.array(rows) + frame, np.array(columns) + frame)
        covered = np.empty((len(self.placed), len(rows), len(columns)), bool)
        for one, own in zip(self.placed, covered):
            sums = np.zeros((self.rows + 1, self.columns + 1), np.int32)
            bottom, right = one.row + one.bands.shape[1], one.column + one.bands.shape[2]
            sums[one.row + 1 : bottom + 1, one.column + 1 : right + 1] = one.valid
            sums = sums.cumsum(axis=0, dtype=np.int32).cumsum(axis=1, dtype=np.int32)
            inside = sums[last] - sums[first[0], last[1]] - sums[last[0], first[1]] + sums[first]
            own[:] = inside >= MIN_VALID * frame**2
        several = np.argwhere(covered.sum(axis=0) > 1)
        return {(rows[i], columns[j]): np.flatnonzero(covered[:, i, j]).tolist() for i, j in several}

    def _crooked(
        self, corner: tuple[int, int], covering: Sequence[int], frame: int, turn: int, rng: np.random.Generator
    ) -> tuple:
        """Any two of the sources, with a random seam between them; now and then a third beside them."""
        pairs = list(combinations(covering, 2))
        pair = rng.permutation(pairs[turn % len(pairs)])
        others = [i for i in covering if i not in pair]
        chosen = [*pair, *(others[:1] if turn % 3 == 1 else [])]
        sources = tuple(self.placed[i].over(*corner, frame) for i in chosen)
        return sources, (np.ones((frame, frame), bool),) * len(chosen), crooked_cut(frame, rng).astype(np.uint8)

    def _own(self, corner: Sequence[int], frame: int, side: int) -> tuple | None:
        """The sources of the imagery's own mosaic over a frame, if its seam runs through the window."""
        if self.own_labels is None:
            return None
        row, column = corner
        numbers = self.own_labels[row : row + frame, column : column + frame]
        start = (frame - side) // 2
        shares = np.bincount(numbers[start : start + side, start : start + side].ravel(), minlength=2) / side**2
        if numbers.min() == 0 or np.sort(shares)[-2] < MIN_SECOND_SHARE:
            return None
        bands = [one.over(row, column, frame) for one in self.placed]
        masks = [(band != placed.nodata).any(axis=0) for band, placed in zip(bands, self.placed)]
        used = [int(number) - 1 for number in np.unique(numbers)]
        others = sorted((i for i in range(len(bands)) if i not in used), key=lambda i: -masks[i].mean())
        chosen = used + [i for i in others[: max(MOST_SOURCES - len(used), 0)] if masks[i].mean() > 0.5]
        place = np.zeros(256, np.uint8)
        place[[i + 1 for i in chosen]] = np.arange(len(chosen))
        labels = place[numbers]
        cut = hard_cut([bands[i] for i in chosen], labels)
        valid = tuple(masks[i] | (labels == k) for k, i in enumerate(chosen))
        return tuple(np.where(mask, bands[i], cut) for mask, i in zip(valid, chosen)), valid, labels


def _half(corners: Sequence[tuple[int, int]], frame: int, held_back: bool) -> list[tuple[int, int]]:
    """Those on one side of the middle column, in an order in which any beginning is spread over all of them."""
    if not corners:
        return []
    columns = [column for _, column in corners]
    if min(columns) == max(columns):  # a single frame: nothing to set limits by
        return list(corners) * 64 if held_back else []
    border = np.median(columns) + frame / 2
    half = [corner for corner in corners if (corner[1] >= border if held_back else corner[1] + frame <= border)]
    order = sorted(range(len(half)), key=lambda number: number * 0.6180339887498949 % 1)
    return [half[number] for number in order]


def _mixed(crooked: Iterator[tuple], ragged: Iterator[tuple]) -> Iterator[tuple]:
    """A ragged one every now and then, as long as there are any."""
    for number, window in enumerate(crooked, 1):
        yield window
        if number % (RAGGED_EVERY - 1) == 0:
            yield from islice(ragged, 1)


def hard_cut(sources: Sequence[np.ndarray], labels: np.ndarray) -> np.ndarray:
    """Each pixel from the source that its label names."""
    mosaic = np.empty_like(sources[0])
    for number, bands in enumerate(sources):
        np.copyto(mosaic, bands, where=labels == number)
    return mosaic


def crooked_cut(side: int, rng: np.random.Generator) -> np.ndarray:
    """Which pixels lie on one side of a random crooked line through the middle of a square, (rows, columns) bool."""
    turn = rng.uniform(0, np.pi)
    y, x = np.mgrid[:side, :side] - side / 2
    across, along = x * np.cos(turn) + y * np.sin(turn), y * np.cos(turn) - x * np.sin(turn)
    walk = np.cumsum(ndimage.gaussian_filter1d(rng.standard_normal(2 * side), 6)) * 0.8
    return np.asarray(across > np.interp(along, np.arange(-side, side), walk - walk[side]))


def brighton(folder: Path) -> Imagery:
    """Brighton's orthoimages (0.03 m) with the cut of their mosaic."""
    labels = gdal.Open(str(folder / "source_label.tif")).ReadAsArray()
    return imagery("Brighton", sorted(folder.glob("DJI_*_ortho.tif")), labels)


def packo(folder: Path) -> Imagery:
    """Three orthoimages of 256 px (0.05 m) as they come with IGN's PackO."""
    return imagery("PackO", sorted(folder.glob("*.tif")))


def imagery(name: str, paths: Sequence[Path], own_labels: np.ndarray | None = None) -> Imagery:
    """Orthoimages of one pixel size, each put on the nearest pixel of the common grid."""
    files = [gdal.Open(str(path)) for path in paths]
    grids = [file.GetGeoTransform() for file in files]
    pixel, left, top = grids[0][1], min(grid[0] for grid in grids), max(grid[3] for grid in grids)
    placed = tuple(
        PlacedImage(file.ReadAsArray()[:3], round((top - grid[3]) / pixel), round((grid[0] - left) / pixel),
                int(file.GetRasterBand(1).GetNoDataValue() or 0))
        for file, grid in zip(files, grids)
    )
    rows = max(one.row + one.bands.shape[1] for one in placed)
    columns = max(one.column + one.bands.shape[2] for one in placed)
    return Imagery(name, pixel, placed, rows, columns, own_labels)
