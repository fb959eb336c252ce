"""A clip as it is compared with others: reduced to the bands that all have, with what is looked at more than once."""
from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ...imagery import limits as imagery_limits
from ...imagery.clips import Clip
from ...imagery.limits import LUMINANCE, has_colours
from ...imagery.rasters import Raster
from ...imagery.shifts import Spectra
from ...imagery.wavelets import Curve, judged_plane
from .tone import Tone, coarse_means, fit_tones


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

    @cached_property
    def plane(self) -> np.ndarray:
        """What the verdict looks at, (rows, columns) float32."""
        return judged_plane(self.bands, self.names)

    @cached_property
    def spectra(self) -> Spectra:
        """Of the plane, which is compared with those of several others."""
        return Spectra(self.plane)

    def with_bands(self, bands: np.ndarray, curves: Mapping[str, Curve], levels: int) -> ComparedImage:
        """Other bands on the same pixels."""
        return replace(self, bands=bands, coarse=_coarse(bands, self.names, levels), curves=curves, valid=None)

    def tones_of(self, other: ComparedImage, where: np.ndarray) -> dict[str, Tone | None]:
        """What became of another image's grey values in this one, by band, fitted to the squares ``where``."""
        pixels: list[tuple[np.ndarray, Sequence[float]]] = [(band[np.newaxis], (1.0,)) for band in other.bands]
        if LUMINANCE in other.coarse:
            pixels.insert(0, (other.bands[:3], imagery_limits.LUMINANCE_WEIGHTS))
        mosaic, source = (np.stack(list(one.coarse.values())) for one in (self, other))
        return dict(zip(self.coarse, fit_tones(mosaic, source, where, pixels)))


def on_common_bands(measured: Sequence[MeasuredClip], levels: int) -> Iterator[ComparedImage]:
    """The mosaic and its sources, reduced to the bands that all of them have."""
    names = _common_names(measured)
    for one in measured:
        clip, bands = one.clip, _bands(one.clip, names)
        coarse = _coarse(bands, names, levels)
        yield ComparedImage(
            bands, names, coarse, one.curves, clip.raster, (clip.offset_x, clip.offset_y), clip.valid
        )


def judged_planes(measured: Sequence[MeasuredClip]) -> Iterator[ComparedImage]:
    """The one plane of each that the verdict looks at, with the ground that was read around the window."""
    names = _common_names(measured)
    for one in measured:
        clip = one.around or one.clip
        plane = judged_plane(_bands(clip, names), names)
        yield ComparedImage(
            plane[np.newaxis], ("judged",), {}, {}, clip.raster, (clip.offset_x, clip.offset_y), clip.valid
        )


def _common_names(measured: Sequence[MeasuredClip]) -> tuple[str, ...]:
    held = [one.clip.raster.band_names for one in measured]
    return tuple(name for name in held[0] if all(name in others for others in held))


def _bands(clip: Clip, names: Sequence[str]) -> np.ndarray:
    order = [clip.raster.band_names.index(name) for name in names]
    return clip.bands if order == list(range(len(clip.bands))) else clip.bands[order]


def _coarse(bands: np.ndarray, names: Sequence[str], levels: int) -> dict[str, np.ndarray]:
    coarse = {name: coarse_means(band, levels) for name, band in zip(names, bands)}
    if has_colours(names):
        weighted = sum(weight * coarse[name] for weight, name in zip(imagery_limits.LUMINANCE_WEIGHTS, names))
        coarse = {LUMINANCE: np.asarray(weighted), **coarse}
    return coarse
