"""Where a window lost detail, painted over a small picture of it, for a report. Reads pixels, knows no Qt's widgets."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...imagery.grids import PixelWindow
from ...toolkit.pages.picture_files import encoded
from ..measure.inspection import Block, InspectionSettings, inspect_window, window_request
from ..measure.profile.loss_picture import LossPicture
from ..words import LOSS_OPACITY, loss_rgba

_SIDE_PX = 300  # of the picture at most
_QUALITY = 75
_FRAME = (255, 255, 255), (17, 17, 17), (255, 255, 255)  # colours of the outline of a part, the outer one first


@dataclass(frozen=True)
class PlacedLoss:
    """Lost detail, and the pixels of the mosaic that it was measured on."""

    window: PixelWindow
    loss: LossPicture


def measured_loss(block: Block, window: PixelWindow) -> PlacedLoss | None:
    """Lost detail of some pixels of a mosaic; None where that can't be told."""
    extent = block.mosaic.grid.window_extent(window)
    result = inspect_window(window_request(block, 0, extent, InspectionSettings()))
    if result.loss is None or result.window is None:
        return None
    return PlacedLoss(result.window, result.loss)


def most_lost(shown: PixelWindow, placed: PlacedLoss, side: int) -> tuple[int, int]:
    """Row and column, in the pixels shown, of the square in which most detail was lost."""
    found, inside = _by_pixel(1 - np.clip(np.nan_to_num(placed.loss.kept, nan=1.0), 0, 1), shown, placed)
    sums = np.pad((found * inside).cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    lost = sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side]
    row, column = np.unravel_index(lost.argmax(), lost.shape)
    return int(row), int(column)


def loss_overview(pixels: np.ndarray, shown: PixelWindow, placed: PlacedLoss, part: PixelWindow) -> tuple[bytes, int]:
    """A JPEG file of the pixels shown, (rows, columns, 3) uint8, under lost detail and a frame around a part of them,
    and its columns."""
    step = -(-max(shown.width, shown.height) // _SIDE_PX)
    picture = _reduced(pixels, step)
    colours = _reduced(_colours(shown, placed), step)
    opacity = LOSS_OPACITY * colours[..., 3:] / 255
    painted = np.rint(picture * (1 - opacity) + colours[..., :3] * opacity).astype(np.uint8)
    row, column = (part.row - shown.row) // step, (part.column - shown.column) // step
    for inset, colour in enumerate(_FRAME):
        _draw_frame(painted, row + inset, column + inset, part.height // step - 2 * inset,
                    part.width // step - 2 * inset, colour)  # fmt: skip
    return encoded(painted, "JPEG", _QUALITY), painted.shape[1]


def _colours(shown: PixelWindow, placed: PlacedLoss) -> np.ndarray:
    """(rows, columns, 4) of each pixel shown; transparent beyond what was measured."""
    found, inside = _by_pixel(loss_rgba(placed.loss.kept), shown, placed)
    return np.asarray(found * inside[..., np.newaxis])


def _by_pixel(cells: np.ndarray, shown: PixelWindow, placed: PlacedLoss) -> tuple[np.ndarray, np.ndarray]:
    """What cells say of each pixel shown, and whether it lies in what was measured, both (rows, columns)."""
    side, window = placed.loss.cell_px, placed.window
    rows = np.arange(shown.row, shown.row + shown.height) - window.row
    columns = np.arange(shown.column, shown.column + shown.width) - window.column
    found = cells[np.ix_(np.clip(rows // side, 0, len(cells) - 1), np.clip(columns // side, 0, cells.shape[1] - 1))]
    inside = np.outer((rows >= 0) & (rows < window.height), (columns >= 0) & (columns < window.width))
    return found, inside


def _reduced(pixels: np.ndarray, step: int) -> np.ndarray:
    """The means of ``step`` x ``step`` pixels, float32; what is left over is cut off."""
    rows, columns = (length // step for length in pixels.shape[:2])
    whole = pixels[: rows * step, : columns * step].astype(np.float32)
    return np.asarray(whole.reshape(rows, step, columns, step, -1).mean(axis=(1, 3)))


def _draw_frame(picture: np.ndarray, row: int, column: int, rows: int, columns: int, colour: tuple[int, ...]) -> None:
    bottom, right = min(row + rows, len(picture)) - 1, min(column + columns, picture.shape[1]) - 1
    picture[row, column : right + 1] = picture[bottom, column : right + 1] = colour
    picture[row : bottom + 1, column] = picture[row : bottom + 1, right] = colour
