"""Which windows a noise check measures on which images: those that were drawn, or chosen on the images."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Callable

from ...imagery import limits as imagery_limits
from ...imagery import messages as imagery_messages
from ...imagery.clips import DrawnWindow, extent_on_image, shared_extent, shown_share
from ...imagery.errors import Message, RasterError, WindowError
from ...imagery.grids import Extent, PixelWindow, snap_window
from ...imagery.open_raster import OpenRaster, describe
from ...imagery.rasters import Raster, RasterRef
from . import messages
from .window_choice import NOISE_SHRINK, NOISE_WINDOW_PX, NOISE_WINDOWS, choose_windows


@dataclass(frozen=True)
class GroupedImage:
    """An image and the group that it belongs to."""

    image: Raster
    group: int
    """1 or 2."""
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
    """What windows are grouped by, as land use or scale; None where they are not, or this one has no value."""

    @property
    def paired(self) -> bool:
        """Whether both groups take part."""
        return len({part.member.group for part in self.parts}) > 1


@dataclass(frozen=True)
class Plan:
    """What will be measured."""

    requests: tuple[NoiseRequest, ...]
    notices: tuple[Message, ...]


def describe_images(
    refs: Iterable[RasterRef], group: int, group_name: str = ""
) -> tuple[list[GroupedImage], list[Message]]:
    """The images of a group, and notices about those that can't be opened."""
    images, notices = [], []
    for ref in dict.fromkeys(refs):
        try:
            images.append(GroupedImage(describe(ref), group, group_name))
        except RasterError as error:
            notices.append(imagery_messages.SOURCE_LEFT_OUT(name=ref.name, why=error.message))
    return images, notices


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


@dataclass(frozen=True)
class _Neighbours:
    """Images that share ground with one."""

    image: Raster
    """That one."""
    opened: tuple[tuple[GroupedImage, OpenRaster], ...]
    levels: int

    def parts(self, window: PixelWindow) -> tuple[Part, ...]:
        """Where they show all of a window of the image."""
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
    first, second = ([one for one in images if one.group == group] for group in (1, 2))
    matched: set[int] = set()
    taken: dict[int, list[PixelWindow]] = {id(one): [] for one in images}
    for index, one in enumerate(all_images := [*first, *second]):
        if cancelled():
            break
        if one.group == 2 and id(one) in matched:
            continue
        later = [other for other in all_images[index + 1 :] if _overlap(one.image, other.image)]
        partners = [other for other in later if other.group != one.group]
        peers = [other for other in later if other.group == one.group]
        for parts in _chosen(one, _opened(one, partners, levels), _opened(one, peers, levels), taken[id(one)], notices):
            requests.append(NoiseRequest(len(requests) + 1, parts))
            matched.update(id(part.member) for part in parts if part.member.group != one.group)
            for part in parts:
                taken[id(part.member)].append(part.window)
    if first and second and not any(request.paired for request in requests):
        notices.append(messages.GROUPS_APART())
    return Plan(tuple(requests), tuple(notices))


def _opened(one: GroupedImage, others: Sequence[GroupedImage], levels: int) -> _Neighbours:
    return _Neighbours(one.image, tuple((other, OpenRaster(other.image.ref)) for other in others), levels)


def _chosen(
    one: GroupedImage, partners: _Neighbours, peers: _Neighbours, taken: list[PixelWindow], notices: list[Message]
) -> list[tuple[Part, ...]]:
    """The windows of an image, each with the partners (of the other group) and the peers (of its own) that show it.

    ``taken``: its windows by the choice of another image, which no new one may touch.
    """
    name, levels = one.image.ref.name, partners.levels
    try:
        found = [
            (Part(one, window), *partners.parts(window), *peers.parts(window))
            for window in _free_windows(one.image, partners, taken)
        ]
    except RasterError as error:
        notices.append(imagery_messages.SOURCE_LEFT_OUT(name=name, why=error.message))
        return []
    found.sort(key=lambda parts: (parts[0].window.row, parts[0].window.column))  # as a file is read best
    if taken:
        return found
    if not found:
        fewest = max(imagery_limits.MIN_SIDE_PX, 2**levels)
        notices.append(messages.RASTER_WITHOUT_WINDOW(name=name, fewest=fewest))
    elif found[0][0].window.width < NOISE_WINDOW_PX:
        side, wanted = found[0][0].window.width, NOISE_WINDOW_PX
        notices.append(messages.WINDOWS_SMALLER(name=name, wanted=wanted, side=side))
    return found


def _free_windows(image: Raster, partners: _Neighbours, taken: list[PixelWindow]) -> list[PixelWindow]:
    """Those that are chosen beside what is taken, if they can be on ground that partners show as well."""
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
    if extent is None or shown_share(other.grid, extent) < 1 - imagery_limits.MAX_INVALID_SHARE:
        return None
    try:
        return snap_window(other.grid, extent, levels)
    except WindowError:
        return None


def _is_valid(source: OpenRaster, window: PixelWindow) -> bool:
    invalid = source.thinned(window, min(NOISE_SHRINK, min(window.width, window.height) // 16))[1]
    return invalid is None or not invalid.any()
