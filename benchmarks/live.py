"""What an operator waits for: the curves after a click, and the live curve under the mouse, against the bare read."""
from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from itertools import count
from statistics import median

from seam_inspector.plugin.imagery.raster_pool import ReadingLanes
from seam_inspector.plugin.seams.measure.window.explained_window import live_profile, read_live
from seam_inspector.plugin.seams.measure.window.measured_window import MeasuredWindow, WindowRequest, measure_window
from seam_inspector.plugin.toolkit.background_tasks import SWITCH_INTERVAL_S

from .ground import Ground
from .timing import Goal, interleaved, print_table
from .windows import bare_read, joined, places

SIDES = (512, 1024)
TILES = ("DEFLATE", "JPEG 75")
FEWEST_PICTURES = 15.0
LIVE_SIDE, CLICKED_SIDE = SIDES
MOST_OF_BARE_READ = 2.0
STEP_PX, STEPS = 6, 8  # that the mouse moves from picture to picture, there and back


def first_click(request: WindowRequest) -> None:
    """Curves of files that nobody has opened."""
    lanes = ReadingLanes()
    measure_window(request, lanes)
    lanes.close()


def moved(request: WindowRequest) -> Iterator[WindowRequest]:
    """A window on its way along a diagonal."""
    assert request.window is not None
    window = request.window
    for number in count():
        step = STEP_PX * min(number % (2 * STEPS), 2 * STEPS - number % (2 * STEPS))
        yield replace(request, window=replace(window, column=window.column + step, row=window.row + step))


def run(ground: Ground, quick: bool) -> list[Goal]:
    """Print clicks and live curves as multiples of the bare read, and the pictures a second."""
    sys.setswitchinterval(SWITCH_INTERVAL_S)  # as in the desk
    repetitions = 5 if quick else 9
    rows, goals = [], []
    lanes = ReadingLanes()
    for tile_format in TILES:
        for side in SIDES:
            timings = []
            for whole in ground.requests(tile_format):
                assert whole.window is not None
                request = replace(whole, window=replace(whole.window, width=side, height=side))
                path, pixels = moved(request), read_live(request, lanes)
                assert pixels is not None
                calls = (
                    partial(bare_read, places(request)),
                    partial(first_click, request),
                    partial(measure_window, request, lanes),
                    partial(next_live, path, lanes),
                    partial(live_profile, pixels),
                )
                timings.append(interleaved(calls, repetitions))
            bare, cold, warm, live, profile = map(joined, zip(*timings))
            pictures = 1 / median(live.wall)
            rows.append([
                f"{tile_format}, {side} px", bare.milliseconds, *(str(one.over(bare)) for one in (cold, warm, live)),
                f"{live.cpu_over(bare):.2f}", f"{pictures:.0f}", f"{profile.over(bare).median:.2f}",
            ])  # fmt: skip
            name = f"{tile_format}, {side} px"
            if side == CLICKED_SIDE:
                text = f"curves at a click, {name}, read ahead: times the bare read"
                goals.append(Goal(text, MOST_OF_BARE_READ, warm.over(bare).median, at_least=False))
            if side == LIVE_SIDE:
                goals.append(Goal(f"live curve, {name}: pictures a second", FEWEST_PICTURES, pictures))
    lanes.close()
    print_table(
        "At the click and under the mouse, a mosaic and two sources, RGB, against the bare GDAL read",
        ["tiles of 256 px", "bare read", "click (least-most)", "read ahead", "live curve", "CPU", "a second", "seam"],
        rows,
        f"Medians of {repetitions} interleaved repetitions of 4 windows, ratios pair by pair. Click: curves of all\n"
        "  bands, files opened for it and read side by side; read ahead: files open, blocks cached. Live curve: of\n"
        f"  luminance, the window {STEP_PX} px farther each time. Seam: its profile, in another thread.",
    )
    return goals


def next_live(path: Iterator[WindowRequest], lanes: ReadingLanes) -> MeasuredWindow | None:
    """The next picture's figures."""
    return read_live(next(path), lanes)
