"""QGIS is closed while the desk looks at something by itself that takes long."""
from __future__ import annotations

import time
from collections.abc import Iterator

from qgis.core import QgsApplication
from seam_inspector.plugin.toolkit.background_task import Cancelled
from seam_inspector.plugin.toolkit.desk.background_tasks import BackgroundTasks

from demo.desk import Desk

LONGEST_S = 120.0


def play(desk: Desk) -> None:
    """It quits with a task under way."""
    desk.open_dock()
    BackgroundTasks(desk.dock).start("Look at the sources", look, print)
    tasks = QgsApplication.taskManager()
    desk.wait(lambda: any(task.status() == task.TaskStatus.Running for task in tasks.activeTasks()), 10, "task begun")
    desk.report["busy_at_exit"] = True


def look(is_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
    """Until it is cancelled, with a pause in which it can't be."""
    end = time.monotonic() + LONGEST_S
    while not is_cancelled() and time.monotonic() < end:
        time.sleep(0.2)
    yield 1.0, None
