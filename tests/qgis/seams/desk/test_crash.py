"""A QGIS that is killed costs at most its last action: a real process is killed while windows are judged."""
from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from qgis.core import QgsProject

from tests.qgis.scenes import Scene
from tests.qgis.seams.desk.session_desk import Desk, wait_until

_REPOSITORY = Path(__file__).resolve().parents[4]


def killed_at(scene: Scene, folder: Path, saved: str, count: int, last: str) -> tuple[dict[int, str], int]:
    """What the process said of each window, the last of it ``last``, and the number of the last window."""
    command = [sys.executable, "-m", "tests.qgis.seams.desk.judging_child", str(folder), saved, str(count)]
    command += [str(path) for path in (scene.mosaic, scene.west, scene.east)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(map(str, (_REPOSITORY, *filter(None, sys.path))))}
    child = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment, cwd=_REPOSITORY)
    judged: dict[int, str] = {}
    number = 0
    assert child.stdout is not None
    for line in child.stdout:
        done, *words = line.split()
        if done == "judged":
            number = int(words[0])
            judged[number] = words[1]
        elif done == "removed":
            number = int(words[0])
            judged.pop(number, None)
        if done == "removed" or (last == "judged" and (done, len(judged)) == ("judged", count)):
            break
    child.send_signal(signal.SIGKILL)
    child.stdout.close()
    assert child.wait() == -signal.SIGKILL
    return judged, number


@pytest.mark.parametrize("saved", ["after", "first"])
def test_what_was_judged_is_there_after_a_crash(
    scene: Scene, project: QgsProject, tmp_path: Path, saved: str
) -> None:
    judged, removed = killed_at(scene, tmp_path, saved, 13, "removed")
    desk = reopened(scene, project, tmp_path)
    rows = desk.rows()
    assert removed not in rows
    assert {number: row.observer for number, row in rows.items()} == judged
    assert all(row.verdict for row in rows.values())
    assert not any(row.stale for row in rows.values())
    assert any(message.startswith("QGIS ended without saving; the changes of") for message in desk.messages)
    desk.undo()
    assert not any(row.observer for row in desk.session.windows())
    desk.redo()
    assert {number: row.observer for number, row in desk.rows().items()} == judged
    assert desk.layer().commitChanges()
    wait_until(lambda: not list(tmp_path.glob("*.unsaved")), "for the record to go, in a thread of its own")
    project.clear()
    assert project.read(str(tmp_path / "project.qgz"))
    if saved == "after":
        assert {number: row.observer for number, row in desk.rows().items()} == judged
    desk.session.close()


def test_a_crash_costs_at_most_the_last_action(scene: Scene, project: QgsProject, tmp_path: Path) -> None:
    judged, last = killed_at(scene, tmp_path, "after", 5, "judged")
    desk = reopened(scene, project, tmp_path)
    found = {number: row.observer for number, row in desk.rows().items() if row.observer}
    judged.pop(last)
    found.pop(last, None)
    assert found == judged
    desk.session.close()


def reopened(scene: Scene, project: QgsProject, folder: Path) -> Desk:
    """The project as its operator finds it."""
    desk = Desk(scene, folder)
    project.clear()
    project.setPresetHomePath("")
    assert project.read(str(folder / "project.qgz"))
    wait_until(lambda: desk.session.windows() and desk.messages, "for the windows")
    return desk
