"""The plugin comes and goes, and the project changes under running work: nothing crashes, nothing stays behind."""
from __future__ import annotations

import gc
import importlib
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from qgis.core import Qgis, QgsApplication, QgsProject
from qgis.gui import QgisInterface, QgsDockWidget
from qgis.PyQt.QtCore import QTimer
from qgis.PyQt.QtWidgets import QAction, QDockWidget
from seam_inspector.plugin.adapters import packages
from seam_inspector.plugin.adapters.inputs import Inputs
from seam_inspector.plugin.gui.session import Session

from tests.core.synthetic import orthoimage, write_raster
from tests.qgis.scenes import Scene, outline, windows
from tests.qgis.session_desk import BLURRED_WINDOW, SHARP_WINDOW, Desk, settle, wait_for_tasks, wait_until

BOXES = [(column, row, 64, 64) for row in range(0, 192, 16) for column in range(0, 448, 32)]


@pytest.fixture
def desk(scene: Scene, project: QgsProject, tmp_path: Path) -> Iterator[Desk]:
    """A session whose window layer has 168 windows."""
    made = Desk(scene, tmp_path)
    made.use(windows(*BOXES))
    yield made
    made.session.close()
    wait_for_tasks()
    project.clear()


@pytest.fixture
def busy(desk: Desk) -> Desk:
    """Its windows are being inspected, and some are done; pictures are being read too."""
    desk.session.inspect_pending()
    wait_until(lambda: desk.session.result(1) is not None)
    desk.session.pictures(100)
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
    assert not other.isModified()


def test_choosing_another_window_layer_under_way(busy: Desk) -> None:
    before = busy.layer()
    other = busy.use(windows(*BOXES, window_id=("integer", list(range(1, len(BOXES) + 1)))))
    assert not busy.session.is_busy
    wait_for_tasks()
    assert not any(verdicts(busy))
    assert not other.isModified()
    busy.session.set_inputs(busy.inputs(windows=before.id()))
    assert verdicts(busy)[0]  # what had arrived was written


@pytest.mark.parametrize("name", ["mosaic", "source", "windows", "seamlines"])
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
    busy.layer().changeGeometry(last, outline((0, 0, 128, 128)))
    busy.session.remove([busy.rows()[len(BOXES) - 1].fid])
    busy.layer().deleteFeature(busy.rows()[len(BOXES) - 2].fid)
    busy.wait()
    rows = busy.rows()
    assert len(rows) == len(BOXES) - 2
    assert all(row.verdict for row in rows.values())
    assert [number for number, row in rows.items() if row.stale] == [len(BOXES)]


def test_saving_and_discarding_edits_under_way(busy: Desk) -> None:
    assert busy.layer().commitChanges()
    settle(0.2)
    busy.layer().rollBack()
    busy.wait()
    assert all(row.verdict for row in busy.session.windows()[-10:])


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


@pytest.fixture
def plugin(qgis_iface: QgisInterface, project: QgsProject) -> Iterator[Any]:
    made = importlib.import_module("seam_inspector").classFactory(qgis_iface)
    made.initGui()
    yield made
    made.unload()
    wait_for_tasks()


def action_of(plugin: Any) -> QAction:
    found = plugin._action
    assert found is not None
    return found


def receivers() -> list[int]:
    """How many are connected to the signals of what outlives the plugin."""
    project, tasks = QgsProject.instance(), QgsApplication.taskManager()
    registry = QgsApplication.processingRegistry()
    return [
        *(project.receivers(signal) for signal in (
            project.readProject, project.cleared, project.writeProject, project.layersAdded, project.layersRemoved,
            project.layersWillBeRemoved, project.layerWasAdded, project.crsChanged,
        )),
        *(tasks.receivers(signal) for signal in (tasks.taskAdded, tasks.statusChanged, tasks.progressChanged)),
        registry.receivers(registry.providerAdded),
        QgsApplication.instance().receivers(QgsApplication.instance().focusChanged),
    ]  # fmt: skip


def left_behind(iface: QgisInterface) -> dict[str, Any]:
    """What a plugin could leave in QGIS."""
    window, canvas = iface.mainWindow(), iface.mapCanvas()
    return {
        "actions": sum(not isinstance(action.parent(), QDockWidget) for action in window.findChildren(QAction)),
        "docks": len(window.findChildren(QgsDockWidget)),
        "items": len(canvas.scene().items()),
        "canvas": [canvas.receivers(signal) for signal in (
            canvas.mapToolSet, canvas.extentsChanged, canvas.destinationCrsChanged, canvas.xyCoordinates,
        )],
        "providers": QgsApplication.processingRegistry().providerById("seaminspector") is not None,
        "tasks": len(QgsApplication.taskManager().tasks()),
        "receivers": receivers(),
    }  # fmt: skip


