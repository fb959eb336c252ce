"""Noise of many images in one group or two: which windows, on which images, with which pixels left out."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from itertools import islice
from typing import Callable

import numpy as np

from .. import messages, thresholds
from ..errors import RasterError, WindowError
from ..messages import Message
from ..rasters import Image, Pixels, RasterRef
from ..systems import extent_on
from ..windows import Extent, Grid, PixelWindow, snap_window
from .choice import choose_windows
from .filling import filled
from .measurement import BandNoise, measure_noise

_Clip = tuple[np.ndarray, np.ndarray]
"""(bands, rows, columns) and where they are invalid, (rows, columns)."""


@dataclass(frozen=True)
class GroupedImage:
    """An image and the group that it belongs to."""

    image: Image
    group: int
    """1 or 2."""


@dataclass(frozen=True)
class DrawnWindow:
    """A rectangle to be measured on every image under it."""

    window_id: int
    extent: Extent
    """In ``wkt``."""
    wkt: str
    """Reference system; empty when unknown, and then the images' own is assumed."""


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

    @property
    def paired(self) -> bool:
        """Whether both groups take part."""
        return len({part.member.group for part in self.parts}) > 1


@dataclass(frozen=True)
class ClipNoise:
    """What was measured on one image in one window."""

    window_id: int
    part: Part
    paired: bool
    """Whether the window was measured on both groups, with the same pixels left out."""
    bands: dict[str, BandNoise]
    """By band name, luminance first where there is one; empty when nothing could be measured."""
    reason: Message | None = None
    """Why nothing could be measured."""


@dataclass(frozen=True)
class Plan:
    """What will be measured."""

    requests: tuple[NoiseRequest, ...]
    notices: tuple[Message, ...]


def describe_images(refs: Iterable[RasterRef], group: int) -> tuple[list[GroupedImage], list[Message]]:
    """The images of a group, and notices about those that can't be opened."""
    images, notices = [], []
    for ref in dict.fromkeys(refs):
        try:
            images.append(GroupedImage(Pixels(ref).image(), group))
        except RasterError as error:
            notices.append(messages.SOURCE_LEFT_OUT(name=ref.name, why=error.message))
    return images, notices


def plan_drawn(images: Sequence[GroupedImage], windows: Iterable[DrawnWindow], levels: int) -> Plan:
    """Requests for drawn windows: each on all images under it.

    An image that shows less than half of a window takes no part in it, unless no image shows more. Where both
    groups take part the window is cut to what all of them show.
    """
    requests: list[NoiseRequest] = []
    notices = [
        messages.WINDOW_IMAGE_ROTATED(name=one.image.ref.name) for one in images if one.image.grid is None
    ]
    for drawn in windows:
        shown = [
            (one, extent, share)
            for one in images
            if one.image.grid is not None
            for extent in (_extent_on_image(drawn.extent, drawn.wkt, one.image),)
            if extent is not None and (share := _shown_share(one.image.grid, extent)) > 0
        ]
        mostly = [entry for entry in shown if entry[2] >= thresholds.MIN_PAIRED_SHARE]
        taken = [(one, extent) for one, extent, _ in mostly or shown]
        if not taken:
            notices.append(messages.WINDOW_ON_NO_RASTER(window=drawn.window_id))
            continue
        if len({one.group for one, _ in taken}) > 1:
            bounds = _common(taken, drawn)
            requests += _requests(drawn.window_id, [(one, bounds[i]) for i, (one, _) in enumerate(taken)], levels,
                                  notices)
        else:
            for one in taken:
                requests += _requests(drawn.window_id, [one], levels, notices)
    return Plan(tuple(requests), tuple(notices))


def plan_chosen(
    images: Sequence[GroupedImage], levels: int, cancelled: Callable[[], bool] = lambda: False
) -> Plan:
    """Requests for windows that are chosen on the images, up to 25 on each.

    An image of group 1 that shares ground with images of group 2 gets windows where those are valid too, and they
    are measured there as well; all others get windows of their own. Windows are numbered through.
    """
    requests: list[NoiseRequest] = []
    notices: list[Message] = []
    first, second = ([one for one in images if one.group == group] for group in (1, 2))
    matched: set[int] = set()
    for one in (*first, *second):
        if cancelled():
            break
        if one.group == 2 and id(one) in matched:
            continue
        partners = [other for other in second if _overlap(one.image, other.image)] if one.group == 1 else []
        found = _chosen(one, partners, levels, notices)
        for parts in found:
            requests.append(NoiseRequest(len(requests) + 1, parts))
            matched.update(id(part.member) for part in parts[1:])
    if first and second and not any(request.paired for request in requests):
        notices.append(messages.GROUPS_APART())
    return Plan(tuple(requests), tuple(notices))


