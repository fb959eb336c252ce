"""The curves panel shows the selected windows, draws no more than it must, and saves what it shows."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from qgis.core import QgsProject, QgsVectorLayer
from qgis.PyQt.QtCore import QEvent, QPoint
from qgis.PyQt.QtGui import QColor, QHelpEvent, QPalette
from qgis.PyQt.QtWidgets import QApplication, QFileDialog, QToolTip
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.wavelets import Curve
from seam_inspector.plugin.seams.charts.curves_painter import LegendedCurves
from seam_inspector.plugin.seams.desk.charts.chart_widgets import CurvesChart
from seam_inspector.plugin.seams.desk.charts.curves_tab import CurvesPanel
from seam_inspector.plugin.seams.measure import messages as seams_messages
from seam_inspector.plugin.seams.measure.judgement.verdicts import Judgement, Ratios, Verdict, judge_curves
from seam_inspector.plugin.seams.measure.window.window_result import ClipResult, WindowResult
from seam_inspector.plugin.seams.measure.window_records import WindowRecord
from seam_inspector.plugin.toolkit.charts.chart_style import DARK, PAPER
from seam_inspector.plugin.toolkit.desk.theme import chart_style

from tests.qgis.seams.desk.windows_session import WindowsSession

BANDS = ("luminance", "red", "green", "blue")


class CurvesSession(WindowsSession):
    """A session that holds what the test puts into it."""

    def __init__(self) -> None:
        super().__init__()
        self.is_busy = False
        self.inputs = replace(self.inputs, max_ratio=0.5, reference="sources")

    def add(self, fid: int, result: WindowResult) -> None:
        self.results[fid] = result
        row = WindowRecord(result.window_id, None, result.judgement.verdict.value, fid=fid)
        self.rows = [*(other for other in self.rows if other.fid != fid), row]
        self.resultArrived.emit(fid)

    def clips(self, fid: int) -> WindowResult | None:
        return self.results.get(fid)

    def is_pending(self, fid: int) -> bool:
        return self.is_busy


def make_curve(level_1: float) -> Curve:
    detail = (level_1, 2.2 * level_1 + 0.01, 0.07 + level_1)
    return Curve(detail, 1 - sum(detail), 900.0)


def make_result(
    window_id: int = 12, sources: int = 2, level_1: float = 0.016, bands: tuple[str, ...] = BANDS
) -> WindowResult:
    """A mosaic with ``level_1`` in luminance, and sources with 0.039, 0.042, ..."""
    clips = [ClipResult("mosaic.tif", "mosaic", {b: make_curve(level_1 * (1 + i / 9)) for i, b in enumerate(bands)})]
    clips += [
        ClipResult(
            f"ortho_2024_flight_0412_{31 + n:04}.tif",
            "source",
            {b: make_curve((0.039 + 0.003 * n) * (1 + i / 9)) for i, b in enumerate(bands)},
        )
        for n in range(sources)
    ]
    judgement = judge_curves(clips[0].curves[bands[0]], [clip.curves[bands[0]] for clip in clips[1:]])
    return WindowResult(window_id, PixelWindow(0, 0, 512, 512), judgement, judgement.verdict, tuple(clips))


def not_comparable(window_id: int) -> WindowResult:
    nothing = Ratios((None, None, None), None)
    judgement = Judgement(Verdict.NOT_COMPARABLE, nothing, seams_messages.NO_SOURCES())
    return WindowResult(window_id, None, judgement, judgement.verdict)


def settle(times: int = 4) -> None:
    """Let timers, drawings and paintings happen."""
    for _ in range(times):
        QApplication.processEvents()


def wait_for_timer(panel: CurvesPanel) -> None:
    while panel._timer.isActive():
        QApplication.processEvents()
    settle()


@pytest.fixture
def session(qgis_app: object) -> CurvesSession:
    return CurvesSession()


@pytest.fixture
def panel(session: CurvesSession) -> Iterator[CurvesPanel]:
    made = CurvesPanel(session)
    made.resize(420, 300)
    made.show()
    settle()
    yield made
    made.close()
    made.deleteLater()


def text_of(panel: CurvesPanel) -> str:
    """What stands in place of the chart; empty when the chart is there."""
    return panel._text.text() if panel._pages.currentWidget() is panel._text else ""


def painter(panel: CurvesPanel) -> LegendedCurves:
    made = panel._chart.painter()
    assert made is not None
    return made


def labels(panel: CurvesPanel) -> list[str]:
    """The names in the legend, of curves that are all drawn."""
    chart = panel._chart.chart
    assert len(painter(panel).places) == 4 * len(chart.curves)
    return [entry.name for entry in painter(panel).entries]


def seen(panel: CurvesPanel, point: tuple[int, int]) -> QColor:
    """The chart's colour on a point of a curve."""
    x, y = place_of(panel, point)
    return panel._chart.grab().toImage().pixelColor(round(x), round(y))


def place_of(panel: CurvesPanel, point: tuple[int, int]) -> tuple[float, float] | None:
    place = painter(panel).places.get(point)
    return None if place is None else (place.x(), place.y())


def select_one(session: CurvesSession, result: WindowResult | None = None) -> None:
    session.add(1, result or make_result())
    session.select([1])
    settle()


# words in place of the chart


