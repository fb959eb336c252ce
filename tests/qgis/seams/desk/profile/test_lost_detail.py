"""Lost detail on the map: where it lies, whatever way the map is turned, and what is left afterwards."""
from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsNullSymbolRenderer,
    QgsPalLayerSettings,
    QgsPointXY,
    QgsRectangle,
    QgsVectorLayerSimpleLabeling,
)
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtWidgets import QApplication
from seam_inspector.plugin.seams.desk.map.lost_detail import (
    LossLegend,
    LossOverlay,
    PictureOverlay,
    PlacedPicture,
    rgba_image,
)

from tests.qgis.scenes import layer
from tests.qgis.seams.desk.profile.profile_desk import SEAM_COLUMN, WINDOW, ProfileSession, on_map
from tests.qgis.seams.desk.session_desk import settle, wait_until

UTM33 = QgsCoordinateReferenceSystem("EPSG:32633")
MAPS = [("EPSG:32633", 0.0), ("EPSG:32633", 33.0), ("EPSG:3857", 0.0), ("EPSG:4326", -50.0)]


@pytest.fixture(params=MAPS)
def canvas(qgis_app: QApplication, request: pytest.FixtureRequest) -> Iterator[QgsMapCanvas]:
    """A map on all of the window, in some reference system and some way round."""
    code, rotation = request.param
    canvas = QgsMapCanvas()
    canvas.resize(500, 500)
    canvas.setDestinationCrs(QgsCoordinateReferenceSystem(code))
    canvas.setRotation(rotation)
    corners = [on_map(WINDOW.column + x, WINDOW.row + y, canvas.mapSettings().destinationCrs())
               for x in (-20, WINDOW.width + 20) for y in (-20, WINDOW.height + 20)]  # fmt: skip
    canvas.setExtent(QgsRectangle(*np.min(corners, axis=0), *np.max(corners, axis=0)))
    canvas.show()
    settle(0.1)
    yield canvas
    canvas.close()
    canvas.deleteLater()
    settle()


def colour_at(canvas: QgsMapCanvas, column: float, row: float) -> QColor:
    """On the screen, of a place in the window's pixels."""
    place = on_map(WINDOW.column + column, WINDOW.row + row, canvas.mapSettings().destinationCrs())
    pixel = canvas.getCoordinateTransform().transform(QgsPointXY(*place))
    return QColor(canvas.grab().toImage().pixel(round(pixel.x()), round(pixel.y())))


def is_on(colour: QColor) -> bool:
    return colour.getRgb()[:3] != (255, 255, 255)


def test_every_pixel_lies_where_it_is_on_the_ground(canvas: QgsMapCanvas) -> None:
    """Squares of 20 px in turn, up to two pixels from their edges."""
    overlay = PictureOverlay(canvas)
    row, column = np.mgrid[:6, :5]
    rgba = np.zeros((6, 5, 4), np.uint8)
    rgba[(row + column) % 2 == 0] = (200, 0, 0, 255)
    session = ProfileSession()
    extent = session.grid.window_extent(WINDOW)
    overlay.show([PlacedPicture(rgba_image(np.kron(rgba, np.ones((20, 20, 1), np.uint8))), extent, extent)], UTM33)
    settle()
    for y in range(6):
        for x in range(5):
            for off_y, off_x in ((2, 2), (2, 18), (18, 2), (18, 18)):
                seen = colour_at(canvas, 20 * x + off_x, 20 * y + off_y)
                assert is_on(seen) == ((x + y) % 2 == 0), (x, y, off_x, off_y)
    overlay.hide()
    settle()
    assert not is_on(colour_at(canvas, 10, 10))
    overlay.close()


def test_labels_are_not_covered(canvas: QgsMapCanvas) -> None:
    outline = [on_map(WINDOW.column + x, WINDOW.row + y, UTM33) for x, y in ((0, 0), (WINDOW.width, WINDOW.height))]
    (x1, y1), (x2, y2) = outline
    shown = layer("Polygon", [QgsGeometry.fromRect(QgsRectangle(x1, y2, x2, y1))], window_id=("integer", [7777777]))
    shown.setCrs(UTM33)
    shown.setRenderer(QgsNullSymbolRenderer())
    settings = QgsPalLayerSettings()
    settings.fieldName = "window_id"
    shown.setLabeling(QgsVectorLayerSimpleLabeling(settings))
    shown.setLabelsEnabled(True)
    canvas.setLayers([shown])
    wait_until(lambda: canvas.labelingResults() is not None and canvas.labelingResults().allLabels(), "for the label")
    (label,) = canvas.labelingResults().allLabels()
    overlay = PictureOverlay(canvas)
    around, red = (x1, y2, x2, y1), rgba_image(np.array([[[255, 0, 0, 255]]], np.uint8))
    overlay.show([PlacedPicture(red, around, around)], UTM33)
    settle(0.1)
    image, place = canvas.grab().toImage(), canvas.getCoordinateTransform()
    middle = place.transform(label.labelGeometry.centroid().asPoint())
    reds = {}
    for reach in (2, 40):
        pixels = [QColor(image.pixel(round(middle.x()) + x, round(middle.y()) + y))
                  for x in range(-reach, reach + 1) for y in range(-reach, reach + 1)]  # fmt: skip
        reds[reach] = sum(colour.red() > colour.green() + 60 for colour in pixels)
    overlay.close()
    assert reds[2] == 0
    assert reds[40] > 500


def test_loss_is_shown_while_it_is_switched_on_and_ends_with_the_window(canvas: QgsMapCanvas) -> None:
    session = ProfileSession()
    before = len(canvas.scene().items())
    overlay = LossOverlay(canvas, session)
    assert overlay._overlay.pictures == ()
    session.lost_detail.toggle()
    settle()
    (legend,) = canvas.findChildren(LossLegend)
    assert legend.isVisible()
    assert legend.geometry().right() < canvas.width()
    legend.hide()  # the map may be seen behind it
    seen = colour_at(canvas, SEAM_COLUMN + 4, 60)
    assert seen.red() > 200
    assert 80 < seen.green() < 190  # the white map is seen through it
    for column in (10, SEAM_COLUMN - 10, SEAM_COLUMN + 20, 90, 103):
        assert not is_on(colour_at(canvas, column, 60)), column
    assert is_on(colour_at(canvas, SEAM_COLUMN + 4, 118))
    assert not is_on(colour_at(canvas, SEAM_COLUMN + 4, 123))
    session.lost_detail.toggle()
    settle()
    assert overlay._overlay.pictures == ()
    overlay.close()
    settle()
    assert len(canvas.scene().items()) == before
    assert canvas.findChildren(LossLegend) == []


def test_results_that_come_are_painted_and_those_of_changed_windows_are_not(qgis_app: QApplication) -> None:
    canvas, session = QgsMapCanvas(), ProfileSession()
    values, session.results = session.results, {}
    overlay = LossOverlay(canvas, session)
    session.lost_detail.setChecked(True)
    (legend,) = canvas.findChildren(LossLegend)
    session.results = values
    session.resultArrived.emit(1)
    wait_until(lambda: len(overlay._overlay.pictures) == 1)
    assert "50 % kept, or less" in legend.text()
    session.change(1, stale=True)
    session.windowsChanged.emit()
    wait_until(lambda: not overlay._overlay.pictures)
    overlay.close()
