"""The noise tab: what it measures and when, what it draws, and what it says."""
from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.colors import same_color
from matplotlib.transforms import Bbox
from qgis.core import QgsApplication, QgsProject
from qgis.PyQt.QtCore import QLocale
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtWidgets import QComboBox
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.noise.desk import noise_panel
from seam_inspector.plugin.noise.desk.noise_chart import NoiseDrawing, figure
from seam_inspector.plugin.noise.desk.noise_panel import NoisePanel
from seam_inspector.plugin.noise.measure.band_noise import noisiest_band
from seam_inspector.plugin.noise.measure.group_noise import ClipNoise, measure_window
from seam_inspector.plugin.noise.noise_summary import NO_GROUP, CurveGroup
from seam_inspector.plugin.toolkit.charts.chart_style import PAPER

from tests.numbers.synthetic import patchy_texture, write_raster
from tests.qgis.scenes import COLUMNS, ROWS, Scene, outline, windows
from tests.qgis.seams.desk.session_desk import Desk, settle, wait_for_tasks, wait_until

BOX, HOLE, FLAT = (64, 32, 128, 128), (256, 32, 128, 128), (384, 128, 128, 128)
"""Windows on the ground, on pixels without data, and on water of one value."""
SIGMA = 12.0
"""Noise added to the eastern source, DN."""


