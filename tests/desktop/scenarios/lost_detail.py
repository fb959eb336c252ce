"""Where detail was lost: one button, a turned map, another project system, chart and map side by side.

Parameters: ``brighton`` (folder), ``mosaic``, ``screenshots`` (folder).
"""
from __future__ import annotations

from pathlib import Path

from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsGeometry, QgsPointXY, QgsRectangle
from qgis.PyQt.QtCore import QPoint
from qgis.PyQt.QtTest import QTest

from demo.desk import Desk

SIDE_M = 15
GRID = 40  # places looked at along a side
BESIDE_M = 3.0  # from the seam, where the feather has ended


def play(desk: Desk) -> None:
    """What is measured is in the report."""
    folder, mosaic = Path(desk.parameters["brighton"]), desk.parameters["mosaic"]
    shots, canvas = Path(desk.parameters["screenshots"]), desk.canvas
    desk.set_up(folder, SIDE_M, SIDE_M, mosaic=mosaic)
    session, dock = desk.session, desk.dock
    dock.place.trigger()
    desk.wait(lambda: session.windows() and not session.is_busy, 30, "windows placed")
    fid = session.windows()[3].fid
    session.inspect([fid])
    desk.wait(lambda: session.row(fid).verdict, 60, "the window inspected")
    desk.wait_for_work()
    dock.zoom_to(fid)
    desk.wait_for_map()
    desk.rest_mouse()
    toggle_loss(desk)
    desk.report["shown_by_button"] = session.loss_view.is_shown
    along = places(desk, fid)
    for name, crs, rotation in (
        ("north up", "EPSG:32615", 0), ("turned", "EPSG:32615", 30), ("in degrees", "EPSG:4326", 0),
    ):  # fmt: skip
        desk.project.setCrs(QgsCoordinateReferenceSystem(crs))
        canvas.setRotation(rotation)
        dock.zoom_to(fid)
        desk.wait_for_map()
        desk.screenshot(shots / f"lost_detail_{mosaic}_{name.replace(' ', '_')}.png")
        desk.report[name] = coloured(desk, *along)
    tab = dock.curves
    curve, profile = tab.curves._chart, tab.profile.chart
    desk.report["curve_px"], desk.report["profile_px"] = (
        [one.width(), one.height()] for one in (curve, profile)
    )  # fmt: skip
    body = dock.widget()
    bottom = dock.judge.mapTo(body, dock.judge.rect().bottomLeft()).y()
    desk.report["judge_bar_in_sight"] = bottom <= body.height()
    placed = profile.painter()
    QTest.mouseMove(profile, QPoint(round(placed.x_of(0.6)), profile.height() // 2))
    desk.pause(0.3)
    desk.report["pointed"] = profile.pointed_bin is not None
    desk.screenshot(shots / f"lost_detail_{mosaic}_pointed.png")
    toggle_loss(desk)
    desk.report["hidden_by_button"] = not session.loss_view.is_shown


def toggle_loss(desk: Desk) -> None:
    """Switch lost detail on or off by the button beside the tabs."""
    desk.dock.lost.action.trigger()
    desk.pause(0.3)


def coloured(desk: Desk, on_seam: list[QgsPointXY], beside: list[QgsPointXY]) -> tuple[float, float]:
    """Shares of the places along the window's seams and beside them that the switch colours on the screen."""
    session, canvas = desk.session, desk.canvas
    transform = QgsCoordinateTransform(
        session.mosaic_layer().crs(), canvas.mapSettings().destinationCrs(), desk.project
    )  # fmt: skip
    shown = canvas.grab().toImage()
    session.loss_view.show(False)
    desk.pause(0.3)
    plain = canvas.grab().toImage()
    session.loss_view.show(True)
    desk.pause(0.3)
    shares = []
    for points in (on_seam, beside):
        differ = seen = 0
        for point in points:
            pixel = canvas.getCoordinateTransform().transform(transform.transform(point))
            x, y = round(pixel.x()), round(pixel.y())
            if 0 <= x < 0.6 * canvas.width() and 0 <= y < canvas.height():  # the legend is on the right
                seen += 1
                differ += shown.pixel(x, y) != plain.pixel(x, y)
        assert seen > 10
        shares.append(differ / seen)
    return shares[0], shares[1]


def places(desk: Desk, fid: int) -> tuple[list[QgsPointXY], list[QgsPointXY]]:
    """In a window, on its seams and far from all of them."""
    layer = next(shown for shown in desk.project.mapLayers().values() if shown.name() == "seamlines")
    box = QgsRectangle(*desk.session.row(fid).extent)
    near = QgsGeometry.fromRect(box.buffered(BESIDE_M))  # thousands of pieces of a pixel each are all there is of them
    parts = [one.geometry().intersection(near) for one in layer.getFeatures(box.buffered(BESIDE_M))]
    seams = QgsGeometry.unaryUnion(parts).simplify(0.02)
    on_seam, beside = [], []
    for row in range(1, GRID):
        for column in range(1, GRID):
            x, y = (low + share / GRID * SIDE_M for low, share in ((box.xMinimum(), column), (box.yMinimum(), row)))
            point = QgsPointXY(x, y)
            away = seams.distance(QgsGeometry.fromPointXY(point))
            if away < 0.15:
                on_seam.append(point)
            elif away > BESIDE_M:
                beside.append(point)
    return on_seam, beside