def test_ten_times_on_and_off_leaves_nothing(
    qgis_iface: QgisInterface, scene: Scene, project: QgsProject, tmp_path: Path
) -> None:
    module = importlib.import_module("seam_inspector")
    before: dict[str, Any] = {}
    for turn in range(11):
        if turn == 1:  # what Qt and QGIS make once, they have made by now
            before = left_behind(qgis_iface)
        plugin = module.classFactory(qgis_iface)
        plugin.initGui()
        action_of(plugin).trigger()
        dock = plugin._dock
        dock.draw.trigger()
        use_in(dock.session, scene, tmp_path)
        dock.session.add_window(BLURRED_WINDOW)
        settle(0.1)
        plugin.unload()
        del dock, plugin
        project.clear()
        wait_for_tasks()
        gc.collect()
        settle()
    assert left_behind(qgis_iface) == before


def use_in(session: Session, scene: Scene, folder: Path) -> Desk:
    """The small block in a session of the plugin's own."""
    desk = Desk(scene, folder)
    desk.session.close()
    desk.session = session
    desk.listen(session)
    session.set_inputs(desk.inputs())
    return desk


def test_unloading_while_a_task_runs(plugin: Any, scene: Scene, tmp_path: Path) -> None:
    action_of(plugin).trigger()
    desk = use_in(plugin._dock.session, scene, tmp_path)
    layer = desk.use(windows(*BOXES))
    desk.session.inspect_pending()
    wait_until(lambda: desk.session.result(1) is not None)
    plugin.unload()
    assert all(task.isCanceled() for task in QgsApplication.taskManager().activeTasks())
    gc.collect()
    wait_for_tasks()
    found = [feature["verdict"] for feature in layer.getFeatures()]
    assert found[0]
    assert not found[-1]


def test_the_dock_inspects(plugin: Any, scene: Scene, tmp_path: Path) -> None:
    action_of(plugin).trigger()
    desk = use_in(plugin._dock.session, scene, tmp_path)
    for window in (BLURRED_WINDOW, SHARP_WINDOW):
        desk.add(window)
    assert [row.verdict for row in desk.session.windows()] == ["significant", "reduced"]
    assert desk.messages == []


@pytest.mark.parametrize("module", ["pywt", "matplotlib"])
def test_a_missing_package_is_named_once(
    plugin: Any, qgis_iface: QgisInterface, monkeypatch: pytest.MonkeyPatch, module: str
) -> None:
    find = packages.find_spec
    monkeypatch.setattr(packages, "find_spec", lambda name: None if name == module else find(name))
    told: list[tuple[str, Any]] = []
    monkeypatch.setattr(
        qgis_iface.messageBar(), "pushMessage", lambda _title, text, level, _time: told.append((text, level))
    )
    action_of(plugin).trigger()
    assert plugin._dock is None
    assert not action_of(plugin).isChecked()
    ((text, level),) = told
    assert level == Qgis.MessageLevel.Warning
    name = {"pywt": "PyWavelets", "matplotlib": "matplotlib"}[module]
    assert name in text
    assert f"python3-{module}" in text
    assert "OSGeo4W" in text


def test_qgis_starts_without_what_the_desk_needs(repository: Path) -> None:
    import subprocess

    code = (
        f"import sys; sys.path.insert(0, {str(repository / 'build' / 'plugins')!r});"
        "import seam_inspector; from seam_inspector.plugin import plugin;"
        "print([name for name in ('matplotlib', 'pywt', 'seam_inspector.plugin.gui.dock') if name in sys.modules])"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert out.stdout.strip() == "[]"


# The interface's thread


class Gaps:
    """The event loop's longest gap, by a timer that should fire every 2 ms."""

    def __init__(self) -> None:
        self.gaps: list[float] = []
        self._last = time.perf_counter()
        self._timer = QTimer()
        self._timer.setInterval(2)
        self._timer.timeout.connect(self._tick)

    def __enter__(self) -> Gaps:
        self._last = time.perf_counter()
        self._timer.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._timer.stop()

    def _tick(self) -> None:
        now = time.perf_counter()
        self.gaps.append(now - self._last)
        self._last = now


@pytest.fixture(scope="module")
def large(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    """Rasters of 4096 x 4096 px."""
    folder = tmp_path_factory.mktemp("large")
    tile = orthoimage((1024, 1024))
    paths = []
    for number, name in enumerate(("mosaic", "west", "east")):
        noise = np.random.default_rng(number).integers(-3, 4, tile.shape)
        pixels = np.tile(np.clip(tile + noise, 1, 255).astype(np.uint8), (1, 4, 4))
        paths.append(folder / f"{name}.tif")
        write_raster(paths[-1], pixels, nodata=0, options=("TILED=YES",))
    return Scene(*paths)


def test_the_map_does_not_stall_while_windows_are_inspected(large: Scene, project: QgsProject, tmp_path: Path) -> None:
    desk = Desk(large, tmp_path)
    boxes = [(430 * column, 330 * row, 1024, 1024) for row in range(7) for column in range(8)][:50]
    desk.use(windows(*boxes))
    desk.session.windows()
    wait_for_tasks()
    with Gaps() as measured:
        desk.session.inspect_pending()
        desk.wait()
    desk.session.close()
    assert all(row.verdict for row in desk.session.windows())
    longest = sorted(measured.gaps)[-5:]
    sys.stdout.write(f"event loop, longest gaps: {[round(1e3 * gap) for gap in longest]} ms\n")
    assert longest[-1] < 0.25  # 50 ms on a machine of its own