@pytest.fixture(scope="module")
def noisy_scene(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    """Smooth ground: a clean mosaic with a hole and flat water, a noisy source, and its western half."""
    folder = tmp_path_factory.mktemp("noisy")
    one = patchy_texture((ROWS, COLUMNS), 3.0, 4)
    ground = np.rint(120 + 30 * np.stack([one] * 3)).clip(1, 254).astype(np.uint8)
    column, row, width, height = HOLE
    mosaic = ground.copy()
    mosaic[:, row : row + height, column : column + width] = 0
    column, row, width, height = FLAT
    mosaic[:, row : row + height, column : column + width] = 77
    added = ground + np.random.default_rng(3).normal(0, SIGMA, ground.shape)
    noisy = np.clip(np.rint(added), 1, 255).astype(np.uint8)
    scene = Scene(folder / "clean.tif", folder / "noisy.tif", folder / "west.tif")
    write_raster(scene.mosaic, mosaic, nodata=0)
    write_raster(scene.west, noisy, nodata=0)
    write_raster(scene.east, noisy[:, :, : COLUMNS // 2], nodata=0)
    return scene


@pytest.fixture
def desk(noisy_scene: Scene, project: QgsProject, tmp_path: Path) -> Iterator[Desk]:
    made = Desk(noisy_scene, tmp_path)
    made.use(windows(BOX, HOLE, FLAT))
    yield made
    made.session.close()
    wait_for_tasks()
    project.clear()


@pytest.fixture
def panel(desk: Desk) -> Iterator[NoisePanel]:
    made = NoisePanel(desk.session)
    made._loader.join()
    made.resize(600, 600)
    made.show()
    settle()
    yield made
    made.close()
    made.deleteLater()


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[RasterRef]:
    """The rasters that were measured, in their order."""
    seen: list[RasterRef] = []

    def noted(ref: RasterRef, window: PixelWindow) -> ClipNoise:
        seen.append(ref)
        return measure_window(ref, window)

    monkeypatch.setattr(noise_panel, "measure_window", noted)
    return seen


def box(panel: NoisePanel) -> QComboBox:
    return panel.findChild(QComboBox)


def rasters(panel: NoisePanel) -> list[str]:
    return [box(panel).itemText(index) for index in range(box(panel).count())]


def choose(panel: NoisePanel, index: int) -> None:
    box(panel).setCurrentIndex(index)
    box(panel).activated.emit(index)


def words(panel: NoisePanel) -> str:
    """The sentence below the chart, or the one in place of it."""
    is_chart = panel._chart is not None and panel._pages.currentWidget() is panel._chart
    return panel._words.text() if is_chart else panel._text.text()


def select(desk: Desk, panel: NoisePanel, fid: int) -> str:
    """What it says about a window."""
    desk.session.select([fid])
    return wait_for_words(panel)


def wait_for_words(panel: NoisePanel) -> str:
    settle()
    wait_until(lambda: not words(panel).startswith("Measuring"), "for the noise")
    chart = panel._chart
    if chart is not None and panel._pages.currentWidget() is chart:
        wait_until(lambda: chart.is_drawn, "for the chart")
    return words(panel)


# what it shows


def test_a_clean_and_a_noisy_raster(desk: Desk, panel: NoisePanel) -> None:
    clean = select(desk, panel, 1)
    assert rasters(panel) == ["clean.tif (mosaic)", "noisy.tif", "west.tif"]
    assert clean.startswith("Low noise: the curve rises at every level; in red sigma ")
    column, row, width, height = BOX
    for index, name in enumerate(("mosaic", "source")):
        choose(panel, index)
        said = wait_for_words(panel)
        layer = desk.mosaic if name == "mosaic" else desk.sources[0]
        expected = measure_window(RasterRef(layer.source()), PixelWindow(column, row, width, height)).bands
        assert panel._chart.bands == expected
        judged = expected[noisiest_band(expected)]
        assert f"sigma {judged.sigma:.2f} DN" in said
        assert f"kurtosis of level 1: {judged.kurtosis[0]:.1f}" in said
        tip = panel._words.toolTip()
        assert all(f"sigma {noise.sigma:.2f} DN" in tip for noise in expected.values())
    assert said.startswith("Strong noise: the curve falls from level 1 to 2 and from 2 to 3; in blue sigma ")
    assert expected["green"].sigma == pytest.approx(SIGMA, rel=0.05)


def test_the_curves_and_the_rule_are_in_the_picture(desk: Desk, panel: NoisePanel) -> None:
    select(desk, panel, 1)
    request = panel._chart._request()
    (axes,) = figure(request).axes
    lines = {line.get_label(): line for line in axes.get_lines()}
    assert set(request.bands) == {"luminance", "red", "green", "blue"}
    for name, noise in request.bands.items():
        assert tuple(lines[name].get_ydata()) == noise.curve.detail
    limit = [line.get_ydata()[0] for line in axes.get_lines() if same_color(line.get_color(), request.style.limit)]
    assert limit == pytest.approx(request.bands[noisiest_band(request.bands)].curve.detail[:-1])
    texts = [text.get_text() for text in axes.figure.legends[0].get_texts()]
    assert texts == ["luminance", "red", "green", "blue", "bold curve in the red: noise"]
    image = panel._chart.grab().toImage()
    seen = {QColor(image.pixel(x, y)).name() for x in range(image.width()) for y in range(image.height())}
    assert {request.style.limit, request.style.text, request.style.background} <= seen


@pytest.mark.parametrize(("width", "height"), [(420, 320), (420, 500), (1000, 180), (420, 130), (200, 100)])
def test_nothing_of_the_chart_is_cut_off(desk: Desk, panel: NoisePanel, width: int, height: int) -> None:
    select(desk, panel, 1)
    request = panel._chart._request()
    made = figure(NoiseDrawing(request.bands, PAPER, request.room._replace(width=width, height=height)))
    renderer, whole, (axes,) = made.canvas.get_renderer(), made.bbox, made.axes
    parts = [axes.get_tightbbox(renderer), *(legend.get_window_extent(renderer) for legend in made.legends)]
    for part in parts:
        assert (part.x0, part.y0) >= (-1, -1)
        assert part.x1 <= whole.x1 + 1
        assert part.y1 <= whole.y1 + 1
    assert len(parts) == (1 if height < 150 else 2)  # a low one does without its legend
    if len(parts) == 2:
        shared = Bbox.intersection(*parts)
        assert shared is None or min(shared.width, shared.height) < 1
    assert axes.bbox.height > 0.35 * whole.height
    assert axes.bbox.width > 0.5 * whole.width


def test_a_window_that_cant_be_measured_says_why(desk: Desk, panel: NoisePanel) -> None:
    assert words(panel) == "Select a window, in the table or on the map, to see its noise."
    assert "100.00\u00a0% of the pixels of clean.tif are invalid in the window" in select(desk, panel, 2)
    assert panel._words.text() == ""
    assert select(desk, panel, 3).startswith("clean.tif has no variance in red here")
    choose(panel, 1)
    assert wait_for_words(panel).startswith("Strong noise: the curve falls from level 1 to 2 and from 2 to 3; in ")


def test_a_file_that_is_gone_says_so(desk: Desk, panel: NoisePanel, tmp_path: Path) -> None:
    request = desk.session.request(1)
    gone = replace(request.sources[0], ref=RasterRef(str(tmp_path / "gone.tif")))
    desk.session.request = lambda fid: replace(request, sources=(gone,))  # type: ignore[method-assign]
    select(desk, panel, 1)
    choose(panel, 1)
    assert wait_for_words(panel).endswith("gone.tif does not exist; check the path.")


def test_the_source_chosen_is_kept_where_it_covers_the_window(desk: Desk, panel: NoisePanel) -> None:
    select(desk, panel, 1)
    choose(panel, 2)
    wait_for_words(panel)
    select(desk, panel, 3)
    assert rasters(panel) == ["clean.tif (mosaic)", "noisy.tif"]
    assert box(panel).currentIndex() == 0
    select(desk, panel, 1)
    assert box(panel).currentText() == "west.tif"


def test_numbers_are_written_as_in_the_users_country(desk: Desk, panel: NoisePanel) -> None:
    before = QLocale()
    QLocale.setDefault(QLocale("pl_PL"))
    try:
        said = select(desk, panel, 1)
    finally:
        QLocale.setDefault(before)
    assert "," in said.split("sigma ")[1].split(" DN")[0]


# when it measures


def test_nothing_is_read_out_of_sight(desk: Desk, panel: NoisePanel, asked: list[RasterRef]) -> None:
    panel.hide()
    desk.session.select([1])
    settle(0.2)
    desk.session.select([3])
    wait_for_tasks()
    assert asked == []
    panel.show()
    wait_for_words(panel)
    assert len(asked) == 1


def test_what_was_measured_is_not_measured_again(desk: Desk, panel: NoisePanel, asked: list[RasterRef]) -> None:
    for fid in (1, 3, 1, 3):
        select(desk, panel, fid)
    assert len(asked) == 2
    desk.set(replace(desk.session.inputs, sources=desk.session.inputs.sources[:1]))  # there may be other files now
    wait_until(lambda: len(asked) == 3)


def test_a_window_that_moves_is_measured_anew(desk: Desk, panel: NoisePanel, asked: list[RasterRef]) -> None:
    before = select(desk, panel, 1)
    desk.layer().startEditing()
    desk.layer().changeGeometry(1, outline((0, 0, 64, 64)))
    wait_until(lambda: len(asked) == 2)
    assert wait_for_words(panel) != before


@pytest.fixture
def slow(monkeypatch: pytest.MonkeyPatch) -> Iterator[dict[str, Any]]:
    """A measurement that waits until it may end, and tells when it has begun."""
    state = {"begun": 0, "may_end": False}

    def wait(ref: RasterRef, window: PixelWindow) -> ClipNoise:
        state["begun"] += 1
        while not state["may_end"]:
            time.sleep(0.002)
        return measure_window(ref, window)

    monkeypatch.setattr(noise_panel, "measure_window", wait)
    yield state
    state["may_end"] = True
    wait_for_tasks()


def test_closing_while_measuring(desk: Desk, panel: NoisePanel, slow: dict[str, Any]) -> None:
    desk.session.select([1])
    wait_until(lambda: slow["begun"])
    assert words(panel) == "Measuring ..."
    panel.close()
    desk.session.close()
    slow["may_end"] = True
    wait_for_tasks()
    assert panel._results == {}


def test_hiding_while_measuring(desk: Desk, panel: NoisePanel, slow: dict[str, Any]) -> None:
    desk.session.select([1])
    wait_until(lambda: slow["begun"])
    panel.hide()
    slow["may_end"] = True
    wait_for_tasks()
    panel.show()
    assert wait_for_words(panel).startswith("Low noise")


@pytest.mark.parametrize("how", ["project", "mosaic", "window"])
def test_what_is_measured_vanishes(desk: Desk, panel: NoisePanel, slow: dict[str, Any], how: str) -> None:
    desk.session.select([1])
    wait_until(lambda: slow["begun"])
    steps: dict[str, Callable[[], object]] = {
        "project": desk.project.clear,
        "mosaic": lambda: desk.project.removeMapLayers([desk.mosaic.id()]),
        "window": lambda: desk.session.remove([1]),
    }
    steps[how]()
    slow["may_end"] = True
    wait_for_tasks()
    assert words(panel).startswith("No mosaic is chosen" if how == "mosaic" else "Select a window")
    assert not box(panel).isEnabled()


def test_a_task_that_is_stopped_leaves_nobody_waiting(desk: Desk, panel: NoisePanel, slow: dict[str, Any]) -> None:
    desk.session.select([1])
    wait_until(lambda: slow["begun"])
    for task in QgsApplication.taskManager().activeTasks():
        task.cancel()
    slow["may_end"] = True
    assert wait_for_words(panel).startswith("The measurement was stopped.")
    desk.session.select([])
    assert select(desk, panel, 1).startswith("Low noise")


def test_the_chart_of_before_is_dimmed_meanwhile(desk: Desk, panel: NoisePanel, slow: dict[str, Any]) -> None:
    slow["may_end"] = True
    select(desk, panel, 1)
    slow["may_end"] = False
    choose(panel, 1)
    wait_until(lambda: slow["begun"] == 2)
    assert not panel._chart.isEnabled()
    assert panel._words.text() == "Measuring ..."
    slow["may_end"] = True
    assert wait_for_words(panel).startswith("Strong noise")
    assert panel._chart.isEnabled()


# groups of windows

NEXT_BOX = (64, 100, 128, 128)


def group(panel: NoisePanel) -> CurveGroup:
    """Group that is drawn behind the curves of the selected window."""
    chart = panel._chart
    return NO_GROUP if chart is None else chart._group


def range_words(panel: NoisePanel) -> str:
    return group(panel)[0]


def group_by(panel: NoisePanel, field: str) -> None:
    settle()
    panel._field.setField(field)
    settle()


def test_windows_of_the_same_value_are_measured_and_their_range_is_drawn(desk: Desk, panel: NoisePanel) -> None:
    desk.use(windows(BOX, HOLE, FLAT, NEXT_BOX, land_use=("string", ["field", "field", "lake", "field"])))
    select(desk, panel, 1)
    assert group(panel) == NO_GROUP
    group_by(panel, "land_use")
    wait_until(lambda: len(group(panel)[1]) == 2, "for the group")
    wait_for_tasks()
    assert range_words(panel) == "field: red of 2 of 3 windows"  # one of them has no valid pixels
    expected = measure_window(RasterRef(desk.mosaic.source()), PixelWindow(*NEXT_BOX)).bands
    assert expected["red"].curve.detail in group(panel)[1]
    request = panel._chart._request()
    assert request.group == group(panel)
    labels = [text.get_text() for text in figure(request).legends[0].get_texts()]
    assert "field: red of 2 of 3 windows" in labels
    group_by(panel, "")
    assert group(panel) == NO_GROUP


def test_another_value_or_another_layer_ends_the_group(desk: Desk, panel: NoisePanel) -> None:
    desk.use(windows(BOX, NEXT_BOX, land_use=("string", ["a field with <b> & $x$", None])))
    group_by(panel, "land_use")
    select(desk, panel, 2)
    assert group(panel) == NO_GROUP  # it has no value
    select(desk, panel, 1)
    assert range_words(panel) == "a field with <b> & $x$: red of 1 of 1 windows"
    made = desk.session.window_layer()
    made.startEditing()
    made.changeAttributeValue(2, made.fields().lookupField("land_use"), "a field with <b> & $x$")
    wait_until(lambda: range_words(panel).endswith("2 of 2 windows"), "for the other window")
    desk.use(windows(BOX))
    select(desk, panel, 1)
    assert panel._field.currentField() == ""
    assert group(panel) == NO_GROUP
