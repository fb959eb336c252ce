"""What a feather between two sources would leave of their detail, known before any mosaic exists.

A 50:50 blend of two images has the detail variance (1 + rho) / 2 of their mean, with rho = 2 cov / (v_a + v_b) of
their detail coefficients: images that do not fit, or whose noise differs, cancel each other.

Of a feather of some width the two are mixed along every place where the seam may run,

    kept = sum |(1 - a) p + a q|^2 / sum |the one that is followed|^2

with p and q their own details: what a cut adds, its edge, is detail of neither. Texture is not even, so it is summed
where it lies: over the window, and over the feather's own strip.
"""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from osgeo import ogr
from scipy import ndimage

from ....imagery import limits as imagery_limits
from ....imagery.grids import PixelWindow
from ....imagery.lines import burnt
from ....imagery.rasters import Raster
from ....imagery.reference_systems import geometry_on
from ....imagery.wavelets import detail_components, placed_components
from ..following.boxes import in_squares
from ..limits import GAUSSIAN, LINEAR


@dataclass(frozen=True)
class Feather:
    """Two sources of one window, blended half and half."""

    first: int
    """Index of a source."""
    second: int
    rho: tuple[float | None, ...]
    """Agreement of their details, levels 1..R, 1 for equal images; None where neither has detail."""

    @property
    def ratios(self) -> tuple[float | None, ...]:
        """Detail variance that a 50:50 feather leaves of their mean, levels 1..R."""
        return tuple(None if rho is None else (1 + rho) / 2 for rho in self.rho)


def feathers(planes: Sequence[np.ndarray], wavelet: str, levels: int) -> list[Feather]:
    """Every pair of the sources' planes, (rows, columns) each, of one window."""
    if len(planes) < 2:
        return []
    stack = np.stack(planes).astype(np.float64)
    least = imagery_limits.MIN_SHARE * stack.var(axis=(1, 2)) * stack[0].size
    products = [np.tensordot(parts, parts, [(0, 2, 3)] * 2) for parts in detail_components(stack, wavelet, levels)]

    def rho(shared: np.ndarray, i: int, j: int) -> float | None:
        energy = shared[i, i] + shared[j, j]
        return float(2 * shared[i, j] / energy) if energy > least[i] + least[j] else None

    pairs = combinations(range(len(planes)), 2)
    return [Feather(i, j, tuple(rho(shared, i, j) for shared in products)) for i, j in pairs]


def smallest(pairs: Iterable[Sequence[float | None]]) -> tuple[float | None, ...] | None:
    """The smallest over several pairs of sources, level by level: where feathering will hurt most; None of none."""
    levels = zip(*pairs)
    return tuple(min((value for value in level if value is not None), default=None) for level in levels) or None


SIGMAS_PER_WIDTH = 4.0  # a Gaussian has no end; over two sigmas to either side the weights go from 0.02 to 0.98


def place_feather(
    distance: np.ndarray, ramp: str, width_m: float, pixel_m: tuple[float, float]
) -> tuple[np.ndarray, np.ndarray]:
    """The feather of a full width along a seam: the share of the second source, 0 to 1, float32, and its strip, bool.

    ``distance``: (rows, columns) m from the seam, negative on one side. ``ramp``: one of ``limits.RAMPS``.
    ``pixel_m``: height and width of a pixel.
    """
    if ramp == GAUSSIAN:
        # A wide one on a coarser grid: off by up to 0.02 at the window's edge and by 0.0005 in the mean.
        sigma_px = width_m / SIGMAS_PER_WIDTH / np.array(pixel_m)
        sides = [side for side in (8, 4, 2) if 4 * side <= sigma_px.min() and not any(n % side for n in distance.shape)]
        side = max(sides, default=1)
        coarse = in_squares(distance > 0, side).mean(axis=(1, 3))
        weight = ndimage.gaussian_filter(coarse, sigma_px / side, mode="nearest")
        if side > 1:
            weight = ndimage.zoom(weight, side, order=1, grid_mode=True, mode="nearest")
    else:
        across = np.clip(distance / width_m, -0.5, 0.5)
        weight = 0.5 + (across if ramp == LINEAR else np.sin(np.pi * across) / 2)
    return weight.astype(np.float32), abs(distance) <= width_m / 2


