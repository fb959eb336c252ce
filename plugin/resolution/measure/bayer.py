"""What a single-chip camera would have seen: of each pixel the colour of its filter, the others interpolated."""
from __future__ import annotations

from collections.abc import Iterator
from importlib.util import find_spec
from typing import Callable

import numpy as np

from ...imagery import messages as imagery_messages
from ...imagery.errors import CancelledError, RasterError, SettingsError
from ...imagery.grids import PixelWindow
from ...imagery.open_raster import OpenRaster
from ...imagery.raster_writer import WrittenBands, raster_writer
from ...imagery.rasters import Raster
from . import messages
from . import target as limits

BILINEAR, MALVAR, EDGE_AWARE = limits.DEMOSAICS

_REACH_PX = 8  # how far a pixel's neighbours reach, generously: strips overlap by this, an even number
_STRIP_PIXELS = 4_000_000

_CODES = {"RGGB": "BG", "BGGR": "RG", "GRBG": "GB", "GBRG": "GR"}  # OpenCV names the second row's second pixel first


def check_demosaic(pattern: str, demosaic: str) -> None:
    """Raise SettingsError for a pattern or a way of interpolation that is not there."""
    if pattern not in limits.BAYER_PATTERNS:
        raise SettingsError(messages.BAYER_PATTERN_UNKNOWN(pattern=pattern, known=", ".join(limits.BAYER_PATTERNS)))
    if demosaic not in limits.DEMOSAICS:
        raise SettingsError(messages.DEMOSAIC_UNKNOWN(demosaic=demosaic, known=", ".join(limits.DEMOSAICS)))
    if demosaic == EDGE_AWARE and find_spec("cv2") is None:
        raise SettingsError(messages.OPENCV_MISSING())


def simulate_file(
    raster: Raster, path: str, pattern: str, demosaic: str, progress: Callable[[float], bool] = lambda share: True
) -> None:
    """Write what a single-chip camera would have seen of a raster, strip by strip.

    A raster of one band is a grey scene. Pixels without data stay so. ``progress`` gets the share that is done and
    says whether to go on. Raises SettingsError for unknown ways, RasterError for a raster that has no colours, or
    can't be read or written, CancelledError when cancelled; no half-written file is left then, and an older one as it
    was.
    """
    check_demosaic(pattern, demosaic)
    names = raster.band_names
    if not raster.has_luminance and len(names) > 1:
        raise RasterError(messages.BANDS_NOT_COLOURS(name=raster.ref.name, count=len(names)))
    source = OpenRaster(raster.ref)
    kind = source.read(PixelWindow(0, 0, 1, 1)).bands.dtype
    if demosaic == EDGE_AWARE:
        _check_kind(kind)
    with raster_writer(path, raster, WrittenBands(3, kind, True, source.nodata)) as writer:
        for row, seen in _strips(source, pattern, demosaic):
            writer.write(row, seen)
            if not progress((row + seen.shape[1]) / raster.rows):
                raise CancelledError(imagery_messages.CANCELLED())