def pixel_size_notice(plan: Plan) -> Message | None:
    """That pixel sizes differ between the groups of a paired window, or None."""
    for request in plan.requests:
        sizes = {
            part.member.group: part.member.image.ground_sample_distance
            for part in reversed(request.parts)
        }
        if request.paired and sizes[1] and sizes[2]:
            ratio = sizes[1] / sizes[2]
            if abs(ratio - 1) > thresholds.MAX_PIXEL_SIZE_DIFFERENCE:
                return messages.PIXEL_SIZES_DIFFER(first=f"{sizes[1]:.3g} m", second=f"{sizes[2]:.3g} m")
    return None


def measure_window(
    ref: RasterRef,
    window: PixelWindow,
    wavelet: str = thresholds.DEFAULT_WAVELET,
    levels: int = thresholds.DEFAULT_LEVELS,
) -> ClipNoise:
    """The noise of one raster in one window on its own pixel grid, both sides multiples of ``2 ** levels``.

    Raises RasterError when the raster can't be opened; what can't be measured has its reason.
    """
    part = Part(GroupedImage(Pixels(ref).image(), 1), window)
    return measure_request(NoiseRequest(1, (part,)), wavelet, levels)[0]


def measure_request(request: NoiseRequest, wavelet: str, levels: int) -> list[ClipNoise]:
    """The noise of each image in a window; one that can't be measured has the reason. Never raises for bad data."""
    return _measured(request, _read(request, {}), wavelet, levels)


def measure_requests(
    requests: Iterable[NoiseRequest],
    wavelet: str,
    levels: int,
    executor: Executor,
    ahead: int,
    cancelled: Callable[[], bool] = lambda: False,
) -> Iterator[list[ClipNoise]]:
    """The results of each request in order, ``ahead`` of them under way at a time. Stops when cancelled.

    The pixels are read here, one request after the other, so that a raster stays open from window to window: a
    JPEG file is decoded from its top again for each new opening.
    """
    waiting = iter(requests)
    opened: dict[RasterRef, Pixels] = {}
    while (batch := list(islice(waiting, ahead))) and not cancelled():
        futures = []
        for request in batch:
            refs = {part.member.image.ref for part in request.parts}
            opened = {ref: pixels for ref, pixels in opened.items() if ref in refs}
            futures.append(executor.submit(_measured, request, _read(request, opened), wavelet, levels))
        for future in futures:
            if cancelled():
                future.cancel()
            else:
                yield future.result()


def _read(request: NoiseRequest, opened: dict[RasterRef, Pixels]) -> list[_Clip | Message]:
    """The pixels of every part and where they are invalid, or why they can't be used. ``opened`` is added to."""
    clips: list[_Clip | Message] = []
    for part in request.parts:
        ref = part.member.image.ref
        try:
            if ref not in opened:
                opened[ref] = Pixels(ref)
            bands, invalid = opened[ref].read(part.window)
            clips.append((bands, np.zeros(bands.shape[1:], bool) if invalid is None else invalid))
        except RasterError as error:
            clips.append(error.message)
    return clips


def _measured(
    request: NoiseRequest, clips: list[_Clip | Message], wavelet: str, levels: int
) -> list[ClipNoise]:
    most = thresholds.MAX_MASKED_SHARE if request.paired else thresholds.MAX_INVALID_SHARE
    usable: list[tuple[Part, _Clip]] = []
    results: dict[Part, ClipNoise] = {}
    for part, clip in zip(request.parts, clips):
        if isinstance(clip, Message):
            results[part] = ClipNoise(request.window_id, part, request.paired, {}, clip)
        elif (share := float(clip[1].mean())) > most:
            why = messages.TOO_MANY_INVALID(name=part.member.image.ref.name, share=share, most=most)
            results[part] = ClipNoise(request.window_id, part, request.paired, {}, why)
        else:
            usable.append((part, clip))
    paired = len({part.member.group for part, _ in usable}) > 1
    most = thresholds.MAX_MASKED_SHARE if paired else thresholds.MAX_INVALID_SHARE
    masks = [invalid for _, (_, invalid) in usable]
    if paired:
        masks = _joined_masks([part for part, _ in usable], masks)
    for (part, (bands, _)), mask in zip(usable, masks):
        name, share = part.member.image.ref.name, float(mask.mean())
        if share > most:
            why = messages.MASKED_TOO_MUCH(share=share, most=most)
            results[part] = ClipNoise(request.window_id, part, paired, {}, why)
        else:
            names = part.member.image.band_names
            measured = measure_noise(filled(bands, mask), names, wavelet, levels, name, mask)
            results[part] = ClipNoise(request.window_id, part, paired, measured)
    return [results[part] for part in request.parts]


