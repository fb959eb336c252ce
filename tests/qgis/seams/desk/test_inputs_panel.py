"""The inputs panel: it writes the session's inputs, follows session and project, and leaves nothing behind."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from qgis.core import QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QApplication, QLineEdit
from seam_inspector.plugin.seams.desk.inputs.inputs_panel import InputsPanel
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs

from tests.numbers.synthetic import ORIGIN, write_raster
from tests.qgis.scenes import Scene, layer, line, outline, whole
from tests.qgis.seams.desk.fake_session import FakeSession

GONE = "sheet_144_c0ffcfeb_70d2_4cb8_bb70_bc0774454265"  # the id of a layer that was removed


class Desk:
    """The panel, its session and the project's layers."""

    def __init__(self, scene: Scene) -> None:
        paths = (scene.mosaic, scene.west, scene.east)
        self.rasters = {path.stem: QgsRasterLayer(str(path), path.stem) for path in paths}
        QgsProject.instance().addMapLayers(list(self.rasters.values()))
        self.session = FakeSession(Inputs())
        self.panel = InputsPanel(self.session)

    def id(self, name: str) -> str:
        return str(self.rasters[name].id())

    def set_all(self) -> None:
        self.session.set_inputs(Inputs(mosaic=self.id("mosaic"), sources=(self.id("east"), self.id("west"))))

    def choose(self, box: str, layer_id: str) -> None:
        """As the operator does, with the mouse."""
        combo = getattr(self.panel, box)
        combo.setLayer(QgsProject.instance().mapLayer(layer_id))
        combo.activated.emit(combo.currentIndex())

    def listed(self) -> dict[str, bool]:
        """Texts of the source list and whether they are checked."""
        items = [self.panel.sources.list.item(row) for row in range(self.panel.sources.list.count())]
        return {item.text(): item.checkState() == Qt.CheckState.Checked for item in items}

    def check(self, text: str, checked: bool) -> None:
        (item,) = self.panel.sources.list.findItems(text, Qt.MatchFlag.MatchExactly)
        item.setCheckState(Qt.CheckState.Checked if checked else Qt.CheckState.Unchecked)

    @property
    def sources(self) -> set[str]:
        names = {raster.id(): name for name, raster in self.rasters.items()}
        return {names.get(source, source) for source in self.session.inputs.sources}


@pytest.fixture
def desk(project: QgsProject, scene: Scene) -> Iterator[Desk]:
    made = Desk(scene)
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


def test_choosing_the_mosaic_takes_all_that_overlap(desk: Desk) -> None:
    desk.choose("mosaic", desk.id("mosaic"))
    assert desk.session.inputs.mosaic == desk.id("mosaic")
    assert desk.sources == {"east", "west"}
    assert desk.listed() == {"east": True, "west": True}


def test_rasters_elsewhere_and_elevation_models_are_no_default(desk: Desk, scene: Scene, tmp_path: Path) -> None:
    apart = write_raster(tmp_path / "apart.tif", whole(scene.west), origin=(ORIGIN[0] + 9000, ORIGIN[1]))
    height = write_raster(tmp_path / "height.tif", whole(scene.west)[:1])
    QgsProject.instance().addMapLayers([QgsRasterLayer(apart, "apart"), QgsRasterLayer(height, "height")])
    desk.choose("mosaic", desk.id("mosaic"))
    assert desk.listed() == {"apart": False, "east": True, "height": False, "west": True}
    desk.panel.sources.all.click()
    assert desk.listed() == {"apart": False, "east": True, "height": True, "west": True}


def test_another_mosaic_of_the_same_block_keeps_the_sources(desk: Desk, scene: Scene) -> None:
    other = QgsRasterLayer(str(scene.mosaic), "other")
    QgsProject.instance().addMapLayer(other)
    desk.set_all()
    desk.check("west", False)
    desk.choose("mosaic", other.id())
    assert desk.session.inputs.mosaic == other.id()
    assert desk.sources == {"east"}


