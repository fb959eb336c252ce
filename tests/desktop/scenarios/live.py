"""How soon a curve follows a click, and how often the curve under the mouse is drawn anew.

Parameters: ``block`` (folder of a block of orthoimages, 0.10 m), ``screenshots`` (folder).
"""
from __future__ import annotations

import statistics
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from itertools import cycle
from pathlib import Path
from typing import Any

from osgeo import gdal
from qgis.core import QgsRectangle
from qgis.PyQt.QtTest import QTest

from demo.desk import Desk, Point
from demo.gaps import Gaps

CLICK_SIDE_M, CLICKS = 100, 8  # 1024 px
LIVE_SIDE_M, LIVE_SECONDS = 50, 4  # 512 px
MANY = 200
_FRAME_S = 0.016
_MARGIN_M = 6.0  # within the footprint of an image of the block there may be none of its pixels so near the edge


def play(desk: Desk) -> None:
    """All that is measured is in the report."""
    desk.set_up(Path(desk.parameters["block"]), CLICK_SIDE_M, CLICK_SIDE_M)
    desk.dock.draw.trigger()
    desk.wait(lambda: desk.session.seam_point_near(*centre_of(desk), 1e6), 30, "seams")
    warm_up(desk)
    time_clicks(desk, rest_s=0.0)
    time_clicks(desk, rest_s=0.7)
    follow(desk)
    move_many(desk)
    desk.dock.draw.trigger()
    desk.rest_mouse()


def warm_up(desk: Desk) -> None:
    """The first window: its layer is made, and the first chart."""
    with Gaps() as gaps:
        click(desk, next(two_source_points(desk)), 0.0)
        desk.wait(lambda: not desk.session.is_busy, 60, "first window inspected")
        desk.session.remove(desk.session.selected())
        desk.pause(0.3)
    note(desk, "first", gaps)


def time_clicks(desk: Desk, rest_s: float) -> None:
    """Windows of 1024 px with two sources: from the release of the button to the curves on the screen.

    Against the bare read of the same pixels, in the same seconds; ``rest_s``: how long the mouse rested before.
    """
    name = "rested" if rest_s else "clicked"
    curves, ratios, wholes, bare, sizes, drawings = [], [], [], [], set(), []
    with Gaps() as gaps:
        for number, point in enumerate(two_source_points(desk)):
            if number >= CLICKS:
                break
            drawn = charts_drawn(desk)
            curve_s, whole_s = click(desk, point, rest_s)
            desk.wait(lambda: not desk.session.is_busy, 60, "idle after a click")
            desk.pause(0.3)
            drawings.append(charts_drawn(desk) - drawn)
            result = desk.session.result(desk.session.selected()[0])
            sizes.add((result.window.width, result.window.height, result.source_count))
            with ThreadPoolExecutor(1) as executor:
                read = executor.submit(bare_read, desk.session.request(desk.session.selected()[0]))
                desk.wait(read.done, 60, "bare read")
            bare.append(read.result())
            desk.session.remove(desk.session.selected())  # a click on it would select it
            desk.pause(0.3)
            curves.append(curve_s)
            wholes.append(whole_s)
            ratios.append(curve_s / bare[-1])
    desk.report[f"{name}_sizes"] = sorted(sizes)
    desk.report[f"{name}_curve_ms"] = [round(1000 * x) for x in sorted(curves)]
    desk.report[f"{name}_whole_ms"] = 1000 * statistics.median(wholes)
    desk.report[f"{name}_bare_read_ms"] = 1000 * statistics.median(bare)
    desk.report[f"{name}_over_bare_read"] = statistics.median(ratios)
    desk.report[f"{name}_drawings"] = drawings
    note(desk, name, gaps)


def click(desk: Desk, point: Point, rest_s: float) -> tuple[float, float]:
    """Seconds from a click to the curves, and to all the rest."""
    session = desk.session
    before = len(session.windows())
    if rest_s:
        QTest.mouseMove(desk.canvas.viewport(), desk.pixel(point))
        desk.pause(rest_s)
    desk.click(point)
    start = time.perf_counter()
    desk.wait(lambda: len(session.windows()) > before and session.selected(), 20, "window")
    desk.wait(lambda: desk.first_curves_of(session.selected()[0]), 20, "curves of a clicked window")
    curve_s = time.perf_counter() - start
    desk.wait(lambda: desk.curves_of(session.selected()[0]), 60, "all of a clicked window")
    return curve_s, time.perf_counter() - start