def _chosen(
    one: GroupedImage, partners: list[GroupedImage], levels: int, notices: list[Message]
) -> list[tuple[Part, ...]]:
    """The windows of an image, each with the partners that show it."""
    name = one.image.ref.name
    opened: list[tuple[GroupedImage, Pixels]] = []
    for partner in partners:
        opened.append((partner, Pixels(partner.image.ref)))

    def shown(window: PixelWindow) -> tuple[Part, ...]:
        parts = []
        for partner, pixels in opened:
            there = _window_on(one.image, window, partner.image, levels)
            if there is not None and _is_valid(pixels, there):
                parts.append(Part(partner, there))
        return tuple(parts)

    try:
        pixels = Pixels(one.image.ref)
        found: list[tuple[Part, ...]] = []
        if opened:
            region = _shared_region(one.image, [partner.image for partner in partners])
            windows = choose_windows(pixels, one.image, levels, region, lambda window: bool(shown(window)))
            found = [(Part(one, window), *shown(window)) for window in windows]
        if not found:
            found = [(Part(one, window),) for window in choose_windows(pixels, one.image, levels)]
        found.sort(key=lambda parts: (parts[0].window.row, parts[0].window.column))  # as a file is read best
    except RasterError as error:
        notices.append(messages.SOURCE_LEFT_OUT(name=name, why=error.message))
        return []
    if not found:
        fewest = max(thresholds.MIN_SIDE_PX, 2**levels)
        notices.append(messages.RASTER_WITHOUT_WINDOW(name=name, fewest=fewest))
    elif found[0][0].window.width < thresholds.NOISE_WINDOW_PX:
        side, wanted = found[0][0].window.width, thresholds.NOISE_WINDOW_PX
        notices.append(messages.WINDOWS_SMALLER(name=name, wanted=wanted, side=side))
    return found


def _requests(
    window_id: int, taken: list[tuple[GroupedImage, Extent]], levels: int, notices: list[Message]
) -> list[NoiseRequest]:
    """One request for the images, or none where the window can't be laid on their pixels."""
    parts = []
    for one, extent in taken:
        assert one.image.grid is not None
        try:
            parts.append(Part(one, snap_window(one.image.grid, extent, levels)))
        except WindowError as error:
            notices.append(messages.WINDOW_LEFT_OUT(window=window_id, name=one.image.ref.name, why=error.message))
    return [NoiseRequest(window_id, tuple(parts))] if parts else []


def _extent_on_image(extent: Extent, wkt: str, image: Image) -> Extent | None:
    """An extent in the image's reference system; None where it can't be transformed there."""
    if not wkt or not image.wkt:
        return extent
    try:
        return extent_on(extent, wkt, image.wkt)
    except RasterError:
        return None


def _shown_share(grid: Grid, extent: Extent) -> float:
    """How much of an extent a grid covers."""
    shared = _shared(grid.extent, extent)
    whole = (extent[2] - extent[0]) * (extent[3] - extent[1])
    return (shared[2] - shared[0]) * (shared[3] - shared[1]) / whole if shared is not None and whole > 0 else 0.0


def _shared(a: Extent, b: Extent) -> Extent | None:
    xmin, ymin, xmax, ymax = max(a[0], b[0]), max(a[1], b[1]), min(a[2], b[2]), min(a[3], b[3])
    return (xmin, ymin, xmax, ymax) if xmin < xmax and ymin < ymax else None


def _common(taken: list[tuple[GroupedImage, Extent]], drawn: DrawnWindow) -> list[Extent]:
    """What all images show of a window, in the reference system of each."""
    left, bottom, right, top = 0.0, 0.0, 1.0, 1.0  # as shares of the window: its sides are parallel on all images
    for one, extent in taken:
        assert one.image.grid is not None
        shared = _shared(one.image.grid.extent, extent)
        assert shared is not None
        width, height = extent[2] - extent[0], extent[3] - extent[1]
        left, right = max(left, (shared[0] - extent[0]) / width), min(right, (shared[2] - extent[0]) / width)
        bottom, top = max(bottom, (shared[1] - extent[1]) / height), min(top, (shared[3] - extent[1]) / height)
    return [
        (x0 + left * (x1 - x0), y0 + bottom * (y1 - y0), x0 + right * (x1 - x0), y0 + top * (y1 - y0))
        for _, (x0, y0, x1, y1) in taken
    ]


