"""The plugin comes and goes, and the project changes under running work: nothing crashes, nothing stays behind."""
from __future__ import annotations

import gc
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsApplication, QgsProject
from qgis.gui import QgisInterface
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs
from seam_inspector.plugin.seams.desk.session import Session

from tests.qgis.plugin_lives import action_of, assert_leaves_nothing
from tests.qgis.scenes import Scene, outline, windows
from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, Desk, settle, wait_for_tasks, wait_until

pytestmark = pytest.mark.slow

BOXES = [(column, row, 64, 64) for row in range(0, 192, 48) for column in range(0, 448, 64)]


@pytest.fixture
def desk(scene: Scene, project: QgsProject, tmp_path: Path) -> Iterator[Desk]:
    """A session whose window layer has 28 windows."""
    made = Desk(scene, tmp_path)
    made.use(windows(*BOXES))
    yield made
    made.session.close()
    wait_for_tasks()
    project.clear()


@pytest.fixture
def busy(desk: Desk) -> Desk:
    """Its windows are being inspected, and some are done."""
    desk.session.inspect_pending()
    wait_until(lambda: desk.session.result(1) is not None)
    return desk


def verdicts(desk: Desk) -> list[str]:
    return [row.verdict for row in desk.session.windows()]


# Work under way


def test_closing_the_project_under_way(busy: Desk) -> None:
    busy.project.clear()
    assert busy.session.windows() == []
    assert not busy.session.is_busy
    wait_for_tasks()
    assert busy.session.inputs == Inputs()
    assert busy.messages == []


def test_nothing_of_a_closed_project_reaches_the_next_one(scene: Scene, busy: Desk) -> None:
    inputs = busy.inputs(seamlines="")
    busy.project.clear()
    busy.mosaic, busy.sources = busy.raster(scene.mosaic), [busy.raster(scene.west), busy.raster(scene.east)]
    other = windows(*BOXES, window_id=("integer", list(range(1, len(BOXES) + 1))))
    busy.project.addMapLayer(other)
    sources = tuple(source.id() for source in busy.sources)
    busy.session.set_inputs(replace(inputs, mosaic=busy.mosaic.id(), sources=sources, windows=other.id()))
    wait_for_tasks()
    assert not any(verdicts(busy))
    assert not any(busy.session.result(row.fid) for row in busy.session.windows())


@pytest.mark.parametrize("name", [
    "mosaic", "windows", *(pytest.param(name, marks=pytest.mark.release) for name in ("source", "seamlines"))
])  # fmt: skip
def test_removing_a_layer_under_way(busy: Desk, name: str) -> None:
    layers = {"mosaic": busy.mosaic, "source": busy.sources[0], "windows": busy.layer(), "seamlines": busy.seamlines}
    busy.project.removeMapLayers([layers[name].id()])
    settle(0.3)
    if name == "windows":
        assert busy.session.windows() == []
    else:
        busy.wait()
        assert all(verdicts(busy))
    wait_for_tasks()
    assert busy.messages == []


def test_moving_and_deleting_windows_under_way(busy: Desk) -> None:
    last = busy.rows()[len(BOXES)].fid
    busy.move(last, outline((0, 0, 128, 128)))
    busy.layer().startEditing()
    busy.session.remove([busy.rows()[len(BOXES) - 1].fid])
    busy.layer().deleteFeature(busy.rows()[len(BOXES) - 2].fid)
    busy.wait()
    rows = busy.rows()
    assert len(rows) == len(BOXES) - 2
    assert all(row.verdict for row in rows.values())
    assert [number for number, row in rows.items() if row.stale] == [len(BOXES)]


def test_closing_the_session_under_way_keeps_what_is_done(busy: Desk) -> None:
    layer, done = busy.layer(), len(verdicts(busy))
    busy.session.close()
    wait_for_tasks()
    assert 1 <= sum(bool(feature["verdict"]) for feature in layer.getFeatures()) < done


def test_a_task_that_nobody_refers_to_ends(scene: Scene, project: QgsProject, tmp_path: Path) -> None:
    for _ in range(5):
        desk = Desk(scene, tmp_path)
        desk.use(windows(*BOXES))
        desk.session.inspect_pending()
        settle(0.05)
        desk.session.close()
        desk.session.deleteLater()
        del desk
        gc.collect()
        project.clear()
    wait_for_tasks()


# The plugin


def test_four_times_on_and_off_leaves_nothing(
    qgis_iface: QgisInterface, scene: Scene, project: QgsProject, tmp_path: Path
) -> None:
    def use(plugin: Any) -> None:
        action_of(plugin).trigger()
        dock = plugin.desk("seamInspectorAction").dock
        dock.draw.trigger()
        use_in(dock.session, scene, tmp_path)
        dock.session.add_window(BLURRED_WINDOW)
        settle(0.1)

    assert_leaves_nothing(qgis_iface, 4, use)


def use_in(session: Session, scene: Scene, folder: Path) -> Desk:
    """The small block in a session of the plugin's own."""
    desk = Desk(scene, folder)
    desk.session.close()
    desk.session = session
    desk.listen(session)
    desk.set(desk.inputs())
    return desk


def test_unloading_while_a_task_runs(plugin: Any, scene: Scene, tmp_path: Path) -> None:
    action_of(plugin).trigger()
    desk = use_in(plugin.desk("seamInspectorAction").dock.session, scene, tmp_path)
    layer = desk.use(windows(*BOXES))
    desk.session.inspect_pending()
    wait_until(lambda: desk.session.result(1) is not None)
    plugin.unload()
    assert all(task.isCanceled() for task in QgsApplication.taskManager().activeTasks())
    gc.collect()
    wait_for_tasks()
    items = [feature["verdict"] for feature in layer.getFeatures()]
    assert items[0]
    assert not items[-1]
