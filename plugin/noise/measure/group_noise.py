"""Noise of many images in one group or two, with the same pixels left out of both."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from itertools import islice
from typing import Callable

import numpy as np
from scipy import ndimage

from ...imagery import limits as imagery_limits
from ...imagery import messages as imagery_messages
from ...imagery.clips import extent_on_image
from ...imagery.errors import Message, RasterError, Stated
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import RasterRef
from . import messages
from .band_noise import BandNoise, judged, measure_noise
from .noise_plan import NoiseRequest, Part


def filled(bands: np.ndarray, invalid: np.ndarray) -> np.ndarray:
    """(bands, rows, columns) with the invalid pixels, (rows, columns) of bool, filled; at least one has to be valid.

    Pull and push (Gortler and others 1996): means of 2 x 2 valid pixels, of 2 x 2 of those, and so on until nothing
    is missing, then down again by linear interpolation. Whole numbers stay whole numbers.
    """
    if not invalid.any():
        return bands
    result = np.array(bands)
    safe = np.where(invalid, 0, bands) if bands.dtype.kind == "f" else bands
    for target, band in zip(result, safe):
        values = _pulled(band.astype(np.float64), ~invalid)[invalid]
        target[invalid] = values if bands.dtype.kind == "f" else np.rint(values)
    return result


def _pulled(band: np.ndarray, valid: np.ndarray) -> np.ndarray:
    if valid.all():
        return band
    rows, columns = band.shape
    edges = ((0, rows % 2), (0, columns % 2))
    weights = _summed(np.pad(valid.astype(np.float64), edges))
    sums = _summed(np.pad(np.where(valid, band, 0.0), edges))
    coarse = _pulled(sums / np.maximum(weights, 1), weights > 0)
    fine = ndimage.zoom(coarse, 2, order=1, mode="nearest", grid_mode=True)
    return np.where(valid, band, fine[:rows, :columns])


def _summed(values: np.ndarray) -> np.ndarray:
    rows, columns = values.shape
    return values.reshape(rows // 2, 2, columns // 2, 2).sum(axis=(1, 3))


MAX_MASKED_SHARE = 0.05  # filled alike in both groups; a hole of 5 % moves a share by 0.5 % of itself

_Clip = tuple[np.ndarray, np.ndarray]  # (bands, rows, columns) and where they are invalid, (rows, columns)


@dataclass(frozen=True)
class ClipNoise:
    """The noise of one image in one window."""

    window_id: int
    part: Part
    paired: bool  # whether the window was measured on both groups, with the same pixels left out
    bands: dict[str, BandNoise]
    """Noise by band name, luminance first where there is one; empty when nothing could be measured."""
    reason: Message | None = None  # why nothing could be measured
    window_class: str | None = None  # the value of the field that windows are grouped by


def measure_requests(
    requests: Iterable[NoiseRequest], wavelet: str, levels: int, executor: Executor, ahead: int,
    cancelled: Callable[[], bool] = lambda: False,
) -> Iterator[list[ClipNoise]]:
    """The noise of each image in a window, window by window in order, ``ahead`` of them under way at a time; one that
    can't be measured has the reason. Never raises for bad data. Stops when cancelled.

    The pixels are read here, one request after the other, so that a raster stays open from window to window: a
    JPEG file is decoded from its top again for each new opening.
    """
    waiting = iter(requests)
    opened: dict[RasterRef, OpenRaster] = {}
    while (batch := list(islice(waiting, ahead))) and not cancelled():
        futures = []
        for request in batch:
            refs = {part.member.image.ref for part in request.parts}
            opened = {ref: source for ref, source in opened.items() if ref in refs}
            futures.append(executor.submit(_measured, request, _read(request, opened), wavelet, levels))
        for future in futures:
            if cancelled():
                future.cancel()
            else:
                yield future.result()


LIKE_BRIGHTNESS = 1.5  # means of windows that differ by less have noise as strong: photons' differs by 22 %


def pooled(results: Sequence[ClipNoise], wavelet: str) -> list[ClipNoise]:
    """The results judged anew, with what the windows of each image tell together.

    The most that noise can be is that of the quietest ground in all windows of the image that are as bright, within a
    factor of 1.5.
    """
    by_image: dict[RasterRef, list[ClipNoise]] = {}
    for result in results:
        by_image.setdefault(result.part.member.image.ref, []).append(result)

    def alike(band: str, signal: float | None, image: RasterRef) -> list[BandNoise]:
        noises = [other.bands[band] for other in by_image[image] if band in other.bands]
        return [noise for noise in noises if noise.ground and are_alike(signal, noise.signal)]

    def are_alike(mean: float | None, other: float | None) -> bool:
        return mean is not None and other is not None and 0 < mean / LIKE_BRIGHTNESS < other < LIKE_BRIGHTNESS * mean

    return [
        replace(result, bands={
            band: judged(noise, wavelet, alike(band, noise.signal, result.part.member.image.ref))
            for band, noise in result.bands.items()
        })
        for result in results
    ]


def _read(request: NoiseRequest, opened: dict[RasterRef, OpenRaster]) -> list[_Clip | Message]:
    """The pixels of every part and where they are invalid, or why they can't be used. ``opened`` is added to."""
    clips: list[_Clip | Message] = []
    for part in request.parts:
        ref = part.member.image.ref
        try:
            if ref not in opened:
                opened[ref] = OpenRaster(ref)
            block = opened[ref].read(part.window)
            clips.append((block.bands, ~block.valid))
        except RasterError as error:
            clips.append(error.message)
    return clips


