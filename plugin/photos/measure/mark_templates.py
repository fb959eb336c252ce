"""Templates of fiducial marks: marks drawn from a few numbers, and marks cut out by the user.

A drawn mark is anti-aliased as a scanner blurs it: every edge is a Gaussian's integral. It can therefore be drawn at
any sub-pixel place, and its own centre is exact.
"""
from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from scipy import ndimage, special

from ...imagery.errors import PhotoError
from . import limits, messages
from .correlation import SurfaceError, correlate, peak_pixel, subpixel_maximum
from .photo import Place, block_means

ARM_WIDTH = 0.6  # the arms of a ring with cross against its ring: UNBC's photo, Wild RC10
WEDGE_HALF_ANGLE_DEG = 30.0  # equilateral
MIN_SYMMETRY = 0.7  # a cut-out that correlates so with itself turned by 180 degrees has a centre of its own
SYMMETRY_BLUR_PX = 1.0  # against grain, which has no symmetry: without it a mark in strong grain has 0.7
COARSE_SIZES_PX = (10.0, 12.0, 14.3, 17.0)  # of a mark at each level: an octave in steps of 1.19


@dataclass(frozen=True)
class MarkShape:
    """A mark to be drawn, light on dark. Lengths in pixels."""

    kind: str
    size: float  # diameter of the ring or dot, length of a cross or of a pair of wedges
    diagonal: bool = False  # arms, or the wedges, at 45 degrees
    interrupted: bool = False  # the cross is open in the middle
    width: float = 0.1  # line width as a share of the size; of a ring with dot the dot's diameter is twice that
    reach: float = 1.0  # how far the arms of a ring with cross go, ring radii
    softness: float = 0.5  # standard deviation of the blur, px
    angle: float = 0.0  # degrees, clockwise on the screen; wedges at 0 lie left and right, their tips on the mark

    @property
    def radius(self) -> float:
        """From the centre to the outermost part, px."""
        reach = self.reach if self.kind == limits.RING_WITH_CROSS else 1.0
        return self.size / 2 * max(reach, 1 + self.width)

    @property
    def margin(self) -> int:
        """Half the side of the drawing without its middle pixel: the figure and the ground around it, px."""
        ground = 0.6 * self.radius if self.kind == limits.DOT else 0.15 * self.radius
        return max(2, math.ceil(self.radius + max(ground, 1.0) + self.softness))

    def scaled(self, factor: float) -> MarkShape:
        """This mark on pixels ``factor`` times as small."""
        return replace(self, size=self.size * factor, softness=max(self.softness * factor, limits.PIXEL_SOFTNESS))


@lru_cache(maxsize=64)
def draw(shape: MarkShape, offset: tuple[float, float] = (0.0, 0.0), margin: int | None = None) -> np.ndarray:
    """The mark, (2 m + 1, 2 m + 1) float64 from 0 (ground) to 1. Its centre lies ``offset`` (columns, rows) px beside
    the centre of the middle pixel. The same drawing is wanted for every mark of a photo: it is kept a while, and
    read-only."""
    half = shape.margin if margin is None else margin
    axis = np.arange(-half, half + 1, dtype=np.float64)
    x, y = axis[np.newaxis] - offset[0], axis[:, np.newaxis] - offset[1]
    turn = math.radians(shape.angle + (45.0 if shape.diagonal else 0.0))
    u, v = x * math.cos(turn) + y * math.sin(turn), y * math.cos(turn) - x * math.sin(turn)
    soft = max(shape.softness, limits.PIXEL_SOFTNESS)
    clear = np.ones(np.broadcast(u, v).shape)
    for part in _parts(shape, u, v, soft):
        clear *= 1 - part
    drawn = np.asarray(1 - clear)
    drawn.flags.writeable = False
    return drawn


def _below(distance: np.ndarray, soft: float) -> np.ndarray:
    """1 where a distance is negative, 0 where it is positive, blurred."""
    return np.asarray(special.erfc(distance / (soft * math.sqrt(2))) / 2)


def _line(across: np.ndarray, width: float, soft: float) -> np.ndarray:
    return _below(across - width / 2, soft) - _below(across + width / 2, soft)


def _arms(shape: MarkShape, u: np.ndarray, v: np.ndarray, soft: float, length: float, gap: float) -> list[np.ndarray]:
    width = max(shape.width * shape.size, 1.0)
    arms = []
    for along, across in ((u, v), (v, u)):
        arm = _line(across, width, soft) * _below(np.abs(along) - length, soft)
        if shape.interrupted:
            arm = arm * (1 - _below(np.abs(along) - gap, soft))
        arms.append(arm)
    return arms


def _parts(shape: MarkShape, u: np.ndarray, v: np.ndarray, soft: float) -> list[np.ndarray]:
    """The pieces of a figure, each from 0 to 1, along its own axes."""
    half = shape.size / 2
    if shape.kind == limits.CROSS:
        return _arms(shape, u, v, soft, half, 0.15 * shape.size)
    if shape.kind == limits.WEDGE:
        slope = math.radians(WEDGE_HALF_ANGLE_DEG)
        side = np.abs(v) * math.cos(slope) - np.abs(u) * math.sin(slope)
        return [_below(side, soft) * _below(np.abs(u) - half, soft)]
    from_centre = np.hypot(u, v)
    if shape.kind == limits.DOT:
        return [_below(from_centre - half, soft)]
    ring = _line(from_centre - half, max(shape.width * shape.size, 1.0), soft)
    if shape.kind == limits.RING_WITH_DOT:
        return [ring, _below(from_centre - max(2 * shape.width * shape.size, 1.0) / 2, soft)]
    thin = replace(shape, width=ARM_WIDTH * shape.width)
    return [ring, *_arms(thin, u, v, soft, shape.reach * shape.size / 2, 0.15 * shape.size)]


