"""Clips as they are compared: reduced to the bands that all have, with what is looked at more than once.

And what became of a source's grey values in the mosaic, band by band. Floating point values are compared as those of 8
or 16 bit are, which limits of energy are meant for.
"""
from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np

from ...imagery.clips import Clip, read_clip
from ...imagery.errors import RasterError
from ...imagery.gdal_paths import file_stamp
from ...imagery.grids import PixelWindow
from ...imagery.limits import COLOURS, LUMINANCE, LUMINANCE_WEIGHTS, MIN_SHARE, has_colours
from ...imagery.open_raster import OpenRaster
from ...imagery.raster_pool import open_raster
from ...imagery.rasters import Raster
from ...imagery.shifts import Shift, Spectra
from ...imagery.wavelets import Curve, judged_plane
from .source_images import even_places
from .tone import Tone, clipped_share, coarse_means, fit_tones


@dataclass(frozen=True, eq=False)
class MeasuredClip:
    """A clip with what was measured in it, by band name; nothing of one that covers the window only partly."""

    clip: Clip
    curves: dict[str, Curve]
    coarse: dict[str, np.ndarray]
    grey_factor: float = 1.0
    """What the file's values were multiplied by."""
    around: Clip | None = None
    """The clip of all that was read around the window; None where that is no more than the window."""
    inside: tuple[slice, slice] | None = None
    """Rows and columns of the window in it."""


@dataclass(frozen=True, eq=False)
class ComparedImage:
    """The bands (bands, rows, columns) of a clip."""

    bands: np.ndarray
    names: tuple[str, ...]
    coarse: dict[str, np.ndarray]
    """Means of squares of 2^R px, by band; luminance first where there is one."""
    curves: Mapping[str, Curve]
    raster: Raster
    offset: tuple[float, float] = (0.0, 0.0)
    """How its pixel grid lies beside the mosaic's, px."""
    valid: np.ndarray | None = None
    """(rows, columns) bool, where it has pixels; None: everywhere."""
    judged: np.ndarray | None = None
    """``plane``, where that was made before."""

    @cached_property
    def plane(self) -> np.ndarray:
        """What the verdict looks at, (rows, columns) float32."""
        return judged_plane(self.bands, self.names) if self.judged is None else self.judged

    @cached_property
    def spectra(self) -> Spectra:
        """Spectra of the plane, which is compared with those of several others."""
        return Spectra(self.plane)

    def with_bands(self, bands: np.ndarray, curves: Mapping[str, Curve], levels: int) -> ComparedImage:
        """Other bands on the same pixels."""
        coarse = _coarse(bands, self.names, levels)
        return replace(self, bands=bands, coarse=coarse, curves=curves, valid=None, judged=None)

    def tones_of(self, other: ComparedImage, where: np.ndarray) -> dict[str, Tone | None]:
        """What became of another image's grey values in this one, by band, fitted to the squares ``where``."""
        pixels: list[tuple[np.ndarray, Sequence[float]]] = [(band[np.newaxis], (1.0,)) for band in other.bands]
        if LUMINANCE in other.coarse:
            pixels.insert(0, (other.bands[:3], LUMINANCE_WEIGHTS))
        mosaic, source = (np.stack(list(image.coarse.values())) for image in (self, other))
        return dict(zip(self.coarse, fit_tones(mosaic, source, where, pixels)))


def on_common_bands(
    measured: Sequence[MeasuredClip], planes: Sequence[np.ndarray], levels: int
) -> Iterator[ComparedImage]:
    """The mosaic and its sources, reduced to the bands that all of them have; ``planes``: those that are judged."""
    names = _common_names(measured)
    for image, plane in zip(measured, planes):
        clip, bands = image.clip, _bands(image.clip, names)
        coarse = _coarse(bands, names, levels)
        yield ComparedImage(
            bands, names, coarse, image.curves, clip.raster, (clip.offset_x, clip.offset_y), clip.valid, plane
        )


def judged_planes(measured: Sequence[MeasuredClip]) -> Iterator[ComparedImage]:
    """The one plane of each that the verdict looks at, with the ground that was read around the window."""
    names = _common_names(measured)
    for image in measured:
        clip = image.around or image.clip
        plane = judged_plane(_bands(clip, names), names)
        yield ComparedImage(
            plane[np.newaxis], ("judged",), {}, {}, clip.raster, (clip.offset_x, clip.offset_y), clip.valid, plane
        )


def _common_names(measured: Sequence[MeasuredClip]) -> tuple[str, ...]:
    held = [names.clip.raster.band_names for names in measured]
    return tuple(name for name in held[0] if all(name in others for others in held))


def _bands(clip: Clip, names: Sequence[str]) -> np.ndarray:
    order = [clip.raster.band_names.index(name) for name in names]
    return clip.bands if order == list(range(len(clip.bands))) else clip.bands[order]


def _coarse(bands: np.ndarray, names: Sequence[str], levels: int) -> dict[str, np.ndarray]:
    coarse = {name: coarse_means(band, levels) for name, band in zip(names, bands)}
    if has_colours(names):
        weighted = sum(weight * coarse[name] for weight, name in zip(LUMINANCE_WEIGHTS, names))
        coarse = {LUMINANCE: np.asarray(weighted), **coarse}
    return coarse


