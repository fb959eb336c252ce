"""The mosaicking line of the demonstration block: balance, resample, cut along seams, feather, dodge."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Callable

import numpy as np
from scipy import ndimage

from .camera import Orthoimage
from .canvas import BLOCK_ROWS, PIXEL, Extent

Tone = tuple[np.ndarray, np.ndarray]  # gain and bias of each band
# Share of a source in the mosaic at the pixels x (1, cols), y (rows, 1), by the source's name.
Weights = Callable[[np.ndarray, np.ndarray], dict[str, np.ndarray]]


@dataclass(frozen=True)
class Dodging:
    """An ellipse (m) in which the light was evened out from a coarse overview and the detail only partly given back."""

    x: float
    y: float
    half_x: float
    half_y: float
    detail_kept: float = 0.5  # share of the detail above the overview
    overview: float = 1.4  # sigma of the overview's blur, pixels
    evened: float = 0.3  # share of the slow changes of light taken out
    reach: float = 20.0  # sigma of what counts as slow, m


def balance(images: Sequence[Orthoimage], step: int = 8) -> dict[str, Tone]:
    """Linear tone of every image, band by band, that fits mean and deviation to its predecessors in their overlap.

    The first image is the reference.
    """
    tones: dict[str, Tone] = {images[0].name: (np.ones(3), np.zeros(3))}
    for number, image in enumerate(images[1:], start=1):
        mine, theirs = [], []
        for other in images[:number]:
            pair = overlap(image, other, step)
            gain, bias = tones[other.name]
            mine.append(pair[0])
            theirs.append(pair[1] * gain[:, None] + bias[:, None])
        own, target = np.concatenate(mine, axis=1), np.concatenate(theirs, axis=1)
        gain = target.std(axis=1) / own.std(axis=1)
        tones[image.name] = gain, target.mean(axis=1) - gain * own.mean(axis=1)
    return tones


def overlap(one: Orthoimage, other: Orthoimage, step: int) -> tuple[np.ndarray, np.ndarray]:
    """Values of two images at common valid pixels, every `step`-th along both axes, (3, n) each."""
    col, row = (int(round((b - a) / PIXEL)) for a, b in ((one.left, other.left), (one.top, other.top)))
    rows = min(one.pixels.shape[1] - max(row, 0), other.pixels.shape[1] + min(row, 0))
    cols = min(one.pixels.shape[2] - max(col, 0), other.pixels.shape[2] + min(col, 0))
    if rows <= 0 or cols <= 0:
        return np.empty((3, 0)), np.empty((3, 0))
    a = one.pixels[:, max(row, 0):max(row, 0) + rows:step, max(col, 0):max(col, 0) + cols:step]
    b = other.pixels[:, max(-row, 0):max(-row, 0) + rows:step, max(-col, 0):max(-col, 0) + cols:step]
    valid = a.any(axis=0) & b.any(axis=0)
    return a[:, valid].astype(np.float64), b[:, valid].astype(np.float64)


def assemble(images: Sequence[Orthoimage], tones: dict[str, Tone], corrections: dict[str, tuple[float, float]],
             weights: Weights, extent_m: Extent) -> np.ndarray:
    """The mosaic, 8 bit (3, rows, cols): images resampled to its grid and mixed by their weights.

    `corrections` are shifts in pixels that the block's adjustment found for an image.
    """
    cols, rows = (int(round(side / PIXEL)) for side in extent_m)
    x = ((np.arange(cols) + 0.5) * PIXEL).astype(np.float32)[None, :]
    mosaic = np.empty((3, rows, cols), dtype=np.uint8)
    for start in range(0, rows, BLOCK_ROWS):
        part = slice(start, min(start + BLOCK_ROWS, rows))
        y = ((np.arange(part.start, part.stop) + 0.5) * PIXEL).astype(np.float32)[:, None]
        total = np.zeros((3, part.stop - part.start, cols), dtype=np.float32)
        share = np.zeros(total.shape[1:], dtype=np.float32)
        every = weights(x, y)
        for image in images:
            used = np.flatnonzero(every[image.name].any(axis=0))
            if not used.size:
                continue
            columns = slice(used[0], used[-1] + 1)
            offset = [(0.0 - start_m) / PIXEL - move for start_m, move
                      in zip((image.left, image.top), corrections.get(image.name, (0.0, 0.0)))]
            values, valid = resample(image.pixels, part, columns, offset[1], offset[0])
            weight = every[image.name][:, columns] * valid
            gain, bias = (np.asarray(one, dtype=np.float32)[:, None, None] for one in tones[image.name])
            total[:, :, columns] += weight * (values * gain + bias)
            share[:, columns] += weight
        total /= np.maximum(share, np.float32(1e-6))
        mosaic[:, part] = np.where(share > 0, np.clip(np.rint(total), 1, 255), 0)
    return mosaic


def resample(pixels: np.ndarray, rows: slice, cols: slice, offset_row: float,
             offset_col: float) -> tuple[np.ndarray, np.ndarray]:
    """Values (bicubic) and validity of an image at the mosaic's rows and columns, moved by an offset in pixels."""
    first_row, weight_row = bicubic(offset_row)
    first_col, weight_col = bicubic(offset_col)
    needed = (slice(rows.start + first_row, rows.stop + first_row + 3),
              slice(cols.start + first_col, cols.stop + first_col + 3))
    inner, missing = [], []
    for want, size in zip(needed, pixels.shape[1:]):
        kept = slice(min(max(want.start, 0), size), max(min(want.stop, size), 0))
        inner.append(kept)
        missing.append((kept.start - want.start, want.stop - kept.stop))
    clip = np.pad(pixels[(slice(None), *inner)], ((0, 0), *missing))
    height, width = rows.stop - rows.start, cols.stop - cols.start
    valid = ndimage.minimum_filter(clip.any(axis=0), 4, origin=-2)[:height, :width]
    down = sum(np.float32(w) * clip[:, tap:tap + height] for tap, w in enumerate(weight_row))
    return sum(np.float32(w) * down[:, :, tap:tap + width] for tap, w in enumerate(weight_col)), valid


