"""Pictures of the desk for its page in docs and for `make demo-pictures`; nothing is measured here.

Parameters: ``block`` (folder), ``mosaic`` (its name), ``side_m``, ``spacing_m``, ``small_side_m`` (of dense windows),
``piece_m`` (of a scan), ``screenshots`` (folder), ``name``: empty for all pictures, else the one of the desk as it
looks in this QGIS.
"""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from osgeo import gdal
from qgis.core import QgsRectangle
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QPushButton, QToolBar, QWidget
from qgis.utils import iface

from demo.desk import Desk

WIDE_PX, NARROW_PX = 640, 420  # of the dock: charts side by side where the screen has room for it
JUDGED = (Qt.Key.Key_V, Qt.Key.Key_V, Qt.Key.Key_I, Qt.Key.Key_V, Qt.Key.Key_U)
PROFILE_TENTHS = 50  # tenths of a second for the live profile


def play(desk: Desk) -> None:
    """One picture after the other."""
    shots, name = Path(desk.parameters["screenshots"]), desk.parameters["name"]
    if name:
        set_up(desk, NARROW_PX)
        inspect_all(desk)
        show_loss(desk, worst(desk))
        desk.screenshot(shots / f"{name}.png")
        return
    inputs(desk, shots)
    set_up(desk, WIDE_PX)
    draw(desk, shots)
    inspect_all(desk)
    curves(desk, shots)
    images(desk, shots)
    judge(desk, shots)
    dense(desk, shots)
    scan(desk, shots)
    desk.new_project()


def inputs(desk: Desk, shots: Path) -> None:
    """Show which rasters of a project are taken for sources, and why the others are not."""
    block, mosaic = Path(desk.parameters["block"]), desk.parameters["mosaic"]
    half, copy = desk.folder / f"{mosaic}_half.tif", desk.folder / f"{mosaic}_copy.vrt"
    gdal.Translate(str(half), str(block / f"{mosaic}.tif"), widthPct=50, heightPct=50, resampleAlg="average")
    gdal.Translate(str(copy), str(block / f"{mosaic}.tif"))
    *_, top = desk.load_rasters([half, copy, *sorted(block.glob("*.tif")), block / f"{mosaic}.tif"])
    desk.load_seamlines(block / "seamlines.gpkg")
    desk.open_dock()
    panel = desk.dock.inputs
    panel.mosaic.setLayer(top)
    panel.mosaic.activated.emit(panel.mosaic.currentIndex())
    panel.side.setValue(float(desk.parameters["side_m"]))
    desk.wait(lambda: desk.session.mosaic_grid() is not None, 20, "mosaic open")
    panel.box.setCollapsed(False)
    arrange(desk, WIDE_PX)
    desk.show_all(top.extent())
    panel.sources.list.scrollToBottom()
    desk.screenshot(shots / "desk_inputs.png")
    panel.box.setCollapsed(True)
    desk.new_project()


def set_up(desk: Desk, width: int) -> None:
    """The block on the map, and the dock beside it."""
    side_m, spacing_m = float(desk.parameters["side_m"]), float(desk.parameters["spacing_m"])
    desk.set_up(Path(desk.parameters["block"]), side_m, spacing_m, mosaic=desk.parameters["mosaic"])
    arrange(desk, width)


def draw(desk: Desk, shots: Path) -> None:
    """Curve and profile of the window under the mouse, before it is there."""
    session, side_m = desk.session, float(desk.parameters["side_m"])
    middle = session.mosaic_layer().extent().center()
    desk.dock.draw.trigger()
    desk.wait(lambda: session.seam_point_near(middle.x(), middle.y(), 1e6), 20, "seams found")
    x, y = session.seam_point_near(middle.x(), middle.y(), 1e6)
    desk.canvas.setExtent(QgsRectangle(x, y, x, y).buffered(0.7 * side_m))
    desk.canvas.refresh()
    desk.wait_for_map()
    for step in range(5):
        desk.move((x + step * desk.canvas.mapUnitsPerPixel(), y))
    desk.wait(lambda: session.live is not None, 30, "live curves")
    for _ in range(PROFILE_TENTHS):  # where one source covers the window there is none
        if session.live is None or session.live.profile is not None:
            break
        desk.pause(0.1)
    desk.pause(0.3)
    desk.screenshot(shots / "desk_live.png")
    desk.dock.draw.trigger()
    desk.rest_mouse()


def inspect_all(desk: Desk) -> None:
    """Windows along the seams, the worst first."""
    desk.place_and_inspect()
    desk.sort_by_loss()
    desk.rest_mouse()