def _strips(source: OpenRaster, pattern: str, demosaic: str) -> Iterator[tuple[int, np.ndarray]]:
    """First row and (3, rows, columns) of pieces from top to bottom."""
    columns, rows = source.columns, source.rows
    height = max(2, _STRIP_PIXELS // columns // 2 * 2)
    for row in range(0, rows, height):
        top, bottom = max(0, row - _REACH_PX), min(rows, row + height + _REACH_PX)
        block = source.read(PixelWindow(0, top, columns, bottom - top))
        bands = block.bands
        colours = bands[:3] if len(bands) >= 3 else np.repeat(bands[:1], 3, axis=0)
        seen = np.where(block.valid, simulated(colours, pattern, demosaic), colours)
        yield row, seen[:, row - top : min(row + height, rows) - top]


def filtered(colours: np.ndarray, pattern: str) -> np.ndarray:
    """What the chip records: (rows, columns) of (3, rows, columns), the colour of the filter over each pixel."""
    chip = np.empty_like(colours[0])
    for place, colour in enumerate(pattern):
        row, column = divmod(place, 2)
        chip[row::2, column::2] = colours["RGB".index(colour), row::2, column::2]
    return chip


def interpolated(chip: np.ndarray, pattern: str, demosaic: str) -> np.ndarray:
    """Red, green and blue (3, rows, columns) of a chip's (rows, columns), in its data type.

    ``bilinear``: the mean of the two or four nearest pixels of the colour. ``malvar``: that, and a share of what the
    pixel's own colour differs from its neighbours (Malvar, He and Cutler 2004). ``edge_aware``: OpenCV's, along edges.
    Raises RasterError when the way does not go with the data type.
    """
    if demosaic == BILINEAR:
        return _bilinear(chip, pattern)
    if demosaic == MALVAR:
        return _malvar(chip, pattern)
    _check_kind(chip.dtype)
    import cv2

    colours = cv2.cvtColor(chip, getattr(cv2, f"COLOR_Bayer{_CODES[pattern]}2RGB_EA"))
    return np.ascontiguousarray(np.moveaxis(colours, -1, 0))


def simulated(colours: np.ndarray, pattern: str, demosaic: str) -> np.ndarray:
    """(3, rows, columns) as a single-chip camera would have seen it. Raises RasterError as ``interpolated`` does."""
    return interpolated(filtered(colours, pattern), pattern, demosaic)


def _check_kind(kind: np.dtype) -> None:
    if kind not in (np.uint8, np.uint16):
        raise RasterError(messages.EDGE_AWARE_WANTS_INTEGERS(kind=kind))


def _bilinear(chip: np.ndarray, pattern: str) -> np.ndarray:
    rows, columns = chip.shape
    values = np.zeros((3, rows + 2, columns + 2))
    there = np.zeros((3, rows + 2, columns + 2))
    for place, colour in enumerate(pattern):
        row, column = divmod(place, 2)
        index = "RGB".index(colour)
        values[index, 1 + row : rows + 1 : 2, 1 + column : columns + 1 : 2] = chip[row::2, column::2]
        there[index, 1 + row : rows + 1 : 2, 1 + column : columns + 1 : 2] = 1
    result = np.empty((3, rows, columns), chip.dtype)
    for index in range(3):
        mean = _nearest_mean(values[index], there[index])
        result[index] = mean if chip.dtype.kind == "f" else np.rint(mean)
    return result


def _malvar(chip: np.ndarray, pattern: str) -> np.ndarray:
    """Linear filters of five by five pixels; beyond the border the chip goes on mirrored, which keeps its pattern."""
    rows, columns = chip.shape
    padded = np.pad(chip.astype(np.float64), 2, mode="reflect")

    def near(*places: tuple[int, int]) -> np.ndarray:
        """The sum of the pixels so far down and to the right, and of those opposite."""
        shifts = [(sign * down, sign * right) for down, right in places for sign in (1, -1)]
        return np.asarray(sum(padded[2 + y : 2 + y + rows, 2 + x : 2 + x + columns] for y, x in shifts))

    own = padded[2:-2, 2:-2]
    upright, level, corners = near((1, 0)), near((0, 1)), near((1, 1), (1, -1))
    upright2, level2 = near((2, 0)), near((0, 2))
    green = (4 * own + 2 * (upright + level) - upright2 - level2) / 8  # at red and blue
    in_row = (5 * own + 4 * level - corners - level2 + upright2 / 2) / 8  # red or blue at green, in a row of theirs
    in_column = (5 * own + 4 * upright - corners - upright2 + level2 / 2) / 8
    opposite = (6 * own + 2 * corners - 1.5 * (upright2 + level2)) / 8  # red at blue, blue at red
    result = np.repeat(own[np.newaxis], 3, axis=0)
    for place, here in enumerate(pattern):
        row, column = divmod(place, 2)
        at = np.s_[row::2, column::2]
        for index, colour in enumerate("RGB"):
            if colour == here:
                continue
            in_the_row = pattern[2 * row + 1 - column] == colour
            kind = green if colour == "G" else opposite if here != "G" else in_row if in_the_row else in_column
            result[index][at] = kind[at]
    if chip.dtype.kind == "f":
        return result.astype(chip.dtype)
    largest = np.iinfo(chip.dtype)
    return np.clip(np.rint(result), largest.min, largest.max).astype(chip.dtype)


def _nearest_mean(values: np.ndarray, there: np.ndarray) -> np.ndarray:
    """Pixels of the colour as they are; else the mean of those at the sides, or at the corners where there are none."""
    own, has = values[1:-1, 1:-1], there[1:-1, 1:-1]
    sides, side_count = (_sum(each, ((0, 1), (1, 0), (1, 2), (2, 1))) for each in (values, there))
    corners, corner_count = (_sum(each, ((0, 0), (0, 2), (2, 0), (2, 2))) for each in (values, there))
    near = np.where(side_count > 0, sides / np.maximum(side_count, 1), corners / np.maximum(corner_count, 1))
    return np.where(has > 0, own, near)


def _sum(padded: np.ndarray, places: tuple[tuple[int, int], ...]) -> np.ndarray:
    rows, columns = padded.shape[0] - 2, padded.shape[1] - 2
    return np.asarray(sum(padded[row : row + rows, column : column + columns] for row, column in places))