def test_sources_are_checked_one_by_one_all_and_none(desk: Desk) -> None:
    desk.set_all()
    desk.check("west", False)
    assert desk.sources == {"east"}
    desk.panel.sources.none.click()
    assert desk.sources == set()
    desk.panel.sources.all.click()
    assert desk.sources == {"east", "west"}


def test_rasters_loaded_later_become_sources_unless_the_operator_chose(desk: Desk, scene: Scene) -> None:
    desk.set_all()
    more = QgsRasterLayer(str(scene.east), "more")
    QgsProject.instance().addMapLayer(more)
    assert more.id() in desk.session.inputs.sources
    desk.check("more", False)
    QgsProject.instance().addMapLayer(QgsRasterLayer(str(scene.east), "yet more"))
    assert desk.sources == {"east", "west"}


def test_missing_source_is_shown_in_italics_until_it_is_unchecked(desk: Desk) -> None:
    desk.set_all()
    desk.session.set_inputs(replace(desk.session.inputs, sources=(*desk.session.inputs.sources, GONE)))
    assert desk.listed() == {"missing: sheet_144": True, "east": True, "west": True}
    assert desk.panel.sources.list.item(0).font().italic()
    assert desk.panel.box.toolTip() == "mosaic · 2 sources · 1 missing"
    desk.check("missing: sheet_144", False)
    assert desk.sources == {"east", "west"}
    assert desk.listed() == {"east": True, "west": True}


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


def test_boxes_offer_what_fits(desk: Desk) -> None:
    vector("Polygon", "cells")
    vector("Polygon", "tiles", location=("string", ["a.tif"]))
    vector("LineString", "seams")
    vector("Point", "points")
    assert offered(desk.panel.mosaic) == ["choose the mosaic", "east", "mosaic", "west"]
    assert offered(desk.panel.index) == ["none", "tiles"]
    assert offered(desk.panel.seamlines) == ["none", "cells", "seams", "tiles"]
    assert offered(desk.panel.windows) == ["new layer", "cells", "tiles"]


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
    more = desk.panel.more
    for spin, field, value in (
        (desk.panel.side, "side_m", 50.0),
        (more.spacing, "spacing_m", 300.0),
        (more.levels, "levels", 4),
        (more.min_kept, "min_kept", 0.6),
        (more.max_ratio, "max_ratio", 0.6),
    ):
        spin.setValue(value)
        expected = replace(expected, **{field: value})
        assert desk.session.inputs == expected
    more.wavelet.setCurrentText("db4")
    more.wavelet.activated.emit(more.wavelet.currentIndex())
    expected = replace(expected, wavelet="db4")
    assert desk.session.inputs == expected
    more.reference.setCurrentIndex(1)
    more.reference.activated.emit(1)
    expected = replace(expected, reference="composite")
    assert desk.session.inputs == expected
    seam_cells = vector("Polygon", "seam cells", source=("string", ["a.tif"]))
    assert offered(more.cells) == ["none", "seam cells"]
    more.cells.setLayer(seam_cells)
    more.cells.activated.emit(more.cells.currentIndex())
    assert desk.session.inputs == replace(expected, cells=seam_cells.id())


def test_following_the_session_changes_nothing(desk: Desk) -> None:
    inputs = Inputs(desk.id("mosaic"), (desk.id("west"), GONE), side_m=51.25, spacing_m=0.04, wavelet="db2", levels=5,
                    reference="composite", cells=GONE)
    desk.session.set_inputs(inputs)
    assert desk.session.settings == [inputs]
    assert desk.panel.more.wavelet.currentText() == "db2"
    assert desk.panel.more.levels.value() == 5
    assert desk.panel.more.reference.currentText() == "the composite"
    assert desk.panel.more.cells.currentText() == "missing: sheet_144"


