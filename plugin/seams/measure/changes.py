"""What became of a source's grey values in the mosaic, band by band."""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ...imagery import limits as imagery_limits
from ...imagery.limits import COLOURS, LUMINANCE
from ...imagery.shifts import Shift
from ...imagery.wavelets import Curve
from .compared_image import ComparedImage
from .tone import Tone, clipped_share, colour_shift


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
    """By band, the judged one first. Of a source that covers the window only partly there is no contrast."""
    clipped = {name: _clipped(mosaic, other, band) for band, name in enumerate(mosaic.names)}
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
    gains = [tone.gain for tone in (tones.get(name) for name in COLOURS) if tone is not None]
    return colour_shift(gains) if len(gains) == len(COLOURS) else None


def _clipped(mosaic: ComparedImage, other: ComparedImage, band: int) -> float:
    if other.valid is None:
        return clipped_share(mosaic.bands[band], other.bands[band])
    valid = other.valid
    return clipped_share(mosaic.bands[band][valid][np.newaxis], other.bands[band][valid][np.newaxis])


def _contrast(mosaic: Curve, source: Curve) -> tuple[float | None, ...]:
    return tuple(
        float(np.sqrt(m * mosaic.variance / (s * source.variance))) if s > imagery_limits.MIN_SHARE else None
        for m, s in zip(mosaic.detail, source.detail)
    )
