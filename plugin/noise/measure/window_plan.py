"""Which drawn windows of a noise check are measured on which images."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from ...imagery import limits as imagery_limits
from ...imagery import messages as imagery_messages
from ...imagery.clips import DrawnWindow, extent_on_image, shared_extent, shown_share
from ...imagery.errors import Message, WindowError
from ...imagery.grids import Extent, snap_window
from . import messages
from .noise_requests import GroupedImage, NoiseRequest, Part, Plan

MIN_PAIRED_SHARE = 0.5  # of a window: a raster that shows less of it takes no part there


def plan_drawn(
    images: Sequence[GroupedImage], windows: Iterable[DrawnWindow], levels: int,
    classes: Mapping[int, str | None] | None = None,
) -> Plan:
    """Requests for drawn windows: each on all images under it. ``classes``: what windows are grouped by, by their id.

    An image that shows less than half of a window takes no part in it, unless no image shows more. Where both
    groups take part the window is cut to what all of them show.
    """
    requests: list[NoiseRequest] = []
    notices = [
        imagery_messages.WINDOW_IMAGE_ROTATED(name=one.image.ref.name).as_warning()
        for one in images
        if not one.image.is_north_up
    ]
    for drawn in windows:
        shown = [
            (one, extent, share)
            for one in images
            if one.image.is_north_up
            for extent in (extent_on_image(drawn.extent, drawn.wkt, one.image),)
            if extent is not None and (share := shown_share(one.image.grid, extent)) > 0
        ]
        mostly = [entry for entry in shown if entry[2] >= MIN_PAIRED_SHARE]
        taken = [(one, extent) for one, extent, _ in mostly or shown]
        if not taken:
            notices.append(imagery_messages.WINDOW_ON_NO_RASTER(window=drawn.window_id))
            continue
        if len({one.group for one, _ in taken}) > 1:
            bounds = _common(taken, drawn)
            requests += _requests(drawn.window_id, [(one, bounds[i]) for i, (one, _) in enumerate(taken)], levels,
                                  notices)
        else:
            for one in taken:
                requests += _requests(drawn.window_id, [one], levels, notices)
    if classes:
        requests = [replace(request, window_class=classes.get(request.window_id)) for request in requests]
    return Plan(tuple(requests), tuple(notices))


def pixel_size_notice(plan: Plan) -> Message | None:
    """That pixel sizes differ between the groups of a paired window, or None."""
    for request in plan.requests:
        sizes = {part.member.group: part.member.ground_sample_distance for part in reversed(request.parts)}
        if request.paired and sizes[1] and sizes[2]:
            ratio = sizes[1] / sizes[2]
            if abs(ratio - 1) > imagery_limits.MAX_PIXEL_SIZE_DIFFERENCE:
                return messages.PIXEL_SIZES_DIFFER(first=f"{sizes[1]:.3g} m", second=f"{sizes[2]:.3g} m")
    return None


def _requests(
    window_id: int, taken: list[tuple[GroupedImage, Extent]], levels: int, notices: list[Message]
) -> list[NoiseRequest]:
    """One request for the images, or none where the window can't be laid on their pixels."""
    parts = []
    for one, extent in taken:
        try:
            parts.append(Part(one, snap_window(one.image.grid, extent, levels)))
        except WindowError as error:
            name = one.image.ref.name
            notices.append(imagery_messages.WINDOW_LEFT_OUT(window=window_id, name=name, why=error.message))
    return [NoiseRequest(window_id, tuple(parts))] if parts else []


def _common(taken: list[tuple[GroupedImage, Extent]], drawn: DrawnWindow) -> list[Extent]:
    """What all images show of a window, in the reference system of each."""
    left, bottom, right, top = 0.0, 0.0, 1.0, 1.0  # as shares of the window: its sides are parallel on all images
    for one, extent in taken:
        shared = shared_extent(one.image.grid.extent, extent)
        assert shared is not None
        width, height = extent[2] - extent[0], extent[3] - extent[1]
        left, right = max(left, (shared[0] - extent[0]) / width), min(right, (shared[2] - extent[0]) / width)
        bottom, top = max(bottom, (shared[1] - extent[1]) / height), min(top, (shared[3] - extent[1]) / height)
    return [
        (x0 + left * (x1 - x0), y0 + bottom * (y1 - y0), x0 + right * (x1 - x0), y0 + top * (y1 - y0))
        for _, (x0, y0, x1, y1) in taken
    ]
