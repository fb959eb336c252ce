"""The mosaic against a source on the map: either side shows what QGIS alone would draw of it, and nothing is left."""
from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import (
    QgsContrastEnhancement,
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsGeometry,
    QgsMapRendererSequentialJob,
    QgsMapSettings,
    QgsRasterLayer,
    QgsRectangle,
    QgsVectorLayer,
)
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QEvent, QPoint, QPointF, QSize, Qt
from qgis.PyQt.QtGui import QColor, QImage, QMouseEvent
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QDockWidget, QMainWindow, QTreeWidget, QWidget
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.desk.desk_keys import DeskKeys
from seam_inspector.plugin.seams.desk.keys import SWIPING
from seam_inspector.plugin.seams.desk.swipe import swipe_item as map_picture
from seam_inspector.plugin.seams.desk.swipe.swipe_action import SwipeAction
from seam_inspector.plugin.seams.desk.swipe.swipe_item import SwipeHandle
from seam_inspector.plugin.seams.desk.swipe.swiped_layer import looks_alike

from tests.numbers.synthetic import orthoimage, write_raster
from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, SHARP_WINDOW, Desk, settle, wait_for_tasks, wait_until

SIZE = QSize(400, 300)
MARGIN = 40  # px beside the handle, and above the names, that are not compared


class Map:
    """A main window with a map of the session's mosaic, and the dock's swipe."""

    def __init__(self, desk: Desk) -> None:
        self.desk = desk
        desk.set(desk.inputs())
        self.window = QMainWindow()
        self.canvas = QgsMapCanvas()
        self.canvas.setCanvasColor(QColor("white"))
        self.window.setCentralWidget(self.canvas)
        self.canvas.setFixedSize(SIZE)
        self.show([desk.mosaic])
        self.window.show()
        QApplication.setActiveWindow(self.window)
        self.canvas.setFocus()
        self.canvas.setDestinationCrs(desk.mosaic.crs())
        self.canvas.setExtent(desk.mosaic.extent())
        self.action = SwipeAction(self.canvas, desk.session, self.window)
        self.swipe = self.action.swipe
        self.keys = DeskKeys(QWidget(self.window), self.window, self.canvas)
        self.keys.set_actions(self.action.key_actions(), {}, {SWIPING: lambda: self.swipe.is_on})
        self.keys.listen(True)
        self.before = self.left_over()
        self.wait()

    def show(self, layers: list[QgsRasterLayer]) -> None:
        self.canvas.setLayers(layers)

    def start(self) -> None:
        self.action.action.trigger()
        self.wait()

    def wait(self) -> None:
        """Until the map and what is swiped are drawn."""
        self.canvas.refresh()
        settle(0.02)
        wait_until(lambda: not self.canvas.isDrawing() and not self.swipe.is_drawing, "for the map")
        settle(0.02)

    def left_over(self) -> tuple[int, int]:
        """Canvas items, and widgets on the canvas."""
        return len(self.canvas.scene().items()), len(self.canvas.findChildren(SwipeHandle))

    def seen(self) -> np.ndarray:
        return pixels(self.canvas.viewport().grab().toImage())

    def alone(self, path: Path) -> np.ndarray:
        """What QGIS draws of one raster."""
        settings = QgsMapSettings(self.canvas.mapSettings())
        layer = QgsRasterLayer(str(path), "alone")
        settings.setLayers([layer])
        settings.setBackgroundColor(QColor("white"))
        job = QgsMapRendererSequentialJob(settings)
        job.start()
        job.waitForFinished()
        return pixels(job.renderedImage())

    def sides(self, image: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        at = round(self.swipe.divider.share * SIZE.width())
        return image[:-MARGIN, : at - MARGIN], image[:-MARGIN, at + MARGIN :]


def pixels(image: QImage) -> np.ndarray:
    image = image.convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits().asarray(image.sizeInBytes()), np.uint8).reshape(image.height(), -1)
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).copy()


def same(one: np.ndarray, other: np.ndarray) -> bool:
    return bool((abs(one.astype(int) - other) <= 1).mean() > 0.999)