def all_shapes() -> tuple[MarkShape, ...]:
    """Every mark that can be drawn, its size of no meaning: what is tried when nobody says what marks are there."""
    made = []
    for diagonal in (False, True):
        made += [MarkShape(kind, 1.0, diagonal) for kind in (limits.RING_WITH_CROSS, limits.CROSS, limits.WEDGE)]
        made.append(MarkShape(limits.CROSS, 1.0, diagonal, interrupted=True))
    return (*made, MarkShape(limits.RING_WITH_DOT, 1.0), MarkShape(limits.DOT, 1.0))


def chosen_shapes(kind: str | None, diagonal: bool | None, interrupted: bool | None) -> tuple[MarkShape, ...]:
    """The shapes that are as asked for; None asks for nothing. What has no arms has no direction, and what has
    no cross no open middle."""
    made = []
    for shape in all_shapes():
        is_cross, is_ringed = shape.kind == limits.CROSS, shape.kind == limits.RING_WITH_CROSS
        if is_ringed and interrupted is not None:
            shape = replace(shape, interrupted=interrupted)
        is_chosen = kind in (None, shape.kind)
        if is_cross or is_ringed or shape.kind == limits.WEDGE:
            is_chosen &= diagonal in (None, shape.diagonal)
        if is_cross or is_ringed:
            is_chosen &= interrupted in (None, shape.interrupted)
        if is_chosen:
            made.append(shape)
    return tuple(made)


@dataclass(frozen=True, eq=False)
class CutOut:
    """A mark cut out of a photo by the user."""

    pixels: np.ndarray  # (rows, columns) float64
    centre: tuple[float, float]  # column and row of the mark in it, pixel centres at .5


def cut_out(pixels: np.ndarray) -> CutOut:
    """A user's template (rows, columns) with its centre. The centre is the one of symmetry where the template looks
    alike when it is turned by 180 degrees, else the middle. Raises PhotoError for a template that holds nothing or is
    too small."""
    rows, columns = pixels.shape
    if min(rows, columns) < limits.MIN_TEMPLATE_PX:
        raise PhotoError(messages.TEMPLATE_TOO_SMALL(width=columns, height=rows, fewest=limits.MIN_TEMPLATE_PX))
    pixels = np.asarray(pixels, dtype=np.float64)
    if np.ptp(pixels) == 0:
        raise PhotoError(messages.TEMPLATE_EMPTY())
    middle = columns / 2, rows / 2
    reach = (rows // 4, columns // 4)
    smooth = ndimage.gaussian_filter(pixels, SYMMETRY_BLUR_PX)
    inner = smooth[reach[0] : rows - reach[0], reach[1] : columns - reach[1]]
    alike = correlate(smooth[::-1, ::-1], inner)
    row, column = peak_pixel(alike)
    if alike[row, column] < MIN_SYMMETRY:
        return CutOut(pixels, middle)
    try:
        x, y = subpixel_maximum(alike, row, column)
    except SurfaceError:
        return CutOut(pixels, middle)
    return CutOut(pixels, (middle[0] - (x - reach[1]) / 2, middle[1] - (y - reach[0]) / 2))


@dataclass(frozen=True, eq=False)
class Pattern:
    """One template at one level: its pixels, and where its centre lies in them."""

    pixels: np.ndarray
    centre: Place  # column and row, pixel centres at .5
    shape: MarkShape | None  # none for a user's template; in pixels of the level


def patterns(mark: MarkShape | CutOut, factor: float, place: Place) -> Iterator[Pattern]:
    """The templates of a mark for pixels that are ``factor`` of the photo's wide, at a place in the frame, mm. A drawn
    mark has the sizes of one octave, and wedges lie in line with the middle of the frame; a cut-out is reduced, and
    there is none where too little of it is left."""
    if isinstance(mark, CutOut):
        step = int(factor)
        if min(mark.pixels.shape) // step >= limits.MIN_TEMPLATE_PX:
            yield Pattern(block_means(mark.pixels, step), (mark.centre[0] / step, mark.centre[1] / step), None)
        return
    for size in COARSE_SIZES_PX:
        sized = wedge_to_middle(replace(mark, size=size), place)
        pixels = draw(sized)
        yield Pattern(pixels, (pixels.shape[1] / 2, pixels.shape[0] / 2), sized)


def wedge_to_middle(shape: MarkShape, place: Place) -> MarkShape:
    """Wedges in line with the middle of the frame, along an axis or a diagonal; other shapes as they are."""
    if shape.kind != limits.WEDGE:
        return shape
    towards = math.degrees(math.atan2(-place[1], -place[0])) - (45 if shape.diagonal else 0)
    return replace(shape, angle=90.0 * round(towards / 90))
