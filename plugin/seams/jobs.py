"""The jobs of the seam inspection, as generators of plain data: windows, seams, placing, pictures."""
from __future__ import annotations

import os
from collections.abc import Collection, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor

from ..imagery.lines import find_seams
from ..imagery.open_raster import OpenRaster
from ..imagery.rasters import Raster, RasterRef
from ..toolkit.background_tasks import Ahead, Cancelled, Job
from .clip_pictures import PictureRequest, WindowPictureSet, composite_picture, make_pictures
from .measure.inputs.candidate_look import SourceCandidate, look_at_candidates
from .measure.inspection import inspect_one, inspect_windows
from .measure.nearest_seam import SeamIndex
from .measure.window.explained_window import WindowComposite, window_composite
from .measure.window.measured_window import MeasureWindow, measure_window
from .measure.window.window_request import InspectionSettings, WindowRequest
from .measure.window.window_result import WindowClips
from .measure.window_placing import place_windows


def inspection_job(requests: Iterable[WindowRequest], count: int, measure: MeasureWindow = measure_window) -> Job:
    """Inspects ``count`` windows; yields a WindowResult each, in their order.

    Of a single window, for which somebody waits, the WindowClips come ahead, and ``measure`` may be faster.
    """

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        if count == 1:
            for found in inspect_one(next(iter(requests)), measure):
                yield (0.0, Ahead(found)) if isinstance(found, WindowClips) else (1.0, found)
                if cancelled():
                    return
            return
        # One core is left to the interface.
        workers = max(1, (os.cpu_count() or 1) - 1)
        with ThreadPoolExecutor(workers, thread_name_prefix="seam-inspector") as executor:
            results = inspect_windows(requests, executor, 2 * workers, cancelled)
            for done, result in enumerate(results, 1):
                yield done / count, result

    return job


def seams_job(lines: Iterable[bytes | None], pixel_size: float) -> Job:
    """Finds the seams of a layer of lines or polygons; yields the SeamIndex of them."""
    return lambda _cancelled: iter([(1.0, SeamIndex(find_seams(lines, pixel_size)))])


def placing_job(
    lines: Iterable[bytes | None], mosaic: Raster, side_m: float, spacing_m: float, settings: InspectionSettings
) -> Job:
    """Places windows along the seams of a layer; yields the Placement."""

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        source = OpenRaster(mosaic.ref)
        seams = find_seams(lines, mosaic.grid.pixel_width)
        placement = place_windows(
            seams, mosaic.grid, side_m, spacing_m, settings.levels,
            lambda window: not cancelled() and source.is_valid(window),
        )
        if not cancelled():
            yield 1.0, placement

    return job


def pictures_job(request: PictureRequest) -> Job:
    """Reads the clips of one window as pictures; yields the WindowPictureSet of them."""
    return lambda cancelled: iter([(1.0, make_pictures(request, cancelled))])


def candidates_job(mosaic: RasterRef, candidates: Sequence[SourceCandidate], known: Collection[str]) -> Job:
    """Looks at rasters that may be sources; yields the key and the Suitability of each."""

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        for done, found in enumerate(look_at_candidates(mosaic, candidates, known, cancelled), 1):
            yield done / len(candidates), found

    return job


def composite_picture_job(request: WindowRequest, shown: WindowPictureSet) -> Job:
    """The picture of a window's hard-cut composite, to be seen beside those that are shown of it; yields a
    WindowPictureSet with it alone, or with nothing where there is none."""

    def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        mosaic = shown.pictures[0]
        found = window_composite(request) if mosaic.is_mosaic else None
        made = (composite_picture(found, mosaic, shown.used),) if isinstance(found, WindowComposite) else ()
        yield 1.0, WindowPictureSet(made, shown.ranges, shown.used)

    return job