def composites_in_memory() -> list[str]:
    return [path for path in gdal.ReadDirRecursive("/vsimem/") or () if "composite" in path and path.endswith(".tif")]


@pytest.fixture
def map_(desk: Desk) -> Iterator[Map]:
    made = Map(desk)
    yield made
    made.keys.close()
    made.action.close()
    made.window.close()
    made.window.deleteLater()
    wait_for_tasks()


def test_either_side_is_what_qgis_draws(map_: Map) -> None:
    """On a rotated map and in another reference system too."""
    west = Path(map_.desk.sources[0].source())
    mosaic = Path(map_.desk.mosaic.source())
    map_.start()
    for change in (
        lambda: None,
        lambda: map_.canvas.zoomByFactor(0.5),
        lambda: map_.canvas.setRotation(30),
        lambda: map_.canvas.setDestinationCrs(QgsCoordinateReferenceSystem("EPSG:3035")),
        lambda: map_.swipe.move(0.3),
    ):
        change()
        map_.wait()
        left, right = map_.sides(map_.seen())
        assert same(left, map_.sides(map_.alone(mosaic))[0])
        assert same(right, map_.sides(map_.alone(west))[1])
        assert not same(right, map_.sides(map_.alone(mosaic))[1])


def test_keys_exchange_the_sides_and_end(map_: Map) -> None:
    map_.start()
    west, mosaic = (Path(layer.source()) for layer in (map_.desk.sources[0], map_.desk.mosaic))
    assert map_.left_over() == tuple(n + more for n, more in zip(map_.before, (1, 1)))
    QTest.keyClick(map_.canvas, Qt.Key.Key_X)
    settle(0.02)
    left, right = map_.sides(map_.seen())
    assert same(left, map_.sides(map_.alone(west))[0])
    assert same(right, map_.sides(map_.alone(mosaic))[1])
    QTest.keyClick(map_.canvas, Qt.Key.Key_Escape)
    settle(0.02)
    assert not map_.swipe.is_on
    assert not map_.action.action.isChecked()
    assert map_.left_over() == map_.before
    assert same(map_.seen(), map_.alone(mosaic))


def test_a_tree_beside_the_map_keeps_its_letters(map_: Map) -> None:
    dock, tree = QDockWidget(), QTreeWidget()
    dock.setWidget(tree)
    map_.window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, dock)
    map_.start()
    tree.setFocus()
    for key in (Qt.Key.Key_X, Qt.Key.Key_Escape):
        QTest.keyClick(tree, key)
    assert map_.swipe.is_on
    assert not map_.swipe.divider.is_flipped


def test_the_handle_is_dragged(map_: Map) -> None:
    map_.start()
    (handle,) = map_.canvas.findChildren(SwipeHandle)

    def mouse(kind: QEvent.Type, x: int) -> None:
        at = map_.canvas.viewport().mapToGlobal(QPoint(x, 150))
        left = Qt.MouseButton.LeftButton
        none = Qt.KeyboardModifier.NoModifier
        event = QMouseEvent(kind, QPointF(handle.mapFromGlobal(at)), QPointF(at), left, left, none)
        QApplication.sendEvent(handle, event)

    mouse(QEvent.Type.MouseButtonPress, 200)
    for x in (180, 120, 100):
        mouse(QEvent.Type.MouseMove, x)
    mouse(QEvent.Type.MouseButtonRelease, 100)
    mouse(QEvent.Type.MouseMove, 300)
    settle(0.02)
    assert handle.geometry().center().x() == pytest.approx(100, abs=2)
    assert same(map_.sides(map_.seen())[1], map_.sides(map_.alone(Path(map_.desk.sources[0].source())))[1])


