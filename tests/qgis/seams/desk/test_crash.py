"""A QGIS that is killed costs nothing that a key had set: a real process is killed while windows are judged."""
from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from qgis.core import QgsProject
from seam_inspector.plugin.seams.desk import window_home

from tests.qgis.scenes import Scene
from tests.qgis.seams.desk.session_desk import Desk, settle, wait_until

_REPOSITORY = Path(__file__).resolve().parents[4]
_KEYS = 40  # pressed at most before the process is killed, some moments after the last
_LATEST_S = 0.05


def killed(scene: Scene, folder: Path, kind: str, moment: random.Random) -> dict[int, str]:
    """What the process had said of each window when it was killed."""
    command = [sys.executable, "-m", "tests.qgis.seams.desk.judging_child", str(folder), kind]
    command += [str(path) for path in (scene.mosaic, scene.west, scene.east)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(map(str, (_REPOSITORY, *filter(None, sys.path))))}
    child = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment, cwd=_REPOSITORY)
    assert child.stdout is not None
    last, said = moment.randint(1, _KEYS), []
    for line in child.stdout:
        said += [line.split()] if line.startswith("judged") else []
        if len(said) == last:
            break
    time.sleep(moment.uniform(0, _LATEST_S))
    child.send_signal(signal.SIGKILL)
    said += [line.split() for line in child.stdout.read().splitlines() if line.startswith("judged")]
    assert child.wait() == -signal.SIGKILL
    return {int(number): word for _, number, word in said if number.isdigit()}


@pytest.mark.parametrize("kind", [
    "unsaved", "second", *(pytest.param(kind, marks=pytest.mark.release) for kind in ("saved", "moved"))
])  # fmt: skip
def test_what_a_key_had_set_is_there_after_a_crash_without_asking(
    scene: Scene, project: QgsProject, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    for part in ("project", "profile"):
        (tmp_path / part).mkdir()
    monkeypatch.setattr(window_home, "unsaved_folder", lambda: tmp_path / "profile")
    judged = killed(scene, tmp_path, kind, random.Random(kind))
    desk = Desk(scene, tmp_path)
    desk.project.setPresetHomePath("")
    if kind in ("saved", "moved"):
        project.clear()
        assert project.read(str(tmp_path / "project" / "project.qgz"))
        if kind == "saved":  # before its inputs were chosen
            desk.lay_out(scene)
    if kind != "moved":
        desk.set(desk.inputs())
    wait_until(desk.session.windows, "for the windows")
    desk.wait_for_opening()
    settle()
    rows = desk.rows()
    items = {number: rows[number].observer if number in rows else "removed" for number in judged}
    others = [number for number in judged if items[number] != judged[number]]
    assert len(others) <= 1, (judged, items)  # the key that was being written as the process was killed
    assert all(row.verdict and not row.stale for row in rows.values())
    assert all(desk.session.result(row.fid) is not None for row in rows.values())
    desk.session.close()
