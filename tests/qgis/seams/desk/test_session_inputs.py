"""The inputs of a session: remembered, opened in the background, followed when they change."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from threading import Event

import pytest
from osgeo import gdal
from qgis.core import QgsProject, QgsRasterLayer
from seam_inspector.plugin.imagery import messages as imagery_messages
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.seams.desk.inputs import block_cache as block_files
from seam_inspector.plugin.seams.desk.inputs.inputs_panel import InputsPanel
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs, load_inputs
from seam_inspector.plugin.seams.desk.session import Session
from seam_inspector.plugin.seams.measure import messages
from seam_inspector.plugin.toolkit.translation import sentence

from tests.numbers.synthetic import write_raster
from tests.patience import PATIENCE_S
from tests.qgis.runs import assert_sentence
from tests.qgis.scenes import ORIGIN, PIXEL, SHARP, Scene, at, layer, line, outline, whole, windows
from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, SHARP_WINDOW, Desk, settle, wait_for_tasks, wait_until

# Inputs


def test_the_inputs_come_back_with_the_project(desk: Desk, tmp_path: Path) -> None:
    desk.add()
    wanted = replace(desk.session.inputs, wavelet="db4", levels=2, reference="composite", cells="gone")
    desk.session.set_inputs(wanted)
    path = str(tmp_path / "project.qgz")
    assert desk.project.write(path)
    desk.project.clear()
    assert desk.session.inputs == Inputs()
    assert desk.session.window_layer() is None
    assert desk.session.windows() == []
    assert desk.project.read(path)
    assert desk.session.inputs == wanted
    desk.wait_for_opening()
    assert desk.session.mosaic_grid() is not None
    assert [row.verdict for row in desk.session.windows()] == ["significant"]


def test_a_copy_of_the_mosaic_hides_no_loss_from_a_window(desk: Desk, tmp_path: Path) -> None:
    """A scan is not misled by it either."""
    copy = tmp_path / "overview.vrt"
    gdal.Translate(str(copy), desk.mosaic.source())
    layer = desk.raster(copy)
    desk.set(desk.inputs(sources=(*(source.id() for source in desk.sources), layer.id())))
    fid = desk.add()
    assert [row.verdict for row in desk.session.windows()] == ["significant"]
    assert desk.session.row(fid).sources == 2
    assert [text for text in desk.messages if copy.name in text] == [
        sentence(messages.COPY_AMONG_SOURCES(name=copy.name))
    ]
    assert [source.ref.name for source in desk.session.block().sources] == ["west.tif", "east.tif"]
    desk.add(SHARP_WINDOW)
    assert len([text for text in desk.messages if copy.name in text]) == 1


# Seams


def test_seams_follow_the_edits_of_their_layer(desk: Desk) -> None:
    wait_until(lambda: desk.session.seam_point_near(*at(256, 100), 1.0) is not None)
    desk.seamlines.startEditing()
    desk.seamlines.changeGeometry(1, line((300, 0), (300, 256)))
    assert desk.session.seam_point_near(*at(256, 100), 1.0) is not None  # the old ones until the new ones are there
    wait_until(lambda: desk.session.seam_point_near(*at(300, 100), 1.0) is not None)
    assert desk.session.seam_point_near(*at(256, 100), 1.0) is None
    desk.seamlines.rollBack()
    wait_until(lambda: desk.session.seam_point_near(*at(256, 100), 1.0) is not None)
    assert desk.session.seam_point_near(*at(300, 100), 1.0) is None


# Opening the mosaic


@pytest.fixture
def gate(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> Iterator[Event]:
    """The desk without inputs; mosaics are opened from a slow drive, not before the gate is set."""
    desk.session.set_inputs(Inputs())
    result = Event()

    def slow(ref: RasterRef) -> Raster:
        assert result.wait(PATIENCE_S)
        return describe_mosaic(ref)

    monkeypatch.setattr(block_files, "describe_mosaic", slow)
    yield result
    result.set()
    wait_for_tasks()


def test_the_desk_can_be_used_while_the_mosaic_is_opened(desk: Desk, gate: Event) -> None:
    panel = InputsPanel(desk.session)
    panel.show()
    drawn = windows(SHARP)
    desk.project.addMapLayer(drawn)
    desk.session.set_inputs(desk.inputs(windows=drawn.id()))  # waits for no drive: the gate is closed
    assert "opening ..." in panel.box.title()
    assert desk.session.mosaic_grid() is None
    assert len(desk.session.windows()) == 1
    desk.session.add_window(BLURRED_WINDOW)
    desk.session.place_windows()
    desk.session.inspect_pending()
    assert len(desk.messages) == 3
    for message in desk.messages:
        assert_sentence(message.split("; ")[0] + ".", "still being opened")
    desk.session.set_inputs(replace(desk.session.inputs, max_ratio=0.4))  # does not open it again
    gate.set()
    desk.wait_for_opening()
    assert desk.session.mosaic_grid() is not None
    assert "opening" not in panel.box.title()
    assert "2 sources" in panel.box.title()
    desk.use(drawn)
    desk.session.inspect_pending()
    desk.add()
    assert all(row.verdict and not row.stale for row in desk.session.windows())
    wait_until(lambda: desk.session.seam_point_near(*at(256, 100), 1.0) is not None)
    panel.close()


def test_a_mosaic_that_cant_be_used_is_told_and_another_one_can_be_chosen(
    desk: Desk, monkeypatch: pytest.MonkeyPatch
) -> None:
    panel = InputsPanel(desk.session)

    def refuse(ref: RasterRef) -> Raster:
        raise RasterError(imagery_messages.NOT_NORTH_UP(name=ref.name))

    with monkeypatch.context() as patch:
        patch.setattr(block_files, "describe_mosaic", refuse)
        desk.set(desk.inputs(mosaic=desk.sources[0].id(), sources=(desk.mosaic.id(),)))
    assert desk.session.mosaic_grid() is None
    assert "can't be used" in panel.box.toolTip()
    assert "west.tif is rotated" in panel.box.toolTip()
    desk.session.add_window(BLURRED_WINDOW)
    assert_sentence(desk.messages.pop().split("; ")[0] + ".", "west.tif is rotated")
    desk.set(desk.inputs())
    assert desk.session.mosaic_grid() is not None
    panel.close()


def test_mosaic_and_seamlines_are_suggested_until_the_operator_says_otherwise(
    project: QgsProject, scene: Scene, tmp_path: Path
) -> None:
    session = Session()
    panel = InputsPanel(session)
    panel.show()
    east = ORIGIN[0] + 192 * PIXEL, ORIGIN[1]
    paths = {
        "mosaic": str(scene.mosaic),
        "west": write_raster(tmp_path / "west.tif", whole(scene.west)[..., :320]),
        "east": write_raster(tmp_path / "east.tif", whole(scene.east)[..., 192:], origin=east),
    }
    rasters = {name: QgsRasterLayer(path, name) for name, path in paths.items()}
    contours = layer("LineString", [line((256, 0), (256, 256))])
    seams = layer("Polygon", [outline((0, 0, 256, 256))], src=("integer", [1]))
    project.addMapLayers([*rasters.values(), contours, seams])
    project.setDirty(False)
    wait_until(lambda: session.inputs.mosaic, "for the suggestion")
    assert load_inputs(project) == session.inputs
    assert not project.isDirty()  # nobody is asked to save a project for what the desk guessed
    assert session.inputs.mosaic == rasters["mosaic"].id()
    assert set(session.inputs.sources) == {rasters["west"].id(), rasters["east"].id()}
    assert session.inputs.seamlines == seams.id()
    panel.seamlines.setCurrentIndex(0)
    panel.seamlines.activated.emit(0)
    assert project.isDirty()
    panel.mosaic.setCurrentIndex(0)
    panel.mosaic.activated.emit(0)
    project.addMapLayer(QgsRasterLayer(paths["west"], "more"))
    settle(0.6)
    assert (session.inputs.mosaic, session.inputs.seamlines) == ("", "")
    panel.close()
    session.close()
    panel.deleteLater()
    wait_for_tasks()


def test_a_system_that_is_set_by_hand_is_taken_and_said_below_the_inputs(desk: Desk, tmp_path: Path) -> None:
    panel = InputsPanel(desk.session)
    layers = []
    for image in (desk.mosaic, *desk.sources):
        path = tmp_path / f"{image.name()}.tif"
        layers.append(desk.raster(Path(write_raster(path, whole(Path(image.source())), system=2180, nodata=0))))
        layers[-1].setCrs(image.crs())
    desk.set(desk.inputs(mosaic=layers[0].id(), sources=tuple(layer.id() for layer in layers[1:])))
    said = panel.doubts.text()
    for image in layers:
        assert_sentence(said, rf"{image.name()} is read in .*EPSG:32633.* not in that of its file, EPSG:2180")
    assert not panel.doubts.isHidden()
    block = desk.session.block()
    assert block is not None
    assert [len(block.sources_over(window)) for window in (SHARP_WINDOW, BLURRED_WINDOW)] == [2, 2]
    desk.add()
    (row,) = desk.rows().values()
    assert row.verdict == "significant"
    desk.set(desk.inputs())
    assert not panel.doubts.text()
    panel.close()