def bicubic(offset: float) -> tuple[int, np.ndarray]:
    """First of the four neighbours and their weights (Keys, a = -0.5) at a constant offset."""
    offset = round(offset, 6)
    base = int(np.floor(offset))
    t = offset - base
    near, far = np.array([t, 1 - t]), np.array([1 + t, 2 - t])
    inner = 1.5 * near ** 3 - 2.5 * near ** 2 + 1
    outer = -0.5 * far ** 3 + 2.5 * far ** 2 - 4 * far + 2
    return base - 1, np.array([outer[0], inner[0], inner[1], outer[1]])


def dodge(mosaic: np.ndarray, dodging: Dodging) -> None:
    """Even out the light inside an ellipse, in place: it looks calm, but kerbs, plants and furrows lose contrast."""
    rows, cols = (slice(max(int((middle - 1.2 * half) / PIXEL), 0), int((middle + 1.2 * half) / PIXEL))
                  for middle, half in ((dodging.y, dodging.half_y), (dodging.x, dodging.half_x)))
    view = mosaic[:, rows, cols]
    y = (rows.start + np.arange(view.shape[1]) + 0.5)[:, None] * PIXEL - dodging.y
    x = (cols.start + np.arange(view.shape[2]) + 0.5)[None, :] * PIXEL - dodging.x
    amount = np.clip((1.2 - np.hypot(x / dodging.half_x, y / dodging.half_y)) / 0.2, 0, 1).astype(np.float32)
    thin = 8  # the slow light is found on every 8th pixel
    for band in view:
        sharp = band.astype(np.float32)
        overview = ndimage.gaussian_filter(sharp, dodging.overview)
        slow = ndimage.gaussian_filter(overview[::thin, ::thin], dodging.reach / PIXEL / thin)
        slow = ndimage.zoom(slow, [a / b for a, b in zip(sharp.shape, slow.shape)], order=1)
        calm = overview + dodging.detail_kept * (sharp - overview) - dodging.evened * (slow - slow.mean())
        band[...] = np.clip(np.rint(sharp + amount * (calm - sharp)), 1, 255)
