"""Windows of a noise check that are chosen on the images, and on which images each is measured."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Callable

from ...imagery import limits as imagery_limits
from ...imagery import messages as imagery_messages
from ...imagery.clips import extent_on_image, shared_extent, shown_share
from ...imagery.errors import Message, RasterError, WindowError
from ...imagery.grids import PixelWindow, snap_window
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster
from . import messages
from .noise_requests import GroupedImage, NoiseRequest, Part, Plan
from .window_choice import NOISE_SHRINK, NOISE_WINDOW_PX, NOISE_WINDOWS, choose_windows


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
