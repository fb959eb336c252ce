"""An operator's walk: the guide's first inspection; then draw, place, inspect, judge, save, come back.

Parameters: ``project`` (of the block, as demo/project.py writes it), ``block`` (folder), ``side_m``, ``screenshots``.
"""
from __future__ import annotations

from pathlib import Path

from qgis.PyQt.QtCore import Qt

from demo.desk import Desk
from tests.desktop.scenarios import first_inspection


def play(desk: Desk) -> None:
    """Everything is asserted here that can be seen here; the rest is in the report."""
    first_inspection.play(desk)
    desk.report["first_sentence"] = desk.report.pop("sentence")
    block, side_m = Path(desk.parameters["block"]), float(desk.parameters["side_m"])
    desk.set_up(block, side_m, 2 * side_m)
    draw_windows(desk)
    place_and_inspect(desk)
    judge(desk)
    show_images(desk)
    desk.save_and_reopen()


def draw_windows(desk: Desk) -> None:
    """One by a click near a seam, one by a drag; each has its curve a moment later."""
    session = desk.session
    desk.dock.draw.trigger()
    assert desk.canvas.mapTool() is desk.dock.tool
    away = 6 * desk.canvas.mapUnitsPerPixel()
    desk.wait(lambda: session.seam_point_near(*place(desk, 0.46, 0.8), 1000), 20, "seams found")
    near = session.seam_point_near(*place(desk, 0.46, 0.8), 1000)
    desk.click((near[0] + away, near[1]))
    desk.wait(lambda: has_curve(desk, 1), 30, "curve of the clicked window")
    left, bottom, right, top = session.windows()[0].extent
    desk.report["clicked_m"] = right - left
    seam = session.seam_point_near((left + right) / 2, (bottom + top) / 2, 0.01 * (right - left))
    desk.report["clicked_on_seam"] = seam is not None
    desk.drag(place(desk, 0.6, 0.13), place(desk, 0.76, 0.38))
    desk.wait(lambda: has_curve(desk, 2), 30, "curve of the drawn window")
    desk.wait_for_work()


def place_and_inspect(desk: Desk) -> None:
    """Windows along the seams, all of them inspected."""
    session = desk.session
    desk.dock.place.trigger()
    desk.wait(lambda: len(session.windows()) > 2, 60, "windows placed")
    desk.wait_for_work()
    desk.dock.inspect.trigger()
    desk.wait(lambda: all(row.verdict for row in session.windows()), 120, "all inspected")
    desk.wait_for_work()
    desk.report["verdicts"] = [row.verdict for row in session.windows()]


def judge(desk: Desk) -> None:
    """The first window, by the key V."""
    session = desk.session
    first = session.windows()[0]
    desk.dock.zoom_to(first.fid)
    desk.pause(0.5)
    desk.report["sentence"], desk.report["why"] = desk.dock.judge.sentence(), desk.dock.judge.why()
    with desk.judging():
        desk.press_on_map(Qt.Key.Key_V)
    assert session.row(first.fid).observer == "visible"
    session.select([first.fid])
    desk.report["table"] = desk.table()
    desk.dock.draw.trigger()  # off: the tool of before is back
    assert desk.canvas.mapTool() is not desk.dock.tool
    desk.rest_mouse()
    desk.wait_for_map()


def show_images(desk: Desk) -> None:
    """The clips of the first window, and the map at 2 x 2 screen pixels an image pixel."""
    panel = desk.dock.images
    desk.show_tab(1)
    desk.dock.zoom_to(desk.session.selected()[0])
    desk.rest_mouse()
    desk.wait(lambda: panel.compared.layer is not None, 30, "hard cut")
    desk.wait_for_map()
    desk.report["pictures"] = panel.choice.count()
    desk.report["map_units_per_pixel"] = desk.canvas.mapUnitsPerPixel()
    desk.screenshot(Path(desk.parameters["screenshots"]) / "walk_images.png")
    desk.show_tab(0)


def has_curve(desk: Desk, count: int) -> bool:
    """Whether there are so many windows, and the chart shows the last one's curves."""
    session = desk.session
    selected = session.selected()
    if len(session.windows()) != count or len(selected) != 1:
        return False
    return session.result(selected[0]) is not None and desk.curves_of(selected[0])


def place(desk: Desk, x: float, y: float) -> tuple[float, float]:
    """A point of the mosaic, by shares from its upper left corner."""
    extent = desk.session.mosaic_layer().extent()
    return extent.xMinimum() + x * extent.width(), extent.yMaximum() - y * extent.height()
