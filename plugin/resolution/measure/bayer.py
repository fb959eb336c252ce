"""The image of a single-chip camera: of each pixel the colour of its filter, the others interpolated."""
from __future__ import annotations

from importlib.util import find_spec
from typing import Callable

import numpy as np
from scipy import ndimage

from ...imagery import messages as imagery_messages
from ...imagery.errors import CancelledError, RasterError, SettingsError
from ...imagery.grids import PixelWindow
from ...imagery.open_raster import OpenRaster
from ...imagery.raster_writer import WrittenBands, raster_writer
from ...imagery.rasters import Raster
from . import messages
from . import target as limits

BILINEAR, _, EDGE_AWARE = limits.DEMOSAICS

_REACH_PX = 8  # how far a pixel's neighbours reach, generously: strips overlap by this, an even number
_STRIP_PIXELS = 4_000_000


def check_demosaic(demosaic: str) -> None:
    """Raise SettingsError for a way of interpolation that needs OpenCV where that is not there."""
    if demosaic == EDGE_AWARE and find_spec("cv2") is None:
        raise SettingsError(messages.OPENCV_MISSING())


def simulate_file(
    raster: Raster, path: str, pattern: str, demosaic: str, progress: Callable[[float], bool] = lambda share: True
) -> None:
    """Write what a single-chip camera would have seen of a raster, strip by strip.

    A raster of one band is a grey scene. Pixels without data stay so. ``progress`` gets the share that is done and
    says whether to go on. Raises SettingsError without OpenCV, RasterError for a raster that has no colours, or
    can't be read or written, CancelledError when cancelled; no half-written file is left then, and an older one as it
    was.
    """
    check_demosaic(demosaic)
    names = raster.band_names
    if not raster.has_luminance and len(names) > 1:
        raise RasterError(messages.BANDS_NOT_COLOURS(name=raster.ref.name, count=len(names)))
    source, columns, rows = OpenRaster(raster.ref), raster.columns, raster.rows
    height = max(2, _STRIP_PIXELS // columns // 2 * 2)
    kind = source.read(PixelWindow(0, 0, 1, 1)).bands.dtype
    with raster_writer(path, raster, WrittenBands(3, kind, True, source.nodata)) as writer:
        for row in range(0, rows, height):
            top, bottom = max(0, row - _REACH_PX), min(rows, row + height + _REACH_PX)
            block = source.read(PixelWindow(0, top, columns, bottom - top))
            colours = block.bands[:3] if len(names) >= 3 else np.repeat(block.bands[:1], 3, axis=0)
            seen = np.where(block.valid, simulated(colours, pattern, demosaic), colours)
            last = min(row + height, rows)
            writer.write(row, seen[:, row - top : last - top])
            if not progress(last / rows):
                raise CancelledError(imagery_messages.CANCELLED())


def interpolated(chip: np.ndarray, pattern: str, demosaic: str) -> np.ndarray:
    """Red, green and blue (3, rows, columns) of a chip's (rows, columns), in its data type.

    ``bilinear``: the mean of the two or four nearest pixels of the colour. ``malvar``: that, and a share of what the
    pixel's colour differs from its neighbours (Malvar, He and Cutler 2004). ``edge_aware``: OpenCV's, along edges.
    ``pattern``: colours of the filter over the first two pixels of the first row, then of the second. Raises
    RasterError when the way does not go with the data type.
    """
    if demosaic == EDGE_AWARE:
        if chip.dtype not in (np.uint8, np.uint16):
            raise RasterError(messages.EDGE_AWARE_WANTS_INTEGERS(kind=chip.dtype))
        import cv2

        code = f"COLOR_Bayer{pattern[:1:-1]}2RGB_EA"  # OpenCV names the second row, from its second pixel back
        colours = cv2.cvtColor(chip, getattr(cv2, code))
        return np.ascontiguousarray(np.moveaxis(colours, -1, 0))
    result = (_bilinear if demosaic == BILINEAR else _malvar)(chip.astype(np.float64), pattern)
    if chip.dtype.kind == "f":
        return result.astype(chip.dtype)
    largest = np.iinfo(chip.dtype)
    return np.clip(np.rint(result), largest.min, largest.max).astype(chip.dtype)


def simulated(colours: np.ndarray, pattern: str, demosaic: str) -> np.ndarray:
    """(3, rows, columns) as a single-chip camera would have seen red, green and blue (3, rows, columns): interpolated
    of what its chip records. Raises RasterError as ``interpolated`` does."""
    chip = np.asarray(np.choose(_colour_indices(pattern, colours.shape[1:]), colours))
    return interpolated(chip, pattern, demosaic)


def _colour_indices(pattern: str, shape: tuple[int, ...]) -> np.ndarray:
    """(rows, columns): the place in RGB of the colour of the filter over each pixel."""
    rows, columns = np.indices(shape)
    return np.array(["RGB".index(colour) for colour in pattern])[rows % 2 * 2 + columns % 2]


def _bilinear(chip: np.ndarray, pattern: str) -> np.ndarray:
    """Pixels of the colour as they are, else the mean of those around: two or four at the sides, or at the corners."""
    indices, around = _colour_indices(pattern, chip.shape), np.ones((3, 3))
    result = np.empty((3, *chip.shape))
    for index in range(3):
        there = indices == index
        total, count = (ndimage.correlate(values, around, mode="constant") for values in (chip * there, there * 1.0))
        result[index] = np.where(there, chip, total / np.maximum(count, 1))
    return result


_GREEN = np.array([[0, 0, -1, 0, 0], [0, 0, 2, 0, 0], [-1, 2, 4, 2, -1], [0, 0, 2, 0, 0], [0, 0, -1, 0, 0]]) / 8
_IN_ROW = np.array([[0, 0, 0.5, 0, 0], [0, -1, 0, -1, 0], [-1, 4, 5, 4, -1], [0, -1, 0, -1, 0], [0, 0, 0.5, 0, 0]]) / 8
_OPPOSITE = np.array(
    [[0, 0, -1.5, 0, 0], [0, 2, 0, 2, 0], [-1.5, 0, 6, 0, -1.5], [0, 2, 0, 2, 0], [0, 0, -1.5, 0, 0]]
) / 8  # fmt: skip


def _malvar(chip: np.ndarray, pattern: str) -> np.ndarray:
    """Linear filters of five by five pixels; beyond the border the chip goes on mirrored, which keeps its pattern."""
    green, in_row, in_column, opposite = (
        ndimage.correlate(chip, kernel, mode="mirror") for kernel in (_GREEN, _IN_ROW, _IN_ROW.T, _OPPOSITE)
    )
    indices = _colour_indices(pattern, chip.shape)
    at_green = indices == 1
    result = np.empty((3, *chip.shape))
    for index in (0, 2):
        in_its_row = (indices == index).any(axis=1, keepdims=True)
        result[index] = np.where(at_green, np.where(in_its_row, in_row, in_column), opposite)
    result[1] = green
    np.put_along_axis(result, indices[np.newaxis], chip[np.newaxis], axis=0)
    return result