def _overlap(a: Image, b: Image) -> bool:
    """Whether two images share ground, as far as their footprints tell."""
    if a.grid is None or b.grid is None or not a.wkt or not b.wkt:
        return False
    extent = _extent_on_image(b.grid.extent, b.wkt, a)
    return extent is not None and _shared(a.grid.extent, extent) is not None


def _shared_region(image: Image, others: Sequence[Image]) -> PixelWindow:
    """The pixels of an image around all that other images share with it, as far as their footprints tell."""
    assert image.grid is not None
    shared = []
    for other in others:
        assert other.grid is not None
        extent = _extent_on_image(other.grid.extent, other.wkt, image)
        box = None if extent is None else _shared(image.grid.extent, extent)
        shared += [] if box is None else [box]
    xmin, ymin = (min(box[i] for box in shared) for i in (0, 1))
    xmax, ymax = (max(box[i] for box in shared) for i in (2, 3))
    left, right = (round((x - image.grid.left) / image.grid.pixel_width) for x in (xmin, xmax))
    top, bottom = (round((image.grid.top - y) / image.grid.pixel_height) for y in (ymax, ymin))
    return PixelWindow(left, top, max(right - left, 1), max(bottom - top, 1))


def _window_on(image: Image, window: PixelWindow, other: Image, levels: int) -> PixelWindow | None:
    """The pixels of another image that show a window; None when it does not show all of it."""
    assert image.grid is not None
    assert other.grid is not None
    extent = _extent_on_image(image.grid.window_extent(window), image.wkt, other)
    if extent is None or _shown_share(other.grid, extent) < 1 - thresholds.MAX_INVALID_SHARE:
        return None
    try:
        return snap_window(other.grid, extent, levels)
    except WindowError:
        return None


def _is_valid(pixels: Pixels, window: PixelWindow) -> bool:
    invalid = pixels.read(window, min(thresholds.NOISE_SHRINK, min(window.width, window.height) // 16))[1]
    return invalid is None or not invalid.any()


def _joined_masks(parts: Sequence[Part], masks: Sequence[np.ndarray]) -> list[np.ndarray]:
    """For each part its own pixels that are invalid in any of the parts."""
    joined = []
    for part, own in zip(parts, masks):
        mask = np.array(own)
        for other, invalid in zip(parts, masks):
            if other is not part and invalid.any():
                mask |= _seen_from(part, other, invalid)
        joined.append(mask)
    return joined


def _seen_from(part: Part, other: Part, invalid: np.ndarray) -> np.ndarray:
    """Which pixels of a part lie, if only with an edge, on invalid pixels of another part."""
    own_grid, grid = part.member.image.grid, other.member.image.grid
    assert own_grid is not None
    assert grid is not None
    extent = own_grid.window_extent(part.window)
    there = _extent_on_image(extent, part.member.image.wkt, other.member.image)
    assert there is not None  # the window came over the same way
    columns = np.linspace(there[0], there[2], part.window.width + 1)
    rows = np.linspace(there[3], there[1], part.window.height + 1)
    columns = (columns - grid.left) / grid.pixel_width - other.window.column
    rows = (grid.top - rows) / grid.pixel_height - other.window.row
    counts = np.pad(invalid.cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    (top, bottom), (left, right) = (_covered(edges, size) for edges, size in zip((rows, columns), invalid.shape))
    found = (
        counts[np.ix_(bottom, right)] - counts[np.ix_(top, right)] - counts[np.ix_(bottom, left)]
        + counts[np.ix_(top, left)]
    )
    return np.asarray(found > 0)


def _covered(edges: np.ndarray, size: int) -> tuple[np.ndarray, np.ndarray]:
    """First and last but one of the cells 0..size - 1 that lie between neighbouring edges; slivers do not count."""
    sliver = 1e-3  # of a cell: rounding of coordinates
    first = np.clip(np.floor(edges[:-1] + sliver), 0, size).astype(int)
    last = np.clip(np.ceil(edges[1:] - sliver), 0, size).astype(int)
    return first, np.maximum(last, first)
