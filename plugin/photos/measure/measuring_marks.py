"""One mark to a fraction of a pixel: the template that fits, its place, and whether the place can be trusted."""
from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from ...imagery.errors import Message, PhotoError
from ...imagery.grids import PixelWindow
from ...imagery.shifts import shifted
from . import limits, messages
from .correlation import SurfaceError, correlate, fit_surface, peak_pixel, subpixel_maximum, surface_extremum
from .mark_templates import CutOut, MarkShape, draw
from .photo import Photo, PhotoView, Place

BRIGHTNESS_REACH_PX = 2  # 5 x 5 grey values: they hold the grain itself
SETTLING_ROUNDS = 5  # two or three are enough to stay within 0.005 px
SETTLED_PX = 0.003  # between two rounds
LOBE_SHARE = 0.7  # of a mark's size: a ring on its own edge, a cross on its own arm still correlates
MAX_SECOND_SHARE = 0.85  # of the best correlation: above it, which of the two is the mark is a guess
HALF_REACH_PX = 4  # how far a half may look for the mark
MAX_HALF_SHIFT_PX = 1.0  # of a half against the whole: UNBC's marks 0.3 px
SMOOTHING_PX = 0.5  # standard deviation of the blur against grain before a mark is measured: the lines are wider


def window_around(photo: Photo, place: Place, half: int) -> PhotoView:
    """(2 half + 1, 2 half + 1) around where a mark should be, a little smoothed. Raises PhotoError outside."""
    if not photo.contains(place):
        raise PhotoError(messages.MARK_OUTSIDE())
    left, top = math.floor(place[0]) - half, math.floor(place[1]) - half
    pixels = photo.grey(PixelWindow(left, top, 2 * half + 1, 2 * half + 1))
    return PhotoView(ndimage.gaussian_filter(pixels, SMOOTHING_PX), left, top)


@dataclass(frozen=True)
class MeasuredMark:
    """A mark as measured, or why it could not be."""

    place: Place | None = None  # column and row, px, pixel centres at .5; None where it could not be measured
    correlation: float | None = None  # with the template at its very place; of a failed mark the best one
    reason: Message | None = None  # why it could not be measured


class MeasuringTemplate:
    """A mark to measure with: drawn at any sub-pixel place, or the user's cut-out moved there."""

    def __init__(self, mark: MarkShape | CutOut, sign: int) -> None:
        self._mark, self._sign = mark, sign
        if isinstance(mark, CutOut):
            self.centre: Place = (math.floor(mark.centre[0]) + 0.5, math.floor(mark.centre[1]) + 0.5)
            self._residue = mark.centre[0] - self.centre[0], mark.centre[1] - self.centre[1]
            self.size = float(min(mark.pixels.shape)) / 2
            self.radius = 0.0  # how much of it is ground is not known
            self.halves_tell = True
        else:
            self.centre = (mark.margin + 0.5, mark.margin + 0.5)
            self.size, self.radius = mark.size, mark.size / 2
            self.halves_tell = mark.kind != limits.WEDGE

    def at(self, offset: Place) -> np.ndarray:
        """The template with the mark ``offset`` px beside the pixel centre that is ``centre``."""
        if isinstance(self._mark, CutOut):
            move = offset[0] - self._residue[0], offset[1] - self._residue[1]
            return self._sign * shifted(self._mark.pixels, *move)
        return self._sign * draw(self._mark, offset)


def measure_mark(
    window: PhotoView, near: Place, reach: float, template: MeasuringTemplate, least: float, surface: str
) -> MeasuredMark:
    """The mark's place: the pixel of the best correlation, then the extremum of the surface around it. With the surface
    over the correlation the template is moved to the sub-pixel place and correlated again until it stays there, so that
    the extremum is at the middle of the pixels it is computed from, where it has no bias. No second place in the whole
    window may fit nearly as well.

    ``near``: where the mark should be (column and row in the photo). ``reach``: how far from there it may be, px.
    ``least``: smallest correlation of a mark that is measured.
    """
    field = correlate(window.pixels, template.at((0.0, 0.0)))
    if field.size == 0:
        return MeasuredMark(reason=messages.MARK_NO_ROOM())
    row, column = _best_near(field, window, near, reach, template)
    best = float(field[row, column])
    if best < least:
        return MeasuredMark(None, best, messages.MARK_TOO_WEAK(value=max(best, 0.0), least=least))
    second = _second_best(field, row, column, template.size)
    if second > MAX_SECOND_SHARE * best:
        return MeasuredMark(None, best, messages.MARK_AMBIGUOUS(best=best, second=second))
    try:
        if surface == limits.BRIGHTNESS:
            x, y = _brightness_extremum(window.pixels, column + template.centre[0], row + template.centre[1])
            pixels = window.pixels
        else:
            x, y, best, pixels = _settled_place(window.pixels, template, (row, column))
    except SurfaceError as error:
        return MeasuredMark(None, best, error.message)
    if best < least:
        return MeasuredMark(None, best, messages.MARK_TOO_WEAK(value=max(best, 0.0), least=least))
    if math.dist((window.left + x, window.top + y), near) > reach + 2:
        return MeasuredMark(None, best, messages.MARK_WANDERS())
    doubt = _halves_doubt(pixels, template, (x, y))
    if doubt is not None:
        return MeasuredMark(None, best, doubt)
    return MeasuredMark((window.left + x, window.top + y), best)


def _best_near(
    field: np.ndarray, window: PhotoView, near: Place, reach: float, template: MeasuringTemplate
) -> tuple[int, int]:
    """Row and column of the best correlation among places within reach of one; the nearest where there are none."""
    rows, columns = np.indices(field.shape)
    x = window.left + columns + template.centre[0] - near[0]
    y = window.top + rows + template.centre[1] - near[1]
    distance = np.maximum(np.abs(x), np.abs(y))
    inside = distance <= max(reach, float(distance.min()))
    return peak_pixel(np.where(inside, field, -2.0))