def test_it_says_why_there_is_nothing_to_draw(session: CurvesSession, panel: CurvesPanel) -> None:
    assert text_of(panel).startswith("Select a window")

    session.rows = [WindowRecord(12, None, fid=1)]
    session.select([1])
    settle()
    assert text_of(panel) == "Not inspected yet"

    session.is_busy = True
    session.progressChanged.emit(0, 1)
    wait_for_timer(panel)
    assert text_of(panel) == "Measuring ..."

    session.add(1, not_comparable(12))
    settle()
    assert text_of(panel) == "This window can't be compared."  # its sentence says why
    assert not panel._save.isEnabled()

    session.add(1, make_result())
    settle()
    assert text_of(panel) == ""
    assert panel._save.isEnabled()


# the chart


def test_one_window_shows_mosaic_sources_and_limit(session: CurvesSession, panel: CurvesPanel) -> None:
    select_one(session)
    assert labels(panel) == [
        "mosaic.tif", "ortho_2024_flight_0412_0031.tif", "ortho_2024_flight_0412_0032.tif", "limit",
    ]
    assert panel._chart.chart.curves[0].values == pytest.approx([0.016, 0.0452, 0.086, 0.8528])
    placed = painter(panel)
    for component, share in enumerate((0.016, 0.0452, 0.086, 0.8528)):
        place = placed.places[0, component]
        assert (place.x(), place.y()) == pytest.approx((placed.x_of(component), placed.y_of(share)))
        assert seen(panel, (0, component)) == QColor(chart_style(panel._chart).text)
    assert placed.limit == pytest.approx(0.5 * 0.039)
    picture = panel._chart.grab().toImage()
    x, y = round(placed.x_of(-0.2)), round(placed.y_of(placed.limit))
    assert QColor(PAPER.limit) in [picture.pixelColor(x, y + away) for away in (-1, 0, 1)]
    assert panel._status.text() == "Window 12"


def test_sources_of_the_table_that_have_no_curve_are_told(session: CurvesSession, panel: CurvesPanel) -> None:
    session.add(1, make_result(sources=2))
    session.rows = [replace(row, sources=4) for row in session.rows]
    session.select([1])
    wait_for_timer(panel)
    assert panel._status.text() == "Window 12; 2 more sources cover a part"
    session.rows = [replace(row, sources=2) for row in session.rows]
    session.selectionChanged.emit()
    wait_for_timer(panel)
    assert panel._status.text() == "Window 12"


def test_a_tip_says_the_value_of_the_point_under_the_mouse(session: CurvesSession, panel: CurvesPanel) -> None:
    select_one(session)
    chart = panel.findChild(CurvesChart)
    place = chart.painter().places[0, 0].toPoint()
    for at, is_near in ((place, True), (place + QPoint(0, 40), False)):
        QApplication.sendEvent(chart, QHelpEvent(QEvent.Type.ToolTip, at, chart.mapToGlobal(at)))
        assert (QToolTip.text() == "mosaic.tif, level 1: 0.016") == is_near


def test_of_many_sources_as_many_stand_in_the_legend_as_there_is_room_for(
    session: CurvesSession, panel: CurvesPanel
) -> None:
    panel.resize(420, 300)
    select_one(session, make_result(sources=40))
    names = labels(panel)
    assert names[:2] == ["mosaic.tif", "0031"]  # what all share says nothing where it has no room
    assert names[-1] == f"and {43 - len(names)} more"  # of 42 names and this one


# when it draws


def test_it_takes_its_colours_from_the_palette(session: CurvesSession, panel: CurvesPanel) -> None:
    select_one(session)
    assert seen(panel, (2, 1)) == QColor(PAPER.sources[1])
    dark = QPalette(panel.palette())
    dark.setColor(QPalette.ColorRole.Base, QColor("#232629"))
    dark.setColor(QPalette.ColorRole.Text, QColor("#eff0f1"))
    panel.setPalette(dark)
    settle(8)
    assert seen(panel, (2, 1)) == QColor(DARK.sources[1])
    image = panel._chart.grab().toImage()
    assert image.pixelColor(1, 1).name() == "#232629"


# save


def save(panel: CurvesPanel, monkeypatch: pytest.MonkeyPatch, path: Path) -> list[str]:
    """What is said."""
    said: list[str] = []
    panel._save.notified.connect(lambda text, _level: said.append(text))
    monkeypatch.setattr(QFileDialog, "getSaveFileName", staticmethod(lambda *_: (str(path), "")))
    panel._save.click()
    return said


@pytest.mark.parametrize("ending", ["png"])
def test_no_layer_of_the_project_is_written_over(
    session: CurvesSession, panel: CurvesPanel, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, project: QgsProject,
    ending: str,
) -> None:
    select_one(session)
    path = tmp_path / f"points.{ending}"
    path.write_text("x\n1\n")
    project.addMapLayer(QgsVectorLayer(f"file://{path}?type=csv", "points", "delimitedtext"))
    assert "which belongs to an input; choose another file" in save(panel, monkeypatch, path)[0]
    assert path.read_text() == "x\n1\n"


@pytest.mark.parametrize(("name", "start"), [("a.png", b"\x89PNG"), ("a", b"\x89PNG")])
def test_pictures(
    session: CurvesSession, panel: CurvesPanel, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, name: str, start: bytes
) -> None:
    select_one(session)
    said = save(panel, monkeypatch, tmp_path / name)
    path = tmp_path / (name if "." in name else f"{name}.png")
    assert path.read_bytes().startswith(start)
    assert said == [f"The picture was saved to {path}."]