def test_the_picture_goes_with_the_map_until_the_next_is_drawn(map_: Map) -> None:
    """Moved, zoomed and turned, every place is where the map has it."""
    map_.start()
    before, picture = QgsMapSettings(map_.canvas.mapSettings()), map_.swipe._other
    now = QgsMapSettings(before)
    extent = now.extent()
    extent.scale(0.4, extent.center())
    now.setExtent(QgsRectangle(*(side + 3 for side in (
        extent.xMinimum(), extent.yMinimum(), extent.xMaximum(), extent.yMaximum()
    ))))  # fmt: skip
    now.setRotation(25)
    where = picture.onto(now)
    assert where is not None
    for x, y in ((0, 0), (10, 250), (333, 77)):
        wanted = now.mapToPixel().transform(before.mapToPixel().toMapCoordinates(x, y))
        found = where.map(QPointF(x, y))
        assert (found.x(), found.y()) == pytest.approx((wanted.x(), wanted.y()), abs=1e-6)
    now.setDestinationCrs(QgsCoordinateReferenceSystem("EPSG:3857"))
    assert picture.onto(now) is None


def test_the_mosaic_is_seen_though_a_source_lies_above_it(map_: Map) -> None:
    map_.show([*map_.desk.sources, map_.desk.mosaic])
    map_.start()
    left, right = map_.sides(map_.seen())
    assert same(left, map_.sides(map_.alone(Path(map_.desk.mosaic.source())))[0])
    assert same(right, map_.sides(map_.alone(Path(map_.desk.sources[0].source())))[1])


def test_lines_stay_above_both_sides(map_: Map) -> None:
    map_.desk.seamlines.renderer().symbol().setColor(QColor("#ff00ff"))
    map_.desk.seamlines.renderer().symbol().setWidth(2)
    map_.canvas.setLayers([map_.desk.seamlines, map_.desk.mosaic])
    map_.start()
    for share in (0.2, 0.8):
        map_.swipe.move(share)
        settle(0.02)
        assert (abs(map_.seen()[200, 190:210].astype(int) - (255, 0, 255)).max(axis=1) < 20).any()


def test_a_source_of_an_index_is_opened_for_the_swipe_alone(map_: Map) -> None:
    desk = map_.desk
    index = QgsVectorLayer("Polygon?crs=EPSG:32633&field=location:string", "index", "memory")
    paths = [layer.source() for layer in desk.sources]
    for layer in desk.sources:
        feature = QgsFeature(index.fields())
        feature.setGeometry(QgsGeometry.fromRect(layer.extent()))
        feature.setAttribute("location", layer.source())
        index.dataProvider().addFeatures([feature])
    desk.project.addMapLayer(index)
    desk.project.removeMapLayers([layer.id() for layer in desk.sources])
    desk.set(replace(desk.session.inputs, sources=(), source_index=index.id()))
    layers = set(desk.project.mapLayers())
    map_.start()
    assert same(map_.sides(map_.seen())[1], map_.sides(map_.alone(Path(paths[0])))[1])
    assert [choice.title for choice in map_.action.choices()] == ["west.tif", "east.tif"]
    assert set(desk.project.mapLayers()) == layers


def test_it_follows_the_selected_window_and_keeps_what_was_chosen(map_: Map) -> None:
    desk = map_.desk
    first = desk.add()
    desk.session.select([first])
    map_.start()
    east = map_.action.choices()[1]
    assert east.title == "east.tif"
    map_.action.start(east)
    map_.wait()
    assert same(map_.sides(map_.seen())[1], map_.sides(map_.alone(Path(desk.sources[1].source())))[1])
    desk.session.select([])
    assert map_.swipe.choice == east
    desk.set(replace(desk.session.inputs, sources=desk.session.inputs.sources[:1]))
    map_.wait()
    assert map_.swipe.choice is not None
    assert map_.swipe.choice.title == "west.tif"


def test_it_begins_with_the_source_that_has_most_pixels_in_the_window(map_: Map, tmp_path: Path) -> None:
    """Footprints are larger than what lies in them; what the operator chose stays."""
    desk = map_.desk
    west = Path(desk.sources[0].source())
    image = gdal.Open(str(west)).ReadAsArray()
    image[..., 300:] = 0  # no data
    half = desk.raster(Path(write_raster(tmp_path / "half.tif", image, nodata=0)))
    desk.set(desk.inputs(sources=(half.id(), desk.sources[1].id())))
    fid = desk.add(BLURRED_WINDOW)
    desk.session.select([fid])
    map_.start()
    wait_until(lambda: desk.session.pictures(fid), "for the pictures")
    map_.wait()
    assert map_.swipe.choice is not None
    assert map_.swipe.choice.title == "east.tif"
    assert "half.tif" not in [choice.title for choice in map_.action.choices()]