def follow(desk: Desk) -> None:
    """Move a standard window of 512 px along a seam for some seconds, then drag one."""
    session, shots = desk.session, Path(desk.parameters["screenshots"])
    session.set_inputs(replace(session.inputs, side_m=LIVE_SIDE_M))
    path = seam_path(desk)
    zoom_to(desk, path[len(path) // 2])
    inside = [point for point in path if desk.canvas.extent().buffered(-10).contains(*point)]
    there_and_back = cycle([*inside, *reversed(inside)])
    measure_live(desk, "moved", there_and_back)
    desk.wait(lambda: session.live is not None and session.live.profile is not None, 20, "profile of the live window")
    desk.report["live_profiles"] = True
    desk.screenshot(shots / "live.png")
    x, y = inside[len(inside) // 2]
    corner = x - 25.6, y + 25.6
    grown = cycle([(x + 25.6 + 0.2 * step, y - 25.6 - 0.2 * step) for step in range(-10, 10)])
    QTest.mousePress(desk.canvas.viewport(), *left(), desk.pixel(corner))
    measure_live(desk, "dragged", grown)
    desk.screenshot(shots / "live_drag.png")
    before = len(session.windows())
    end = next(grown)
    QTest.mouseRelease(desk.canvas.viewport(), *left(), desk.pixel(end))
    desk.wait(lambda: len(session.windows()) > before and session.live is None, 20, "dragged window")
    desk.wait(lambda: desk.curves_of(session.selected()[0]), 60, "all of a dragged window")
    desk.rest_mouse()
    desk.screenshot(shots / "live_after.png")


def measure_live(desk: Desk, name: str, points: Iterator[Point]) -> None:
    """Pictures a second while the mouse moves."""
    told: list[Any] = []
    profiles: list[Any] = []

    def hear() -> None:
        live = desk.session.live
        if live is not None and (not told or told[-1] != live.window):
            told.append(live.window)
        if live is not None and live.profile is not None and (not profiles or profiles[-1] is not live.profile):
            profiles.append(live.profile)

    desk.session.liveChanged.connect(hear)
    move(desk, points, 1.0)  # blocks are read the first time
    told.clear()
    profiles.clear()
    drawn, start = charts_drawn(desk), time.perf_counter()
    with Gaps() as gaps:
        moves = move(desk, points, LIVE_SECONDS)
    seconds = time.perf_counter() - start
    desk.session.liveChanged.disconnect(hear)
    desk.report[f"{name}_curves_a_second"] = len(told) / seconds
    desk.report[f"{name}_pictures_a_second"] = (charts_drawn(desk) - drawn) / seconds
    desk.report[f"{name}_profiles_a_second"] = len(profiles) / seconds
    desk.report[f"{name}_moves_a_second"] = moves / seconds
    note(desk, name, gaps)


def move(desk: Desk, points: Iterator[Point], seconds: float) -> int:
    """Move the mouse from point to point; how many times."""
    end, count = time.perf_counter() + seconds, 0
    while time.perf_counter() < end:
        QTest.mouseMove(desk.canvas.viewport(), desk.pixel(next(points)))
        desk.pause(_FRAME_S)
        count += 1
    return count


def move_many(desk: Desk) -> None:
    """Two hundred places all over the block: what stays open and in memory; and nothing when it is let go."""
    desk.show_all(desk.session.mosaic_layer().extent())
    points = two_source_points(desk)
    many = [next(points) for _ in range(20)]
    steps = cycle((x + dx, y) for dx in range(10) for x, y in many)
    for count in (20, MANY):
        for _ in range(count):
            QTest.mouseMove(desk.canvas.viewport(), desk.pixel(next(steps)))
            desk.pause(0.1)
        desk.report[f"files_after_{count}"], desk.report[f"memory_mb_after_{count}"] = open_files(), memory_mb()
    desk.session.leave()
    desk.wait(lambda: not desk.session.live, 5, "no live window")
    before = open_files()
    desk.session._live.let_go()
    desk.pause(1)
    desk.report["files_let_go"] = before - open_files()


# What all of them need


def bare_read(request: Any) -> float:
    """Seconds that GDAL alone takes for the pixels of a window, each file opened for it."""
    window, grid = request.window, request.mosaic.grid
    start = time.perf_counter()
    for ref in (request.mosaic.ref, *(source.ref for source in request.sources)):
        dataset = gdal.Open(ref.path)
        left, size, _, top, _, _ = dataset.GetGeoTransform()
        column = max(round((grid.left - left) / size) + window.column, 0)
        row = max(round((top - grid.top) / size) + window.row, 0)
        width, height = min(window.width, dataset.RasterXSize - column), min(window.height, dataset.RasterYSize - row)
        dataset.ReadAsArray(column, row, width, height)
    return time.perf_counter() - start


def two_source_points(desk: Desk) -> Iterator[Point]:
    """Where a standard window has just two sources, both of them wholly, scattered over the block."""
    from seam_inspector.plugin.seams.desk.map.window_tool import clicked_window

    session, grid = desk.session, desk.session.mosaic_grid()
    extent = session.mosaic_layer().extent()
    found = []
    for row in range(1, 40):
        for column in range(1, 40):
            x = extent.xMinimum() + column / 40 * extent.width()
            y = extent.yMinimum() + row / 40 * extent.height()
            window = clicked_window(grid, (x, y), session.inputs)
            around, over = QgsRectangle(*grid.window_extent(window)).buffered(_MARGIN_M), session.block().sources_over
            if len(over(window)) == 2 and all(QgsRectangle(*one.extent).contains(around) for one in over(window)):
                found.append((x, y))
    assert len(found) >= 3 * CLICKS, f"{len(found)} points"
    return iter(found[:: max(1, len(found) // 40)] * 5)


def seam_path(desk: Desk) -> list[Point]:
    """Points every 0.3 m along the seam where windows have two sources."""
    from seam_inspector.plugin.seams.desk.map.window_tool import clicked_window

    session, grid = desk.session, desk.session.mosaic_grid()
    layer = desk.project.mapLayer(session.inputs.seamlines)
    longest: list[Point] = []
    for feature in layer.getFeatures():
        line = feature.geometry()
        if line.type() == 2:
            line = line.convertToType(1, True)
        path = []
        for step in range(int(line.length() / 0.3)):
            place = line.interpolate(0.3 * step).asPoint()
            point = place.x(), place.y()
            try:
                count = len(session.block().sources_over(clicked_window(grid, point, session.inputs)))
            except Exception:
                count = 0
            if count == 2:
                path.append(point)
            else:
                longest, path = max(longest, path, key=len), []
        longest = max(longest, path, key=len)
    return longest


def zoom_to(desk: Desk, point: Point) -> None:
    """Some 150 m around a point."""
    x, y = point
    desk.canvas.setExtent(QgsRectangle(x - 75, y - 75, x + 75, y + 75))
    desk.canvas.refresh()
    desk.wait_for_map()


def centre_of(desk: Desk) -> Point:
    """Middle of the mosaic."""
    point = desk.session.mosaic_layer().extent().center()
    return point.x(), point.y()


def left() -> tuple[Any, Any]:
    """The left button, without keys."""
    from qgis.PyQt.QtCore import Qt

    return Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier


_drawn: dict[Any, list[object]] = {}


def charts_drawn(desk: Desk) -> int:
    """How many pictures of curves were drawn since it was asked first; nobody points at a new one."""
    chart = desk.dock.curves.curves._chart
    if chart not in _drawn:
        _drawn[chart] = []
        chart.pointed.connect(_drawn[chart].append)
    return len(_drawn[chart])


def open_files() -> int:
    """How many files this process has open."""
    return len(list(Path("/proc/self/fd").iterdir()))


def memory_mb() -> float:
    """Held by this process now."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmRSS")) / 1024


def note(desk: Desk, name: str, gaps: Gaps) -> None:
    """Into the report."""
    desk.report[f"{name}_gap_ms"] = 1000 * gaps.longest_s
    desk.report[f"{name}_work_ms"] = 1000 * gaps.longest_work_s
    desk.report[f"{name}_gaps"] = sorted(gaps.long_ones, reverse=True)[:6]
