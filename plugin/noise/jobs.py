"""The job that measures the noise of one window on one raster in the background."""
from __future__ import annotations

from collections.abc import Iterator

from ..imagery import messages as imagery_messages
from ..imagery.clips import DrawnWindow, pixels_under
from ..imagery.errors import Message, SeamInspectorError
from ..imagery.limits import DEFAULT_LEVELS
from ..imagery.open_raster import describe
from ..imagery.rasters import RasterRef
from ..toolkit.background_task import Cancelled, Job
from .measure.group_noise import ClipNoise, measure_window


def noise_job(ref: RasterRef, drawn: DrawnWindow) -> Job:
    """Measures a window on the raster's own pixels, as the noise check does; yields the ClipNoise, or the Message why
    there is none."""

    def measured() -> ClipNoise | Message:
        try:
            window = pixels_under(drawn, describe(ref), DEFAULT_LEVELS)
            return imagery_messages.NOT_COVERED(name=ref.name) if window is None else measure_window(ref, window)
        except SeamInspectorError as error:
            return error.message

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        if not cancelled():
            yield 1.0, measured()

    return job