def curves(desk: Desk, shots: Path) -> None:
    """Curve and profile beside the map, with the lost detail."""
    fid = worst(desk)
    show_loss(desk, fid)
    desk.screenshot(shots / "desk.png")
    desk.session.lost_detail.setChecked(False)
    desk.rest_mouse()


def images(desk: Desk, shots: Path) -> None:
    """The worst window beside its hard cut, and where detail was lost in it."""
    fid = worst(desk)
    desk.session.select([fid])
    desk.show_tab(1)
    panel = desk.dock.images
    desk.wait(lambda: panel.compared.layer is not None, 30, "hard cut")
    desk.wait_for_map()
    desk.rest_mouse()
    desk.screenshot(shots / "desk_images.png")
    desk.session.lost_detail.setChecked(True)
    desk.wait_for_map()
    desk.screenshot(shots / "desk_loss.png")
    desk.session.lost_detail.setChecked(False)
    desk.show_tab(0)


def judge(desk: Desk, shots: Path) -> None:
    """The worst windows, by keys alone."""
    desk.dock.zoom_to(worst(desk))
    with desk.judging():
        for key in JUDGED:
            desk.press_on_map(key)
    desk.rest_mouse()
    desk.wait_for_map()
    desk.wait(lambda: desk.curves_of(desk.session.selected()[0]), 30, "chart drawn")
    desk.screenshot(shots / "desk_judging.png")


def dense(desk: Desk, shots: Path) -> None:
    """The desk with as many small windows as the seams have room for."""
    desk.new_project()
    side_m = float(desk.parameters["small_side_m"])
    desk.set_up(Path(desk.parameters["block"]), side_m, 1.15 * side_m, mosaic=desk.parameters["mosaic"])
    desk.session.set_inputs(replace(desk.session.inputs, reference="sources"))
    desk.place_and_inspect()
    rows = desk.session.windows()
    for place, observer in enumerate(("visible", "invisible", "unsure")):
        desk.session.judge([row.fid for row in rows[place::6]], observer)
    desk.session.select([row.fid for row in rows[:12:3]])
    arrange(desk, NARROW_PX)
    desk.rest_mouse()
    desk.wait_for_map()
    desk.screenshot(shots / "desk_dense.png")


def scan(desk: Desk, shots: Path) -> None:
    """The whole mosaic, its seams found from the pixels; then the worst places, by the button of the message."""
    desk.new_project()
    set_up(desk, WIDE_PX)
    desk.project.removeMapLayer(desk.session.inputs.seamlines)
    piece_m = float(desk.parameters["piece_m"])
    desk.session.set_inputs(replace(desk.session.inputs, seamlines="", piece_m=piece_m))
    desk.wait(lambda: desk.session.mosaic_grid() is not None, 20, "mosaic open")
    items: list[object] = []
    desk.dock.scans.scanned.connect(items.append)
    desk.dock.scan.trigger()
    desk.wait(lambda: items, 400, "the scan's end")
    desk.wait_for_map()
    desk.screenshot(shots / "scan.png")
    messages = (item for item in iface.messageBar().items())
    buttons = [button for item in messages for button in item.findChildren(QPushButton)]
    next(button for button in buttons if button.text().startswith("Judge")).click()
    desk.wait(lambda: desk.session.windows() and all(row.verdict for row in desk.session.windows()), 200, "verdicts")
    desk.wait_for_work()
    desk.rest_mouse()
    desk.wait_for_map()
    desk.screenshot(shots / "scan_worst.png")


# What all of them need


def arrange(desk: Desk, width: int) -> None:
    """The dock at the right, the list of layers no wider than it has to be; QGIS's own toolbars are no part of it."""
    for bar in desk.window.findChildren(QToolBar, options=Qt.FindChildOption.FindDirectChildrenOnly):
        bar.hide()
    layers = desk.window.findChild(QWidget, "Layers")
    desk.window.resizeDocks([layers, desk.dock], [200, width], Qt.Orientation.Horizontal)
    desk.pause(0.5)


def show_loss(desk: Desk, fid: int) -> None:
    """A window on the map, wholly, with its lost detail, its curve and its profile."""
    desk.session.select([fid])
    extent = QgsRectangle(*desk.session.row(fid).extent)
    desk.canvas.setExtent(extent.buffered(0.03 * extent.width()))
    desk.canvas.refresh()
    desk.session.lost_detail.setChecked(True)
    iface.messageBar().clearWidgets()
    desk.wait(lambda: desk.curves_of(fid), 30, "chart drawn")
    desk.rest_mouse()
    desk.wait_for_map()


def worst(desk: Desk) -> int:
    """The first window of the order that begins with the worst."""
    return int(desk.dock.windows.ordered_fids()[0])