@pytest.mark.parametrize(
    ("side", "levels", "shown", "tip"),
    [
        (100.0, 3, "1024 px, 102.4 m", "smallest power of two"),
        (10.0, 3, "128 px, 12.8 m", "smallest power of two"),
        (3.0, 3, "too short", "give a side of 6.4 metres or more"),
        (10.0, 8, "too short", "8 levels need at least 256 px"),
    ],
)
def test_side_is_shown_in_pixels(desk: Desk, side: float, levels: int, shown: str, tip: str) -> None:
    assert desk.panel.side_px.text() == ""
    desk.set_all()
    desk.session.set_inputs(replace(desk.session.inputs, side_m=side, levels=levels))
    assert desk.panel.side_px.text() == shown
    assert tip in desk.panel.side_px.toolTip().replace(" m ", " metres ")


def test_folds_once_set_and_then_stays_as_it_is_left(desk: Desk) -> None:
    box = desk.panel.box
    desk.panel.resize(900, 500)
    desk.panel.grab()
    assert not box.isCollapsed()
    assert box.title() == "Inputs: choose the mosaic"
    desk.set_all()
    assert box.isCollapsed()
    assert box.title() == "mosaic · 2 sources"
    box.setCollapsed(False)
    desk.panel.side.setValue(50)
    assert not box.isCollapsed()


def test_does_not_fold_under_the_operator_s_hands(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(QApplication, "focusWidget", lambda: desk.panel.mosaic)
    desk.choose("mosaic", desk.id("mosaic"))
    assert not desk.panel.box.isCollapsed()
    elsewhere = QLineEdit()
    monkeypatch.setattr(QApplication, "focusWidget", lambda: elsewhere)
    QApplication.instance().focusChanged.emit(desk.panel.mosaic, elsewhere)
    assert desk.panel.box.isCollapsed()


def test_unfolds_for_a_new_project(desk: Desk) -> None:
    desk.set_all()
    desk.session.set_inputs(Inputs())
    assert not desk.panel.box.isCollapsed()
    desk.set_all()
    assert desk.panel.box.isCollapsed()


def test_folded_while_hidden_is_folded_when_shown(desk: Desk) -> None:
    desk.panel.show()
    desk.panel.hide()
    desk.set_all()
    desk.panel.show()
    QApplication.processEvents()
    assert desk.panel.box.isCollapsed()
    assert not desk.panel.mosaic.isVisible()
    assert desk.panel.box.height() < 3 * desk.panel.fontMetrics().height()


def test_sources_stand_beside_the_rest_where_there_is_room(desk: Desk) -> None:
    def beside() -> bool:
        desk.panel.grab()
        return bool(desk.panel.sources.x() > desk.panel.mosaic.geometry().right())

    for width, expected in ((1500, True), (420, False), (1500, True)):
        desk.panel.resize(width, 500)
        assert beside() == expected
    assert desk.panel.minimumSizeHint().width() <= 420


def test_tab_goes_through_all_fields(desk: Desk) -> None:
    panel = desk.panel
    widget, seen = panel.mosaic, []
    for _ in range(60):
        seen.append(widget)
        widget = widget.nextInFocusChain()
    wanted = [
        panel.mosaic, *panel.sources.fields(), panel.index, panel.seamlines, panel.windows, panel.side,
        *panel.more.fields(),
    ]  # fmt: skip
    assert [one for one in seen if one in wanted][: len(wanted)] == wanted


def test_close_lets_go_of_everything(desk: Desk) -> None:
    project, app = QgsProject.instance(), QApplication.instance()
    owners = [(desk.session, "inputsChanged"), (app, "focusChanged")]
    owners += [(project, "layersAdded"), (project, "layersRemoved")]
    before = [owner.receivers(getattr(owner, name)) for owner, name in owners]
    desk.panel.close()
    after = [owner.receivers(getattr(owner, name)) for owner, name in owners]
    assert [one - two for one, two in zip(before, after)] == [1, 1, 1, 1]
    desk.panel.close()
    desk.set_all()
    assert desk.panel.mosaic.currentText() == "choose the mosaic"
