"""Where marks are looked for, and those pieces of the photo, coarse to fine."""
from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

COARSEST_SIDE_PX = 150  # of a photo: marks up to a tenth of it wide
COARSEST_WINDOW_PX = 64  # of a search window: a coarse figure is 25 px wide with its ground

Place = tuple[float, float]
"""Column and row in the photo, px."""


@dataclass(frozen=True)
class SearchArea:
    """A rectangle of the photo, px: left, top, right, bottom."""

    left: float
    top: float
    right: float
    bottom: float


@dataclass(frozen=True, eq=False)
class MarkFrame:
    """The marks of a calibration as they lie in the photo but for shift, scale and a small rotation."""

    marks: tuple[str, ...]
    places: np.ndarray
    """(n, 2) mm, x to the right and y downwards in the photo."""
    areas: tuple[SearchArea, ...]
    """Where each mark is looked for."""
    scales: tuple[float, float]
    """Smallest and largest pixels per millimetre."""
    rotation: float
    """Largest rotation, radians."""


def image_pyramid(image: np.ndarray, coarsest: int) -> list[np.ndarray]:
    """An image and its halves, quarters, ... until a side would be shorter than ``coarsest`` px."""
    made = [image]
    while min(made[-1].shape) >= 2 * coarsest:
        made.append(block_means(made[-1], 2))
    return made


def block_means(pixels: np.ndarray, step: int) -> np.ndarray:
    """(rows, columns) reduced by an integer, each pixel a mean; what is left over is cut off."""
    rows, columns = (side // step for side in pixels.shape)
    return np.asarray(pixels[: rows * step, : columns * step].reshape(rows, step, columns, step).mean(axis=(1, 3)))


@dataclass(frozen=True, eq=False)
class ReducedView:
    """A piece of the photo, reduced."""

    pixels: np.ndarray
    """(rows, columns)."""
    left: float
    """Column of its left edge in the photo, px."""
    top: float
    """Row of its upper edge in the photo, px."""
    factor: float
    """Pixels of the photo that one of its pixels is wide."""


Scene = Callable[[MarkFrame], Sequence[Sequence[ReducedView]]]
"""One view for each mark of a frame, for each level, coarse to fine."""


def whole_photo_views(image: np.ndarray, factor: int) -> Scene:
    """Views of the areas in which a frame may have its marks; the image is the photo reduced by a factor."""
    levels = list(enumerate(image_pyramid(image, COARSEST_SIDE_PX)))[::-1]
    return lambda frame: [[_cut(level, area, factor * 2.0**k) for area in frame.areas] for k, level in levels]


def window_views(views: Sequence[ReducedView]) -> Scene:
    """Views of one window for each mark, of one size."""
    pyramids = [image_pyramid(view.pixels, COARSEST_WINDOW_PX) for view in views]
    count = min(len(pyramid) for pyramid in pyramids)
    made = [
        [replace(view, pixels=pyramid[k], factor=view.factor * 2.0**k) for view, pyramid in zip(views, pyramids)]
        for k in reversed(range(count))
    ]
    return lambda frame: made


def _cut(level: np.ndarray, area: SearchArea, factor: float) -> ReducedView:
    left, top = max(int(area.left / factor), 0), max(int(area.top / factor), 0)
    piece = level[top : math.ceil(area.bottom / factor), left : math.ceil(area.right / factor)]
    return ReducedView(piece, left * factor, top * factor, factor)