def test_the_mended_mosaic_of_the_project(map_: Map, tmp_path: Path) -> None:
    desk = map_.desk
    path = str(tmp_path / "mended.vrt")
    gdal.Translate(path, desk.sources[0].source(), format="VRT")
    mended = desk.raster(Path(path))
    choice = map_.action.choices()[-1]
    assert choice.title == mended.name()
    map_.show([mended, desk.mosaic])
    map_.action.start(choice)
    map_.wait()
    assert same(map_.sides(map_.seen())[1], map_.sides(map_.alone(Path(path)))[1])


def test_the_composite_of_the_selected_window(map_: Map) -> None:
    """Sharp where the mosaic is blurred, the mosaic around it; no file of it is left."""
    desk, before = map_.desk, set(composites_in_memory())
    fid = desk.add(PixelWindow(320, 64, 128, 128))
    desk.session.select([fid])
    composite = map_.action.choices()[-1]
    assert composite.title == "composite"
    map_.action.start(composite)
    map_.swipe.move(0.0)
    map_.wait()
    box = QgsRectangle(*desk.session.mosaic_grid().window_extent(PixelWindow(320, 64, 128, 128)))
    map_.canvas.setExtent(box.scaled(2.5))
    map_.wait()
    mosaic, seen = map_.alone(Path(desk.mosaic.source())), map_.seen()
    to_pixel = map_.canvas.getCoordinateTransform()
    corners = (box.xMinimum(), box.yMaximum()), (box.xMaximum(), box.yMinimum())
    (left, top), (right, below) = ((round(p.x()), round(p.y())) for p in (to_pixel.transform(x, y) for x, y in corners))
    assert same(seen[top + 2 : below, right + 2 :], mosaic[top + 2 : below, right + 2 :])
    inside = np.s_[max(top, 0) + 40 : below - 2, left + 60 : right - 2]
    detail = [np.diff(one[inside].astype(float).mean(axis=2), axis=1).std() for one in (seen, mosaic)]
    assert detail[0] > 1.3 * detail[1]
    assert len({*composites_in_memory()} - before) == 1
    other = desk.add(SHARP_WINDOW)
    desk.session.select([other])
    map_.wait()
    assert map_.swipe.choice is not None
    assert map_.swipe.choice.request.window == SHARP_WINDOW
    map_.swipe.stop()
    assert {*composites_in_memory()} <= before


@pytest.mark.parametrize("way", ["mosaic", "project", "unload"])
def test_nothing_is_left(map_: Map, way: str) -> None:
    """Whatever goes while it is being drawn."""
    map_.action.action.trigger()
    assert map_.swipe.is_on
    if way == "mosaic":
        map_.desk.project.removeMapLayer(map_.desk.mosaic.id())
    elif way == "project":
        map_.desk.project.clear()
    else:
        map_.action.close()
    wait_for_tasks()
    settle(0.05)
    assert not map_.swipe.is_on
    assert map_.left_over()[1:] == map_.before[1:]
    assert map_.left_over()[0] <= map_.before[0]


@pytest.mark.parametrize("way", ["layer", "project"])
def test_no_thread_draws_layers_that_go(map_: Map, way: str) -> None:
    """They share the style of a layer with it."""
    map_.start()
    map_.swipe._draw()
    map_.swipe._draw()  # those before are cancelled, and may be at work yet
    drawing: list[bool] = []

    def look(_ids: list[str]) -> None:
        drawing.extend(job.isActive() for job in map_picture._under_way)

    map_.desk.project.layersWillBeRemoved.connect(look)
    try:
        if way == "layer":
            map_.desk.project.removeMapLayer(map_.desk.seamlines.id())
        else:
            map_.desk.project.clear()
    finally:  # the project outlives the jobs, which must not be asked then
        map_.desk.project.layersWillBeRemoved.disconnect(look)
    assert drawing
    assert not any(drawing)


