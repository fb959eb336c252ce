"""Windows for which it is known which source each pixel was taken from, and mosaics made of them by known operations.

What a step of production does to a mosaic is done here to real clips, one step at a time, so that its cause and its
numbers are known beforehand.
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Callable

import numpy as np
from osgeo import gdal, ogr
from scipy import ndimage
from seam_inspector.plugin.imagery.clips import Clip, read_clip
from seam_inspector.plugin.imagery.errors import NotCoveredError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.limits import DEFAULT_LEVELS, DEFAULT_WAVELET
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.imagery.wavelets import Curve, measure_bands
from seam_inspector.plugin.seams.measure.compared_image import MeasuredClip
from seam_inspector.plugin.seams.measure.judgement.causes import Cause
from seam_inspector.plugin.seams.measure.judgement.explanation import Explanation, explain
from seam_inspector.plugin.seams.measure.window.inspection import Block, make_block

STEP_PX = 24
"""Raster of the windows that are looked at."""
MIN_SECOND_SHARE = 0.1
"""Least share of a window's pixels that come from the source it has second most of."""


@dataclass(frozen=True, eq=False)
class Scene:
    """The clips of one window and the cut that is known."""

    window: PixelWindow
    labels: np.ndarray
    """(rows, columns) uint8: index of each pixel's source in ``sources``."""
    sources: tuple[Clip, ...]
    mosaic: Raster

    @property
    def main(self) -> tuple[int, int]:
        """The two sources with most pixels."""
        order = np.bincount(self.labels.ravel(), minlength=len(self.sources)).argsort()[::-1]
        return int(order[0]), int(order[1])

    def cut(self) -> np.ndarray:
        """The hard cut, (bands, rows, columns) as the sources are."""
        return cut(self.labels, [clip.bands for clip in self.sources])


@dataclass(frozen=True)
class Truth:
    """One operation, what it should be called and what should be measured after it; None: not known."""

    name: str
    cause: Cause
    make: Callable[[Scene], np.ndarray]
    """The mosaic's bands, of the sources' type."""
    gain: float | None = None
    bias: float | None = None
    gamma: float = 1.0
    colours: tuple[float, float, float] | None = None
    """Gains of the bands."""
    shift: tuple[float, float] | None = None
    """Shift of the mosaic on its second source, x and y px."""
    linear: Callable[[Scene], tuple[float, float]] | None = field(default=None)
    """Gain and bias where they follow from the clip."""


def brighton_scenes(folder: Path, side: int, count: int) -> list[Scene]:
    """Windows on the seams of Brighton's mosaics, whose labels come with them."""
    sources = sorted(folder.glob("DJI_*_ortho.tif"))
    labels = gdal.Open(str(folder / "source_label.tif")).ReadAsArray()
    return scenes_of(folder / "mosaic_hardseam.tif", sources, labels, side, count)


def demo_scenes(block_mosaic: Path, sources: Sequence[Path], seams: Path, side: int, count: int) -> list[Scene]:
    """Windows on the seams of the demonstration's block, labels from the layer ``cells``."""
    mosaic = gdal.Open(str(block_mosaic))
    labels = gdal.GetDriverByName("MEM").Create("", mosaic.RasterXSize, mosaic.RasterYSize, 1, gdal.GDT_Byte)
    labels.SetGeoTransform(mosaic.GetGeoTransform())
    labels.SetProjection(mosaic.GetProjection())
    package = ogr.Open(str(seams))
    layer = package.GetLayerByName("cells")
    for number, path in enumerate(sources, 1):
        layer.SetAttributeFilter(f"source = '{path.name}'")
        gdal.RasterizeLayer(labels, [1], layer, burn_values=[number])
    return scenes_of(block_mosaic, sources, labels.ReadAsArray(), side, count)