def _second_best(field: np.ndarray, row: int, column: int, size: float) -> float:
    """The highest correlation that is not on the best peak's own slope; -1 where there is no room."""
    reach = max(3, math.ceil(size * LOBE_SHARE))
    others = field.copy()
    others[max(row - reach, 0) : row + reach + 1, max(column - reach, 0) : column + reach + 1] = -1
    return float(others.max())


def _settled_place(
    pixels: np.ndarray, template: MeasuringTemplate, start: tuple[int, int]
) -> tuple[float, float, float, np.ndarray]:
    """Column and row in the window, px, the correlation there, and the pixels less the ground's slope. A slope of the
    ground pulls the correlation to one side; a plane, fitted together with the template, takes it off."""
    place = start[1] + template.centre[0], start[0] + template.centre[1]
    offset = (0.0, 0.0)
    reach = HALF_REACH_PX
    best = 0.0
    level = pixels
    for _ in range(SETTLING_ROUNDS):
        pattern = template.at(offset)
        middle = round(place[1] - offset[1] - template.centre[1]), round(place[0] - offset[0] - template.centre[0])
        level = without_slope(pixels, pattern, middle)
        top, left = max(middle[0] - reach, 0), max(middle[1] - reach, 0)
        area = level[top : middle[0] + pattern.shape[0] + reach, left : middle[1] + pattern.shape[1] + reach]
        field = correlate(area, pattern)
        row, column = peak_pixel(field)
        x, y = subpixel_maximum(field, row, column)
        best, before = float(field[row, column]), place
        place = left + x + template.centre[0] + offset[0], top + y + template.centre[1] + offset[1]
        offset = _fraction(place[0]), _fraction(place[1])
        if max(abs(place[0] - before[0]), abs(place[1] - before[1])) < SETTLED_PX:
            break
    return place[0], place[1], best, level


def without_slope(
    pixels: np.ndarray, pattern: np.ndarray | None = None, corner: tuple[int, int] = (0, 0)
) -> np.ndarray:
    """A window less the slope of the plane that fits it best, where there is a pattern at ``corner`` together with it
    and below it alone."""
    pattern = np.zeros(pixels.shape) if pattern is None else pattern
    rows, columns = pattern.shape
    top, left = max(corner[0], 0), max(corner[1], 0)
    under = pixels[top : corner[0] + rows, left : corner[1] + columns]
    mark = pattern[top - corner[0] :, left - corner[1] :][: under.shape[0], : under.shape[1]]
    y, x = np.indices(under.shape, dtype=np.float64)
    terms = np.column_stack([mark.ravel(), x.ravel(), y.ravel(), np.ones(mark.size)])
    _, across, down, _ = np.linalg.lstsq(terms, under.ravel().astype(np.float64), rcond=None)[0]
    y, x = np.indices(pixels.shape, dtype=np.float64)
    return np.asarray(pixels - across * x - down * y)


def _fraction(position: float) -> float:
    """The distance of a position from the nearest pixel centre, px, with its sign."""
    return position - 0.5 - round(position - 0.5)


def _brightness_extremum(pixels: np.ndarray, x: float, y: float) -> tuple[float, float]:
    """The extremum of the brightness around a pixel centre (the paper's formula 2)."""
    reach = BRIGHTNESS_REACH_PX
    row, column = int(y), int(x)
    around = pixels[max(row - reach, 0) : row + reach + 1, max(column - reach, 0) : column + reach + 1]
    if around.shape != (2 * reach + 1, 2 * reach + 1):
        raise SurfaceError(messages.SURFACE_OUTSIDE())
    dx, dy, _ = surface_extremum(fit_surface(around), reach, float(np.ptp(pixels)))
    return column + 0.5 + dx, row + 0.5 + dy


def _halves_doubt(pixels: np.ndarray, template: MeasuringTemplate, place: Place) -> Message | None:
    """The reason why a place can't be trusted, or None: each half of the template, alone, has to find the mark at the
    same place. Dirt, a scratch or the edge of the frame pulls at one half; a place that is no mark has halves that
    wander off."""
    if not template.halves_tell:
        return None
    whole = template.at((_fraction(place[0]), _fraction(place[1])))
    middle = int(template.centre[1]), int(template.centre[0])
    corner = round(place[1] - 0.5) - middle[0], round(place[0] - 0.5) - middle[1]
    reach = HALF_REACH_PX
    worst = 0.0
    for rows, columns in (
        (slice(0, middle[0] + 1), slice(None)),
        (slice(middle[0], None), slice(None)),
        (slice(None), slice(0, middle[1] + 1)),
        (slice(None), slice(middle[1], None)),
    ):
        half = whole[rows, columns]
        top, left = corner[0] + (rows.start or 0) - reach, corner[1] + (columns.start or 0) - reach
        area = pixels[max(top, 0) : top + half.shape[0] + 2 * reach, max(left, 0) : left + half.shape[1] + 2 * reach]
        field = correlate(area, half)
        if field.shape != (2 * reach + 1, 2 * reach + 1):
            return messages.MARK_AT_THE_EDGE()
        row, column = peak_pixel(field)
        try:
            x, y = subpixel_maximum(field, row, column)
        except SurfaceError:
            x, y = float(column), float(row)
        worst = max(worst, abs(x - reach), abs(y - reach))
    if worst > MAX_HALF_SHIFT_PX:
        return messages.MARK_HALVES_DIFFER(shift=worst, most=MAX_HALF_SHIFT_PX)
    return None
