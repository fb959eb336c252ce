"""A window that is being moved: what can be known of it many times a second, from the judged band alone."""
from __future__ import annotations

from dataclasses import dataclass, replace

from ....imagery.grids import PixelWindow
from ....imagery.raster_pool import ReadEach
from ..compared_image import judged_planes
from ..judgement.hard_cut import judged_ground
from ..profile.seam_profile import SeamProfile
from ..while_measuring import measuring
from .explained_window import known_labels
from .measured_window import MeasuredWindow, measure_window
from .window_request import WindowRequest
from .window_result import WindowClips


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


def read_live(request: WindowRequest, read_each: ReadEach) -> MeasuredWindow | None:
    """Read and measure the judged band of a window; None where the mosaic has no pixels there."""
    plain = replace(request, settings=replace(request.settings, directions=False))
    measured = measure_window(plain, read_each, judged_only=True)
    return measured if isinstance(measured, MeasuredWindow) else None


@measuring()
def live_profile(measured: MeasuredWindow) -> SeamProfile | None:
    """What is kept along the seam, as a whole inspection has it; None without a seam or where it can't be told."""
    if not measured.judged:
        return None
    image, *images = judged_planes((measured.mosaic, *measured.judged))
    settings, labels = measured.request.settings, known_labels(measured.request, measured.judged)
    ground = judged_ground(image, images, labels, measured.mosaic.inside)
    return None if ground.is_unclear else ground.detail(settings.wavelet, settings.levels).profile