@dataclass(frozen=True)
class KeptDetail:
    """Detail variance of the feathered sources over their own, levels 1..R; None where there is none."""

    window: tuple[float | None, ...]
    """In the whole window."""
    strip: tuple[float | None, ...]
    """In the feather's full width."""


def kept_detail(
    first: np.ndarray, second: np.ndarray, feathers: Sequence[tuple[np.ndarray, np.ndarray]], wavelet: str, levels: int
) -> KeptDetail:
    """What feathers, as ``place_feather`` has them, leave of two sources' planes, (rows, columns) each.

    Detail is summed over all places where the seam may run, and over both ways of sharing the sides out to the sources.
    """
    planes = np.stack([first, second]).astype(np.float32)
    energies = np.zeros((2, 2, levels))  # feathered and cut; window and strip
    for level, details in enumerate(placed_components(planes, wavelet, levels)):
        alone, both = (details**2).sum(axis=(0, 1)), 2 * (details[:, 0] * details[:, 1]).sum(axis=0)
        for weight, pixels in feathers:
            # Of (1 - a) p + a q and a p + (1 - a) q together.
            apart = 2 * weight * (1 - weight)
            lost, strip = (in_squares(share, 2 ** (level + 1)).mean(axis=(1, 3)) for share in (apart, pixels))
            for row, energy in enumerate(((1 - lost) * alone + lost * both, alone)):
                energies[row, 0, level] += float(energy.sum(dtype=np.float64))
                energies[row, 1, level] += float((energy * strip).sum(dtype=np.float64))
    least = imagery_limits.MIN_SHARE * planes.size * float(planes.var(axis=(1, 2), dtype=np.float64).sum())
    feathered, cut = energies
    window, strip = (
        tuple(float(a / b) if b > least else None for a, b in zip(*both)) for both in zip(feathered, cut)
    )
    return KeptDetail(window, strip)


_DIRECTIONS = np.pi / 4 * (np.arange(4) + 0.5)
"""Directions of assumed seams. All are 8 % longer than a window's side; the mean of all directions is 12 %."""
_MIN_SIDE_SHARE = 0.01  # of the window: smaller pieces are what is left between a line's steps and the pixels


def assumed_seams(rows: int, columns: int, pixel_m: tuple[float, float]) -> list[np.ndarray]:
    """Straight seams through the middle of a window, in four directions: (rows, columns) m from each of them.

    Windows lie along seams, which run through them in any direction. ``pixel_m``: height and width of a pixel.
    """
    y, x = np.ogrid[:rows, :columns]
    y, x = (y - (rows - 1) / 2) * pixel_m[0], (x - (columns - 1) / 2) * pixel_m[1]
    return [x * np.cos(direction) + y * np.sin(direction) for direction in _DIRECTIONS]


def drawn_seam(
    lines: Iterable[ogr.Geometry], wkt: str, mosaic: Raster, window: PixelWindow, pixel_m: tuple[float, float]
) -> np.ndarray | None:
    """Distance from the seamlines of a window, (rows, columns) m; None where they do not divide it.

    ``lines``: in the reference system ``wkt``. One side is the largest part of the window, the other all the rest.

    Raises RasterError when the lines can't be transformed to the mosaic's reference system.
    """
    borders = []
    for line in lines:
        geometry = geometry_on(line.GetLinearGeometry(), wkt, mosaic.wkt)
        borders.append((geometry.Boundary() if geometry.GetDimension() == 2 else geometry, 1))
    parts, _ = ndimage.label(burnt(borders, mosaic.grid, window, touched=True) == 0)
    sizes = np.bincount(parts.ravel())
    sizes[0] = 0
    sides = np.flatnonzero(sizes >= _MIN_SIDE_SHARE * parts.size)
    if len(sides) < 2:
        return None
    nearest = ndimage.distance_transform_edt(~np.isin(parts, sides), return_distances=False, return_indices=True)
    largest = parts[tuple(nearest)] == sizes.argmax()
    inside, outside = (ndimage.distance_transform_edt(side, pixel_m) for side in (largest, ~largest))
    half = min(pixel_m) / 2  # the seam runs between two pixels
    return np.where(largest, inside - half, half - outside)
