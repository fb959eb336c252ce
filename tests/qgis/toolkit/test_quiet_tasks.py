"""QGIS says nothing over the map when a task of ours has ended, and the user's setting stays."""
from __future__ import annotations

from collections.abc import Iterator

import pytest
from qgis.core import QgsApplication, QgsSettings
from seam_inspector.plugin.toolkit.background_tasks import BackgroundTask, Cancelled

from tests.qgis.seams.desk.session_desk import wait_until

SETTING = "minTaskLengthForSystemNotification"


def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
    yield 1.0, None


@pytest.mark.parametrize("before", [None, 7])
def test_no_task_is_long_enough_for_a_notice_while_qgis_hears_of_its_end(
    qgis_app: QgsApplication, before: int | None
) -> None:
    settings, section = QgsSettings(), QgsSettings.Section.App
    if before is None:
        settings.remove(SETTING, section)
    else:
        settings.setValue(SETTING, before, section)
    heard: list[tuple[int, int]] = []

    def listen(_task: int, status: int) -> None:
        heard.append((status, int(QgsSettings().value(SETTING, 5, section=section))))

    manager = QgsApplication.taskManager()
    manager.statusChanged.connect(listen)
    task = BackgroundTask("inspect", job)
    done = []
    task.ended.connect(done.append)
    manager.addTask(task)
    wait_until(lambda: done and not manager.countActiveTasks(), "for the task")
    manager.statusChanged.disconnect(listen)
    if hasattr(type(task), "Silent"):
        return
    assert heard[-1][1] > 10**6
    assert QgsSettings().value(SETTING, None, section=section) == before
