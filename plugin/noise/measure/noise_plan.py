"""The windows that a noise check measures, and on which images: they were drawn, or are chosen on the images."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Callable

import numpy as np

from ...imagery import limits as imagery_limits
from ...imagery import messages as imagery_messages
from ...imagery.clips import DrawnWindow, extent_on_image
from ...imagery.errors import Message, RasterError, WindowError
from ...imagery.grids import Extent, PixelWindow, covered_share, shared_extent, snap_window
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster
from . import messages
from .window_choice import NOISE_SHRINK, NOISE_WINDOW_PX, NOISE_WINDOWS, choose_windows


@dataclass(frozen=True)
class GroupedImage:
    """An image and the group that it belongs to."""

    image: Raster
    group: int  # 1 or 2
    group_name: str = ""

    @property
    def ground_sample_distance(self) -> float | None:
        """Metres on the ground per pixel, the shorter side; None when the image has no place on the map."""
        return self.image.ground_sample_distance if self.image.has_place else None


@dataclass(frozen=True)
class Part:
    """One image in a window."""

    member: GroupedImage
    window: PixelWindow


@dataclass(frozen=True)
class NoiseRequest:
    """One window and the images that are measured in it. With both groups among them, their masks are joined."""

    window_id: int
    parts: tuple[Part, ...]
    window_class: str | None = None
    """The value that windows are grouped by, as land use; None where they are not, or this one has no value."""

    @property
    def paired(self) -> bool:
        """Whether both groups take part."""
        return len({part.member.group for part in self.parts}) > 1


@dataclass(frozen=True)
class Plan:
    """The measurements to be made."""

    requests: tuple[NoiseRequest, ...]
    notices: tuple[Message, ...]


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
        imagery_messages.NOT_NORTH_UP(name=member.image.ref.name).as_warning()
        for member in images
        if not member.image.is_north_up
    ]
    for drawn in windows:
        shown = [
            (member, extent, share)
            for member in images
            if member.image.is_north_up
            for extent in (extent_on_image(drawn.extent, drawn.wkt, member.image),)
            if extent is not None and (share := covered_share(extent, member.image.grid.extent)) > 0
        ]
        mostly = [entry for entry in shown if entry[2] >= MIN_PAIRED_SHARE]
        taken = [(member, extent) for member, extent, _ in mostly or shown]
        if not taken:
            notices.append(imagery_messages.WINDOW_ON_NO_RASTER(window=drawn.window_id))
            continue
        if len({member.group for member, _ in taken}) > 1:
            bounds = _common(taken)
            members = [member for member, _ in taken]
            requests += _requests(drawn.window_id, list(zip(members, bounds)), levels, notices)
        else:
            for placed in taken:
                requests += _requests(drawn.window_id, [placed], levels, notices)
    classes = classes or {}
    requests = [replace(request, window_class=classes.get(request.window_id)) for request in requests]
    return Plan(tuple(requests), tuple(notices))


def pixel_size_notice(plan: Plan) -> Message | None:
    """A warning of pixel sizes that differ between the groups of a paired window, or None."""
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
    for member, extent in taken:
        try:
            parts.append(Part(member, snap_window(member.image.grid, extent, levels)))
        except WindowError as error:
            name = member.image.ref.name
            notices.append(imagery_messages.WINDOW_LEFT_OUT(window=window_id, name=name, why=error.message))
    return [NoiseRequest(window_id, tuple(parts))] if parts else []


def _common(taken: list[tuple[GroupedImage, Extent]]) -> list[Extent]:
    """The part of a window that all images show, in the reference system of each."""
    corners, shared = (
        np.array(extents, dtype=np.float64).reshape(-1, 2, 2)
        for extents in zip(*((extent, shared_extent(member.image.grid.extent, extent)) for member, extent in taken))
    )
    origins, sizes = corners[:, :1], corners[:, 1:] - corners[:, :1]
    shares = (shared - origins) / sizes  # of the window, whose sides are parallel on all images
    ends = np.stack([shares[:, 0].max(axis=0), shares[:, 1].min(axis=0)])
    return [(x0, y0, x1, y1) for x0, y0, x1, y1 in (origins + ends * sizes).reshape(-1, 4).tolist()]


@dataclass(frozen=True)
class _Neighbours:
    """Images that share ground with an image."""

    image: Raster
    opened: tuple[tuple[GroupedImage, OpenRaster], ...]
    levels: int

    def parts(self, window: PixelWindow) -> tuple[Part, ...]:
        """The places of a window of the image on those that show all of it."""
        parts = []
        for neighbour, source in self.opened:
            there = _window_on(self.image, window, neighbour.image, self.levels)
            if there is not None and _is_valid(source, there):
                parts.append(Part(neighbour, there))
        return tuple(parts)


def plan_chosen(images: Sequence[GroupedImage], levels: int, cancelled: Callable[[], bool] = lambda: False) -> Plan:
    """Requests for windows that are chosen on the images, up to 25 on each.

    An image of group 1 that shares ground with images of group 2 gets windows where those are valid too, and they
    are measured there as well; all others get windows of their own. Ground that several images of a group show is
    chosen once: its window is measured on all of them. Windows are numbered through.
    """
    requests: list[NoiseRequest] = []
    notices: list[Message] = []
    first, second = ([member for member in images if member.group == group] for group in (1, 2))
    matched: set[int] = set()
    taken: dict[int, list[PixelWindow]] = {id(member): [] for member in images}
    for index, member in enumerate(all_images := [*first, *second]):
        if cancelled():
            break
        if member.group == 2 and id(member) in matched:
            continue
        later = [other for other in all_images[index + 1 :] if _overlap(member.image, other.image)]
        partners = [other for other in later if other.group != member.group]
        peers = [other for other in later if other.group == member.group]
        around = _opened(member, partners, levels), _opened(member, peers, levels)
        for parts in _chosen(member, *around, taken[id(member)], notices):
            requests.append(NoiseRequest(len(requests) + 1, parts))
            matched.update(id(part.member) for part in parts if part.member.group != member.group)
            for part in parts:
                taken[id(part.member)].append(part.window)
    if first and second and not any(request.paired for request in requests):
        notices.append(messages.GROUPS_APART())
    return Plan(tuple(requests), tuple(notices))


def _opened(member: GroupedImage, others: Sequence[GroupedImage], levels: int) -> _Neighbours:
    return _Neighbours(member.image, tuple((other, OpenRaster(other.image.ref)) for other in others), levels)


def _chosen(
    member: GroupedImage, partners: _Neighbours, peers: _Neighbours, taken: list[PixelWindow], notices: list[Message]
) -> list[tuple[Part, ...]]:
    """The windows of an image, each with the partners (of the other group) and the peers (of its own) that show it.

    ``taken``: its windows by the choice of another image, which no new one may touch.
    """
    name, levels = member.image.ref.name, partners.levels
    try:
        windows = [
            (Part(member, window), *partners.parts(window), *peers.parts(window))
            for window in _free_windows(member.image, partners, taken)
        ]
    except RasterError as error:
        notices.append(imagery_messages.SOURCE_LEFT_OUT(name=name, why=error.message))
        return []
    windows.sort(key=lambda parts: (parts[0].window.row, parts[0].window.column))  # as a file is read best
    if taken:
        return windows
    if not windows:
        fewest = max(imagery_limits.MIN_SIDE_PX, 2**levels)
        notices.append(messages.RASTER_WITHOUT_WINDOW(name=name, fewest=fewest))
    elif windows[0][0].window.width < NOISE_WINDOW_PX:
        side, wanted = windows[0][0].window.width, NOISE_WINDOW_PX
        notices.append(messages.WINDOWS_SMALLER(name=name, wanted=wanted, side=side))
    return windows


def _free_windows(image: Raster, partners: _Neighbours, taken: list[PixelWindow]) -> list[PixelWindow]:
    """The windows that are chosen beside those taken, if they can be on ground that partners show as well."""
    if len(taken) >= NOISE_WINDOWS:
        return []
    source = OpenRaster(image.ref)

    def is_free(window: PixelWindow) -> bool:
        return not any(window.shared_pixels(other) for other in taken)

    windows: list[PixelWindow] = []
    if partners.opened:
        region = _shared_region(image, [partner.image for partner, _ in partners.opened])
        windows = choose_windows(
            source, partners.levels, region, lambda window: is_free(window) and bool(partners.parts(window))
        )
    windows = windows or choose_windows(source, partners.levels, allowed=is_free)
    if taken:  # a gap between them is no reason for smaller ones
        windows = [window for window in windows if window.width >= taken[0].width]
    return windows[: NOISE_WINDOWS - len(taken)]


def _overlap(a: Raster, b: Raster) -> bool:
    """Whether two images share ground, as far as their footprints tell."""
    if not all(image.is_north_up and image.has_place and image.wkt for image in (a, b)):
        return False
    extent = extent_on_image(b.grid.extent, b.wkt, a)
    return extent is not None and shared_extent(a.grid.extent, extent) is not None


def _shared_region(image: Raster, others: Sequence[Raster]) -> PixelWindow:
    """The pixels of an image around all that other images share with it, as far as their footprints tell."""
    shared = []
    for other in others:
        extent = extent_on_image(other.grid.extent, other.wkt, image)
        box = None if extent is None else shared_extent(image.grid.extent, extent)
        shared += [] if box is None else [box]
    xmin, ymin = (min(box[i] for box in shared) for i in (0, 1))
    xmax, ymax = (max(box[i] for box in shared) for i in (2, 3))
    left, right = (round(image.grid.column_at(x)) for x in (xmin, xmax))
    top, bottom = (round(image.grid.row_at(y)) for y in (ymax, ymin))
    return PixelWindow(left, top, max(right - left, 1), max(bottom - top, 1))


def _window_on(image: Raster, window: PixelWindow, other: Raster, levels: int) -> PixelWindow | None:
    """The pixels of another image that show a window; None when it does not show all of it."""
    extent = extent_on_image(image.grid.window_extent(window), image.wkt, other)
    if extent is None or covered_share(extent, other.grid.extent) < 1 - imagery_limits.MAX_INVALID_SHARE:
        return None
    try:
        return snap_window(other.grid, extent, levels)
    except WindowError:
        return None


def _is_valid(source: OpenRaster, window: PixelWindow) -> bool:
    invalid = source.thinned(window, min(NOISE_SHRINK, min(window.width, window.height) // 16))[1]
    return invalid is None or not invalid.any()
