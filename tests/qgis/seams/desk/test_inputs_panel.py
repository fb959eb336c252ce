"""The inputs panel: it writes the session's inputs, follows session and project, and leaves nothing behind."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import Qt
from seam_inspector.plugin.seams.desk.inputs.inputs_panel import InputsPanel
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs
from seam_inspector.plugin.seams.measure.window_records import WindowRecord

from tests.numbers.synthetic import ORIGIN, write_raster
from tests.qgis.scenes import PIXEL, Scene, layer, line, outline, whole
from tests.qgis.seams.desk.fake_session import FakeSession


def noisy(scene: Scene) -> list[np.ndarray]:
    """Both sources with the noise and the lean of heights that tell two flights apart."""
    random = np.random.default_rng(3)
    both = (whole(scene.west), np.roll(whole(scene.east), 3, axis=2))
    return [np.clip(item + random.normal(0, 12, item.shape), 1, 255).astype(np.uint8) for item in both]


class Desk:
    """The panel, its session and the project's layers."""

    def __init__(self, scene: Scene, folder: Path) -> None:
        east = ORIGIN[0] + 192 * PIXEL, ORIGIN[1]
        images = noisy(scene)
        paths = (
            scene.mosaic,
            Path(write_raster(folder / "west.tif", images[0][..., :320])),
            Path(write_raster(folder / "east.tif", images[1][..., 192:], origin=east)),
        )
        self.rasters = {path.stem: QgsRasterLayer(str(path), path.stem) for path in paths}
        QgsProject.instance().addMapLayers(list(self.rasters.values()))
        self.session = FakeSession(Inputs())
        self.panel = InputsPanel(self.session)

    def id(self, name: str) -> str:
        return str(self.rasters[name].id())

    def set_all(self) -> None:
        self.session.set_inputs(Inputs(mosaic=self.id("mosaic"), sources=(self.id("east"), self.id("west"))))

    def choose(self, box: str, layer_id: str) -> None:
        """Choose a layer as the operator does, with the mouse."""
        combo = getattr(self.panel, box)
        combo.setLayer(QgsProject.instance().mapLayer(layer_id))
        combo.activated.emit(combo.currentIndex())

    def listed(self) -> dict[str, bool]:
        """Names in the source list and whether they are checked."""
        items = [self.panel.sources.list.item(row) for row in range(self.panel.sources.list.count())]
        return {item.text().split(" \u2013 ")[0]: item.checkState() == Qt.CheckState.Checked for item in items}

    def reason(self, name: str) -> str:
        """Why a raster is left out."""
        (item,) = self.panel.sources.list.findItems(f"{name} \u2013 ", Qt.MatchFlag.MatchStartsWith)
        return str(item.text()).split(" \u2013 ")[1]

    def check(self, name: str, checked: bool) -> None:
        (item,) = (
            item for item in self.panel.sources.list.findItems(name, Qt.MatchFlag.MatchStartsWith)
            if item.text().split(" \u2013 ")[0] == name
        )
        item.setCheckState(Qt.CheckState.Checked if checked else Qt.CheckState.Unchecked)

    @property
    def sources(self) -> set[str]:
        names = {raster.id(): name for name, raster in self.rasters.items()}
        return {names.get(source, source) for source in self.session.inputs.sources}


@pytest.fixture
def desk(project: QgsProject, scene: Scene, tmp_path: Path) -> Iterator[Desk]:
    made = Desk(scene, tmp_path)
    yield made
    made.panel.close()
    made.panel.deleteLater()


def vector(kind: str, name: str, **fields: tuple[str, list[str]]) -> QgsVectorLayer:
    shape = {"LineString": line((0, 10), (500, 10)), "Polygon": outline((0, 0, 128, 128))}.get(kind)
    made = layer(kind, [shape], **fields)
    made.setName(name)
    QgsProject.instance().addMapLayer(made)
    return made


def offered(box: object) -> list[str]:
    return [box.itemText(row) for row in range(box.count())]  # type: ignore[attr-defined]


def test_choosing_the_mosaic_takes_its_sources(desk: Desk) -> None:
    desk.choose("mosaic", desk.id("mosaic"))
    assert desk.session.inputs.mosaic == desk.id("mosaic")
    assert desk.sources == {"east", "west"}
    assert desk.listed() == {"east": True, "west": True}


