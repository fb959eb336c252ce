"""The profile across the bars of one group, from the pixels.

Places are in pixels of the raster: (column, row), the centre of its first pixel at (0.5, 0.5).
"""
from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy import sparse
from scipy.interpolate import BSpline
from scipy.ndimage import map_coordinates, spline_filter
from scipy.sparse.linalg import spsolve

from ...imagery.errors import BarLineError
from ...imagery.grids import PixelWindow
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster
from . import messages
from . import target as limits

MAX_BAR_TURN_DEG = 10.0  # how roughly a line may be drawn: a hand does better
BAR_MARGIN = 0.2  # of a line's length: half a cycle of three bars, when the line ends with the outer ones
GROUND_REACH_PX = 12  # how much further than its length a line's surroundings go: two squares of ground at least
GROUND_SQUARE_PX = 6  # side of a square of ground: 36 values, its noise to 12 %
PLAIN_GROUND_PERCENTILE = 10  # of the squares: as many are plain beside the most crowded target, USAF-1951

Point = tuple[float, float]

_KNOT_PX = 0.5  # between the knots of a profile: half a pixel, as a turned line crosses the bars at many phases
_ROUGHNESS = 0.002  # weight of the third differences: bridges places without pixels, keeps 0.45 cycles/px to 1 %
_SAMPLE_PX = 0.125  # between the values of a profile


@dataclass(frozen=True)
class Segment:
    """A line across the bars, in pixels of the raster."""

    start: Point  # column and row, px
    end: Point  # column and row, px

    @property
    def length(self) -> float:
        return math.dist(self.start, self.end)

    @property
    def middle(self) -> Point:
        return (self.start[0] + self.end[0]) / 2, (self.start[1] + self.end[1]) / 2

    @property
    def along(self) -> Point:
        return (self.end[0] - self.start[0]) / self.length, (self.end[1] - self.start[1]) / self.length

    def turned(self, angle: float) -> Segment:
        """This line turned around its middle, radians from column to row."""
        (x, y), (u, v), half = self.middle, self.along, self.length / 2
        c, s = math.cos(angle), math.sin(angle)
        dx, dy = half * (c * u - s * v), half * (s * u + c * v)
        return Segment((x - dx, y - dy), (x + dx, y + dy))


@dataclass(frozen=True)
class Patch:
    """The pixels around a line."""

    bands: np.ndarray  # (bands, rows, columns) float64
    valid: np.ndarray  # (rows, columns) bool
    column: int  # column of the patch's first pixel in the raster
    row: int  # row of the patch's first pixel in the raster
    highest: float | None  # the largest value that the data type holds; None for floats

    def distances(self, line: Segment) -> tuple[np.ndarray, np.ndarray]:
        """(rows, columns) each: how far every pixel's centre lies along the line from its start, and beside it."""
        rows, columns = self.valid.shape
        x = self.column + np.arange(columns) + 0.5 - line.start[0]
        y = (self.row + np.arange(rows) + 0.5 - line.start[1])[:, np.newaxis]
        u, v = line.along
        return x * u + y * v, y * u - x * v


@dataclass(frozen=True)
class Profile:
    """Values across the bars, averaged along them."""

    positions: np.ndarray  # (n,) px from the line's start, negative before it, in even steps
    values: np.ndarray  # (n,) DN
    length: float  # px: where the line ends. The profile goes on a little beyond both ends
    noise: float  # standard deviation of the pixels of the plain ground beside the bars, DN
    scatter: float = 0.0  # standard deviation of the pixels about the profile, DN
    density: float = 1.0  # how many pixels a pixel's length of the line is averaged over

    def error_over(self, length: float) -> float:
        """Standard deviation of the mean of so long a piece, px, in DN."""
        return max(self.noise, self.scatter) / math.sqrt(max(self.density * length, 1.0))


def read_patch(raster: Raster, line: Segment, bars: int) -> Patch:
    """The pixels around a line, with ground on all sides.

    Raises BarLineError when the line is too short for its bars, too long, or leaves the raster, and RasterError
    when the raster can't be read.
    """
    name, grid = raster.ref.name, raster.grid
    shortest = 2 * bars - 1
    if line.length < shortest:
        raise BarLineError(messages.BAR_LINE_TOO_SHORT(length=line.length, least=shortest, bars=bars))
    if line.length > limits.MAX_BAR_LINE_PX:
        raise BarLineError(messages.BAR_LINE_TOO_LONG(length=line.length, most=limits.MAX_BAR_LINE_PX))
    for x, y in (line.start, line.end):
        if not (0 <= x <= grid.columns and 0 <= y <= grid.rows):
            raise BarLineError(messages.BAR_LINE_OUTSIDE(name=name))
    reach = line.length + GROUND_REACH_PX
    column = max(0, math.floor(line.middle[0] - reach))
    row = max(0, math.floor(line.middle[1] - reach))
    right = min(grid.columns, math.ceil(line.middle[0] + reach))
    bottom = min(grid.rows, math.ceil(line.middle[1] + reach))
    block = OpenRaster(raster.ref).read(PixelWindow(column, row, right - column, bottom - row))
    bands, valid = block.bands, block.valid
    highest = None if bands.dtype.kind == "f" else float(np.iinfo(bands.dtype).max)
    patch = Patch(bands.astype(np.float64), valid, column, row, highest)
    along, beside = patch.distances(line)
    swath = (np.abs(beside) <= 1) & (along >= 0) & (along <= line.length)
    if not valid[swath].all():
        raise BarLineError(messages.BAR_LINE_ON_NODATA(name=name))
    return patch


