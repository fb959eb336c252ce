"""A project full of unsuitable layers, one with an image of another flight, and one of 500 rasters.

Parameters: ``brighton`` (folder), ``relatives`` (folder of rasters made of its mosaic), ``stranger`` (an image that it
was not made from), ``screenshots`` (folder).
"""
from __future__ import annotations

from pathlib import Path

from qgis.core import QgsRasterLayer, QgsVectorLayer

from demo.desk import Desk
from demo.gaps import Gaps

MOSAIC = "mosaic_feather0p4m"
MANY = 500


def play(desk: Desk) -> None:
    """All that is measured is in the report."""
    brighton, shots = Path(desk.parameters["brighton"]), Path(desk.parameters["screenshots"])
    unsuitable(desk, brighton, Path(desk.parameters["relatives"]), shots)
    desk.new_project()
    with_stranger(desk, brighton, Path(desk.parameters["stranger"]))
    desk.new_project()
    many(desk, brighton)
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
    (mosaic,) = desk.project.mapLayersByName(MOSAIC)
    inputs.mosaic.setLayer(mosaic)
    inputs.mosaic.activated.emit(inputs.mosaic.currentIndex())
    desk.pause(0.5)
    desk.report["sources"] = sources_of(desk)
    desk.screenshot(shots / "inputs_reasons.png")


def with_stranger(desk: Desk, brighton: Path, stranger: Path) -> None:
    """An image that the mosaic follows nowhere is suggested: its header and its place are those of a source."""
    desk.load_rasters([*sorted(brighton.glob("DJI*.tif")), stranger, brighton / f"{MOSAIC}.tif"])
    desk.load_seamlines(brighton / "seamlines.gpkg")
    desk.wait(lambda: desk.session.mosaic_grid() is not None, 20, "mosaic suggested and opened")
    desk.report["with_stranger"] = sources_of(desk)


def many(desk: Desk, brighton: Path) -> None:
    """500 rasters are judged by their headers without a halt."""
    files = sorted(brighton.glob("DJI*.tif"))
    layers = [QgsRasterLayer(str(files[number % len(files)]), f"image {number:03d}") for number in range(MANY)]
    mosaic = QgsRasterLayer(str(brighton / f"{MOSAIC}.tif"), MOSAIC)
    desk.project.addMapLayers([*layers, mosaic], False)
    inputs = desk.dock.inputs
    desk.wait(lambda: len(desk.session.inputs.sources) == MANY, 20, "mosaic suggested with its sources")
    inputs.sources.none.click()  # the sources are taken away with a mosaic that is chosen no more
    choose(desk, None)
    desk.pause(1)
    with Gaps() as gaps:
        choose(desk, mosaic)
        desk.report["many"] = len(desk.session.inputs.sources)
        desk.pause(5)
    desk.report["many_gap_ms"], desk.report["many_work_ms"] = 1000 * gaps.longest_s, 1000 * gaps.longest_work_s
    assert inputs.sources.list.count() == MANY


def choose(desk: Desk, mosaic: QgsRasterLayer | None) -> None:
    """Choose as the operator does."""
    box = desk.dock.inputs.mosaic
    box.setCurrentIndex(0) if mosaic is None else box.setLayer(mosaic)
    box.activated.emit(box.currentIndex())