def test_what_is_no_source_by_its_header_is_left_out_with_the_reason(desk: Desk, scene: Scene, tmp_path: Path) -> None:
    west = whole(scene.west)[..., :320]
    apart = write_raster(tmp_path / "apart.tif", west, origin=(ORIGIN[0] + 9000, ORIGIN[1]))
    height = write_raster(tmp_path / "height.tif", west[:1])
    half = write_raster(tmp_path / "half.tif", west[:, ::2, ::2], gsd=2 * PIXEL)
    deep = write_raster(tmp_path / "deep.tif", west.astype(np.uint16) * 257)
    turned = str(tmp_path / "turned.tif")
    gdal.Warp(turned, str(tmp_path / "west.tif"), dstSRS="EPSG:4326")
    others = {"apart": apart, "height": height, "half": half, "deep": deep, "turned": turned,
              "copy": str(scene.west), "again": str(scene.mosaic)}
    QgsProject.instance().addMapLayers([QgsRasterLayer(path, name) for name, path in others.items()])
    desk.choose("mosaic", desk.id("mosaic"))
    assert desk.listed() == {"east": True, "west": True, **dict.fromkeys(others, False)}
    assert list(desk.listed())[:2] == ["east", "west"]  # what is left out comes last
    for name, words in {
        "apart": "not overlap", "height": "1 and not 3", "half": "2.0 times as large", "deep": "16 bit",
        "turned": "another reference system", "copy": "Covers the whole mosaic", "again": "mosaic itself",
    }.items():
        assert words in desk.reason(name)
    desk.check("height", True)  # the operator may know better
    assert desk.sources == {"east", "west", next(iter(desk.sources - {"east", "west"}))}
    desk.panel.sources.suggested.click()
    assert desk.sources == {"east", "west"}


def test_sources_that_somebody_set_stay_whatever_is_suggested(desk: Desk, scene: Scene) -> None:
    again = QgsRasterLayer(str(scene.mosaic), "again")
    QgsProject.instance().addMapLayer(again)
    sources = (desk.id("east"), again.id())
    desk.session.set_inputs(replace(desk.session.inputs, mosaic=desk.id("mosaic"), sources=sources))
    desk.panel.refresh()
    assert "mosaic itself" in desk.reason("again")
    assert desk.session.inputs.sources == sources
    desk.panel.sources.suggested.click()
    assert desk.sources == {"east", "west"}


def test_sources_are_checked_one_by_one_all_and_none(desk: Desk) -> None:
    desk.set_all()
    desk.check("west", False)
    assert desk.sources == {"east"}
    desk.panel.sources.none.click()
    assert desk.sources == set()
    desk.panel.sources.suggested.click()
    assert desk.sources == {"east", "west"}


def test_layers_that_are_removed_stay_in_the_inputs_as_missing(desk: Desk) -> None:
    seams = vector("LineString", "seams").id()
    vector("LineString", "others")
    desk.set_all()
    desk.choose("seamlines", seams)
    before = desk.session.inputs
    QgsProject.instance().removeMapLayers([seams, desk.id("west"), desk.id("mosaic")])
    assert desk.session.inputs == before
    assert desk.panel.seamlines.currentText() == "missing: made"  # the name it had when its id was made
    assert desk.panel.mosaic.currentText() == "missing: mosaic"
    assert desk.panel.box.toolTip() == "missing: mosaic · 1 source · 1 missing"
    desk.panel.seamlines.activated.emit(desk.panel.seamlines.currentIndex())  # the missing one chosen again
    assert desk.session.inputs == before
    desk.panel.seamlines.setCurrentIndex(0)
    desk.panel.seamlines.activated.emit(0)
    assert desk.session.inputs.seamlines == ""


