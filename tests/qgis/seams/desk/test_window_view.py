"""What the map shows of windows: it goes to them at 2x, and tells whether they are seen."""
from __future__ import annotations

from collections.abc import Iterator

import pytest
from qgis.core import QgsCoordinateReferenceSystem
from qgis.gui import QgsMapCanvas
from seam_inspector.plugin.seams.desk.map.window_view import WindowView

from tests.qgis.scenes import BLURRED, PIXEL, SHARP, layer, line, windows
from tests.qgis.seams.desk.session_desk import Desk

UTM33, WEB = "EPSG:32633", "EPSG:3857"


@pytest.fixture
def canvas(desk: Desk) -> Iterator[QgsMapCanvas]:
    made = QgsMapCanvas()
    made.resize(200, 150)
    made.setDestinationCrs(QgsCoordinateReferenceSystem(UTM33))
    made.show()
    yield made
    made.deleteLater()


@pytest.mark.parametrize(("windows_in", "map_in"), [(32633, UTM33), (4326, UTM33), (4326, WEB), (32633, WEB)])
def test_one_pixel_of_the_image_covers_two_of_the_screen_whatever_the_systems(
    desk: Desk, canvas: QgsMapCanvas, windows_in: int, map_in: str
) -> None:
    canvas.setDestinationCrs(QgsCoordinateReferenceSystem(map_in))
    layer = desk.use(windows(BLURRED, SHARP, epsg=windows_in))
    view = WindowView(canvas, desk.session)
    rows = desk.session.windows()
    for row in rows:
        view.show(row.fid)
        assert desk.session.selected() == [row.fid]
        assert [view.is_seen(row.fid) for row in rows] == [record is row for record in rows]
        stretch = canvas.mapUnitsPerPixel() / (PIXEL / 2)
        assert stretch == pytest.approx(1 if map_in == UTM33 else 1.6, abs=0.35)  # Mercator stretches
    assert layer.crs().authid() == f"EPSG:{windows_in}"


def test_the_map_goes_to_all_of_a_layer(desk: Desk, canvas: QgsMapCanvas) -> None:
    failures = layer("LineString", [line((100, 100), (100, 900))])
    WindowView(canvas, desk.session).show_layer(failures)
    assert canvas.extent().contains(failures.extent())
    assert canvas.extent().height() < 1.5 * failures.extent().height()


def test_the_map_goes_to_a_window_that_is_selected_elsewhere(desk: Desk, canvas: QgsMapCanvas) -> None:
    desk.use(windows(BLURRED, SHARP))
    view = WindowView(canvas, desk.session)
    first, second = desk.session.windows()
    view.show(first.fid)
    before = canvas.extent()
    desk.session.select([first.fid])
    view.follow()
    assert canvas.extent() == before
    desk.session.select([first.fid, second.fid])
    view.follow()
    assert canvas.extent() == before
    desk.session.select([second.fid])
    view.follow()
    assert view.is_seen(second.fid)
