"""A click on a piece of a scanned seam says what was found there, and a window is made of it."""
from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from qgis.core import QgsPointXY, QgsRectangle, QgsVectorLayer
from qgis.gui import QgsMapCanvas, QgsMapToolPan, QgsRubberBand
from qgis.PyQt.QtCore import QPoint, Qt
from qgis.PyQt.QtTest import QTest
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.charts.profile_painter import bin_words
from seam_inspector.plugin.seams.desk.charts.curves_tab import CurvesAndProfile
from seam_inspector.plugin.seams.desk.judge_bar import JudgeBar
from seam_inspector.plugin.seams.desk.judging import Judging
from seam_inspector.plugin.seams.desk.map.window_tool import ClickedPieces

from tests.numbers.synthetic import write_raster
from tests.qgis.acceptance.seam_scenes import file, sealed
from tests.qgis.scenes import at, layer, line, whole
from tests.qgis.seams.desk.session_desk import Desk, settle, wait_until

KEPT = 0.31
OUTSIDE = 500  # where the mosaic has no pixels
BESIDE_NODATA = line((470, 0), (470, 256)), line((OUTSIDE, 0), (OUTSIDE, 256))


class Map:
    """The desk's map with a scanned seam down its middle, and the bar below the list of windows."""

    def __init__(self, desk: Desk, canvas: QgsMapCanvas, folder: Path) -> None:
        self.desk, self.canvas = desk, canvas
        pixels = whole(Path(desk.mosaic.source()))
        pixels[..., 480:] = 0  # nodata
        desk.mosaic = desk.raster(Path(write_raster(folder / "mosaic.tif", pixels, nodata=0)))
        desk.set(desk.inputs())
        made = sealed(layer(
            "LineString", [line((256, 0), (256, 256)), *BESIDE_NODATA], kept_1=("double", [KEPT, 0.57, 0.48]),
            kept_low=("double", [KEPT - 0.05, 0.5, 0.4]), kept_high=("double", [KEPT + 0.05, 0.6, 0.5]),
            band_width=("double", [2.0, 1.0, 1.0]), verdict=("string", ["significant"] * 3),
            profile=("string", ["0 1 0.310; 0 0.2 0.250; 0.2 0.4 0.400", "0 1 0.570; 0 0.2 0.500; 0.8 1.2 0.700", ""]),
        ))  # fmt: skip
        made.setName("seams")
        self.seams = QgsVectorLayer(f"{file(made, folder / 'seams.gpkg')}|layername=seams", "Seams", "ogr")
        self.seams.setCustomProperty("seam_inspector/made_for", desk.mosaic.id())
        self.seams.setCustomProperty("seam_inspector/scanned", "2026-01-01")
        desk.project.addMapLayer(self.seams)
        canvas.resize(400, 300)
        canvas.setDestinationCrs(desk.mosaic.crs())
        canvas.setLayers([self.seams, desk.mosaic])
        canvas.setExtent(desk.mosaic.extent())
        self.tool = QgsMapToolPan(canvas)
        canvas.setMapTool(self.tool)
        self.is_blind = False
        self.pieces = ClickedPieces(canvas, desk.session, canvas, lambda: self.is_blind)
        self.judging = Judging(desk.session)
        self.bar = JudgeBar(desk.session, self.judging, self.pieces)
        self.charts = CurvesAndProfile(desk.session)
        self.charts.show()

    def click(self, column: float, row: float) -> None:
        place = self.canvas.getCoordinateTransform().transform(QgsPointXY(*at(column, row)))
        pixel = QPoint(round(place.x()), round(place.y()))
        QTest.mouseClick(self.canvas.viewport(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, pixel)
        settle()

    def close(self) -> None:
        self.pieces.close()
        self.charts.close()
        self.charts.deleteLater()
        self.judging.close()
        self.canvas.unsetMapTool(self.tool)
        self.bar.deleteLater()


@pytest.fixture
def shown(desk: Desk, qgis_canvas: QgsMapCanvas, tmp_path: Path) -> Iterator[Map]:
    made = Map(desk, qgis_canvas, tmp_path)
    yield made
    made.close()
    settle()


@pytest.mark.parametrize(("column", "lost"), [(256, 69), (470, 43)])
def test_a_click_on_a_piece_says_what_was_found_and_offers_a_window(shown: Map, column: int, lost: int) -> None:
    """Beside ground without pixels a window that holds none of it."""
    session = shown.desk.session
    shown.click(column, 128)
    assert f"{lost} % of detail lost in 1.6 m along the seam" in shown.bar.sentence()
    wait_until(lambda: session.live is not None, "for the charts")
    (mark,) = [item for item in shown.canvas.scene().items() if isinstance(item, QgsRubberBand) and item.size()]
    assert mark.asGeometry().equals(line((column, 0), (column, 256)))
    assert shown.pieces.judge()
    shown.desk.wait()
    (row,) = session.windows()
    assert row.verdict
    assert session.selected() == [row.fid]
    assert shown.desk.session.piece is None
    assert QgsRectangle(*row.extent).contains(QgsPointXY(*at(column, 128)))


def test_a_piece_where_no_window_has_pixels_stays_in_view(shown: Map) -> None:
    session = shown.desk.session
    shown.click(OUTSIDE, 128)
    said = shown.bar.sentence()
    assert "52 % of detail lost" in said
    assert shown.pieces.judge()
    shown.desk.wait()
    assert shown.desk.messages == ["No window there: pixels are missing. Draw a smaller one beside the edge."]
    assert (session.windows(), shown.bar.sentence()) == ([], said)
    assert session.piece is not None


def test_elsewhere_blind_or_with_another_tool_a_click_is_the_tools(shown: Map) -> None:
    shown.click(256, 128)
    shown.canvas.setExtent(shown.desk.mosaic.extent())  # the pan tool goes where it clicks
    shown.click(100, 128)
    assert shown.desk.session.piece is None
    assert "By the scan" not in shown.bar.sentence()
    shown.canvas.setExtent(shown.desk.mosaic.extent())
    shown.is_blind = True
    shown.click(256, 128)
    assert shown.desk.session.piece is None
    shown.is_blind = False
    shown.click(256, 128)
    assert shown.desk.session.piece is not None
    shown.canvas.unsetMapTool(shown.tool)
    assert shown.desk.session.piece is None
    shown.click(256, 128)
    assert shown.desk.session.piece is None


def test_the_charts_are_never_those_of_another_piece(shown: Map) -> None:
    session, charts = shown.desk.session, shown.charts
    shown.click(256, 128)
    wait_until(lambda: session.live is not None and charts.curves.shown, "for the curves")
    profile = charts.profile.chart.shown
    assert profile is not None
    assert [bin_.kept for bin_ in profile.bins(1)] == [0.25, 0.4]
    assert bin_words(profile, profile.bins(1)[0]) == "0.00 to 0.20 m: 25 % kept"
    shown.canvas.setExtent(shown.desk.mosaic.extent())  # the pan tool goes where it clicks
    shown.click(470, 128)
    assert "43 % of detail lost" in shown.bar.sentence()
    profile = charts.profile.chart.shown
    assert profile is not None
    assert [bin_.kept for bin_ in profile.bins(1)] == [0.5, 0.7]
    assert charts.profile.chart.isVisible()
    shown.pieces.leave()
    settle()
    assert not charts.profile.chart.isVisible()


def test_a_piece_in_a_window_is_judged_there(shown: Map) -> None:
    session = shown.desk.session
    session.add_window(PixelWindow(400, 64, 72, 128))
    shown.desk.wait()
    (row,) = session.windows()
    session.select([])
    shown.click(470, 128)
    assert session.piece is not None
    assert shown.pieces.judge()
    shown.desk.wait()
    assert [window.window_id for window in session.windows()] == [row.window_id]
    assert session.selected() == [row.fid]
