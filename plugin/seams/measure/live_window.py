"""A window that is being moved: what can be known of it many times a second, from the judged band alone."""
from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from ...imagery.clips import Clip
from ...imagery.errors import RasterError
from ...imagery.grids import PixelWindow
from ...imagery.open_raster import OpenRaster
from ...imagery.raster_pool import ReadEach
from ...imagery.wavelets import Curve, clip_curves, judged_plane
from .compared_image import ComparedImage, MeasuredClip
from .hard_cut import judged_ground
from .profile.seam_profile import SeamProfile
from .verdicts import judge
from .while_measuring import measuring
from .window.explained_window import known_labels
from .window.window_request import WindowRequest, place_in, read_with_surroundings
from .window.window_result import ClipResult, WindowClips


@dataclass(frozen=True, eq=False)
class LivePixels:
    """The judged band of the rasters in a window, and its curves."""

    request: WindowRequest
    band: str
    images: tuple[ComparedImage, ...]
    """The mosaic, then the sources that the verdict would be taken against."""
    judged: tuple[MeasuredClip, ...]
    """Those sources; their curves are among the ``clips``."""
    clips: WindowClips


@dataclass(frozen=True)
class LiveWindow:
    """What is known of the window that is being moved."""

    window: PixelWindow
    clips: WindowClips
    """With the curves of the judged band alone."""
    ground_sample_distance: float
    """The mosaic's pixel size, m."""
    profile: SeamProfile | None = None
    """What is kept along the seam, a moment ago: it takes longer than the curves."""


def read_live(request: WindowRequest, read_each: ReadEach) -> LivePixels | None:
    """Read and measure the judged band of a window; None where the mosaic has no pixels there."""
    if request.window is None:
        return None
    band = request.mosaic.judged_band
    refs = [request.mosaic.ref, *(source.ref for source in request.sources)]
    found = read_each([(ref, partial(_read, request, band, is_source)) for is_source, ref in enumerate(refs)])
    if isinstance(found[0], RasterError) or found[0] is None:
        return None
    mosaic, *sources = [one for one in found if one is not None and not isinstance(one, RasterError)]
    judged = [one for one in sources if not one[0].resampled] or sources
    named = [(mosaic, "mosaic"), *((one, "source") for one in sources)]
    clips = tuple(
        ClipResult(clip.raster.ref.name, role, {band: curve}) for (clip, _, curve), role in named if curve is not None
    )
    assert mosaic[2] is not None
    whole = [curve for _, _, curve in judged if curve is not None]
    paper = judge(mosaic[2], whole, request.settings.max_ratio)
    images = tuple(image for _, image, _ in (mosaic, *judged))
    first = WindowClips(request.window_id, request.window, clips, paper, bool(judged))
    against = tuple(MeasuredClip(clip, {}, {}) for clip, _, _ in judged)
    return LivePixels(request, band, images, against, first)


@measuring()
def live_profile(pixels: LivePixels) -> SeamProfile | None:
    """What is kept along the seam, as a whole inspection has it; None without a seam or where it can't be told."""
    window = pixels.request.window
    if not pixels.judged or window is None:
        return None
    image, *images = pixels.images
    settings = pixels.request.settings
    inside = place_in(window, pixels.request.around)
    ground = judged_ground(image, images, known_labels(pixels.request, pixels.judged), inside)
    return None if ground.is_unclear else ground.detail(settings.wavelet, settings.levels).profile


_Read = tuple[Clip, ComparedImage, "Curve | None"]


def _read(request: WindowRequest, band: str, is_source: int, raster: OpenRaster) -> _Read | None:
    """Clip, plane and curve; no curve of a source that covers the window only partly, None of one without the band."""
    assert request.window is not None
    if raster.raster.judged_band != band:
        return None
    window, around = request.window, request.around
    clip, wide, _ = read_with_surroundings(raster, request.mosaic, window, around, partly=bool(is_source))
    image = ComparedImage(
        judged_plane(wide.bands, wide.raster.band_names)[np.newaxis], (band,), {}, {}, wide.raster,
        (wide.offset_x, wide.offset_y), wide.valid,
    )
    if clip.valid is not None:
        return clip, image, None
    is_part = wide.invalid_share == 0 and wide is not clip
    plane = image.plane[place_in(window, around)] if is_part else judged_plane(clip.bands, clip.raster.band_names)
    (curve,), _ = clip_curves(plane[np.newaxis], request.settings.wavelet, request.settings.levels)
    return None if is_source and curve.variance == 0 else (clip, image, curve)
