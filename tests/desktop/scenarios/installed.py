"""The plugin's zip is installed into an empty profile by QGIS's own installer, and used.

Then QGIS is closed while the desk looks at something by itself that takes long.

Parameters: ``package`` (the zip), ``block`` (folder), ``side_m``, ``screenshots`` (folder).
"""
from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Callable

import pyplugin_installer
from qgis.core import Qgis, QgsApplication
from qgis.utils import plugins

from demo.desk import Desk

LONGEST_S = 120.0


def play(desk: Desk) -> None:
    """Nothing of the plugin is there before; what QGIS notes of it afterwards is in the report."""
    noted: list[str] = []

    def note(text: str, tag: str, level: Qgis.MessageLevel) -> None:
        if level in (Qgis.MessageLevel.Warning, Qgis.MessageLevel.Critical):
            noted.append(f"{tag}: {text}")

    QgsApplication.messageLog().messageReceived.connect(note)
    assert "seam_inspector" not in plugins
    pyplugin_installer.instance().installFromZipFile(desk.parameters["package"])
    assert "seam_inspector" in plugins
    import seam_inspector

    home = (Path(QgsApplication.qgisSettingsDirPath()) / "python" / "plugins").resolve()
    assert home in Path(seam_inspector.__file__).resolve().parents, seam_inspector.__file__
    desk.report["tooltip"] = desk.plugin.desk("seamInspectorAction").action.toolTip()
    desk.set_up(Path(desk.parameters["block"]), desk.parameters["side_m"], 2 * desk.parameters["side_m"])
    desk.dock.place.trigger()
    desk.wait(lambda: desk.session.windows() and not desk.session.is_busy, 60, "windows placed")
    desk.dock.inspect.trigger()
    desk.wait(lambda: all(row.verdict for row in desk.session.windows()), 120, "all inspected")
    desk.wait_for_work()
    desk.report["verdicts"] = [row.verdict for row in desk.session.windows()]
    desk.report["provider"] = QgsApplication.processingRegistry().providerById("seaminspector") is not None
    desk.screenshot(Path(desk.parameters["screenshots"]) / "installed.png")
    desk.report["noted"] = noted
    quit_at_work(desk)


def quit_at_work(desk: Desk) -> None:
    """QGIS quits with a task under way."""
    from seam_inspector.plugin.toolkit.background_tasks import BackgroundTasks

    BackgroundTasks(desk.dock).start("Look at the sources", look, print)
    tasks = QgsApplication.taskManager()
    desk.wait(lambda: any(task.status() == task.TaskStatus.Running for task in tasks.activeTasks()), 10, "task begun")
    desk.drop_changes()


def look(is_cancelled: Callable[[], bool]) -> Iterator[tuple[float, object]]:
    """Until it is cancelled, with a pause in which it can't be."""
    end = time.monotonic() + LONGEST_S
    while not is_cancelled() and time.monotonic() < end:
        time.sleep(0.2)
    yield 1.0, None
