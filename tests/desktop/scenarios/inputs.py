"""A project full of unsuitable layers, one that is as it should be, and one of 500 rasters.

Parameters: ``brighton`` (folder), ``relatives`` (folder of rasters made of its mosaic), ``stranger`` (an image that it
was not made from), ``screenshots`` (folder).
"""
from __future__ import annotations

import time
from pathlib import Path

from qgis.core import QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import Qt

from demo.desk import Desk
from demo.gaps import Gaps

MOSAIC = "mosaic_feather0p4m"
MANY = 500


def play(desk: Desk) -> None:
    """All that is measured is in the report."""
    brighton, shots = Path(desk.parameters["brighton"]), Path(desk.parameters["screenshots"])
    unsuitable(desk, brighton, Path(desk.parameters["relatives"]), shots)
    desk.new_project()
    suitable(desk, brighton, shots)
    desk.new_project()
    questioned(desk, brighton, Path(desk.parameters["stranger"]), shots)
    desk.new_project()
    many(desk, brighton, shots)
    desk.new_project()


def sources_of(desk: Desk) -> list[str]:
    """Names of the sources."""
    return sorted(desk.project.mapLayer(source).name() for source in desk.session.inputs.sources)


def unsuitable(desk: Desk, brighton: Path, relatives: Path, shots: Path) -> None:
    """Copies, overviews, other mosaics and maps do not become sources, and say why."""
    desk.load_rasters([*sorted(brighton.glob("*.tif")), *sorted(relatives.iterdir())])
    roads = QgsVectorLayer("LineString?crs=EPSG:32615&field=kind:string", "roads", "memory")
    desk.project.addMapLayers([roads])
    desk.open_dock()
    inputs = desk.dock.inputs
    desk.pause(1)
    assert not desk.session.inputs.mosaic, "one of several mosaics was suggested"
    assert not inputs.box.isCollapsed()
    assert "choose the mosaic" in inputs.box.title()
    assert "choose" in desk.dock.scan.toolTip().lower()
    desk.screenshot(shots / "inputs_unset.png")
    (mosaic,) = desk.project.mapLayersByName(MOSAIC)
    inputs.mosaic.setLayer(mosaic)
    inputs.mosaic.activated.emit(inputs.mosaic.currentIndex())
    desk.pause(0.5)
    desk.report["sources"] = sources_of(desk)
    inputs.box.setCollapsed(False)
    desk.show_all(mosaic.extent())
    shown = inputs.sources.list
    shown.scrollToBottom()
    items = [shown.item(row) for row in range(shown.count())]
    desk.report["reasons"] = [item.text() for item in items if item.checkState() == Qt.CheckState.Unchecked]
    desk.screenshot(shots / "inputs_reasons.png")


def suitable(desk: Desk, brighton: Path, shots: Path) -> None:
    """One mosaic, its sources and its seamlines are found without a choice."""
    layers = desk.load_rasters([*sorted(brighton.glob("DJI*.tif")), brighton / f"{MOSAIC}.tif"])
    desk.load_seamlines(brighton / "seamlines.gpkg")
    session = desk.session
    desk.wait(lambda: session.mosaic_grid() is not None, 20, "mosaic suggested and opened")
    desk.report["suggested"] = [
        desk.project.mapLayer(session.inputs.mosaic).name(), len(sources_of(desk)),
        desk.project.mapLayer(session.inputs.seamlines).name(), session.inputs.side_m,
    ]
    desk.dock.inputs.box.setCollapsed(False)
    desk.dock.inputs.side.setValue(7.6)
    desk.show_all(layers[-1].extent())
    desk.screenshot(shots / "inputs_suggested.png")
    desk.dock.draw.trigger()
    hover(desk, shots)
    desk.dock.draw.trigger()


