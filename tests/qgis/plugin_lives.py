"""The plugin in QGIS from its start to its end, and what it could leave there."""
from __future__ import annotations

import gc
import importlib
from collections.abc import Callable
from typing import Any

from qgis.core import QgsApplication, QgsProject
from qgis.gui import QgisInterface, QgsDockWidget
from qgis.PyQt.QtWidgets import QAction, QDockWidget

from tests.qgis.seams.desk.session_desk import settle, wait_for_tasks


def started(iface: QgisInterface) -> Any:
    """The plugin as QGIS starts it."""
    made = importlib.import_module("seam_inspector").classFactory(iface)
    made.initGui()
    return made


def action_of(plugin: Any) -> QAction:
    result = plugin.desk("seamInspectorAction").action
    assert result is not None
    return result


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


def left_behind(iface: QgisInterface) -> dict[str, int]:
    """What a plugin could leave in QGIS: how many of each."""
    window, canvas = iface.mainWindow(), iface.mapCanvas()
    counts = {
        "actions": sum(not isinstance(action.parent(), QDockWidget) for action in window.findChildren(QAction)),
        "docks": len(window.findChildren(QgsDockWidget)),
        "items": len(canvas.scene().items()),
        "providers": int(QgsApplication.processingRegistry().providerById("seaminspector") is not None),
        "tasks": len(QgsApplication.taskManager().tasks()),
    }
    followed = [canvas.receivers(signal) for signal in (
        canvas.mapToolSet, canvas.extentsChanged, canvas.destinationCrsChanged, canvas.xyCoordinates,
    )]  # fmt: skip
    return {**counts, **{f"receiver {number}": count for number, count in enumerate([*followed, *receivers()])}}


_TURNS = 100  # turns of the event loop, 20 s in all, in which what was deleted goes on a busy machine


def assert_leaves_nothing(
    iface: QgisInterface, times: int, use: Callable[[Any], None], then: Callable[[], None] = lambda: None
) -> None:
    """The plugin is started, used and unloaded so many times, and once before: what Qt and QGIS make once, they have
    made by then. ``then``: after each time, before the project is cleared."""
    before: dict[str, int] = {}
    for turn in range(times + 1):
        if turn == 1:
            before = left_behind(iface)
        plugin = started(iface)
        use(plugin)
        plugin.unload()
        del plugin
        then()
        QgsProject.instance().clear()
        wait_for_tasks()
        gc.collect()
        settle()
    grown = {}
    for _ in range(_TURNS):
        grown = {name: count - before[name] for name, count in left_behind(iface).items() if count > before[name]}
        if not grown:
            break
        gc.collect()
        settle(0.2)
    assert grown == {}, grown