def scenes_of(mosaic: Path, sources: Sequence[Path], labels: np.ndarray, side: int, count: int) -> list[Scene]:
    """Up to ``count`` windows of ``side`` px on seams, spread evenly over all that there are, always the same.

    ``labels`` (rows, columns) of the whole mosaic: number of each pixel's source from 1, 0 for none. A window counts
    where the second source has a tenth of it and all its sources cover it.
    """
    block, _ = make_block(describe_mosaic(RasterRef(str(mosaic))), [RasterRef(str(path)) for path in sources])
    valid = np.stack([_valid(path, block.mosaic) for path in sources])
    places = [
        PixelWindow(column, row, side, side)
        for row in range(0, labels.shape[0] - side + 1, STEP_PX)
        for column in range(0, labels.shape[1] - side + 1, STEP_PX)
        if _lies_on_a_covered_seam(labels[row : row + side, column : column + side],
                                   valid[:, row : row + side, column : column + side])
    ]
    names = [path.name for path in sources]
    return [_scene(block, places[number], labels, names) for number in _spread(len(places))[:count]]


def _valid(path: Path, mosaic: Raster) -> np.ndarray:
    """Where a source has pixels, (rows, columns) bool of the mosaic, to the nearest pixel."""
    grid, own = mosaic.grid, describe(RasterRef(str(path))).grid
    row, column = round((grid.top - own.top) / grid.pixel_height), round((own.left - grid.left) / grid.pixel_width)
    found = (gdal.Open(str(path)).ReadAsArray() > 0).any(axis=0)
    found = found[max(-row, 0) : grid.rows - row, max(-column, 0) : grid.columns - column]
    row, column = max(row, 0), max(column, 0)
    margins = ((row, grid.rows - row - found.shape[0]), (column, grid.columns - column - found.shape[1]))
    return np.pad(found, margins)


def _spread(count: int) -> list[int]:
    """0 to ``count`` - 1 in an order in which any beginning is spread over all of them: by the golden section."""
    return sorted(range(count), key=lambda number: number * 0.6180339887498949 % 1)


def _lies_on_a_covered_seam(labels: np.ndarray, valid: np.ndarray) -> bool:
    shares = np.bincount(labels[::8, ::8].ravel(), minlength=2) / labels[::8, ::8].size
    if shares[0] > 0 or np.sort(shares)[-2] < MIN_SECOND_SHARE or labels.min() == 0:
        return False
    return all(valid[number - 1].all() for number in np.unique(labels))


def _scene(block: Block, window: PixelWindow, labels: np.ndarray, names: Sequence[str]) -> Scene:
    clips: list[Clip] = []
    places = np.zeros(256, np.uint8)
    for source in block.sources_over(window):
        try:
            clip = read_clip(OpenRaster(source.ref), block.mosaic, window)
        except NotCoveredError:
            continue
        places[names.index(source.ref.name) + 1] = len(clips)
        clips.append(replace(clip, offset_x=0.0, offset_y=0.0))  # the mosaic is made of these very pixels
    own = labels[window.row : window.row + window.height, window.column : window.column + window.width]
    return Scene(window, places[own], tuple(clips), block.mosaic)


def cut(labels: np.ndarray, sources: Sequence[np.ndarray]) -> np.ndarray:
    """Each pixel from the source that its label names."""
    mosaic = np.empty_like(sources[0])
    for number, bands in enumerate(sources):
        np.copyto(mosaic, bands, where=labels == number)
    return mosaic


def feather(labels: np.ndarray, sources: Sequence[np.ndarray], sigma_px: float) -> np.ndarray:
    """Sources weighted by their labels smoothed with a Gaussian."""
    blended = np.zeros(sources[0].shape, np.float32)
    for number in np.unique(labels):
        blended += ndimage.gaussian_filter((labels == number).astype(np.float32), sigma_px) * sources[number]
    return whole_values(blended)


def half_and_half(scene: Scene) -> np.ndarray:
    """The mean of the two sources with most pixels."""
    first, second = (scene.sources[number].bands.astype(np.float32) for number in scene.main)
    return whole_values((first + second) / 2)


def blur(scene: Scene, sigma_px: float) -> np.ndarray:
    """The hard cut, smoothed."""
    return whole_values(ndimage.gaussian_filter(scene.cut().astype(np.float32), (0, sigma_px, sigma_px)))


