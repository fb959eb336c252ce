"""The job that measures the noise of one window on one raster in the background."""
from __future__ import annotations

from collections.abc import Iterator

from ..core import messages
from ..core.drawn_windows import DrawnWindow, pixels_under
from ..core.errors import SeamInspectorError
from ..core.messages import Message
from ..core.noise.comparison import ClipNoise, measure_window
from ..core.pixels import Pixels
from ..core.rasters import RasterRef
from ..core.thresholds import DEFAULT_LEVELS
from .tasks import Cancelled, Job


def noise_job(ref: RasterRef, drawn: DrawnWindow) -> Job:
    """Measures a window on the raster's own pixels, as the noise check does; yields the ClipNoise, or the Message why
    there is none."""

    def measured() -> ClipNoise | Message:
        try:
            window = pixels_under(drawn, Pixels(ref).image(), DEFAULT_LEVELS)
            return messages.NOT_COVERED(name=ref.name) if window is None else measure_window(ref, window)
        except SeamInspectorError as error:
            return error.message

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        if not cancelled():
            yield 1.0, measured()

    return job