def hover(desk: Desk, shots: Path) -> None:
    """Along the seams: what is promised is what is found; where nothing can be judged a click goes where it can be."""
    from seam_inspector.plugin.seams.desk.map.window_tool import clicked_window

    session, grid = desk.session, desk.session.mosaic_grid()
    seams = desk.project.mapLayer(session.inputs.seamlines)
    desk.wait(lambda: session.seam_point_near(*grid_middle(grid), 1e9) is not None, 60, "seams found")
    points = [vertex for feature in seams.getFeatures() for vertex in list(feature.geometry().vertices())[::400]]
    kinds: dict[str, int] = {}
    slowest = 0.0
    for number, point in enumerate(points):
        window = clicked_window(grid, (point.x(), point.y()), session.inputs)
        desk.wait(lambda one=window: not session.coverage(one).unread, 60, "sources looked at")
        start = time.perf_counter()
        coverage = session.coverage(window)
        near = None if coverage.can_be_judged else session.nearest_judgeable(window, True)
        slowest = max(slowest, time.perf_counter() - start)
        kind = "here" if coverage.can_be_judged else "elsewhere" if near else "nowhere"
        kinds[kind] = kinds.get(kind, 0) + 1
        if kinds[kind] == 1 or number == len(points) // 2:
            desk.move((point.x(), point.y()))
            desk.screenshot(shots / f"hover_{kind}_{number}.png")
            if near is not None:
                desk.click((point.x(), point.y()))
                desk.wait_for_work()
                desk.report["clicked"] = session.windows()[-1].verdict
    desk.report["places"], desk.report["hover_ms"] = kinds, 1000 * slowest


def questioned(desk: Desk, brighton: Path, stranger: Path, shots: Path) -> None:
    """A source that the mosaic follows nowhere is asked about when windows were inspected."""
    desk.load_rasters([*sorted(brighton.glob("DJI*.tif")), stranger, brighton / f"{MOSAIC}.tif"])
    desk.load_seamlines(brighton / "seamlines.gpkg")
    desk.wait(lambda: desk.session.mosaic_grid() is not None, 20, "mosaic suggested and opened")
    inputs = desk.dock.inputs
    desk.report["with_stranger"] = sources_of(desk)
    inputs.side.setValue(7.6)
    inputs.more.boxes["spacing_m"].setValue(6)
    desk.dock.place.trigger()
    desk.wait(lambda: desk.session.windows() and not desk.session.is_busy, 60, "windows placed")
    desk.dock.inspect.trigger()
    desk.wait_for_work(200)
    desk.report["doubts"] = inputs.doubts.text()
    desk.session.select([desk.session.windows()[0].fid])
    desk.pause(1)
    desk.screenshot(shots / "inputs_doubts.png")


def grid_middle(grid: object) -> tuple[float, float]:
    """A point of the mosaic."""
    xmin, ymin, xmax, ymax = grid.extent  # type: ignore[attr-defined]
    return (xmin + xmax) / 2, (ymin + ymax) / 2


def many(desk: Desk, brighton: Path, shots: Path) -> None:
    """500 rasters are judged by their headers without a halt."""
    files = sorted(brighton.glob("DJI*.tif"))
    layers = [QgsRasterLayer(str(files[number % len(files)]), f"image {number:03d}") for number in range(MANY)]
    mosaic = QgsRasterLayer(str(brighton / f"{MOSAIC}.tif"), MOSAIC)
    desk.project.addMapLayers([*layers, mosaic], False)
    inputs = desk.dock.inputs
    desk.wait(lambda: len(desk.session.inputs.sources) == MANY, 20, "mosaic suggested with its sources")
    choose(desk, None)
    desk.pause(1)
    with Gaps() as gaps:
        desk.report["many_s"] = choose(desk, mosaic)
        desk.report["many"] = len(desk.session.inputs.sources)
        desk.pause(5)
    desk.report["many_gap_ms"], desk.report["many_work_ms"] = 1000 * gaps.longest_s, 1000 * gaps.longest_work_s
    assert inputs.sources.list.count() == MANY
    desk.screenshot(shots / "inputs_many.png")


def choose(desk: Desk, mosaic: QgsRasterLayer | None) -> float:
    """Choose as the operator does, the sources taken away with a mosaic that is chosen no more; seconds."""
    box = desk.dock.inputs.mosaic
    start = time.perf_counter()
    if mosaic is None:
        desk.dock.inputs.sources.none.click()
        box.setCurrentIndex(0)
    else:
        box.setLayer(mosaic)
    box.activated.emit(box.currentIndex())
    return time.perf_counter() - start
