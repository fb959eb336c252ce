"""Windows know their mosaic: another one asks before it takes over what was measured and judged."""
from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from qgis.core import QgsCoordinateReferenceSystem, QgsVectorLayer
from seam_inspector.plugin.imagery.errors import Message
from seam_inspector.plugin.seams.desk.session import Session

from tests.qgis.emptied import UNDEFINED
from tests.qgis.scenes import SHARP, Scene, windows
from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, SHARP_WINDOW, Desk, settle


@pytest.fixture
def asked(desk: Desk) -> list[Message]:
    """A desk with two inspected windows, one of them judged, and what it asks."""
    items: list[Message] = []
    desk.set(desk.inputs())
    desk.add(SHARP_WINDOW)
    desk.session.judge([desk.add(BLURRED_WINDOW)], "visible")
    desk.session.mosaicDoubted.connect(items.append)
    return items


def other_mosaic(desk: Desk, scene: Scene, folder: Path) -> None:
    """Another one: the west image, under a name of its own."""
    path = folder / "another.tif"
    shutil.copyfile(scene.west, path)
    desk.set(desk.inputs(mosaic=desk.raster(path).id()))


def said(desk: Desk) -> list[tuple[str, str]]:
    return [(row.verdict, row.observer) for row in desk.session.windows()]


def test_another_mosaic_asks_and_changes_nothing(
    desk: Desk, scene: Scene, tmp_path: Path, asked: list[Message]
) -> None:
    before = said(desk)
    other_mosaic(desk, scene, tmp_path)
    assert [message.values["older"] for message in asked] == [scene.mosaic.name]
    desk.session.inspect_pending()
    desk.wait()
    assert said(desk) == before
    assert desk.session.problem() == asked[0]
    desk.set(desk.inputs())  # the first one is back
    assert desk.session.problem() is None
    assert len(asked) == 1


@pytest.mark.parametrize("wkt", ["", UNDEFINED])
def test_windows_that_lost_their_reference_system_have_the_mosaics(desk: Desk, wkt: str) -> None:
    """They lie where they were drawn, and the map goes there."""
    drawn = desk.use(windows(SHARP))
    drawn.setCrs(QgsCoordinateReferenceSystem.fromWkt(wkt))
    desk.session.set_inputs(desk.inputs(windows=""))
    desk.session.set_inputs(desk.inputs(windows=drawn.id()))
    settle()
    mosaic = desk.session.mosaic_layer()
    assert mosaic is not None
    assert drawn.crs() == mosaic.crs()
    desk.session.inspect([row.fid for row in desk.session.windows()])
    desk.wait()
    assert all(row.verdict for row in desk.session.windows())


def test_windows_know_their_mosaic_when_they_are_opened_again(
    desk: Desk, scene: Scene, tmp_path: Path, asked: list[Message]
) -> None:
    windows = desk.layer()
    source, name = windows.source(), windows.name()
    desk.set(desk.inputs(windows=""))
    desk.project.removeMapLayer(windows.id())
    settle()
    other_mosaic(desk, scene, tmp_path)
    assert asked == []
    again = QgsVectorLayer(source, name, "ogr")
    desk.project.addMapLayer(again)
    desk.set(desk.inputs(mosaic=desk.session.inputs.mosaic, windows=again.id()))
    assert len(asked) == 1


def on_map(desk: Desk) -> dict[str, bool]:
    root = desk.project.layerTreeRoot()
    return {node.name(): node.itemVisibilityChecked() for node in root.findLayers() if "Windows" in node.name()}


@pytest.mark.parametrize("is_inspected", [True, False])
def test_a_mosaic_that_comes_back_brings_its_windows(
    desk: Desk, scene: Scene, tmp_path: Path, asked: list[Message], is_inspected: bool
) -> None:
    first, before = desk.layer(), said(desk)
    other_mosaic(desk, scene, tmp_path)
    assert on_map(desk) == {"Windows of mosaic": False}
    desk.session.leave_windows()
    second = desk.session.inputs.mosaic
    desk.session.add_window(SHARP_WINDOW) if is_inspected else desk.session.place_windows()
    desk.wait()
    count = len(desk.rows())
    assert on_map(desk) == {"Windows of mosaic": False, "Windows of another": True}
    desk.set(desk.inputs())
    assert (desk.layer(), said(desk)) == (first, before)
    assert on_map(desk) == {"Windows of mosaic": True, "Windows of another": False}
    desk.set(desk.inputs(mosaic=second))
    assert (desk.layer().name(), len(desk.rows())) == ("Windows of another", count)
    assert len(asked) == 1


def test_a_field_that_was_renamed_is_told_then_and_when_the_desk_opens(desk: Desk, asked: list[Message]) -> None:
    windows = desk.layer()
    assert windows.startEditing()
    windows.renameAttribute(windows.fields().indexOf("verdict"), "werdykt")
    assert windows.commitChanges()
    settle()
    assert [text for text in desk.messages if "'verdict'" in text] == desk.messages[-1:]
    desk.session.close()
    desk.session = Session()
    desk.listen(desk.session)  # who listens is there once it is made
    desk.wait_for_opening()
    settle()
    assert ["'verdict'" in text for text in desk.messages].count(True) == 2
    windows.updateFields()
    settle()
    assert ["'verdict'" in text for text in desk.messages].count(True) == 2