def _measured(request: NoiseRequest, clips: list[_Clip | Message], wavelet: str, levels: int) -> list[ClipNoise]:
    results: dict[Part, ClipNoise] = {}

    def keep(part: Part, paired: bool, bands: dict[str, BandNoise], why: Message | None = None) -> None:
        results[part] = ClipNoise(request.window_id, part, paired, bands, why, request.window_class)

    most = MAX_MASKED_SHARE if request.paired else imagery_limits.MAX_INVALID_SHARE
    usable: list[tuple[Part, _Clip]] = []
    for part, clip in zip(request.parts, clips):
        if isinstance(clip, Message):
            keep(part, request.paired, {}, clip)
        elif (share := float(clip[1].mean())) > most:
            name = part.member.image.ref.name
            why = imagery_messages.TOO_MANY_INVALID(name=name, share=Stated(share, most), most=most)
            keep(part, request.paired, {}, why)
        else:
            usable.append((part, clip))
    paired = len({part.member.group for part, _ in usable}) > 1
    most = MAX_MASKED_SHARE if paired else imagery_limits.MAX_INVALID_SHARE
    masks = [invalid for _, (_, invalid) in usable]
    if paired:
        masks = _joined_masks([part for part, _ in usable], masks)
    for (part, (bands, _)), mask in zip(usable, masks):
        image, share = part.member.image, float(mask.mean())
        if share > most:
            keep(part, paired, {}, messages.MASKED_TOO_MUCH(share=Stated(share, most), most=most))
        else:
            whole = filled(bands, mask)
            keep(part, paired, measure_noise(whole, image.band_names, wavelet, levels, image.ref.name, mask))
    return [results[part] for part in request.parts]


def _joined_masks(parts: Sequence[Part], masks: Sequence[np.ndarray]) -> list[np.ndarray]:
    """The mask of each part: its pixels that are invalid in any of the parts."""
    joined = []
    for part, invalid_here in zip(parts, masks):
        mask = np.array(invalid_here)
        for other, invalid in zip(parts, masks):
            if other is not part and invalid.any():
                mask |= _seen_from(part, other, invalid)
        joined.append(mask)
    return joined


def _seen_from(part: Part, other: Part, invalid: np.ndarray) -> np.ndarray:
    """The mask of a part's pixels that lie, if only with an edge, on invalid pixels of another part."""
    own_grid, grid = part.member.image.grid, other.member.image.grid
    there = extent_on_image(own_grid.window_extent(part.window), part.member.image.wkt, other.member.image)
    assert there is not None  # the window came over the same way
    columns = np.linspace(there[0], there[2], part.window.width + 1)
    rows = np.linspace(there[3], there[1], part.window.height + 1)
    columns = grid.column_at(columns) - other.window.column
    rows = grid.row_at(rows) - other.window.row
    counts = np.pad(invalid.cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    (top, bottom), (first, last) = (_covered(edges, size) for edges, size in zip((rows, columns), invalid.shape))
    below, above = counts[bottom], counts[top]
    return np.asarray(below[:, last] - above[:, last] - below[:, first] + above[:, first] > 0)


def _covered(edges: np.ndarray, size: int) -> tuple[np.ndarray, np.ndarray]:
    """First and last but one of the cells 0..size - 1 that lie between neighbouring edges; slivers do not count."""
    sliver = 1e-3  # of a cell: rounding of coordinates
    first = np.clip(np.floor(edges[:-1] + sliver), 0, size).astype(int)
    last = np.clip(np.ceil(edges[1:] - sliver), 0, size).astype(int)
    return first, np.maximum(last, first)
