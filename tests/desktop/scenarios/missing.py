"""Without PyWavelets: the plugin loads, says what is missing, and works once QGIS has started with it.

Then QGIS is closed while the desk looks at something by itself that takes long.
"""
from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from typing import Callable

from qgis.core import Qgis, QgsApplication
from qgis.PyQt.QtWidgets import QAction
from qgis.utils import iface, loadPlugin, startPlugin, unloadPlugin

from demo.desk import Desk

NAME = "seam_inspector"
LONGEST_S = 120.0


def play(desk: Desk) -> None:
    """What the message bar says is in the report."""
    assert "pywt" not in sys.modules  # nothing has needed it yet
    sys.modules["pywt"] = None  # type: ignore[assignment]
    restart()
    button().trigger()
    desk.pause(0.3)
    bar = iface.messageBar()
    desk.report["messages"] = [item.text() for item in bar.items()]
    desk.report["is_warning"] = bar.currentItem().level() == Qgis.MessageLevel.Warning
    assert desk.dock is None
    assert not button().isChecked()
    bar.clearWidgets()
    del sys.modules["pywt"]
    restart()
    desk.open_dock()
    desk.report["messages_after"] = [item.text() for item in bar.items()]
    quit_at_work(desk)


def restart() -> None:
    """What QGIS does with a plugin when it starts."""
    assert unloadPlugin(NAME)
    assert loadPlugin(NAME)
    assert startPlugin(NAME)


def button() -> QAction:
    """The plugin's, in the toolbar."""
    return next(action for action in iface.rasterToolBar().actions() if action.objectName() == "seamInspectorAction")


def quit_at_work(desk: Desk) -> None:
    """QGIS quits with a task under way."""
    from seam_inspector.plugin.toolkit.background_tasks import BackgroundTasks

    BackgroundTasks(desk.dock).start("Look at the sources", look, print)
    tasks = QgsApplication.taskManager()
    desk.wait(lambda: any(task.status() == task.TaskStatus.Running for task in tasks.activeTasks()), 10, "task begun")
    desk.report["busy_at_exit"] = True


def look(is_cancelled: Callable[[], bool]) -> Iterator[tuple[float, object]]:
    """Until it is cancelled, with a pause in which it can't be."""
    end = time.monotonic() + LONGEST_S
    while not is_cancelled() and time.monotonic() < end:
        time.sleep(0.2)
    yield 1.0, None