def test_a_source_that_is_gone_is_told(map_: Map, tmp_path: Path, desk: Desk) -> None:
    write_raster(tmp_path / "gone.tif", orthoimage((256, 512)))
    gone = desk.raster(tmp_path / "gone.tif")
    desk.set(replace(desk.session.inputs, sources=(gone.id(),)))
    (tmp_path / "gone.tif").unlink()
    told: list[str] = []
    map_.action.told.connect(lambda text, _level: told.append(text))
    map_.start()
    assert len(told) == 1
    assert "gone.tif" in told[0]
    assert map_.left_over() == map_.before


# --- the stretch -------------------------------------------------------------------------------------------------


def test_both_sides_have_the_mosaics_stretch(tmp_path: Path, qgis_app: object) -> None:
    ground = orthoimage((256, 512)).astype("u2") * 16
    layers = []
    for name, tone in (("mosaic", 1), ("source", 2)):
        write_raster(tmp_path / f"{name}.tif", ground * tone)
        layers.append(QgsRasterLayer(str(tmp_path / f"{name}.tif"), name))
    mosaic, source = layers
    limits = QgsContrastEnhancement(mosaic.dataProvider().dataType(1))
    limits.setMinimumValue(300)
    limits.setMaximumValue(3000)
    limits.setContrastEnhancementAlgorithm(QgsContrastEnhancement.ContrastEnhancementAlgorithm.StretchToMinimumMaximum)
    mosaic.renderer().setRedContrastEnhancement(limits)
    assert looks_alike(source, mosaic)
    found = source.renderer().redContrastEnhancement()
    assert (found.minimumValue(), found.maximumValue()) == (300, 3000)


def test_another_type_keeps_its_own_stretch(tmp_path: Path, qgis_app: object) -> None:
    write_raster(tmp_path / "mosaic.tif", orthoimage((256, 512)))
    write_raster(tmp_path / "source.tif", orthoimage((256, 512)).astype("u2") * 16)
    write_raster(tmp_path / "grey.tif", orthoimage((256, 512), 1))
    mosaic, source, grey = (QgsRasterLayer(str(tmp_path / f"{n}.tif"), n) for n in ("mosaic", "source", "grey"))
    before = source.renderer().redContrastEnhancement().maximumValue()
    assert not looks_alike(source, mosaic)
    assert not looks_alike(grey, mosaic)
    assert source.renderer().redContrastEnhancement().maximumValue() == before


def test_twofold_desktop_scaling(repository: Path) -> None:
    """The scaling of a process is set when it starts; both sides are drawn in the screen's own pixels."""
    code = (
        "import sys; sys.path.insert(0, 'build/plugins'); sys.path.insert(0, '.')\n"
        "from qgis.core import QgsApplication, QgsProject\n"
        "app = QgsApplication([], True); app.initQgis()\n"
        "from pathlib import Path; import tempfile\n"
        "from tests.qgis.seams.desk import test_swipe as t\n"
        "from tests.qgis.scenes import make_scene\n"
        "folder = Path(tempfile.mkdtemp())\n"
        "desk = t.Desk(make_scene(folder), folder)\n"
        "made = t.Map(desk); made.start()\n"
        "seen, west = made.seen(), made.alone(Path(desk.sources[0].source()))\n"
        "assert seen.shape == west.shape and seen.shape[1] == 2 * made.canvas.viewport().width(), seen.shape\n"
        "assert t.same(seen[:-80, 480:], west[:-80, 480:])\n"
        "assert t.same(seen[:-80, :320], made.alone(Path(desk.mosaic.source()))[:-80, :320])\n"
        "print('same', flush=True); import os; os._exit(0)\n"
    )
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "QT_SCALE_FACTOR": "2"}
    finished = subprocess.run(
        [sys.executable, "-c", code], cwd=repository, env=environment, capture_output=True, text=True, check=False
    )
    assert "same" in finished.stdout, finished.stderr
