"""What must do no harm: a missing package, enabling and disabling, pulling the ground from under a task at work.

Parameters: ``block`` (folder), ``side_m``.
"""
from __future__ import annotations

import gc
import sys
from functools import partial
from pathlib import Path

from qgis.core import Qgis, QgsApplication, QgsProject
from qgis.PyQt.QtCore import QCoreApplication, QEvent, QTimer
from qgis.PyQt.QtWidgets import QAction, QApplication, QDockWidget, QMessageBox, QToolBar, QWidget
from qgis.utils import active_plugins, iface, loadPlugin, plugins, startPlugin, unloadPlugin

from demo.desk import Desk

NAME = "seam_inspector"


def play(desk: Desk) -> None:
    """The last danger comes when QGIS quits."""
    block, side_m = Path(desk.parameters["block"]), float(desk.parameters["side_m"])
    miss_a_package(desk)
    come_and_go(desk, block, side_m)
    close_project(desk, block, side_m)
    remove_mosaic(desk, block, side_m)
    disable_at_work(desk, block, side_m)
    start_work(desk, block, side_m)
    desk.report["busy_at_exit"] = desk.session.is_busy
    QTimer.singleShot(1000, partial(cancel_tasks, desk))


def miss_a_package(desk: Desk) -> None:
    """Without PyWavelets a message says what to do; after a restart with it the desk opens."""
    assert "pywt" not in sys.modules  # nothing has needed it yet
    sys.modules["pywt"] = None  # type: ignore[assignment]
    switch(desk)
    action(desk, "seamInspectorAction").trigger()
    desk.pause(0.3)
    bar = iface.messageBar()
    desk.report["messages"] = [item.text() for item in bar.items()]
    desk.report["is_warning"] = bar.currentItem().level() == Qgis.MessageLevel.Warning
    assert desk.dock is None
    assert not action(desk, "seamInspectorAction").isChecked()
    bar.clearWidgets()
    del sys.modules["pywt"]
    switch(desk)
    desk.open_dock()
    desk.report["messages_after"] = [item.text() for item in bar.items()]


def action(desk: Desk, name: str) -> QAction:
    """Button of the plugin."""
    return desk.window.findChild(QAction, name)


def cancel_tasks(desk: Desk) -> None:
    """Answer QGIS, which asks instead of quitting, and quit as soon as it lets us."""
    dialog = QApplication.activeModalWidget()
    if isinstance(dialog, QMessageBox):
        dialog.button(QMessageBox.StandardButton.Yes).click()
    QTimer.singleShot(100, partial(quit_again, desk))


def quit_again(desk: Desk) -> None:
    """Once the tasks have ended."""
    if QgsApplication.taskManager().countActiveTasks():
        QTimer.singleShot(20, partial(quit_again, desk))
    else:
        desk.drop_changes()
        iface.actionExit().trigger()


def come_and_go(desk: Desk, block: Path, side_m: float) -> None:
    """Five times off and on, with the dock open and the map tool in use."""
    desk.set_up(block, side_m, side_m)
    use_once(desk)
    switch(desk)
    before = counts(desk)
    for _ in range(5):
        use_once(desk)
        switch(desk)
    desk.report["before"], desk.report["after"] = before, counts(desk)
    clear(desk)


def use_once(desk: Desk) -> None:
    """Open the docks, take the tool, move over the map, until the looks at the sources have ended.

    QGIS adds widgets of its own for a task at work, and a tab of its log when the first one has ended.
    """
    desk.open_dock()
    action(desk, "seamInspectorBarAction").trigger()
    desk.dock.draw.trigger()
    desk.move(tuple(desk.session.mosaic_layer().extent().center()))
    desk.pause(0.1)
    wait_for_tasks(desk)


def wait_for_tasks(desk: Desk) -> None:
    """Until no task is at work, the plugin's or QGIS's."""
    desk.wait(lambda: QgsApplication.taskManager().countActiveTasks() == 0, 60, "no task at work")


def switch(desk: Desk) -> None:
    """Off and on again."""
    assert unloadPlugin(NAME)
    assert NAME not in active_plugins
    settle(desk)
    assert loadPlugin(NAME)
    assert startPlugin(NAME)
    assert NAME in plugins
    settle(desk)


def settle(desk: Desk) -> None:
    """Let go what is to be deleted later."""
    desk.pause(0.1)
    wait_for_tasks(desk)
    QCoreApplication.sendPostedEvents(None, int(QEvent.Type.DeferredDelete))
    gc.collect()
    desk.pause(0.1)


def counts(desk: Desk) -> dict[str, int]:
    """What a plugin may leave behind."""
    project = QgsProject.instance()
    signals = ("readProject", "cleared", "layersAdded", "layersRemoved", "layersWillBeRemoved")
    return {
        "actions": len(desk.window.findChildren(QAction)),
        "raster actions": len(iface.rasterToolBar().actions()),
        "raster menu": len(iface.rasterMenu().actions()),
        "help menu": len(iface.pluginHelpMenu().actions()),
        "tool bars": len(desk.window.findChildren(QToolBar)),
        "docks": len(desk.window.findChildren(QDockWidget)),
        "widgets": len(desk.window.findChildren(QWidget)),
        "top level widgets": len(QgsApplication.topLevelWidgets()),
        "scene items": len(desk.canvas.scene().items()),
        "providers": len(QgsApplication.processingRegistry().providers()),
        "our objects": sum(type(thing).__module__.startswith("seam_inspector") for thing in gc.get_objects()),
        **{name: project.receivers(getattr(project, name)) for name in signals},
    }


def start_work(desk: Desk, block: Path, side_m: float) -> None:
    """Windows along the seams, all being inspected."""
    if desk.project.count() == 0:
        desk.set_up(block, side_m, side_m / 2)
    else:
        desk.open_dock()
    session = desk.session
    if not session.windows():
        desk.dock.place.trigger()
        desk.wait(lambda: session.windows(), 60, "windows placed")
        desk.wait_for_work()
    fids = [row.fid for row in session.windows()]
    for _ in range(10):
        session.inspect(fids)
    assert session.is_busy


def close_project(desk: Desk, block: Path, side_m: float) -> None:
    """While windows are being inspected."""
    start_work(desk, block, side_m)
    session = desk.session
    clear(desk)
    desk.wait(lambda: not session.is_busy, 20, "idle after the project was closed")
    assert session.windows() == []
    assert not session.inputs.mosaic


def remove_mosaic(desk: Desk, block: Path, side_m: float) -> None:
    """While windows are being inspected; then the window layer."""
    start_work(desk, block, side_m)
    session = desk.session
    desk.project.removeMapLayer(session.inputs.mosaic)
    desk.wait(lambda: not session.is_busy, 60, "idle after the mosaic was removed")
    assert session.mosaic_grid() is None
    assert not desk.dock.draw.isEnabled()
    desk.drop_changes()
    desk.project.removeMapLayer(session.window_layer().id())
    desk.pause(0.3)
    assert session.windows() == []
    clear(desk)


def disable_at_work(desk: Desk, block: Path, side_m: float) -> None:
    """The plugin goes while its tasks are under way, and they end."""
    start_work(desk, block, side_m)
    switch(desk)
    clear(desk)


def clear(desk: Desk) -> None:
    """A new, empty project."""
    desk.new_project()