def gain(scene: Scene, factor: float, bias: float = 0.0) -> np.ndarray:
    """The hard cut with a narrower or wider histogram."""
    return whole_values(scene.cut() * np.float32(factor) + np.float32(bias))


def power(scene: Scene, gamma: float) -> np.ndarray:
    """The hard cut after a power function over the whole scale."""
    return whole_values(255 * (scene.cut() / np.float32(255)) ** np.float32(gamma))


def stretch_of(scene: Scene) -> tuple[float, float]:
    """Gain and bias by which 3 % of the hard cut's values leave the scale, half at either end."""
    low, high = np.percentile(scene.cut(), (1.5, 98.5))
    return float(255 / (high - low)), float(-low * 255 / (high - low))


def colours(scene: Scene, gains: Sequence[float]) -> np.ndarray:
    """The hard cut with each band corrected for itself."""
    return whole_values(scene.cut() * np.asarray(gains, np.float32)[:, np.newaxis, np.newaxis])


def misplaced(scene: Scene, x_px: float, y_px: float, sigma_px: float) -> np.ndarray:
    """Feathered after the second source was moved to the right and down."""
    bands = [clip.bands for clip in scene.sources]
    second = scene.main[1]
    bands[second] = whole_values(ndimage.shift(bands[second].astype(np.float32), (0, y_px, x_px), mode="nearest"))
    return feather(scene.labels, bands, sigma_px)


def whole_values(bands: np.ndarray) -> np.ndarray:
    """Rounded to 8 bit, and held inside it."""
    return np.clip(np.rint(bands), 0, 255).astype(np.uint8)


def truths(pixel_m: float) -> list[Truth]:
    """All operations, for pixels of that size on the ground."""
    wide = 0.4 / pixel_m

    def feathered(width_m: float) -> Truth:
        make = lambda scene: feather(scene.labels, [clip.bands for clip in scene.sources], width_m / pixel_m)  # noqa: E731
        return Truth(f"feather {width_m:g} m", Cause.FEATHERING, make, 1.0, 0.0)

    def blurred(sigma: float) -> Truth:
        return Truth(f"blur {sigma:g} px", Cause.BLUR, lambda scene: blur(scene, sigma), 1.0, 0.0)

    def curved(gamma: float) -> Truth:
        return Truth(f"gamma {gamma:g}", Cause.GAMMA, lambda scene: power(scene, gamma), gamma=gamma)

    def moved(x: float, y: float) -> Truth:
        make = lambda scene: misplaced(scene, x, y, wide)  # noqa: E731
        return Truth(f"shift {abs(x + y):g} px", Cause.MISREGISTRATION, make, shift=(x, y))

    gains = (0.85, 1.0, 0.92)
    return [
        Truth("hard cut", Cause.NONE, Scene.cut, 1.0, 0.0),
        *map(feathered, (0.2, 0.4, 1.0)),
        Truth("gain 0.6", Cause.NARROWED_HISTOGRAM, lambda scene: gain(scene, 0.6, 20), 0.6, 20.0),
        *map(curved, (0.6, 1.6)),
        Truth("clipping 3 %", Cause.CLIPPING, lambda scene: gain(scene, *stretch_of(scene)), linear=stretch_of),
        Truth("gains by channel", Cause.COLOUR_SHIFT, lambda scene: colours(scene, gains), colours=gains),
        *map(blurred, (0.6, 0.8, 1.2)),
        moved(0.5, 0.0),
        moved(0.0, 1.0),
        moved(-2.0, 0.0),
    ]


def explained(scene: Scene, bands: np.ndarray) -> tuple[Explanation, Mapping[str, Curve], list[Mapping[str, Curve]]]:
    """What the measurement says of a mosaic in the scene's window: explanation, its curves and its sources'."""
    mosaic, *sources = (
        MeasuredClip(clip, *measure_bands(clip.bands, clip.raster.band_names, DEFAULT_WAVELET, DEFAULT_LEVELS))
        for clip in (Clip(scene.mosaic, bands, 0.0), *scene.sources)
    )
    found = explain(mosaic, sources, DEFAULT_WAVELET, DEFAULT_LEVELS)
    return found, mosaic.curves, [source.curves for source in sources]