@dataclass(frozen=True)
class Change:
    """Against one source, or against the composite, in one band."""

    tone: Tone | None
    """None where it can't be fitted."""
    contrast: tuple[float | None, ...]
    """Standard deviation of the mosaic's detail over the source's, levels 1..R; None where the source has none."""
    clipped: float
    """Share of pixels at the end of the mosaic's scale that were not at the source's."""
    colour_shift: float | None
    """Largest over smallest gain of the colours; None without colours."""
    shift: Shift | None
    """How the mosaic lies on the source on the ground, px; None where they show nothing in common."""

    @property
    def sharpness(self) -> tuple[float | None, ...]:
        """Contrast over gain, levels 1..R: 1 means that all detail came over at the gain."""
        gain = abs(self.tone.gain) if self.tone else 0.0
        return tuple(None if value is None or not gain else value / gain for value in self.contrast)


def measure_changes(
    mosaic: ComparedImage, other: ComparedImage, tones: Mapping[str, Tone | None], shift: Shift | None
) -> dict[str, Change]:
    """Changes by band, the judged one first. Of a source that covers the window only partly there is no contrast."""
    where = slice(None) if other.valid is None else (other.valid, np.newaxis)
    clipped = {name: clipped_share(a[where], b[where]) for name, a, b in zip(mosaic.names, mosaic.bands, other.bands)}
    clipped[LUMINANCE] = max(clipped.values())
    nothing = (None,) * len(next(iter(mosaic.curves.values())).detail)
    return {
        name: Change(
            tones[name],
            _contrast(mosaic.curves[name], other.curves[name]) if name in other.curves else nothing,
            clipped[name],
            gains_of_colours(tones),
            shift,
        )
        for name in mosaic.coarse
    }


def gains_of_colours(tones: Mapping[str, Tone | None]) -> float | None:
    """Largest over smallest gain of the colours; None without colours."""
    gains = [abs(tone.gain) for tone in (tones.get(name) for name in COLOURS) if tone is not None]
    return max(gains) / min(gains) if len(gains) == len(COLOURS) and min(gains) > 0 else None


def _contrast(mosaic: Curve, source: Curve) -> tuple[float | None, ...]:
    return tuple(
        float(np.sqrt(m * mosaic.variance / (s * source.variance))) if s > MIN_SHARE else None
        for m, s in zip(mosaic.detail, source.detail)
    )


USUAL_RANGE = (32.0, 70_000.0)
"""Between the outermost percentiles: values of less or more are brought to 8 bit, by a factor that is the same for
all that is delivered from 0 to 1."""
_SAMPLES, _SIDE_PX = 6, 128  # along each side of a raster, and of a sample: 600,000 pixels that span its values
_WIDEST = 1.5  # what goes for 0 to 1, as reflectance of snow and of glints is more
_ALIKE = 10.5  # times: factors that differ no more are of one scale, near to where the next one begins


def grey_factor(raster: Raster) -> float:
    """What the values of a raster are multiplied by; 1 for whole numbers and for values of a usual range."""
    return _sampled_factor(raster, file_stamp(raster.ref.path)) if raster.data_type.startswith("float") else 1.0


def read_grey_clip(
    source: OpenRaster, mosaic: Raster, window: PixelWindow, partly: bool = False
) -> tuple[Clip, float]:
    """A clip as ``read_clip`` has it, in values as those of 8 or 16 bit are, and by what they were multiplied.

    Raises RasterError.
    """
    clip = read_clip(source, mosaic, window, partly)
    factor = clip_factor(clip, mosaic)
    return (clip if factor == 1 else replace(clip, bands=clip.bands * clip.bands.dtype.type(factor))), factor


def clip_factor(clip: Clip, mosaic: Raster) -> float:
    """What the values of a clip are multiplied by: those of a source of the mosaic's scale as the mosaic's."""
    if clip.bands.dtype.kind != "f":
        return 1.0
    mosaic_factor, factor = grey_factor(mosaic), grey_factor(clip.raster)
    return mosaic_factor if mosaic_factor / _ALIKE < factor < mosaic_factor * _ALIKE else factor


@lru_cache(1024)
def _sampled_factor(raster: Raster, stamp: object) -> float:
    """``stamp``: of the file, as another one may be there under its name."""
    try:
        opened, whole = open_raster(raster.ref), PixelWindow(0, 0, raster.columns, raster.rows)
        blocks = map(opened.read, even_places(whole, _SIDE_PX, (_SAMPLES, _SAMPLES)))
        samples = [block.bands[:3, block.valid].ravel() for block in blocks]
    except RasterError:
        return 1.0  # the scan says so where it needs it
    return factor_of(np.concatenate(samples))


def factor_of(values: np.ndarray) -> float:
    """Factor as ``grey_factor`` has it, of some of the values themselves, in any shape."""
    if values.dtype.kind != "f" or not values.size:
        return 1.0
    low, high = np.percentile(values, (1, 99))
    least, most = USUAL_RANGE
    if least <= high - low <= most or high <= low:
        return 1.0
    return float(255 * 10.0 ** -math.ceil(math.log10((high - low) / _WIDEST)))