def perpendicular_line(patch: Patch, bands: list[int], line: Segment, width: float) -> Segment:
    """The line turned to be perpendicular to the bars: where the profile, averaged along them, is modulated most.

    It is sought within 10 degrees, by the energy of the profile's slopes in all the bands.
    """
    filled = [spline_filter(np.where(patch.valid, patch.bands[band], patch.bands[band].mean())) for band in bands]
    along = np.arange(0, line.length + 1e-6, 0.5)
    beside = np.arange(-width, width + 1e-6, 1.0)

    def modulation(angle: float) -> float:
        at = line.turned(angle)
        u, v = at.along
        x = at.start[0] + along * u - beside[:, np.newaxis] * v - patch.column - 0.5
        y = at.start[1] + along * v + beside[:, np.newaxis] * u - patch.row - 0.5
        energy = 0.0
        for band in filled:
            profile = map_coordinates(band, [y, x], mode="nearest", prefilter=False).mean(axis=0)
            energy += float(np.sum((profile[2:] - profile[:-2]) ** 2))
        return energy

    most = math.radians(MAX_BAR_TURN_DEG)
    best = max(np.linspace(-most, most, 21), key=modulation)
    for step in (math.radians(0.5), math.radians(0.25), math.radians(0.125)):
        best = max((angle for angle in (best - step, best, best + step) if abs(angle) <= most), key=modulation)
    return line.turned(float(best))


def bar_profile(patch: Patch, band: int, line: Segment, width: float) -> Profile:
    """The profile along a line perpendicular to the bars (px of the raster), ``width`` px either side of it averaged.

    A smooth curve (cubic splines, knots every half pixel) is fitted to the values of the pixels themselves at their
    distances along the line, so nothing is resampled first, and a line that crosses the bars at many phases of the
    pixel grid gives more than one value a pixel.
    """
    along, beside = patch.distances(line)
    margin = max(2.0, line.length * BAR_MARGIN)
    low, high = -margin, line.length + margin
    used = (np.abs(beside) <= width + 0.5) & (along >= low) & (along <= high) & patch.valid
    at, values = along[used], patch.bands[band][used]
    low, high = float(at.min()), float(at.max())
    count = max(4, math.ceil((high - low) / _KNOT_PX))
    spacing = (high - low) / count
    knots = low + spacing * np.arange(-3, count + 4)
    design = BSpline.design_matrix(np.clip(at, low, high - 1e-9), knots, 3)
    rough = sparse.diags([-1.0, 3.0, -3.0, 1.0], [0, 1, 2, 3], shape=(count, count + 3))
    weight = _ROUGHNESS * len(at) / (count + 3)
    level = float(values.mean())
    normal = (design.T @ design + weight * rough.T @ rough).tocsc()
    coefficients = spsolve(normal, design.T @ (values - level))
    positions = np.arange(math.ceil(low / _SAMPLE_PX), math.floor(high / _SAMPLE_PX) + 1) * _SAMPLE_PX
    fitted = level + BSpline(knots, coefficients, 3)(positions)
    rest = values - level - design @ coefficients
    scatter = math.sqrt(float(np.sum(rest**2)) / max(1, len(at) - count))
    return Profile(positions, fitted, line.length, _noise(patch, band, line, width), scatter, len(at) / (high - low))


def _noise(patch: Patch, band: int, line: Segment, width: float) -> float:
    """The noise of the plain ground beside the bars, DN.

    The surroundings are cut into small squares, and a slope is taken off each. Where some of them lie on other bars,
    figures or edges the plain ones are those with little scatter: every tenth counts as such, so that chance makes it
    no smaller than 15 % below the truth where all of them are plain.
    """
    side = GROUND_SQUARE_PX
    along, beside = patch.distances(line)
    bars = (along > 0) & (along < line.length) & (np.abs(beside) <= width + 0.5)
    rows, columns = (count // side for count in bars.shape)

    def squares(values: np.ndarray) -> np.ndarray:
        cut = values[: rows * side, : columns * side].reshape(rows, side, columns, side)
        return cut.swapaxes(1, 2).reshape(rows * columns, side * side)

    plain = squares(patch.valid & ~bars).all(axis=1)
    places = np.indices((side, side)).reshape(2, -1)
    basis = np.linalg.qr(np.column_stack([np.ones(side * side), places[0], places[1]]))[0]
    values = squares(patch.bands[band])[plain]
    rest = values - values @ basis @ basis.T
    spreads = np.sqrt(np.sum(rest**2, axis=1) / (side * side - 3))
    spreads = spreads[spreads > 1e-9 * max(1.0, float(np.abs(values).max(initial=0.0)))]
    return float(np.percentile(spreads, PLAIN_GROUND_PERCENTILE)) if spreads.size else 0.0