def test_each_choice_changes_its_own_input_only(desk: Desk) -> None:
    cells, tiles = vector("Polygon", "cells").id(), vector("Polygon", "tiles", location=("string", ["a.tif"])).id()
    desk.set_all()
    expected = desk.session.inputs
    for box, field, value in (
        ("index", "source_index", tiles),
        ("seamlines", "seamlines", cells),
        ("windows", "windows", cells),
    ):
        desk.choose(box, value)
        expected = replace(expected, **{field: value})
        assert desk.session.inputs == expected
    more: dict[str, Any] = desk.panel.more.boxes
    spins: tuple[tuple[Any, str, float], ...] = (
        (desk.panel.side, "side_m", 50.0),
        (more["spacing_m"], "spacing_m", 300.0),
        (more["levels"], "levels", 4),
        (more["min_kept"], "min_kept", 0.6),
        (more["max_ratio"], "max_ratio", 0.6),
    )
    for spin, field, value in spins:
        spin.setValue(value)
        expected = replace(expected, **{field: value})
        assert desk.session.inputs == expected
    more["wavelet"].setCurrentText("db4")
    more["wavelet"].activated.emit(more["wavelet"].currentIndex())
    expected = replace(expected, wavelet="db4")
    assert desk.session.inputs == expected
    more["reference"].setCurrentIndex(1)
    more["reference"].activated.emit(1)
    expected = replace(expected, reference="composite")
    assert desk.session.inputs == expected
    seam_cells = vector("Polygon", "seam cells", source=("string", ["a.tif"]))
    assert offered(more["cells"]) == ["none", "seam cells"]
    more["cells"].setLayer(seam_cells)
    more["cells"].activated.emit(more["cells"].currentIndex())
    assert desk.session.inputs == replace(expected, cells=seam_cells.id())


@pytest.mark.parametrize(
    ("side", "levels", "becomes", "shown", "note"),
    [
        (100.0, 3, 100.0, "1024 px, 102.4 m", ""),
        (10.0, 3, 10.0, "128 px, 12.8 m (!)", ""),
        # not 12.8, as tenths would say
        (12.79, 3, 12.79, "128 px, 12.8 m (!)", ""),
        (3.0, 3, 25.6, "256 px, 25.6 m", "3.0 m does not fit this mosaic: 25.6 m now, a window every 51.2 m"),
        (10.0, 8, 25.6, "256 px, 25.6 m", "10.0 m does not fit this mosaic: 25.6 m now, a window every 51.2 m"),
        (300.0, 3, 51.2, "512 px, 51.2 m", "300.0 m does not fit this mosaic: 51.2 m now, a window every 102.4 m"),
    ],
)
def test_side_is_shown_in_pixels_and_one_that_does_not_fit_is_replaced(
    desk: Desk, side: float, levels: int, becomes: float, shown: str, note: str
) -> None:
    notes: list[str] = []
    desk.session.messageRaised.connect(lambda text, _: notes.append(text))
    assert desk.panel.side_px.text() == ""
    desk.set_all()
    desk.session.set_inputs(replace(desk.session.inputs, side_m=side, levels=levels))
    assert desk.session.inputs.side_m == pytest.approx(becomes)
    assert desk.panel.side.value() == pytest.approx(becomes)
    assert desk.panel.side_px.text() == shown
    assert notes == [note] * bool(note)
    assert (desk.panel.side_px.toolTip() == "few windows below 256 px can be measured") == ("(!)" in shown)


def test_folds_with_the_first_window_and_then_stays_as_it_is_left(desk: Desk) -> None:
    box = desk.panel.box
    desk.panel.resize(900, 500)
    desk.panel.grab()
    assert not box.isCollapsed()
    assert box.title() == "Inputs: choose the mosaic"
    desk.set_all()
    assert not box.isCollapsed()
    assert box.title() == "mosaic · 2 sources"
    desk.session.rows = [WindowRecord(1, None)]
    desk.session.windowsChanged.emit()
    assert box.isCollapsed()
    box.setCollapsed(False)
    desk.session.windowsChanged.emit()
    assert not box.isCollapsed()


def test_close_lets_go_of_everything(desk: Desk) -> None:
    project = QgsProject.instance()
    owners: list[tuple[Any, str]] = [(desk.session, "inputsChanged"), (desk.session, "windowsChanged")]
    owners += [(project, "layersAdded"), (project, "layersRemoved")]
    before = [owner.receivers(getattr(owner, name)) for owner, name in owners]
    desk.panel.close()
    after = [owner.receivers(getattr(owner, name)) for owner, name in owners]
    assert [item - two for item, two in zip(before, after)] == [1, 1, 1, 1]
    desk.panel.close()
    desk.set_all()
    assert desk.panel.mosaic.currentText() == "choose the mosaic"
